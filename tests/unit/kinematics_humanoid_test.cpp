// SPDX-License-Identifier: Apache-2.0
// Which part of a body a node plays, told from names as exporters write them.
#include "kinematics/humanoid.h"
#include "kinematics/skeleton.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {
namespace {

using enum HumanRole;

NamedHumanoid told(const std::vector<std::string>& names) {
  std::vector<NodeName> list;
  for (const std::string& name : names)
    list.push_back({.name = name});
  return humanoid_from_names(list);
}

std::ptrdiff_t roles(const NamedHumanoid& humanoid) {
  return std::ranges::count_if(humanoid.node, [](int node) { return node != kNoNode; });
}

int node(const NamedHumanoid& humanoid, HumanRole role) {
  return humanoid.node[static_cast<size_t>(role)];
}

/// Names of a body: those in the middle, and each of a pair with the side put where `%` stands.
std::vector<std::string> body(const std::vector<std::string>& middle, const std::vector<std::string>& pairs,
                              const std::string& left, const std::string& right) {
  std::vector<std::string> names = middle;
  for (const std::string& side : {left, right})
    for (std::string name : pairs)
      names.push_back(name.replace(name.find('%'), 1, side));
  return names;
}

/// "BEFORE" + digit + joint, for every joint of `digits`.
std::vector<std::string> with_digits(std::vector<std::string> pairs, const std::vector<std::string>& digits,
                                     const std::vector<std::string>& joints, const std::string& before,
                                     const std::string& after) {
  for (const std::string& digit : digits)
    for (const std::string& joint : joints) {
      std::string name = before;
      name += digit;
      name += joint;
      pairs.push_back(name + after);
    }
  return pairs;
}

TEST(Humanoid, NamesOfRolesAreThoseOfVrm1) {
  EXPECT_EQ(name_of(kHips), "hips");
  EXPECT_EQ(name_of(kRightLittleDistal), "rightLittleDistal");
  for (size_t r = 0; r < kHumanRoleCount; ++r)
    EXPECT_EQ(human_role(kHumanRoleNames[r]), static_cast<HumanRole>(r));
  EXPECT_FALSE(human_role("leftThumbIntermediate"));
}

TEST(Humanoid, Mixamo) {
  for (const std::string prefix : {"mixamorig:", "mixamorig", "mixamorig1:", ""}) {
    const std::string pair = prefix + "%";
    const std::vector<std::string> names =
        body({prefix + "Hips", prefix + "Spine", prefix + "Spine1", prefix + "Spine2", prefix + "Neck", prefix + "Head",
              prefix + "HeadTop_End"},
             with_digits({pair + "Shoulder", pair + "Arm", pair + "ForeArm", pair + "Hand", pair + "UpLeg",
                          pair + "Leg", pair + "Foot", pair + "ToeBase"},
                         {"Thumb", "Index", "Middle", "Ring", "Pinky"}, {"1", "2", "3", "4"}, pair + "Hand", ""),
             "Left", "Right");
    const NamedHumanoid found = told(names);
    EXPECT_EQ(found.rig, "Mixamo") << prefix;
    EXPECT_EQ(roles(found), 52) << prefix;
    EXPECT_EQ(names.at(static_cast<size_t>(node(found, kLeftLowerArm))), prefix + "LeftForeArm");
    EXPECT_EQ(names.at(static_cast<size_t>(node(found, kRightThumbMetacarpal))), prefix + "RightHandThumb1");
  }
}

TEST(Humanoid, EndingsThatExportersAdd) {
  for (const std::string ending : {"_012", "_Armature", ".007"}) {
    const NamedHumanoid found =
        told(body({"mixamorig:Hips" + ending, "mixamorig:Spine" + ending, "mixamorig:Spine1" + ending, "Head" + ending},
                  {"mixamorig:%ForeArm" + ending, "mixamorig:%HandIndex2" + ending}, "Left", "Right"));
    EXPECT_EQ(found.rig, "Mixamo") << ending;
    EXPECT_EQ(roles(found), 8) << ending;
    const NamedHumanoid unreal =
        told({"pelvis" + ending, "spine_01" + ending, "hand_l" + ending, "index_02_r" + ending});
    EXPECT_EQ(unreal.rig, "Unreal") << ending;
    EXPECT_EQ(node(unreal, kRightIndexIntermediate), 3) << ending;
  }
}

TEST(Humanoid, FirstWordsThatExportersAdd) {
  const NamedHumanoid character = told(body({"Character1_Hips", "Character1_Spine", "Character1_Head"},
                                            {"Character1_%ForeArm", "Character1_%HandIndex2"}, "Left", "Right"));
  EXPECT_EQ(character.rig, "Mixamo");
  EXPECT_EQ(roles(character), 7);
  const NamedHumanoid biped = told(body({"ValveBiped.Bip01_Pelvis", "ValveBiped.Bip01_Spine"},
                                        {"ValveBiped.Bip01_%_Forearm", "ValveBiped.Bip01_%_Finger12"}, "L", "R"));
  EXPECT_EQ(biped.rig, "3ds Max Biped");
  EXPECT_EQ(roles(biped), 6);
}

TEST(Humanoid, UnrealManny) {
  const std::vector<std::string> names =
      body({"root", "pelvis", "spine_01", "spine_02", "spine_03", "spine_04", "spine_05", "neck_01", "neck_02", "head",
            "ik_hand_root"},
           with_digits({"clavicle_%", "upperarm_%", "upperarm_twist_01_%", "lowerarm_%", "hand_%", "ik_hand_%",
                        "index_metacarpal_%", "thigh_%", "calf_%", "foot_%", "ball_%"},
                       {"thumb", "index", "middle", "ring", "pinky"}, {"_01", "_02", "_03"}, "", "_%"),
           "l", "r");
  const NamedHumanoid found = told(names);
  EXPECT_EQ(found.rig, "Unreal");
  EXPECT_EQ(roles(found), 52);
  EXPECT_EQ(names.at(static_cast<size_t>(node(found, kUpperChest))), "spine_05");
  EXPECT_EQ(names.at(static_cast<size_t>(node(found, kLeftHand))), "hand_l");
  EXPECT_EQ(names.at(static_cast<size_t>(node(found, kRightLittleDistal))), "pinky_03_r");
}

TEST(Humanoid, MakeHumanDefaultRig) {
  for (const bool is_stripped : {false, true}) {  // some exporters lose the dot
    const std::string mark = is_stripped ? "%" : ".%";
    const std::vector<std::string> names = body(
        {"root", "spine05", "spine04", "spine03", "spine02", "spine01", "neck01", "neck02", "neck03", "head", "jaw"},
        with_digits({"clavicle" + mark, "shoulder01" + mark, "upperarm01" + mark, "upperarm02" + mark,
                     "lowerarm01" + mark, "wrist" + mark, "metacarpal1" + mark, "pelvis" + mark, "upperleg01" + mark,
                     "lowerleg01" + mark, "foot" + mark, "toe1-1" + mark, "toe1-2" + mark, "eye" + mark},
                    {"1", "2", "3", "4", "5"}, {"-1", "-2", "-3"}, "finger", mark),
        "L", "R");
    const NamedHumanoid found = told(names);
    EXPECT_EQ(found.rig, "MakeHuman");
    EXPECT_EQ(roles(found), kHumanRoleCount);
    EXPECT_EQ(names.at(static_cast<size_t>(node(found, kSpine))), "spine05");
    EXPECT_EQ(names.at(static_cast<size_t>(node(found, kLeftThumbMetacarpal))),
              is_stripped ? "finger1-1L" : "finger1-1.L");
    EXPECT_EQ(names.at(static_cast<size_t>(node(found, kRightToes))), is_stripped ? "toe1-1R" : "toe1-1.R");
  }
}

TEST(Humanoid, VroidAndRigify) {
  const NamedHumanoid vroid =
      told(body({"Root", "J_Bip_C_Hips", "J_Bip_C_Spine", "J_Bip_C_Chest", "J_Bip_C_UpperChest", "J_Bip_C_Neck",
                 "J_Bip_C_Head", "J_Sec_Hair1_01"},
                with_digits({"J_Adj_%_FaceEye", "J_Bip_%_Shoulder", "J_Bip_%_UpperArm", "J_Bip_%_LowerArm",
                             "J_Bip_%_Hand", "J_Bip_%_UpperLeg", "J_Bip_%_LowerLeg", "J_Bip_%_Foot", "J_Bip_%_ToeBase"},
                            {"Thumb", "Index", "Middle", "Ring", "Little"}, {"1", "2", "3"}, "J_Bip_%_", ""),
                "L", "R"));
  EXPECT_EQ(vroid.rig, "VRM names");
  EXPECT_EQ(roles(vroid), kHumanRoleCount - 1);  // no jaw
  const NamedHumanoid rigify =
      told(body({"DEF-spine", "DEF-spine.001", "DEF-spine.002", "DEF-spine.003", "DEF-spine.004", "DEF-spine.006"},
                with_digits({"DEF-shoulder.%", "DEF-upper_arm.%", "DEF-forearm.%", "DEF-hand.%", "DEF-thigh.%",
                             "DEF-shin.%", "DEF-foot.%", "DEF-toe.%"},
                            {"thumb", "f_index", "f_middle", "f_ring", "f_pinky"}, {".01", ".02", ".03"}, "DEF-", ".%"),
                "L", "R"));
  EXPECT_EQ(rigify.rig, "Rigify");
  EXPECT_EQ(roles(rigify), 52);
}

TEST(Humanoid, BipedAndCharacterCreator) {
  const NamedHumanoid biped =
      told(body({"Bip01", "Bip01 Pelvis", "Bip01 Spine", "Bip01 Spine1", "Bip01 Spine2", "Bip01 Neck", "Bip01 Head"},
                with_digits({"Bip01 % Clavicle", "Bip01 % UpperArm", "Bip01 % Forearm", "Bip01 % Hand", "Bip01 % Thigh",
                             "Bip01 % Calf", "Bip01 % Foot", "Bip01 % Toe0"},
                            {"0", "1", "2", "3", "4"}, {"", "1", "2"}, "Bip01 % Finger", ""),
                "L", "R"));
  EXPECT_EQ(biped.rig, "3ds Max Biped");
  EXPECT_EQ(roles(biped), 52);
  const NamedHumanoid creator = told(
      body({"CC_Base_Hip", "CC_Base_Waist", "CC_Base_Spine01", "CC_Base_Spine02", "CC_Base_NeckTwist01", "CC_Base_Head",
            "CC_Base_JawRoot"},
           with_digits({"CC_Base_%_Eye", "CC_Base_%_Clavicle", "CC_Base_%_Upperarm", "CC_Base_%_Forearm",
                        "CC_Base_%_Hand", "CC_Base_%_Thigh", "CC_Base_%_Calf", "CC_Base_%_Foot", "CC_Base_%_ToeBase"},
                       {"Thumb", "Index", "Mid", "Ring", "Pinky"}, {"1", "2", "3"}, "CC_Base_%_", ""),
           "L", "R"));
  EXPECT_EQ(creator.rig, "Character Creator");
  EXPECT_EQ(roles(creator), kHumanRoleCount);
}

TEST(Humanoid, TheProjectsOwnSkeleton) {
  const NamedHumanoid found = told({kNodeNames.begin(), kNodeNames.end()});
  EXPECT_EQ(found.rig, "Auslan Jam");
  EXPECT_EQ(roles(found), 39);
}

TEST(Humanoid, AHandTakesItsSideFromAnotherNode) {
  std::vector<NodeName> names = {{.name = "wrist"},
                                 {.name = "thumb-metacarpal"},
                                 {.name = "thumb-phalanx-proximal"},
                                 {.name = "index-finger-phalanx-distal"},
                                 {.name = "r_handMesh", .is_bone = false}};
  const NamedHumanoid right = humanoid_from_names(names);
  EXPECT_EQ(right.rig, "WebXR hand");
  EXPECT_EQ(node(right, kRightHand), 0);
  EXPECT_EQ(node(right, kRightIndexDistal), 3);
  EXPECT_EQ(node(right, kLeftHand), kNoNode);
  names.back().name = "mesh";
  EXPECT_EQ(humanoid_from_names(names).rig, "");
}

TEST(Humanoid, MeshesPlayNoRole) {
  const std::vector<NodeName> names = {{.name = "Head", .is_bone = false},
                                       {.name = "head"},
                                       {.name = "pelvis"},
                                       {.name = "spine_01"},
                                       {.name = "spine_02"}};
  EXPECT_EQ(node(humanoid_from_names(names), kHead), 1);
}

TEST(Humanoid, FewOrStrangeNamesAreNoRig) {
  EXPECT_EQ(told({}).rig, "");
  EXPECT_EQ(told({"head", "neck", "hips"}).rig, "");
  EXPECT_EQ(told({"", ":", "L", "left", "right", "___", "\xff\xfe", "mixamorig", std::string(100'000, 'L')}).rig, "");
  EXPECT_EQ(told({"Cube", "Camera", "Light", "wheel_l", "wheel_r", "door.L"}).rig, "");
}

}  // namespace
}  // namespace auslan
