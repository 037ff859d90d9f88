// SPDX-License-Identifier: Apache-2.0
#include "grammar.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace auslan {
namespace {

constexpr const char* kHoldLastSign = "hold last sign";

bool is_signed(const Draft& draft) {
  return draft.item.kind != ItemKind::kDropped && draft.item.kind != ItemKind::kPause;
}

void move_to(std::vector<Draft>* from, std::vector<Draft>* to) {
  std::move(from->begin(), from->end(), std::back_inserter(*to));
}

NonManualSpan question_span(const char* kind, const char* brows, int from, int to) {
  NonManualSpan span;
  span.kind = kind;
  span.from = from;
  span.to = to;
  span.brows = brows;
  span.head = "tilt-forward";
  span.gaze = "addressee";
  span.ending = kHoldLastSign;
  return span;
}

}  // namespace

std::vector<Draft> order_clause(const Clause& clause, std::vector<Draft> drafts) {
  std::vector<Draft> lead, time, body, wh;
  bool content_before = false;
  bool wh_open = clause.question == QuestionKind::kWh;
  for (Draft& draft : drafts) {
    const bool content = is_signed(draft);
    if (draft.lead) {
      lead.push_back(std::move(draft));
    } else if (draft.time) {
      if (content_before) draft.item.rules.emplace_back("time-first");
      time.push_back(std::move(draft));
    } else if (wh_open && draft.wh && content) {
      wh.push_back(std::move(draft));  // the first wh-sign, with "long" or "often" right after "how"
    } else {
      if (!wh.empty()) wh_open = false;
      content_before = content_before || content;
      body.push_back(std::move(draft));
    }
  }
  // wh_open stays true where the wh-word already stood last.
  if (!wh_open)
    for (Draft& draft : wh)
      draft.item.rules.emplace_back("wh-last");
  std::vector<Draft> ordered;
  ordered.reserve(drafts.size());
  move_to(&lead, &ordered);
  move_to(&time, &ordered);
  move_to(&body, &ordered);
  move_to(&wh, &ordered);
  return ordered;
}

void mark_clause(const Clause& clause, const std::vector<Draft>& drafts, int first, std::vector<NonManualSpan>* spans) {
  int from = -1, to = -1, negated_from = -1, negated_to = -1;
  for (size_t i = 0; i < drafts.size(); ++i) {
    const Draft& draft = drafts[i];
    if (!is_signed(draft)) continue;
    const int index = first + static_cast<int>(i);
    if (!draft.lead) {
      if (from < 0) from = index;
      to = index;
    }
    if (draft.negator && negated_from < 0) negated_from = index;
    const bool asked = draft.wh && clause.question == QuestionKind::kWh;
    if (negated_from >= 0 && (!asked || draft.negator)) negated_to = index;
  }
  if (from >= 0 && clause.question == QuestionKind::kWh) spans->push_back(question_span("wh", "furrow", from, to));
  if (from >= 0 && clause.question == QuestionKind::kYesNo) {
    const auto open =
        std::find_if(spans->rbegin(), spans->rend(), [](const NonManualSpan& s) { return s.kind == "yn"; });
    if (clause.continues_question && open != spans->rend())
      open->to = to;
    else
      spans->push_back(question_span("yn", "raise", from, to));
  }
  if (clause.condition && to >= 0) {
    NonManualSpan span;
    span.kind = "cond";
    span.from = first;
    span.to = to;
    span.brows = "raise";
    span.ending = "pause/blink";
    spans->push_back(std::move(span));
  }
  if (negated_from >= 0) {
    NonManualSpan span;
    span.kind = "neg";
    span.from = negated_from;
    span.to = negated_to;
    span.head = "shake";
    // In a question or a condition the brows already mean something else.
    if (clause.question == QuestionKind::kNone && !clause.condition) span.brows = "furrow-slight";
    spans->push_back(std::move(span));
  }
}

}  // namespace auslan
