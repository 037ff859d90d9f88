// SPDX-License-Identifier: Apache-2.0
// What the hierarchy of balls finds is what a search through every vertex finds.
#include "body_solids.h"
#include "kinematics/rotation.h"
#include "kinematics/solid.h"
#include "shipped.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace auslan {
namespace {

using Places = std::vector<Transform>;

/// The deepest vertex of one node's segment in another's: every vertex against the whole surface.
double depth_by_every_vertex(const Figure& figure, const Places& world, int points, int solid) {
  static std::map<int, Solid> solids;
  const Solid& surface = solids.try_emplace(solid, figure.segments[static_cast<size_t>(solid)]).first->second;
  const Transform& from = world[static_cast<size_t>(points)];
  const Transform& to = world[static_cast<size_t>(solid)];
  double deepest = 0.0;
  for (const glm::vec3& position : figure.segments[static_cast<size_t>(points)].positions) {
    const Vec3 p = glm::conjugate(to.rotation) * (apply(from, Vec3(position)) - to.position);
    if (glm::min(p, surface.low()) != surface.low() || glm::max(p, surface.high()) != surface.high()) continue;
    const auto nearest = surface.nearest(p, 1.0);
    if (nearest && -nearest->distance > deepest && surface.contains(p)) deepest = -nearest->distance;
  }
  return deepest;
}

TEST(BodySolids, TheDeepestOverlapIsThatOfEveryVertex) {
  const Figure& figure = shipped().figure;
  const BodySolids solids(figure);
  int overlapping = 0;
  for (const char* gloss : {"fs:B", "LOVE", "HURT", "fs:X", "HAPPY"}) {
    const Score score = score_of({gloss});
    const Performance performance(*shipped().signer, score, {.left_handed = false, .idle = false, .seed = 1});
    Pose pose;
    Places world(static_cast<size_t>(figure.skeleton.size()));
    for (int frame = 1; frame < 6; ++frame) {
      performance.sample(score.end * frame / 6, pose);
      // Well-made signs have no overlaps: the arms are turned inwards, into each other and into what they touch.
      for (const auto& [arm, angle] : {std::pair("shoulder_r", 0.2), std::pair("shoulder_l", -0.2)}) {
        Quat& rotation = pose.rotation[static_cast<size_t>(figure.skeleton.find(arm))];
        rotation = axis_angle(Vec3(0, 1, 0), angle) * rotation;
      }
      forward(figure.skeleton, pose, world);
      for (const auto& [a, b] : BodySolids::pairs()) {
        double deepest = 0.0;
        for (const int node_a : solids.nodes_of(a))
          for (const int node_b : solids.nodes_of(b))
            deepest = std::max({deepest, depth_by_every_vertex(figure, world, node_a, node_b),
                                depth_by_every_vertex(figure, world, node_b, node_a)});
        const auto found = solids.overlap(a, b, 0.0, world);
        EXPECT_NEAR(found ? found->depth : 0.0, deepest, 1e-12) << gloss << " frame " << frame;
        if (deepest > 0.0) ++overlapping;
        EXPECT_EQ(solids.overlap(a, b, deepest + 1e-9, world).has_value(), false) << gloss << " frame " << frame;
        if (deepest > 1e-6) {
          EXPECT_TRUE(solids.overlap(a, b, deepest - 1e-9, world).has_value()) << gloss;
        }
      }
    }
  }
  // A comparison of nothings would tell nothing.
  EXPECT_GE(overlapping, 10);
}

TEST(BodySolids, ALineThatMissesTheBallsMeetsNothing) {
  const Figure& figure = shipped().figure;
  const BodySolids solids(figure);
  Places world(static_cast<size_t>(figure.skeleton.size()));
  forward(figure.skeleton, rest_pose(figure.skeleton), world);
  const Vec3 wrist = world[static_cast<size_t>(figure.skeleton.find("wrist_r"))].position;
  EXPECT_TRUE(solids.may_cross(BodyGroup::kRightHand, wrist - Vec3(0, 0.5, 0), wrist + Vec3(0, 0.5, 0), world));
  EXPECT_FALSE(solids.may_cross(BodyGroup::kRightHand, wrist - Vec3(0, 0.5, 0), wrist - Vec3(0, 0.3, 0), world));
  EXPECT_FALSE(solids.may_cross(BodyGroup::kLeftHand, wrist - Vec3(0, 0.5, 0), wrist + Vec3(0, 0.5, 0), world));
}

}  // namespace
}  // namespace auslan
