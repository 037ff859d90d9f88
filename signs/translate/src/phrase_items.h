// SPDX-License-Identifier: Apache-2.0
// The items of a matched phrase: its glosses in the order a person gave them, its slots filled from the text.
#pragma once

#include "clauses.h"
#include "resolver.h"
#include "translate/translation.h"
#include "warnings.h"
#include "word_index.h"

#include <span>
#include <vector>

namespace auslan {

/// Appends the items and the spans of the phrase that `clause` matched. Each English word is given to the gloss that
/// stands for it, or to a neighbour's; words that no item can hold follow as dropped items with the phrase's rule.
void add_phrase_items(const Clause& clause, std::span<const Word> words, const WordIndex& index, Resolver* resolver,
                      Warnings* warnings, Translation* out);

}  // namespace auslan
