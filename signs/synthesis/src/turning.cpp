// SPDX-License-Identifier: Apache-2.0
#include "turning.h"

#include "kinematics/arm_ik.h"
#include "kinematics/interpolate.h"
#include "kinematics/limits.h"
#include "kinematics/rotation.h"
#include "synthesis/joint_speed.h"
#include "synthesis/performance.h"

#include <algorithm>
#include <cmath>

namespace auslan {
namespace {

// Below this the hand keeps its direction, radians.
constexpr double kNoTurn = 1e-3;

ArmSolution arm_of(const Signer& signer, Side side, const HandState& state) {
  const Skeleton& skeleton = signer.figure().skeleton;
  const Vec3 from_trunk = state.wrist.position - skeleton.rest_position(arm_nodes(skeleton, side).trunk);
  const ArmReach& reach = signer.reach(side);
  return reach.limited(reach.solve({state.wrist.rotation, from_trunk}, state.swivel));
}

JointAngles middle(const JointAngles& a, const JointAngles& b) {
  return {0.5 * (a.flexion + b.flexion), 0.5 * (a.abduction + b.abduction), 0.5 * (a.twist + b.twist)};
}

bool digits_move(const HandSegment& segment) {
  const HandAngles &a = segment.from.angles, &b = segment.to.angles;
  for (size_t i = 0; i < 4; ++i)
    if (a.fingers[i].mcp != b.fingers[i].mcp || a.fingers[i].pip != b.fingers[i].pip ||
        a.fingers[i].dip != b.fingers[i].dip || a.fingers[i].abduction != b.fingers[i].abduction)
      return true;
  return a.thumb.radial_abduction != b.thumb.radial_abduction || a.thumb.palmar_abduction != b.thumb.palmar_abduction ||
         a.thumb.opposition != b.thumb.opposition || a.thumb.mp != b.thumb.mp || a.thumb.ip != b.thumb.ip ||
         segment.oscillation.flex != 0.0 || segment.oscillation.wiggle != 0.0;
}

/// The time that the fastest of equal steps through the segment asks for.
double seconds_by_steps(const Signer& signer, Side side, const HandSegment& segment, int steps) {
  const Skeleton& skeleton = signer.figure().skeleton;
  const bool with_digits = digits_move(segment);
  HandSegment second = segment;
  second.begin = 0;
  second.end = kTicksPerSecond;
  ArmSolution before = arm_of(signer, side, segment.from);
  // Where the wrist truly is: the limits of the joints may keep it from its path.
  const ArmNodes nodes = arm_nodes(skeleton, side);
  const Vec3 upper = skeleton.node(nodes.elbow).offset, fore = skeleton.node(nodes.wrist).offset;
  const Vec3 clavicle = skeleton.node(nodes.shoulder).offset;
  const auto place_of = [&](const ArmSolution& arm) {
    return arm.clavicle * (clavicle + arm.shoulder * (upper + arm.elbow * fore));
  };
  DigitRotations hand_before;
  if (with_digits) hand_before = signer.hand(side).rotations(segment.from.angles);
  double needed = 0.0;
  for (int i = 1; i <= steps; ++i) {
    const HandState state = state_at(second, kTicksPerSecond * i / steps);
    const ArmSolution now = arm_of(signer, side, state);
    const Vec3 way = place_of(now) - place_of(before);
    needed = std::max({needed, angle_between(before.clavicle, now.clavicle) * steps / joint_speed::kClavicle,
                       angle_between(before.shoulder, now.shoulder) * steps / joint_speed::kShoulder,
                       angle_between(before.elbow, now.elbow) * steps / joint_speed::kElbow,
                       angle_between(before.wrist, now.wrist) * steps / joint_speed::kWrist,
                       std::sqrt(glm::dot(way, way)) * steps / joint_speed::kWristInSpace});
    before = now;
    if (!with_digits) continue;
    const DigitRotations hand_now = signer.hand(side).rotations(state.angles);
    for (size_t digit = 0; digit < 5; ++digit)
      for (size_t joint = 0; joint < 3; ++joint)
        needed = std::max(
            needed, angle_between(hand_before[digit][joint], hand_now[digit][joint]) * steps / joint_speed::kDigit);
    hand_before = hand_now;
  }
  return needed;
}

}  // namespace

double fastest_turn(std::string_view node) {
  if (node == "spine_base") return joint_speed::kTrunk;
  if (node == "neck_base" || node == "head_base") return joint_speed::kNeck;
  if (node.starts_with("clavicle_")) return joint_speed::kClavicle;
  if (node.starts_with("shoulder_")) return joint_speed::kShoulder;
  if (node.starts_with("elbow_")) return joint_speed::kElbow;
  if (node.starts_with("wrist_")) return joint_speed::kWrist;
  return joint_speed::kDigit;
}

std::optional<Quat> turn_through_joints(const Signer& signer, Side side, const HandSegment& segment) {
  if (angle_between(segment.from.wrist.rotation, segment.to.wrist.rotation) < kNoTurn) return std::nullopt;
  const Skeleton& skeleton = signer.figure().skeleton;
  const ArmNodes nodes = arm_nodes(skeleton, side);
  const ArmSolution from = arm_of(signer, side, segment.from), to = arm_of(signer, side, segment.to);
  HandState half;
  half.wrist.position = 0.5 * (segment.from.wrist.position + segment.to.wrist.position) + segment.bulge +
                        0.84375 * (segment.leave + segment.approach);
  half.wrist.rotation = slerp(segment.from.wrist.rotation, segment.to.wrist.rotation, 0.5);
  half.swivel = 0.5 * (segment.from.swivel + segment.to.swivel) + segment.swivel_bulge;
  const ArmSolution arm = arm_of(signer, side, half);
  JointAngles elbow = joint_angles(skeleton, nodes.elbow, arm.elbow);
  elbow.twist =
      middle(joint_angles(skeleton, nodes.elbow, from.elbow), joint_angles(skeleton, nodes.elbow, to.elbow)).twist;
  const JointAngles wrist =
      middle(joint_angles(skeleton, nodes.wrist, from.wrist), joint_angles(skeleton, nodes.wrist, to.wrist));
  return arm.clavicle * arm.shoulder * from_joint_angles(skeleton, nodes.elbow, elbow) *
         from_joint_angles(skeleton, nodes.wrist, wrist);
}

double shortest_seconds(const Signer& signer, Side side, const HandSegment& segment) {
  constexpr int kSteps = 32, kFineSteps = 128;
  // An arm that is pressed turns unevenly: there the peaks lie close together.
  constexpr double kPressed = 0.3;
  const double needed = seconds_by_steps(signer, side, segment, kSteps);
  // What lies between the steps may be a little faster.
  return 1.04 * (needed < kPressed ? needed : seconds_by_steps(signer, side, segment, kFineSteps));
}

}  // namespace auslan
