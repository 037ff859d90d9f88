// SPDX-License-Identifier: Apache-2.0
// Which English function words are not signed. A dropped word stays in the result as an item that names its rule.
#include "closed_class.h"
#include "resolver.h"

#include <string_view>

namespace auslan {

/// A present or past perfect "have": before "been", or before the past form of a verb that is no word of its own.
bool Resolver::is_perfect(size_t at) const {
  if (!is_have_form(words_[at].norm)) return false;
  size_t next = at + 1;
  bool apart = false;  // something only an auxiliary lets stand between: "have you eaten", "has not eaten"
  while (next < clause_.end && next < at + 4 && joined(next)) {
    const std::string& norm = words_[next].norm;
    const bool adverb = norm == "ever" || norm == "just" || norm == "already" || norm == "never";
    if (!adverb && norm != "not" && !is_subject_pronoun(norm)) break;
    apart = true;
    ++next;
  }
  if (next >= clause_.end || !joined(next)) return false;
  const std::string& norm = words_[next].norm;
  if (norm == "been") return true;
  if (!apart && !index_.exact(norm).empty()) return false;  // "I have broken bones"
  for (const LemmaCandidate& candidate : index_.lemmatiser().candidates(norm))
    if (candidate.rule == "lemma:past" && !index_.exact(candidate.lemma).empty()) return true;
  return false;
}

std::string_view Resolver::do_rule(size_t at) const {
  const bool question = clause_.question != QuestionKind::kNone;
  if (joined(at + 1) && words_[at + 1].norm == "not") return "drop:do-support";
  const bool first = at == clause_.lead_end;
  bool after_wh = false;
  for (size_t i = at; i > clause_.begin && at - i < 4; --i)
    after_wh = after_wh || is_wh(words_[i - 1].norm);
  if (joined(at + 1)) {
    const std::string& next = words_[at + 1].norm;
    if ((first || after_wh) && is_subject_pronoun(next)) return question || after_wh ? "drop:do-support" : "";
    if ((first || after_wh) && question) return "drop:do-support";  // "does the tablet …", "does Kim …"
    // "I do understand": an auxiliary before a verb.
    if (!first && is_verb(at + 1) && joined(at) && is_subject_pronoun(words_[at - 1].norm)) return "drop:do-support";
    return {};
  }
  // "Yes, I do.": it stands for a verb said before.
  const bool after_pronoun = joined(at) && is_subject_pronoun(words_[at - 1].norm);
  return after_pronoun && clause_.question != QuestionKind::kWh ? std::string_view("drop:do-support")
                                                                : std::string_view();
}

/// "there is a fire", "is there a doctor"; but "the toilet is there", "there is the toilet" point.
bool Resolver::is_existential(size_t at) const {
  size_t next = at + 1;
  const bool inverted = joined(at) && is_copula(words_[at - 1].norm);
  if (inverted && at != clause_.lead_end + 1) return false;
  if (!inverted) {
    if (at != clause_.lead_end) return false;
    while (next < clause_.end && joined(next) && (is_modal(words_[next].norm) || words_[next].norm == "not"))
      ++next;
    if (next >= clause_.end || !joined(next) || !is_copula(words_[next].norm)) return false;
    ++next;
    if (next < clause_.end && joined(next) && words_[next].norm == "not") ++next;
  }
  if (next >= clause_.end || !joined(next)) return false;
  return words_[next].norm != "the" && !is_possessive_pronoun(words_[next].norm);
}

/// "where does it hurt", "it rains", "what time is it": the pronoun stands for nothing.
bool Resolver::is_dummy_it(size_t at) const {
  if (at >= clause_.begin + 3 && joined(at) && is_copula(words_[at - 1].norm)) {
    const std::string& noun = words_[at - 2].norm;
    if (is_wh(words_[at - 3].norm) && (noun == "time" || noun == "day" || noun == "date")) return true;
  }
  size_t next = at + 1;
  while (next < clause_.end && next < at + 4 && joined(next) &&
         (is_auxiliary(words_[next].norm) || words_[next].norm == "not"))
    ++next;
  return next < clause_.end && joined(next) && is_impersonal_verb(words_[next].norm);
}

std::string_view Resolver::drop_rule(size_t at) const {
  const Word& word = words_[at];
  const std::string& norm = word.norm;
  if (word.kind != WordKind::kLetters) return {};
  if (stands_alone(at)) return {};
  if (is_article(norm)) return "drop:article";
  if (is_copula(norm)) {
    // "10 am" is a time of day, not "I am".
    const bool after_number = joined(at) && words_[at - 1].kind == WordKind::kNumber;
    if (norm == "am" && (word.rule == "unit" || word.rule == "abbreviation" || after_number)) return {};
    return "drop:copula";
  }
  if (is_do_form(norm)) return do_rule(at);
  if (is_perfect(at)) return "drop:perfect";
  if (norm == "there" && is_existential(at)) return "drop:existential";
  if (norm == "it" && is_dummy_it(at)) return "drop:dummy-it";
  if (norm == "going" && joined(at + 1) && words_[at + 1].norm == "to" && joined(at + 2) && is_verb(at + 2)) {
    const bool after_be = (joined(at) && is_copula(words_[at - 1].norm)) ||
                          (at > clause_.begin + 1 && joined(at) && joined(at - 1) && is_copula(words_[at - 2].norm));
    if (after_be && index_.entry("WILL") != nullptr) return "future:going-to";
  }
  if (norm == "to" && word.rule != "number:range" && joined(at + 1)) {
    if (is_verb(at + 1)) return "drop:infinitive-to";
    if (joined(at) && is_motion_verb(words_[at - 1].norm)) return "drop:direction-to";
  }
  return {};
}

}  // namespace auslan
