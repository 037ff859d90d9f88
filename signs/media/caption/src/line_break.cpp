// SPDX-License-Identifier: Apache-2.0
#include "line_break.h"

#include <cstddef>

namespace auslan {

uint32_t take_code_point(std::string_view& utf8) noexcept {
  const auto byte = [&utf8](size_t i) { return static_cast<uint32_t>(static_cast<unsigned char>(utf8[i])); };
  const uint32_t first = byte(0);
  size_t length = 0;
  uint32_t value = 0;
  uint32_t least = 0;
  if (first < 0x80) {
    utf8.remove_prefix(1);
    return first;
  }
  if (first >= 0xC2 && first <= 0xDF) {
    length = 2, value = first & 0x1F, least = 0x80;
  } else if (first >= 0xE0 && first <= 0xEF) {
    length = 3, value = first & 0x0F, least = 0x800;
  } else if (first >= 0xF0 && first <= 0xF4) {
    length = 4, value = first & 0x07, least = 0x10000;
  }
  bool good = length > 0 && utf8.size() >= length;
  for (size_t i = 1; good && i < length; ++i) {
    good = (byte(i) & 0xC0) == 0x80;
    value = value << 6 | (byte(i) & 0x3F);
  }
  good = good && value >= least && value <= 0x10FFFF && (value < 0xD800 || value > 0xDFFF);
  utf8.remove_prefix(good ? length : 1);
  return good ? value : kReplacement;
}

namespace {

bool is_space(uint32_t code_point) {
  return code_point == ' ' || code_point == '\t' || code_point == '\r';
}

/// How many bytes of `text` fit in `limit`, cut at a space if there is one, else anywhere.
size_t bytes_that_fit(std::string_view text, int64_t limit, const Measure& measure, bool at_least_one) noexcept {
  std::string_view rest = text;
  int64_t width = 0;
  size_t anywhere = 0;
  size_t at_space = 0;
  bool after_space = false;
  while (!rest.empty()) {
    const size_t here = text.size() - rest.size();
    const uint32_t code_point = take_code_point(rest);
    // A break is before the first of several spaces.
    if (is_space(code_point) && !after_space && here > 0) at_space = here;
    after_space = is_space(code_point);
    width += measure.of(code_point);
    if (width > limit && !(at_least_one && anywhere == 0)) {
      // A space that does not fit is dropped at the break: the word before it is whole.
      return at_space > 0 ? at_space : anywhere;
    }
    anywhere = text.size() - rest.size();
  }
  return text.size();
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(static_cast<unsigned char>(text.back())))
    text.remove_suffix(1);
  return text;
}

}  // namespace

Line take_line(std::string_view& rest, int64_t limit, const Measure& measure, bool last_line) noexcept {
  while (!rest.empty() && is_space(static_cast<unsigned char>(rest.front())))
    rest.remove_prefix(1);
  const size_t newline = rest.find('\n');
  const std::string_view paragraph = trimmed(rest.substr(0, newline));
  const bool more_paragraphs =
      newline != std::string_view::npos && rest.find_first_not_of(" \t\r\n", newline) != std::string_view::npos;
  const size_t fits = bytes_that_fit(paragraph, limit, measure, true);
  const bool all_of_it = fits == paragraph.size();
  Line line;
  if (last_line && (!all_of_it || more_paragraphs)) {
    const size_t with_ellipsis = bytes_that_fit(paragraph, limit - measure.of(kEllipsis), measure, false);
    line.text = trimmed(paragraph.substr(0, with_ellipsis));
    line.ellipsis = true;
    rest = {};
    return line;
  }
  line.text = trimmed(paragraph.substr(0, fits));
  if (all_of_it) {
    rest.remove_prefix(newline == std::string_view::npos ? rest.size() : newline + 1);
  } else {
    rest.remove_prefix(fits);
  }
  return line;
}

}  // namespace auslan
