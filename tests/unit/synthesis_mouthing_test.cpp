// SPDX-License-Identifier: Apache-2.0
// Facts of English pronunciation that can be seen on the lips.
#include "synthesis/mouthing.h"

#include <algorithm>
#include <cmath>
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
    EXPECT_EQ(visemes.front(), Viseme::kPp) << word;
    EXPECT_EQ(visemes.back(), Viseme::kPp) << word;
  }
  EXPECT_FALSE(shows("hurt", Viseme::kPp));
}

TEST(Mouthing, LowerLipMeetsTeethForFAndVAndPh) {
  for (const char* word : {"fish", "van", "phone"})
    EXPECT_EQ(visemes_of(word).front(), Viseme::kFf) << word;
}

TEST(Mouthing, TongueShowsForTh) {
  EXPECT_EQ(visemes_of("think").front(), Viseme::kTh);
  EXPECT_EQ(visemes_of("mouth").back(), Viseme::kTh);
  EXPECT_FALSE(shows("time", Viseme::kTh));
}

TEST(Mouthing, LipsRoundForShChJ) {
  for (const char* word : {"shop", "chair", "jam"})
    EXPECT_EQ(visemes_of(word).front(), Viseme::kCh) << word;
}

TEST(Mouthing, TeethMeetForSAndTheTongueRisesForNAndL) {
  EXPECT_EQ(visemes_of("sit").front(), Viseme::kSs);
  EXPECT_EQ(visemes_of("zoo").front(), Viseme::kSs);
  EXPECT_EQ(visemes_of("six").back(), Viseme::kSs);
  for (const char* word : {"name", "leg", "knee"})
    EXPECT_EQ(visemes_of(word).front(), Viseme::kNn) << word;
}

TEST(Mouthing, NoTwoVisemesLookAlike) {
  for (int a = 0; a < kVisemeCount; ++a) {
    for (int b = 0; b < a; ++b) {
      const FaceWeights first = weights_of(static_cast<Viseme>(a));
      const FaceWeights second = weights_of(static_cast<Viseme>(b));
      float largest = 0.0F;
      for (size_t i = 0; i < first.size(); ++i)
        largest = std::max(largest, std::abs(first[i] - second[i]));
      // A tenth of a channel is what a viewer can be expected to see.
      EXPECT_GE(largest, 0.1F) << kVisemeNames[static_cast<size_t>(a)] << ' ' << kVisemeNames[static_cast<size_t>(b)];
    }
  }
}

TEST(Mouthing, FinalEIsSilent) {
  EXPECT_EQ(visemes_of("name").back(), Viseme::kPp);
  EXPECT_EQ(visemes_of("wave").back(), Viseme::kFf);
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
  EXPECT_GT(jaw(Viseme::kAa), jaw(Viseme::kE));
  EXPECT_GT(jaw(Viseme::kE), jaw(Viseme::kIh));
  EXPECT_EQ(jaw(Viseme::kPp), 0.0F);
}

}  // namespace
}  // namespace auslan
