// SPDX-License-Identifier: Apache-2.0
// What other programs write and a figure may still be.
#include "glb_document.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace auslan {
namespace {

using test::difference;
using test::glb_bytes;
using test::GlbDocument;
using test::open_glb;
using test::parse_text;
using test::tiny_figure;

class GltfReader : public testing::Test {
 protected:
  void expect_figure(const Figure& expected) const {
    const auto read = parse_text(document_.pack());
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(difference(expected, *read), "");
  }

  Figure figure_ = tiny_figure();
  GlbDocument document_ = open_glb(glb_bytes(figure_));
};

std::string base64(const std::string& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k)
      group = group << 8U | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0U);
    for (size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[group >> (18U - 6U * k) & 63U];
  }
  return text;
}

TEST_F(GltfReader, TextWithAnExternalBuffer) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "parts");
  document_.json["buffers"][0]["uri"] = "parts/figure%20data.bin";
  put_bytes(folder / "parts/figure data.bin", document_.binary);
  put_bytes(folder / "figure.gltf", document_.json.dump());
  const auto read = read_gltf(folder / "figure.gltf");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(difference(figure_, *read), "");
}

TEST_F(GltfReader, TextWithAnEmbeddedBuffer) {
  document_.json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(document_.binary);
  const auto read = parse_text(document_.json.dump());
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(difference(figure_, *read), "");
}

TEST_F(GltfReader, MatrixThatOnlyTranslates) {
  document_.json["nodes"][4].erase("translation");
  document_.json["nodes"][4]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, -2, 4, 1};
  std::vector<Node> nodes = test::sample_nodes();
  nodes[4].offset = Vec3(0.5, -2.0, 4.0);
  figure_.skeleton = Skeleton::build(nodes).value();
  expect_figure(figure_);
}

TEST_F(GltfReader, IdentityRotationAndScaleAreNoRotationAndScale) {
  document_.json["nodes"][4]["rotation"] = {0, 0, 0, -1};  // the other quaternion of the same rotation
  document_.json["nodes"][4]["scale"] = {1, 1, 1};
  expect_figure(figure_);
}

TEST_F(GltfReader, NodesInAnyOrderBecomeDepthFirst) {
  // The last node of the file takes the place of the first: only the hierarchy and the order of children count.
  auto& nodes = document_.json["nodes"];
  std::swap(nodes[2], nodes[38]);
  for (auto& node : nodes)
    if (node.contains("children"))
      for (auto& child : node["children"]) {
        if (child == 2)
          child = 38;
        else if (child == 38)
          child = 2;
      }
  expect_figure(figure_);
}

TEST_F(GltfReader, DenseMorphTargetsKeepWhatMoves) {
  std::string dense;
  for (const float value : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 2.0F, 0.0F})
    append_little_endian(dense, value);
  const size_t view = document_.add_view(dense);
  auto& target = document_.target(0, 0);
  target.erase("sparse");
  target["bufferView"] = view;
  expect_figure(figure_);
}

TEST_F(GltfReader, SparsePartReplacesValuesOfTheDensePart) {
  std::string dense;
  for (int i = 0; i < 12; ++i)
    append_little_endian(dense, 8.0F);
  document_.target(0, 0)["bufferView"] = document_.add_view(dense);
  figure_.segments[2].morphs[0].vertices = {0, 1, 2, 3};
  figure_.segments[2].morphs[0].displacement = {
      glm::vec3(8.0F), {1.0F, 0.0F, 0.0F}, glm::vec3(8.0F), {0.0F, 2.0F, 0.0F}};
  expect_figure(figure_);
}

TEST_F(GltfReader, MorphTargetsThatAreNoFaceChannelAreLeftOut) {
  document_.json["meshes"][0]["extras"]["targetNames"] = {"mouthDimpleLeft"};
  figure_.segments[2].morphs.clear();
  expect_figure(figure_);
}

TEST_F(GltfReader, MeshWithoutIndicesTakesItsVerticesInTurn) {
  auto& primitive = document_.json["meshes"][0]["primitives"][0];
  primitive.erase("indices");
  for (const char* name : {"POSITION", "NORMAL", "COLOR_0", "_PAINT"})
    document_.attribute(0, name)["count"] = 3;
  primitive.erase("targets");
  Mesh& mesh = figure_.segments[2];
  mesh.positions.pop_back();
  mesh.normals.pop_back();
  mesh.colours.pop_back();
  mesh.paint.pop_back();
  mesh.indices = {0, 1, 2};
  mesh.morphs.clear();
  expect_figure(figure_);
}

// Linear 0, 1/255 (sRGB 12.7), 55/255 (sRGB 127.7) and 1, by IEC 61966-2-1.
TEST_F(GltfReader, ByteColoursAreLinearLight) {
  std::string bytes;
  for (int vertex = 0; vertex < 4; ++vertex)
    bytes += std::string("\x00\x01\x37\x00", 4);
  auto& accessor = document_.attribute(0, "COLOR_0");
  accessor["bufferView"] = document_.add_view(bytes);
  accessor["byteOffset"] = 0;
  accessor["componentType"] = 5121;
  for (glm::u8vec4& colour : figure_.segments[2].colours)
    colour = glm::u8vec4(0, 13, 128, 255);
  expect_figure(figure_);
}

// Linear 0.25 is sRGB (1.055 * 0.25^(1/2.4) - 0.055) * 255 = 136.96; values outside 0 to 1 are clamped.
TEST_F(GltfReader, FloatColoursAreLinearLight) {
  std::string bytes;
  for (int vertex = 0; vertex < 4; ++vertex)
    for (const float value : {0.25F, -3.0F, 7.0F})
      append_little_endian(bytes, value);
  auto& accessor = document_.attribute(0, "COLOR_0");
  accessor["bufferView"] = document_.add_view(bytes);
  accessor["byteOffset"] = 0;
  accessor["componentType"] = 5126;
  accessor["type"] = "VEC3";
  accessor.erase("normalized");
  for (glm::u8vec4& colour : figure_.segments[2].colours)
    colour = glm::u8vec4(137, 0, 255, 255);
  expect_figure(figure_);
}

TEST_F(GltfReader, MeshWithoutColoursTakesTheMaterials) {
  document_.json["meshes"][0]["primitives"][0]["attributes"].erase("COLOR_0");
  document_.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.25, 0.0, 1.0, 1.0};
  for (glm::u8vec4& colour : figure_.segments[2].colours)
    colour = glm::u8vec4(137, 0, 255, 255);
  expect_figure(figure_);
}

TEST_F(GltfReader, ImagesAreLookedAtButNotDecoded) {
  std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x04\0\0\0\x04\0", 24);  // 1024 x 1024, no pixels
  const size_t view = document_.add_view(png);
  document_.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
  expect_figure(figure_);
}

}  // namespace
}  // namespace auslan
