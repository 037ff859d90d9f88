// SPDX-License-Identifier: Apache-2.0
// Phrases, keywords and spans of non-manual features: the sentence-level half of the lexicon.
#pragma once

#include "phonology/sign.h"

#include <string>
#include <vector>

namespace auslan {

/// Non-manual features over consecutive items of a signed sentence, both ends included.
struct NonManualSpan {
  std::string kind;                            ///< topic, yn, wh, neg, cond, aff, cmd, polite
  int from = 0;                                ///< index of the first item
  int to = 0;                                  ///< index of the last item
  std::string brows, head, gaze, mouth, eyes;  ///< the words of NonManual; empty = not marked
  std::string ending;                          ///< "hold last sign", "pause/blink" or empty
};

/// A sentence that a person has put into signing order. In `english`, {NAME}, {NUMBER}, {TIME}, {WORD} are typed slots.
struct Phrase {
  std::string id;
  std::string domain;
  std::string english;
  std::vector<std::string> glosses;  ///< GLOSS, "{SLOT}", "fs:TEXT" (fingerspelled) or "num:DIGITS"
  std::vector<NonManualSpan> non_manual;
  std::string notes;
  Provenance provenance;
};

/// An English word or fixed expression that an entry can stand for.
struct Keyword {
  std::string word;            ///< lower case, lemma form; may hold single spaces ("blood pressure")
  std::string part_of_speech;  ///< noun verb adj adv pron wh num neg modal interj prep conj det, or empty (any)
  std::string gloss;
  int rank = 0;  ///< 0 is the first choice among entries that share the word
};

}  // namespace auslan
