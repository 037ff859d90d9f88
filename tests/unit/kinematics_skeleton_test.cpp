// SPDX-License-Identifier: Apache-2.0
#include "kinematics/elementary.h"
#include "kinematics/pose.h"
#include "kinematics/rotation.h"
#include "kinematics/skeleton.h"
#include "measured_skeleton.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace auslan {
namespace {

std::vector<Node> measured_nodes() {
  const Skeleton skeleton = test::measured_skeleton();
  return {skeleton.nodes().begin(), skeleton.nodes().end()};
}

double distance(const Vec3& a, const Vec3& b) {
  return std::sqrt(glm::dot(a - b, a - b));
}

TEST(Skeleton, ThereAre39NamesEachOnceAndMirrored) {
  const std::set<std::string_view> names(kNodeNames.begin(), kNodeNames.end());
  EXPECT_EQ(names.size(), 39U);
  int left = 0;
  for (const std::string_view name : kNodeNames)
    if (name.ends_with("_l")) {
      ++left;
      EXPECT_TRUE(names.count(std::string(name.substr(0, name.size() - 1)) + "r") == 1) << name;
    }
  EXPECT_EQ(left, 18);
}

TEST(Skeleton, ParentsStandBeforeTheirChildren) {
  const Skeleton skeleton = test::measured_skeleton();
  EXPECT_EQ(skeleton.size(), 39);
  for (int i = 0; i < skeleton.size(); ++i)
    EXPECT_LT(skeleton.node(i).parent, i);
  for (const std::string_view name : kNodeNames) {
    ASSERT_NE(skeleton.find(name), kNoNode) << name;
    EXPECT_EQ(skeleton.node(skeleton.find(name)).name, name);
  }
  EXPECT_EQ(skeleton.find("tail"), kNoNode);
}

TEST(Skeleton, RestPositionIsTheSumOfOffsets) {
  const Skeleton skeleton = test::measured_skeleton();
  const Vec3& wrist = skeleton.rest_position(skeleton.find("wrist_r"));
  EXPECT_LT(distance(wrist, Vec3(-0.17 - 0.287 - 0.2545, 0.97 + 0.47 - 0.088, 0.0)), 1e-15);
}

TEST(Skeleton, BrokenListsAreRefusedWithAPlace) {
  const auto refused = [](const std::vector<Node>& nodes) {
    const Result<Skeleton> result = Skeleton::build(nodes);
    return !result && result.error().code == ErrorCode::kMalformed && !result.error().message.empty();
  };
  EXPECT_TRUE(refused({}));
  std::vector<Node> nodes = measured_nodes();
  nodes[5].parent = 7;
  EXPECT_TRUE(refused(nodes)) << "a parent behind its child";
  nodes = measured_nodes();
  nodes[5].parent = kNoNode;
  EXPECT_TRUE(refused(nodes)) << "a second root";
  nodes = measured_nodes();
  nodes[6].name = nodes[7].name;
  EXPECT_TRUE(refused(nodes)) << "a name twice";
  nodes = measured_nodes();
  nodes[6].offset.y = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(refused(nodes)) << "a position that is not finite";
  nodes = measured_nodes();
  nodes.pop_back();
  EXPECT_TRUE(refused(nodes)) << "a node short";
  nodes = measured_nodes();
  nodes.push_back({"jaw", 2, Vec3(0.0)});
  EXPECT_FALSE(refused(nodes)) << "more than 39 are welcome";
}

TEST(Forward, RestPoseIsTheRest) {
  const Skeleton skeleton = test::measured_skeleton();
  std::vector<Transform> world(static_cast<size_t>(skeleton.size()));
  forward(skeleton, rest_pose(skeleton), world);
  for (int i = 0; i < skeleton.size(); ++i) {
    EXPECT_LT(distance(world[static_cast<size_t>(i)].position, skeleton.rest_position(i)), 1e-15);
    EXPECT_EQ(world[static_cast<size_t>(i)].rotation, kIdentity);
  }
}

TEST(Forward, ABentElbowCarriesTheHandForwards) {
  const Skeleton skeleton = test::measured_skeleton();
  Pose pose = rest_pose(skeleton);
  // The left forearm turns from +X to +Z about -Y.
  pose.rotation[static_cast<size_t>(skeleton.find("elbow_l"))] = axis_angle(Vec3(0.0, -1.0, 0.0), kPi / 2.0);
  std::vector<Transform> world(static_cast<size_t>(skeleton.size()));
  forward(skeleton, pose, world);
  const Vec3& elbow = skeleton.rest_position(skeleton.find("elbow_l"));
  const Vec3& wrist = world[static_cast<size_t>(skeleton.find("wrist_l"))].position;
  EXPECT_LT(distance(wrist, elbow + Vec3(0.0, 0.0, 0.2545)), 1e-15);
}

TEST(Forward, LengthsOfBonesNeverChange) {
  const Skeleton skeleton = test::measured_skeleton();
  Pose pose = rest_pose(skeleton);
  for (size_t i = 0; i < pose.rotation.size(); ++i)
    pose.rotation[i] = from_rotation_vector(Vec3(0.1, -0.2, 0.05) * static_cast<double>(i % 11));
  pose.root_translation = Vec3(0.3, 0.1, -2.0);
  std::vector<Transform> world(static_cast<size_t>(skeleton.size()));
  forward(skeleton, pose, world);
  EXPECT_LT(distance(world[0].position, skeleton.rest_position(0) + pose.root_translation), 1e-15);
  for (int i = 1; i < skeleton.size(); ++i) {
    const Node& node = skeleton.node(i);
    const Vec3& parent = world[static_cast<size_t>(node.parent)].position;
    EXPECT_NEAR(distance(world[static_cast<size_t>(i)].position, parent), distance(node.offset, Vec3(0.0)), 1e-14);
  }
}

}  // namespace
}  // namespace auslan
