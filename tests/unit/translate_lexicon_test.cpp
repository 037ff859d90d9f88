// SPDX-License-Identifier: Apache-2.0
// The translator over the lexicon that is shipped.
#include "lexicon/lexicon_text.h"
#include "translate_vocabulary.h"

#include <gtest/gtest.h>
#include <string>

namespace auslan {
namespace {

const LexiconText* lexicon() {
  static const auto kText = read_lexicon_text(std::string(AUSLANJAM_SOURCE_DIR) + "/assets/lexicon");
  if (!kText) ADD_FAILURE() << to_string(kText.error());
  return kText ? &*kText : nullptr;
}

Result<Translator> translator_over(const LexiconText& text) {
  TranslatorData data;
  for (const Sign& sign : text.signs)
    data.entries.push_back({sign.gloss, sign.provenance.confidence, sign.provenance.review});
  data.keywords = text.keywords;
  data.phrases = text.phrases;
  return Translator::build(std::move(data));
}

TEST(ShippedLexicon, EveryPhraseIsTranslatedByItself) {
  ASSERT_NE(lexicon(), nullptr);
  const auto translator = translator_over(*lexicon());
  ASSERT_TRUE(translator) << to_string(translator.error());
  for (const Phrase& phrase : lexicon()->phrases) {
    if (phrase.english.find('{') != std::string::npos) continue;
    const auto result = translator->translate(phrase.english);
    ASSERT_TRUE(result) << phrase.english;
    size_t gloss = 0;
    for (const Item& item : result->items) {
      if (item.kind == ItemKind::kDropped) continue;
      EXPECT_EQ(item.rules.front(), "phrase:" + phrase.domain + "/" + phrase.id) << phrase.english;
      EXPECT_NE(item.rules.back(), "spell:missing-entry") << phrase.english;
      ++gloss;
    }
    EXPECT_EQ(gloss, phrase.glosses.size()) << phrase.english;
    EXPECT_EQ(result->non_manual.size(), phrase.non_manual.size()) << phrase.english;
  }
}

TEST(ShippedLexicon, GreetingNameAndPain) {
  ASSERT_NE(lexicon(), nullptr);
  const auto translator = translator_over(*lexicon());
  ASSERT_TRUE(translator);
  const auto result = translator->translate("Hello, my name is Kim. Where does it hurt?");
  ASSERT_TRUE(result);
  EXPECT_EQ(test::signed_line(*result), "HELLO | MY NAME K-I-M | HURT WHERE");
}

}  // namespace
}  // namespace auslan
