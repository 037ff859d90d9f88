// SPDX-License-Identifier: Apache-2.0
#include "kinematics/arm_ik.h"
#include "kinematics/elementary.h"
#include "kinematics/limits.h"
#include "kinematics/pose.h"
#include "kinematics/rotation.h"
#include "measured_skeleton.h"
#include "random_places.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace auslan {
namespace {

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

struct Reached {
  Vec3 elbow;
  Transform wrist;
};

const Skeleton& figure() {
  static const Skeleton skeleton = test::measured_skeleton();
  return skeleton;
}

Reached reached(Side side, const Transform& parent, const ArmSolution& solution) {
  const ArmNodes nodes = arm_nodes(figure(), side);
  Transform placed{parent.rotation * solution.shoulder, apply(parent, figure().node(nodes.shoulder).offset)};
  placed = {placed.rotation * solution.elbow, apply(placed, figure().node(nodes.elbow).offset)};
  const Vec3 elbow = placed.position;
  placed = {placed.rotation * solution.wrist, apply(placed, figure().node(nodes.wrist).offset)};
  return {elbow, placed};
}

const double kUpper = 0.287;
const double kFore = 0.2545;

Vec3 shoulder_of(Side side, const Transform& parent) {
  return apply(parent, figure().node(arm_nodes(figure(), side).shoulder).offset);
}

Transform upright_parent() {
  return {kIdentity, figure().rest_position(figure().find("neck_base"))};
}

// What a viewer sees in a mirror: x is negated.
Transform mirrored(const Transform& t) {
  return {Quat(t.rotation.w, t.rotation.x, -t.rotation.y, -t.rotation.z),
          Vec3(-t.position.x, t.position.y, t.position.z)};
}

TEST(ArmIk, ForwardKinematicsMeetsEveryReachableTarget) {
  test::Random random;
  for (int i = 0; i < 20000; ++i) {
    const Side side = i % 2 == 0 ? Side::kLeft : Side::kRight;
    const Transform parent{random.rotation(), random.vector()};
    const double reach = random.between(kUpper - kFore + 1e-6, kUpper + kFore - 1e-9);
    const Vec3 direction = unit(random.vector());
    const Transform target{random.rotation(), shoulder_of(side, parent) + direction * reach};
    const ArmSolution solution = solve_arm(figure(), side, parent, target, random.between(-3.0, 3.0));
    ASSERT_TRUE(solution.reachable);
    ASSERT_EQ(solution.shortfall, 0.0);
    const Reached got = reached(side, parent, solution);
    ASSERT_LT(length(got.wrist.position - target.position), 1e-9);
    ASSERT_LT(angle_between(got.wrist.rotation, target.rotation), 1e-9);
  }
}

TEST(ArmIk, TheElbowIsAHingeThatBendsForwardsThenTwistsAndTheWristDoesNotTwist) {
  test::Random random;
  for (int i = 0; i < 2000; ++i) {
    const Side side = i % 2 == 0 ? Side::kLeft : Side::kRight;
    const double sign = side == Side::kLeft ? 1.0 : -1.0;
    const Transform parent = upright_parent();
    const Transform target{random.rotation(), shoulder_of(side, parent) + random.vector() * 0.28};
    const ArmSolution solution = solve_arm(figure(), side, parent, target, random.between(-1.0, 2.0));
    if (!solution.reachable) continue;
    const Vec3 forearm(sign, 0.0, 0.0);
    const Vec3 bend = rotation_vector(swing_twist(solution.elbow, forearm).swing);
    ASSERT_NEAR(bend.x, 0.0, 1e-9);
    ASSERT_NEAR(bend.z, 0.0, 1e-9);
    ASSERT_GE(-sign * bend.y, 0.0) << "bends backwards";
    ASSERT_NEAR(twist_angle(solution.wrist, forearm), 0.0, 1e-9);
  }
}

TEST(ArmIk, SwivelZeroIsDownAndPositiveIsOutwards) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const double outward = side == Side::kLeft ? 1.0 : -1.0;
    const Transform parent = upright_parent();
    const Vec3 shoulder = shoulder_of(side, parent);
    const Transform target{kIdentity, shoulder + Vec3(0.0, 0.0, 0.4)};
    const Vec3 down = reached(side, parent, solve_arm(figure(), side, parent, target, 0.0)).elbow - shoulder;
    EXPECT_NEAR(down.x, 0.0, 1e-12);
    EXPECT_LT(down.y, -0.1);
    const Vec3 out = reached(side, parent, solve_arm(figure(), side, parent, target, kPi / 2.0)).elbow - shoulder;
    EXPECT_NEAR(out.y, 0.0, 1e-12);
    EXPECT_GT(out.x * outward, 0.1);
  }
}

TEST(ArmIk, AHangingHandsElbowPointsBackwardsAndARaisedOnesForwards) {
  const Transform parent = upright_parent();
  const Vec3 shoulder = shoulder_of(Side::kLeft, parent);
  const auto elbow = [&](const Vec3& offset) {
    return reached(Side::kLeft, parent, solve_arm(figure(), Side::kLeft, parent, {kIdentity, shoulder + offset}, 0.0))
               .elbow -
           shoulder;
  };
  EXPECT_LT(elbow(Vec3(0.0, -0.4, 0.0)).z, -0.1);
  EXPECT_GT(elbow(Vec3(0.0, 0.4, 0.0)).z, 0.1);
}

TEST(ArmIk, TheRightArmMirrorsTheLeftExactly) {
  test::Random random;
  for (int i = 0; i < 2000; ++i) {
    const Transform parent{random.rotation(), random.vector()};
    const Transform target{random.rotation(), shoulder_of(Side::kLeft, parent) + random.vector() * 0.35};
    const double swivel = random.between(-1.0, 2.0);
    const ArmSolution left = solve_arm(figure(), Side::kLeft, parent, target, swivel);
    const ArmSolution right = solve_arm(figure(), Side::kRight, mirrored(parent), mirrored(target), swivel);
    const auto mirror = [](const Quat& q) { return Quat(q.w, q.x, -q.y, -q.z); };
    ASSERT_EQ(right.shoulder, mirror(left.shoulder));
    ASSERT_EQ(right.elbow, mirror(left.elbow));
    ASSERT_EQ(right.wrist, mirror(left.wrist));
    ASSERT_EQ(right.shortfall, left.shortfall);
    if (i < 200) {
      ASSERT_EQ(natural_swivel(figure(), Side::kLeft, parent, target),
                natural_swivel(figure(), Side::kRight, mirrored(parent), mirrored(target)));
    }
  }
}

TEST(ArmIk, TargetsOutOfReachAreStretchedTowardsAndReported) {
  const Transform parent = upright_parent();
  const Vec3 shoulder = shoulder_of(Side::kRight, parent);
  const Vec3 direction = unit(Vec3(-0.3, 0.2, 1.0));
  const Transform far{axis_angle(Vec3(0.0, 1.0, 0.0), 0.5), shoulder + direction * 0.8};
  const ArmSolution solution = solve_arm(figure(), Side::kRight, parent, far, 0.3);
  EXPECT_FALSE(solution.reachable);
  EXPECT_NEAR(solution.shortfall, 0.8 - kUpper - kFore, 1e-12);
  const Reached got = reached(Side::kRight, parent, solution);
  EXPECT_LT(length(got.wrist.position - (shoulder + direction * (kUpper + kFore))), 1e-12);
  EXPECT_LT(angle_between(got.wrist.rotation, far.rotation), 1e-12);

  const Transform near{kIdentity, shoulder + direction * 0.01};
  const ArmSolution folded = solve_arm(figure(), Side::kRight, parent, near, 0.3);
  EXPECT_FALSE(folded.reachable);
  EXPECT_NEAR(folded.shortfall, kUpper - kFore - 0.01, 1e-12);
  EXPECT_LT(length(reached(Side::kRight, parent, folded).wrist.position - (shoulder + direction * (kUpper - kFore))),
            1e-9);

  // The shoulder itself as the target: no line, and still an answer.
  const ArmSolution nowhere = solve_arm(figure(), Side::kRight, parent, {kIdentity, shoulder}, 0.0);
  EXPECT_FALSE(nowhere.reachable);
  EXPECT_TRUE(std::isfinite(nowhere.shoulder.w + nowhere.elbow.w + nowhere.wrist.w));
}

// Signing space: in front of the body from the waist to over the head.
Transform signing_target(Side side, double a, double b, double c) {
  const double sign = side == Side::kLeft ? 1.0 : -1.0;
  const HandFrame rest = rest_hand_frame(figure(), side);
  const Vec3 position = upright_parent().position + Vec3(sign * (0.05 + 0.2 * std::sin(1.3 * a)),
                                                         -0.15 + 0.25 * std::sin(b), 0.28 + 0.08 * std::sin(c));
  const Vec3 fingers(-sign * 0.5, 1.0 + 0.5 * std::sin(c), 0.3);
  const Vec3 palm(-sign * 0.5 * std::sin(a), 0.0, 1.0);
  return {orient_hand(rest, fingers, palm), position};
}

TEST(ArmIk, NearbyTargetsHaveNearbySolutions) {
  const Transform parent = upright_parent();
  for (const Side side : {Side::kLeft, Side::kRight}) {
    Quat before[3];
    for (int i = 0; i <= 4000; ++i) {
      const double t = i * 0.002;
      const Transform target = signing_target(side, t, 0.7 * t, 1.9 * t);
      const ArmSolution solution =
          solve_arm(figure(), side, parent, target, natural_swivel(figure(), side, parent, target));
      const Quat now[3] = {solution.shoulder, solution.elbow, solution.wrist};
      // The target moves by at most 1 mm and half a degree a step.
      for (int k = 0; k < 3; ++k) {
        if (i > 0) {
          ASSERT_LT(angle_between(before[k], now[k]), 3.0 * kDegree) << "step " << i << " joint " << k;
        }
        before[k] = now[k];
      }
    }
  }
}

TEST(NaturalSwivel, IsDownAndSlightlyOutWhereNothingForbidsIt) {
  const Transform parent = upright_parent();
  const Vec3 shoulder = shoulder_of(Side::kRight, parent);
  // The hand in front of the chest with the palm to the other side: a handshake.
  const HandFrame rest = rest_hand_frame(figure(), Side::kRight);
  const Transform target{orient_hand(rest, Vec3(0.0, 0.0, 1.0), Vec3(1.0, 0.0, 0.0)),
                         shoulder + Vec3(0.02, -0.2, 0.35)};
  const double swivel = natural_swivel(figure(), Side::kRight, parent, target);
  EXPECT_GT(swivel, 0.0);
  EXPECT_LT(swivel, 50.0 * kDegree);
}

TEST(NaturalSwivel, KeepsLimitsWhereSomeSwivelDoes) {
  const Transform parent = upright_parent();
  int tried = 0;
  int kept = 0;
  for (int i = 0; i < 300; ++i) {
    const Side side = i % 2 == 0 ? Side::kLeft : Side::kRight;
    const Transform target = signing_target(side, 0.31 * i, 0.17 * i, 0.23 * i);
    const ArmNodes nodes = arm_nodes(figure(), side);
    const auto violation = [&](double swivel) {
      const ArmSolution solution = solve_arm(figure(), side, parent, target, swivel);
      return limit_violation(figure(), nodes.shoulder, solution.shoulder) +
             limit_violation(figure(), nodes.elbow, solution.elbow) +
             limit_violation(figure(), nodes.wrist, solution.wrist);
    };
    double least = 1e9;
    for (int degrees = -60; degrees <= 150; degrees += 5)
      least = std::min(least, violation(degrees * kDegree));
    const double chosen = violation(natural_swivel(figure(), side, parent, target));
    // Where the hand cannot be held so by any swivel the sum to be least is another one than the search's.
    if (least < 30.0 * kDegree) {
      EXPECT_LT(chosen, least + 6.0 * kDegree) << i;
    }
    if (least > 0.0) continue;
    ++tried;
    if (chosen < 1.0 * kDegree) ++kept;
  }
  EXPECT_GT(tried, 50);
  EXPECT_GE(kept, tried * 9 / 10);
}

}  // namespace
}  // namespace auslan
