// SPDX-License-Identifier: Apache-2.0
#include "media/motion_file.h"
#include "scratch_folder.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

namespace auslan {
namespace {

using Names = std::vector<std::string>;
constexpr double kDegreesToRadians = 3.14159265358979323846 / 180.0;

int parent_of(int index) {
  const auto find = [](std::string_view name) {
    for (size_t i = 0; i < kNodeNames.size(); ++i)
      if (kNodeNames[i] == name) return static_cast<int>(i);
    return kNoNode;
  };
  const std::string name(kNodeNames[static_cast<size_t>(index)]);
  const std::string side = name.substr(name.size() - 2);
  if (name == "spine_base") return kNoNode;
  if (name == "neck_base" || name.starts_with("shoulder")) return find("spine_base");
  if (name == "head_base") return find("neck_base");
  if (name.starts_with("elbow")) return find("shoulder" + side);
  if (name.starts_with("wrist")) return find("elbow" + side);
  if (name.starts_with("thumb_cmc") || name.find("_mp_") != std::string::npos) {
    if (name.starts_with("thumb_mp")) return find("thumb_cmc" + side);
    return find("wrist" + side);
  }
  return index - 1;
}

/// The 39 nodes with offsets that are all different.
Skeleton skeleton() {
  std::vector<Node> nodes;
  for (int i = 0; i < static_cast<int>(kNodeNames.size()); ++i)
    nodes.push_back({std::string(kNodeNames[static_cast<size_t>(i)]), parent_of(i),
                     Vec3(0.01 * i - 0.13, 0.2 - 0.007 * i, 0.003 * i)});
  return Skeleton::build(std::move(nodes)).value();
}

/// A pose in which every joint is turned by something else, some through gimbal lock.
Pose pose_at(const Skeleton& body, int frame) {
  Pose pose = rest_pose(body);
  for (size_t i = 0; i < pose.rotation.size(); ++i) {
    const double n = static_cast<double>(i) + 40.0 * frame;
    const Quat q(std::cos(n), std::sin(1.3 * n), std::cos(2.1 * n), std::sin(0.7 * n + 1));
    pose.rotation[i] = q / glm::length(q);
  }
  // A quarter turn about X is where Z-X-Y angles lock.
  pose.rotation[5] = glm::angleAxis(kDegreesToRadians * 90, Vec3(1, 0, 0)) * glm::angleAxis(0.4, Vec3(0, 1, 0));
  pose.rotation[6] = glm::angleAxis(kDegreesToRadians * -90, Vec3(1, 0, 0));
  pose.root_translation = Vec3(0.1 * frame, -0.02, 0.5);
  pose.face[static_cast<size_t>(FaceChannel::kJawOpen)] = 0.1F * static_cast<float>(frame);
  return pose;
}

std::vector<Transform> world_of(const Skeleton& body, const Pose& pose) {
  std::vector<Transform> world(pose.rotation.size());
  forward(body, pose, world);
  return world;
}

MotionHeader header() {
  return {30, {{"HELLO", 0, 0.5}, {"say \"hi\"\\\n\xC3\xA9\xFF", 0.5, 1.25}}};
}

Result<void> write_motion(const std::string& path, const Skeleton& body, int frames) {
  auto sink = open_motion(path, header(), body);
  if (!sink) return tl::unexpected(sink.error());
  for (int i = 0; i < frames; ++i) {
    const Pose pose = pose_at(body, i);
    if (auto done = (*sink)->write(i / 30.0, pose, world_of(body, pose)); !done) return done;
  }
  return (*sink)->finish();
}

TEST(MotionJsonl, KeepsTheContractWithAllNodesInWorldSpace) {
  const ScratchFolder folder;
  const Skeleton body = skeleton();
  ASSERT_TRUE(write_motion(folder / "m.jsonl", body, 3));
  EXPECT_EQ(folder.contents(), Names{"m.jsonl"});
  std::istringstream lines(bytes_of(folder / "m.jsonl"));
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  const auto first = nlohmann::json::parse(line);
  EXPECT_EQ(first["fps"], 30);
  EXPECT_EQ(first["units"], "m");
  EXPECT_EQ(first["frame"], "y-up, +x signer's left, +z towards the viewer, world");
  EXPECT_EQ(first["glosses"][0], (nlohmann::json{{"gloss", "HELLO"}, {"start", 0}, {"end", 0.5}}));
  EXPECT_EQ(first["glosses"][1]["gloss"], "say \"hi\"\\\n\xC3\xA9\xEF\xBF\xBD");
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(std::getline(lines, line));
    const auto frame = nlohmann::json::parse(line);
    EXPECT_EQ(frame["t"].get<double>(), i / 30.0);
    ASSERT_EQ(frame["joints"].size(), 39U);
    const auto world = world_of(body, pose_at(body, i));
    for (size_t n = 0; n < kNodeNames.size(); ++n) {
      const auto values = frame["joints"].at(std::string(kNodeNames[n])).get<std::vector<double>>();
      const Transform& w = world[n];
      const std::vector<double> expected = {w.position.x, w.position.y, w.position.z, w.rotation.w,
                                            w.rotation.x, w.rotation.y, w.rotation.z};
      EXPECT_EQ(values, expected) << kNodeNames[n];
    }
    if (i > 0) {
      EXPECT_EQ(frame["face"].at("jawOpen").get<float>(), 0.1F * static_cast<float>(i));
    }
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(MotionJsonl, ReadBackGivesTheSamePoses) {
  const ScratchFolder folder;
  const Skeleton body = skeleton();
  ASSERT_TRUE(write_motion(folder / "m.jsonl", body, 4));
  const auto clip = read_motion_jsonl(folder / "m.jsonl");
  ASSERT_TRUE(clip) << to_string(clip.error());
  EXPECT_EQ(clip->header.fps, 30);
  ASSERT_EQ(clip->header.glosses.size(), 2U);
  EXPECT_EQ(clip->header.glosses[1].end, 1.25);
  ASSERT_EQ(clip->frames.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    const Pose original = pose_at(body, i);
    const auto pose = pose_from_frame(*clip, clip->frames[static_cast<size_t>(i)], body);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->face, original.face);
    const auto expected = world_of(body, original);
    const auto actual = world_of(body, *pose);
    for (size_t n = 0; n < expected.size(); ++n) {
      EXPECT_LT(glm::distance(expected[n].position, actual[n].position), 1e-12) << kNodeNames[n];
      EXPECT_GT(std::abs(glm::dot(expected[n].rotation, actual[n].rotation)), 1 - 1e-12) << kNodeNames[n];
    }
  }
}

TEST(MotionJsonl, BrokenInputIsRefusedWithItsLine) {
  const std::string head = R"({"fps":25,"units":"m"})"
                           "\n";
  const std::string good = R"({"t":0,"joints":{"a":[0,0,0,1,0,0,0]}})"
                           "\n";
  const std::string later = R"({"t":1,"joints":{"a":[0,0,0,1,0,0,0]}})"
                            "\n";
  ASSERT_TRUE(parse_motion_jsonl(head + good + "\r\n\n" + later, "m"));
  struct Case {
    std::string text;
    ErrorCode code;
    std::string place;
  };
  const Case cases[] = {
      {"", ErrorCode::kMalformed, "m:1"},
      {"nonsense\n", ErrorCode::kMalformed, "m:1"},
      {"[1,2]\n", ErrorCode::kMalformed, "m:1"},
      {R"({"units":"m"})"
       "\n",
       ErrorCode::kMalformed, "m:1"},
      {R"({"fps":0})"
       "\n",
       ErrorCode::kMalformed, "m:1"},
      {R"({"fps":1e999})"
       "\n",
       ErrorCode::kMalformed, "m:1"},
      {R"({"fps":25,"units":"cm"})"
       "\n",
       ErrorCode::kMalformed, "m:1"},
      {R"({"fps":25,"glosses":[{"gloss":3}]})"
       "\n",
       ErrorCode::kMalformed, "m:1"},
      {head, ErrorCode::kMalformed, "m:1"},
      {head + R"({"t":0})", ErrorCode::kMalformed, "m:2"},
      {head + R"({"joints":{"a":[0,0,0,1,0,0,0]}})", ErrorCode::kMalformed, "m:2"},
      {head + R"({"t":0,"joints":{}})", ErrorCode::kMalformed, "m:2"},
      {head + R"({"t":0,"joints":{"a":[0,0,0,1,0,0]}})", ErrorCode::kMalformed, "m:2"},
      {head + R"({"t":0,"joints":{"a":[0,0,0,"1",0,0,0]}})", ErrorCode::kMalformed, "m:2"},
      {head + R"({"t":0,"joints":{"a":[0,0,0,0,0,0,0]}})", ErrorCode::kMalformed, "m:2"},
      {head + R"({"t":0,"joints":{"a":[1e300,0,0,1,0,0,0]}})", ErrorCode::kMalformed, "m:2"},
      {head + good + "\n" + good.substr(0, 20), ErrorCode::kMalformed, "m:4"},
      {head + later + good, ErrorCode::kMalformed, "m:3"},
      {head + good + R"({"t":1,"joints":{"b":[0,0,0,1,0,0,0]}})", ErrorCode::kMalformed, "m:3"},
      {head + good + R"({"t":1,"joints":{"a":[0,0,0,1,0,0,0],"b":[0,0,0,1,0,0,0]}})", ErrorCode::kMalformed, "m:3"},
      {head + R"({"t":0,"joints":{"a":[0,0,0,1,0,0,0]},"face":{"jawOpen":"x"}})", ErrorCode::kMalformed, "m:2"},
      {head + std::string(300000, '['), ErrorCode::kLimit, "m:2"},
      {head + "{\"t\":" + std::string(2000000, ' ') + "0}", ErrorCode::kLimit, "m:2"},
  };
  for (const Case& one : cases) {
    const auto clip = parse_motion_jsonl(one.text, "m");
    ASSERT_FALSE(clip) << one.text.substr(0, 120);
    EXPECT_EQ(clip.error().code, one.code) << one.text.substr(0, 120) << ": " << to_string(clip.error());
    EXPECT_EQ(clip.error().place, one.place) << one.text.substr(0, 120) << ": " << to_string(clip.error());
  }
  EXPECT_EQ(read_motion_jsonl("/nonexistent/m.jsonl").error().code, ErrorCode::kNotFound);
}

TEST(MotionJsonl, AMotionThatLacksANodeCannotBePlayed) {
  const auto clip = parse_motion_jsonl("{\"fps\":25}\n{\"t\":0,\"joints\":{\"wrist_r\":[0,0,0,1,0,0,0]}}\n", "m");
  ASSERT_TRUE(clip);
  const auto pose = pose_from_frame(*clip, clip->frames[0], skeleton());
  ASSERT_FALSE(pose);
  EXPECT_NE(pose.error().message.find("spine_base"), std::string::npos);
}

// --- BVH: a reader that shares nothing with the writer, from the format's description.

struct BvhNode {
  std::string name;
  int parent = -1;
  Vec3 offset{0.0};
  std::vector<std::string> channels;
};

struct Bvh {
  std::vector<BvhNode> nodes;
  int end_sites = 0;
  double frame_time = 0;
  std::vector<std::vector<double>> frames;
};

Bvh parse_bvh(const std::string& text) {
  Bvh bvh;
  std::istringstream in(text);
  std::vector<int> open;
  std::string word;
  bool in_end_site = false;
  int pending = -1;
  while (in >> word && word != "MOTION") {
    if (word == "ROOT" || word == "JOINT") {
      bvh.nodes.push_back({});
      pending = static_cast<int>(bvh.nodes.size()) - 1;
      in >> bvh.nodes.back().name;
      bvh.nodes.back().parent = open.empty() ? -1 : open.back();
    } else if (word == "End") {
      in >> word;
      in_end_site = true;
      ++bvh.end_sites;
    } else if (word == "{") {
      open.push_back(in_end_site ? -2 : pending);
    } else if (word == "}") {
      if (open.back() == -2) in_end_site = false;
      open.pop_back();
    } else if (word == "OFFSET") {
      Vec3 offset(0.0);
      in >> offset.x >> offset.y >> offset.z;
      if (!in_end_site) bvh.nodes[static_cast<size_t>(open.back())].offset = offset;
    } else if (word == "CHANNELS") {
      size_t count = 0;
      in >> count;
      auto& channels = bvh.nodes[static_cast<size_t>(open.back())].channels;
      channels.resize(count);
      for (std::string& channel : channels)
        in >> channel;
    }
  }
  EXPECT_TRUE(open.empty());
  size_t frames = 0, values = 0;
  in >> word >> frames >> word >> word >> bvh.frame_time;
  for (const BvhNode& node : bvh.nodes)
    values += node.channels.size();
  for (size_t i = 0; i < frames; ++i) {
    bvh.frames.emplace_back(values);
    for (double& value : bvh.frames.back())
      in >> value;
  }
  EXPECT_TRUE(static_cast<bool>(in)) << "fewer numbers than the header promises";
  EXPECT_FALSE(in >> word) << "more numbers than the header promises";
  return bvh;
}

/// Rotation matrices in the order of the channels, each about its own axis.
Mat3 turn(char axis, double degrees) {
  const double c = std::cos(degrees * kDegreesToRadians), s = std::sin(degrees * kDegreesToRadians);
  // glm's constructor takes columns.
  if (axis == 'X') return {1, 0, 0, 0, c, s, 0, -s, c};
  if (axis == 'Y') return {c, 0, -s, 0, 1, 0, s, 0, c};
  return {c, s, 0, -s, c, 0, 0, 0, 1};
}

std::map<std::string, Vec3> positions_of(const Bvh& bvh, const std::vector<double>& values) {
  std::map<std::string, Vec3> positions;
  std::vector<Mat3> rotation(bvh.nodes.size());
  std::vector<Vec3> position(bvh.nodes.size());
  size_t at = 0;
  for (size_t i = 0; i < bvh.nodes.size(); ++i) {
    const BvhNode& node = bvh.nodes[i];
    Vec3 local = node.offset;
    Mat3 turned(1.0);
    for (const std::string& channel : node.channels) {
      const double value = values[at++];
      const int axis = channel[0] - 'X';
      if (channel.ends_with("position"))
        local[axis] = node.offset[axis] + value;
      else
        turned = turned * turn(channel[0], value);
    }
    const bool root = node.parent < 0;
    const size_t parent = root ? 0 : static_cast<size_t>(node.parent);
    position[i] = root ? local : position[parent] + rotation[parent] * local;
    rotation[i] = root ? turned : rotation[parent] * turned;
    positions[node.name] = position[i];
  }
  return positions;
}

TEST(MotionBvh, AnIndependentReaderFindsEveryNodeWhereItWas) {
  const ScratchFolder folder;
  const Skeleton body = skeleton();
  ASSERT_TRUE(write_motion(folder / "m.bvh", body, 12));
  EXPECT_EQ(folder.contents(), Names{"m.bvh"});
  const Bvh bvh = parse_bvh(bytes_of(folder / "m.bvh"));
  ASSERT_EQ(bvh.nodes.size(), 39U);
  EXPECT_EQ(bvh.end_sites, 11) << "ten fingertips and the head";
  EXPECT_DOUBLE_EQ(bvh.frame_time, 1.0 / 30);
  ASSERT_EQ(bvh.frames.size(), 12U);
  double worst = 0;
  for (int i = 0; i < 12; ++i) {
    const auto positions = positions_of(bvh, bvh.frames[static_cast<size_t>(i)]);
    const auto world = world_of(body, pose_at(body, i));
    for (size_t n = 0; n < kNodeNames.size(); ++n) {
      const auto found = positions.find(std::string(kNodeNames[n]));
      ASSERT_NE(found, positions.end()) << kNodeNames[n];
      worst = std::max(worst, glm::distance(found->second, world[n].position));
    }
  }
  EXPECT_LT(worst, 1e-6);
}

TEST(MotionSink, FailuresLeaveNothing) {
  const ScratchFolder folder;
  const Skeleton body = skeleton();
  for (const std::string name : {"m.jsonl", "m.bvh"}) {
    put_bytes(folder / name, "old");
    EXPECT_EQ(open_motion(folder / ("none/" + name), header(), body).error().code, ErrorCode::kUnwritable);
    EXPECT_FALSE(write_motion(folder / name, body, 0));
    auto sink = open_motion(folder / name, header(), body);
    ASSERT_TRUE(sink);
    Pose pose = pose_at(body, 0);
    auto world = world_of(body, pose);
    ASSERT_TRUE((*sink)->write(0, pose, world));
    world[3].position.x = std::nan("");
    EXPECT_EQ((*sink)->write(0, pose, world).error().code, ErrorCode::kUsage);
    EXPECT_FALSE((*sink)->finish());
    EXPECT_EQ(bytes_of(folder / name), "old");
  }
  EXPECT_EQ(folder.contents(), (Names{"m.bvh", "m.jsonl"}));
  EXPECT_EQ(open_motion(folder / "m.fbx", header(), body).error().code, ErrorCode::kUsage);
  EXPECT_EQ(open_motion(folder / "m.bvh", {0, {}}, body).error().code, ErrorCode::kUsage);
}

}  // namespace
}  // namespace auslan
