// SPDX-License-Identifier: Apache-2.0
// A sign as it is written: the elements of SiGML in their order, with everything in them, whether it is understood or
// not. What was read from HamNoSys symbols is kept as the elements of the same names. Comments and white space between
// elements are no part of it.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace auslan {

struct WrittenElement {
  std::string name;  ///< empty: a piece of text
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<WrittenElement> children;
  std::string text;  ///< of a piece of text

  /// The attribute's value; empty where there is none.
  std::string_view attribute(std::string_view key) const {
    for (const auto& [name_of, value] : attributes)
      if (name_of == key) return value;
    return {};
  }
  /// Adds an attribute with a value; one without a value is not written.
  void put(std::string_view key, std::string_view value) {
    if (!value.empty()) attributes.emplace_back(key, value);
  }
  WrittenElement& add(std::string_view child) {
    children.emplace_back();
    children.back().name = child;
    return children.back();
  }

  friend bool operator==(const WrittenElement&, const WrittenElement&) = default;
};

}  // namespace auslan
