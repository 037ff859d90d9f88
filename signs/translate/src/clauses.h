// SPDX-License-Identifier: Apache-2.0
// Cutting the words of a text into clauses: stretches that a phrase translates as a whole, or that the rules work on.
#pragma once

#include "word_index.h"
#include "words.h"

#include <cstddef>
#include <span>
#include <vector>

namespace auslan {

enum class QuestionKind { kNone, kYesNo, kWh };

struct Clause {
  size_t begin = 0, end = 0;  ///< word positions
  size_t lead_end = 0;        ///< the clause proper begins here, after "and", "please", "hello" …
  PhraseMatch match;          ///< match.phrase < 0: translated by rules
  QuestionKind question = QuestionKind::kNone;
  bool continues_question = false;  ///< belongs to the yes/no question that began in an earlier clause
  bool condition = false;           ///< begins with "if" and a comma follows
  bool ends_sentence = false;
};

/// The clauses in order; together they cover all words.
std::vector<Clause> find_clauses(std::span<const Word> words, const WordIndex& index);

}  // namespace auslan
