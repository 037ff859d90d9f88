// SPDX-License-Identifier: Apache-2.0
#include "kinematics/anatomy.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
#include "measured_skeleton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace auslan {
namespace {

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}
double degrees_between(const Vec3& a, const Vec3& b) {
  return length(rotation_vector(rotation_between(a, b))) / kDegree;
}

DigitAngles finger(double mcp, double pip, double dip, double abduction) {
  return {mcp * kDegree, pip * kDegree, dip * kDegree, abduction * kDegree};
}
ThumbPose thumb(double radial, double palmar, double opposition, double mp, double ip) {
  return {radial * kDegree, palmar * kDegree, opposition, mp * kDegree, ip * kDegree};
}
HandAngles hand(const DigitAngles& all, const ThumbPose& thumb_pose) {
  return {{all, all, all, all}, thumb_pose};
}

// A posed hand with the wrist at the origin, in coordinates (fingers, palm, radial), millimetres.
class PosedHand {
 public:
  PosedHand(Side side, const HandAngles& angles)
      : nodes_(arm_nodes(skeleton_, side)), frame_(rest_hand_frame(skeleton_, side)) {
    Pose pose = rest_pose(skeleton_);
    pose_hand(skeleton_, side, angles, pose);
    world_.resize(static_cast<size_t>(skeleton_.size()));
    forward(skeleton_, pose, world_);
  }
  /// Joints 0 to 2; 3 is the centre of the fingertip's ball.
  Vec3 at(size_t digit, size_t joint) const {
    if (joint < 3) return local(world_[index(digit, joint)].position);
    const Vec3 along = unit(skeleton_.node(nodes_.digits[digit][2]).offset);
    return local(apply(world_[index(digit, 2)], along * (test::measured_tip(digit) - kTipRadius)));
  }
  Vec3 bone(size_t digit, size_t joint) const { return unit(at(digit, joint + 1) - at(digit, joint)); }
  Vec3 turned(size_t digit, size_t joint, const Vec3& rest_direction) const {
    return coordinates(world_[index(digit, joint)].rotation * rest_direction);
  }
  Vec3 coordinates(const Vec3& v) const {
    return {glm::dot(v, frame_.fingers), glm::dot(v, frame_.palm), glm::dot(v, frame_.radial)};
  }
  const Skeleton& skeleton() const { return skeleton_; }

  static constexpr double kTipRadius = 0.0075;

 private:
  size_t index(size_t digit, size_t joint) const { return static_cast<size_t>(nodes_.digits[digit][joint]); }
  Vec3 local(const Vec3& world) const {
    return 1e3 * coordinates(world - world_[static_cast<size_t>(nodes_.wrist)].position);
  }

  Skeleton skeleton_ = test::measured_skeleton();
  ArmNodes nodes_;
  HandFrame frame_;
  std::vector<Transform> world_;
};

// Least distance between two segments, by trying 40 points on each.
double distance_of(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  double least = 1e9;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j)
      least = std::min(least, length(a0 + (a1 - a0) * (i / 40.0) - b0 - (b1 - b0) * (j / 40.0)));
  return least;
}

TEST(Anatomy, ArmNodesAreThoseOfTheirNames) {
  const Skeleton skeleton = test::measured_skeleton();
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::string end = side == Side::kLeft ? "_l" : "_r";
    const ArmNodes nodes = arm_nodes(skeleton, side);
    const auto name = [&](int node) { return skeleton.node(node).name; };
    EXPECT_EQ(name(nodes.shoulder), "shoulder" + end);
    EXPECT_EQ(name(nodes.elbow), "elbow" + end);
    EXPECT_EQ(name(nodes.wrist), "wrist" + end);
    EXPECT_EQ(name(nodes.digits[0][0]), "thumb_cmc" + end);
    EXPECT_EQ(name(nodes.digits[0][2]), "thumb_ip" + end);
    EXPECT_EQ(name(nodes.digits[1][1]), "index_pip" + end);
    EXPECT_EQ(name(nodes.digits[4][2]), "little_dip" + end);
  }
}

TEST(Anatomy, RestHandsPointOutWithPalmsDownAndThumbsForward) {
  const Skeleton skeleton = test::measured_skeleton();
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const HandFrame frame = rest_hand_frame(skeleton, side);
    EXPECT_LT(degrees_between(frame.fingers, Vec3(side == Side::kLeft ? 1.0 : -1.0, 0.0, 0.0)), 6.0);
    EXPECT_LT(degrees_between(frame.palm, Vec3(0.0, -1.0, 0.0)), 6.0);
    EXPECT_LT(degrees_between(frame.radial, Vec3(0.0, 0.0, 1.0)), 6.0);
    EXPECT_NEAR(glm::dot(frame.fingers, frame.palm), 0.0, 1e-15);
    EXPECT_NEAR(glm::dot(frame.fingers, frame.radial), 0.0, 1e-15);
    EXPECT_NEAR(glm::dot(frame.palm, frame.radial), 0.0, 1e-15);
  }
}

TEST(Anatomy, OrientedHandsPointAndFaceAsAsked) {
  const Skeleton skeleton = test::measured_skeleton();
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const HandFrame rest = rest_hand_frame(skeleton, side);
    const Vec3 up(0.0, 2.0, 0.0);
    const Vec3 forward_and_up(0.0, 1.0, 1.0);
    const Quat q = orient_hand(rest, up, forward_and_up);
    EXPECT_LT(length(q * rest.fingers - Vec3(0.0, 1.0, 0.0)), 1e-15);
    EXPECT_LT(length(q * rest.palm - Vec3(0.0, 0.0, 1.0)), 1e-15);
    // With fingers up and the palm to the viewer the thumbs of both hands point at the body's middle.
    EXPECT_LT(length(q * rest.radial - Vec3(side == Side::kLeft ? -1.0 : 1.0, 0.0, 0.0)), 1e-15);
    const Quat parallel = orient_hand(rest, up, up);
    EXPECT_LT(angle_between(parallel, rotation_between(rest.fingers, up)), 1e-15);
  }
}

TEST(PoseHand, FlexionBendsEachFingerTowardsThePalmByItsAngle) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const PosedHand posed(side, hand(finger(40.0, 30.0, 20.0, 0.0), {}));
    for (size_t digit = 1; digit < 5; ++digit) {
      EXPECT_LT(degrees_between(posed.bone(digit, 0), Vec3(std::cos(40 * kDegree), std::sin(40 * kDegree), 0.0)), 4.0);
      EXPECT_NEAR(degrees_between(posed.bone(digit, 0), posed.bone(digit, 1)), 30.0, 1e-6);
      EXPECT_NEAR(degrees_between(posed.bone(digit, 1), posed.bone(digit, 2)), 20.0, 1e-6);
      EXPECT_GT(posed.bone(digit, 2).y, posed.bone(digit, 1).y) << "not towards the palm";
    }
  }
}

TEST(PoseHand, AbductionSpreadsFromParallelFingers) {
  const PosedHand together(Side::kRight, hand(finger(0.0, 0.0, 0.0, 0.0), {}));
  const PosedHand spread(Side::kRight, hand(finger(0.0, 0.0, 0.0, 12.0), {}));
  const double expected_sign[5] = {0.0, 1.0, 1.0, -1.0, -1.0};  // to the thumb's side
  for (size_t digit = 1; digit < 5; ++digit) {
    EXPECT_NEAR(together.bone(digit, 0).z, 0.0, 1e-9);
    EXPECT_NEAR(std::atan2(spread.bone(digit, 0).z, spread.bone(digit, 0).x) / kDegree, 12.0 * expected_sign[digit],
                1e-6);
  }
}

TEST(PoseHand, AbductionFadesInAFlexedJoint) {
  // At 90 degrees of flexion abduction is a roll of the finger about itself: a quarter of it is left.
  const PosedHand posed(
      Side::kRight, {{finger(90, 90, 0, 0), finger(90, 90, 0, 0), finger(90, 90, 0, 0), finger(90, 90, 0, 20)}, {}});
  const Vec3 little = posed.bone(4, 1);
  EXPECT_NEAR(std::fabs(std::atan2(little.z, -little.x)) / kDegree, 5.0, 0.5);
}

TEST(PoseHand, OnlyTheFifteenDigitNodesAreWritten) {
  const Skeleton skeleton = test::measured_skeleton();
  Pose pose = rest_pose(skeleton);
  const Quat mark = axis_angle(Vec3(0.0, 0.0, 1.0), 0.3);
  pose.rotation.assign(pose.rotation.size(), mark);
  pose_hand(skeleton, Side::kLeft, hand(finger(10, 10, 10, 0), thumb(10, 10, 0.5, 10, 10)), pose);
  int changed = 0;
  for (int i = 0; i < skeleton.size(); ++i)
    if (!(pose.rotation[static_cast<size_t>(i)] == mark)) {
      ++changed;
      EXPECT_TRUE(skeleton.node(i).name.ends_with("_l"));
      EXPECT_FALSE(skeleton.node(i).name == "wrist_l" || skeleton.node(i).name == "elbow_l");
    }
  EXPECT_EQ(changed, 15);
}

TEST(PoseHand, TheRightHandMirrorsTheLeftExactly) {
  const Skeleton skeleton = test::measured_skeleton();
  const HandAngles angles = {{finger(10, 20, 30, 5), finger(80, 100, 60, -3), finger(50, 5, 0, 8), finger(0, 0, 0, 25)},
                             thumb(15, 40, 0.7, 20, 25)};
  Pose pose = rest_pose(skeleton);
  pose_hand(skeleton, Side::kLeft, angles, pose);
  pose_hand(skeleton, Side::kRight, angles, pose);
  const ArmNodes left = arm_nodes(skeleton, Side::kLeft);
  const ArmNodes right = arm_nodes(skeleton, Side::kRight);
  for (size_t digit = 0; digit < 5; ++digit)
    for (size_t joint = 0; joint < 3; ++joint) {
      const Quat& l = pose.rotation[static_cast<size_t>(left.digits[digit][joint])];
      const Quat& r = pose.rotation[static_cast<size_t>(right.digits[digit][joint])];
      EXPECT_EQ(r, Quat(l.w, l.x, -l.y, -l.z)) << digit << ' ' << joint;
    }
}

TEST(Thumb, LiesAlongsideTheIndexAtZero) {
  const PosedHand posed(Side::kRight, hand({}, {}));
  const Vec3 metacarpal = posed.bone(0, 0);
  EXPECT_NEAR(metacarpal.y, 0.0, 1e-9) << "in the plane of the palm";
  EXPECT_LT(degrees_between(metacarpal, posed.at(1, 0)), 10.0);
  EXPECT_LT(degrees_between(metacarpal, posed.bone(0, 1)), 1e-5) << "straight";
}

TEST(Thumb, AGoodHandPointsItAwayFromTheFingers) {
  const PosedHand posed(Side::kRight, hand(finger(85, 105, 65, 0), thumb(65, 5, 0.0, -5, -15)));
  EXPECT_LT(degrees_between(posed.bone(0, 1), Vec3(0.0, 0.0, 1.0)), 15.0);
}

TEST(Thumb, PalmarAbductionLeadsToWhereThePalmFaces) {
  const PosedHand posed(Side::kLeft, hand({}, thumb(0, 60, 0.0, 0, 0)));
  EXPECT_NEAR(posed.bone(0, 0).y, std::sin(60 * kDegree), 1e-9);
}

TEST(Thumb, OppositionTurnsThePadByAQuarterTurnIntoThePalm) {
  const PosedHand flat(Side::kRight, hand({}, thumb(30, 0, 0.0, 0, 0)));
  const PosedHand opposed(Side::kRight, hand({}, thumb(30, 50, 1.0, 0, 0)));
  const Vec3 rest = rest_thumb_pad(flat.skeleton(), Side::kRight);
  const Vec3 pad = flat.turned(0, 0, rest);
  EXPECT_GT(pad.y, 0.5) << "half to where the palm faces";
  EXPECT_LT(pad.z, -0.4) << "half to the index";
  // Opposed, the pad faces the fingers and the palm: back from where the palm faces.
  EXPECT_LT(opposed.turned(0, 0, rest).y, 0.0);
  // The palm's direction turned by the elevation of the metacarpal: the pad was 50 degrees from the index, is 40
  // beyond.
  EXPECT_NEAR(glm::dot(opposed.turned(0, 0, rest), opposed.bone(0, 0)), 0.0, 1e-9);
}

TEST(Thumb, MpAndIpFlexTowardsThePad) {
  const PosedHand posed(Side::kRight, hand({}, thumb(20, 20, 0.2, 30, 50)));
  EXPECT_NEAR(degrees_between(posed.bone(0, 0), posed.bone(0, 1)), 30.0, 1e-6);
  EXPECT_NEAR(degrees_between(posed.bone(0, 1), posed.bone(0, 2)), 50.0, 1e-6);
  const Vec3 pad = posed.turned(0, 0, rest_thumb_pad(posed.skeleton(), Side::kRight));
  EXPECT_GT(glm::dot(posed.bone(0, 1), pad), 0.0);
}

// The thumb and finger radii here are half the breadths of a mean hand, about 10 and 9 millimetres.
TEST(Thumb, LiesOverAClosedFist) {
  const PosedHand posed(Side::kRight, hand(finger(85, 105, 65, 0), thumb(0, 25, 0.7, 35, 45)));
  // In front of the middle phalanges as the palm sees them, across at least the index.
  EXPECT_GT(posed.at(0, 3).y, posed.at(1, 1).y);
  EXPECT_LT(posed.at(0, 3).z, posed.at(1, 1).z - 10.0);
  double nearest = 1e9;
  for (size_t joint = 1; joint < 3; ++joint)
    for (size_t digit = 1; digit < 3; ++digit)
      for (size_t bone = 0; bone < 3; ++bone)
        nearest = std::min(nearest, distance_of(posed.at(0, joint), posed.at(0, joint + 1), posed.at(digit, bone),
                                                posed.at(digit, bone + 1)));
  EXPECT_GT(nearest, 15.0) << "the thumb is in the fingers";
  EXPECT_LT(nearest, 23.0) << "the thumb does not touch the fingers";
}

TEST(Thumb, MeetsTheIndexInARing) {
  const PosedHand posed(Side::kLeft, hand(finger(55, 60, 35, 0), thumb(15, 40, 0.7, 20, 25)));
  const double apart = length(posed.at(0, 3) - posed.at(1, 3));
  EXPECT_GT(apart, 11.0);
  EXPECT_LT(apart, 20.0);
}

TEST(Thumb, StaysOutOfAFlatHand) {
  const PosedHand posed(Side::kRight, hand({}, thumb(5, 0, 0.0, 5, 5)));
  EXPECT_GT(distance_of(posed.at(0, 1), posed.at(0, 3), posed.at(1, 0), posed.at(1, 3)), 17.0);
}

}  // namespace
}  // namespace auslan
