// SPDX-License-Identifier: Apache-2.0
// Every word that the lexicon may use for the face and the body means something to the synthesis.
#include "lexicon/face_words.h"
#include "synthesis/non_manual.h"

#include <gtest/gtest.h>
#include <map>
#include <string>
#include <utility>
#include <vector>

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
      // The head goes with the eyes in any case, and stands straight where nothing turns it.
      const bool neutral =
          word.empty() || word == "neutral" || word == "addressee" || word == "follow-gaze" || word == "straight";
      const bool shows =
          total(face) > 0 || body.head != Vec3(0.0) || body.trunk != Vec3(0.0) || body.swing != Vec3(0.0);
      EXPECT_EQ(shows, !neutral) << tier_name(tier) << " " << word;
    }
  }
}

// SiGML's mouth gestures: 9 of the teeth, 4 of the jaw, 35 of the lips, 13 of the cheeks, 17 of the tongue.
std::vector<std::string> mouth_gesture_codes() {
  std::vector<std::string> codes;
  for (const auto& [letter, count] :
       {std::pair('D', 9), std::pair('J', 4), std::pair('L', 35), std::pair('C', 13), std::pair('T', 17)}) {
    for (int i = 1; i <= count; ++i)
      codes.push_back(letter + std::string(i < 10 ? "0" : "") + std::to_string(i));
  }
  return codes;
}

TEST(NonManual, EachOfThe78MouthGesturesIsAFaceOfItsOwn) {
  std::map<FaceWeights, std::string> faces;
  for (const std::string& code : mouth_gesture_codes()) {
    FaceWeights face{};
    ASSERT_TRUE(add_mouth(code, face)) << code;
    for (const float weight : face) {
      EXPECT_GE(weight, 0.0F) << code;
      EXPECT_LE(weight, 1.0F) << code;
    }
    EXPECT_GT(total(face), 0.0F) << code;
    const auto [entry, is_new] = faces.emplace(face, code);
    EXPECT_TRUE(is_new) << code << " looks like " << entry->second;
  }
  EXPECT_EQ(faces.size(), 78U);
  FaceWeights face{};
  for (const char* wrong : {"D00", "D10", "J05", "L36", "C14", "T18", "L1", "l01", "X01"})
    EXPECT_FALSE(add_mouth_gesture(wrong, face)) << wrong;
}

TEST(NonManual, GesturesOfTheTongueShowIt) {
  const auto of = [](std::string_view code, FaceChannel channel) {
    FaceWeights face{};
    EXPECT_TRUE(add_mouth_gesture(code, face));
    return face[static_cast<size_t>(channel)];
  };
  for (const char* out : {"T02", "T04", "T05", "T06", "T12", "T14", "T16", "L27", "L28"})
    EXPECT_GT(of(out, FaceChannel::kTongueOut), 0.0F) << out;
  // One side only: a cheek, half a lip, the corner of the mouth.
  EXPECT_GT(of("C04", FaceChannel::kCheekPuffLeft), 0.0F);
  EXPECT_EQ(of("C04", FaceChannel::kCheekPuffRight), 0.0F);
  EXPECT_EQ(of("L26", FaceChannel::kMouthUpperUpRight), 0.0F);
  EXPECT_EQ(of("T14", FaceChannel::kTongueRight), 0.0F);
}

TEST(NonManual, GazeTurnsBothEyesTheSameWay) {
  const auto of = [](std::string_view word, FaceChannel channel) {
    FaceWeights face{};
    BodyFeature body;
    EXPECT_TRUE(add_gaze(word, body, face));
    return face[static_cast<size_t>(channel)];
  };
  using enum FaceChannel;
  EXPECT_GT(of("left", kEyeLookOutLeft), 0.0F);
  EXPECT_EQ(of("left", kEyeLookOutLeft), of("left", kEyeLookInRight));
  EXPECT_GT(of("right", kEyeLookInLeft), 0.0F);
  EXPECT_EQ(of("right", kEyeLookInLeft), of("right", kEyeLookOutRight));
  EXPECT_GT(of("up", kEyeLookUpLeft), 0.0F);
  EXPECT_GT(of("down-to-hand", kEyeLookDownRight), 0.0F);
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
