// SPDX-License-Identifier: Apache-2.0
#include "phrase_items.h"

#include "characters.h"
#include "numbers.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace auslan {
namespace {

bool starts_with(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

/// "HELP(me)" and "CHILD+" are forms of HELP and CHILD.
std::string_view plain_gloss(std::string_view gloss) {
  return gloss.substr(0, gloss.find_first_of("(+"));
}

std::string_view slot_name(Slot slot) {
  switch (slot) {
    case Slot::kName:
      return "{NAME}";
    case Slot::kNumber:
      return "{NUMBER}";
    case Slot::kTime:
      return "{TIME}";
    case Slot::kWord:
      return "{WORD}";
  }
  return {};
}

std::string rule_of(const Phrase& phrase) {
  std::string rule = "phrase:";
  if (!phrase.domain.empty()) rule += phrase.domain + "/";
  return rule + (phrase.id.empty() ? phrase.english : phrase.id);
}

class PhraseBuilder {
 public:
  PhraseBuilder(const Clause& clause, std::span<const Word> words, const WordIndex& index, Resolver* resolver,
                Warnings* warnings, Translation* out)
      : clause_(clause),
        words_(words),
        index_(index),
        resolver_(resolver),
        warnings_(warnings),
        out_(out),
        phrase_(index.phrases()[static_cast<size_t>(clause.match.phrase)]),
        rule_(rule_of(phrase_)) {}

  void build() {
    owner_.assign(clause_.end - clause_.begin, kNobody);
    taken_.assign(phrase_.glosses.size(), false);
    slot_of_.assign(phrase_.glosses.size(), nullptr);
    give_slots();
    give_words();
    give_rest();
    std::vector<int> first, last;
    for (size_t g = 0; g < phrase_.glosses.size(); ++g) {
      first.push_back(static_cast<int>(out_->items.size()));
      if (slot_of_[g] != nullptr)
        add_slot(*slot_of_[g]);
      else
        add_gloss(g);
      last.push_back(static_cast<int>(out_->items.size()) - 1);
    }
    add_unowned();
    for (NonManualSpan span : phrase_.non_manual) {
      span.from = first[static_cast<size_t>(span.from)];
      span.to = last[static_cast<size_t>(span.to)];
      out_->non_manual.push_back(std::move(span));
    }
  }

 private:
  static constexpr int kNobody = -1, kSlot = -2;

  int& owner(size_t word) { return owner_[word - clause_.begin]; }

  void give_slots() {
    std::vector<bool> used(clause_.match.slots.size(), false);
    for (size_t g = 0; g < phrase_.glosses.size(); ++g)
      for (size_t s = 0; s < clause_.match.slots.size(); ++s) {
        const SlotMatch& slot = clause_.match.slots[s];
        if (used[s] || phrase_.glosses[g] != slot_name(slot.slot)) continue;
        used[s] = taken_[g] = true;
        slot_of_[g] = &slot;
        for (size_t word = slot.begin; word < slot.end; ++word)
          owner(word) = kSlot;
        break;
      }
  }

  int free_gloss(std::string_view gloss) const {
    for (size_t g = 0; g < phrase_.glosses.size(); ++g)
      if (!taken_[g] && plain_gloss(phrase_.glosses[g]) == gloss) return static_cast<int>(g);
    return kNobody;
  }

  int gloss_of_keywords(std::span<const int> keywords) const {
    for (const int k : keywords)
      if (const int g = free_gloss(index_.keywords()[static_cast<size_t>(k)].gloss); g >= 0) return g;
    return kNobody;
  }

  /// The gloss that a single word stands for: its keyword, the keyword of its base form, or "fs:" of the word itself.
  int gloss_of_word(const Word& word) const {
    if (const int g = gloss_of_keywords(index_.exact(word.norm)); g >= 0) return g;
    for (const LemmaCandidate& candidate : index_.lemmatiser().candidates(word.norm))
      if (const int g = gloss_of_keywords(index_.exact(candidate.lemma)); g >= 0) return g;
    for (size_t g = 0; g < phrase_.glosses.size(); ++g)
      if (!taken_[g] && starts_with(phrase_.glosses[g], "fs:") && fold_case(phrase_.glosses[g].substr(3)) == word.norm)
        return static_cast<int>(g);
    return kNobody;
  }

  void give_words() {
    for (size_t at = clause_.begin; at < clause_.end;) {
      if (owner(at) == kSlot) {
        ++at;
        continue;
      }
      const KeywordMatch match = index_.longest_expression(words_, at, clause_.end);
      int gloss = match.words > 1 ? gloss_of_keywords(match.keywords) : kNobody;
      size_t count = match.words;
      for (size_t i = at; gloss >= 0 && i < at + count; ++i)
        if (owner(i) == kSlot) gloss = kNobody;
      if (gloss < 0) {
        gloss = gloss_of_word(words_[at]);
        count = 1;
      }
      if (gloss >= 0) {
        taken_[static_cast<size_t>(gloss)] = true;
        for (size_t i = at; i < at + count; ++i)
          owner(i) = gloss;
      }
      at += count;
    }
  }

  /// Words that no gloss stands for go with the word before them, or else with the word after them; where no gloss took
  /// any word, with the first gloss that is no slot.
  void give_rest() {
    for (size_t at = clause_.begin + 1; at < clause_.end; ++at)
      if (owner(at) == kNobody && owner(at - 1) >= 0) owner(at) = owner(at - 1);
    for (size_t at = clause_.end - 1; at > clause_.begin; --at)
      if (owner(at - 1) == kNobody && owner(at) >= 0) owner(at - 1) = owner(at);
    const auto idle = std::find(taken_.begin(), taken_.end(), false);
    if (idle == taken_.end()) return;
    const int gloss = static_cast<int>(idle - taken_.begin());
    bool open = false;
    for (size_t at = clause_.begin; at < clause_.end; ++at) {
      if (owner(at) == kNobody)
        owner(at) = gloss;
      else if (open)
        return;
      open = open || owner(at) == gloss;
    }
  }

  void finish(Item item, size_t gloss) {
    size_t first = clause_.end, last = 0;
    for (size_t at = clause_.begin; at < clause_.end; ++at)
      if (owner(at) == static_cast<int>(gloss)) {
        first = std::min(first, at);
        last = at;
      }
    if (first < clause_.end) {
      Item covered = resolver_->item_over(first, last - first + 1, item.kind);
      item.text = std::move(covered.text);
      item.begin = covered.begin;
      item.end = covered.end;
    } else {
      item.begin = item.end = words_[clause_.begin].begin;
    }
    push(std::move(item));
  }

  /// A phrase is as sure and as reviewed as it says; an entry in it that is less so lowers its own item.
  void push(Item item) {
    item.rules.insert(item.rules.begin(), rule_);
    if (item.kind != ItemKind::kDropped) {
      item.confidence = std::min(phrase_.provenance.confidence, item.confidence);
      if (phrase_.provenance.review != ReviewState::kReviewed) item.review = phrase_.provenance.review;
    }
    out_->items.push_back(std::move(item));
  }

  void add_gloss(size_t g) {
    const std::string& gloss = phrase_.glosses[g];
    Item item;
    item.confidence = Confidence::kHigh;
    item.review = ReviewState::kReviewed;
    if (starts_with(gloss, "fs:")) {
      item.kind = ItemKind::kSpelled;
      item.glosses = resolver_->letters_of(std::string_view(gloss).substr(3));
    } else if (starts_with(gloss, "num:")) {
      item.kind = ItemKind::kNumber;
      item.glosses = resolver_->number_glosses(std::string_view(gloss).substr(4));
    } else if (index_.entry(gloss) != nullptr) {
      item.glosses = {gloss};
    } else if (index_.entry(plain_gloss(gloss)) != nullptr) {
      item.glosses = {std::string(plain_gloss(gloss))};
      item.rules.emplace_back("form:citation");
      item.confidence = Confidence::kMedium;
    } else {
      item.kind = ItemKind::kSpelled;
      item.glosses = resolver_->letters_of(plain_gloss(gloss));
      item.rules.emplace_back("spell:missing-entry");
      item.confidence = Confidence::kLow;
      warnings_->add(WarningKind::kMissingEntry, gloss, phrase_.id);
    }
    resolver_->rate(&item);
    finish(std::move(item), g);
  }

  void add_slot(const SlotMatch& slot) {
    if (slot.slot == Slot::kNumber) return add_number(slot.begin, slot.end);
    for (size_t at = slot.begin; at < slot.end;) {
      const NumberReading number =
          slot.slot == Slot::kTime ? read_number(words_.subspan(0, slot.end), at) : NumberReading{};
      if (number.words > 0) {
        add_number(at, at + number.words);
        at += number.words;
        continue;
      }
      const bool spelled = slot.slot == Slot::kName || words_[at].norm == "am" || words_[at].norm == "pm";
      push(spelled ? resolver_->spell(at, 1, "spell:name") : resolver_->word(at));
      ++at;
    }
  }

  void add_number(size_t begin, size_t end) {
    const NumberReading number = read_number(words_.subspan(0, end), begin);
    push(resolver_->number(begin, end - begin, number.digits, number.rule));
  }

  void add_unowned() {
    for (size_t at = clause_.begin; at < clause_.end; ++at)
      if (owner(at) == kNobody) push(resolver_->item_over(at, 1, ItemKind::kDropped));
  }

  const Clause& clause_;
  std::span<const Word> words_;
  const WordIndex& index_;
  Resolver* resolver_;
  Warnings* warnings_;
  Translation* out_;
  const Phrase& phrase_;
  std::string rule_;
  std::vector<int> owner_;                 ///< of each word of the clause: a gloss, kSlot or kNobody
  std::vector<bool> taken_;                ///< of each gloss
  std::vector<const SlotMatch*> slot_of_;  ///< of each gloss
};

}  // namespace

void add_phrase_items(const Clause& clause, std::span<const Word> words, const WordIndex& index, Resolver* resolver,
                      Warnings* warnings, Translation* out) {
  PhraseBuilder(clause, words, index, resolver, warnings, out).build();
}

}  // namespace auslan
