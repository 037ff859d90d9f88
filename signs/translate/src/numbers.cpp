// SPDX-License-Identifier: Apache-2.0
#include "numbers.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace auslan {
namespace {

constexpr std::array<std::string_view, 20> kSmall = {
    "zero", "one",    "two",    "three",    "four",     "five",    "six",     "seven",     "eight",    "nine",
    "ten",  "eleven", "twelve", "thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};
constexpr std::array<std::string_view, 8> kTens = {"twenty", "thirty",  "forty",  "fifty",
                                                   "sixty",  "seventy", "eighty", "ninety"};

template <size_t N>
int index_in(const std::array<std::string_view, N>& list, std::string_view word) {
  const auto found = std::find(list.begin(), list.end(), word);
  return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

/// Value of a number below 100 at `at`, and how many words it takes (0: none).
size_t read_below_hundred(std::span<const Word> words, size_t at, uint64_t* value) {
  if (at >= words.size() || words[at].kind != WordKind::kLetters || words[at].possessive) return 0;
  if (const int small = index_in(kSmall, words[at].norm); small >= 0) {
    *value = static_cast<uint64_t>(small);
    return 1;
  }
  const int tens = index_in(kTens, words[at].norm);
  if (tens < 0) return 0;
  *value = static_cast<uint64_t>(tens + 2) * 10;
  if (words[at].after.strength == 0 && at + 1 < words.size()) {
    const int unit = index_in(kSmall, words[at + 1].norm);
    if (unit >= 1 && unit <= 9) {
      *value += static_cast<uint64_t>(unit);
      return 2;
    }
  }
  return 1;
}

bool is_word(std::span<const Word> words, size_t at, std::string_view norm) {
  return at < words.size() && words[at].norm == norm && words[at - 1].after.strength == 0;
}

/// Value below 1000: "two hundred and fifty".
size_t read_below_thousand(std::span<const Word> words, size_t at, uint64_t* value) {
  size_t count = 0;
  if (words[at].norm == "hundred") {
    *value = 100;
    count = 1;
  } else {
    count = read_below_hundred(words, at, value);
    if (count == 0 || *value == 0 || !is_word(words, at + count, "hundred")) return count;
    *value *= 100;
    ++count;
  }
  const size_t joint = is_word(words, at + count, "and") ? 1 : 0;
  uint64_t rest = 0;
  if (words[at + count - 1].after.strength > 0 || (joint == 1 && words[at + count].after.strength > 0)) return count;
  const size_t more = read_below_hundred(words, at + count + joint, &rest);
  if (more == 0 || rest == 0) return count;
  *value += rest;
  return count + joint + more;
}

std::string_view rule_of(std::string_view digits) {
  if (digits.find('.') != std::string_view::npos) return "number:decimal";
  if (digits.find(':') != std::string_view::npos) return "number:time";
  const auto slashes = std::count(digits.begin(), digits.end(), '/');
  if (slashes > 1) return "number:date";
  return slashes == 1 ? "number:fraction" : "number:digits";
}

}  // namespace

NumberReading read_number(std::span<const Word> words, size_t at) {
  if (at >= words.size()) return {};
  const Word& first = words[at];
  if (first.kind == WordKind::kNumber) return {1, first.norm, rule_of(first.norm)};
  if (first.kind != WordKind::kLetters) return {};
  uint64_t total = 0, value = 0;
  uint64_t scale_limit = 1000000000000;  // scales must fall: "two million three thousand"
  size_t count = 0;
  while (at + count < words.size()) {
    if (count > 0 && words[at + count - 1].after.strength > 0) break;
    size_t taken = read_below_thousand(words, at + count, &value);
    const bool bare_scale = taken == 0 && count == 0;
    if (taken == 0 && !bare_scale) break;
    uint64_t scale = 1;
    if (bare_scale) value = 1;
    const size_t next = at + count + taken;
    if (next < words.size() && (bare_scale || words[next - 1].after.strength == 0)) {
      if (words[next].norm == "thousand") scale = 1000;
      if (words[next].norm == "million") scale = 1000000;
      if (words[next].norm == "billion") scale = 1000000000;
    }
    if (scale == 1 && bare_scale) break;
    if (scale >= scale_limit || (scale == 1 && count > 0 && scale_limit == 1)) break;
    total += value * scale;
    count += taken + (scale > 1 ? 1 : 0);
    if (scale == 1) break;
    scale_limit = scale;
  }
  if (count == 0) return {};
  return {count, std::to_string(total), "number:word"};
}

}  // namespace auslan
