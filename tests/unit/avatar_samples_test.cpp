// SPDX-License-Identifier: Apache-2.0
// Figures of other makers: what the reader finds in them is what their makers and an independent program say is there.
#include "gltf/avatar_gltf.h"
#include "kinematics/avatar_pose.h"
#include "kinematics/rotation.h"
#include "sample_avatars.h"
#include "scratch_folder.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace auslan {
namespace {

using nlohmann::json;
using test::sample_avatar;

Avatar read(const std::string& name) {
  auto avatar = read_avatar(sample_avatar(name));
  EXPECT_TRUE(avatar) << to_string(avatar.error());
  return avatar ? *std::move(avatar) : Avatar{};
}

/// Roles that the file itself maps.
std::ptrdiff_t mapped(const Avatar& avatar) {
  return std::ranges::count_if(avatar.human_node, [](int node) { return node != kNoNode; }) -
         std::ranges::count(avatar.is_guessed, true);
}

std::string bone(const Avatar& avatar, HumanRole role) {
  const int node = avatar.node_of(role);
  return node == kNoNode ? "" : avatar.nodes[static_cast<size_t>(node)].name;
}

const AvatarExpression* expression(const Avatar& avatar, std::string_view name) {
  const auto found = std::ranges::find(avatar.expressions, name, &AvatarExpression::name);
  return found == avatar.expressions.end() ? nullptr : &*found;
}

bool warns(const Avatar& avatar, std::string_view of) {
  return std::ranges::any_of(avatar.warnings,
                             [&](const std::string& text) { return text.find(of) != std::string::npos; });
}

size_t vertex_count(const Avatar& avatar) {
  size_t count = 0;
  for (const AvatarMesh& mesh : avatar.meshes)
    for (const AvatarVertices& vertices : mesh.vertices)
      count += vertices.positions.size();
  return count;
}

TEST(AvatarSamples, SkinAndMorphsOfMakeHumanAgreeWithThreeJs) {
  AUSLAN_NEEDS_AVATAR("makehuman_reference_pose.json");
  const Avatar avatar = read("makehuman.glb");
  const json reference = json::parse(bytes_of(sample_avatar("makehuman_reference_pose.json")));
  AvatarPose pose = rest_pose(avatar);
  size_t turned = 0;
  for (const auto& [name, angles] : reference["rotations"].items())
    for (size_t i = 0; i < avatar.nodes.size(); ++i) {
      if (avatar.nodes[i].name != name) continue;
      const Vec3 radians(angles[0], angles[1], angles[2]);
      pose.rotation[i] = avatar.nodes[i].rotation * from_euler(radians, EulerOrder::kXYZ);
      ++turned;
    }
  EXPECT_EQ(turned, reference["rotations"].size());
  size_t moved = 0;
  for (size_t m = 0; m < avatar.meshes.size(); ++m)
    for (size_t i = 0; i < avatar.meshes[m].morph_names.size(); ++i)
      if (reference["morphs"].contains(avatar.meshes[m].morph_names[i])) {
        pose.morph_weights[m][i] = reference["morphs"][avatar.meshes[m].morph_names[i]];
        ++moved;
      }
  EXPECT_EQ(moved, reference["morphs"].size());

  AvatarPoser poser(avatar);
  poser.pose(pose);
  size_t compared = 0;
  for (const json& primitive : reference["primitives"]) {
    const auto mesh = std::ranges::find(avatar.meshes, primitive["mesh"].get<std::string>(), &AvatarMesh::name);
    ASSERT_NE(mesh, avatar.meshes.end());
    const AvatarSurface& surface = mesh->surfaces.at(primitive["primitive"].get<size_t>());
    EXPECT_EQ(surface.material, primitive["material"].get<std::string>());
    const auto part = std::ranges::find_if(poser.parts(), [&](const AvatarPoser::Part& each) {
      return each.mesh == mesh - avatar.meshes.begin() && each.vertices == surface.vertices;
    });
    ASSERT_NE(part, poser.parts().end());
    ASSERT_EQ(part->positions.size(), primitive["vertexCount"].get<size_t>());
    for (const auto& [index, expected] : primitive["vertices"].items())
      for (int c = 0; c < 3; ++c, ++compared)
        EXPECT_NEAR(part->positions.at(std::stoul(index))[c], expected[static_cast<size_t>(c)].get<double>(), 1e-5)
            << primitive["mesh"] << " " << primitive["material"] << " vertex " << index;
    for (int c = 0; c < 3; ++c) {
      const auto [least, most] = std::ranges::minmax(part->positions, {}, [&](const glm::vec3& p) { return p[c]; });
      EXPECT_NEAR(least[c], primitive["min"][static_cast<size_t>(c)].get<double>(), 1e-5);
      EXPECT_NEAR(most[c], primitive["max"][static_cast<size_t>(c)].get<double>(), 1e-5);
    }
  }
  EXPECT_GT(compared, 100U);
}

TEST(AvatarSamples, MakeHumanGlbIsReadByItsNames) {
  AUSLAN_NEEDS_AVATAR("makehuman.glb");
  const Avatar avatar = read("makehuman.glb");
  EXPECT_EQ(avatar.kind, Avatar::Kind::kGltf);
  EXPECT_EQ(avatar.rig, "Unreal");
  EXPECT_EQ(triangle_count(avatar), 29782U);
  EXPECT_EQ(vertex_count(avatar), 15664U);
  EXPECT_EQ(avatar.meshes.at(0).morph_names.size(), 59U);
  EXPECT_EQ(avatar.meshes.at(1).morph_names.size(), 0U);
  ASSERT_EQ(avatar.skins.size(), 1U);
  EXPECT_EQ(avatar.skins[0].joints.size(), 53U);
  // All but eyes and jaw, which the rig does not have.
  EXPECT_EQ(mapped(avatar), kHumanRoleCount - 3);
  EXPECT_EQ(bone(avatar, HumanRole::kHips), "pelvis");
  EXPECT_EQ(bone(avatar, HumanRole::kUpperChest), "spine_03");
  EXPECT_EQ(bone(avatar, HumanRole::kHead), "head");
  EXPECT_EQ(bone(avatar, HumanRole::kLeftThumbMetacarpal), "thumb_01_l");
  EXPECT_EQ(bone(avatar, HumanRole::kRightLittleDistal), "pinky_03_r");
  // Its pose units drive all channels but those of pressed and funnelled lips and of one cheek alone.
  const std::vector<FaceChannel> missing = {FaceChannel::kMouthFunnel, FaceChannel::kMouthPressLeft,
                                            FaceChannel::kMouthPressRight, FaceChannel::kCheekPuffLeft,
                                            FaceChannel::kCheekPuffRight};
  for (size_t c = 0; c < kFaceChannelCount; ++c)
    EXPECT_EQ(avatar.face[c].means == FaceDrive::Means::kNone,
              std::ranges::find(missing, static_cast<FaceChannel>(c)) != missing.end())
        << kFaceChannelNames[c];
}

TEST(AvatarSamples, MakeHumanVrmIsReadByItsMap) {
  AUSLAN_NEEDS_AVATAR("makehuman.vrm");
  const Avatar avatar = read("makehuman.vrm");
  EXPECT_EQ(avatar.kind, Avatar::Kind::kVrm1);
  EXPECT_EQ(avatar.author, "MakeHuman team and contributors (CC0 assets)");
  EXPECT_EQ(avatar.licence, "https://creativecommons.org/publicdomain/zero/1.0/");
  EXPECT_EQ(avatar.rig, "");
  EXPECT_EQ(triangle_count(avatar), 29782U);
  EXPECT_EQ(mapped(avatar), 52);
  EXPECT_EQ(bone(avatar, HumanRole::kRightRingIntermediate), "ring_02_r");
  EXPECT_EQ(avatar.expressions.size(), 18U);
  const AvatarExpression* ih = expression(avatar, "ih");
  ASSERT_NE(ih, nullptr);
  std::vector<std::pair<std::string, double>> binds;
  for (const MorphBind& bind : ih->binds)
    binds.emplace_back(avatar.meshes.at(static_cast<size_t>(bind.mesh)).morph_names.at(static_cast<size_t>(bind.morph)),
                       bind.weight);
  const std::vector<std::pair<std::string, double>> expected = {
      {"MouthLeftPullSide", 0.45}, {"MouthRightPullSide", 0.45}, {"JawDrop", 0.22}, {"UpperLipUp", 0.3}};
  EXPECT_EQ(binds, expected);
  // "oh" stands in for the funnel that the pose units lack.
  EXPECT_EQ(avatar.face[static_cast<size_t>(FaceChannel::kMouthFunnel)].source, "oh");
}

TEST(AvatarSamples, CryptovoxelsMapsFortyThreeBonesAndLacksTipsAndThumbs) {
  AUSLAN_NEEDS_AVATAR("cryptovoxels.vrm");
  const Avatar avatar = read("cryptovoxels.vrm");
  EXPECT_EQ(avatar.kind, Avatar::Kind::kVrm0);
  EXPECT_EQ(triangle_count(avatar), 4907U);
  EXPECT_EQ(mapped(avatar), 43);
  EXPECT_EQ(avatar.meshes.at(0).morph_names.size(), 0U);
  EXPECT_TRUE(avatar.expressions.empty());
  EXPECT_TRUE(avatar.images.empty());
  EXPECT_EQ(bone(avatar, HumanRole::kLeftMiddleDistal), "MiddleFinger3_L");
  // What its map leaves out its names tell.
  for (const auto& [role, name] :
       {std::pair(HumanRole::kLeftIndexDistal, "IndexFinger3_L"),
        std::pair(HumanRole::kRightIndexDistal, "IndexFinger3_R"),
        std::pair(HumanRole::kLeftThumbMetacarpal, "Thumb0_L"), std::pair(HumanRole::kRightThumbDistal, "Thumb2_R")}) {
    EXPECT_EQ(bone(avatar, role), name);
    EXPECT_TRUE(avatar.is_guessed[static_cast<size_t>(role)]) << name;
  }
  for (const FaceDrive& drive : avatar.face)
    EXPECT_EQ(drive.means, FaceDrive::Means::kNone);
}

TEST(AvatarSamples, GodetteHasNoRingFingerAndSpeaksByExpressions) {
  AUSLAN_NEEDS_AVATAR("godette.vrm");
  const Avatar avatar = read("godette.vrm");
  EXPECT_EQ(avatar.kind, Avatar::Kind::kVrm0);
  EXPECT_EQ(avatar.author, "SirRichard94");
  EXPECT_EQ(avatar.licence, "CC_BY");
  EXPECT_EQ(triangle_count(avatar), 3439U);
  EXPECT_EQ(avatar.meshes.at(0).morph_names.size(), 15U);
  EXPECT_EQ(avatar.meshes.at(0).morph_names.at(3), "blink_left");
  EXPECT_EQ(bone(avatar, HumanRole::kLeftRingProximal), "");
  EXPECT_EQ(bone(avatar, HumanRole::kRightRingDistal), "");
  // VRM 0 calls this thumb bone proximal.
  EXPECT_EQ(bone(avatar, HumanRole::kLeftThumbMetacarpal), "thumb.1.l_Armature");
  EXPECT_EQ(bone(avatar, HumanRole::kLeftThumbProximal), "thumb.2.l_Armature");
  EXPECT_EQ(bone(avatar, HumanRole::kLeftThumbDistal), "thumb.3.l_Armature");
  for (const char* name : {"aa", "ih", "ou", "ee", "oh", "blink", "blinkLeft", "blinkRight", "happy", "sad", "relaxed"})
    EXPECT_NE(expression(avatar, name), nullptr) << name;
  const AvatarExpression* happy = expression(avatar, "happy");
  ASSERT_EQ(happy->binds.size(), 2U);
  EXPECT_EQ(happy->binds[0].morph, 9);
  EXPECT_EQ(happy->binds[0].weight, 0.5);
  EXPECT_EQ(avatar.face[static_cast<size_t>(FaceChannel::kEyeBlinkLeft)].source, "blinkLeft");
  EXPECT_EQ(avatar.face[static_cast<size_t>(FaceChannel::kTongueOut)].means, FaceDrive::Means::kNone);
  EXPECT_EQ(avatar.images.size(), 5U);
  EXPECT_EQ(avatar.images.at(0).format, AvatarImage::Format::kPng);
  EXPECT_EQ(avatar.images.at(1).format, AvatarImage::Format::kJpeg);
  EXPECT_EQ(avatar.meshes.at(0).surfaces.at(0).image, 0);
  EXPECT_TRUE(warns(avatar, "MToon"));
}

TEST(AvatarSamples, WebXrHandsAreFlatAndHaveFifteenFingerBones) {
  for (const bool is_left : {true, false}) {
    const std::string name = is_left ? "webxr_hand_left.glb" : "webxr_hand_right.glb";
    AUSLAN_NEEDS_AVATAR(name);
    const Avatar avatar = read(name);
    EXPECT_EQ(avatar.rig, "WebXR hand");
    EXPECT_EQ(triangle_count(avatar), 2314U);
    ASSERT_EQ(avatar.skins.size(), 1U);
    EXPECT_EQ(avatar.skins[0].joints.size(), 25U);
    for (const int joint : avatar.skins[0].joints)
      EXPECT_EQ(avatar.nodes[static_cast<size_t>(joint)].parent,
                avatar.nodes[static_cast<size_t>(avatar.skins[0].joints[0])].parent);
    EXPECT_EQ(mapped(avatar), 16);
    EXPECT_EQ(bone(avatar, is_left ? HumanRole::kLeftHand : HumanRole::kRightHand), "wrist");
    EXPECT_EQ(bone(avatar, is_left ? HumanRole::kLeftLittleDistal : HumanRole::kRightLittleDistal),
              "pinky-finger-phalanx-distal");
    EXPECT_TRUE(warns(avatar, "flat"));
  }
}

TEST(AvatarSamples, RestPoseIsTheMeshAsItIsStored) {
  for (const char* name : {"makehuman.glb", "makehuman.vrm", "godette.vrm"}) {
    AUSLAN_NEEDS_AVATAR(name);
    const Avatar avatar = read(name);
    AvatarPoser poser(avatar);
    poser.pose(rest_pose(avatar));
    for (const AvatarPoser::Part& part : poser.parts()) {
      const AvatarVertices& stored =
          avatar.meshes[static_cast<size_t>(part.mesh)].vertices[static_cast<size_t>(part.vertices)];
      float worst = 0;
      for (size_t i = 0; i < part.positions.size(); ++i)
        worst = std::max(worst, glm::distance(part.positions[i], stored.positions[i]));
      EXPECT_LT(worst, 2e-5F) << name;
    }
  }
}

// Bound in another pose than its nodes rest in. The numbers are those of a separate script in plain Python.
TEST(AvatarSamples, CryptovoxelsRestsElsewhereThanItWasBound) {
  AUSLAN_NEEDS_AVATAR("cryptovoxels.vrm");
  const Avatar avatar = read("cryptovoxels.vrm");
  AvatarPoser poser(avatar);
  poser.pose(rest_pose(avatar));
  ASSERT_EQ(poser.parts().size(), 1U);
  const glm::vec3 posed = poser.parts()[0].positions.at(297);
  EXPECT_NEAR(posed.x, 0.020417156, 1e-6);
  EXPECT_NEAR(posed.y, 0.309605942, 1e-6);
  EXPECT_NEAR(posed.z, 0.028687720, 1e-6);
  EXPECT_NEAR(glm::distance(posed, avatar.meshes[0].vertices[0].positions[297]), 0.007842512, 1e-6);
}

TEST(AvatarSamples, WeightsAreOfSumOneAndNameJointsOfTheSkin) {
  for (const char* name :
       {"makehuman.glb", "makehuman.vrm", "cryptovoxels.vrm", "godette.vrm", "webxr_hand_left.glb"}) {
    AUSLAN_NEEDS_AVATAR(name);
    const Avatar avatar = read(name);
    for (const AvatarNode& node : avatar.nodes) {
      if (node.mesh < 0) continue;
      for (const AvatarVertices& vertices : avatar.meshes[static_cast<size_t>(node.mesh)].vertices)
        for (size_t i = 0; i < vertices.weights.size(); ++i) {
          const glm::vec4& weights = vertices.weights[i];
          ASSERT_NEAR(weights.x + weights.y + weights.z + weights.w, 1.0F, 1e-6F) << name;
          for (int k = 0; k < 4; ++k)
            ASSERT_LT(vertices.joints[i][k], avatar.skins[static_cast<size_t>(node.skin)].joints.size()) << name;
        }
    }
  }
}

}  // namespace
}  // namespace auslan
