// SPDX-License-Identifier: Apache-2.0
// English text to items in Auslan signing order, by approved phrases, then words, then fingerspelling. Every item says
// which rules made it; the rules and the facts they rest on are listed in the room's README.
//
// The translator is transparent and total: every word of the input is covered by exactly one item, and the same text
// always gives the same result. It works in time proportional to the length of the text.
#pragma once

#include "kinematics/result.h"
#include "phonology/phrase.h"
#include "translate/translation.h"
#include "translate/word_forms.h"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

/// What the translator needs to know of a lexicon entry.
struct EntryFacts {
  std::string gloss;
  Confidence confidence = Confidence::kLow;
  ReviewState review = ReviewState::kUnreviewed;
  std::string region = "all";
  bool safety_critical = false;
};

/// Everything the translator knows, as plain data.
struct TranslatorData {
  std::vector<EntryFacts> entries;  ///< signs, letters and numbers; a gloss that is not here is never put into a
                                    ///< result. Signs and phrases that a reviewer rejected are never used
  std::vector<Phrase> phrases;  ///< a reviewed phrase wins over an unreviewed one with the same English, then the first
  std::vector<Keyword> keywords;           ///< those that point to unknown or rejected entries are left out
  std::vector<WordForm> irregular_lemmas;  ///< "teeth" -> "tooth"; read_wordnet_exceptions() supplies them
  std::string letter_prefix = "fs:";       ///< "fs:A" is the entry of the letter A
  std::string number_prefix = "num:";      ///< "num:7" is the entry of the number 7
};

class WordIndex;

/// Immutable once built; translate() may be called from several threads at once.
class Translator {
 public:
  /// The longest text that translate() takes, in bytes.
  static constexpr size_t kMaxBytes = size_t{1} << 20;

  /// Fails with kNotFound where one of the letters A to Z or of the digits 0 to 9 has no entry (fingerspelling could
  /// not be total), and with kMalformed, naming the phrase, where a phrase has no English or no glosses, a slot that is
  /// not {NAME}, {NUMBER}, {TIME} or {WORD}, a slot in its glosses that its English lacks, or a span outside its
  /// glosses.
  static Result<Translator> build(TranslatorData data);

  /// `english` is UTF-8. Fails with kMalformed and the byte offset where it is not, with kLimit beyond kMaxBytes, and
  /// with kUsage where nothing in it can be signed.
  Result<Translation> translate(std::string_view english) const;

  Translator(Translator&&) noexcept;
  Translator& operator=(Translator&&) noexcept;
  ~Translator();

 private:
  explicit Translator(std::unique_ptr<const WordIndex> index);
  std::unique_ptr<const WordIndex> index_;
};

}  // namespace auslan
