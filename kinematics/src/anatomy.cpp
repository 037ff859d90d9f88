// SPDX-License-Identifier: Apache-2.0
#include "kinematics/anatomy.h"

#include "hand_geometry.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"

#include <cmath>

namespace auslan {
namespace {

// Places in kNodeNames.
constexpr size_t kFirstArmName = 3;
constexpr size_t kNamesPerArm = 18;

// A thumb that lies alongside the index presses its pad half against it: the nail of a flat hand is tilted by 45
// degrees.
constexpr double kPadAtZero = 45.0 * kDegree;
constexpr double kFullOpposition = 90.0 * kDegree;

constexpr double kSpreadFadeStart = 50.0 * kDegree;
constexpr double kSpreadFadeEnd = 90.0 * kDegree;

double smooth_step(double low, double high, double x) {
  const double t = (x - low) / (high - low);
  if (!(t > 0.0)) return 0.0;
  return t >= 1.0 ? 1.0 : t * t * (3.0 - 2.0 * t);
}

Vec3 perpendicular_part(const Vec3& v, const Vec3& unit_axis) {
  return v - unit_axis * glm::dot(v, unit_axis);
}

// Direction and pad of the metacarpal; both unit and perpendicular.
struct ThumbDirections {
  Vec3 bone, pad;
};

ThumbDirections thumb_directions(const HandGeometry& hand, const ThumbCarriage& carriage) {
  double s = 0.0;
  double c = 0.0;
  sine_cosine(carriage.radial_abduction, s, c);
  const Vec3 along = hand.thumb_zero * c + hand.thumb_out * s;
  const Vec3 out = hand.thumb_out * c - hand.thumb_zero * s;
  sine_cosine(carriage.palmar_abduction, s, c);
  const Vec3 bone = along * c + hand.frame.palm * s;
  const Vec3 palmar = hand.frame.palm * c - along * s;
  sine_cosine(kPadAtZero - carriage.opposition * kFullOpposition, s, c);
  return {bone, palmar * s - out * c};
}

// The two abductions at which the metacarpal has a direction.
ThumbCarriage carriage_of_bone(const HandGeometry& hand, const Vec3& bone) {
  const double x = glm::dot(bone, hand.thumb_zero);
  const double y = glm::dot(bone, hand.thumb_out);
  return {arc_tangent(y, x), arc_tangent(glm::dot(bone, hand.frame.palm), std::sqrt(x * x + y * y)), 0.0};
}

}  // namespace

ArmNodes arm_nodes(const Skeleton& skeleton, Side side) {
  const size_t first = kFirstArmName + (side == Side::kLeft ? 0 : kNamesPerArm);
  ArmNodes nodes;
  nodes.shoulder = skeleton.find(kNodeNames[first]);
  nodes.elbow = skeleton.find(kNodeNames[first + 1]);
  nodes.wrist = skeleton.find(kNodeNames[first + 2]);
  for (size_t digit = 0; digit < 5; ++digit)
    for (size_t joint = 0; joint < 3; ++joint)
      nodes.digits[digit][joint] = skeleton.find(kNodeNames[first + 3 + 3 * digit + joint]);
  return nodes;
}

HandFrame rest_hand_frame(const Skeleton& skeleton, Side side) {
  const ArmNodes nodes = arm_nodes(skeleton, side);
  const Vec3 outward(side == Side::kLeft ? 1.0 : -1.0, 0.0, 0.0);
  const Vec3& middle = skeleton.rest_position(nodes.digits[2][0]);
  const Vec3 knuckles = skeleton.rest_position(nodes.digits[1][0]) - skeleton.rest_position(nodes.digits[4][0]);
  HandFrame frame;
  frame.fingers = unit(middle - skeleton.rest_position(nodes.wrist), outward);
  const Vec3 normal = unit(glm::cross(frame.fingers, knuckles), Vec3(0.0, -1.0, 0.0));
  frame.palm = normal.y > 0.0 ? -normal : normal;
  frame.radial = unit(perpendicular_part(knuckles, frame.fingers), Vec3(0.0, 0.0, 1.0));
  return frame;
}

Quat orient_hand(const HandFrame& rest, const Vec3& fingers, const Vec3& palm) {
  const Vec3 along = unit(fingers, rest.fingers);
  const Vec3 facing = unit(palm, Vec3(0.0));
  const Vec3 across = perpendicular_part(facing, along);
  if (glm::dot(across, across) < 1e-12) return rotation_between(rest.fingers, along);
  return rotation_between_frames(rest.fingers, rest.palm, along, unit(across));
}

HandGeometry hand_geometry(const Skeleton& skeleton, const ArmNodes& nodes, Side side) {
  HandGeometry hand;
  hand.frame = rest_hand_frame(skeleton, side);
  const HandFrame& frame = hand.frame;
  hand.spread_axis = glm::cross(frame.fingers, frame.radial);
  const auto bone = [&](size_t digit, size_t joint, const Vec3& fallback) {
    return unit(
        skeleton.rest_position(nodes.digits[digit][joint + 1]) - skeleton.rest_position(nodes.digits[digit][joint]),
        fallback);
  };

  for (size_t finger = 0; finger < 4; ++finger) {
    FingerAxes& axes = hand.fingers[finger];
    axes.bone = bone(finger + 1, 0, frame.fingers);
    const Vec3 middle = bone(finger + 1, 1, axes.bone);
    axes.bend[0] = unit(glm::cross(axes.bone, frame.palm), glm::cross(frame.fingers, frame.palm));
    axes.bend[1] = unit(glm::cross(middle, frame.palm), axes.bend[0]);
    axes.bend[2] = axes.bend[1];
    axes.rest_splay = arc_tangent(glm::dot(axes.bone, frame.radial), glm::dot(axes.bone, frame.fingers));
    axes.outward = finger < 2 ? 1.0 : -1.0;
  }

  const Vec3 index_knuckle = skeleton.rest_position(nodes.digits[1][0]) - skeleton.rest_position(nodes.wrist);
  hand.thumb_zero = unit(perpendicular_part(index_knuckle, frame.palm), frame.fingers);
  hand.thumb_out =
      unit(perpendicular_part(perpendicular_part(frame.radial, frame.palm), hand.thumb_zero), frame.radial);
  hand.thumb_bone = bone(0, 0, hand.thumb_zero);
  // Nothing in the joints' places says where a straight thumb's pad faces: a figure at rest is taken not to oppose it.
  hand.thumb_pad = thumb_directions(hand, carriage_of_bone(hand, hand.thumb_bone)).pad;
  const Vec3 phalanx = bone(0, 1, hand.thumb_bone);
  hand.thumb_mp_straight = rotation_between(phalanx, hand.thumb_bone);
  hand.thumb_mp_axis = glm::cross(hand.thumb_bone, hand.thumb_pad);
  hand.thumb_ip_axis = glm::conjugate(hand.thumb_mp_straight) * hand.thumb_mp_axis;
  return hand;
}

Quat thumb_rotation(const HandGeometry& hand, const ThumbCarriage& carriage) {
  const ThumbDirections to = thumb_directions(hand, carriage);
  return rotation_between_frames(hand.thumb_bone, hand.thumb_pad, to.bone, to.pad);
}

ThumbCarriage thumb_carriage(const HandGeometry& hand, const Quat& local) {
  ThumbCarriage carriage = carriage_of_bone(hand, local * hand.thumb_bone);
  const ThumbDirections zero = thumb_directions(hand, carriage);
  const Vec3 pad = local * hand.thumb_pad;
  // Pronation turns the zero pad towards its cross product with the bone or away from it, by the side of the body.
  const Vec3 quarter = thumb_directions(hand, {carriage.radial_abduction, carriage.palmar_abduction, 1.0}).pad;
  carriage.opposition = arc_tangent(glm::dot(pad, quarter), glm::dot(pad, zero.pad)) / kFullOpposition;
  return carriage;
}

void pose_hand(const Skeleton& skeleton, Side side, const HandAngles& angles, Pose& pose) {
  const ArmNodes nodes = arm_nodes(skeleton, side);
  const HandGeometry hand = hand_geometry(skeleton, nodes, side);
  const auto rotation = [&](size_t digit, size_t joint) -> Quat& {
    return pose.rotation[static_cast<size_t>(nodes.digits[digit][joint])];
  };

  for (size_t finger = 0; finger < 4; ++finger) {
    const FingerAxes& axes = hand.fingers[finger];
    const DigitAngles& digit = angles.fingers[finger];
    const double freedom = 1.0 - 0.75 * smooth_step(kSpreadFadeStart, kSpreadFadeEnd, digit.mcp);
    const double spread = axes.outward * digit.abduction * freedom - axes.rest_splay;
    rotation(finger + 1, 0) = axis_angle(hand.spread_axis, spread) * axis_angle(axes.bend[0], digit.mcp);
    rotation(finger + 1, 1) = axis_angle(axes.bend[1], digit.pip);
    rotation(finger + 1, 2) = axis_angle(axes.bend[2], digit.dip);
  }

  const ThumbPose& thumb = angles.thumb;
  rotation(0, 0) = thumb_rotation(hand, {thumb.radial_abduction, thumb.palmar_abduction, thumb.opposition});
  rotation(0, 1) = axis_angle(hand.thumb_mp_axis, thumb.mp) * hand.thumb_mp_straight;
  rotation(0, 2) = axis_angle(hand.thumb_ip_axis, thumb.ip);
}

Vec3 rest_thumb_pad(const Skeleton& skeleton, Side side) {
  return hand_geometry(skeleton, arm_nodes(skeleton, side), side).thumb_pad;
}

}  // namespace auslan
