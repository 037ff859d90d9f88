// SPDX-License-Identifier: Apache-2.0
// Warnings for a person, a few of each kind, however long the text.
#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

enum class WarningKind { kNoLetter, kLostCharacter, kLongSpelling, kAmbiguous, kPast, kMissingEntry, kNumberForm };
inline constexpr size_t kWarningKinds = 7;

class Warnings {
 public:
  /// `what` is the word in question; `detail` completes the sentence of some kinds. The same sentence is kept once.
  void add(WarningKind kind, std::string_view what, std::string_view detail = {});
  /// All sentences, in the order of WarningKind.
  std::vector<std::string> sentences() const;

 private:
  struct Group {
    std::set<std::string> seen;
    std::vector<std::string> sentences;
    size_t more = 0;
  };
  std::array<Group, kWarningKinds> groups_;
};

}  // namespace auslan
