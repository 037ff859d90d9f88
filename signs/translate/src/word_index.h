// SPDX-License-Identifier: Apache-2.0
// What the translator knows, arranged for look-up: entries by gloss, keywords and phrases as tries over words.
#pragma once

#include "lemma.h"
#include "translate/translator.h"
#include "words.h"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace auslan {

enum class Slot { kName, kNumber, kTime, kWord };

/// A phrase's English as the matcher sees it.
struct PhrasePart {
  int word = -1;  ///< id of the word, or -1 for a slot
  Slot slot = Slot::kName;
  bool after_stop = false;  ///< a sentence end may stand before it
};

struct KeywordMatch {
  size_t words = 0;           ///< how many words; 0 = none
  std::vector<int> keywords;  ///< indexes into keywords(), best first
  std::string_view rule;      ///< of the inflected word, or empty
};

struct SlotMatch {
  Slot slot = Slot::kName;
  size_t begin = 0, end = 0;  ///< word positions
};

struct PhraseMatch {
  int phrase = -1;  ///< index into phrases(), -1 = none
  size_t end = 0;   ///< one past the last word
  std::vector<SlotMatch> slots;
};

class WordIndex {
 public:
  static Result<WordIndex> build(TranslatorData data);

  const EntryFacts* entry(std::string_view gloss) const;
  const std::vector<Keyword>& keywords() const { return data_.keywords; }
  const std::vector<Phrase>& phrases() const { return data_.phrases; }
  /// The entry of a letter (a to z) or of a number (digits).
  std::string letter(char lower_case) const;
  std::string number(std::string_view digits) const { return data_.number_prefix + std::string(digits); }
  const Lemmatiser& lemmatiser() const { return lemmatiser_; }

  /// Keywords whose English is exactly this one word, best first.
  std::span<const int> exact(std::string_view word) const;

  /// The longest keyword of two words or more at words[at], before `end` and within punctuation; first and last word
  /// may be inflected.
  KeywordMatch longest_expression(std::span<const Word> words, size_t at, size_t end) const;

  /// The longest phrase that begins at words[at] and ends at a position (one past its last word) that `may_end` marks.
  PhraseMatch longest_phrase(std::span<const Word> words, size_t at, const std::vector<bool>& may_end) const;

  /// Could this word be part of a person's name inside a phrase or after "my name is"?
  bool may_be_name(std::span<const Word> words, size_t at, bool first) const;

 private:
  WordIndex() = default;
  int word_id(std::string_view norm) const;
  int intern(const std::string& norm);
  Result<std::vector<PhrasePart>> parse_phrase(const Phrase& phrase);
  void add_phrase(int index, const std::vector<PhrasePart>& parts);
  void add_keyword(int index);
  struct ExpressionWalk;
  void walk_expression(ExpressionWalk* walk, size_t at, int node, std::string_view rule) const;
  std::vector<size_t> slot_lengths(Slot slot, std::span<const Word> words, size_t at) const;

  struct PhraseWalk;
  void walk_phrases(PhraseWalk* walk, size_t at, int node) const;

  TranslatorData data_;
  std::map<std::string, size_t, std::less<>> entries_;
  std::map<std::string, int, std::less<>> word_ids_;
  std::map<std::pair<int, int>, int> expression_edges_;  ///< (node, word) -> node
  std::vector<std::vector<int>> expressions_at_;         ///< node -> keywords that end there
  std::map<std::pair<int, int>, int> phrase_edges_;
  std::vector<int> phrase_at_;
  Lemmatiser lemmatiser_{{}};
};

}  // namespace auslan
