// SPDX-License-Identifier: Apache-2.0
// The rules a lexicon keeps, whatever it was read from: used by the text reader and by the database.
#pragma once

#include "lexicon/lexicon_text.h"

#include <string>
#include <string_view>
#include <vector>

namespace auslan {

/// A broken rule: the entry ("HURT", "handshape spread", "phrase where-pain"), the part of it where one can be named
/// ("dominant[0]", "moves[1]", "english[0]", "spans[2]"), and what is wrong with it.
struct Finding {
  std::string entry;
  std::string part;
  std::string message;
};

/// The rules inside one sign: phases, orientation, locations that fit its handedness, words of the face, provenance.
std::vector<Finding> check_sign(const Sign& sign);
std::vector<Finding> check_handshape(const Handshape& handshape);
std::vector<Finding> check_phrase(const Phrase& phrase);
/// The rules between entries as well: duplicates, dangling handshapes and glosses, signs without a keyword, unknown
/// parts of speech, two first choices for a word. In the order of the entries.
std::vector<Finding> check_lexicon(const LexiconText& text);

/// True for a gloss: capital letters, digits and hyphens, or "fs:" and a capital letter, or "num:" and digits.
bool is_gloss(std::string_view gloss);
/// True for an item of a phrase: a gloss, "fs:TEXT", "num:DIGITS", or a slot ({NAME}, {NUMBER}, {TIME}, {WORD}).
bool is_phrase_item(std::string_view item);

}  // namespace auslan
