// SPDX-License-Identifier: Apache-2.0
#include "box_figure.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
#include "kinematics/surface.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace auslan {
namespace {

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

class Surface : public ::testing::Test {
 protected:
  Figure figure_ = test::box_figure();  // boxes of half width 20 mm about head_base and wrist_l
  int head_ = figure_.skeleton.find("head_base");
  int wrist_ = figure_.skeleton.find("wrist_l");
  Vec3 head_centre_ = figure_.skeleton.rest_position(head_);
};

TEST_F(Surface, ARayMeetsTheNearOrTheFarSide) {
  const std::array<int, 1> nodes = {head_};
  const Vec3 origin = head_centre_ + Vec3(0.003, 0.005, 1.0);
  const Vec3 inwards(0.0, 0.0, -7.0);
  const auto near = cast_ray(figure_, nodes, origin, inwards);
  ASSERT_TRUE(near.has_value());
  EXPECT_EQ(near->node, head_);
  EXPECT_LT(length(near->position - Vec3(0.003, 0.005, 0.02)), 1e-7);
  EXPECT_LT(length(near->normal - Vec3(0.0, 0.0, 1.0)), 1e-6);
  const auto far = cast_ray(figure_, nodes, origin, inwards, RayHit::kFarthest);
  ASSERT_TRUE(far.has_value());
  EXPECT_LT(length(far->position - Vec3(0.003, 0.005, -0.02)), 1e-7);
  EXPECT_LT(length(far->normal - Vec3(0.0, 0.0, -1.0)), 1e-6);
}

TEST_F(Surface, ARayFromInsideMeetsTheWall) {
  const std::array<int, 1> nodes = {head_};
  const auto hit = cast_ray(figure_, nodes, head_centre_, Vec3(1.0, 0.1, 0.2));
  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->position.x, 0.02, 1e-7);
}

TEST_F(Surface, OnlyTheNamedNodesAreTried) {
  const std::array<int, 1> only_head = {head_};
  const std::array<int, 2> both = {head_, wrist_};
  const Vec3 wrist = figure_.skeleton.rest_position(wrist_);
  const Vec3 origin = wrist + Vec3(0.001, 0.002, 1.0);
  EXPECT_FALSE(cast_ray(figure_, only_head, origin, Vec3(0.0, 0.0, -1.0)).has_value());
  const auto hit = cast_ray(figure_, both, origin, Vec3(0.0, 0.0, -1.0));
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->node, wrist_);
}

TEST_F(Surface, MissesAreNothing) {
  const std::array<int, 1> nodes = {head_};
  EXPECT_FALSE(cast_ray(figure_, nodes, head_centre_ + Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, 1.0)).has_value())
      << "behind";
  EXPECT_FALSE(cast_ray(figure_, nodes, head_centre_ + Vec3(0.03, 0.0, 1.0), Vec3(0.0, 0.0, -1.0)).has_value())
      << "beside";
  EXPECT_FALSE(cast_ray(figure_, nodes, head_centre_, Vec3(0.0)).has_value()) << "no direction";
}

TEST_F(Surface, ExtremePointIsTheFarthestCorner) {
  const SurfacePoint point = extreme_point(figure_, wrist_, Vec3(3.0, -2.0, 1.0));
  EXPECT_LT(length(point.position - Vec3(0.02, -0.02, 0.02)), 1e-7);
  EXPECT_GT(glm::dot(point.normal, Vec3(3.0, -2.0, 1.0)), 0.0);
  const SurfacePoint bare = extreme_point(figure_, 0, Vec3(0.0, 2.0, 0.0));
  EXPECT_EQ(bare.position, Vec3(0.0));
  EXPECT_EQ(bare.normal, Vec3(0.0, 1.0, 0.0));
}

TEST_F(Surface, PointsAreCarriedAlongWithTheirNode) {
  const SurfacePoint point = extreme_point(figure_, wrist_, Vec3(1.0, 0.9, 0.8));
  Pose pose = rest_pose(figure_.skeleton);
  pose.rotation[static_cast<size_t>(wrist_)] = axis_angle(Vec3(0.0, 0.0, 1.0), kPi / 2.0);
  std::vector<Transform> world(static_cast<size_t>(figure_.skeleton.size()));
  forward(figure_.skeleton, pose, world);
  const Vec3 centre = figure_.skeleton.rest_position(wrist_);
  EXPECT_LT(length(placed_position(point, world) - (centre + Vec3(-0.02, 0.02, 0.02))), 1e-7);
  EXPECT_LT(length(placed_normal(point, world) - Vec3(-point.normal.y, point.normal.x, point.normal.z)), 1e-12);
}

}  // namespace
}  // namespace auslan
