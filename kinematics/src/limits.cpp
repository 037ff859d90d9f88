// SPDX-License-Identifier: Apache-2.0
// Norms: American Academy of Orthopaedic Surgeons, "Joint Motion" (1965), as most tables of goniometry quote them.
// Where they are silent or narrower than a closed fist, the line says so.
#include "kinematics/limits.h"

#include "arm_geometry.h"
#include "hand_geometry.h"
#include "kinematics/anatomy.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace auslan {
namespace {

constexpr double kSlack = 5.0;  // what a joint gives beyond its norm in a direction it has no muscles for

constexpr JointLimits degrees(double flexion_low, double flexion_high, double abduction_low, double abduction_high,
                              double twist_low, double twist_high) {
  return {flexion_low * kDegree,    flexion_high * kDegree, abduction_low * kDegree,
          abduction_high * kDegree, twist_low * kDegree,    twist_high * kDegree};
}

// Horizontal adduction (135 degrees with the arm raised by 90) is 64 degrees of adduction beside 64 of flexion.
// Medial rotation is 70 degrees in the norm, with the arm raised sideways; with the arm beside the body it is 95 and
// more (Kapandji, The Physiology of the Joints), and that is where a hand reaches across to the other arm.
constexpr JointLimits kShoulder = degrees(-60, 180, -64, 180, -90, 95);
// Forwards and backwards, up and down, and rolled, as the shoulder blade carries it (Ludewig et al. 2009, Journal of
// Bone and Joint Surgery 91:378; Kapandji: 10 cm of protraction to 3 of retraction at the shoulder's end).
constexpr JointLimits kClavicle = degrees(-15, 20, -5, 20, -kSlack, kSlack);
constexpr JointLimits kElbow = degrees(0, 150, -kSlack, kSlack, -80, 80);
constexpr JointLimits kWrist = degrees(-70, 80, -30, 20, -kSlack, kSlack);

struct Row {
  std::string_view name;  // without the side
  JointLimits limits;
};

constexpr std::array<Row, 22> kTable = {{
    {"spine_base", degrees(-25, 80, -35, 35, -45, 45)},
    // The cervical spine's 45, 45, 45 and 60 are shared by two nodes.
    {"neck_base", degrees(-25, 25, -25, 25, -35, 35)},
    {"head_base", degrees(-25, 25, -25, 25, -35, 35)},
    {"clavicle", kClavicle},
    {"shoulder", kShoulder},
    {"elbow", kElbow},
    {"wrist", kWrist},
    // Adduction past the index and pronation are not in the norms: what the thumb of a closed hand needs.
    {"thumb_cmc", degrees(-20, 70, -15, 70, -20, 110)},
    {"thumb_mp", degrees(-10, 50, -kSlack, kSlack, -kSlack, kSlack)},
    {"thumb_ip", degrees(-20, 80, -kSlack, kSlack, -kSlack, kSlack)},
    {"index_mp", degrees(-45, 90, -20, 20, -15, 15)},
    {"index_pip", degrees(-kSlack, 110, -kSlack, kSlack, -kSlack, kSlack)},  // norm 100; a fist closes at 105
    {"index_dip", degrees(-kSlack, 90, -kSlack, kSlack, -kSlack, kSlack)},
    {"middle_mp", degrees(-45, 90, -20, 20, -15, 15)},
    {"middle_pip", degrees(-kSlack, 110, -kSlack, kSlack, -kSlack, kSlack)},
    {"middle_dip", degrees(-kSlack, 90, -kSlack, kSlack, -kSlack, kSlack)},
    {"ring_mp", degrees(-45, 90, -20, 20, -15, 15)},
    {"ring_pip", degrees(-kSlack, 110, -kSlack, kSlack, -kSlack, kSlack)},
    {"ring_dip", degrees(-kSlack, 90, -kSlack, kSlack, -kSlack, kSlack)},
    // From the ring finger 32 degrees (Chatzioglou 2024), which itself spreads by 14.
    {"little_mp", degrees(-45, 90, -20, 46, -15, 15)},
    {"little_pip", degrees(-kSlack, 110, -kSlack, kSlack, -kSlack, kSlack)},
    {"little_dip", degrees(-kSlack, 90, -kSlack, kSlack, -kSlack, kSlack)},
}};
constexpr size_t kFirstSided = 3;
constexpr size_t kFirstDigit = 7;

struct Place {
  size_t row = kTable.size();
  Side side = Side::kLeft;
};

Place place_of(std::string_view name) {
  for (size_t row = 0; row < kTable.size(); ++row) {
    const std::string_view stem = kTable[row].name;
    if (row < kFirstSided) {
      if (name == stem) return {row, Side::kLeft};
    } else if (name.size() == stem.size() + 2 && name.substr(0, stem.size()) == stem && name[stem.size()] == '_') {
      if (name.back() == 'l') return {row, Side::kLeft};
      if (name.back() == 'r') return {row, Side::kRight};
    }
  }
  return {};
}

bool is_thumb_cmc(const Place& place) {
  return place.row == kFirstDigit;
}

HandGeometry geometry_of(const Skeleton& skeleton, Side side) {
  return hand_geometry(skeleton, arm_nodes(skeleton, side), side);
}

JointAxes digit_axes(const Skeleton& skeleton, const Place& place) {
  const HandGeometry hand = geometry_of(skeleton, place.side);
  const size_t digit = (place.row - kFirstDigit) / 3;
  const size_t joint = (place.row - kFirstDigit) % 3;
  JointAxes axes;
  if (digit == 0) {
    axes.bone = joint == 1 ? hand.thumb_bone : glm::conjugate(hand.thumb_mp_straight) * hand.thumb_bone;
    axes.flexion = joint == 1 ? hand.thumb_mp_axis : hand.thumb_ip_axis;
    axes.zero = joint == 1 ? hand.thumb_mp_straight : kIdentity;
    axes.abduction = glm::cross(axes.bone, axes.flexion);
    return axes;
  }
  const FingerAxes& finger = hand.fingers[digit - 1];
  axes.flexion = finger.bend[joint];
  axes.bone = unit(glm::cross(hand.frame.palm, axes.flexion), finger.bone);
  const Vec3 out = glm::cross(axes.flexion, axes.bone);
  axes.abduction = out * (glm::dot(out, hand.spread_axis) * finger.outward < 0.0 ? -1.0 : 1.0);
  if (joint == 0) axes.zero = axis_angle(hand.spread_axis, -finger.rest_splay);
  if (joint == 0) {
    axes.bone = axes.zero * axes.bone;
    axes.flexion = axes.zero * axes.flexion;
  }
  return axes;
}

JointAxes axes_of(const Skeleton& skeleton, const Place& place) {
  const double sign = place.side == Side::kLeft ? 1.0 : -1.0;
  switch (place.row) {
    case 0:
    case 1:
    case 2:
      // Bowing forwards, bending to the left, turning to the left.
      return {Vec3(0.0, 1.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.0, -1.0), 1.0, kIdentity};
    case 3:
      return clavicle_axes(arm_geometry(skeleton, place.side));
    case 4:
      return shoulder_axes(arm_geometry(skeleton, place.side));
    case 5:
      return elbow_axes(arm_geometry(skeleton, place.side));
    case 6:
      return wrist_axes(rest_hand_frame(skeleton, place.side), sign);
    default:
      return digit_axes(skeleton, place);
  }
}

double within(double x, double low, double high) {
  return x < low ? low : (x > high ? high : x);
}

double excess(double x, double low, double high) {
  return x - within(x, low, high);
}

}  // namespace

JointLimits shoulder_limits() {
  return kShoulder;
}
JointLimits elbow_limits() {
  return kElbow;
}
JointLimits wrist_limits() {
  return kWrist;
}

JointAxes clavicle_axes(const ArmGeometry& arm) {
  const Vec3 outward(arm.side_sign, 0.0, 0.0);
  const Vec3 bone = arm.clavicle_offset ? unit(arm.shoulder_offset - *arm.clavicle_offset, outward) : outward;
  // Forwards about what is nearest to the vertical across the bone; up about what is left.
  const Vec3 upright = unit(Vec3(0.0, 1.0, 0.0) - bone * bone.y, Vec3(0.0, 0.0, 1.0));
  return {bone, upright * -arm.side_sign, glm::cross(bone, upright), arm.side_sign, kIdentity};
}

JointAxes shoulder_axes(const ArmGeometry& arm) {
  const Vec3 down(0.0, -1.0, 0.0);
  return {down, Vec3(-1.0, 0.0, 0.0), Vec3(0.0, 0.0, arm.side_sign), arm.side_sign,
          rotation_between(arm.upper_bone, down)};
}

JointAxes elbow_axes(const ArmGeometry& arm) {
  const Vec3 hinge = unit(arm.hinge - arm.fore_bone * glm::dot(arm.hinge, arm.fore_bone), arm.hinge);
  return {arm.fore_bone, hinge, glm::cross(arm.fore_bone, hinge), arm.side_sign, kIdentity};
}

JointAxes wrist_axes(const HandFrame& hand, double side_sign) {
  return {hand.fingers, glm::cross(hand.fingers, hand.palm), glm::cross(hand.fingers, hand.radial), side_sign,
          kIdentity};
}

JointAngles angles_about(const JointAxes& axes, const Quat& local) {
  const SwingTwist parts = swing_twist(local * glm::conjugate(axes.zero), axes.bone);
  const Vec3 swing = rotation_vector(parts.swing);
  return {glm::dot(swing, axes.flexion), glm::dot(swing, axes.abduction),
          axes.twist_sign * twist_angle(parts.twist, axes.bone)};
}

Quat rotation_about(const JointAxes& axes, const JointAngles& angles) {
  const Quat swing = from_rotation_vector(axes.flexion * angles.flexion + axes.abduction * angles.abduction);
  return swing * axis_angle(axes.bone, axes.twist_sign * angles.twist) * axes.zero;
}

double squared_excess(const JointLimits& limits, const JointAngles& angles) {
  const double flexion = excess(angles.flexion, limits.flexion_low, limits.flexion_high);
  const double abduction = excess(angles.abduction, limits.abduction_low, limits.abduction_high);
  const double twist = excess(angles.twist, limits.twist_low, limits.twist_high);
  return flexion * flexion + abduction * abduction + twist * twist;
}

std::optional<JointLimits> joint_limits(const Skeleton& skeleton, int node) {
  const Place place = place_of(skeleton.node(node).name);
  if (place.row == kTable.size()) return std::nullopt;
  return kTable[place.row].limits;
}

JointAngles joint_angles(const Skeleton& skeleton, int node, const Quat& local) {
  const Place place = place_of(skeleton.node(node).name);
  if (place.row == kTable.size()) return {};
  if (!is_thumb_cmc(place)) return angles_about(axes_of(skeleton, place), local);
  const ThumbCarriage carriage = thumb_carriage(geometry_of(skeleton, place.side), local);
  return {carriage.palmar_abduction, carriage.radial_abduction, carriage.opposition * (kPi / 2.0)};
}

Quat from_joint_angles(const Skeleton& skeleton, int node, const JointAngles& angles) {
  const Place place = place_of(skeleton.node(node).name);
  if (place.row == kTable.size()) return kIdentity;
  if (!is_thumb_cmc(place)) return rotation_about(axes_of(skeleton, place), angles);
  return thumb_rotation(geometry_of(skeleton, place.side),
                        {angles.abduction, angles.flexion, angles.twist / (kPi / 2.0)});
}

double limit_violation(const Skeleton& skeleton, int node, const Quat& local) {
  const std::optional<JointLimits> limits = joint_limits(skeleton, node);
  if (!limits) return 0.0;
  return std::sqrt(squared_excess(*limits, joint_angles(skeleton, node, local)));
}

Quat clamped(const Skeleton& skeleton, int node, const Quat& local) {
  const std::optional<JointLimits> limits = joint_limits(skeleton, node);
  if (!limits) return local;
  const JointAngles angles = joint_angles(skeleton, node, local);
  if (squared_excess(*limits, angles) == 0.0) return local;
  return from_joint_angles(skeleton, node,
                           {within(angles.flexion, limits->flexion_low, limits->flexion_high),
                            within(angles.abduction, limits->abduction_low, limits->abduction_high),
                            within(angles.twist, limits->twist_low, limits->twist_high)});
}

}  // namespace auslan
