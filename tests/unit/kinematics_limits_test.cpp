// SPDX-License-Identifier: Apache-2.0
#include "kinematics/anatomy.h"
#include "kinematics/elementary.h"
#include "kinematics/limits.h"
#include "kinematics/rotation.h"
#include "measured_skeleton.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

namespace auslan {
namespace {

const Skeleton& figure() {
  static const Skeleton skeleton = test::measured_skeleton();
  return skeleton;
}

double violation_degrees(const std::string& node, const Quat& q) {
  return limit_violation(figure(), figure().find(node), q) / kDegree;
}
Quat turn(double x, double y, double z, double degrees) {
  return axis_angle(Vec3(x, y, z), degrees * kDegree);
}

TEST(Limits, EveryNodeOfTheFigureHasARangeThatHoldsItsRest) {
  for (int node = 0; node < figure().size(); ++node) {
    ASSERT_TRUE(joint_limits(figure(), node).has_value()) << figure().node(node).name;
    if (figure().node(node).name.substr(0, 9) == "thumb_cmc") continue;
    EXPECT_LT(limit_violation(figure(), node, kIdentity), 1e-12) << figure().node(node).name;
  }
}

TEST(Limits, UnknownNodesHaveNone) {
  std::vector<Node> nodes(figure().nodes().begin(), figure().nodes().end());
  nodes.push_back({"jaw", 2, Vec3(0.0)});
  const Skeleton longer = Skeleton::build(nodes).value();
  EXPECT_FALSE(joint_limits(longer, 39).has_value());
  EXPECT_EQ(limit_violation(longer, 39, turn(1, 0, 0, 170)), 0.0);
  EXPECT_EQ(clamped(longer, 39, turn(1, 0, 0, 170)), turn(1, 0, 0, 170));
}

// AAOS: elbow 0 to 150. The left forearm bends forwards about -Y, the right about +Y.
TEST(Limits, ElbowsBendForwardsTo150AndNotBack) {
  for (const double sign : {1.0, -1.0}) {
    const std::string elbow = sign > 0.0 ? "elbow_l" : "elbow_r";
    EXPECT_LT(violation_degrees(elbow, turn(0, -sign, 0, 145)), 1e-9);
    EXPECT_NEAR(violation_degrees(elbow, turn(0, -sign, 0, 160)), 10.0, 1e-6);
    EXPECT_NEAR(violation_degrees(elbow, turn(0, -sign, 0, -20)), 20.0, 1e-6);
  }
}

// AAOS: 80 each way from thumbs forward with the palm down. Pronation turns the palm backwards.
TEST(Limits, ForearmsTurnBy80EachWay) {
  EXPECT_LT(violation_degrees("elbow_l", turn(1, 0, 0, 79)), 1e-9);
  EXPECT_NEAR(violation_degrees("elbow_l", turn(1, 0, 0, 95)), 15.0, 1e-6);
  EXPECT_NEAR(violation_degrees("elbow_r", turn(1, 0, 0, -95)), 15.0, 1e-6);
  EXPECT_GT(joint_angles(figure(), figure().find("elbow_l"), turn(1, 0, 0, 30)).twist, 0.0);
  EXPECT_GT(joint_angles(figure(), figure().find("elbow_r"), turn(1, 0, 0, 30)).twist, 0.0);
}

// AAOS: wrist flexion 80, extension 70, radial 20, ulnar 30. The left hand flexes (palm side, down) about -Z.
TEST(Limits, WristsFlexExtendAndDeviate) {
  const HandFrame left = rest_hand_frame(figure(), Side::kLeft);
  const Vec3 flexion = glm::cross(left.fingers, left.palm);
  const Vec3 radial = glm::cross(left.fingers, left.radial);
  const auto beyond = [&](const Vec3& axis, double degrees) {
    return violation_degrees("wrist_l", axis_angle(axis, degrees * kDegree));
  };
  EXPECT_LT(beyond(flexion, 79), 1e-9);
  EXPECT_NEAR(beyond(flexion, 90), 10.0, 1e-6);
  EXPECT_LT(beyond(flexion, -69), 1e-9);
  EXPECT_NEAR(beyond(flexion, -80), 10.0, 1e-6);
  EXPECT_NEAR(beyond(radial, 25), 5.0, 1e-6);
  EXPECT_LT(beyond(radial, -29), 1e-9);
  EXPECT_NEAR(beyond(radial, -40), 10.0, 1e-6);
}

// Shoulders: hanging is zero, and the T-pose is 90 degrees of abduction.
TEST(Limits, ShouldersRaiseForwardsTo180AndBackTo60) {
  const int shoulder = figure().find("shoulder_l");
  EXPECT_NEAR(joint_angles(figure(), shoulder, kIdentity).abduction / kDegree, 90.0, 1e-9);
  const Quat hanging = turn(0, 0, 1, -90);
  EXPECT_NEAR(joint_angles(figure(), shoulder, hanging).abduction, 0.0, 1e-12);
  // About -X the hanging arm rises forwards.
  EXPECT_NEAR(joint_angles(figure(), shoulder, turn(-1, 0, 0, 70) * hanging).flexion / kDegree, 70.0, 1e-9);
  EXPECT_NEAR(violation_degrees("shoulder_l", turn(-1, 0, 0, -75) * hanging), 15.0, 1e-6);
  // Medial rotation 95 with the arm beside the body, lateral 90: the hanging left arm turns inwards about -Y.
  EXPECT_NEAR(violation_degrees("shoulder_l", turn(0, -1, 0, 105) * hanging), 10.0, 1e-6);
  EXPECT_LT(violation_degrees("shoulder_l", turn(0, -1, 0, -89) * hanging), 1e-9);
  EXPECT_NEAR(violation_degrees("shoulder_r", turn(0, 1, 0, 105) * turn(0, 0, 1, 90)), 10.0, 1e-6);
}

TEST(Limits, PosedHandsWithinTheNormsBreakNothing) {
  const Skeleton& skeleton = figure();
  std::mt19937 random(3);
  const auto upto = [&](double high) { return high * kDegree * (static_cast<double>(random()) / 4294967296.0); };
  for (int i = 0; i < 200; ++i) {
    HandAngles angles;
    for (DigitAngles& digit : angles.fingers) {
      digit.mcp = upto(88);
      digit.pip = upto(105);
      digit.dip = upto(85);
      digit.abduction = upto(15);
    }
    angles.thumb.radial_abduction = upto(65);
    angles.thumb.palmar_abduction = upto(60);
    angles.thumb.opposition = upto(1.0) / kDegree;
    angles.thumb.mp = upto(48);
    angles.thumb.ip = upto(75);
    Pose pose = rest_pose(skeleton);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      pose_hand(skeleton, side, angles, pose);
      for (const auto& digit : arm_nodes(skeleton, side).digits)
        for (const int node : digit)
          ASSERT_LT(limit_violation(skeleton, node, pose.rotation[static_cast<size_t>(node)]), 1e-9)
              << skeleton.node(node).name;
    }
  }
}

TEST(Limits, AFingerBentTooFarOrBackwardsBreaksThem) {
  const Skeleton& skeleton = figure();
  Pose pose = rest_pose(skeleton);
  HandAngles angles;
  angles.fingers[0].pip = 120.0 * kDegree;
  angles.fingers[2].dip = -30.0 * kDegree;
  angles.thumb.mp = 65.0 * kDegree;
  angles.thumb.radial_abduction = 85.0 * kDegree;
  pose_hand(skeleton, Side::kRight, angles, pose);
  const auto beyond = [&](const std::string& name) {
    return violation_degrees(name, pose.rotation[static_cast<size_t>(skeleton.find(name))]);
  };
  EXPECT_NEAR(beyond("index_pip_r"), 10.0, 1e-6);
  EXPECT_NEAR(beyond("ring_dip_r"), 25.0, 1e-6);
  EXPECT_NEAR(beyond("thumb_mp_r"), 15.0, 1e-6);
  EXPECT_NEAR(beyond("thumb_cmc_r"), 15.0, 1e-6);
}

TEST(Limits, AnglesAndRotationsAreInverse) {
  std::mt19937 random(5);
  const auto upto = [&](double high) { return high * (static_cast<double>(random()) / 2147483648.0 - 1.0); };
  for (int node = 0; node < figure().size(); ++node)
    for (int i = 0; i < 50; ++i) {
      const JointAngles angles{upto(0.9), upto(0.8), upto(0.7)};
      const JointAngles again = joint_angles(figure(), node, from_joint_angles(figure(), node, angles));
      ASSERT_NEAR(again.flexion, angles.flexion, 1e-9) << figure().node(node).name;
      ASSERT_NEAR(again.abduction, angles.abduction, 1e-9) << figure().node(node).name;
      ASSERT_NEAR(again.twist, angles.twist, 1e-9) << figure().node(node).name;
    }
}

TEST(Limits, ClampedRotationsAreWithinAndGoodOnesUntouched) {
  std::mt19937 random(9);
  const auto any = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  for (int node = 0; node < figure().size(); ++node)
    for (int i = 0; i < 100; ++i) {
      const double x = any();
      const double y = any();
      const double z = any();
      const Quat q = from_rotation_vector(Vec3(x, y, z) * 1.7);
      const Quat limited = clamped(figure(), node, q);
      ASSERT_LT(limit_violation(figure(), node, limited), 1e-9) << figure().node(node).name;
      if (limit_violation(figure(), node, q) == 0.0) {
        ASSERT_EQ(limited, q);
      }
    }
}

}  // namespace
}  // namespace auslan
