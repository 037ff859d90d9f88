// SPDX-License-Identifier: Apache-2.0
// The order of a clause's items and its non-manual features.
#pragma once

#include "clauses.h"
#include "resolver.h"
#include "translate/translation.h"

#include <vector>

namespace auslan {

/// Puts the drafts into signing order: "and"/"please" …, time words, the rest, the wh-sign of a wh-question.
std::vector<Draft> order_clause(const Clause& clause, std::vector<Draft> drafts);

/// Spans of one ordered clause whose first item has index `first` in the translation. A clause that continues a yes/no
/// question lengthens the question's span, the last of its kind in `spans`.
void mark_clause(const Clause& clause, const std::vector<Draft>& drafts, int first, std::vector<NonManualSpan>* spans);

}  // namespace auslan
