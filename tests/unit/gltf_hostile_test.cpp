// SPDX-License-Identifier: Apache-2.0
// Broken and hostile files: each is refused with the right code, without a crash and without much memory.
#include "counted_memory.h"
#include "glb_document.h"
#include "kinematics/figure_file.h"
#include "sample_avatars.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <sys/stat.h>
#include <vector>

namespace auslan {
namespace {

using nlohmann::json;
using test::glb_bytes;
using test::GlbDocument;
using test::live_bytes;
using test::open_glb;
using test::parse_text;
using test::peak_bytes;
using test::tiny_figure;

class GltfHostile : public testing::Test {
 protected:
  /// Refused with this code, with a message, holding at most 64 MiB beyond what was held before.
  static void expect_refused(const std::string& bytes, ErrorCode code, const std::filesystem::path& folder = {}) {
    const size_t before = live_bytes;
    peak_bytes = before;
    const auto read = parse_text(bytes, folder);
    EXPECT_LT(peak_bytes - before, size_t{64} << 20);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, code) << to_string(read.error());
    EXPECT_FALSE(read.error().message.empty());
  }
  void expect_refused(ErrorCode code) const { expect_refused(document_.pack(), code); }

  GlbDocument document_ = open_glb(glb_bytes(tiny_figure()));
};

TEST_F(GltfHostile, UnchangedFileIsRead) {
  EXPECT_TRUE(parse_text(document_.pack()));
}

TEST_F(GltfHostile, TruncatedAnywhere) {
  const std::string glb = document_.pack();
  for (size_t part = 0; part < 37; ++part)
    expect_refused(glb.substr(0, glb.size() * part / 37), ErrorCode::kMalformed);
  expect_refused(glb.substr(0, glb.size() - 1), ErrorCode::kMalformed);
}

TEST_F(GltfHostile, EveryFlippedByteIsRefusedOrGivesAWholeFigure) {
  const std::string glb = document_.pack();
  for (size_t i = 0; i < glb.size(); ++i) {
    std::string broken = glb;
    broken[i] = static_cast<char>(static_cast<unsigned char>(broken[i]) ^ (1U << i % 8));
    const auto read = parse_text(broken);
    if (read)
      ASSERT_TRUE(check_figure(*read)) << "byte " << i;
    else
      ASSERT_FALSE(read.error().message.empty()) << "byte " << i;
  }
}

TEST_F(GltfHostile, ChunkLengthsThatReachPastTheEnd) {
  const std::string glb = document_.pack();
  const size_t binary = 20 + load_little_endian<uint32_t>(glb.data() + 12);
  for (const size_t at : {size_t{12}, binary})
    for (const uint32_t excess : {4U, 8U, 0x7FFFFFF0U, 0xFFFFFF00U}) {
      std::string length;
      append_little_endian(length, load_little_endian<uint32_t>(glb.data() + at) + excess);
      std::string broken = glb;
      expect_refused(broken.replace(at, 4, length), ErrorCode::kMalformed);
    }
}

TEST_F(GltfHostile, ForeignFiles) {
  expect_refused("", ErrorCode::kMalformed);
  expect_refused("solid cube\nendsolid\n", ErrorCode::kMalformed);
  expect_refused("{}", ErrorCode::kMalformed);
  expect_refused(R"({"asset":{"version":"1.0"}})", ErrorCode::kUnsupported);
  expect_refused(R"({"asset":{"version":"2.0"}})", ErrorCode::kMalformed);
  expect_refused(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":{}})", ErrorCode::kMalformed);
}

TEST_F(GltfHostile, DeepExtras) {
  const std::string deep = std::string(200'000, '[') + std::string(200'000, ']');
  expect_refused(R"({"asset":{"version":"2.0"},"extras":)" + deep + "}", ErrorCode::kLimit);
  expect_refused(document_.pack(R"({"asset":{"version":"2.0"},"extras":)" + deep + "}"), ErrorCode::kLimit);
}

TEST_F(GltfHostile, BracketsInTextAreNotDepth) {
  document_.json["extras"]["note"] = std::string(1000, '[') + "\\\"" + std::string(1000, '{');
  EXPECT_TRUE(parse_text(document_.pack()));
}

TEST_F(GltfHostile, MillionsOfValues) {
  std::string many = "[0";
  for (int i = 0; i < 2'000'000; ++i)
    many += ",0";
  expect_refused(R"({"asset":{"version":"2.0"},"extras":)" + many + "]}", ErrorCode::kLimit);
}

TEST_F(GltfHostile, ImageOutsideItsBuffer) {
  const json views = document_.json["bufferViews"];
  for (const json& image : {json{{"bufferView", 9999}}, json{{"bufferView", -1}}, json{{"bufferView", 1e30}}}) {
    document_.json["images"] = json::array({image});
    expect_refused(ErrorCode::kMalformed);
  }
  for (const json& view : {json{{"buffer", 0}, {"byteOffset", 0xFFFFFF00}, {"byteLength", 64}},
                           json{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 0x7FFFFFFF}},
                           json{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 0}},
                           json{{"buffer", 7}, {"byteOffset", 0}, {"byteLength", 4}}}) {
    document_.json["bufferViews"] = views;
    document_.json["bufferViews"].push_back(view);
    document_.json["images"] = json::array({{{"bufferView", views.size()}, {"mimeType", "image/png"}}});
    expect_refused(ErrorCode::kMalformed);
  }
}

TEST_F(GltfHostile, GiganticImage) {
  const std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x3E\x80\0\0\x3E\x80\x08\x06", 26);    // 16000 x 16000
  const std::string jpeg("\xFF\xD8\xFF\xE0\0\x04\0\0\xFF\xC0\0\x11\x08\x3E\x80\0\x10\x03", 18);  // 16 x 16000
  for (const std::string& bytes : {png, jpeg}) {
    GlbDocument document = document_;
    const size_t view = document.add_view(bytes);
    document.json["images"] = json::array({{{"bufferView", view}, {"mimeType", "image/png"}}});
    expect_refused(document.pack(), ErrorCode::kLimit);
  }
}

TEST_F(GltfHostile, UrisThatLeaveTheFolder) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "inner");
  put_bytes(folder / "outside.bin", document_.binary);
  std::filesystem::create_symlink(folder / "outside.bin", folder / "inner/link.bin");
  const std::string absolute = (folder / "outside.bin").string();
  for (const std::string& uri :
       {std::string("../outside.bin"), std::string("%2e%2e/outside.bin"), std::string("a/../../outside.bin"),
        std::string("../../etc/passwd"), std::string("/etc/passwd"), std::string("link.bin"), absolute,
        "file://" + absolute, std::string("http://example.org/figure.bin"), std::string("C:\\figure.bin"),
        std::string("~/figure.bin"), std::string("a%00b"), std::string("a%2"), std::string("")}) {
    document_.json["buffers"][0]["uri"] = uri;
    expect_refused(document_.json.dump(), ErrorCode::kUnsupported, folder / "inner");
    expect_refused(document_.pack(), ErrorCode::kUnsupported, folder / "inner");
  }
  document_.json["buffers"][0].erase("uri");
  document_.json["images"] = json::array({{{"uri", "../outside.bin"}}});
  expect_refused(document_.pack(), ErrorCode::kUnsupported, folder / "inner");
}

TEST_F(GltfHostile, FilesThatAreNoFiles) {
  const ScratchFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const std::filesystem::path& path : {folder / "pipe", folder.path(), std::filesystem::path("/dev/zero")}) {
    const auto read = read_gltf(path);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kUnreadable) << to_string(read.error());
  }
  const auto missing = read_gltf(folder / "missing.glb");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kNotFound);

  document_.json["buffers"][0]["uri"] = "pipe";
  expect_refused(document_.json.dump(), ErrorCode::kUnreadable, folder.path());
  document_.json["buffers"][0]["uri"] = "missing.bin";
  expect_refused(document_.json.dump(), ErrorCode::kNotFound, folder.path());
}

TEST_F(GltfHostile, FileBeyondTheLimit) {
  const ScratchFolder folder;
  put_bytes(folder / "huge.glb", "glTF");
  std::filesystem::resize_file(folder / "huge.glb", kMaxGltfBytes + 1);  // takes no space: a hole
  const auto read = read_gltf(folder / "huge.glb");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kLimit);
}

TEST_F(GltfHostile, NodesThatAreNoTree) {
  const json nodes = document_.json["nodes"];
  const auto with_child = [&](size_t node, int child) {
    document_.json["nodes"] = nodes;
    document_.json["nodes"][node]["children"].push_back(child);
    expect_refused(ErrorCode::kMalformed);
  };
  with_child(38, 0);  // a cycle through the root
  with_child(8, 4);   // a cycle
  with_child(5, 5);   // its own child
  with_child(38, 8);  // two parents
  with_child(8, 39);  // does not exist
  with_child(8, -2);  // nor does this
  with_child(8, INT_MAX);
  document_.json["nodes"] = nodes;
  document_.json["scenes"][0]["nodes"] = {77};
  expect_refused(ErrorCode::kMalformed);
}

TEST_F(GltfHostile, IndexOutOfRange) {
  const size_t start = document_.start(document_.index_accessor(0));
  document_.store(start + 2, uint16_t{4});  // of vertices 0 to 3
  expect_refused(ErrorCode::kMalformed);
  document_.store(start + 2, uint16_t{3});
  EXPECT_TRUE(parse_text(document_.pack()));
}

TEST_F(GltfHostile, AccessorsThatAskForMoreThanThereIs) {
  const json original = document_.json;
  for (const char* key : {"count", "byteOffset"})
    for (const uint64_t value : {uint64_t{1'000'000}, uint64_t{0xFFFFFFFF}, uint64_t{1} << 40U, uint64_t{1} << 62U,
                                 std::numeric_limits<uint64_t>::max()})
      for (const char* name : {"POSITION", "NORMAL", "COLOR_0"}) {
        document_.json = original;
        document_.attribute(0, name)[key] = value;
        expect_refused(ErrorCode::kMalformed);
      }
  for (const uint64_t value : {uint64_t{1'000'000}, std::numeric_limits<uint64_t>::max()}) {
    document_.json = original;
    document_.index_accessor(0)["count"] = value;
    expect_refused(ErrorCode::kMalformed);
    document_.json = original;
    document_.json["bufferViews"][0]["byteLength"] = value;
    expect_refused(ErrorCode::kMalformed);
    document_.json = original;
    document_.json["bufferViews"][0]["byteOffset"] = value;
    expect_refused(ErrorCode::kMalformed);
    document_.json = original;
    document_.json["buffers"][0]["byteLength"] = value;
    expect_refused(ErrorCode::kMalformed);
  }
}

TEST_F(GltfHostile, ReferencesToNothing) {
  const json original = document_.json;
  for (const int index : {-2, 999, INT_MAX}) {
    for (const char* pointer :
         {"/nodes/2/mesh", "/meshes/0/primitives/0/indices", "/meshes/0/primitives/0/material",
          "/meshes/0/primitives/0/attributes/POSITION", "/meshes/0/primitives/0/attributes/_PAINT",
          "/meshes/0/primitives/0/targets/0/POSITION", "/accessors/0/bufferView", "/bufferViews/0/buffer",
          "/accessors/5/sparse/indices/bufferView", "/accessors/5/sparse/values/bufferView",
          "/accessors/5/sparse/indices/byteOffset", "/accessors/5/sparse/values/byteOffset",
          "/accessors/5/sparse/count"}) {
      document_.json = original;
      const json::json_pointer at(pointer);
      ASSERT_TRUE(document_.json.contains(at)) << pointer;
      document_.json[at] = index;
      const auto read = parse_text(document_.pack());
      // A negative index reads as none at all, which is a complete mesh in some places.
      if (read)
        EXPECT_LT(index, 0) << pointer;
      else
        EXPECT_EQ(read.error().code, ErrorCode::kMalformed) << pointer << " " << to_string(read.error());
    }
  }
}

TEST_F(GltfHostile, AppearancesThatAreNone) {
  const json original = document_.json;
  const json& whole = original["scenes"][0]["extras"]["appearances"];
  ASSERT_EQ(whole.size(), 2U);
  json many = json::array();
  for (int i = 0; i < 65; ++i) {
    many.push_back(whole[0]);
    many.back()["name"] = std::to_string(i);
  }
  const auto refused = [&](const char* pointer, const json& value, ErrorCode code = ErrorCode::kMalformed) {
    document_.json = original;
    document_.json[json::json_pointer(std::string("/scenes/0/extras/appearances") + pointer)] = value;
    expect_refused(code);
  };
  refused("", many, ErrorCode::kLimit);
  refused("/0", 7);
  refused("/0/name", 7);
  refused("/0/name", "");
  refused("/0/name", whole[1]["name"]);
  refused("/0/background", json::array({1, 2}));
  refused("/0/pigments", "none");
  refused("/0/pigments", json::array());
  refused("/0/pigments/0", json::array({1, 2, 256}));
  refused("/0/pigments/0", json::array({1, -2, 3}));
  refused("/0/pigments/0", json::array({1, 2.5, 3}));
  refused("/0/pigments/0", json::array({"1", 2, 3}));
  refused("/0/pigments", json(std::vector<json>(257, whole[0]["pigments"][0])));
}

// What is no list of appearances is another maker's, and so is the paint beside it.
TEST_F(GltfHostile, ForeignExtrasAreNoAppearances) {
  document_.json["scenes"][0]["extras"] = {{"appearances", "blue"}};
  const auto read = parse_text(document_.pack());
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_TRUE(read->appearances.empty());
  EXPECT_TRUE(read->segments[2].paint.empty());
}

TEST_F(GltfHostile, PaintThatIsNoBytes) {
  auto& accessor = document_.attribute(0, "_PAINT");
  accessor["normalized"] = true;
  expect_refused(ErrorCode::kMalformed);
  accessor["normalized"] = false;
  document_.store(document_.start(accessor), uint8_t{2});  // there are pigments 0 and 1
  expect_refused(ErrorCode::kMalformed);
}

TEST_F(GltfHostile, SparseIndicesOutOfOrderOrRange) {
  const size_t start = document_.start(document_.target(0, 0)["sparse"]["indices"]);
  document_.store(start, uint16_t{3});  // 3, 3
  expect_refused(ErrorCode::kMalformed);
  document_.store(start, uint16_t{1});
  document_.store(start + 2, uint16_t{4});  // 1, 4 of 4 vertices
  expect_refused(ErrorCode::kMalformed);
}

TEST_F(GltfHostile, NumbersThatAreNotFinite) {
  const std::string binary = document_.binary;
  const size_t position = document_.start(document_.attribute(0, "POSITION"));
  const size_t normal = document_.start(document_.attribute(0, "NORMAL"));
  const size_t morph = document_.start(document_.target(0, 0)["sparse"]["values"]);
  for (const size_t at : {position, normal, morph})
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
      document_.binary = binary;
      document_.store(at + 4, value);
      expect_refused(ErrorCode::kMalformed);
    }
}

TEST_F(GltfHostile, NormalsThatAreNotUnit) {
  document_.store(document_.start(document_.attribute(0, "NORMAL")), 3.0F);
  expect_refused(ErrorCode::kMalformed);
}

TEST_F(GltfHostile, EachMissingNodeIsNamed) {
  for (size_t i = 0; i < kNodeNames.size(); ++i) {
    GlbDocument document = document_;
    document.json["nodes"][i]["name"] = "other";
    const auto read = parse_text(document.pack());
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kMalformed);
    EXPECT_NE(to_string(read.error()).find(kNodeNames[i]), std::string::npos) << to_string(read.error());
  }
}

TEST_F(GltfHostile, DoubledNames) {
  document_.json["nodes"][30]["name"] = "elbow_l";
  expect_refused(ErrorCode::kMalformed);
}

TEST_F(GltfHostile, RotatedScaledAndSkinnedNodesAreNamed) {
  const json nodes = document_.json["nodes"];
  const json half = {0.5, 0.5, 0.5, 0.5};
  const json sheared = {1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  for (const auto& [key, value] : std::vector<std::pair<std::string, json>>{
           {"rotation", half}, {"scale", {1, 1, 1.5}}, {"matrix", sheared}, {"skin", 0}}) {
    document_.json["nodes"] = nodes;
    document_.json["nodes"][4][key] = value;
    const auto read = parse_text(document_.pack());
    ASSERT_FALSE(read) << key;
    EXPECT_EQ(read.error().code, ErrorCode::kUnsupported) << to_string(read.error());
    EXPECT_NE(read.error().place.find("elbow_l"), std::string::npos) << to_string(read.error());
  }
}

TEST_F(GltfHostile, TransformsOfTheWrongLength) {
  const json nodes = document_.json["nodes"];
  for (const char* key : {"rotation", "scale", "translation", "matrix"}) {
    document_.json["nodes"] = nodes;
    document_.json["nodes"][4][key] = {1, 0};
    expect_refused(ErrorCode::kMalformed);
  }
}

TEST_F(GltfHostile, WhatFiguresDoNotHave) {
  const json original = document_.json;
  document_.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  expect_refused(ErrorCode::kUnsupported);
  document_.json = original;
  document_.json["meshes"][0]["primitives"].push_back(document_.json["meshes"][0]["primitives"][0]);
  expect_refused(ErrorCode::kUnsupported);
  document_.json = original;
  document_.json["meshes"][0]["primitives"][0]["mode"] = 5;
  expect_refused(ErrorCode::kUnsupported);
  document_.json = original;
  document_.json["meshes"][0].erase("extras");  // morph targets without names
  expect_refused(ErrorCode::kUnsupported);
}

// A short file may ask for any number of zeros, and for the same data any number of times.
TEST_F(GltfHostile, ZerosAndRepetitionsHaveABound) {
  const json original = document_.json;
  auto& position = document_.attribute(0, "POSITION");
  position.erase("bufferView");
  position["count"] = uint64_t{1} << 40U;
  expect_refused(ErrorCode::kLimit);

  document_.json = original;
  const size_t zeros = document_.json["accessors"].size();
  document_.json["accessors"].push_back({{"componentType", 5126}, {"count", 1'000'000}, {"type", "VEC3"}});
  document_.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = zeros;
  document_.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = zeros;
  for (auto& node : document_.json["nodes"])
    node["mesh"] = 0;
  const auto read = parse_text(document_.pack());
  ASSERT_FALSE(read);

  document_.json = original;
  for (int i = 0; i < 40; ++i)
    document_.json["buffers"].push_back(document_.json["buffers"][0]);
  expect_refused(ErrorCode::kLimit);
}

TEST(GltfAvatars, ForeignAvatarsAreReadOrRefusedWithAReason) {
  const std::filesystem::path folder = test::sample_avatar("");
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "the folder of sample avatars is not there: " << folder;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".glb" && entry.path().extension() != ".vrm") continue;
    ++files;
    const auto read = read_gltf(entry.path());
    if (read) continue;
    EXPECT_EQ(read.error().code, ErrorCode::kUnsupported) << to_string(read.error());
    EXPECT_FALSE(read.error().message.empty());
  }
  EXPECT_GT(files, 0);
}

}  // namespace
}  // namespace auslan
