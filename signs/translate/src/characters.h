// SPDX-License-Identifier: Apache-2.0
// Characters of the input and what reading does with each class of them.
#pragma once

#include "kinematics/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

enum class CharClass {
  kSpace,
  kNewline,
  kLetter,
  kDigit,
  kFraction,
  kApostrophe,
  kHyphen,
  kDash,
  kStop,
  kQuestion,
  kComma,
  kIgnored,
  kPoint,
  kSlash,
  kSymbolWord,
  kOther
};

struct Character {
  int32_t code = 0;
  CharClass kind = CharClass::kOther;
  size_t begin = 0;  ///< byte offset
};

/// One more element than characters: the last is the end of the text (kNewline). Fails with kMalformed and "byte N".
Result<std::vector<Character>> read_characters(std::string_view text);

/// "percent" for '%', empty for a character without a reading.
std::string_view symbol_reading(int32_t code);

/// Value of a decimal digit of any script.
int digit_value(int32_t code);

bool is_upper(int32_t code);

/// NFC and case-folded, invisible characters removed, typographic apostrophes made plain. `text` is valid UTF-8.
std::string fold_case(std::string_view text);

/// What fingerspelling can show of `text` (valid UTF-8): a to z and 0 to 9, diacritics folded. Characters that have no
/// letter are appended to `lost`, once each call and character.
std::string fold_letters(std::string_view text, std::vector<std::string>* lost);

}  // namespace auslan
