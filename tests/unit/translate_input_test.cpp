// SPDX-License-Identifier: Apache-2.0
// What a text may be: any bytes give a translation or an error that says what to do.
#include "translate_vocabulary.h"

#include <gtest/gtest.h>
#include <string>

namespace auslan {
namespace {

const Translator& translator() {
  static const Translator kTranslator = *Translator::build(test::vocabulary());
  return kTranslator;
}

TEST(Input, InvalidUtf8NamesTheByte) {
  for (const std::string& bad : {std::string("ab\xFF"), std::string("ab\xC3"), std::string("ab\xED\xA0\x80"),
                                 std::string("ab\xC0\xAF"), std::string("ab\xF4\x90\x80\x80")}) {
    const auto result = translator().translate(bad);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kMalformed);
    EXPECT_EQ(result.error().place, "byte 2");
  }
}

TEST(Input, NothingToSignIsAUsageError) {
  for (const char* empty : {"", " \t\n", "?!.,", "\u2026\u201C\u201D", "\u200B\uFEFF", "'", "-"}) {
    const auto result = translator().translate(empty);
    ASSERT_FALSE(result) << empty;
    EXPECT_EQ(result.error().code, ErrorCode::kUsage);
    EXPECT_NE(result.error().message.find("nothing to sign"), std::string::npos);
  }
}

TEST(Input, OtherScriptsAreReportedAndKeptAsDropped) {
  for (const std::string& foreign : {std::string("\U0001F44D\U0001F3FD"), std::string("\u0645\u0631\u062D\u0628\u0627"),
                                     std::string("\u4F60\u597D"), std::string("\u043C\u0438\u0440")}) {
    const auto result = translator().translate("hello " + foreign + " doctor");
    ASSERT_TRUE(result);
    EXPECT_EQ(test::signed_line(*result), "HELLO DOCTOR");
    ASSERT_EQ(result->items.size(), 3u);
    EXPECT_EQ(result->items[1].kind, ItemKind::kDropped);
    EXPECT_EQ(result->items[1].text, foreign);
    EXPECT_NE(result->warnings.front().find(foreign), std::string::npos);
    EXPECT_EQ(translator().translate(foreign).error().code, ErrorCode::kUsage);
  }
}

TEST(Input, ALetterThatCannotBeSpelledIsNamed) {
  const auto result = translator().translate("ab\u0436c");
  ASSERT_TRUE(result);
  EXPECT_EQ(test::signed_line(*result), "A-B-C");
  EXPECT_NE(result->warnings.front().find("\u0436"), std::string::npos);
}

TEST(Input, DecomposedAndComposedLettersAreTheSame) {
  EXPECT_EQ(test::signed_line(*translator().translate("Zoe\u0308")),
            test::signed_line(*translator().translate("Zo\u00EB")));
}

TEST(Input, BeyondTheBoundIsALimitError) {
  EXPECT_EQ(translator().translate(std::string(Translator::kMaxBytes + 1, 'a')).error().code, ErrorCode::kLimit);
  EXPECT_TRUE(translator().translate(std::string(Translator::kMaxBytes, 'a')));
}

// Each would take hours if any step were quadratic.
TEST(Input, LongTextsWork) {
  for (const char* piece : {"I do not know where it hurts ", "Does it hurt? ", "my name is not ", "one hundred ",
                            "and ", "'s a-", "not have to ", "1,000/", "a.", "today "}) {
    std::string text;
    while (text.size() < 300000)
      text += piece;
    const auto result = translator().translate(text);
    ASSERT_TRUE(result) << piece;
    EXPECT_LT(result->warnings.size(), 200u);
  }
}

TEST(Input, ALongWordIsSpelledWhole) {
  const auto result = translator().translate("pneumonoultramicroscopic");
  ASSERT_TRUE(result);
  EXPECT_EQ(result->items[0].glosses.size(), 24u);
  EXPECT_NE(result->warnings.front().find("24 letters"), std::string::npos);
}

TEST(Input, ALexiconWithoutAllLettersIsRefused) {
  TranslatorData data = test::vocabulary();
  std::erase_if(data.entries, [](const EntryFacts& entry) { return entry.gloss == "fs:Q"; });
  const auto result = Translator::build(std::move(data));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kNotFound);
  EXPECT_NE(result.error().message.find("fs:Q"), std::string::npos);
}

}  // namespace
}  // namespace auslan
