// SPDX-License-Identifier: Apache-2.0
#include "kinematics/avatar.h"

#include <algorithm>
#include <optional>
#include <span>

namespace auslan {
namespace {

std::string letters_of(std::string_view name) {
  if (const size_t dot = name.rfind('.'); dot != std::string_view::npos && dot + 2 < name.size())
    name.remove_prefix(dot + 1);
  std::string letters;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z')
      letters += static_cast<char>(c - 'A' + 'a');
    else if (c >= 'a' && c <= 'z')
      letters += c;
  }
  return letters;
}

/// Whether a morph target or expression is named as ARKit names the channel: "eyeBlinkLeft", "EyeBlink_L",
/// "face.eyeBlinkLeft".
bool is_named(std::string_view name, std::string_view channel) {
  constexpr size_t kLongest = 256;
  if (name.size() > kLongest) return false;
  const std::string found = letters_of(name);
  const std::string expected = letters_of(channel);
  if (found == expected) return true;
  for (const std::string_view side : {"left", "right"})
    if (expected.ends_with(side)) return found == expected.substr(0, expected.size() - side.size()) + side.front();
  return false;
}

/// A morph target that comes near a channel; `share` is the weight that a full channel gives. One target for both sides
/// of the face gets half from each channel.
struct FaceUnit {
  FaceChannel channel;
  std::string_view morph;
  double share;
};

using enum FaceChannel;

// clang-format off
constexpr FaceUnit kMakeHumanUnits[] = {  // face pose units
    {kBrowInnerUp, "LeftInnerBrowUp", 1.0}, {kBrowInnerUp, "RightInnerBrowUp", 1.0},
    {kBrowOuterUpLeft, "LeftOuterBrowUp", 1.0}, {kBrowOuterUpRight, "RightOuterBrowUp", 1.0},
    {kBrowDownLeft, "LeftBrowDown", 1.0}, {kBrowDownRight, "RightBrowDown", 1.0},
    {kEyeBlinkLeft, "LeftUpperLidClosed", 1.0}, {kEyeBlinkRight, "RightUpperLidClosed", 1.0},
    {kEyeWideLeft, "LeftUpperLidOpen", 1.0}, {kEyeWideRight, "RightUpperLidOpen", 1.0},
    {kJawOpen, "JawDrop", 1.0}, {kMouthPucker, "LipsKiss", 1.0},
    {kMouthSmileLeft, "MouthLeftPullUp", 1.0}, {kMouthSmileRight, "MouthRightPullUp", 1.0},
    {kMouthFrownLeft, "MouthLeftPullDown", 1.0}, {kMouthFrownRight, "MouthRightPullDown", 1.0},
    {kMouthStretchLeft, "MouthLeftPullSide", 1.0}, {kMouthStretchRight, "MouthRightPullSide", 1.0},
    {kMouthLowerDownLeft, "lowerLipDown", 0.5}, {kMouthLowerDownRight, "lowerLipDown", 0.5},
    {kMouthUpperUpLeft, "UpperLipUp", 0.5}, {kMouthUpperUpRight, "UpperLipUp", 0.5},
    {kCheekPuff, "CheeksPump", 1.0}, {kTongueOut, "TongueOut", 1.0},
    {kEyeLookUpLeft, "LeftEyeUp", 1.0}, {kEyeLookUpRight, "RightEyeUp", 1.0},
    {kEyeLookDownLeft, "LeftEyeDown", 1.0}, {kEyeLookDownRight, "RightEyeDown", 1.0},
    {kEyeLookInLeft, "LeftEyeturnRight", 1.0}, {kEyeLookInRight, "RightEyeturnLeft", 1.0},
    {kEyeLookOutLeft, "LeftEyeturnLeft", 1.0}, {kEyeLookOutRight, "RightEyeturnRight", 1.0},
    {kEyeSquintLeft, "LeftLowerLidUp", 1.0}, {kEyeSquintRight, "RightLowerLidUp", 1.0},
    {kNoseSneerLeft, "NoseWrinkler", 0.5}, {kNoseSneerRight, "NoseWrinkler", 0.5},
    {kMouthLeft, "MouthMoveLeft", 1.0}, {kMouthRight, "MouthMoveRight", 1.0},
    {kMouthRollUpper, "UpperLipBackward", 1.0}, {kMouthRollLower, "lowerLipBackward", 1.0},
    {kMouthShrugLower, "lowerLipUp", 1.0}, {kJawForward, "ChinForward", 1.0},
    {kJawLeft, "ChinLeft", 1.0}, {kJawRight, "ChinRight", 1.0},
    {kCheekSuckLeft, "CheeksSuck", 0.5}, {kCheekSuckRight, "CheeksSuck", 0.5},
    {kTongueUp, "TongueUp", 1.0}, {kTongueLeft, "TongueLeft", 1.0}, {kTongueRight, "TongueRight", 1.0}};
constexpr FaceUnit kVroidUnits[] = {  // VRoid Studio, most often behind a prefix: "Face.M_F00_000_00_Fcl_MTH_A"
    {kBrowInnerUp, "Fcl_BRW_Sorrow", 1.0},
    {kBrowOuterUpLeft, "Fcl_BRW_Surprised", 0.5}, {kBrowOuterUpRight, "Fcl_BRW_Surprised", 0.5},
    {kBrowDownLeft, "Fcl_BRW_Angry", 0.5}, {kBrowDownRight, "Fcl_BRW_Angry", 0.5},
    {kEyeBlinkLeft, "Fcl_EYE_Close_L", 1.0}, {kEyeBlinkRight, "Fcl_EYE_Close_R", 1.0},
    {kEyeWideLeft, "Fcl_EYE_Spread", 0.5}, {kEyeWideRight, "Fcl_EYE_Spread", 0.5},
    {kJawOpen, "Fcl_MTH_A", 1.0}, {kMouthPucker, "Fcl_MTH_U", 1.0}, {kMouthFunnel, "Fcl_MTH_O", 1.0},
    {kMouthStretchLeft, "Fcl_MTH_I", 0.5}, {kMouthStretchRight, "Fcl_MTH_I", 0.5},
    {kMouthSmileLeft, "Fcl_MTH_Fun", 0.5}, {kMouthSmileRight, "Fcl_MTH_Fun", 0.5},
    {kMouthFrownLeft, "Fcl_MTH_Down", 0.5}, {kMouthFrownRight, "Fcl_MTH_Down", 0.5}};
constexpr FaceUnit kVisemeUnits[] = {  // Oculus visemes and what Ready Player Me puts beside them
    {kJawOpen, "mouthOpen", 1.0}, {kJawOpen, "viseme_aa", 1.0},
    {kMouthPucker, "viseme_U", 1.0}, {kMouthFunnel, "viseme_O", 1.0},
    {kMouthStretchLeft, "viseme_I", 0.5}, {kMouthStretchRight, "viseme_I", 0.5},
    {kMouthPressLeft, "viseme_PP", 0.5}, {kMouthPressRight, "viseme_PP", 0.5},
    {kMouthSmileLeft, "mouthSmile", 0.5}, {kMouthSmileRight, "mouthSmile", 0.5},
    {kEyeBlinkLeft, "eyesClosed", 0.5}, {kEyeBlinkRight, "eyesClosed", 0.5}};
// clang-format on
constexpr std::array<std::span<const FaceUnit>, 3> kFaceUnits = {kMakeHumanUnits, kVroidUnits, kVisemeUnits};

/// Whether a name is that of a unit, alone or behind a prefix that ends in a mark.
bool is_unit(std::string_view name, std::string_view unit) {
  if (!name.ends_with(unit)) return false;
  const size_t before = name.size() - unit.size();
  return before == 0 || std::string_view("._:").find(name[before - 1]) != std::string_view::npos;
}

/// Expressions of VRM that come near a channel, the nearest first. They move more of the face than the channel does.
struct Stand {
  FaceChannel channel;
  std::string_view expression;
};
constexpr std::array<Stand, 27> kStands = {{{kEyeBlinkLeft, "blinkLeft"},
                                            {kEyeBlinkRight, "blinkRight"},
                                            {kEyeBlinkLeft, "blink"},
                                            {kEyeBlinkRight, "blink"},
                                            {kJawOpen, "aa"},
                                            {kMouthPucker, "ou"},
                                            {kMouthFunnel, "oh"},
                                            {kMouthStretchLeft, "ih"},
                                            {kMouthStretchRight, "ih"},
                                            {kMouthSmileLeft, "happy"},
                                            {kMouthSmileRight, "happy"},
                                            {kMouthFrownLeft, "sad"},
                                            {kMouthFrownRight, "sad"},
                                            {kBrowDownLeft, "angry"},
                                            {kBrowDownRight, "angry"},
                                            {kBrowInnerUp, "surprised"},
                                            {kEyeWideLeft, "surprised"},
                                            {kEyeWideRight, "surprised"},
                                            {kBrowInnerUp, "sad"},
                                            {kEyeLookUpLeft, "lookUp"},
                                            {kEyeLookUpRight, "lookUp"},
                                            {kEyeLookDownLeft, "lookDown"},
                                            {kEyeLookDownRight, "lookDown"},
                                            {kEyeLookOutLeft, "lookLeft"},
                                            {kEyeLookInRight, "lookLeft"},
                                            {kEyeLookInLeft, "lookRight"},
                                            {kEyeLookOutRight, "lookRight"}}};

bool is_sided_face_channel(FaceChannel channel) {
  const std::string_view name = kFaceChannelNames[static_cast<size_t>(channel)];
  return name.ends_with("Left") || name.ends_with("Right");
}

void add_binds(const Avatar& avatar, FaceDrive& drive, double share, auto is_wanted) {
  for (size_t m = 0; m < avatar.meshes.size(); ++m)
    for (size_t i = 0; i < avatar.meshes[m].morph_names.size(); ++i) {
      const std::string& name = avatar.meshes[m].morph_names[i];
      if (!is_wanted(name)) continue;
      drive.means = FaceDrive::Means::kMorph;
      if (drive.source.empty()) drive.source = name;
      drive.binds.push_back({.mesh = static_cast<int>(m), .morph = static_cast<int>(i), .weight = share});
    }
}

/// Lips that an expression shapes do not open a jaw that has a morph target of its own: its channel does.
void leave_jaw_out(const FaceDrive& jaw, FaceDrive& drive) {
  if (jaw.means != FaceDrive::Means::kMorph) return;
  std::erase_if(drive.binds, [&](const MorphBind& bind) {
    return std::ranges::any_of(
        jaw.binds, [&](const MorphBind& each) { return each.mesh == bind.mesh && each.morph == bind.morph; });
  });
  if (drive.binds.empty()) drive = {};
}

void drive_by_expression(const AvatarExpression& expression, double share, FaceDrive& drive) {
  if (expression.binds.empty() || drive.means != FaceDrive::Means::kNone) return;
  drive = {.means = FaceDrive::Means::kExpression, .source = expression.name, .binds = expression.binds};
  for (MorphBind& bind : drive.binds)
    bind.weight *= share;
}

}  // namespace

size_t triangle_count(const Avatar& avatar) {
  size_t triangles = 0;
  for (const AvatarNode& node : avatar.nodes)
    if (node.mesh >= 0)
      for (const AvatarSurface& surface : avatar.meshes[static_cast<size_t>(node.mesh)].surfaces)
        triangles += surface.indices.size() / 3;
  return triangles;
}

void drive_face(Avatar& avatar) {
  for (size_t c = 0; c < kFaceChannelCount; ++c) {
    FaceDrive& drive = avatar.face[c];
    drive = {};
    const std::string_view channel = kFaceChannelNames[c];
    add_binds(avatar, drive, 1.0, [&](std::string_view name) { return is_named(name, channel); });
    if (drive.means != FaceDrive::Means::kNone) continue;
    for (const AvatarExpression& expression : avatar.expressions)
      if (is_named(expression.name, channel)) drive_by_expression(expression, 1.0, drive);
    if (drive.means != FaceDrive::Means::kNone) continue;
    for (const std::span<const FaceUnit> units : kFaceUnits) {
      std::string_view taken;  // of several units for one side of the face, the first that occurs
      for (const FaceUnit& unit : units) {
        if (static_cast<size_t>(unit.channel) != c || (!taken.empty() && unit.channel != kBrowInnerUp)) continue;
        add_binds(avatar, drive, unit.share, [&](std::string_view name) { return is_unit(name, unit.morph); });
        if (!drive.binds.empty()) taken = unit.morph;
      }
      if (drive.means != FaceDrive::Means::kNone) break;
    }
  }
  for (const Stand& stand : kStands) {
    // Both channels of a pair take half of an expression that moves both sides.
    const bool is_half = is_sided_face_channel(stand.channel) && !stand.expression.starts_with("blink");
    FaceDrive& drive = avatar.face[static_cast<size_t>(stand.channel)];
    for (const AvatarExpression& expression : avatar.expressions)
      if (expression.name == stand.expression) drive_by_expression(expression, is_half ? 0.5 : 1.0, drive);
  }
  const auto by_bone = [&](HumanRole role, std::initializer_list<FaceChannel> channels) {
    const int node = avatar.node_of(role);
    if (node == kNoNode) return;
    for (const FaceChannel channel : channels)
      if (FaceDrive& drive = avatar.face[static_cast<size_t>(channel)]; drive.means == FaceDrive::Means::kNone)
        drive = {.means = FaceDrive::Means::kBone, .source = avatar.nodes[static_cast<size_t>(node)].name, .binds = {}};
  };
  by_bone(HumanRole::kLeftEye, {kEyeLookUpLeft, kEyeLookDownLeft, kEyeLookInLeft, kEyeLookOutLeft});
  by_bone(HumanRole::kRightEye, {kEyeLookUpRight, kEyeLookDownRight, kEyeLookInRight, kEyeLookOutRight});
  by_bone(HumanRole::kJaw, {kJawOpen});
  for (const FaceChannel lips : {kMouthPucker, kMouthFunnel, kMouthStretchLeft, kMouthStretchRight})
    if (FaceDrive& drive = avatar.face[static_cast<size_t>(lips)]; drive.means == FaceDrive::Means::kExpression)
      leave_jaw_out(avatar.face[static_cast<size_t>(kJawOpen)], drive);
}

}  // namespace auslan
