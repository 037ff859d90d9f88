// SPDX-License-Identifier: Apache-2.0
// Whom a translation is for: dialects, and strictness about doubtful signs, over the lexicon that is shipped.
#include "lexicon/lexicon_text.h"
#include "translate/audience.h"
#include "translate/translation.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

namespace auslan {
namespace {

const LexiconText& lexicon() {
  static const auto kText = read_lexicon_text(std::string(AUSLANJAM_SOURCE_DIR) + "/assets/lexicon");
  EXPECT_TRUE(kText);
  return *kText;
}

TranslatorData data() {
  TranslatorData data;
  for (const Sign& sign : lexicon().signs)
    data.entries.push_back(
        {sign.gloss, sign.provenance.confidence, sign.provenance.review, sign.region, sign.safety_critical});
  data.keywords = lexicon().keywords;
  data.phrases = lexicon().phrases;
  return data;
}

std::string glosses(const std::string& english, const Audience& audience) {
  TranslatorData suited = data();
  suit(suited, audience);
  const auto translator = Translator::build(std::move(suited));
  EXPECT_TRUE(translator);
  const auto result = translator->translate(english);
  EXPECT_TRUE(result) << english;
  std::string all;
  for (const Item& item : result->items)
    for (const std::string& gloss : item.glosses)
      all += (all.empty() ? "" : " ") + gloss;
  return all;
}

TEST(Audience, EachDialectHasItsOwnSigns) {
  EXPECT_EQ(glosses("red", {Dialect::kSouth, false}), "RED");
  EXPECT_EQ(glosses("red", {Dialect::kNorth, false}), "RED-NORTH");
  EXPECT_EQ(glosses("red", {}), "RED");
  EXPECT_EQ(glosses("who", {Dialect::kNorth, false}), "WHO-NORTH");
  EXPECT_EQ(glosses("yesterday", {Dialect::kNorth, false}), "YESTERDAY-NORTH");
  EXPECT_EQ(glosses("sorry", {Dialect::kNorth, false}), "SORRY-NORTH");
}

TEST(Audience, WhatOneDialectAloneHasIsSignedInBoth) {
  EXPECT_EQ(glosses("purple", {Dialect::kNorth, false}), "PURPLE");
  EXPECT_EQ(glosses("hospital", {Dialect::kNorth, false}), glosses("hospital", {Dialect::kSouth, false}));
}

TEST(Audience, PhrasesFollowTheDialect) {
  for (const Phrase& phrase : lexicon().phrases)
    for (const std::string& gloss : phrase.glosses)
      if (gloss == "WHO" && phrase.english.find('{') == std::string::npos) {
        EXPECT_NE(glosses(phrase.english, {Dialect::kNorth, false}).find("WHO-NORTH"), std::string::npos)
            << phrase.english;
        EXPECT_EQ(glosses(phrase.english, {Dialect::kSouth, false}).find("WHO-NORTH"), std::string::npos)
            << phrase.english;
      }
}

TEST(Audience, DoubtfulSafetyCriticalSignsAreSpelledWhenStrict) {
  const Audience strict{std::nullopt, true};
  EXPECT_EQ(glosses("emergency", {}), "EMERGENCY");
  EXPECT_EQ(glosses("emergency", strict), "fs:E fs:M fs:E fs:R fs:G fs:E fs:N fs:C fs:Y");
  // A sign that nothing hangs on, and one that is not doubtful, stay signs.
  EXPECT_EQ(glosses("chocolate", strict), "CHOCOLATE");
  EXPECT_EQ(glosses("danger", strict), glosses("danger", {}));
  EntryFacts entry{"X", Confidence::kLow, ReviewState::kUnreviewed, "all", true};
  EXPECT_TRUE(is_doubtful(entry));
  entry.review = ReviewState::kReviewed;
  EXPECT_FALSE(is_doubtful(entry));
}

TEST(Audience, StrictnessLosesNoWordOfAPhrase) {
  const Audience strict{std::nullopt, true};
  for (const Phrase& phrase : lexicon().phrases) {
    if (phrase.english.find('{') != std::string::npos) continue;
    TranslatorData suited = data();
    suit(suited, strict);
    for (const std::string& gloss : phrase.glosses) {
      const auto kept = [&](const EntryFacts& entry) { return entry.gloss == gloss; };
      if (gloss.find(':') != std::string::npos || std::ranges::any_of(suited.entries, kept)) continue;
      EXPECT_NE(glosses(phrase.english, strict).find("fs:" + gloss.substr(0, 1)), std::string::npos)
          << phrase.english << " lost " << gloss;
    }
  }
}

}  // namespace
}  // namespace auslan
