// SPDX-License-Identifier: Apache-2.0
// The shadow of the arms, on the shipped figure: where it falls, and that it costs nothing when nothing moves.
#include "kinematics/anatomy.h"
#include "kinematics/arm_ik.h"
#include "kinematics/figure_file.h"
#include "stage/stage.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace auslan {
namespace {

constexpr int kSide = 320;

class StageShadow : public ::testing::Test {
 protected:
  StageShadow() {
    options_.width = options_.height = kSide;
    options_.samples = 1;
  }

  // The right hand so far before the middle of the chest, palm to it.
  Pose hand_before_chest(double metres) const {
    const Skeleton& skeleton = figure_.skeleton;
    const ArmNodes arm = arm_nodes(skeleton, Side::kRight);
    Transform trunk;
    trunk.position = skeleton.rest_position(skeleton.find("spine_base"));
    Transform wrist;
    wrist.position = trunk.position + Vec3(-0.10, 0.36, 0.13 + metres);
    wrist.rotation = orient_hand(rest_hand_frame(skeleton, Side::kRight), Vec3(1, 0.2, 0), Vec3(0, 0, -1));
    const ArmSolution solved =
        solve_arm(skeleton, Side::kRight, trunk, wrist, natural_swivel(skeleton, Side::kRight, trunk, wrist));
    EXPECT_TRUE(solved.reachable);
    Pose pose = rest_pose(skeleton);
    pose_arm(arm, solved, pose);
    return pose;
  }
  std::vector<uint32_t> picture(const Pose& pose, bool shadow) {
    options_.shadow = shadow;
    Stage stage = Stage::build(figure_, options_).value();
    std::vector<uint32_t> pixels(size_t{kSide} * kSide);
    stage.render(pose, pixels);
    return pixels;
  }

  struct Fall {
    int64_t pixels = 0;
    double column = 0.0, row = 0.0;  ///< of its middle
  };
  // The pixels that the shadow makes darker; none may be brighter.
  Fall fall(double metres) {
    const Pose pose = hand_before_chest(metres);
    const auto lit = picture(pose, false);
    const auto shaded = picture(pose, true);
    Fall fall;
    for (size_t i = 0; i < lit.size(); ++i) {
      int lost = 0;
      for (const int shift : {0, 8, 16}) {
        const auto before = static_cast<int>(lit[i] >> shift & 255U);
        const auto after = static_cast<int>(shaded[i] >> shift & 255U);
        EXPECT_LE(after, before);
        lost += before - after;
      }
      if (lost < 8) continue;
      ++fall.pixels;
      fall.column += static_cast<double>(i % kSide);
      fall.row += static_cast<double>(i / kSide);
    }
    fall.column /= static_cast<double>(std::max<int64_t>(fall.pixels, 1));
    fall.row /= static_cast<double>(std::max<int64_t>(fall.pixels, 1));
    return fall;
  }

  Figure figure_ = read_figure(std::string(AUSLANJAM_BINARY_DIR) + "/share/auslanjam/signer.figure").value();
  StageOptions options_;
};

TEST_F(StageShadow, FallsAwayFromTheKeyLight) {
  // The light comes from above and from the viewer's right: a hand farther from the chest throws its shadow lower and
  // farther to the viewer's left.
  const Fall near = fall(0.08);
  const Fall far = fall(0.20);
  EXPECT_GT(near.pixels, 50);
  EXPECT_GT(far.pixels, 50);
  EXPECT_GT(far.row, near.row + 5.0);
  EXPECT_LT(far.column, near.column - 2.0);
}

TEST_F(StageShadow, ArmsHeldAsideThrowNone) {
  // The T-pose: what the arms throw falls beside and below the body.
  const Pose rest = rest_pose(figure_.skeleton);
  EXPECT_EQ(picture(rest, true), picture(rest, false));
}

TEST_F(StageShadow, NothingIsDrawnAgainWhenNothingMoved) {
  Stage stage = Stage::build(figure_, options_).value();
  std::vector<uint32_t> pixels(size_t{kSide} * kSide);
  const Pose pose = hand_before_chest(0.12);
  stage.render(pose, pixels);
  stage.render(pose, pixels, raster::Canvas::kLastFrame);
  EXPECT_TRUE(stage.damage().empty());
  stage.render(hand_before_chest(0.13), pixels, raster::Canvas::kLastFrame);
  EXPECT_FALSE(stage.damage().empty());
  // What was drawn a part at a time is what is drawn at once.
  std::vector<uint32_t> whole(pixels.size());
  stage.render(hand_before_chest(0.13), whole);
  EXPECT_EQ(pixels, whole);
}

}  // namespace
}  // namespace auslan
