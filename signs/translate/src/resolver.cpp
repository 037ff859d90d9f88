// SPDX-License-Identifier: Apache-2.0
#include "resolver.h"

#include "closed_class.h"
#include "numbers.h"

#include <algorithm>
#include <array>
#include <utility>

namespace auslan {
namespace {

struct NegatedVerb {
  std::string_view lemma, gloss;
};

// Auslan has one sign for these; a generic NOT with the verb would be signed English.
constexpr std::array<NegatedVerb, 7> kNegatedVerbs = {{{"have", "NOT-HAVE"},
                                                       {"want", "NOT-WANT"},
                                                       {"like", "NOT-LIKE"},
                                                       {"understand", "NOT-UNDERSTAND"},
                                                       {"know", "DONT-KNOW"},
                                                       {"allow", "NOT-ALLOWED"},
                                                       {"yet", "NOT-YET"}}};

bool is_digits_or_letter(const Word& word) {
  return word.kind == WordKind::kLetters && word.norm.size() == 1;
}

}  // namespace

bool Resolver::joined(size_t at) const {
  return at > clause_.begin && at < clause_.end && words_[at - 1].after.strength == 0;
}

std::vector<Draft> Resolver::resolve(const Clause& clause) {
  clause_ = clause;
  find_names();
  find_case();
  has_time_ = false;
  for (size_t at = clause.begin; at < clause.end; ++at) {
    const std::string& norm = words_[at].norm;
    has_time_ = has_time_ || is_time_word(norm) || norm == "ago" || norm == "last" || norm == "before" ||
                norm == "already" || norm == "finished";
  }
  std::vector<Draft> drafts;
  for (size_t at = clause.begin; at < clause.end;) {
    const size_t first = drafts.size();
    const size_t begin = at;
    at = add_next(at, &drafts);
    for (size_t i = first; i < drafts.size(); ++i)
      drafts[i].lead = begin < clause.lead_end;
  }
  return drafts;
}

/// "my name is Kim Lee": the words after it are spelled, whatever else they mean.
void Resolver::find_names() {
  name_begin_ = name_end_ = 0;
  for (size_t at = clause_.begin; at + 2 < clause_.end; ++at) {
    if (words_[at].norm != "name" || at == clause_.begin || !is_possessive_pronoun(words_[at - 1].norm)) continue;
    if (words_[at + 1].norm != "is" && words_[at + 1].norm != "was") continue;
    if (!joined(at + 1) || !joined(at + 2) || clause_.question == QuestionKind::kWh) continue;
    size_t end = at + 2;
    while (end < clause_.end && end < at + 5 && (end == at + 2 || joined(end)) &&
           index_.may_be_name(words_, end, end == at + 2))
      ++end;
    if (end == at + 2) continue;
    name_begin_ = at + 2;
    name_end_ = end;
    return;
  }
}

/// Capitals tell names only where the rest is not capitalised too.
void Resolver::find_case() {
  size_t words = 0, capitals = 0, uppers = 0;
  for (size_t at = clause_.begin + 1; at < clause_.end; ++at) {
    if (words_[at].kind != WordKind::kLetters || words_[at].norm.size() < 2) continue;
    ++words;
    if (words_[at].capital) ++capitals;
    if (words_[at].upper) ++uppers;
  }
  ignore_capitals_ = (uppers > 1 && uppers * 2 > words) || (words > 2 && capitals * 3 > words * 2);
}

bool Resolver::is_name(size_t at) const {
  if (at >= name_begin_ && at < name_end_) return true;
  const Word& word = words_[at];
  if (word.kind != WordKind::kLetters || !word.capital || ignore_capitals_ || at == 0 || is_closed_class(word.norm))
    return false;
  if (words_[at - 1].after.strength == 2) return false;
  const bool with_last = words_[at - 1].after.strength == 0;
  if (with_last && is_title(words_[at - 1].norm)) return true;
  if (index_.exact(word.norm).empty()) return !is_title(word.norm);
  // A capital on a known word makes it a name only beside a name: "Kim White".
  const Word& last = words_[at - 1];
  return with_last && last.capital && last.kind == WordKind::kLetters && !is_closed_class(last.norm) &&
         index_.exact(last.norm).empty() && last.norm.size() > 1 && !is_title(last.norm);
}

bool Resolver::stands_alone(size_t at) const {
  if (!is_digits_or_letter(words_[at]) || words_[at].rule == "contraction") return false;
  const char letter = words_[at].norm.front();
  if (letter < 'a' || letter > 'z') return false;
  const bool glued_before = words_[at].glued && at > 0 && is_digits_or_letter(words_[at - 1]);
  const bool glued_after = at + 1 < words_.size() && words_[at + 1].glued && is_digits_or_letter(words_[at + 1]);
  if (glued_before || glued_after) return true;
  if (letter == 'i') return false;
  if (letter != 'a') return true;
  const bool sentence_start = at == 0 || words_[at - 1].after.strength == 2;
  return words_[at].capital && !ignore_capitals_ && !sentence_start;
}

void Resolver::add_sign(size_t at, size_t count, const std::string& gloss, std::string_view rule, bool negator,
                        std::vector<Draft>* out) {
  Draft draft;
  draft.item = item_over(at, count, ItemKind::kSign);
  draft.item.glosses = {gloss};
  draft.item.rules.emplace_back(rule);
  draft.item.confidence = Confidence::kMedium;
  draft.item.review = ReviewState::kReviewed;
  rate(&draft.item);
  draft.negator = negator;
  out->push_back(std::move(draft));
}

bool Resolver::lemma_is(size_t at, std::string_view lemma) const {
  if (words_[at].norm == lemma) return true;
  const auto candidates = index_.lemmatiser().candidates(words_[at].norm);
  return std::any_of(candidates.begin(), candidates.end(), [&](const LemmaCandidate& c) { return c.lemma == lemma; });
}

/// Negators and what Auslan merges with them. Returns how many words were taken, 0 where no rule applied.
size_t Resolver::add_negation(size_t at, std::vector<Draft>* out) {
  const std::string& norm = words_[at].norm;
  const auto known = [&](std::string_view gloss) {
    const EntryFacts* facts = index_.entry(gloss);
    return facts != nullptr && facts->review != ReviewState::kRejected;
  };
  const bool before_not = joined(at + 1) && words_[at + 1].norm == "not";
  if ((norm == "can" || norm == "could") && before_not && known("CANT")) {
    add_sign(at, 2, "CANT", "neg:lexical", true, out);
    return 2;
  }
  if (is_have_form(norm) && before_not && joined(at + 2) && words_[at + 2].norm == "got" && known("NOT-HAVE")) {
    add_sign(at, 3, "NOT-HAVE", "neg:lexical", true, out);
    return 3;
  }
  if (norm != "not") return 0;
  const bool have_to = joined(at + 1) && joined(at + 2) && words_[at + 1].norm == "have" && words_[at + 2].norm == "to";
  if (have_to) {
    // "not have to" lifts an obligation, "must not" forbids: the two must never be signed alike.
    add_word(at, out);
    out->back().negator = true;
    out->back().item.rules.emplace_back("neg:no-obligation");
    if (known("NEED")) {
      add_sign(at + 1, 2, "NEED", "neg:no-obligation", false, out);
    } else {
      Draft draft;
      draft.item = spell(at + 1, 2, "neg:no-obligation");
      out->push_back(std::move(draft));
    }
    return 3;
  }
  if (joined(at + 1))
    for (const NegatedVerb& verb : kNegatedVerbs)
      if (known(verb.gloss) && lemma_is(at + 1, verb.lemma) && !(verb.lemma == "have" && is_perfect(at + 1))) {
        add_sign(at, 2, std::string(verb.gloss), "neg:lexical", true, out);
        return 2;
      }
  add_word(at, out);
  return 1;
}

/// Fixed expressions of the lexicon. Returns how many words were taken.
size_t Resolver::add_expression(size_t at, std::vector<Draft>* out) {
  const KeywordMatch match = index_.longest_expression(words_, at, clause_.end);
  if (match.words < 2) return 0;
  const Keyword& keyword = index_.keywords()[static_cast<size_t>(match.keywords.front())];
  const Word& last = words_[at + match.words - 1];
  if (last.norm == "not") return 0;  // "don't" as a keyword: the negator is handled by its own rule
  if (is_have_form(last.norm) && joined(at + match.words) && words_[at + match.words].norm == "to") return 0;
  // "what time" as a keyword of TIME would lose the question word.
  const bool wh = is_wh(words_[at].norm);
  const std::string_view gloss = keyword.gloss;
  const bool keeps_wh = gloss.substr(0, 3) == "HOW" || gloss.substr(0, 2) == "WH" || keyword.part_of_speech == "wh";
  if (wh && !keeps_wh) return 0;
  Draft draft;
  draft.item = item_over(at, match.words, ItemKind::kSign);
  const std::vector<std::string> glosses = distinct(match.keywords, {});
  draft.item.glosses = {glosses.front()};
  draft.item.alternatives.assign(glosses.begin() + 1, glosses.end());
  draft.item.rules = {"expression"};
  if (!match.rule.empty()) draft.item.rules.emplace_back(match.rule);
  draft.item.ambiguous = glosses.size() > 1;
  if (draft.item.ambiguous) {
    draft.item.rules.emplace_back("ambiguous");
    warnings_->add(WarningKind::kAmbiguous, draft.item.text, glosses[0] + " or " + glosses[1]);
  }
  draft.item.confidence = draft.item.ambiguous ? Confidence::kLow : Confidence::kHigh;
  draft.item.review = ReviewState::kReviewed;
  rate(&draft.item);
  for (size_t i = at; i < at + match.words; ++i)
    draft.negator = draft.negator || is_negator(words_[i].norm);
  draft.wh = wh;
  out->push_back(std::move(draft));
  return match.words;
}

void Resolver::mark_past(size_t at, std::vector<Draft>* out) {
  if (has_time_) return;
  out->back().item.rules.emplace_back("tense:past-unmarked");
  warnings_->add(WarningKind::kPast, text_.substr(words_[at].begin, words_[at].end - words_[at].begin));
}

void Resolver::add_word(size_t at, std::vector<Draft>* out) {
  Draft draft;
  const Word& word = words_[at];
  if (is_name(at))
    draft.item = spell(at, 1, "spell:name");
  else if (stands_alone(at))
    draft.item = spell(at, 1, "spell:letter");
  else if (word.rule == "unit" && index_.exact(word.norm).empty())
    draft.item = spell(at, 1, "spell:unit");
  else
    draft.item = this->word(at);
  draft.negator = is_negator(word.norm);
  draft.wh = is_wh(word.norm);
  const auto has_rule = [&](std::string_view rule) {
    return std::find(draft.item.rules.begin(), draft.item.rules.end(), rule) != draft.item.rules.end();
  };
  const bool past = has_rule("lemma:past") && !is_modal(word.norm);
  const bool comparative = has_rule("lemma:comparative"), superlative = has_rule("lemma:superlative");
  if (comparative || superlative) {
    // The degree is part of the message: signed before the adjective, or else the whole word is spelled.
    const std::string_view degree = comparative ? "MORE" : "MOST";
    if (index_.entry(degree) == nullptr) {
      draft.item = spell(at, 1, "spell:unknown");
    } else {
      Draft more;
      more.item.kind = ItemKind::kSign;
      more.item.begin = more.item.end = word.begin;
      more.item.glosses = {std::string(degree)};
      more.item.rules = {comparative ? "add:comparative" : "add:superlative"};
      more.item.review = ReviewState::kReviewed;
      rate(&more.item);
      out->push_back(std::move(more));
    }
  }
  const std::string_view last = joined(at) ? std::string_view(words_[at - 1].norm) : "";
  const std::string_view next = joined(at + 1) ? std::string_view(words_[at + 1].norm) : "";
  draft.time = is_time_word(word.norm) && !word.possessive && !is_preposition(last) && !is_negator(last) &&
               last != "right" && last != "and" && last != "or" && last != "but" && next != "and" && next != "or" &&
               next != "but";
  out->push_back(std::move(draft));
  if (past) mark_past(at, out);
}

size_t Resolver::add_next(size_t at, std::vector<Draft>* out) {
  const bool name = is_name(at);
  if (!name) {
    if (const size_t taken = add_negation(at, out); taken > 0) return at + taken;
    if (const size_t taken = add_expression(at, out); taken > 0) return at + taken;
    const std::string_view rule = drop_rule(at);
    if (rule == "future:going-to") {
      add_sign(at, 2, "WILL", rule, false, out);
      return at + 2;
    }
    if (!rule.empty()) {
      Draft draft;
      draft.item = item_over(at, 1, ItemKind::kDropped);
      if (!words_[at].rule.empty()) draft.item.rules.emplace_back(words_[at].rule);
      draft.item.rules.emplace_back(rule);
      draft.item.confidence = Confidence::kHigh;
      out->push_back(std::move(draft));
      if (words_[at].norm == "did" || is_past_copula(words_[at].norm) || rule == "drop:perfect") mark_past(at, out);
      return at + 1;
    }
    const NumberReading reading = read_number(words_.subspan(0, clause_.end), at);
    if (reading.words > 0) {
      Draft draft;
      draft.item = number(at, reading.words, reading.digits, reading.rule);
      out->push_back(std::move(draft));
      return at + reading.words;
    }
  }
  add_word(at, out);
  const bool degree = !name && joined(at) && words_[at - 1].norm == "how" && is_degree(words_[at].norm);
  if (degree) out->back().wh = true;
  return at + 1;
}

}  // namespace auslan
