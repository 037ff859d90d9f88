// SPDX-License-Identifier: Apache-2.0
// What a text must keep before an XML parser sees it. pugixml recurses without a bound and tells no line numbers.
#pragma once

#include "kinematics/result.h"
#include "written_sign.h"

#include <string_view>

namespace auslan::notation {

/// kLimit or kMalformed with the place "name:line:column": size, UTF-8, control characters, depth, length of
/// attributes, declarations, entities.
std::optional<Error> find_broken_bound(std::string_view text, const std::string& name);

/// The byte at which UTF-8 breaks, or npos.
size_t find_invalid_utf8(std::string_view text);

/// Line and column (in bytes) of an offset.
class Lines {
 public:
  explicit Lines(std::string_view text);
  Mark mark(size_t offset) const;

 private:
  std::vector<size_t> starts_;
};

std::string place(const std::string& name, const Mark& mark);

}  // namespace auslan::notation
