// SPDX-License-Identifier: Apache-2.0
// Numbers in digits and in words.
#pragma once

#include "words.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

struct NumberReading {
  size_t words = 0;    ///< how many words the number takes; 0 where none begins here
  std::string digits;  ///< as Word::norm of a number
  std::string_view
      rule;  ///< "number:word" or "number:digits", "number:decimal", "number:time", "number:date", "number:fraction"
};

/// The number that begins at words[at]; number words ("two hundred and fifty") are taken together, up to punctuation.
NumberReading read_number(std::span<const Word> words, size_t at);

}  // namespace auslan
