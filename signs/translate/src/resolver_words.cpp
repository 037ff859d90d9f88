// SPDX-License-Identifier: Apache-2.0
// Single words: senses, spelling, numbers.
#include "characters.h"
#include "closed_class.h"
#include "numbers.h"
#include "region.h"
#include "resolver.h"

#include <algorithm>
#include <array>
#include <utility>

namespace auslan {
namespace {

constexpr size_t kLongSpelling = 12;  // letters; beyond it the English should stand beside the signing

std::string_view ordinal_word(std::string_view norm) {
  static constexpr std::array<std::string_view, 10> kWords = {"first", "second",  "third",  "fourth", "fifth",
                                                              "sixth", "seventh", "eighth", "ninth",  "tenth"};
  const std::string_view digits = norm.substr(0, norm.size() - 2);
  if (digits == "10") return kWords[9];
  return digits.size() == 1 && digits[0] >= '1' ? kWords[static_cast<size_t>(digits[0] - '1')] : std::string_view{};
}

std::string join(const std::vector<std::string>& words, std::string_view between) {
  std::string result;
  for (const std::string& word : words) {
    if (!result.empty()) result += between;
    result += word;
  }
  return result;
}

}  // namespace

Item Resolver::item_over(size_t at, size_t count, ItemKind kind) const {
  Item item;
  item.kind = kind;
  item.begin = words_[at].begin;
  item.end = words_[at + count - 1].end;
  item.text = std::string(text_.substr(item.begin, item.end - item.begin));
  return item;
}

void Resolver::rate(Item* item) const {
  if (item->glosses.empty()) return;
  for (const std::string& gloss : item->glosses) {
    const EntryFacts* facts = index_.entry(gloss);
    if (facts == nullptr) continue;
    item->confidence = std::min(item->confidence, facts->confidence);
    if (facts->review != ReviewState::kReviewed) item->review = facts->review;
  }
}

std::vector<std::string> Resolver::letters_of(std::string_view written) {
  std::vector<std::string> lost, glosses;
  for (const char c : fold_letters(written, &lost))
    glosses.push_back(c >= 'a' && c <= 'z' ? index_.letter(c) : index_.number(std::string_view(&c, 1)));
  return glosses;
}

Item Resolver::spell(size_t at, size_t count, std::string_view rule) {
  Item item = item_over(at, count, ItemKind::kSpelled);
  // What a symbol or a contraction stands for is spelled, not the marks that were written.
  const bool as_read = count == 1 && (words_[at].possessive || words_[at].rule == "symbol" ||
                                      words_[at].rule == "number:range" || words_[at].rule == "contraction");
  const std::string written = as_read ? words_[at].norm : item.text;
  std::vector<std::string> lost;
  for (const char c : fold_letters(written, &lost))
    item.glosses.push_back(c >= 'a' && c <= 'z' ? index_.letter(c) : index_.number(std::string_view(&c, 1)));
  if (item.glosses.empty()) {
    item.kind = ItemKind::kDropped;
    item.rules = {"drop:no-letter"};
    warnings_->add(WarningKind::kNoLetter, item.text);
    return item;
  }
  if (!words_[at].rule.empty()) item.rules.emplace_back(words_[at].rule);
  item.rules.emplace_back(rule);
  if (!lost.empty()) {
    item.rules.emplace_back("spell:lost-character");
    warnings_->add(WarningKind::kLostCharacter, item.text, join(lost, " "));
  }
  if (item.glosses.size() > kLongSpelling) {
    item.rules.emplace_back("spell:long");
    warnings_->add(WarningKind::kLongSpelling, item.text, std::to_string(item.glosses.size()));
  }
  // That a name is spelled is sure; that an unknown word has no sign is not.
  item.confidence = rule == "spell:unknown" ? Confidence::kMedium : Confidence::kHigh;
  item.review = ReviewState::kReviewed;
  rate(&item);
  return item;
}

std::vector<std::string> Resolver::number_glosses(std::string_view digits) {
  std::vector<std::string> glosses;
  const auto read_symbol = [&](std::string_view word) {
    const auto found = index_.exact(word);
    if (!found.empty()) {
      glosses.push_back(index_.keywords()[static_cast<size_t>(found.front())].gloss);
      return;
    }
    for (const std::string& letter : letters_of(word))
      glosses.push_back(letter);
  };
  const auto slashes = std::count(digits.begin(), digits.end(), '/');
  bool fraction = false;
  while (!digits.empty()) {
    const size_t end = std::min(digits.find_first_of(".:/"), digits.size());
    const std::string part(digits.substr(0, end));
    if (!fraction && index_.entry(index_.number(part)) != nullptr && (part.size() == 1 || part.front() != '0'))
      glosses.push_back(index_.number(part));
    else
      for (const char& digit : part)
        glosses.push_back(index_.number(std::string_view(&digit, 1)));
    if (end == digits.size()) break;
    if (digits[end] == '.') {
      read_symbol("point");
      fraction = true;
    }
    if (digits[end] == '/' && slashes == 1) read_symbol("slash");
    digits.remove_prefix(end + 1);
  }
  return glosses;
}

Item Resolver::number(size_t at, size_t count, std::string_view digits, std::string_view rule) {
  Item item = item_over(at, count, ItemKind::kNumber);
  item.glosses = number_glosses(digits);
  item.rules.emplace_back(rule);
  if (item.glosses.size() > 1 && (rule == "number:word" || rule == "number:digits"))
    item.rules.emplace_back("number:digit-by-digit");
  if (item.glosses.size() > 1 && rule != "number:date" && rule != "number:time")
    warnings_->add(WarningKind::kNumberForm, item.text);
  item.confidence = item.glosses.size() > 1 ? Confidence::kMedium : Confidence::kHigh;
  item.review = ReviewState::kReviewed;
  rate(&item);
  return item;
}

std::vector<std::string> Resolver::distinct(std::span<const int> keywords, std::string_view part_of_speech) const {
  std::vector<std::string> glosses;
  for (const int k : keywords) {
    const Keyword& keyword = index_.keywords()[static_cast<size_t>(k)];
    const bool fits = part_of_speech.empty() || keyword.part_of_speech.empty() ||
                      keyword.part_of_speech == part_of_speech ||
                      (part_of_speech == "adj" && keyword.part_of_speech == "adv");
    const auto same = [&](const std::string& gloss) { return without_region(gloss) == without_region(keyword.gloss); };
    if (fits && std::none_of(glosses.begin(), glosses.end(), same)) glosses.push_back(keyword.gloss);
  }
  return glosses;
}

bool Resolver::is_verb(size_t at) const {
  if (at >= clause_.end) return false;
  const std::string& norm = words_[at].norm;
  if (norm == "be" || norm == "have" || norm == "do") return true;
  const auto found = index_.exact(norm);
  return std::any_of(found.begin(), found.end(),
                     [&](int k) { return index_.keywords()[static_cast<size_t>(k)].part_of_speech == "verb"; });
}

std::string_view Resolver::expected_part_of_speech(size_t at) const {
  if (at <= clause_.begin || !joined(at)) return {};
  const std::string& last = words_[at - 1].norm;
  const std::string_view before = at - 1 > clause_.begin && joined(at - 1) ? std::string_view(words_[at - 2].norm) : "";
  if (last == "not") return is_modal(before) || is_do_form(before) ? "verb" : "";
  if (is_modal(last) || (last == "to" && is_verb(at))) return "verb";
  if (is_do_form(last) && at - 1 == clause_.lead_end) return "verb";
  if (is_subject_pronoun(last)) return is_copula(before) ? "adj" : "verb";
  if (is_article(last) || is_possessive_pronoun(last)) return "noun";
  if (is_copula(last) || last == "very" || last == "too" || last == "how") return "adj";
  return {};
}

Resolver::Sense Resolver::sense_of(size_t at) const {
  const Word& word = words_[at];
  const std::string_view expected = expected_part_of_speech(at);
  Sense sense;
  const auto exact = index_.exact(word.norm);
  if (!exact.empty()) {
    const std::vector<std::string> all = distinct(exact, {});
    sense.glosses = expected.empty() ? all : distinct(exact, expected);
    if (sense.glosses.empty() && expected != "verb") sense.glosses = all;
    for (const std::string& gloss : all)
      if (std::find(sense.glosses.begin(), sense.glosses.end(), gloss) == sense.glosses.end())
        sense.alternatives.push_back(gloss);
    if (!sense.glosses.empty()) return sense;
  }
  const std::vector<LemmaCandidate> candidates = index_.lemmatiser().candidates(word.norm);
  for (const bool must_fit : {true, false}) {
    for (const LemmaCandidate& candidate : candidates) {
      if (must_fit && candidate.part_of_speech != expected) continue;
      sense.glosses = distinct(index_.exact(candidate.lemma), candidate.part_of_speech);
      if (sense.glosses.empty()) continue;
      sense.rule = candidate.rule;
      sense.doubtful = candidate.doubtful;
      return sense;
    }
    if (!exact.empty()) break;  // "left" after a pronoun is a verb only if a verb is known
  }
  if (!exact.empty()) {
    sense.glosses = distinct(exact, {});
    sense.alternatives.clear();
  }
  return sense;
}

Item Resolver::word(size_t at) {
  const Word& word = words_[at];
  if (word.kind == WordKind::kOther) return spell(at, 1, "spell:unknown");
  if (const NumberReading reading = read_number(words_.subspan(0, at + 1), at); reading.words > 0)
    return number(at, 1, reading.digits, reading.rule);
  Item item = item_over(at, 1, ItemKind::kSign);
  Sense sense = sense_of(at);
  if (sense.glosses.empty() && is_ordinal(word.norm)) {
    sense.glosses = distinct(index_.exact(ordinal_word(word.norm)), {});
    sense.rule = "number:ordinal";
  }
  if (sense.glosses.empty() && is_negator(word.norm) && word.norm == "not" && index_.entry("NOT") != nullptr &&
      index_.entry("NOT")->review != ReviewState::kRejected)
    sense.glosses = {"NOT"};
  if (sense.glosses.empty()) return spell(at, 1, is_negator(word.norm) ? "spell:negator" : "spell:unknown");
  if (!word.rule.empty()) item.rules.emplace_back(word.rule);
  item.rules.emplace_back(sense.rule.empty() ? "word" : sense.rule);
  if (word.possessive) item.rules.emplace_back("possessive");
  item.glosses = {sense.glosses.front()};
  item.ambiguous = sense.glosses.size() > 1 || sense.doubtful;
  item.alternatives.assign(sense.glosses.begin() + 1, sense.glosses.end());
  if (item.ambiguous) {
    item.rules.emplace_back("ambiguous");
    const std::string other = sense.doubtful && sense.glosses.size() == 1 ? " or another word" : "";
    warnings_->add(WarningKind::kAmbiguous, item.text, join(sense.glosses, " or ") + other);
  }
  item.alternatives.insert(item.alternatives.end(), sense.alternatives.begin(), sense.alternatives.end());
  item.confidence = item.ambiguous ? Confidence::kLow : sense.rule.empty() ? Confidence::kHigh : Confidence::kMedium;
  item.review = ReviewState::kReviewed;
  rate(&item);
  return item;
}

}  // namespace auslan
