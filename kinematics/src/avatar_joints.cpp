// SPDX-License-Identifier: Apache-2.0
// Joints of a foreign figure: where they are, and how they turn into the rest pose of the project's skeleton.
#include "avatar_fit.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace auslan::fit {
namespace {

using enum HumanRole;

/// A digit as a person of average build has it, as shares of the distance from wrist to the middle finger's knuckle.
/// Buryanov & Kotiuk 2010 (Int J Morphol 28:755), as in the table of the built-in figure.
struct DigitProportion {
  double along, back, radial;  ///< of the first joint, from the wrist
  double bones[3];             ///< to the next joint; the last to the tip
};
constexpr std::array<DigitProportion, 5> kHand = {{{0.221, -0.074, 0.232, {0.487, 0.333, 0.289}},
                                                   {0.959, 0.005, 0.327, {0.419, 0.236, 0.209}},
                                                   {0.998, 0.021, 0.105, {0.470, 0.277, 0.225}},
                                                   {0.922, 0.005, -0.116, {0.436, 0.271, 0.224}},
                                                   {0.827, -0.026, -0.332, {0.345, 0.191, 0.211}}}};
constexpr std::array<std::string_view, 5> kDigitNames = {"thumb", "index finger", "middle finger", "ring finger",
                                                         "little finger"};
/// A hand without any finger bone, as a share of the forearm.
constexpr double kPalmOfForearm = 0.373;

Vec3 perpendicular_part(const Vec3& v, const Vec3& unit_axis) {
  return v - unit_axis * glm::dot(v, unit_axis);
}

/// Axes of a hand: along the fingers, out of its back, to the thumb's side; unit, at right angles.
struct HandAxes {
  Vec3 along, back, radial;
};

HandAxes hand_axes(const Vec3& along, const Vec3& to_radial, Side side) {
  HandAxes axes;
  axes.along = along;
  const Vec3 other = std::fabs(along.z) < 0.9 ? Vec3(0.0, 0.0, 1.0) : Vec3(0.0, 1.0, 0.0);
  axes.radial = unit(perpendicular_part(to_radial, along), unit(perpendicular_part(other, along)));
  axes.back = glm::cross(axes.radial, axes.along) * sign_of(side);
  return axes;
}

/// The digits that a hand lacks, and those that lack joints.
struct Gaps {
  std::vector<std::string> gone, shortened;
};

struct Finder {
  const Avatar& avatar;
  std::span<const glm::dmat4> world_from_node;
  std::span<const AvatarPoser::Part> parts;
  std::span<const Skin> skins;
  Joints& joints;
  std::vector<std::string>& warnings;
  std::array<Gaps, 2> gaps = {};

  bool take(int node, HumanRole role) {
    const int found = avatar.node_of(role);
    if (found == kNoNode) return false;
    set(node, Vec3(world_from_node[static_cast<size_t>(found)][3]));
    joints.is_known[static_cast<size_t>(node)] = true;
    return true;
  }
  void set(int node, const Vec3& place) { joints.place[static_cast<size_t>(node)] = place; }
  const Vec3& at(int node) const { return joints.place[static_cast<size_t>(node)]; }
  bool is_known(int node) const { return joints.is_known[static_cast<size_t>(node)]; }

  /// How far the surface of a node reaches from a place along a direction; 0 without one.
  double extent(int node, const Vec3& from, const Vec3& along) const {
    double farthest = 0.0;
    for (size_t p = 0; p < parts.size(); ++p)
      for (size_t i = 0; i < parts[p].positions.size(); ++i)
        if (skins[p].driver[i] == node)
          farthest = std::max(farthest, glm::dot(Vec3(parts[p].positions[i]) - from, along));
    return farthest;
  }

  void trunk() {
    const Vec3 shoulders = 0.5 * (at(named_arm(Side::kLeft).shoulder) + at(named_arm(Side::kRight).shoulder));
    take(2, kHead);
    const Vec3 up = unit(at(2) - shoulders, Vec3(0.0, 1.0, 0.0));
    // Where the trunk turns: the lowest bone that is well below the shoulders.
    constexpr double kLeastTrunk = 0.2 * kSigningArmLength;
    constexpr double kUsualTrunk = 0.705 * kSigningArmLength;
    bool has_base = false;
    for (const HumanRole role : {kHips, kSpine, kChest}) {
      if (!take(0, role)) continue;
      has_base = shoulders.y - at(0).y > kLeastTrunk;
      // Hips are where the legs begin; the trunk bends above them, in the loins.
      constexpr double kLoins = 0.15;
      if (has_base && role == kHips) set(0, at(0) + (shoulders - at(0)) * kLoins);
      if (has_base) break;
    }
    if (!has_base) {
      set(0, shoulders - Vec3(0.0, kUsualTrunk, 0.0));
      warnings.emplace_back("the hips are missing; the trunk turns about a place below the shoulders");
    }
    if (!take(1, kNeck)) {
      set(1, shoulders + 0.4 * (at(2) - shoulders));
      warnings.emplace_back("the neck is missing; the head alone nods and turns");
    }
    // A neck that is no longer than nothing would have no direction.
    if (!(length(at(1) - at(0)) > 1e-3)) set(1, shoulders);
    if (!(length(at(2) - at(1)) > 1e-3)) set(2, at(1) + up * 0.05);
  }

  void hand(Side side) {
    const ArmNodes arm = named_arm(side);
    const Vec3 wrist = at(arm.wrist);
    for (size_t digit = 0; digit < 5; ++digit)
      for (size_t joint = 0; joint < 3; ++joint)
        take(arm.digits[digit][joint], digit_role(side, digit, joint));
    // A first joint that lies on the wrist tells nothing.
    for (size_t digit = 0; digit < 5; ++digit) {
      const auto first = static_cast<size_t>(arm.digits[digit][0]);
      if (length(at(arm.digits[digit][0]) - wrist) < 1e-3) joints.is_known[first] = false;
    }
    const HandAxes axes = first_axes(arm, wrist, side);
    const double palm = palm_length(arm, wrist);
    for (size_t digit = 1; digit < 5; ++digit)
      if (!is_known(arm.digits[digit][0])) set(arm.digits[digit][0], knuckle(arm, digit, wrist, axes, palm));
    if (!is_known(arm.digits[0][0])) {
      const DigitProportion& usual = kHand[0];
      set(arm.digits[0][0],
          wrist + (axes.along * usual.along + axes.back * usual.back + axes.radial * usual.radial) * palm);
    }
    Gaps& gaps_of_hand = gaps[side == Side::kLeft ? 0 : 1];
    for (size_t digit = 0; digit < 5; ++digit) {
      const std::array<int, 3>& nodes = arm.digits[digit];
      const auto known = std::ranges::count_if(nodes, [&](int node) { return is_known(node); });
      if (known == 0) gaps_of_hand.gone.emplace_back(kDigitNames[digit]);
      if (known == 1 || known == 2) gaps_of_hand.shortened.emplace_back(kDigitNames[digit]);
      phalanges(arm, digit, axes, palm);
    }
  }

  /// Tells what hands lack, of both at once where they lack the same.
  void tell_gaps() {
    const auto tell = [&](const std::string& hands, const std::vector<std::string>& names, const char* one,
                          const char* many) {
      if (names.empty()) return;
      std::string list;
      for (size_t i = 0; i < names.size(); ++i)
        list += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
      warnings.push_back("of " + hands + " the " + list + (names.size() == 1 ? one : many));
    };
    const auto tell_both = [&](std::vector<std::string> Gaps::*list, const char* one, const char* many) {
      if (gaps[0].*list == gaps[1].*list) return tell("both hands", gaps[0].*list, one, many);
      tell("the left hand", gaps[0].*list, one, many);
      tell("the right hand", gaps[1].*list, one, many);
    };
    tell_both(&Gaps::gone, " is missing; signs are solved as if it were there, and it is not drawn",
              " are missing; signs are solved as if they were there, and they are not drawn");
    tell_both(&Gaps::shortened, " is short of joints; it bends in those that it has",
              " are short of joints; they bend in those that they have");
  }

  HandAxes first_axes(const ArmNodes& arm, const Vec3& wrist, Side side) const {
    const Vec3 forearm = unit(wrist - at(arm.elbow), Vec3(sign_of(side), 0.0, 0.0));
    Vec3 sum(0.0);
    std::optional<Vec3> first, last;
    for (size_t digit = 1; digit < 5; ++digit) {
      if (!is_known(arm.digits[digit][0])) continue;
      const Vec3 knuckle = at(arm.digits[digit][0]) - wrist;
      sum += knuckle;
      if (!first) first = knuckle;
      last = knuckle;
    }
    const Vec3 along = unit(sum, forearm);
    Vec3 radial = first && length(*first - *last) > 1e-3 ? *first - *last : Vec3(0.0, 0.0, 1.0);
    if (!(first && length(*first - *last) > 1e-3) && is_known(arm.digits[0][0])) radial = at(arm.digits[0][0]) - wrist;
    return hand_axes(along, radial, side);
  }

  double palm_length(const ArmNodes& arm, const Vec3& wrist) const {
    double sum = 0.0;
    int count = 0;
    for (size_t digit = 1; digit < 5; ++digit) {
      if (!is_known(arm.digits[digit][0])) continue;
      const DigitProportion& usual = kHand[digit];
      sum += length(at(arm.digits[digit][0]) - wrist) / length(Vec3(usual.along, usual.back, usual.radial));
      ++count;
    }
    return count > 0 ? sum / count : kPalmOfForearm * length(wrist - at(arm.elbow));
  }

  /// A missing knuckle: between its neighbours, else where people have it.
  Vec3 knuckle(const ArmNodes& arm, size_t digit, const Vec3& wrist, const HandAxes& axes, double palm) const {
    size_t before = digit;
    while (before > 1 && !is_known(arm.digits[before][0]))
      --before;
    size_t after = digit;
    while (after < 4 && !is_known(arm.digits[after][0]))
      ++after;
    if (is_known(arm.digits[before][0]) && is_known(arm.digits[after][0])) {
      const double share = (kHand[before].radial - kHand[digit].radial) / (kHand[before].radial - kHand[after].radial);
      return at(arm.digits[before][0]) + (at(arm.digits[after][0]) - at(arm.digits[before][0])) * share;
    }
    const DigitProportion& usual = kHand[digit];
    return wrist + (axes.along * usual.along + axes.back * usual.back + axes.radial * usual.radial) * palm;
  }

  /// The joints of a digit behind its first.
  void phalanges(const ArmNodes& arm, size_t digit, const HandAxes& axes, double palm) {
    const std::array<int, 3>& nodes = arm.digits[digit];
    const DigitProportion& usual = kHand[digit];
    // The thumb as people hold it: out to the side, a little to the palm.
    Vec3 along = digit == 0 ? unit(axes.along * 0.72 + axes.radial * 0.67 - axes.back * 0.17) : axes.along;
    for (size_t joint = 1; joint < 3; ++joint) {
      const Vec3 before = at(nodes[joint - 1]);
      if (is_known(nodes[joint]) && length(at(nodes[joint]) - before) > 1e-3) {
        along = unit(at(nodes[joint]) - before);
        continue;
      }
      double bone = usual.bones[joint - 1] * palm;
      double rest = usual.bones[joint - 1];
      for (size_t next = joint; next < 3; ++next)
        rest += usual.bones[next];
      // The bone before has the surface of all that follow.
      const double reach = extent(nodes[joint - 1], before, along);
      if (is_known(nodes[joint - 1]) && reach > 0.3 * bone) bone = reach * usual.bones[joint - 1] / rest;
      set(nodes[joint], before + along * bone);
      joints.is_known[static_cast<size_t>(nodes[joint])] = false;
    }
  }
};

/// The rotation about `axis` that brings `from` nearest to `to`, radians.
double roll_between(const Vec3& from, const Vec3& to, const Vec3& axis) {
  const Vec3 a = perpendicular_part(from, axis);
  const Vec3 b = perpendicular_part(to, axis);
  return arc_tangent(glm::dot(glm::cross(a, b), axis), glm::dot(a, b));
}

/// Sets a node's rotation; its place is where its parent's takes it.
void turn(const Joints& joints, int node, const Quat& rotation, std::array<Transform, kNodes>& placed) {
  const Vec3& place = joints.place[static_cast<size_t>(node)];
  const int parent = parent_of(node);
  const Vec3 moved = parent == kNoNode ? place : apply(placed[static_cast<size_t>(parent)], place);
  placed[static_cast<size_t>(node)] = {rotation, moved - rotation * place};
}

}  // namespace

Joints find_joints(const Avatar& avatar, std::span<const glm::dmat4> world_from_node,
                   std::span<const AvatarPoser::Part> parts, std::span<const Skin> skins,
                   std::vector<std::string>& warnings) {
  Joints joints;
  Finder finder{avatar, world_from_node, parts, skins, joints, warnings};
  for (size_t s = 0; s < 2; ++s) {
    const ArmNodes arm = named_arm(side_of(s));
    finder.take(arm.shoulder, s == 0 ? kLeftUpperArm : kRightUpperArm);
    finder.take(arm.elbow, s == 0 ? kLeftLowerArm : kRightLowerArm);
    finder.take(arm.wrist, s == 0 ? kLeftHand : kRightHand);
  }
  finder.trunk();
  finder.hand(Side::kLeft);
  finder.hand(Side::kRight);
  finder.tell_gaps();
  return joints;
}

std::array<Transform, kNodes> pose_for_rest(const Joints& joints, std::span<const AvatarPoser::Part> parts,
                                            std::span<const Skin> skins) {
  std::array<Transform, kNodes> placed;
  const auto at = [&](int node) { return joints.place[static_cast<size_t>(node)]; };
  for (int node = 0; node < 3; ++node)
    turn(joints, node, kIdentity, placed);
  for (size_t s = 0; s < 2; ++s) {
    const Side side = side_of(s);
    const ArmNodes arm = named_arm(side);
    const Vec3 outward(sign_of(side), 0.0, 0.0);
    const Vec3 forward(0.0, 0.0, 1.0);
    const HandAxes hand = hand_axes(unit(at(arm.digits[2][0]) - at(arm.wrist), outward),
                                    at(arm.digits[1][0]) - at(arm.digits[4][0]), side);
    const Quat wrist = rotation_between_frames(hand.along, hand.radial, outward, forward);

    const Vec3 upper = unit(at(arm.elbow) - at(arm.shoulder), outward);
    const Vec3 fore = unit(at(arm.wrist) - at(arm.elbow), upper);
    Quat shoulder = rotation_between(upper, outward);
    Quat elbow = rotation_between(shoulder * fore, outward) * shoulder;
    // What the palm then lacks of facing down. An elbow that is bent at rest tells how the upper arm is rolled; a
    // straight one is taken to have its crook where the hand says.
    const double hand_roll = roll_between(elbow * hand.radial, forward, outward);
    double arm_roll = hand_roll;
    constexpr double kBent = 0.25;  // sine
    const Vec3 bend = perpendicular_part(fore, upper);
    if (length(bend) > kBent) arm_roll = roll_between(shoulder * bend, forward, outward);
    shoulder = axis_angle(outward, arm_roll) * shoulder;
    elbow = axis_angle(outward, 0.5 * (arm_roll + hand_roll)) * elbow;
    turn(joints, arm.shoulder, shoulder, placed);
    turn(joints, arm.elbow, elbow, placed);
    turn(joints, arm.wrist, wrist, placed);

    for (size_t digit = 0; digit < 5; ++digit) {
      const std::array<int, 3>& nodes = arm.digits[digit];
      std::array<Vec3, 3> bone = {unit(at(nodes[1]) - at(nodes[0]), hand.along),
                                  unit(at(nodes[2]) - at(nodes[1]), hand.along), hand.along};
      // Where the last phalanx points: to the middle of its surface.
      Vec3 sum(0.0);
      for (size_t p = 0; p < parts.size(); ++p)
        for (size_t i = 0; i < parts[p].positions.size(); ++i)
          if (skins[p].driver[i] == nodes[2]) sum += Vec3(parts[p].positions[i]) - at(nodes[2]);
      bone[2] = unit(sum, bone[1]);
      if (!(glm::dot(bone[2], bone[1]) > 0.2)) bone[2] = bone[1];
      Vec3 straight = wrist * bone[0];
      Quat rotation = wrist;
      if (digit != 0) {
        // Into the plane of the palm; the splay stays.
        straight = unit(Vec3(straight.x, 0.0, straight.z), outward);
        if (glm::dot(straight, outward) < 0.5) straight = outward;
        rotation = rotation_between(wrist * bone[0], straight) * wrist;
      }
      turn(joints, nodes[0], rotation, placed);
      if (digit == 0) straight = wrist * bone[1];
      for (size_t joint = 1; joint < 3; ++joint) {
        rotation = rotation_between(rotation * bone[joint], straight) * rotation;
        turn(joints, nodes[joint], rotation, placed);
      }
    }
  }
  return placed;
}

}  // namespace auslan::fit
