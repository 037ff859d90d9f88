// SPDX-License-Identifier: Apache-2.0
// The parts of a human body that a foreign figure's nodes may stand for, named as VRM 1.0 names its human bones; and
// the names that well-known rigs give them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace auslan {

/// In the order of kHumanRoleNames. Of each hand fifteen, thumb to little finger, from the palm to the tip.
enum class HumanRole : uint8_t {
  // clang-format off
  kHips, kSpine, kChest, kUpperChest, kNeck, kHead, kLeftEye, kRightEye, kJaw,
  kLeftUpperLeg, kLeftLowerLeg, kLeftFoot, kLeftToes, kRightUpperLeg, kRightLowerLeg, kRightFoot, kRightToes,
  kLeftShoulder, kLeftUpperArm, kLeftLowerArm, kLeftHand, kRightShoulder, kRightUpperArm, kRightLowerArm, kRightHand,
  kLeftThumbMetacarpal, kLeftThumbProximal, kLeftThumbDistal,
  kLeftIndexProximal, kLeftIndexIntermediate, kLeftIndexDistal,
  kLeftMiddleProximal, kLeftMiddleIntermediate, kLeftMiddleDistal,
  kLeftRingProximal, kLeftRingIntermediate, kLeftRingDistal,
  kLeftLittleProximal, kLeftLittleIntermediate, kLeftLittleDistal,
  kRightThumbMetacarpal, kRightThumbProximal, kRightThumbDistal,
  kRightIndexProximal, kRightIndexIntermediate, kRightIndexDistal,
  kRightMiddleProximal, kRightMiddleIntermediate, kRightMiddleDistal,
  kRightRingProximal, kRightRingIntermediate, kRightRingDistal,
  kRightLittleProximal, kRightLittleIntermediate, kRightLittleDistal,
  // clang-format on
};
inline constexpr int kHumanRoleCount = 55;

/// The spelling of VRM 1.0 ("leftIndexProximal"), in enum order.
inline constexpr std::array<std::string_view, kHumanRoleCount> kHumanRoleNames = {
    // clang-format off
    "hips", "spine", "chest", "upperChest", "neck", "head", "leftEye", "rightEye", "jaw",
    "leftUpperLeg", "leftLowerLeg", "leftFoot", "leftToes", "rightUpperLeg", "rightLowerLeg", "rightFoot", "rightToes",
    "leftShoulder", "leftUpperArm", "leftLowerArm", "leftHand",
    "rightShoulder", "rightUpperArm", "rightLowerArm", "rightHand",
    "leftThumbMetacarpal", "leftThumbProximal", "leftThumbDistal",
    "leftIndexProximal", "leftIndexIntermediate", "leftIndexDistal",
    "leftMiddleProximal", "leftMiddleIntermediate", "leftMiddleDistal",
    "leftRingProximal", "leftRingIntermediate", "leftRingDistal",
    "leftLittleProximal", "leftLittleIntermediate", "leftLittleDistal",
    "rightThumbMetacarpal", "rightThumbProximal", "rightThumbDistal",
    "rightIndexProximal", "rightIndexIntermediate", "rightIndexDistal",
    "rightMiddleProximal", "rightMiddleIntermediate", "rightMiddleDistal",
    "rightRingProximal", "rightRingIntermediate", "rightRingDistal",
    "rightLittleProximal", "rightLittleIntermediate", "rightLittleDistal",
    // clang-format on
};

/// The role of that VRM 1.0 name, or nothing.
std::optional<HumanRole> human_role(std::string_view name);
inline std::string_view name_of(HumanRole role) {
  return kHumanRoleNames[static_cast<size_t>(role)];
}

/// Index of the node that plays each role, kNoNode (-1) where none does.
using HumanNodes = std::array<int, kHumanRoleCount>;

struct NodeName {
  std::string_view name;
  bool is_bone = true;  ///< false: may only tell the side, as the node of a mesh
};

/// What the names of nodes tell.
struct NamedHumanoid {
  std::string_view rig;  ///< "Mixamo", "Unreal", ...; empty when no rig's names were recognised
  HumanNodes node;
};

/// Compares the names of all nodes with those of the rigs known here and takes the rig that explains most roles; fewer
/// than four are taken for chance. Capitals, separators, prefixes as "mixamorig:", words before or after as in
/// "Armature_Hand_012" and the way a side is marked do not count. Hands whose nodes do not name their side (WebXR) take
/// it from any other node that does, as "l_handMeshNode".
NamedHumanoid humanoid_from_names(std::span<const NodeName> names);

}  // namespace auslan
