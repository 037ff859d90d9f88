// SPDX-License-Identifier: Apache-2.0
// Phrases: the order a person gave, matched before any rule.
#include "translate_vocabulary.h"

#include <gtest/gtest.h>
#include <utility>

namespace auslan {
namespace {

using test::phrase;
using test::phrase_span;

Translator translator_with(std::vector<Phrase> phrases) {
  TranslatorData data = test::vocabulary();
  data.phrases = std::move(phrases);
  auto result = Translator::build(std::move(data));
  EXPECT_TRUE(result) << to_string(result.error());
  return std::move(*result);
}

std::string translate(const Translator& translator, const char* english) {
  const auto result = translator.translate(english);
  return result ? test::signed_line(*result) : to_string(result.error());
}

TEST(Phrases, MatchWithoutRegardToCasePunctuationAndContraction) {
  const Translator translator = translator_with({phrase("where-pain", "Where is the pain?", {"PAIN", "WHERE"})});
  for (const char* english : {"Where is the pain?", "where\u2019s the pain", "WHERE IS, THE PAIN!"})
    EXPECT_EQ(translator.translate(english)->items[0].rules.front(), "phrase:where-pain") << english;
}

TEST(Phrases, TheLongestWins) {
  const Translator translator =
      translator_with({phrase("a", "Wait.", {"WAIT"}), phrase("b", "Wait here.", {"HERE", "WAIT"})});
  EXPECT_EQ(translate(translator, "Wait here."), "HERE WAIT");
}

TEST(Phrases, MustBeAWholeClause) {
  const Translator translator = translator_with(
      {phrase("a", "I do not understand.", {"I", "NOT-UNDERSTAND"}), phrase("b", "What happened?", {"WHAT"})});
  EXPECT_EQ(translator.translate("I do not understand you")->items[0].rules.front(), "word");
}

TEST(Phrases, DoNotReachOverASentenceEndThatTheyLack) {
  const Translator translator = translator_with({phrase("a", "No water.", {"NOTHING"})});
  EXPECT_EQ(translate(translator, "No. Water."), "NO | WATER");
}

TEST(Phrases, NameSlotTakesOneToThreeWordsUpToPunctuation) {
  const Translator translator =
      translator_with({phrase("name", "My name is {NAME}.", {"MY", "NAME", "{NAME}"}, {phrase_span("aff", 2, 2, "")})});
  const auto result = *translator.translate("Hello, my name is Kim Brown Lee, where is the toilet?");
  EXPECT_EQ(test::signed_line(result), "HELLO | MY NAME K-I-M B-R-O-W-N L-E-E | TOILET WHERE");
  const NonManualSpan& span = result.non_manual.front();
  EXPECT_EQ(span.kind, "aff");
  EXPECT_EQ(result.items[static_cast<size_t>(span.from)].text, "Kim");
  EXPECT_EQ(result.items[static_cast<size_t>(span.to)].text, "Lee");
}

TEST(Phrases, NameSlotNeverSwallowsANegator) {
  const Translator translator = translator_with({phrase("name", "My name is {NAME}.", {"MY", "NAME", "{NAME}"})});
  EXPECT_EQ(translate(translator, "My name is not Kim."), "MY NAME NOT K-I-M");
}

TEST(Phrases, NumberTimeAndWordSlots) {
  const Translator translator =
      translator_with({phrase("take", "Take {NUMBER} {WORD}.", {"{WORD}", "TAKE", "{NUMBER}"}),
                       phrase("see", "See the doctor at {TIME}.", {"TIME", "{TIME}", "DOCTOR", "SEE"})});
  EXPECT_EQ(translate(translator, "Take twenty-five tablets."), "TABLET TAKE #2-5");
  EXPECT_EQ(translate(translator, "See the doctor at 10:30 pm."), "TIME #10-3-0 P-M DOCTOR SEE");
}

TEST(Phrases, SpelledAndNumberGlosses) {
  const Translator translator = translator_with({phrase("lift", "Use level two.", {"fs:LEVEL", "num:2", "USE"})});
  EXPECT_EQ(translate(translator, "use level two"), "L-E-V-E-L #2 USE");
}

TEST(Phrases, EveryWordBelongsToOneItem) {
  const Translator translator = translator_with({phrase("where-pain", "Where is the pain?", {"PAIN", "WHERE"})});
  const auto result = *translator.translate("Where is the pain?");
  ASSERT_EQ(result.items.size(), 2u);
  EXPECT_EQ(result.items[0].text, "pain");
  EXPECT_EQ(result.items[1].text, "Where is the");
}

TEST(Phrases, ReviewedWinAndRejectedAreNeverUsed) {
  Phrase first = phrase("draft", "Stop here.", {"STOP"});
  Phrase reviewed = phrase("checked", "Stop here.", {"HERE", "STOP"});
  reviewed.provenance.review = ReviewState::kReviewed;
  Phrase rejected = phrase("bad", "Wait here.", {"GO"});
  rejected.provenance.review = ReviewState::kRejected;
  const Translator translator = translator_with({first, reviewed, rejected});
  EXPECT_EQ(translate(translator, "Stop here."), "HERE STOP");
  EXPECT_EQ(translate(translator, "Wait here."), "WAIT HERE");
}

TEST(Phrases, ADefectIsNamed) {
  const auto error_of = [](Phrase broken) {
    TranslatorData data = test::vocabulary();
    data.phrases = {std::move(broken)};
    const auto result = Translator::build(std::move(data));
    return result ? std::string("built") : to_string(result.error());
  };
  EXPECT_NE(error_of(phrase("x1", "Go to {PLANET}.", {"GO"})).find("phrase x1"), std::string::npos);
  EXPECT_NE(error_of(phrase("x2", "Go.", {"GO", "{NAME}"})).find("phrase x2"), std::string::npos);
  EXPECT_NE(error_of(phrase("x3", "Go.", {})).find("phrase x3"), std::string::npos);
  EXPECT_NE(error_of(phrase("x4", "?", {"GO"})).find("phrase x4"), std::string::npos);
  EXPECT_NE(error_of(phrase("x5", "Go.", {"GO"}, {phrase_span("yn", 0, 1, "raise")})).find("phrase x5"),
            std::string::npos);
}

TEST(Phrases, AnEntryThatIsMissingIsSpelledAndReported) {
  const Translator translator = translator_with({phrase("lift", "Use it.", {"ABSEIL", "USE"})});
  const auto result = *translator.translate("Use it.");
  EXPECT_EQ(test::signed_line(result), "A-B-S-E-I-L USE");
  EXPECT_NE(result.warnings.front().find("ABSEIL"), std::string::npos);
}

}  // namespace
}  // namespace auslan
