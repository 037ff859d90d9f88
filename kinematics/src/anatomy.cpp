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

// How ThumbPose's angles become directions. The numbers were fitted to pictures of a hand of measured bones: the thumb
// of a closed hand lies on the fingers, that of a pinch meets the index, with the angles that handshape tables give.
//
// A thumb alongside the index clears it by this much, and its pad is turned so from the index to where the palm faces.
constexpr double kClearance = 6.0 * kDegree;
constexpr double kPadAtZero = 50.0 * kDegree;
constexpr double kFullOpposition = 90.0 * kDegree;
// The saddle joint does not pronate on the spot: opposition swings the metacarpal across, and from about half of it
// carries it out of the palm's plane, to this elevation whatever the palmar abduction.
constexpr double kOpposedAdduction = 20.0 * kDegree;
constexpr double kOpposedElevation = 53.0 * kDegree;
constexpr double kCarryStart = 0.45;
constexpr double kCarryEnd = 0.75;
constexpr double kCarryShare = 0.9;

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

// The metacarpal on the sphere about the cmc joint: longitude in the palm's plane from the index to the thumb's side,
// elevation to where the palm faces, and the angle of the pad from the index's side to the palm's.
struct ThumbSphere {
  double longitude = 0.0, elevation = 0.0, roll = 0.0;
};

double carried(double opposition) {
  return kCarryShare * smooth_step(kCarryStart, kCarryEnd, opposition);
}

ThumbSphere sphere_of(const ThumbCarriage& carriage) {
  const double share = carried(carriage.opposition);
  return {carriage.radial_abduction + kClearance - kOpposedAdduction * carriage.opposition,
          carriage.palmar_abduction + share * (kOpposedElevation - carriage.palmar_abduction),
          kPadAtZero - kFullOpposition * carriage.opposition};
}

ThumbCarriage carriage_of(const ThumbSphere& sphere) {
  ThumbCarriage carriage;
  carriage.opposition = (kPadAtZero - sphere.roll) / kFullOpposition;
  const double share = carried(carriage.opposition);
  carriage.radial_abduction = sphere.longitude - kClearance + kOpposedAdduction * carriage.opposition;
  carriage.palmar_abduction = (sphere.elevation - share * kOpposedElevation) / (1.0 - share);
  return carriage;
}

// Direction of the metacarpal and what its pad's angle is counted between; all unit, at right angles.
struct ThumbDirections {
  Vec3 bone, to_index, to_palm;
};

ThumbDirections thumb_directions(const HandGeometry& hand, const ThumbSphere& sphere) {
  double s = 0.0;
  double c = 0.0;
  sine_cosine(sphere.longitude, s, c);
  const Vec3 along = hand.thumb_zero * c + hand.thumb_out * s;
  const Vec3 to_index = hand.thumb_zero * s - hand.thumb_out * c;
  sine_cosine(sphere.elevation, s, c);
  return {along * c + hand.frame.palm * s, to_index, hand.frame.palm * c - along * s};
}

Vec3 pad_of(const ThumbDirections& directions, double roll) {
  double s = 0.0;
  double c = 0.0;
  sine_cosine(roll, s, c);
  return directions.to_index * c + directions.to_palm * s;
}

ThumbSphere sphere_of_bone(const HandGeometry& hand, const Vec3& bone) {
  const double x = glm::dot(bone, hand.thumb_zero);
  const double y = glm::dot(bone, hand.thumb_out);
  return {arc_tangent(y, x), arc_tangent(glm::dot(bone, hand.frame.palm), std::sqrt(x * x + y * y)), 0.0};
}

}  // namespace

ArmNodes arm_nodes(const Skeleton& skeleton, Side side) {
  const size_t first = kFirstArmName + (side == Side::kLeft ? 0 : kNamesPerArm);
  ArmNodes nodes;
  nodes.shoulder = skeleton.named(first);
  nodes.trunk = skeleton.node(nodes.shoulder).parent;
  const int above = nodes.trunk == kNoNode ? kNoNode : skeleton.node(nodes.trunk).parent;
  if (above != kNoNode && skeleton.node(nodes.trunk).name == kClavicleNames[side == Side::kLeft ? 0 : 1]) {
    nodes.clavicle = nodes.trunk;
    nodes.trunk = above;
  }
  nodes.elbow = skeleton.named(first + 1);
  nodes.wrist = skeleton.named(first + 2);
  for (size_t digit = 0; digit < 5; ++digit)
    for (size_t joint = 0; joint < 3; ++joint)
      nodes.digits[digit][joint] = skeleton.named(first + 3 + 3 * digit + joint);
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
  hand.thumb_pad = pad_of(thumb_directions(hand, sphere_of_bone(hand, hand.thumb_bone)), kPadAtZero);
  const Vec3 phalanx = bone(0, 1, hand.thumb_bone);
  hand.thumb_mp_straight = rotation_between(phalanx, hand.thumb_bone);
  hand.thumb_mp_axis = glm::cross(hand.thumb_bone, hand.thumb_pad);
  hand.thumb_ip_axis = glm::conjugate(hand.thumb_mp_straight) * hand.thumb_mp_axis;
  return hand;
}

Quat thumb_rotation(const HandGeometry& hand, const ThumbCarriage& carriage) {
  const ThumbSphere sphere = sphere_of(carriage);
  const ThumbDirections to = thumb_directions(hand, sphere);
  return rotation_between_frames(hand.thumb_bone, hand.thumb_pad, to.bone, pad_of(to, sphere.roll));
}

ThumbCarriage thumb_carriage(const HandGeometry& hand, const Quat& local) {
  ThumbSphere sphere = sphere_of_bone(hand, local * hand.thumb_bone);
  const ThumbDirections directions = thumb_directions(hand, sphere);
  const Vec3 pad = local * hand.thumb_pad;
  sphere.roll = arc_tangent(glm::dot(pad, directions.to_palm), glm::dot(pad, directions.to_index));
  return carriage_of(sphere);
}

namespace {

DigitRotations rotations_of(const HandGeometry& hand, const HandAngles& angles) {
  DigitRotations rotation;
  for (size_t finger = 0; finger < 4; ++finger) {
    const FingerAxes& axes = hand.fingers[finger];
    const DigitAngles& digit = angles.fingers[finger];
    const double freedom = 1.0 - 0.75 * smooth_step(kSpreadFadeStart, kSpreadFadeEnd, digit.mcp);
    const double spread = axes.outward * digit.abduction * freedom - axes.rest_splay;
    rotation[finger + 1] = {axis_angle(hand.spread_axis, spread) * axis_angle(axes.bend[0], digit.mcp),
                            axis_angle(axes.bend[1], digit.pip), axis_angle(axes.bend[2], digit.dip)};
  }
  const ThumbPose& thumb = angles.thumb;
  rotation[0] = {thumb_rotation(hand, {thumb.radial_abduction, thumb.palmar_abduction, thumb.opposition}),
                 axis_angle(hand.thumb_mp_axis, thumb.mp) * hand.thumb_mp_straight,
                 axis_angle(hand.thumb_ip_axis, thumb.ip)};
  return rotation;
}

}  // namespace

HandRig::HandRig(const Skeleton& skeleton, Side side)
    : geometry_(std::make_shared<const HandGeometry>(hand_geometry(skeleton, arm_nodes(skeleton, side), side))) {}

DigitRotations HandRig::rotations(const HandAngles& angles) const {
  return rotations_of(*geometry_, angles);
}

void pose_hand(const Skeleton& skeleton, Side side, const HandAngles& angles, Pose& pose) {
  const ArmNodes nodes = arm_nodes(skeleton, side);
  const DigitRotations rotation = rotations_of(hand_geometry(skeleton, nodes, side), angles);
  for (size_t digit = 0; digit < 5; ++digit)
    for (size_t joint = 0; joint < 3; ++joint)
      pose.rotation[static_cast<size_t>(nodes.digits[digit][joint])] = rotation[digit][joint];
}

Vec3 rest_thumb_pad(const Skeleton& skeleton, Side side) {
  return hand_geometry(skeleton, arm_nodes(skeleton, side), side).thumb_pad;
}

}  // namespace auslan
