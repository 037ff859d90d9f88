// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace auslan {

/// WATER and WATER-NORTH are one sense in two regions.
inline std::string_view without_region(std::string_view gloss) {
  for (const std::string_view suffix : {"-NORTH", "-SOUTH"})
    if (gloss.size() > suffix.size() && gloss.ends_with(suffix)) return gloss.substr(0, gloss.size() - suffix.size());
  return gloss;
}

}  // namespace auslan
