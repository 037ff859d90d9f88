// SPDX-License-Identifier: Apache-2.0
// Reading: UTF-8 text to words with their byte spans. Nothing is thrown away but white space, quotes and characters
// that have no appearance of their own; contractions become two words.
#pragma once

#include "kinematics/result.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

/// Punctuation after a word.
struct Break {
  int strength = 0;  ///< 0 none, 1 inside a sentence (comma, dash, bracket …), 2 end of a sentence
  bool question = false;
  size_t begin = 0, end = 0;  ///< bytes; empty where a blank line ends the sentence
};

enum class WordKind {
  kLetters,  ///< letters, or letters mixed with digits
  kNumber,  ///< digits, with . : / between them where the text has them; `norm` holds ASCII digits, no thousands commas
  kOther,   ///< symbols without a reading: emoji and the like
};

struct Word {
  WordKind kind = WordKind::kLetters;
  size_t begin = 0, end = 0;  ///< bytes of the input
  std::string norm;       ///< NFC, case-folded, contraction expanded ("n't" is "not"), symbols read ("%" is "percent")
  std::string_view rule;  ///< the rule that read it, or empty
  bool capital = false;   ///< begins with a capital letter
  bool upper = false;     ///< more than one letter, all capitals
  bool glued = false;     ///< joined to the word before it by a hyphen, or split from it ("20mg")
  bool possessive = false;  ///< ends in a possessive 's
  Break after;
};

/// Fails with kMalformed and the byte offset where `text` is not UTF-8. An empty result means there was no word.
Result<std::vector<Word>> read_words(std::string_view text);

}  // namespace auslan
