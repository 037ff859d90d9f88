// SPDX-License-Identifier: Apache-2.0
// Broken and hostile figures of other makers: each is refused with the right code, without a crash and without much
// memory. What the container alone refuses is tested in gltf_hostile_test.
#include "avatar_promises.h"
#include "counted_memory.h"
#include "sample_avatars.h"
#include "tiny_avatar.h"

#include <climits>
#include <cstdint>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <sys/stat.h>
#include <utility>
#include <vector>

namespace auslan {
namespace {

using nlohmann::json;
using test::broken_promise;
using test::GlbDocument;
using test::live_bytes;
using test::parse_avatar_text;
using test::peak_bytes;
using test::tiny_avatar;

class AvatarHostile : public testing::Test {
 protected:
  /// Refused with this code, with a message, holding at most so many bytes beyond what was held before.
  static void expect_refused(const std::string& bytes, ErrorCode code, const std::filesystem::path& folder = {},
                             size_t most_bytes = size_t{64} << 20) {
    const size_t before = live_bytes;
    peak_bytes = before;
    const auto read = parse_avatar_text(bytes, folder);
    EXPECT_LT(peak_bytes - before, most_bytes);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, code) << to_string(read.error());
    EXPECT_FALSE(read.error().message.empty());
  }
  void expect_refused(ErrorCode code) const { expect_refused(document_.pack(), code); }
  /// Read, and all that avatar.h promises holds.
  void expect_read() const {
    const auto read = parse_avatar_text(document_.pack());
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(broken_promise(*read), "");
  }
  json& primitive() { return document_.json["meshes"][0]["primitives"][0]; }

  GlbDocument document_ = tiny_avatar();
  const json original_ = document_.json;
};

TEST_F(AvatarHostile, UnchangedFileIsRead) {
  expect_read();
  document_ = tiny_avatar(Avatar::Kind::kVrm0);
  expect_read();
  document_ = tiny_avatar(Avatar::Kind::kGltf);
  expect_read();
}

TEST_F(AvatarHostile, TruncatedAnywhere) {
  const std::string glb = document_.pack();
  for (size_t length = 0; length < glb.size(); length += 7)
    expect_refused(glb.substr(0, length), ErrorCode::kMalformed);
}

TEST_F(AvatarHostile, EveryFlippedByteIsRefusedOrGivesAWholeFigure) {
  for (const Avatar::Kind kind : {Avatar::Kind::kVrm1, Avatar::Kind::kVrm0}) {
    const std::string glb = tiny_avatar(kind).pack();
    for (size_t i = 0; i < glb.size(); ++i) {
      std::string broken = glb;
      broken[i] = static_cast<char>(static_cast<unsigned char>(broken[i]) ^ (1U << i % 8));
      const auto read = parse_avatar_text(broken);
      if (read)
        ASSERT_EQ(broken_promise(*read), "") << "byte " << i;
      else
        ASSERT_FALSE(read.error().message.empty()) << "byte " << i;
    }
  }
}

// Every value of the document in turn becomes something else.
TEST_F(AvatarHostile, EveryValueOfTheDocumentReplaced) {
  const std::vector<json> others = {
      -1,  0,    1,       2,       77,    INT_MAX,       INT_MIN,        uint64_t{1} << 40U,
      0.5, 1e30, nullptr, "other", false, json::array(), json::object(), json::array({0})};
  for (const Avatar::Kind kind : {Avatar::Kind::kVrm1, Avatar::Kind::kVrm0}) {
    const GlbDocument whole = tiny_avatar(kind);
    const json flat = whole.json.flatten();
    for (const auto& [pointer, value] : flat.items())
      for (const json& other : others)
        // The value itself, and the object or list that holds it.
        for (json::json_pointer at(pointer); !at.empty(); at = at.parent_pointer()) {
          GlbDocument document = whole;
          document.json[at] = other;
          const size_t before = live_bytes;
          peak_bytes = before;
          const auto read = parse_avatar_text(document.pack());
          ASSERT_LT(peak_bytes - before, size_t{64} << 20) << at.to_string() << " " << other;
          if (read)
            ASSERT_EQ(broken_promise(*read), "") << at.to_string() << " " << other;
          else
            ASSERT_FALSE(read.error().message.empty()) << at.to_string() << " " << other;
          if (at.to_string().size() + 3 < pointer.size()) break;
        }
  }
}

TEST_F(AvatarHostile, NodesThatAreNoTree) {
  const auto with_child = [&](size_t node, int child) {
    document_.json = original_;
    document_.json["nodes"][node]["children"].push_back(child);
    expect_refused(ErrorCode::kMalformed);
  };
  with_child(3, 0);  // a cycle through the root
  with_child(3, 2);  // a cycle
  with_child(4, 4);  // its own child
  with_child(4, 2);  // two parents
  with_child(4, 5);  // does not exist
  with_child(4, -2);
  with_child(4, INT_MAX);
  document_.json = original_;
  document_.json["scenes"][0]["nodes"] = {77};
  expect_refused(ErrorCode::kMalformed);
  document_.json["scene"] = 3;
  expect_refused(ErrorCode::kMalformed);
}

TEST_F(AvatarHostile, ChainsAsDeepAsTheyMayBe) {
  const auto with_chain = [&](size_t count) {
    document_.json = original_;
    json& nodes = document_.json["nodes"];
    while (nodes.size() < count) {
      nodes.back()["children"] = {nodes.size()};
      nodes.push_back({{"scale", {1e9, 1e9, 1e9}}});
    }
  };
  with_chain(kMaxAvatarNodes + 1);
  expect_refused(ErrorCode::kLimit);
  with_chain(kMaxAvatarNodes);  // of scales whose product overflows
  expect_refused(ErrorCode::kMalformed);
  for (size_t i = 5; i < kMaxAvatarNodes; ++i)
    document_.json["nodes"][i].erase("scale");
  expect_read();
}

TEST_F(AvatarHostile, ReferencesToNothing) {
  for (const int index : {999, INT_MAX})
    for (const char* pointer :
         {"/nodes/4/mesh", "/nodes/4/skin", "/skins/0/joints/1", "/skins/0/inverseBindMatrices",
          "/meshes/0/primitives/0/indices", "/meshes/0/primitives/0/material",
          "/meshes/0/primitives/0/attributes/POSITION", "/meshes/0/primitives/0/attributes/JOINTS_0",
          "/meshes/0/primitives/0/attributes/WEIGHTS_0", "/meshes/0/primitives/0/attributes/TEXCOORD_0",
          "/meshes/0/primitives/0/targets/0/POSITION", "/accessors/0/bufferView", "/bufferViews/0/buffer",
          "/textures/0/source", "/textures/0/sampler", "/materials/0/pbrMetallicRoughness/baseColorTexture/index",
          "/materials/0/pbrMetallicRoughness/baseColorTexture/texCoord", "/images/0/bufferView",
          "/extensions/VRMC_vrm/humanoid/humanBones/hips/node"}) {
      document_.json = original_;
      const json::json_pointer at(pointer);
      ASSERT_TRUE(pointer == std::string("/materials/0/pbrMetallicRoughness/baseColorTexture/texCoord") ||
                  pointer == std::string("/textures/0/sampler") || document_.json.contains(at))
          << pointer;
      document_.json[at] = index;
      const auto read = parse_avatar_text(document_.pack());
      ASSERT_FALSE(read) << pointer;
      EXPECT_EQ(read.error().code, ErrorCode::kMalformed) << pointer << " " << to_string(read.error());
      EXPECT_FALSE(read.error().message.empty()) << pointer;
    }
}

TEST_F(AvatarHostile, JointsAndIndicesOutOfRange) {
  const size_t joints = document_.start(document_.attribute(0, "JOINTS_0"));
  document_.store(joints, uint8_t{2});  // of two joints
  expect_refused(ErrorCode::kMalformed);
  document_.store(joints, uint8_t{0});
  document_.store(joints + 3, uint8_t{200});  // its weight is 0, so that it counts for nothing
  expect_read();
  document_.store(document_.start(document_.index_accessor(0)), uint8_t{4});  // of four vertices
  expect_refused(ErrorCode::kMalformed);
}

TEST_F(AvatarHostile, FewerMatricesThanJointsAndFewerNumbersThanVertices) {
  document_.json["skins"][0]["joints"].push_back(3);
  expect_refused(ErrorCode::kMalformed);
  document_.json = original_;
  document_.json["skins"][0]["joints"] = json::array();
  expect_refused(ErrorCode::kMalformed);
  for (const char* name : {"NORMAL", "TEXCOORD_0", "JOINTS_0", "WEIGHTS_0"}) {
    document_.json = original_;
    document_.attribute(0, name)["count"] = 3;
    expect_refused(ErrorCode::kMalformed);
  }
  document_.json = original_;
  document_.target(0, 0)["count"] = 3;
  expect_refused(ErrorCode::kMalformed);
}

TEST_F(AvatarHostile, SkinsWithMoreJointsThanThereAreNodes) {
  document_.json["skins"][0] = {{"joints", json(std::vector<int>(kMaxAvatarNodes + 1, 1))}};
  expect_refused(ErrorCode::kLimit);
}

TEST_F(AvatarHostile, NumbersThatAreNotFiniteOrHuge) {
  const std::string binary = document_.binary;
  const json matrices = document_.json["accessors"][document_.json["skins"][0]["inverseBindMatrices"].get<size_t>()];
  for (const json& accessor :
       {document_.attribute(0, "POSITION"), document_.attribute(0, "NORMAL"), document_.attribute(0, "TEXCOORD_0"),
        document_.attribute(0, "WEIGHTS_0"), document_.target(0, 0), matrices})
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
      document_.binary = binary;
      document_.store(document_.start(accessor) + 4, value);
      expect_refused(ErrorCode::kMalformed);
    }
  for (const json& accessor : {document_.attribute(0, "POSITION"), matrices}) {
    document_.binary = binary;
    document_.store(document_.start(accessor), 1e30F);
    expect_refused(ErrorCode::kMalformed);
  }
  document_.binary = binary;
  for (const auto& [key, value] :
       std::vector<std::pair<std::string, json>>{{"translation", {1e300, 0, 0}},
                                                 {"translation", {1e8, 0, 0}},
                                                 {"scale", {1e300, 1, 1}},
                                                 {"rotation", {0, 0, 0, 0}},
                                                 {"rotation", {1, 0}},
                                                 {"matrix", {1, 2, 3}},
                                                 {"matrix", json(std::vector<double>(16, 1e200))}}) {
    document_.json = original_;
    document_.json["nodes"][2][key] = value;
    expect_refused(ErrorCode::kMalformed);
  }
}

TEST_F(AvatarHostile, FlatAndStrangeNodesAreReadAsFarAsTheyGo) {
  for (const auto& [key, value] : std::vector<std::pair<std::string, json>>{
           {"scale", {0, 0, 0}}, {"matrix", json(std::vector<double>(16, 0.0))}, {"rotation", {0, 0, 3, 4}}}) {
    document_.json = original_;
    document_.json["nodes"][2][key] = value;
    expect_read();
  }
}

// A short file may ask for any number of zeros, and for the same data any number of times.
TEST_F(AvatarHostile, ZerosAndRepetitionsHaveABound) {
  auto& position = document_.attribute(0, "POSITION");
  position.erase("bufferView");
  position["count"] = uint64_t{1} << 40U;
  expect_refused(ErrorCode::kLimit);

  document_.json = original_;
  const size_t zeros = document_.json["accessors"].size();
  document_.json["accessors"].push_back({{"componentType", 5126}, {"count", 999'999}, {"type", "VEC3"}});
  json parts = json::array();
  for (int i = 0; i < 1000; ++i)  // each differs from the last, so that none shares its vertices
    parts.push_back({{"attributes", {{"POSITION", zeros}, {"EXTRA_" + std::to_string(i), 0}}}});
  document_.json["meshes"][0]["primitives"] = parts;
  expect_refused(document_.pack(), ErrorCode::kLimit, {}, size_t{256} << 20);

  parts = json(std::vector<json>(1000, parts[0]));  // one set of vertices, a third of a million triangles a time
  document_.json["meshes"][0]["primitives"] = parts;
  expect_refused(document_.pack(), ErrorCode::kLimit, {}, size_t{256} << 20);

  parts = json(std::vector<json>(1100, parts[0]));
  document_.json["meshes"][0]["primitives"] = parts;
  expect_refused(document_.pack(), ErrorCode::kLimit);

  document_.json = original_;  // one mesh shown by many nodes
  for (auto& [name, accessor] : primitive()["attributes"].items())
    accessor = zeros;
  document_.json["accessors"].push_back({{"componentType", 5126}, {"count", 999'999}, {"type", "VEC3"}});
  primitive()["attributes"] = {{"POSITION", zeros}};
  primitive().erase("targets");
  for (int i = 5; i < 1000; ++i) {
    document_.json["nodes"].push_back({{"mesh", 0}});
    document_.json["scenes"][0]["nodes"].push_back(i);
  }
  expect_refused(document_.pack(), ErrorCode::kLimit, {}, size_t{256} << 20);
}

TEST_F(AvatarHostile, MorphTargetsOfZerosTakeNoRoom) {
  const size_t zeros = document_.json["accessors"].size();
  document_.json["accessors"].push_back({{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}});
  primitive()["targets"] = json(std::vector<json>(20'000, json{{"POSITION", zeros}, {"NORMAL", zeros}}));
  const size_t before = live_bytes;
  peak_bytes = before;
  expect_read();
  EXPECT_LT(peak_bytes - before, size_t{64} << 20);
}

TEST_F(AvatarHostile, ImagesAreBoundedAloneAndTogether) {
  const size_t giant = document_.add_view(test::png_head(9000));
  document_.json["images"][0]["bufferView"] = giant;
  expect_refused(ErrorCode::kLimit);

  document_ = tiny_avatar();
  const size_t large = document_.add_view(test::png_head(16) + std::string(size_t{1} << 20, 'x'));
  document_.json["images"] = json(std::vector<json>(100, json{{"bufferView", large}, {"mimeType", "image/png"}}));
  expect_refused(document_.pack(), ErrorCode::kLimit, {}, size_t{128} << 20);

  document_.json["images"] = {{{"bufferView", document_.add_view("no image at all")}, {"mimeType", "image/png"}}};
  const auto read = parse_avatar_text(document_.pack());
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->images[0].format, AvatarImage::Format::kOther);
  EXPECT_TRUE(read->images[0].bytes.empty());
}

TEST_F(AvatarHostile, UrisThatLeaveTheFolder) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "inner");
  put_bytes(folder / "outside.png", test::png_head(16));
  std::filesystem::create_symlink(folder / "outside.png", folder / "inner/link.png");
  ASSERT_EQ(::mkfifo((folder / "inner/pipe.png").c_str(), 0600), 0);
  for (const std::string& uri : {std::string("../outside.png"), std::string("%2e%2e/outside.png"),
                                 std::string("/etc/passwd"), std::string("http://example.org/skin.png")}) {
    document_.json["images"][0] = {{"uri", uri}};
    expect_refused(document_.pack(), ErrorCode::kUnsupported, folder / "inner");
  }
  // Images that cannot be had cost their colours only; nothing of them is read.
  for (const char* uri : {"link.png", "pipe.png", "missing.png"}) {
    document_.json["images"][0] = {{"uri", uri}};
    const auto read = parse_avatar_text(document_.pack(), folder / "inner");
    ASSERT_TRUE(read) << uri << " " << to_string(read.error());
    EXPECT_TRUE(read->images[0].bytes.empty()) << uri;
    EXPECT_FALSE(read->warnings.empty()) << uri;
  }
  document_.json = original_;
  document_.json["buffers"][0]["uri"] = "pipe.png";
  expect_refused(document_.json.dump(), ErrorCode::kUnreadable, folder / "inner");
}

TEST_F(AvatarHostile, FilesThatAreNoFiles) {
  const ScratchFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const std::filesystem::path& path : {folder / "pipe", folder.path(), std::filesystem::path("/dev/zero")}) {
    const auto read = read_avatar(path);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kUnreadable) << to_string(read.error());
  }
  put_bytes(folder / "huge.glb", "glTF");
  std::filesystem::resize_file(folder / "huge.glb", kMaxGltfBytes + 1);  // takes no space: a hole
  const auto huge = read_avatar(folder / "huge.glb");
  ASSERT_FALSE(huge);
  EXPECT_EQ(huge.error().code, ErrorCode::kLimit);
  const auto missing = read_avatar(folder / "missing.glb");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kNotFound);
}

TEST_F(AvatarHostile, DeepAndVastExtensions) {
  const std::string deep = std::string(200'000, '[') + std::string(200'000, ']');
  expect_refused(R"({"asset":{"version":"2.0"},"extensions":{"VRM":)" + deep + "}}", ErrorCode::kLimit);
  std::string vast = "[0";
  for (int i = 0; i < 500'000; ++i)
    vast += ",0";
  expect_refused(R"({"asset":{"version":"2.0"},"extensions":{"VRM":)" + vast + "]}}", ErrorCode::kLimit);
}

TEST_F(AvatarHostile, WarningsDoNotPileUp) {
  json& bones = document_.json["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"];
  for (int i = 0; i < 10'000; ++i)
    bones["bone" + std::to_string(i)] = {{"node", 1}};
  const auto read = parse_avatar_text(document_.pack());
  ASSERT_TRUE(read);
  EXPECT_LE(read->warnings.size(), 64U);
}

TEST_F(AvatarHostile, NothingToShow) {
  document_.json["scenes"][0]["nodes"] = {0};
  expect_refused(ErrorCode::kUnsupported);
  document_.json = original_;
  primitive()["mode"] = 1;
  expect_refused(ErrorCode::kUnsupported);
}

TEST(AvatarHostileSamples, DamagedSamplesAreRefusedOrGiveAWholeFigure) {
  for (const char* name : {"cryptovoxels.vrm", "godette.vrm"}) {
    AUSLAN_NEEDS_AVATAR(name);
    const std::string whole = bytes_of(test::sample_avatar(name));
    for (uint64_t i = 1; i <= 150; ++i) {
      std::string broken = whole;
      // Half of the places in the JSON, which stands first.
      const size_t range = i % 2 == 0 ? whole.size() : whole.size() / 16;
      broken[static_cast<size_t>(i * 15485863 % range)] = static_cast<char>(i * 37);
      const auto read = parse_avatar_text(broken);
      if (read) {
        ASSERT_EQ(broken_promise(*read), "") << name << " " << i;
      }
    }
  }
}

}  // namespace
}  // namespace auslan
