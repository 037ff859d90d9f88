// SPDX-License-Identifier: Apache-2.0
#include "translate/translator.h"

#include "clauses.h"
#include "grammar.h"
#include "phrase_items.h"
#include "resolver.h"
#include "warnings.h"
#include "word_index.h"
#include "words.h"

#include <algorithm>
#include <utility>

namespace auslan {
namespace {

constexpr double kCommaPause = 0.25, kSentencePause = 0.5;  // seconds

bool is_signed(const Item& item) {
  return item.kind != ItemKind::kDropped && item.kind != ItemKind::kPause;
}

/// Builds the translation of one text, clause by clause.
class Assembly {
 public:
  Assembly(std::string_view english, std::span<const Word> words, const WordIndex& index)
      : words_(words), index_(index), resolver_(english, words, index, &warnings_) {
    result_.english = std::string(english);
  }

  Translation assemble() {
    for (const Clause& clause : find_clauses(words_, index_)) {
      if (clause.match.phrase >= 0) {
        add_phrase_items(clause, words_, index_, &resolver_, &warnings_, &result_);
      } else {
        add_rule_clause(clause);
      }
      if (clause.ends_sentence) end_sentence();
      add_pause(clause);
    }
    result_.warnings = warnings_.sentences();
    const bool unreviewed = std::any_of(result_.items.begin(), result_.items.end(), [](const Item& item) {
      return is_signed(item) && item.review != ReviewState::kReviewed;
    });
    if (unreviewed)
      result_.warnings.emplace_back(
          "This translation is automatic: not all of it has been checked by a Deaf signer of Auslan.");
    return std::move(result_);
  }

 private:
  void add_rule_clause(const Clause& clause) {
    std::vector<Draft> drafts = order_clause(clause, resolver_.resolve(clause));
    mark_clause(clause, drafts, static_cast<int>(result_.items.size()), &result_.non_manual);
    for (Draft& draft : drafts)
      result_.items.push_back(std::move(draft.item));
  }

  /// A sentence of dropped words alone ("It is.") is spelled: something was said.
  void end_sentence() {
    const auto begin = result_.items.begin() + static_cast<std::ptrdiff_t>(sentence_begin_);
    if (std::none_of(begin, result_.items.end(), is_signed))
      for (auto item = begin; item != result_.items.end(); ++item)
        respell(&*item);
    sentence_begin_ = result_.items.size();
  }

  void respell(Item* item) {
    if (item->kind != ItemKind::kDropped || item->rules.front() == "drop:no-letter") return;
    item->glosses = resolver_.letters_of(item->text);
    if (item->glosses.empty()) return;
    item->kind = ItemKind::kSpelled;
    item->rules.emplace_back("spell:only-words");
    item->confidence = Confidence::kLow;
    item->review = ReviewState::kReviewed;
    resolver_.rate(item);
  }

  /// Pauses stand between signed items only: not at the end, not before the first sign.
  void add_pause(const Clause& clause) {
    const Break& after = words_[clause.end - 1].after;
    if (after.strength == 0 || clause.end == words_.size()) return;
    const auto last = std::find_if(result_.items.rbegin(), result_.items.rend(),
                                   [](const Item& item) { return item.kind != ItemKind::kDropped; });
    if (last == result_.items.rend()) return;
    const double seconds = after.strength == 2 ? kSentencePause : kCommaPause;
    const char* rule = after.strength == 2 ? "pause:sentence" : "pause:comma";
    if (last->kind == ItemKind::kPause) {  // nothing was signed since
      if (seconds > last->pause_seconds) {
        last->pause_seconds = seconds;
        last->rules = {rule};
      }
      return;
    }
    Item pause;
    pause.kind = ItemKind::kPause;
    pause.begin = after.begin;
    pause.end = after.end;
    pause.text = result_.english.substr(after.begin, after.end - after.begin);
    pause.rules = {rule};
    pause.confidence = Confidence::kHigh;
    pause.pause_seconds = seconds;
    result_.items.push_back(std::move(pause));
    if (clause.ends_sentence) sentence_begin_ = result_.items.size();
  }

  std::span<const Word> words_;
  const WordIndex& index_;
  Warnings warnings_;
  Resolver resolver_;
  Translation result_;
  size_t sentence_begin_ = 0;
};

}  // namespace

Translator::Translator(std::unique_ptr<const WordIndex> index) : index_(std::move(index)) {}
Translator::Translator(Translator&&) noexcept = default;
Translator& Translator::operator=(Translator&&) noexcept = default;
Translator::~Translator() = default;

Result<Translator> Translator::build(TranslatorData data) {
  auto index = WordIndex::build(std::move(data));
  if (!index) return tl::unexpected<Error>(std::move(index.error()));
  return Translator(std::make_unique<const WordIndex>(std::move(*index)));
}

Result<Translation> Translator::translate(std::string_view english) const {
  if (english.size() > kMaxBytes)
    return fail(ErrorCode::kLimit, "the text has " + std::to_string(english.size()) + " bytes; at most " +
                                       std::to_string(kMaxBytes) + " can be translated at once: split it");
  const auto words = read_words(english);
  if (!words) return tl::unexpected<Error>(words.error());
  if (words->empty()) return fail(ErrorCode::kUsage, "nothing to sign: the text has no words; give some English words");
  Translation translation = Assembly(english, *words, *index_).assemble();
  if (std::none_of(translation.items.begin(), translation.items.end(), is_signed))
    return fail(
        ErrorCode::kUsage,
        "nothing to sign: none of the characters has a sign or a letter that can be fingerspelled; give some English "
        "words");
  return translation;
}

}  // namespace auslan
