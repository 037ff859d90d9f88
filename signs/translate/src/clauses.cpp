// SPDX-License-Identifier: Apache-2.0
#include "clauses.h"

#include "closed_class.h"

namespace auslan {
namespace {

bool breaks_after(std::span<const Word> words, size_t at) {
  return words[at].after.strength > 0;
}

/// "where does it …", "what is the …": a wh-question that begins here whether or not punctuation says so.
bool is_inverted_wh(std::span<const Word> words, size_t at) {
  if (at + 2 >= words.size() || !is_wh(words[at].norm) || breaks_after(words, at) || breaks_after(words, at + 1))
    return false;
  if (at > 0 && !breaks_after(words, at - 1) && is_preposition(words[at - 1].norm)) return false;
  return is_auxiliary(words[at + 1].norm) &&
         (is_subject_pronoun(words[at + 2].norm) || is_determiner(words[at + 2].norm));
}

/// "do you …", "is there …": without a question mark only pronouns tell a question from an order ("do the dishes").
bool is_inverted_auxiliary(std::span<const Word> words, size_t at, size_t end, bool question_mark) {
  if (at >= end || !is_auxiliary(words[at].norm)) return false;
  if (question_mark) return true;
  if (at + 1 >= end || breaks_after(words, at)) return false;
  const std::string& next = words[at + 1].norm;
  if (next == "it" || next == "this" || next == "that" || next == "there")
    return words[at].norm != "do" && words[at].norm != "have";
  return is_subject_pronoun(next);
}

bool is_wh_question(std::span<const Word> words, size_t at, size_t end, bool question_mark) {
  if (at < end && is_preposition(words[at].norm) && at + 1 < end && is_wh(words[at + 1].norm)) ++at;
  if (at >= end || !is_wh(words[at].norm)) return false;
  const auto auxiliary_at = [&](size_t i) { return i < end && is_auxiliary(words[i].norm); };
  if (auxiliary_at(at + 1)) return true;
  const std::string& wh = words[at].norm;
  if (wh == "when") return false;  // "when I walk" is no question
  if (question_mark) return true;
  const bool takes_word =
      wh == "which" || wh == "what" || wh == "whose" || (wh == "how" && at + 1 < end && is_degree(words[at + 1].norm));
  return takes_word && at + 3 < end && auxiliary_at(at + 2) &&
         (is_subject_pronoun(words[at + 3].norm) || is_determiner(words[at + 3].norm));
}

size_t skip_lead(std::span<const Word> words, size_t at, size_t end) {
  while (at < end) {
    const bool pair = at + 1 < end && ((words[at].norm == "thank" && words[at + 1].norm == "you") ||
                                       (words[at].norm == "excuse" && words[at + 1].norm == "me"));
    if (pair)
      at += 2;
    else if (is_clause_opener(words[at].norm) || is_conjunction(words[at].norm))
      ++at;
    else
      break;
  }
  return at;
}

/// Cuts words into clauses; questions are settled afterwards, sentence by sentence.
class Cutter {
 public:
  Cutter(std::span<const Word> words, const WordIndex& index) : words_(words), index_(index) {
    may_end_.resize(words.size() + 1);
    for (size_t end = 1; end <= words.size(); ++end)
      may_end_[end] = end == words.size() || breaks_after(words, end - 1) || is_clause_closer(words[end].norm) ||
                      is_inverted_wh(words, end);
  }

  std::vector<Clause> cut() {
    size_t begin = 0;
    for (size_t at = 0; at < words_.size();) {
      PhraseMatch match;
      if (may_start_phrase(at)) match = index_.longest_phrase(words_, at, may_end_);
      if (match.phrase >= 0) {
        close(begin, at);
        begin = at = match.end;
        add(std::move(match));
        continue;
      }
      if (at > begin && begins_clause(begin, at)) {
        close(begin, at);
        begin = at;
      }
      ++at;
    }
    close(begin, words_.size());
    return std::move(clauses_);
  }

 private:
  bool may_start_phrase(size_t at) const {
    if (at == 0 || breaks_after(words_, at - 1) || is_clause_opener(words_[at - 1].norm) || is_inverted_wh(words_, at))
      return true;
    if (!clauses_.empty() && clauses_.back().match.phrase >= 0 && clauses_.back().end == at) return true;
    const std::string& last = words_[at - 1].norm;
    return at > 1 &&
           ((last == "you" && words_[at - 2].norm == "thank") || (last == "me" && words_[at - 2].norm == "excuse"));
  }

  bool begins_clause(size_t begin, size_t at) const {
    if (breaks_after(words_, at - 1)) return true;
    const std::string& word = words_[at].norm;
    if (word == "but" || word == "because") return true;
    if (is_inverted_wh(words_, at)) return skip_lead(words_, begin, at) < at;
    if (!is_conjunction(word) || at + 2 >= words_.size()) return false;
    const std::string& next = words_[at + 1].norm;
    const std::string& third = words_[at + 2].norm;
    if (is_wh(next) && is_auxiliary(third)) return true;
    if (is_auxiliary(next) && is_subject_pronoun(third)) return true;
    return is_subject_pronoun(next) && next != "i" && next != "you";
  }

  void close(size_t begin, size_t end) {
    if (begin == end) return;
    Clause clause;
    clause.begin = begin;
    clause.end = end;
    clause.lead_end = skip_lead(words_, begin, end);
    clause.condition = words_[begin].norm == "if" && words_[end - 1].after.strength == 1;
    clauses_.push_back(std::move(clause));
    note_sentence_end();
  }

  void add(PhraseMatch match) {
    Clause clause;
    clause.begin = clause.lead_end = clauses_.empty() ? 0 : clauses_.back().end;
    clause.end = match.end;
    clause.match = std::move(match);
    clauses_.push_back(std::move(clause));
    note_sentence_end();
  }

  void note_sentence_end() {
    Clause& clause = clauses_.back();
    clause.ends_sentence = clause.end == words_.size() || words_[clause.end - 1].after.strength == 2;
  }

  std::span<const Word> words_;
  const WordIndex& index_;
  std::vector<bool> may_end_;
  std::vector<Clause> clauses_;
};

bool has_wh(std::span<const Word> words, const Clause& clause) {
  for (size_t i = clause.begin; i < clause.end; ++i)
    if (is_wh(words[i].norm)) return true;
  return false;
}

void settle_sentence(std::span<const Word> words, std::span<Clause> clauses) {
  const bool mark = words[clauses.back().end - 1].after.question;
  bool found = false;
  bool in_yes_no = false;
  for (Clause& clause : clauses) {
    if (clause.match.phrase >= 0) {
      in_yes_no = false;
      continue;
    }
    if (is_wh_question(words, clause.lead_end, clause.end, mark)) {
      clause.question = QuestionKind::kWh;
    } else if (is_inverted_auxiliary(words, clause.lead_end, clause.end, mark)) {
      clause.question = QuestionKind::kYesNo;
    } else if (mark && in_yes_no) {
      clause.question = QuestionKind::kYesNo;
      clause.continues_question = true;
    }
    in_yes_no = clause.question == QuestionKind::kYesNo;
    found = found || clause.question != QuestionKind::kNone;
  }
  Clause& last = clauses.back();
  if (mark && !found && last.match.phrase < 0)
    last.question = has_wh(words, last) ? QuestionKind::kWh : QuestionKind::kYesNo;
}

}  // namespace

std::vector<Clause> find_clauses(std::span<const Word> words, const WordIndex& index) {
  std::vector<Clause> clauses = Cutter(words, index).cut();
  size_t begin = 0;
  for (size_t i = 0; i < clauses.size(); ++i) {
    if (!clauses[i].ends_sentence) continue;
    settle_sentence(words, std::span(clauses).subspan(begin, i + 1 - begin));
    begin = i + 1;
  }
  return clauses;
}

}  // namespace auslan
