// SPDX-License-Identifier: Apache-2.0
// What the translator hands on: items in signing order, each with the English it came from and the rules that made it.
#pragma once

#include "phonology/phrase.h"

#include <cstddef>
#include <string>
#include <vector>

namespace auslan {

enum class ItemKind {
  kSign,     ///< a lexicon entry
  kSpelled,  ///< fingerspelled, because no sign is known or because names are spelled
  kNumber,   ///< signed from number entries
  kPause,    ///< a clause or sentence boundary
  kDropped,  ///< deliberately not signed (articles, copula, auxiliary do …); kept here, so that nothing vanishes
             ///< silently
};

struct Item {
  ItemKind kind = ItemKind::kSign;
  std::vector<std::string>
      glosses;                ///< entry ids to perform: one for a sign, one a letter or digit for spelled and number
  std::string text;           ///< the English words this item stands for, as written; empty for what a rule added
  size_t begin = 0, end = 0;  ///< byte span of `text` in the input
  std::vector<std::string> rules;         ///< ids of the rules that made it, in order
  std::vector<std::string> alternatives;  ///< other entries the word could have been
  bool ambiguous = false;                 ///< more than one sense remained
  Confidence confidence = Confidence::kLow;
  ReviewState review = ReviewState::kUnreviewed;
  double pause_seconds = 0;  ///< for kPause
};

struct Translation {
  std::string english;                    ///< the text as it was read (valid UTF-8)
  std::vector<Item> items;                ///< in signing order; dropped items stand where their words stood
  std::vector<NonManualSpan> non_manual;  ///< from/to are indexes into items
  std::vector<std::string> warnings;      ///< one sentence each, for a person
};

}  // namespace auslan
