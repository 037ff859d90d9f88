// SPDX-License-Identifier: Apache-2.0
#include "kinematics/humanoid.h"

#include "kinematics/skeleton.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace auslan {
namespace {

enum class Side : uint8_t { kNone, kLeft, kRight };

/// A name without its marks: lower-case letters and digits, and the side taken out.
struct PlainName {
  std::string text;
  Side side = Side::kNone;
  bool is_bone = true;
};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// What exporters put before every name of one rig; longest first where one begins another.
constexpr std::array<std::string_view, 7> kPrefixes = {"mixamorig", "jbipc", "jbip", "jadj", "ccbase", "bip01", "def"};

Side side_of_word(std::string_view word) {
  if (word == "l" || word == "left") return Side::kLeft;
  if (word == "r" || word == "right") return Side::kRight;
  return Side::kNone;
}

/// What exporters put round names: "mixamorig:LeftArm_09", "hand.l_Armature", "Character1_LeftArm".
enum class Trim : uint8_t { kNothing, kLastWord, kFirstWord };

PlainName plain(std::string_view name, Trim trim) {
  if (const size_t colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
  PlainName result;
  std::string word;
  size_t before_last_word = 0;
  size_t after_first_word = 0;
  const auto finish_word = [&] {
    if (const Side side = side_of_word(word); side != Side::kNone && result.side == Side::kNone)
      result.side = side;
    else if (!word.empty()) {
      before_last_word = result.text.size();
      result.text += word;
      if (after_first_word == 0) after_first_word = word.size();
    }
    word.clear();
  };
  for (size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!is_letter(c) && !is_digit(c)) {
      finish_word();
      continue;
    }
    // A capital L or R at the very end marks a side that lost its separator: "finger1-1L".
    if ((c == 'L' || c == 'R') && i + 1 == name.size() && i > 0 && lower(name[i - 1]) == name[i - 1]) finish_word();
    word += lower(c);
  }
  finish_word();
  if (trim == Trim::kLastWord && before_last_word > 0) result.text.erase(before_last_word);
  if (trim == Trim::kFirstWord && before_last_word > 0) result.text.erase(0, after_first_word);
  for (const std::string_view prefix : kPrefixes)
    if (result.text.starts_with(prefix) && result.text.size() > prefix.size()) {
      result.text.erase(0, prefix.size());
      break;
    }
  if (result.side != Side::kNone) return result;
  for (const auto& [word_of_side, side] : {std::pair("left", Side::kLeft), std::pair("right", Side::kRight)}) {
    const std::string_view mark = word_of_side;
    if (result.text.size() <= mark.size()) continue;
    if (result.text.starts_with(mark))
      result.text.erase(0, mark.size());
    else if (result.text.ends_with(mark))
      result.text.erase(result.text.size() - mark.size());
    else
      continue;
    result.side = side;
    break;
  }
  return result;
}

/// A role (of a pair, the left one) and what a rig calls it, as plain() leaves it. Of several entries with one role the
/// first that occurs counts.
struct Entry {
  HumanRole role;
  std::string_view name;
};

using enum HumanRole;

// clang-format off
constexpr Entry kMixamo[] = {  // also Ready Player Me
    {kHips, "hips"}, {kSpine, "spine"}, {kChest, "spine1"}, {kUpperChest, "spine2"}, {kNeck, "neck"}, {kHead, "head"},
    {kLeftEye, "eye"}, {kJaw, "jaw"}, {kLeftUpperLeg, "upleg"}, {kLeftLowerLeg, "leg"}, {kLeftFoot, "foot"}, {kLeftToes, "toebase"},
    {kLeftShoulder, "shoulder"}, {kLeftUpperArm, "arm"}, {kLeftLowerArm, "forearm"}, {kLeftHand, "hand"},
    {kLeftThumbMetacarpal, "handthumb1"}, {kLeftThumbProximal, "handthumb2"}, {kLeftThumbDistal, "handthumb3"},
    {kLeftIndexProximal, "handindex1"}, {kLeftIndexIntermediate, "handindex2"}, {kLeftIndexDistal, "handindex3"},
    {kLeftMiddleProximal, "handmiddle1"}, {kLeftMiddleIntermediate, "handmiddle2"}, {kLeftMiddleDistal, "handmiddle3"},
    {kLeftRingProximal, "handring1"}, {kLeftRingIntermediate, "handring2"}, {kLeftRingDistal, "handring3"},
    {kLeftLittleProximal, "handpinky1"}, {kLeftLittleIntermediate, "handpinky2"}, {kLeftLittleDistal, "handpinky3"}};
constexpr Entry kUnreal[] = {  // also MakeHuman's game_engine rig
    {kHips, "pelvis"}, {kSpine, "spine01"}, {kChest, "spine02"}, {kUpperChest, "spine05"}, {kUpperChest, "spine03"},
    {kNeck, "neck01"}, {kHead, "head"}, {kLeftEye, "eye"}, {kJaw, "jaw"},
    {kLeftUpperLeg, "thigh"}, {kLeftLowerLeg, "calf"}, {kLeftFoot, "foot"}, {kLeftToes, "ball"},
    {kLeftShoulder, "clavicle"}, {kLeftUpperArm, "upperarm"}, {kLeftLowerArm, "lowerarm"}, {kLeftHand, "hand"},
    {kLeftThumbMetacarpal, "thumb01"}, {kLeftThumbProximal, "thumb02"}, {kLeftThumbDistal, "thumb03"},
    {kLeftIndexProximal, "index01"}, {kLeftIndexIntermediate, "index02"}, {kLeftIndexDistal, "index03"},
    {kLeftMiddleProximal, "middle01"}, {kLeftMiddleIntermediate, "middle02"}, {kLeftMiddleDistal, "middle03"},
    {kLeftRingProximal, "ring01"}, {kLeftRingIntermediate, "ring02"}, {kLeftRingDistal, "ring03"},
    {kLeftLittleProximal, "pinky01"}, {kLeftLittleIntermediate, "pinky02"}, {kLeftLittleDistal, "pinky03"}};
constexpr Entry kMakeHuman[] = {  // the default rig, whose spine counts downwards
    {kHips, "root"}, {kSpine, "spine05"}, {kChest, "spine03"}, {kUpperChest, "spine01"}, {kNeck, "neck01"}, {kHead, "head"},
    {kLeftEye, "eye"}, {kJaw, "jaw"}, {kLeftUpperLeg, "upperleg01"}, {kLeftLowerLeg, "lowerleg01"}, {kLeftFoot, "foot"},
    {kLeftToes, "toe11"}, {kLeftShoulder, "clavicle"}, {kLeftUpperArm, "upperarm01"}, {kLeftLowerArm, "lowerarm01"}, {kLeftHand, "wrist"},
    {kLeftThumbMetacarpal, "finger11"}, {kLeftThumbProximal, "finger12"}, {kLeftThumbDistal, "finger13"},
    {kLeftIndexProximal, "finger21"}, {kLeftIndexIntermediate, "finger22"}, {kLeftIndexDistal, "finger23"},
    {kLeftMiddleProximal, "finger31"}, {kLeftMiddleIntermediate, "finger32"}, {kLeftMiddleDistal, "finger33"},
    {kLeftRingProximal, "finger41"}, {kLeftRingIntermediate, "finger42"}, {kLeftRingDistal, "finger43"},
    {kLeftLittleProximal, "finger51"}, {kLeftLittleIntermediate, "finger52"}, {kLeftLittleDistal, "finger53"}};
constexpr Entry kWebXr[] = {  // WebXR Hand Input: hands alone; metacarpals of the fingers and tips have no role
    {kLeftHand, "wrist"},
    {kLeftThumbMetacarpal, "thumbmetacarpal"}, {kLeftThumbProximal, "thumbphalanxproximal"}, {kLeftThumbDistal, "thumbphalanxdistal"},
    {kLeftIndexProximal, "indexfingerphalanxproximal"}, {kLeftIndexIntermediate, "indexfingerphalanxintermediate"}, {kLeftIndexDistal, "indexfingerphalanxdistal"},
    {kLeftMiddleProximal, "middlefingerphalanxproximal"}, {kLeftMiddleIntermediate, "middlefingerphalanxintermediate"}, {kLeftMiddleDistal, "middlefingerphalanxdistal"},
    {kLeftRingProximal, "ringfingerphalanxproximal"}, {kLeftRingIntermediate, "ringfingerphalanxintermediate"}, {kLeftRingDistal, "ringfingerphalanxdistal"},
    {kLeftLittleProximal, "pinkyfingerphalanxproximal"}, {kLeftLittleIntermediate, "pinkyfingerphalanxintermediate"}, {kLeftLittleDistal, "pinkyfingerphalanxdistal"}};
constexpr Entry kSpokenNames[] = {  // "Left elbow", "IndexFinger1_L": figures for social worlds
    {kHips, "hips"}, {kSpine, "spine"}, {kChest, "chest"}, {kUpperChest, "upperchest"}, {kNeck, "neck"}, {kHead, "head"},
    {kLeftEye, "eye"}, {kJaw, "jaw"}, {kLeftUpperLeg, "leg"}, {kLeftLowerLeg, "knee"}, {kLeftFoot, "ankle"}, {kLeftToes, "toe"},
    {kLeftShoulder, "shoulder"}, {kLeftUpperArm, "arm"}, {kLeftLowerArm, "elbow"}, {kLeftHand, "wrist"},
    {kLeftThumbMetacarpal, "thumb0"}, {kLeftThumbProximal, "thumb1"}, {kLeftThumbDistal, "thumb2"},
    {kLeftIndexProximal, "indexfinger1"}, {kLeftIndexIntermediate, "indexfinger2"}, {kLeftIndexDistal, "indexfinger3"},
    {kLeftMiddleProximal, "middlefinger1"}, {kLeftMiddleIntermediate, "middlefinger2"}, {kLeftMiddleDistal, "middlefinger3"},
    {kLeftRingProximal, "ringfinger1"}, {kLeftRingIntermediate, "ringfinger2"}, {kLeftRingDistal, "ringfinger3"},
    {kLeftLittleProximal, "littlefinger1"}, {kLeftLittleIntermediate, "littlefinger2"}, {kLeftLittleDistal, "littlefinger3"}};
constexpr Entry kRoleNames[] = {  // the roles' own names, which Unity's humanoid and VRoid (J_Bip_L_Index1) come near
    {kHips, "hips"}, {kSpine, "spine"}, {kChest, "chest"}, {kUpperChest, "upperchest"}, {kNeck, "neck"}, {kHead, "head"},
    {kLeftEye, "eye"}, {kLeftEye, "faceeye"}, {kJaw, "jaw"}, {kLeftUpperLeg, "upperleg"}, {kLeftLowerLeg, "lowerleg"}, {kLeftFoot, "foot"},
    {kLeftToes, "toes"}, {kLeftToes, "toebase"}, {kLeftShoulder, "shoulder"}, {kLeftUpperArm, "upperarm"},
    {kLeftLowerArm, "lowerarm"}, {kLeftHand, "hand"},
    {kLeftThumbMetacarpal, "thumbmetacarpal"}, {kLeftThumbMetacarpal, "thumb1"}, {kLeftThumbProximal, "thumb2"}, {kLeftThumbProximal, "thumbproximal"},
    {kLeftThumbDistal, "thumbdistal"}, {kLeftThumbDistal, "thumb3"},
    {kLeftIndexProximal, "indexproximal"}, {kLeftIndexIntermediate, "indexintermediate"}, {kLeftIndexDistal, "indexdistal"},
    {kLeftIndexProximal, "index1"}, {kLeftIndexIntermediate, "index2"}, {kLeftIndexDistal, "index3"},
    {kLeftMiddleProximal, "middleproximal"}, {kLeftMiddleIntermediate, "middleintermediate"}, {kLeftMiddleDistal, "middledistal"},
    {kLeftMiddleProximal, "middle1"}, {kLeftMiddleIntermediate, "middle2"}, {kLeftMiddleDistal, "middle3"},
    {kLeftRingProximal, "ringproximal"}, {kLeftRingIntermediate, "ringintermediate"}, {kLeftRingDistal, "ringdistal"},
    {kLeftRingProximal, "ring1"}, {kLeftRingIntermediate, "ring2"}, {kLeftRingDistal, "ring3"},
    {kLeftLittleProximal, "littleproximal"}, {kLeftLittleIntermediate, "littleintermediate"}, {kLeftLittleDistal, "littledistal"},
    {kLeftLittleProximal, "little1"}, {kLeftLittleIntermediate, "little2"}, {kLeftLittleDistal, "little3"}};
constexpr Entry kRigify[] = {  // Blender's metarig and its deforming bones
    {kHips, "spine"}, {kSpine, "spine001"}, {kChest, "spine002"}, {kUpperChest, "spine003"}, {kNeck, "spine004"}, {kHead, "spine006"},
    {kLeftEye, "eye"}, {kJaw, "jaw"}, {kLeftUpperLeg, "thigh"}, {kLeftLowerLeg, "shin"}, {kLeftFoot, "foot"}, {kLeftToes, "toe"},
    {kLeftShoulder, "shoulder"}, {kLeftUpperArm, "upperarm"}, {kLeftLowerArm, "forearm"}, {kLeftHand, "hand"},
    {kLeftThumbMetacarpal, "thumb01"}, {kLeftThumbProximal, "thumb02"}, {kLeftThumbDistal, "thumb03"},
    {kLeftIndexProximal, "findex01"}, {kLeftIndexIntermediate, "findex02"}, {kLeftIndexDistal, "findex03"},
    {kLeftMiddleProximal, "fmiddle01"}, {kLeftMiddleIntermediate, "fmiddle02"}, {kLeftMiddleDistal, "fmiddle03"},
    {kLeftRingProximal, "fring01"}, {kLeftRingIntermediate, "fring02"}, {kLeftRingDistal, "fring03"},
    {kLeftLittleProximal, "fpinky01"}, {kLeftLittleIntermediate, "fpinky02"}, {kLeftLittleDistal, "fpinky03"}};
constexpr Entry kAuslanJam[] = {  // kNodeNames of skeleton.h
    {kSpine, "spinebase"}, {kNeck, "neckbase"}, {kHead, "headbase"},
    {kLeftUpperArm, "shoulder"}, {kLeftLowerArm, "elbow"}, {kLeftHand, "wrist"},
    {kLeftThumbMetacarpal, "thumbcmc"}, {kLeftThumbProximal, "thumbmp"}, {kLeftThumbDistal, "thumbip"},
    {kLeftIndexProximal, "indexmp"}, {kLeftIndexIntermediate, "indexpip"}, {kLeftIndexDistal, "indexdip"},
    {kLeftMiddleProximal, "middlemp"}, {kLeftMiddleIntermediate, "middlepip"}, {kLeftMiddleDistal, "middledip"},
    {kLeftRingProximal, "ringmp"}, {kLeftRingIntermediate, "ringpip"}, {kLeftRingDistal, "ringdip"},
    {kLeftLittleProximal, "littlemp"}, {kLeftLittleIntermediate, "littlepip"}, {kLeftLittleDistal, "littledip"}};
constexpr Entry kBiped[] = {  // 3ds Max: "Bip01 L Finger01"; the thumb is finger 0, the last digit counts its joints
    {kHips, "pelvis"}, {kSpine, "spine"}, {kChest, "spine1"}, {kUpperChest, "spine2"}, {kNeck, "neck"}, {kHead, "head"},
    {kLeftUpperLeg, "thigh"}, {kLeftLowerLeg, "calf"}, {kLeftFoot, "foot"}, {kLeftToes, "toe0"},
    {kLeftShoulder, "clavicle"}, {kLeftUpperArm, "upperarm"}, {kLeftLowerArm, "forearm"}, {kLeftHand, "hand"},
    {kLeftThumbMetacarpal, "finger0"}, {kLeftThumbProximal, "finger01"}, {kLeftThumbDistal, "finger02"},
    {kLeftIndexProximal, "finger1"}, {kLeftIndexIntermediate, "finger11"}, {kLeftIndexDistal, "finger12"},
    {kLeftMiddleProximal, "finger2"}, {kLeftMiddleIntermediate, "finger21"}, {kLeftMiddleDistal, "finger22"},
    {kLeftRingProximal, "finger3"}, {kLeftRingIntermediate, "finger31"}, {kLeftRingDistal, "finger32"},
    {kLeftLittleProximal, "finger4"}, {kLeftLittleIntermediate, "finger41"}, {kLeftLittleDistal, "finger42"}};
constexpr Entry kCharacterCreator[] = {  // "CC_Base_L_Mid1"
    {kHips, "hip"}, {kSpine, "waist"}, {kChest, "spine01"}, {kUpperChest, "spine02"}, {kNeck, "necktwist01"}, {kHead, "head"},
    {kLeftEye, "eye"}, {kJaw, "jawroot"}, {kLeftUpperLeg, "thigh"}, {kLeftLowerLeg, "calf"}, {kLeftFoot, "foot"}, {kLeftToes, "toebase"},
    {kLeftShoulder, "clavicle"}, {kLeftUpperArm, "upperarm"}, {kLeftLowerArm, "forearm"}, {kLeftHand, "hand"},
    {kLeftThumbMetacarpal, "thumb1"}, {kLeftThumbProximal, "thumb2"}, {kLeftThumbDistal, "thumb3"},
    {kLeftIndexProximal, "index1"}, {kLeftIndexIntermediate, "index2"}, {kLeftIndexDistal, "index3"},
    {kLeftMiddleProximal, "mid1"}, {kLeftMiddleIntermediate, "mid2"}, {kLeftMiddleDistal, "mid3"},
    {kLeftRingProximal, "ring1"}, {kLeftRingIntermediate, "ring2"}, {kLeftRingDistal, "ring3"},
    {kLeftLittleProximal, "pinky1"}, {kLeftLittleIntermediate, "pinky2"}, {kLeftLittleDistal, "pinky3"}};
// clang-format on

struct Rig {
  std::string_view name;
  std::span<const Entry> entries;
};
constexpr std::array<Rig, 10> kRigs = {{{"Mixamo", kMixamo},
                                        {"Unreal", kUnreal},
                                        {"MakeHuman", kMakeHuman},
                                        {"WebXR hand", kWebXr},
                                        {"plain English", kSpokenNames},
                                        {"VRM names", kRoleNames},
                                        {"Rigify", kRigify},
                                        {"3ds Max Biped", kBiped},
                                        {"Character Creator", kCharacterCreator},
                                        {"Auslan Jam", kAuslanJam}}};
constexpr int kFewestRoles = 4;

/// The role on the right of one on the left, or nothing for a role that has no side.
std::optional<HumanRole> mirrored(HumanRole role) {
  const std::string_view name = name_of(role);
  if (!name.starts_with("left")) return std::nullopt;
  return human_role("right" + std::string(name.substr(4)));
}

HumanNodes match(std::span<const PlainName> names, std::span<const Entry> entries, Side side_of_all) {
  HumanNodes found;
  found.fill(kNoNode);
  for (const Entry& entry : entries) {
    const std::optional<HumanRole> right = mirrored(entry.role);
    for (size_t i = 0; i < names.size(); ++i) {
      if (!names[i].is_bone || names[i].text != entry.name) continue;
      const Side side = names[i].side == Side::kNone ? side_of_all : names[i].side;
      if (right ? side == Side::kNone : names[i].side != Side::kNone) continue;
      int& node = found[static_cast<size_t>(side == Side::kRight && right ? *right : entry.role)];
      if (node == kNoNode) node = static_cast<int>(i);
    }
  }
  return found;
}

/// The side that names agree on, for rigs that are one hand.
Side common_side(std::span<const PlainName> names) {
  const auto has = [&](Side side) { return std::ranges::count(names, side, &PlainName::side) > 0; };
  if (has(Side::kLeft) == has(Side::kRight)) return Side::kNone;
  return has(Side::kLeft) ? Side::kLeft : Side::kRight;
}

}  // namespace

std::optional<HumanRole> human_role(std::string_view name) {
  const auto found = std::ranges::find(kHumanRoleNames, name);
  if (found == kHumanRoleNames.end()) return std::nullopt;
  return static_cast<HumanRole>(found - kHumanRoleNames.begin());
}

NamedHumanoid humanoid_from_names(std::span<const NodeName> names) {
  NamedHumanoid best;
  best.node.fill(kNoNode);
  std::ptrdiff_t most = kFewestRoles - 1;
  for (const Trim trim : {Trim::kNothing, Trim::kLastWord, Trim::kFirstWord}) {
    std::vector<PlainName> plain_names;
    plain_names.reserve(names.size());
    for (const NodeName& name : names) {
      plain_names.push_back(plain(name.name, trim));
      plain_names.back().is_bone = name.is_bone;
    }
    const Side side_of_all = common_side(plain_names);
    for (const Rig& rig : kRigs) {
      const HumanNodes found = match(plain_names, rig.entries, side_of_all);
      const std::ptrdiff_t roles = kHumanRoleCount - std::ranges::count(found, kNoNode);
      if (roles <= most) continue;
      most = roles;
      best = {.rig = rig.name, .node = found};
    }
  }
  return best;
}

}  // namespace auslan
