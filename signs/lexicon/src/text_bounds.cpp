// SPDX-License-Identifier: Apache-2.0
#include "text_bounds.h"

namespace auslan {
namespace {

constexpr int kMaxDotsPerLine = 64;

}  // namespace

std::optional<Error> find_broken_bound(const TextSource& source) {
  const std::string& text = source.text;
  int line = 1;
  const auto broken = [&source, &line](ErrorCode code, std::string message) {
    return Error{code, std::move(message), source.name + ":" + std::to_string(line)};
  };
  if (text.size() > kMaxSourceBytes)
    return broken(ErrorCode::kLimit, "the file is larger than " + std::to_string(kMaxSourceBytes) + " bytes; split it");
  int nesting = 0;
  int dots = 0;
  size_t line_start = 0;
  char quote = 0;  // the open string's quote; strings end with their line, as the form has no multi-line strings
  bool comment = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      ++line;
      line_start = i + 1;
      dots = 0;
      quote = 0;
      comment = false;
      continue;
    }
    if (c == '\0') return broken(ErrorCode::kMalformed, "a zero byte; expected a text file");
    if (i - line_start >= kMaxLineBytes)
      return broken(ErrorCode::kLimit, "a line longer than " + std::to_string(kMaxLineBytes) + " bytes; break it");
    if (comment) continue;
    if (quote != 0) {
      if (c == '\\' && quote == '"' && i + 1 < text.size() && text[i + 1] != '\n')
        ++i;
      else if (c == quote)
        quote = 0;
      continue;
    }
    if (c == '"' || c == '\'') {
      if (text.compare(i, 3, std::string(3, c)) == 0)
        return broken(ErrorCode::kMalformed, "a multi-line string; expected a string on one line");
      quote = c;
    } else if (c == '#') {
      comment = true;
    } else if (c == '[' || c == '{') {
      if (++nesting > kMaxNesting)
        return broken(ErrorCode::kLimit, "brackets nested deeper than " + std::to_string(kMaxNesting));
    } else if (c == ']' || c == '}') {
      if (nesting > 0) --nesting;
    } else if (c == '.' && ++dots > kMaxDotsPerLine) {
      return broken(ErrorCode::kLimit, "more than " + std::to_string(kMaxDotsPerLine) + " dots in a line");
    }
  }
  return std::nullopt;
}

}  // namespace auslan
