// SPDX-License-Identifier: Apache-2.0
// The clavicle at the edge of an arm's reach.
#include "kinematics/arm_ik.h"
#include "kinematics/arm_reach.h"
#include "kinematics/elementary.h"
#include "kinematics/limits.h"
#include "kinematics/rotation.h"
#include "measured_skeleton.h"
#include "random_places.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace auslan {
namespace {

const double kStraight = 0.287 + 0.2545;  // metres, of the arm

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

class Clavicle : public testing::Test {
 protected:
  Vec3 shoulder(Side side) const { return skeleton_.rest_position(arm_nodes(skeleton_, side).shoulder); }
  Transform trunk(Side side) const { return {kIdentity, skeleton_.rest_position(arm_nodes(skeleton_, side).trunk)}; }
  ArmSolution solved(Side side, const Transform& wrist) const {
    return solve_arm(skeleton_, side, trunk(side), wrist, 0.3);
  }
  std::vector<Transform> placed(Side side, const ArmSolution& arm) const {
    Pose pose = rest_pose(skeleton_);
    pose_arm(arm_nodes(skeleton_, side), arm, pose);
    std::vector<Transform> world(static_cast<size_t>(skeleton_.size()));
    forward(skeleton_, pose, world);
    return world;
  }
  /// The hand at so many arm lengths from the shoulder at rest.
  Transform at(Side side, const Vec3& direction, double lengths) const {
    return {kIdentity, shoulder(side) + unit(direction) * (lengths * kStraight)};
  }

  const Skeleton skeleton_ = test::measured_skeleton(true);
  const Skeleton without_ = test::measured_skeleton();
};

TEST_F(Clavicle, IsFoundWithTheTrunkThatCarriesIt) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const ArmNodes nodes = arm_nodes(skeleton_, side);
    EXPECT_EQ(skeleton_.node(nodes.clavicle).name, side == Side::kLeft ? "clavicle_l" : "clavicle_r");
    EXPECT_EQ(skeleton_.node(nodes.trunk).name, "neck_base");
    EXPECT_EQ(arm_nodes(without_, side).clavicle, kNoNode);
    EXPECT_EQ(without_.node(arm_nodes(without_, side).trunk).name, "neck_base");
  }
}

TEST_F(Clavicle, TheWristMeetsItsTargetAlsoWhereItHelps) {
  test::Random random;
  for (int i = 0; i < 5000; ++i) {
    const Side side = i % 2 == 0 ? Side::kLeft : Side::kRight;
    Transform wrist = at(side, random.vector(), random.between(0.5, 1.0));
    wrist.rotation = random.rotation();
    const ArmSolution arm = solved(side, wrist);
    if (!arm.reachable) continue;
    const Transform reached = placed(side, arm)[static_cast<size_t>(arm_nodes(skeleton_, side).wrist)];
    ASSERT_LT(length(reached.position - wrist.position), 1e-9);
    ASSERT_LT(angle_between(reached.rotation, wrist.rotation), 1e-9);
  }
}

TEST_F(Clavicle, HelpsFarOutAndUpButNotNearNorForAHangingArm) {
  const Vec3 forwards(0, 0, 1), up(0, 1, 0.1), down(-0.1, -1, 0.1);
  for (const Vec3& near : {forwards, up, down})
    EXPECT_EQ(solved(Side::kRight, at(Side::kRight, near, 0.89)).clavicle, kIdentity);
  EXPECT_EQ(solved(Side::kRight, at(Side::kRight, down, 0.99)).clavicle, kIdentity);
  // What is out of reach without it by 2 cm is in reach with it.
  const double beyond = 1.0 + 0.02 / kStraight;
  for (const Vec3& far : {forwards, up}) {
    const Transform wrist = at(Side::kRight, far, beyond);
    const Transform base{kIdentity, without_.rest_position(arm_nodes(without_, Side::kRight).trunk)};
    EXPECT_NEAR(solve_arm(without_, Side::kRight, base, wrist, 0.3).shortfall, 0.02, 1e-9);
    EXPECT_TRUE(solved(Side::kRight, wrist).reachable);
  }
  // Forwards it goes forwards, upwards upwards.
  const auto moved = [&](const Vec3& direction) {
    const auto world = placed(Side::kRight, solved(Side::kRight, at(Side::kRight, direction, 1.0)));
    return world[static_cast<size_t>(arm_nodes(skeleton_, Side::kRight).shoulder)].position - shoulder(Side::kRight);
  };
  EXPECT_GT(moved(forwards).z, 0.015);
  EXPECT_GT(moved(up).y, 0.015);
}

TEST_F(Clavicle, KeepsItsLimitsAndTheArmStraightensAsTheHandGoesOut) {
  test::Random random;
  for (int i = 0; i < 400; ++i) {
    const Vec3 direction = random.vector();
    double before = 0.0;
    Quat turn = kIdentity;
    for (double lengths = 0.85; lengths < 1.2; lengths += 0.002) {
      const ArmSolution arm = solved(Side::kLeft, at(Side::kLeft, direction, lengths));
      const ArmNodes nodes = arm_nodes(skeleton_, Side::kLeft);
      ASSERT_LT(limit_violation(skeleton_, nodes.clavicle, arm.clavicle), 1e-9);
      // A millimetre of the hand turns it by less than a degree.
      ASSERT_LT(angle_between(turn, arm.clavicle), 1.0 * kDegree);
      turn = arm.clavicle;
      const auto world = placed(Side::kLeft, arm);
      const double stretched = length(world[static_cast<size_t>(nodes.wrist)].position -
                                      world[static_cast<size_t>(nodes.shoulder)].position);
      ASSERT_GE(stretched, before - 1e-9) << lengths;
      before = stretched;
    }
  }
}

TEST_F(Clavicle, TheRightOneMirrorsTheLeft) {
  test::Random random;
  for (int i = 0; i < 500; ++i) {
    const Transform left = at(Side::kLeft, random.vector(), random.between(0.9, 1.1));
    const Transform right{kIdentity, Vec3(-left.position.x, left.position.y, left.position.z)};
    const ArmSolution a = solved(Side::kLeft, left), b = solved(Side::kRight, right);
    EXPECT_EQ(b.clavicle, Quat(a.clavicle.w, a.clavicle.x, -a.clavicle.y, -a.clavicle.z));
    EXPECT_EQ(b.shoulder, Quat(a.shoulder.w, a.shoulder.x, -a.shoulder.y, -a.shoulder.z));
  }
}

TEST_F(Clavicle, ProtractionAndElevationArePositiveOnBothSides) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const ArmNodes nodes = arm_nodes(skeleton_, side);
    const Quat forwards = solved(side, at(side, Vec3(0, 0, 1), 1.05)).clavicle;
    const Quat up = solved(side, at(side, Vec3(0, 1, 0), 1.05)).clavicle;
    EXPECT_GT(joint_angles(skeleton_, nodes.clavicle, forwards).flexion, 10.0 * kDegree);
    EXPECT_GT(joint_angles(skeleton_, nodes.clavicle, up).abduction, 10.0 * kDegree);
  }
}

}  // namespace
}  // namespace auslan
