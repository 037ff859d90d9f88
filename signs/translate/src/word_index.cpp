// SPDX-License-Identifier: Apache-2.0
#include "word_index.h"

#include "closed_class.h"
#include "numbers.h"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

namespace auslan {
namespace {

constexpr size_t kLongestName = 3;  // words

int child_of(const std::map<std::pair<int, int>, int>& edges, int node, int label) {
  const auto found = edges.find({node, label});
  return found == edges.end() ? -1 : found->second;
}

// Labels of the phrase trie: a word's id, a slot below zero; and the same after a sentence end.
int slot_label(Slot slot) {
  return -2 - static_cast<int>(slot);
}
int label_after_stop(int label) {
  return -100 - label;
}

bool slot_from_name(std::string_view name, Slot* slot) {
  static constexpr std::array<std::string_view, 4> kNames = {"NAME", "NUMBER", "TIME", "WORD"};
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return false;
  *slot = static_cast<Slot>(found - kNames.begin());
  return true;
}

Error phrase_error(const Phrase& phrase, std::string message) {
  return Error{ErrorCode::kMalformed, std::move(message), "phrase " + (phrase.id.empty() ? phrase.english : phrase.id)};
}

/// "hearing (person)" is looked up as "hearing".
std::string_view without_remark(std::string_view text) {
  const size_t bracket = text.find(" (");
  return bracket == std::string_view::npos ? text : text.substr(0, bracket);
}

}  // namespace

Result<WordIndex> WordIndex::build(TranslatorData data) {
  WordIndex index;
  index.data_ = std::move(data);
  for (size_t i = 0; i < index.data_.entries.size(); ++i)
    index.entries_.emplace(index.data_.entries[i].gloss, i);
  for (char letter = 'a'; letter <= 'z'; ++letter)
    if (index.entry(index.letter(letter)) == nullptr)
      return fail(ErrorCode::kNotFound, "the lexicon has no letter " + index.letter(letter) +
                                            "; fingerspelling needs all of A to Z: build the lexicon again");
  for (char digit = '0'; digit <= '9'; ++digit) {
    const std::string number = index.number(std::string_view(&digit, 1));
    if (index.entry(number) == nullptr)
      return fail(ErrorCode::kNotFound,
                  "the lexicon has no number " + number + "; it needs all of 0 to 9: build the lexicon again");
  }
  index.lemmatiser_ = Lemmatiser(index.data_.irregular_lemmas);
  index.expressions_at_.emplace_back();
  for (size_t i = 0; i < index.data_.keywords.size(); ++i) {
    const EntryFacts* facts = index.entry(index.data_.keywords[i].gloss);
    if (facts != nullptr && facts->review != ReviewState::kRejected) index.add_keyword(static_cast<int>(i));
  }
  for (std::vector<int>& list : index.expressions_at_)
    std::stable_sort(list.begin(), list.end(), [&](int a, int b) {
      return index.data_.keywords[static_cast<size_t>(a)].rank < index.data_.keywords[static_cast<size_t>(b)].rank;
    });
  index.phrase_at_.push_back(-1);
  for (size_t i = 0; i < index.data_.phrases.size(); ++i) {
    const Phrase& phrase = index.data_.phrases[i];
    auto parts = index.parse_phrase(phrase);
    if (!parts) return tl::unexpected<Error>(std::move(parts.error()));
    if (phrase.provenance.review != ReviewState::kRejected) index.add_phrase(static_cast<int>(i), *parts);
  }
  return index;
}

const EntryFacts* WordIndex::entry(std::string_view gloss) const {
  const auto found = entries_.find(gloss);
  return found == entries_.end() ? nullptr : &data_.entries[found->second];
}

std::string WordIndex::letter(char lower_case) const {
  return data_.letter_prefix + static_cast<char>(lower_case - 'a' + 'A');
}

int WordIndex::word_id(std::string_view norm) const {
  const auto found = word_ids_.find(norm);
  return found == word_ids_.end() ? -1 : found->second;
}

int WordIndex::intern(const std::string& norm) {
  return word_ids_.emplace(norm, static_cast<int>(word_ids_.size())).first->second;
}

void WordIndex::add_keyword(int index) {
  const auto words = read_words(without_remark(data_.keywords[static_cast<size_t>(index)].word));
  if (!words || words->empty()) return;  // a keyword without a word can match nothing
  int node = 0;
  for (const Word& word : *words) {
    const std::pair<int, int> edge{node, intern(word.norm)};
    const auto found = expression_edges_.find(edge);
    if (found != expression_edges_.end()) {
      node = found->second;
      continue;
    }
    node = static_cast<int>(expressions_at_.size());
    expression_edges_.emplace(edge, node);
    expressions_at_.emplace_back();
  }
  expressions_at_[static_cast<size_t>(node)].push_back(index);
}

Result<std::vector<PhrasePart>> WordIndex::parse_phrase(const Phrase& phrase) {
  std::vector<PhrasePart> parts;
  std::multiset<Slot> slots;
  std::string_view rest = phrase.english;
  bool stop = false;
  const auto add_words = [&](std::string_view text) -> bool {
    const auto words = read_words(text);
    if (!words) return false;
    for (const Word& word : *words) {
      parts.push_back({intern(word.norm), Slot::kName, stop && !parts.empty()});
      stop = word.after.strength > 0;
    }
    return true;
  };
  while (!rest.empty()) {
    const size_t open = rest.find('{');
    if (!add_words(rest.substr(0, open)))
      return tl::unexpected<Error>(phrase_error(phrase, "its English is not UTF-8"));
    if (open == std::string_view::npos) break;
    const size_t close = rest.find('}', open);
    Slot slot = Slot::kName;
    if (close == std::string_view::npos || !slot_from_name(rest.substr(open + 1, close - open - 1), &slot))
      return tl::unexpected<Error>(
          phrase_error(phrase, "its English has a slot that is not {NAME}, {NUMBER}, {TIME} or {WORD}"));
    parts.push_back({-1, slot, stop && !parts.empty()});
    slots.insert(slot);
    rest.remove_prefix(close + 1);
    stop = !rest.empty() && (rest.front() == '.' || rest.front() == '?' || rest.front() == '!');
  }
  if (parts.empty()) return tl::unexpected<Error>(phrase_error(phrase, "it has no English words"));
  if (phrase.glosses.empty()) return tl::unexpected<Error>(phrase_error(phrase, "it has no glosses"));
  for (const std::string& gloss : phrase.glosses) {
    if (gloss.empty() || gloss.front() != '{') continue;
    Slot slot = Slot::kName;
    const bool known =
        gloss.back() == '}' && slot_from_name(std::string_view(gloss).substr(1, gloss.size() - 2), &slot);
    const auto found = slots.find(slot);
    if (!known || found == slots.end())
      return tl::unexpected<Error>(
          phrase_error(phrase, "its glosses have the slot " + gloss + ", its English has not"));
    slots.erase(found);
  }
  const int count = static_cast<int>(phrase.glosses.size());
  for (const NonManualSpan& span : phrase.non_manual)
    if (span.from < 0 || span.to < span.from || span.to >= count)
      return tl::unexpected<Error>(phrase_error(phrase, "its span \"" + span.kind + "\" lies outside its glosses"));
  return parts;
}

void WordIndex::add_phrase(int index, const std::vector<PhrasePart>& parts) {
  int node = 0;
  for (const PhrasePart& part : parts) {
    const int label = part.word >= 0 ? part.word : slot_label(part.slot);
    const std::pair<int, int> edge{node, part.after_stop ? label_after_stop(label) : label};
    const auto found = phrase_edges_.find(edge);
    if (found != phrase_edges_.end()) {
      node = found->second;
      continue;
    }
    node = static_cast<int>(phrase_at_.size());
    phrase_edges_.emplace(edge, node);
    phrase_at_.push_back(-1);
  }
  int& holder = phrase_at_[static_cast<size_t>(node)];
  const auto reviewed = [&](int phrase) {
    return data_.phrases[static_cast<size_t>(phrase)].provenance.review == ReviewState::kReviewed;
  };
  if (holder < 0 || (reviewed(index) && !reviewed(holder))) holder = index;
}

std::span<const int> WordIndex::exact(std::string_view word) const {
  const int id = word_id(word);
  const int node = id < 0 ? -1 : child_of(expression_edges_, 0, id);
  if (node < 0) return {};
  return expressions_at_[static_cast<size_t>(node)];
}

struct WordIndex::ExpressionWalk {
  std::span<const Word> words;
  size_t begin = 0, end = 0;
  KeywordMatch best;
};

void WordIndex::walk_expression(ExpressionWalk* walk, size_t at, int node, std::string_view rule) const {
  const std::vector<int>& here = expressions_at_[static_cast<size_t>(node)];
  const size_t length = at - walk->begin;
  const bool better =
      length > walk->best.words || (length == walk->best.words && !walk->best.rule.empty() && rule.empty());
  if (length > 1 && !here.empty() && better) walk->best = {length, here, rule};
  if (at >= walk->end || (at > walk->begin && walk->words[at - 1].after.strength > 0)) return;
  const Word& word = walk->words[at];
  if (const int id = word_id(word.norm); id >= 0)
    if (const int next = child_of(expression_edges_, node, id); next >= 0) walk_expression(walk, at + 1, next, rule);
  if (!rule.empty() || is_closed_class(word.norm) != is_have_form(word.norm)) return;
  for (const LemmaCandidate& candidate : lemmatiser_.candidates(word.norm)) {
    if (candidate.part_of_speech == "adj") continue;  // a comparative inside a fixed expression is another expression
    const int id = word_id(candidate.lemma);
    if (id < 0) continue;
    if (const int next = child_of(expression_edges_, node, id); next >= 0)
      walk_expression(walk, at + 1, next, candidate.rule);
  }
}

KeywordMatch WordIndex::longest_expression(std::span<const Word> words, size_t at, size_t end) const {
  ExpressionWalk walk{words, at, end, {}};
  walk_expression(&walk, at, 0, {});
  return walk.best;
}

bool WordIndex::may_be_name(std::span<const Word> words, size_t at, bool first) const {
  const Word& word = words[at];
  if (word.kind != WordKind::kLetters || !word.rule.empty()) return false;
  if (is_closed_class(word.norm)) return first && word.capital && word.norm == "will";
  return first || word.capital || exact(word.norm).empty();
}

std::vector<size_t> WordIndex::slot_lengths(Slot slot, std::span<const Word> words, size_t at) const {
  const auto joined = [&](size_t i) { return i < words.size() && words[i - 1].after.strength == 0; };
  std::vector<size_t> lengths;
  switch (slot) {
    case Slot::kName: {
      size_t most = 0;
      while (most < kLongestName && (most == 0 || joined(at + most)) && may_be_name(words, at + most, most == 0))
        ++most;
      for (size_t length = most; length > 0; --length)
        lengths.push_back(length);
      break;
    }
    case Slot::kNumber:
      if (const size_t count = read_number(words, at).words; count > 0) lengths.push_back(count);
      break;
    case Slot::kTime: {
      size_t lead = 0;
      if (words[at].norm == "half" || words[at].norm == "quarter") {
        if (!joined(at + 1) || (words[at + 1].norm != "past" && words[at + 1].norm != "to") || !joined(at + 2)) break;
        lead = 2;
      }
      const size_t number = read_number(words, at + lead).words;
      if (number == 0) break;
      size_t count = lead + number;
      for (const std::string_view tail : {"o'clock", "am", "pm"})
        if (joined(at + count) && words[at + count].norm == tail) ++count;
      lengths.push_back(count);
      break;
    }
    case Slot::kWord:
      if (words[at].kind == WordKind::kLetters && !is_negator(words[at].norm)) lengths.push_back(1);
      break;
  }
  return lengths;
}

struct WordIndex::PhraseWalk {
  std::span<const Word> words;
  const std::vector<bool>& may_end;
  std::vector<SlotMatch> slots;
  PhraseMatch best;
};

// Depth-first; bounded by the phrases' length and three lengths a slot, whatever the text.
void WordIndex::walk_phrases(PhraseWalk* walk, size_t at, int node) const {
  const int phrase = phrase_at_[static_cast<size_t>(node)];
  if (phrase >= 0 && at > walk->best.end && walk->may_end[at]) walk->best = {phrase, at, walk->slots};
  if (at >= walk->words.size()) return;
  // A sentence end may stand only where the phrase has punctuation; where the phrase has it, the text need not.
  const bool stop = node != 0 && walk->words[at - 1].after.strength == 2;
  const auto follow = [&](int label) {
    const int plain = stop ? -1 : child_of(phrase_edges_, node, label);
    return plain >= 0 ? plain : child_of(phrase_edges_, node, label_after_stop(label));
  };
  if (const int id = word_id(walk->words[at].norm); id >= 0)
    if (const int next = follow(id); next >= 0) walk_phrases(walk, at + 1, next);
  for (const Slot slot : {Slot::kName, Slot::kNumber, Slot::kTime, Slot::kWord}) {
    const int next = follow(slot_label(slot));
    if (next < 0) continue;
    for (const size_t length : slot_lengths(slot, walk->words, at)) {
      walk->slots.push_back({slot, at, at + length});
      walk_phrases(walk, at + length, next);
      walk->slots.pop_back();
    }
  }
}

PhraseMatch WordIndex::longest_phrase(std::span<const Word> words, size_t at, const std::vector<bool>& may_end) const {
  PhraseWalk walk{words, may_end, {}, {}};
  walk_phrases(&walk, at, 0);
  return walk.best;
}

}  // namespace auslan
