// SPDX-License-Identifier: Apache-2.0
// A pose: one quaternion per node and a weight per face channel; and the one forward loop that turns it into
// placements.
#pragma once

#include "kinematics/skeleton.h"
#include "kinematics/vector.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace auslan {

/// Face channels, named as ARKit names its blend shapes; the last seven, which ARKit lacks, after their like. Weights
/// run from 0 (rest) to 1. Left and right are the signer's.
enum class FaceChannel {
  kBrowInnerUp,
  kBrowOuterUpLeft,
  kBrowOuterUpRight,
  kBrowDownLeft,
  kBrowDownRight,
  kEyeBlinkLeft,
  kEyeBlinkRight,
  kEyeWideLeft,
  kEyeWideRight,
  kJawOpen,
  kMouthPucker,
  kMouthFunnel,
  kMouthSmileLeft,
  kMouthSmileRight,
  kMouthFrownLeft,
  kMouthFrownRight,
  kMouthStretchLeft,
  kMouthStretchRight,
  kMouthPressLeft,
  kMouthPressRight,
  kMouthLowerDownLeft,
  kMouthLowerDownRight,
  kMouthUpperUpLeft,
  kMouthUpperUpRight,
  kCheekPuff,
  kTongueOut,
  kEyeLookUpLeft,
  kEyeLookUpRight,
  kEyeLookDownLeft,
  kEyeLookDownRight,
  kEyeLookInLeft,
  kEyeLookInRight,
  kEyeLookOutLeft,
  kEyeLookOutRight,
  kEyeSquintLeft,
  kEyeSquintRight,
  kNoseSneerLeft,
  kNoseSneerRight,
  kMouthLeft,
  kMouthRight,
  kMouthRollUpper,
  kMouthRollLower,
  kMouthShrugLower,
  kJawForward,
  kJawLeft,
  kJawRight,
  kCheekPuffLeft,
  kCheekPuffRight,
  kCheekSuckLeft,
  kCheekSuckRight,
  kTongueUp,
  kTongueLeft,
  kTongueRight,
};
inline constexpr int kFaceChannelCount = 53;

/// The ARKit spelling ("browInnerUp"), in enum order.
inline constexpr std::array<std::string_view, kFaceChannelCount> kFaceChannelNames = {
    "browInnerUp",        "browOuterUpLeft",     "browOuterUpRight",  "browDownLeft",      "browDownRight",
    "eyeBlinkLeft",       "eyeBlinkRight",       "eyeWideLeft",       "eyeWideRight",      "jawOpen",
    "mouthPucker",        "mouthFunnel",         "mouthSmileLeft",    "mouthSmileRight",   "mouthFrownLeft",
    "mouthFrownRight",    "mouthStretchLeft",    "mouthStretchRight", "mouthPressLeft",    "mouthPressRight",
    "mouthLowerDownLeft", "mouthLowerDownRight", "mouthUpperUpLeft",  "mouthUpperUpRight", "cheekPuff",
    "tongueOut",          "eyeLookUpLeft",       "eyeLookUpRight",    "eyeLookDownLeft",   "eyeLookDownRight",
    "eyeLookInLeft",      "eyeLookInRight",      "eyeLookOutLeft",    "eyeLookOutRight",   "eyeSquintLeft",
    "eyeSquintRight",     "noseSneerLeft",       "noseSneerRight",    "mouthLeft",         "mouthRight",
    "mouthRollUpper",     "mouthRollLower",      "mouthShrugLower",   "jawForward",        "jawLeft",
    "jawRight",           "cheekPuffLeft",       "cheekPuffRight",    "cheekSuckLeft",     "cheekSuckRight",
    "tongueUp",           "tongueLeft",          "tongueRight"};

/// The right channel of a left one ("mouthSmileLeft"); others are their own.
constexpr FaceChannel right_of(FaceChannel channel) {
  const bool left = kFaceChannelNames[static_cast<size_t>(channel)].ends_with("Left");
  return static_cast<FaceChannel>(static_cast<int>(channel) + (left ? 1 : 0));
}

using FaceWeights = std::array<float, kFaceChannelCount>;

struct Pose {
  std::vector<Quat> rotation;  ///< parent_from_node for each node of the skeleton, unit
  Vec3 root_translation{0.0};  ///< added to the root's rest offset, metres
  FaceWeights face{};          ///< by FaceChannel
};

/// The rest pose of a skeleton: every rotation the identity.
Pose rest_pose(const Skeleton& skeleton);

/// Forward kinematics. `world_from_node` has one element per node. Allocates nothing.
void forward(const Skeleton& skeleton, const Pose& pose, std::span<Transform> world_from_node);

}  // namespace auslan
