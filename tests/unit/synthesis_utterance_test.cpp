// SPDX-License-Identifier: Apache-2.0
#include "synthesis/utterance.h"

#include <gtest/gtest.h>
#include <string>

namespace auslan {
namespace {

Result<std::optional<Sign>> some_sign(std::string_view gloss) {
  if (gloss == "UNKNOWN") return std::optional<Sign>();
  Sign sign;
  sign.gloss = gloss;
  sign.dominant.resize(1);
  sign.dominant[0].handshape = gloss == "ODD" ? "missing" : "flat";
  sign.non_manual.mouthing = "word";
  return std::optional<Sign>(sign);
}

Result<std::optional<Handshape>> some_handshape(std::string_view id) {
  if (id == "missing") return std::optional<Handshape>();
  Handshape shape;
  shape.id = id;
  return std::optional<Handshape>(shape);
}

Item item(ItemKind kind, std::vector<std::string> glosses, std::string text, size_t begin) {
  Item made;
  made.kind = kind;
  made.glosses = std::move(glosses);
  made.text = std::move(text);
  made.begin = begin;
  made.end = begin + made.text.size();
  return made;
}

Item pause(double seconds) {
  Item made;
  made.kind = ItemKind::kPause;
  made.pause_seconds = seconds;
  return made;
}

Translation two_sentences() {
  Translation t;
  t.english = "The Hi, Kim. Where?";
  t.items = {item(ItemKind::kDropped, {}, "The", 0),
             item(ItemKind::kSign, {"HELLO"}, "Hi", 4),
             pause(0.25),
             item(ItemKind::kSpelled, {"K", "I", "M"}, "Kim", 8),
             pause(0.5),
             item(ItemKind::kSign, {"WHERE"}, "Where", 13)};
  return t;
}

TEST(Utterance, LettersBecomeUnitsAndDroppedWordsNone) {
  const auto utterance = compose(two_sentences(), some_sign, some_handshape);
  ASSERT_TRUE(utterance);
  ASSERT_EQ(utterance->units.size(), 7U);  // HELLO, pause, K, I, M, pause, WHERE
  EXPECT_TRUE(utterance->units[2].spelled);
  EXPECT_TRUE(utterance->units[2].first_of_word);
  EXPECT_EQ(utterance->units[2].word_letters, 3);
  EXPECT_FALSE(utterance->units[3].first_of_word);
  EXPECT_EQ(utterance->units[2].mouthing, "Kim");
  EXPECT_TRUE(utterance->units[3].mouthing.empty());
  EXPECT_FALSE(utterance->units[1].sign);
}

TEST(Utterance, SpansMoveFromItemsToUnits) {
  Translation t = two_sentences();
  NonManualSpan span;
  span.from = 3;
  span.to = 3;
  t.non_manual = {span};
  const auto utterance = compose(t, some_sign, some_handshape);
  ASSERT_TRUE(utterance);
  ASSERT_EQ(utterance->non_manual.size(), 1U);
  EXPECT_EQ(utterance->non_manual[0].from, 2);  // K
  EXPECT_EQ(utterance->non_manual[0].to, 4);    // M
}

TEST(Utterance, CaptionsAreTheSentencesAsWritten) {
  const auto utterance = compose(two_sentences(), some_sign, some_handshape);
  ASSERT_TRUE(utterance);
  ASSERT_EQ(utterance->sentences.size(), 2U);
  EXPECT_EQ(utterance->sentences[0], "The Hi, Kim.");
  EXPECT_EQ(utterance->sentences[1], "Where?");
  EXPECT_EQ(utterance->units[0].sentence, 0);
  EXPECT_EQ(utterance->units[6].sentence, 1);
}

TEST(Utterance, AnUnknownGlossIsNamed) {
  const auto utterance = compose(translation_of_glosses({"UNKNOWN"}), some_sign, some_handshape);
  ASSERT_FALSE(utterance);
  EXPECT_EQ(utterance.error().code, ErrorCode::kNotFound);
  EXPECT_NE(utterance.error().message.find("UNKNOWN"), std::string::npos);
}

TEST(Utterance, AMissingHandshapeIsNamed) {
  const auto utterance = compose(translation_of_glosses({"ODD"}), some_sign, some_handshape);
  ASSERT_FALSE(utterance);
  EXPECT_NE(utterance.error().message.find("missing"), std::string::npos);
}

TEST(Utterance, NothingIsReviewedUntilSomebodyHasReviewedIt) {
  const auto utterance = compose(translation_of_glosses({"HELLO"}), some_sign, some_handshape);
  ASSERT_TRUE(utterance);
  EXPECT_FALSE(utterance->all_reviewed);
}

}  // namespace
}  // namespace auslan
