// SPDX-License-Identifier: Apache-2.0
// Facts of English pronunciation that can be seen on the lips.
#include "synthesis/mouthing.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace auslan {
namespace {

bool shows(std::string_view word, Viseme viseme) {
  const auto visemes = visemes_of(word);
  return std::find(visemes.begin(), visemes.end(), viseme) != visemes.end();
}

TEST(Mouthing, LipsCloseForPBAndM) {
  for (const char* word : {"mum", "pop", "bib"}) {
    const auto visemes = visemes_of(word);
    ASSERT_GE(visemes.size(), 3U) << word;
    EXPECT_EQ(visemes.front(), Viseme::kClosed) << word;
    EXPECT_EQ(visemes.back(), Viseme::kClosed) << word;
  }
  EXPECT_FALSE(shows("hurt", Viseme::kClosed));
}

TEST(Mouthing, LowerLipMeetsTeethForFAndVAndPh) {
  for (const char* word : {"fish", "van", "phone"})
    EXPECT_EQ(visemes_of(word).front(), Viseme::kLipTeeth) << word;
}

TEST(Mouthing, TongueShowsForTh) {
  EXPECT_EQ(visemes_of("think").front(), Viseme::kTongue);
  EXPECT_EQ(visemes_of("mouth").back(), Viseme::kTongue);
  EXPECT_FALSE(shows("time", Viseme::kTongue));
}

TEST(Mouthing, LipsRoundForShChJ) {
  for (const char* word : {"shop", "chair", "jam"})
    EXPECT_EQ(visemes_of(word).front(), Viseme::kRounded) << word;
}

TEST(Mouthing, FinalEIsSilent) {
  EXPECT_EQ(visemes_of("name").back(), Viseme::kClosed);
  EXPECT_EQ(visemes_of("wave").back(), Viseme::kLipTeeth);
}

TEST(Mouthing, EveryEnglishWordWithALetterShowsSomething) {
  EXPECT_TRUE(visemes_of("").empty());
  EXPECT_TRUE(visemes_of("42 !").empty());
  for (const char* word : {"a", "I", "hurt", "where", "hello", "Kim", "hospital", "xyz"})
    EXPECT_FALSE(visemes_of(word).empty()) << word;
}

TEST(Mouthing, CaseDoesNotMatter) {
  EXPECT_EQ(visemes_of("HELLO"), visemes_of("hello"));
}

TEST(Mouthing, OpenVowelsOpenTheJawMoreThanCloseOnes) {
  const auto jaw = [](Viseme v) { return weights_of(v)[static_cast<size_t>(FaceChannel::kJawOpen)]; };
  EXPECT_GT(jaw(Viseme::kA), jaw(Viseme::kE));
  EXPECT_GT(jaw(Viseme::kE), jaw(Viseme::kI));
  EXPECT_EQ(jaw(Viseme::kClosed), 0.0F);
}

}  // namespace
}  // namespace auslan
