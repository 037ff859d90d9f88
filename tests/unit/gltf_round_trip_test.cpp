// SPDX-License-Identifier: Apache-2.0
#include "glb_document.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace auslan {
namespace {

using test::difference;
using test::GlbDocument;
using test::open_glb;
using test::sample_figure;

TEST(GltfRoundTrip, GivesTheSameFigureBitForBit) {
  const ScratchFolder folder;
  const Figure figure = sample_figure();
  const auto written = write_gltf(figure, folder / "figure.glb");
  ASSERT_TRUE(written) << to_string(written.error());
  const auto read = read_gltf(folder / "figure.glb");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(difference(figure, *read), "");
}

TEST(GltfRoundTrip, FigureWithoutAnyMeshIsAFigure) {
  const ScratchFolder folder;
  Figure figure = sample_figure();
  for (Mesh& mesh : figure.segments)
    mesh = Mesh();
  figure.name.clear();
  ASSERT_TRUE(write_gltf(figure, folder / "bare.glb"));
  const auto read = read_gltf(folder / "bare.glb");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(difference(figure, *read), "");
}

TEST(GltfWriter, WritesTheSameBytesAgain) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_gltf(sample_figure(), folder / "a.glb"));
  ASSERT_TRUE(write_gltf(sample_figure(), folder / "b.glb"));
  EXPECT_EQ(bytes_of(folder / "a.glb"), bytes_of(folder / "b.glb"));
}

// IEC 61966-2-1: C / 12.92 up to 0.04045, ((C + 0.055) / 1.055)^2.4 above.
TEST(GltfWriter, ColoursAreLinearLight) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_gltf(sample_figure(), folder / "figure.glb"));
  const GlbDocument document = open_glb(bytes_of(folder / "figure.glb"));
  const Figure figure = sample_figure();
  const Mesh& mesh = figure.segments[2];
  const auto& primitive = document.json["meshes"][1]["primitives"][0];
  const auto& accessor = document.json["accessors"][primitive["attributes"]["COLOR_0"].get<size_t>()];
  EXPECT_TRUE(accessor["normalized"].get<bool>());
  EXPECT_EQ(accessor["componentType"], 5123);
  EXPECT_EQ(accessor["count"], mesh.colours.size());
  const auto& view = document.json["bufferViews"][accessor["bufferView"].get<size_t>()];
  const size_t start = view["byteOffset"].get<size_t>() + accessor["byteOffset"].get<size_t>();
  for (size_t i = 0; i < mesh.colours.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double code = mesh.colours[i][c] / 255.0;
      const double linear = code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
      const auto stored =
          load_little_endian<uint16_t>(document.binary.data() + start + 8 * i + 2 * static_cast<size_t>(c));
      ASSERT_NEAR(stored, linear * 65535.0, 0.51) << "code " << int{mesh.colours[i][c]};
    }
}

TEST(GltfWriter, NamesMorphTargetsAsArkitDoesAndStoresThemSparse) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_gltf(sample_figure(), folder / "figure.glb"));
  const GlbDocument document = open_glb(bytes_of(folder / "figure.glb"));
  const auto& mesh = document.json["meshes"][1];
  EXPECT_EQ(mesh["extras"]["targetNames"], nlohmann::json({"tongueOut", "jawOpen", "mouthPucker"}));
  const size_t target = mesh["primitives"][0]["targets"][0]["POSITION"].get<size_t>();
  const auto& accessor = document.json["accessors"][target];
  EXPECT_EQ(accessor["count"], 300);
  EXPECT_EQ(accessor["sparse"]["count"], 2);
  EXPECT_FALSE(accessor.contains("bufferView"));
}

TEST(GltfWriter, RefusesAFigureThatBreaksItsContractAndLeavesTheOldFile) {
  const ScratchFolder folder;
  put_bytes(folder / "figure.glb", "old");
  Figure figure = sample_figure();
  figure.segments[2].indices[1] = 300;
  const auto written = write_gltf(figure, folder / "figure.glb");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kMalformed);
  EXPECT_EQ(written.error().place, "head_base");
  EXPECT_EQ(bytes_of(folder / "figure.glb"), "old");
}

TEST(GltfWriter, RefusesNodesThatAreNotDepthFirst) {
  const ScratchFolder folder;
  std::vector<Node> nodes = test::sample_nodes();
  nodes.push_back({.name = "jaw", .parent = 2, .offset = Vec3(0.0)});
  Figure figure;
  figure.skeleton = Skeleton::build(nodes).value();
  figure.segments.resize(nodes.size());
  const auto written = write_gltf(figure, folder / "figure.glb");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kMalformed);
}

TEST(GltfWriter, RefusesNamesThatAreNotUtf8) {
  const ScratchFolder folder;
  Figure figure = test::tiny_figure();
  figure.name = "\xFF";
  const auto written = write_gltf(figure, folder / "figure.glb");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kMalformed);
}

}  // namespace
}  // namespace auslan
