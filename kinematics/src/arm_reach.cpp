// SPDX-License-Identifier: Apache-2.0
#include "kinematics/arm_reach.h"

#include "arm_geometry.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"

#include <algorithm>
#include <cmath>

namespace auslan {
namespace {

// The hand is brought this far within the limits, so that what later turns it a little does not break them again.
constexpr double kInside = 1.0 * kDegree;
// From this far within a limit a joint gives way.
constexpr double kSoft = 1.0 * kDegree;

/// Once differentiable: the angle itself, then a parabola, then the limit. A straight elbow is at its limit and at
/// ease: a range that begins at zero begins hard.
double softened(double angle, double low, double high) {
  const auto eased = [](double beyond) {
    const double u = beyond / kSoft;
    return u < 2.0 ? kSoft * (u - 0.25 * u * u) : kSoft;
  };
  if (angle > high - kSoft) return high - kSoft + eased(angle - high + kSoft);
  if (low == 0.0) return std::max(angle, low);
  if (angle < low + kSoft) return low + kSoft - eased(low + kSoft - angle);
  return angle;
}

void soften(JointAngles& angles, const JointLimits& limits) {
  angles.flexion = softened(angles.flexion, limits.flexion_low, limits.flexion_high);
  angles.abduction = softened(angles.abduction, limits.abduction_low, limits.abduction_high);
  angles.twist = softened(angles.twist, limits.twist_low, limits.twist_high);
}

JointLimits narrowed(JointLimits limits, double by) {
  const auto narrow = [by](double& low, double& high) {
    if (low < 0.0) low += by;
    high -= by;
  };
  narrow(limits.flexion_low, limits.flexion_high);
  narrow(limits.abduction_low, limits.abduction_high);
  narrow(limits.twist_low, limits.twist_high);
  return limits;
}

JointAngles brought_within(const JointLimits& limits, const JointAngles& angles) {
  return {std::clamp(angles.flexion, limits.flexion_low, limits.flexion_high),
          std::clamp(angles.abduction, limits.abduction_low, limits.abduction_high),
          std::clamp(angles.twist, limits.twist_low, limits.twist_high)};
}

}  // namespace

/// The ranges in which forearm and wrist are sought.
struct ArmReach::Within {
  JointLimits elbow, wrist;

  explicit Within(double inside) : elbow(narrowed(elbow_limits(), inside)), wrist(narrowed(wrist_limits(), inside)) {}
  /// The wrist gives a little about the forearm: it takes what the forearm cannot turn.
  void share_twist(JointAngles& forearm, JointAngles& hand) const {
    const double kept = std::clamp(forearm.twist, elbow.twist_low, elbow.twist_high);
    const double given = std::clamp(forearm.twist - kept, wrist.twist_low, wrist.twist_high);
    forearm.twist -= given;
    hand.twist += given;
  }
};

struct ArmReach::State {
  ArmGeometry arm;
  JointAxes shoulder, elbow, wrist;
  // A joint that gives way from kSoft within its limit has come to the limit when as much more is asked of it.
  Within within{kInside}, ends{-kSoft};

  double excess(const ArmSolution& solution) const {
    JointAngles forearm = angles_about(elbow, solution.elbow), hand = angles_about(wrist, solution.wrist);
    within.share_twist(forearm, hand);
    return excess(solution, forearm, hand);
  }
  /// Forearm and hand as share_twist leaves them.
  double excess(const ArmSolution& solution, const JointAngles& forearm, const JointAngles& hand) const {
    return std::sqrt(squared_excess(shoulder_limits(), angles_about(shoulder, solution.shoulder)) +
                     squared_excess(elbow_limits(), forearm) + squared_excess(wrist_limits(), hand));
  }
};

ArmReach::ArmReach(const Skeleton& skeleton, Side side) {
  const ArmGeometry arm = arm_geometry(skeleton, side);
  state_.reset(
      new State{arm, shoulder_axes(arm), elbow_axes(arm), wrist_axes(rest_hand_frame(skeleton, side), arm.side_sign)});
}
ArmReach::ArmReach(ArmReach&&) noexcept = default;
ArmReach& ArmReach::operator=(ArmReach&&) noexcept = default;
ArmReach::~ArmReach() = default;

ArmReach::Reached ArmReach::reach(const Quat& wanted, const Vec3& pivot, const Vec3& target, double swivel,
                                  int rounds) const {
  return reach_within(state_->within, wanted, pivot, target, swivel, rounds);
}

ArmReach::Reached ArmReach::reach_to_ends(const Quat& wanted, const Vec3& pivot, const Vec3& target,
                                          double swivel) const {
  constexpr int kRounds = 16;
  return reach_within(state_->ends, wanted, pivot, target, swivel, kRounds);
}

ArmReach::Reached ArmReach::reach_within(const Within& within, const Quat& wanted, const Vec3& pivot,
                                         const Vec3& target, double swivel, int rounds) const {
  const State& s = *state_;
  Reached reached;
  reached.wrist.rotation = wanted;
  JointAngles elbow, wrist;
  for (int round = 0; round < rounds; ++round) {
    reached.wrist.position = target - reached.wrist.rotation * pivot;
    reached.arm = solve_in_trunk(s.arm, reached.wrist, swivel);
    elbow = angles_about(s.elbow, reached.arm.elbow);
    wrist = angles_about(s.wrist, reached.arm.wrist);
    within.share_twist(elbow, wrist);
    if (squared_excess(within.elbow, elbow) == 0.0 && squared_excess(within.wrist, wrist) == 0.0) break;
    if (round + 1 == rounds) break;
    // The forearm can turn the hand and the wrist can bend it; the elbow's own bend is the place's matter.
    JointAngles turned = brought_within(within.elbow, elbow);
    turned.flexion = elbow.flexion;
    reached.wrist.rotation =
        renormalised(reached.arm.clavicle * reached.arm.shoulder * rotation_about(s.elbow, turned) *
                     rotation_about(s.wrist, brought_within(within.wrist, wrist)));
  }
  reached.lean = angle_between(wanted, reached.wrist.rotation);
  reached.excess = s.excess(reached.arm, elbow, wrist);
  reached.off = reached.arm.shortfall;
  return reached;
}

ArmSolution ArmReach::solve(const Transform& trunk_from_wrist, double swivel) const {
  return solve_in_trunk(state_->arm, trunk_from_wrist, swivel);
}

double ArmReach::excess(const Transform& trunk_from_wrist, double swivel) const {
  return state_->excess(solve_in_trunk(state_->arm, trunk_from_wrist, swivel));
}

ArmSolution ArmReach::limited(const ArmSolution& arm) const {
  const State& s = *state_;
  JointAngles shoulder = angles_about(s.shoulder, arm.shoulder);
  JointAngles elbow = angles_about(s.elbow, arm.elbow);
  JointAngles wrist = angles_about(s.wrist, arm.wrist);
  s.within.share_twist(elbow, wrist);
  soften(shoulder, shoulder_limits());
  soften(elbow, elbow_limits());
  soften(wrist, wrist_limits());
  ArmSolution limited = arm;
  limited.shoulder = renormalised(rotation_about(s.shoulder, shoulder));
  limited.elbow = renormalised(rotation_about(s.elbow, elbow));
  limited.wrist = renormalised(rotation_about(s.wrist, wrist));
  return limited;
}

}  // namespace auslan
