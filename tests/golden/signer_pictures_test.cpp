// SPDX-License-Identifier: Apache-2.0
// The signer as a viewer sees it. Each golden picture was looked at and compared with the written facts: a fist stands
// on a fist in G, the index lies against the other thumb in A, raised and furrowed brows are told apart.
#include "golden.h"
#include "media/caption.h"
#include "media/picture.h"
#include "shipped.h"
#include "stage/stage.h"

#include <gtest/gtest.h>

namespace auslan {
namespace {

constexpr int kSize = 200;

PerformanceOptions still() {
  PerformanceOptions options;
  options.idle = false;
  return options;
}

Picture picture_of(const Pose& pose, CameraName camera, bool flat = false) {
  StageOptions options;
  options.width = options.height = kSize;
  options.camera = camera;
  options.flat = flat;
  Picture picture = make_picture(kSize, kSize);
  Stage stage = Stage::build(shipped().figure, options).value();
  stage.render(pose, picture.span().pixels);
  return picture;
}

/// The pose at the middle of a sign's last hold.
Pose held(const std::string& gloss) {
  const Score score = score_of({gloss});
  Pose pose;
  Performance(*shipped().signer, score, still()).sample(score.glosses.front().end - ticks(0.05), pose);
  return pose;
}

Pose at_rest() {
  Pose pose;
  Performance(*shipped().signer, score_of({"HELLO"}), still()).sample(0, pose);
  return pose;
}

TEST(SignerPictures, AtRest) {
  EXPECT_GOLDEN(picture_of(at_rest(), CameraName::kFront).view(), "signer_rest_front");
  EXPECT_GOLDEN(picture_of(at_rest(), CameraName::kThreeQuarter).view(), "signer_rest_three_quarter");
}

TEST(SignerPictures, FlatShadingShowsFacets) {
  EXPECT_GOLDEN(picture_of(at_rest(), CameraName::kFace, true).view(), "signer_face_flat");
}

TEST(SignerPictures, BrowsAskAQuestion) {
  Pose pose = at_rest();
  EXPECT_GOLDEN(picture_of(pose, CameraName::kFace).view(), "signer_face_neutral");
  for (const FaceChannel channel :
       {FaceChannel::kBrowInnerUp, FaceChannel::kBrowOuterUpLeft, FaceChannel::kBrowOuterUpRight})
    pose.face[static_cast<size_t>(channel)] = 1.0F;
  EXPECT_GOLDEN(picture_of(pose, CameraName::kFace).view(), "signer_face_raised");
  pose.face = {};
  for (const FaceChannel channel : {FaceChannel::kBrowDownLeft, FaceChannel::kBrowDownRight})
    pose.face[static_cast<size_t>(channel)] = 1.0F;
  EXPECT_GOLDEN(picture_of(pose, CameraName::kFace).view(), "signer_face_furrowed");
}

TEST(SignerPictures, LettersOfTheTwoHandedAlphabet) {
  for (const char* letter : {"a", "c", "g", "k", "w"}) {
    const std::string gloss = std::string("fs:") + static_cast<char>(*letter - 'a' + 'A');
    EXPECT_GOLDEN(picture_of(held(gloss), CameraName::kHands).view(), std::string("letter_") + letter);
  }
}

TEST(SignerPictures, SignsOfTheHospital) {
  EXPECT_GOLDEN(picture_of(held("HURT"), CameraName::kFront).view(), "sign_hurt");
  EXPECT_GOLDEN(picture_of(held("WHERE"), CameraName::kFront).view(), "sign_where");
  EXPECT_GOLDEN(picture_of(held("HOSPITAL"), CameraName::kFront).view(), "sign_hospital");
}

TEST(SignerPictures, ACaptionUnderTheSigner) {
  Picture picture = picture_of(at_rest(), CameraName::kFront);
  CaptionStyle style;
  style.size_px = 14;
  style.margin_px = 6;
  CaptionPainter::open().value().paint(picture.span(), "Where does it hurt?", style);
  EXPECT_GOLDEN(picture.view(), "signer_captioned");
}

/// A change of one joint by a degree is seen: the pictures do not pass by being coarse.
TEST(SignerPictures, AJointThatTurnsByOneDegreeChangesThePicture) {
  Pose pose = held("HURT");
  const Picture before = picture_of(pose, CameraName::kFront);
  const int elbow = shipped().figure.skeleton.find("elbow_r");
  pose.rotation[static_cast<size_t>(elbow)] =
      pose.rotation[static_cast<size_t>(elbow)] * glm::normalize(Quat(1.0, 0.0, 0.0087, 0.0));
  EXPECT_FALSE(compare(before.view(), picture_of(pose, CameraName::kFront).view()).equal());
}

}  // namespace
}  // namespace auslan
