// SPDX-License-Identifier: Apache-2.0
// UTF-8 into code points and code points into lines that fit.
#pragma once

#include <cstdint>
#include <string_view>

namespace auslan {

inline constexpr uint32_t kReplacement = 0xFFFD;
inline constexpr uint32_t kEllipsis = 0x2026;

/// Takes the first code point off a non-empty text. What is not UTF-8 (overlong forms and surrogates too) comes out as
/// one kReplacement a byte.
uint32_t take_code_point(std::string_view& utf8) noexcept;

/// A line as cut from a text.
struct Line {
  std::string_view text;
  bool ellipsis = false;  ///< "…" follows: the caption goes on but there is no more room
};

/// How wide a code point is, in any unit; a plain function pointer so that nothing is allocated.
struct Measure {
  const void* context = nullptr;
  int64_t (*advance)(const void* context, uint32_t code_point) noexcept = nullptr;

  int64_t of(uint32_t code_point) const noexcept { return advance(context, code_point); }
};

/// Takes the next line of at most `limit` off `rest`: up to a '\n', else to the last space that fits, else anywhere
/// (but at least one code point). Spaces at the break belong to neither line. With `last_line`, a rest that does not
/// fit is cut, and the line with its ellipsis stays within the limit if a lone ellipsis does.
Line take_line(std::string_view& rest, int64_t limit, const Measure& measure, bool last_line) noexcept;

}  // namespace auslan
