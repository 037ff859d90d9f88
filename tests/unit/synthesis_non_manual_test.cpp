// SPDX-License-Identifier: Apache-2.0
// Every word that the lexicon may use for the face and the body means something to the synthesis.
#include "lexicon/face_words.h"
#include "synthesis/non_manual.h"

#include <gtest/gtest.h>

namespace auslan {
namespace {

float total(const FaceWeights& weights) {
  float sum = 0;
  for (const float w : weights)
    sum += w;
  return sum;
}

bool add(FaceTier tier, std::string_view word, FaceWeights& face, BodyFeature& body) {
  switch (tier) {
    case FaceTier::kBrows:
      return add_brows(word, face);
    case FaceTier::kEyes:
      return add_eyes(word, face);
    case FaceTier::kMouth:
      return add_mouth(word, face);
    case FaceTier::kCheeks:
      return add_cheeks(word, face);
    case FaceTier::kHead:
      return add_head(word, body);
    case FaceTier::kShoulders:
      return add_shoulders(word, body);
    case FaceTier::kGaze:
      return add_gaze(word, body, face);
    case FaceTier::kFace:
      return add_face(word, face);
  }
  return false;
}

TEST(NonManual, EveryWordOfTheLexiconIsKnownAndShows) {
  for (int i = 0; i < kFaceTiers; ++i) {
    const auto tier = static_cast<FaceTier>(i);
    for (const std::string_view word : face_words(tier)) {
      FaceWeights face{};
      BodyFeature body;
      EXPECT_TRUE(add(tier, word, face, body)) << tier_name(tier) << " " << word;
      const bool neutral = word.empty() || word == "neutral" || word == "addressee";
      const bool shows =
          total(face) > 0 || body.head != Vec3(0.0) || body.trunk != Vec3(0.0) || body.swing != Vec3(0.0);
      EXPECT_EQ(shows, !neutral) << tier_name(tier) << " " << word;
    }
  }
}

TEST(NonManual, UnknownWordsAreRefused) {
  FaceWeights face{};
  BodyFeature body;
  for (int i = 0; i < kFaceTiers; ++i)
    EXPECT_FALSE(add(static_cast<FaceTier>(i), "wobble", face, body));
  EXPECT_EQ(total(face), 0.0F);
}

TEST(NonManual, WeightsNeverExceedOne) {
  FaceWeights face{};
  for (int i = 0; i < 5; ++i)
    add_brows("raise", face);
  for (const float w : face)
    EXPECT_LE(w, 1.0F);
}

TEST(NonManual, RaisedAndFurrowedBrowsUseDifferentChannels) {
  FaceWeights raised{}, furrowed{};
  add_brows("raise", raised);
  add_brows("furrow", furrowed);
  EXPECT_GT(raised[static_cast<size_t>(FaceChannel::kBrowOuterUpLeft)], 0.5F);
  EXPECT_EQ(raised[static_cast<size_t>(FaceChannel::kBrowDownLeft)], 0.0F);
  EXPECT_GT(furrowed[static_cast<size_t>(FaceChannel::kBrowDownLeft)], 0.5F);
  EXPECT_EQ(furrowed[static_cast<size_t>(FaceChannel::kBrowInnerUp)], 0.0F);
}

TEST(NonManual, HeadshakeTurnsAboutTheVerticalAndNodAboutTheSideways) {
  BodyFeature shake, nod;
  add_head("shake", shake);
  add_head("nod", nod);
  EXPECT_GT(shake.swing.y, 0.0);
  EXPECT_EQ(shake.swing.x, 0.0);
  EXPECT_GT(nod.swing.x, 0.0);
  EXPECT_EQ(nod.swing.y, 0.0);
}

}  // namespace
}  // namespace auslan
