// SPDX-License-Identifier: Apache-2.0
// What is read of small figures whose every number is known, and where their vertices go.
#include "kinematics/avatar_pose.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
#include "tiny_avatar.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <tuple>
#include <vector>

namespace auslan {
namespace {

using nlohmann::json;
using test::GlbDocument;
using test::parse_avatar_text;
using test::tiny_avatar;

Avatar read(const GlbDocument& document) {
  auto avatar = parse_avatar_text(document.pack());
  EXPECT_TRUE(avatar) << to_string(avatar.error());
  return avatar ? *std::move(avatar) : Avatar{};
}

std::vector<glm::vec3> posed(const Avatar& avatar, const AvatarPose& pose) {
  AvatarPoser poser(avatar);
  poser.pose(pose);
  return poser.parts().front().positions;
}

void expect_near(const glm::vec3& found, const glm::vec3& expected) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(found[c], expected[c], 1e-6F) << "component " << c;
}

bool warns(const Avatar& avatar, std::string_view of) {
  return std::ranges::any_of(avatar.warnings,
                             [&](const std::string& text) { return text.find(of) != std::string::npos; });
}

FaceDrive face(const Avatar& avatar, FaceChannel channel) {
  return avatar.face[static_cast<size_t>(channel)];
}

TEST(AvatarReader, EverythingOfTheTinyFigure) {
  const Avatar avatar = read(tiny_avatar());
  EXPECT_EQ(avatar.kind, Avatar::Kind::kVrm1);
  EXPECT_EQ(avatar.name, "tiny");
  ASSERT_EQ(avatar.nodes.size(), 5U);
  EXPECT_EQ(avatar.nodes[2].parent, 1);
  EXPECT_EQ(avatar.nodes[4].parent, kNoNode);
  ASSERT_EQ(avatar.meshes.size(), 1U);
  EXPECT_EQ(avatar.meshes[0].morph_names, std::vector<std::string>{"jawOpen"});
  ASSERT_EQ(avatar.meshes[0].surfaces.size(), 1U);
  const AvatarSurface& surface = avatar.meshes[0].surfaces[0];
  EXPECT_EQ(surface.base_colour, glm::vec4(0.5F, 0.25F, 1.0F, 1.0F));
  EXPECT_EQ(surface.image, 0);
  EXPECT_EQ(surface.indices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(avatar.meshes[0].vertices.at(0).texture_coordinates.at(1), glm::vec2(1, 1));
  ASSERT_EQ(avatar.images.size(), 1U);
  EXPECT_EQ(avatar.images[0].format, AvatarImage::Format::kPng);
  EXPECT_EQ(avatar.images[0].bytes.size(), test::png_head(16).size());
  EXPECT_EQ(avatar.node_of(HumanRole::kSpine), 2);
  EXPECT_EQ(avatar.node_of(HumanRole::kHead), kNoNode);
  EXPECT_EQ(face(avatar, FaceChannel::kJawOpen).means, FaceDrive::Means::kMorph);
  EXPECT_EQ(avatar.expressions.at(0).binds.at(0).weight, 0.75);
}

TEST(AvatarReader, Vrm0ComesUnderTheNamesOfVrm1) {
  const Avatar avatar = read(tiny_avatar(Avatar::Kind::kVrm0));
  EXPECT_EQ(avatar.kind, Avatar::Kind::kVrm0);
  EXPECT_EQ(avatar.node_of(HumanRole::kLeftThumbMetacarpal), 2);
  EXPECT_EQ(avatar.node_of(HumanRole::kLeftThumbProximal), kNoNode);
  EXPECT_EQ(avatar.node_of(HumanRole::kJaw), kNoNode);
  ASSERT_EQ(avatar.expressions.size(), 1U);
  EXPECT_EQ(avatar.expressions[0].name, "aa");
  EXPECT_TRUE(avatar.expressions[0].is_preset);
  EXPECT_EQ(avatar.expressions[0].binds.at(0).weight, 0.75);
}

TEST(AvatarReader, SkinningBlendsTheMatricesOfTwoBones) {
  const Avatar avatar = read(tiny_avatar());
  AvatarPose pose = rest_pose(avatar);
  const std::vector<glm::vec3> rest = posed(avatar, pose);
  expect_near(rest[2], {1, 2, 0});
  // The spine, at (0, 1.5, 0), turns a quarter about Z: (1, 2) goes to (-0.5, 2.5) for it and stays for the hips.
  pose.rotation[2] = axis_angle(Vec3(0, 0, 1), kPi / 2);
  const std::vector<glm::vec3> turned = posed(avatar, pose);
  expect_near(turned[0], {0, 1, 0});
  expect_near(turned[1], {1, 1, 0});
  expect_near(turned[2], {0.25F, 2.25F, 0});
  expect_near(turned[3], {-0.25F, 1.75F, 0});
}

TEST(AvatarReader, MorphsMoveBeforeBonesDo) {
  const Avatar avatar = read(tiny_avatar());
  AvatarPose pose = rest_pose(avatar);
  pose.morph_weights[0][0] = 0.5F;
  pose.rotation[1] = axis_angle(Vec3(0, 0, 1), kPi / 2);  // the hips at (0, 1): (0, 2.125) goes to (-1.125, 1)
  expect_near(posed(avatar, pose)[3], {-1.125F, 1, 0});
  AvatarPoser poser(avatar);
  poser.pose(pose);
  expect_near(poser.parts().front().normals[0], {0, 0, 1});
}

TEST(AvatarReader, TheNodeOfASkinnedMeshDoesNotMoveIt) {
  GlbDocument document = tiny_avatar();
  document.json["nodes"][4]["translation"] = {7, 7, 7};
  const Avatar skinned = read(document);
  expect_near(posed(skinned, rest_pose(skinned))[0], {0, 1, 0});
  document.json["nodes"][4].erase("skin");
  const Avatar rigid = read(document);
  expect_near(posed(rigid, rest_pose(rigid))[0], {7, 8, 7});
}

TEST(AvatarReader, RootTranslationMovesAll) {
  const Avatar avatar = read(tiny_avatar());
  AvatarPose pose = rest_pose(avatar);
  pose.translation = Vec3(1, 2, 3);
  expect_near(posed(avatar, pose)[2], {2, 4, 3});
}

TEST(AvatarReader, MatricesBecomeTranslationRotationAndScale) {
  GlbDocument document = tiny_avatar();
  auto& node = document.json["nodes"][4];
  node.erase("skin");
  // Columns: 2 x along Y, 3 y along -X, z; moved by (5, 6, 7).
  node["matrix"] = {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
  const Avatar avatar = read(document);
  const std::vector<glm::vec3> positions = posed(avatar, rest_pose(avatar));
  expect_near(positions[1], {5 - 3, 6 + 2, 7});  // (1, 1, 0)
  expect_near(positions[2], {5 - 6, 6 + 2, 7});  // (1, 2, 0)
  node["matrix"] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const Avatar mirrored = read(document);
  expect_near(posed(mirrored, rest_pose(mirrored))[1], {-1, 1, 0});
  EXPECT_FALSE(warns(mirrored, "sheared"));
  node["matrix"] = {1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  EXPECT_TRUE(warns(read(document), "sheared"));
}

TEST(AvatarReader, WeightsAreNormalisedAndTheFourHeaviestStay) {
  GlbDocument document = tiny_avatar();
  auto& attributes = document.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["WEIGHTS_0"] = add_floats(document, "VEC4", 4, {2, 2, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, .4F, .2F, .1F, .1F});
  attributes["JOINTS_1"] = test::add_bytes(document, "VEC4", 4, std::string("\1\0\0\0\1\0\0\0\1\0\0\0\1\0\0\0", 16));
  attributes["WEIGHTS_1"] = add_floats(document, "VEC4", 4, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, .3F, 0, 0, 0});
  const Avatar avatar = read(document);
  const AvatarVertices& vertices = avatar.meshes[0].vertices[0];
  EXPECT_EQ(vertices.weights[0], glm::vec4(0.5F, 0.5F, 0, 0));
  EXPECT_EQ(vertices.weights[2], glm::vec4(1, 0, 0, 0));
  EXPECT_FLOAT_EQ(vertices.weights[3].x, 0.4F);
  EXPECT_FLOAT_EQ(vertices.weights[3].y, 0.3F);
  EXPECT_FLOAT_EQ(vertices.weights[3].z, 0.2F);
  EXPECT_EQ(vertices.joints[3].y, 1);
  EXPECT_TRUE(warns(avatar, "more than four"));
  EXPECT_TRUE(warns(avatar, "no bone"));
}

TEST(AvatarReader, PrimitivesOverTheSameVerticesShareThem) {
  GlbDocument document = tiny_avatar();
  auto& primitives = document.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  EXPECT_EQ(read(document).meshes[0].vertices.size(), 1U);
  primitives[1]["targets"] = json::array();
  const Avatar avatar = read(document);
  EXPECT_EQ(avatar.meshes[0].vertices.size(), 2U);
  EXPECT_EQ(avatar.meshes[0].surfaces[1].vertices, 1);
  AvatarPose pose = rest_pose(avatar);
  pose.morph_weights[0][0] = 1.0F;
  AvatarPoser poser(avatar);
  poser.pose(pose);
  expect_near(poser.parts()[0].positions[3], {0, 2.25F, 0});
  expect_near(poser.parts()[1].positions[3], {0, 2, 0});
}

TEST(AvatarReader, QuantisedNumbersAreRead) {
  GlbDocument document = tiny_avatar();
  document.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const auto add_shorts = [&](const char* type, const std::vector<int16_t>& values, size_t stride, bool is_normalised) {
    std::string bytes;
    for (const int16_t value : values)
      append_little_endian(bytes, value);
    const size_t view = document.add_view(bytes);
    document.json["bufferViews"][view]["byteStride"] = stride;
    document.json["accessors"].push_back(
        {{"bufferView", view}, {"componentType", 5122}, {"count", 4}, {"type", type}, {"normalized", is_normalised}});
    return document.json["accessors"].size() - 1;
  };
  auto& attributes = document.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["POSITION"] = add_shorts("VEC3", {0, 1, 0, 0, 1, 1, 0, 0, 1, -2, 0, 0, 0, 2, 0, 0}, 8, false);
  attributes["TEXCOORD_0"] = add_shorts("VEC2", {0, 32767, 32767, 32767, -32768, 0, 0, 0}, 4, true);
  const Avatar avatar = read(document);
  EXPECT_EQ(avatar.meshes[0].vertices[0].positions[2], glm::vec3(1, -2, 0));
  EXPECT_EQ(avatar.meshes[0].vertices[0].texture_coordinates[1], glm::vec2(1, 1));
  EXPECT_EQ(avatar.meshes[0].vertices[0].texture_coordinates[2], glm::vec2(-1, 0));
}

TEST(AvatarReader, StripsAndFansBecomeTriangles) {
  GlbDocument document = tiny_avatar();
  auto& primitive = document.json["meshes"][0]["primitives"][0];
  primitive["indices"] = test::add_bytes(document, "SCALAR", 4, std::string("\0\1\3\2", 4));
  primitive["mode"] = 5;
  EXPECT_EQ(read(document).meshes[0].surfaces[0].indices, (std::vector<uint32_t>{0, 1, 3, 3, 1, 2}));
  primitive["indices"] = test::add_bytes(document, "SCALAR", 4, std::string("\0\1\2\3", 4));
  primitive["mode"] = 6;
  EXPECT_EQ(read(document).meshes[0].surfaces[0].indices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
}

TEST(AvatarReader, MissingNormalsComeFromTheTriangles) {
  GlbDocument document = tiny_avatar();
  document.json["meshes"][0]["primitives"][0]["attributes"].erase("NORMAL");
  const Avatar avatar = read(document);
  for (const glm::vec3& normal : avatar.meshes[0].vertices[0].normals)
    expect_near(normal, {0, 0, 1});
}

TEST(AvatarReader, OnlyTheDefaultSceneIsShown) {
  GlbDocument document = tiny_avatar();
  document.json["nodes"].push_back({{"name", "spare"}, {"mesh", 0}});
  const Avatar avatar = read(document);
  EXPECT_EQ(triangle_count(avatar), 2U);
  document.json["scenes"][0]["nodes"].push_back(5);
  EXPECT_EQ(triangle_count(read(document)), 4U);
}

TEST(AvatarReader, BindsAndImagesThatLeadNowhereOnlyWarn) {
  GlbDocument document = tiny_avatar();
  document.json["extensions"]["VRMC_vrm"]["expressions"]["preset"]["aa"]["morphTargetBinds"][0]["index"] = 9;
  document.json["images"][0] = {{"name", "skin"}, {"uri", "missing.png"}};
  const Avatar avatar = read(document);
  EXPECT_TRUE(avatar.expressions.at(0).binds.empty());
  EXPECT_TRUE(warns(avatar, "aa"));
  EXPECT_TRUE(warns(avatar, "skin"));
}

TEST(AvatarReader, ImagesWrapAsTheirSamplersSay) {
  GlbDocument document = tiny_avatar();
  const auto surface = [&document] { return read(document).meshes.at(0).surfaces.at(0); };
  EXPECT_EQ(surface().wrap_u, ImageWrap::kRepeat) << "glTF's default";
  EXPECT_EQ(surface().wrap_v, ImageWrap::kRepeat);
  document.json["textures"][0]["sampler"] = 0;
  document.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}}};
  EXPECT_EQ(surface().wrap_u, ImageWrap::kClamp);
  EXPECT_EQ(surface().wrap_v, ImageWrap::kMirroredRepeat);
  document.json["samplers"] = {{{"wrapS", 10497}}};
  EXPECT_EQ(surface().wrap_u, ImageWrap::kRepeat);
  EXPECT_EQ(surface().wrap_v, ImageWrap::kRepeat);
  for (const int bad : {0, -1, 33070, INT_MAX}) {
    document.json["samplers"] = {{{"wrapT", bad}}};
    const auto refused = parse_avatar_text(document.pack());
    ASSERT_FALSE(refused) << bad;
    EXPECT_EQ(refused.error().code, ErrorCode::kMalformed);
  }
}

// KHR_texture_transform: scaled, then turned counter-clockwise on the image (v runs down), then moved.
TEST(AvatarReader, ImagesAreScaledTurnedAndMoved) {
  GlbDocument document = tiny_avatar();
  auto& info = document.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  info["extensions"]["KHR_texture_transform"] = {
      {"offset", {0.5, 0.25}}, {"rotation", 1.5707963267948966}, {"scale", {2, 4}}};
  const ImagePlacement placement = read(document).meshes.at(0).surfaces.at(0).placement;
  EXPECT_EQ(placement.origin, glm::vec2(0.5F, 0.25F));
  EXPECT_NEAR(placement.x_axis.x, 0.0F, 1e-6F);
  EXPECT_NEAR(placement.x_axis.y, -2.0F, 1e-6F);
  EXPECT_NEAR(placement.y_axis.x, 4.0F, 1e-6F);
  EXPECT_NEAR(placement.y_axis.y, 0.0F, 1e-6F);
  // It may choose other coordinates, of which there are none here.
  info["extensions"]["KHR_texture_transform"] = {{"texCoord", 1}};
  EXPECT_TRUE(read(document).meshes.at(0).vertices.at(0).texture_coordinates.empty());
  info["extensions"]["KHR_texture_transform"] = {{"texCoord", 99}};
  EXPECT_FALSE(parse_avatar_text(document.pack()));
  for (const auto& odd : {nlohmann::json{{"offset", 3}}, nlohmann::json{{"scale", {1e300, "x"}}},
                          nlohmann::json{{"rotation", 1e300}}, nlohmann::json::array({1, 2})}) {
    info["extensions"]["KHR_texture_transform"] = odd;
    const auto odd_one = parse_avatar_text(document.pack());
    ASSERT_TRUE(odd_one) << odd.dump();
    EXPECT_LE(std::fabs(odd_one->meshes.at(0).surfaces.at(0).placement.x_axis.x), 1e4F);
  }
}

TEST(AvatarReader, MasksHaveACutOff) {
  GlbDocument document = tiny_avatar();
  const auto cutoff = [&document] { return read(document).meshes.at(0).surfaces.at(0).alpha_cutoff; };
  auto& material = document.json["materials"][0];
  EXPECT_EQ(cutoff(), std::nullopt);
  material["alphaCutoff"] = 0.25;
  EXPECT_EQ(cutoff(), std::nullopt) << "only masks have one";
  material["alphaMode"] = "MASK";
  EXPECT_EQ(cutoff(), 0.25F);
  material.erase("alphaCutoff");
  EXPECT_EQ(cutoff(), 0.5F) << "glTF's default";
  material["alphaCutoff"] = 1e300;
  EXPECT_GT(cutoff().value(), 1.0F);
  material["alphaCutoff"] = -3.0;
  EXPECT_EQ(cutoff(), 0.0F);
  material["alphaMode"] = "BLEND";
  EXPECT_EQ(cutoff(), std::nullopt);
}

TEST(AvatarReader, KnownExtensionsMayBeRequired) {
  GlbDocument document = tiny_avatar();
  document.json["extensionsRequired"] = {"KHR_materials_unlit", "VRMC_vrm"};
  EXPECT_TRUE(parse_avatar_text(document.pack()));
  document.json["extensionsRequired"].push_back("KHR_draco_mesh_compression");
  const auto refused = parse_avatar_text(document.pack());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kUnsupported);
  EXPECT_NE(refused.error().message.find("draco"), std::string::npos);
}

TEST(AvatarReader, MorphNamesOfArkitAreKnownInEverySpelling) {
  for (const char* name : {"eyeBlinkLeft", "EyeBlinkLeft", "eyeBlink_L", "face.eyeBlinkLeft", "eye_blink_left"}) {
    GlbDocument document = tiny_avatar();
    document.json["meshes"][0]["extras"]["targetNames"] = {name};
    const Avatar avatar = read(document);
    EXPECT_EQ(face(avatar, FaceChannel::kEyeBlinkLeft).means, FaceDrive::Means::kMorph) << name;
    EXPECT_EQ(face(avatar, FaceChannel::kEyeBlinkRight).means, FaceDrive::Means::kNone) << name;
    EXPECT_EQ(face(avatar, FaceChannel::kJawOpen).source, "aa") << name;
  }
}

TEST(AvatarReader, MorphNamesOfVroidAndOculusComeNearChannels) {
  for (const auto& [name, channel, share] : {std::tuple("Face.M_F00_000_00_Fcl_MTH_A", FaceChannel::kJawOpen, 1.0),
                                             std::tuple("Fcl_EYE_Close_R", FaceChannel::kEyeBlinkRight, 1.0),
                                             std::tuple("Fcl_MTH_Fun", FaceChannel::kMouthSmileLeft, 0.5),
                                             std::tuple("viseme_PP", FaceChannel::kMouthPressRight, 0.5)}) {
    GlbDocument document = tiny_avatar(Avatar::Kind::kGltf);
    document.json["meshes"][0]["extras"]["targetNames"] = {name};
    const Avatar avatar = read(document);
    EXPECT_EQ(face(avatar, channel).means, FaceDrive::Means::kMorph) << name;
    ASSERT_EQ(face(avatar, channel).binds.size(), 1U) << name;
    EXPECT_EQ(face(avatar, channel).binds[0].weight, share) << name;
  }
  GlbDocument document = tiny_avatar(Avatar::Kind::kGltf);
  document.json["meshes"][0]["extras"]["targetNames"] = {"noFcl_MTH_A"};
  EXPECT_EQ(face(read(document), FaceChannel::kJawOpen).means, FaceDrive::Means::kNone);
}

}  // namespace
}  // namespace auslan
