// SPDX-License-Identifier: Apache-2.0
// Distances from closed surfaces whose formula is known: a box, a sphere, two boxes that overlap; and against a search
// through every triangle.
#include "kinematics/rotation.h"
#include "kinematics/solid.h"
#include "solid_shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace auslan {
namespace {

TEST(Solid, ABoxHasTheDistancesOfItsFormula) {
  const Vec3 low(-0.1, -0.2, -0.3);
  const Vec3 high(0.1, 0.25, 0.5);
  Mesh mesh;
  add_box(low, high, mesh);
  const Solid solid(mesh);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-0.8, 0.8);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p(place(random), place(random), place(random));
    const auto found = solid.nearest(p, 10.0);
    ASSERT_TRUE(found);
    const double expected = box_distance(low, high, p);
    // The corners are floats.
    ASSERT_NEAR(found->distance, expected, 1e-7);
    inside += expected < 0.0;
    const Vec3 back = found->position + unit(p - found->position) * std::abs(found->distance);
    ASSERT_NEAR(glm::dot(back - p, back - p), 0.0, 1e-12);
  }
  EXPECT_GT(inside, 300);
}

TEST(Solid, ASphereIsAsDeepAsItsRadius) {
  const Solid solid(sphere(0.1, 60, 120));
  // A facet of the mesh lies at most radius * (1 - cos(half the angle between vertices)) below the sphere.
  const double sagitta = 0.1 * (1.0 - std::cos(M_PI / 60));
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> radius(0.001, 0.3);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 way = unit(Vec3(normal(random), normal(random), normal(random)));
    const double r = radius(random);
    const auto found = solid.nearest(way * r, 1.0);
    ASSERT_TRUE(found);
    ASSERT_NEAR(found->distance, r - 0.1, sagitta + 1e-6);
    if (r > 0.02) {
      ASSERT_GT(glm::dot(found->normal, way), 0.99);
    }
  }
}

TEST(Solid, OfOverlappingPartsTheDeepestCounts) {
  Mesh mesh;
  add_box({0, 0, 0}, {1, 1, 1}, mesh);
  add_box({0.5, 0, 0}, {2, 1, 1}, mesh);
  const Solid solid(mesh);
  // In both: 0.1 deep in the first, 0.4 in the second.
  EXPECT_NEAR(solid.nearest({0.9, 0.5, 0.5}, 5.0)->distance, -0.4, 1e-12);
  // Below the surface of the second, on the surface of the first.
  EXPECT_NEAR(solid.nearest({1.0, 0.5, 0.5}, 5.0)->distance, -0.5, 1e-12);
  EXPECT_NEAR(solid.nearest({2.5, 0.5, 0.5}, 5.0)->distance, 0.5, 1e-12);
  EXPECT_NEAR(solid.nearest({-0.25, 0.5, 0.5}, 5.0)->distance, 0.25, 1e-12);
  EXPECT_EQ(solid.low(), Vec3(0, 0, 0));
  EXPECT_EQ(solid.high(), Vec3(2, 1, 1));
}

TEST(Solid, SeamsDoNotTakeASurfaceApartAndSheetsBelongTogether) {
  Mesh box;
  add_box({0, 0, 0}, {1, 1, 1}, box);
  // Every triangle with corners of its own, as at texture seams.
  Mesh loose;
  for (const uint32_t index : box.indices) {
    loose.indices.push_back(static_cast<uint32_t>(loose.positions.size()));
    loose.positions.push_back(box.positions[index]);
  }
  EXPECT_NEAR(Solid(loose).nearest({0.5, 0.5, 0.9}, 5.0)->distance, -0.1, 1e-12);
  EXPECT_NEAR(Solid(loose).nearest({0.5, 0.5, 1.2}, 5.0)->distance, 0.2, 1e-12);
  // Front and back of a body whose sides are missing: what is before the front is not behind the back.
  Mesh sheets;
  sheets.positions = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  sheets.indices = {0, 1, 2, 3, 4, 5};
  EXPECT_NEAR(Solid(sheets).nearest({0.2, 0.2, 1.3}, 5.0)->distance, 0.3, 1e-7);
  EXPECT_NEAR(Solid(sheets).nearest({0.2, 0.2, -0.3}, 5.0)->distance, 0.3, 1e-7);
  EXPECT_NEAR(Solid(sheets).nearest({0.2, 0.2, 0.7}, 5.0)->distance, -0.3, 1e-7);
}

TEST(Solid, WhatTheGridTellsTheNearestSurfaceConfirms) {
  Mesh boxes;
  add_box({0, 0, 0}, {0.1, 0.2, 0.3}, boxes);
  add_box({0.05, 0.01, 0.02}, {0.17, 0.15, 0.15}, boxes);
  add_box({-0.3, 0.25, 0}, {-0.2, 0.3, 0.1}, boxes);
  // Without its last face a box has a rim.
  Mesh open = boxes;
  open.indices.resize(open.indices.size() - 6);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-0.4, 0.4), depth(-0.03, 0.03);
  for (const Mesh& mesh : {boxes, open, sphere(0.1, 30, 60)}) {
    const Solid solid(mesh);
    int told = 0, far = 0;
    for (int i = 0; i < 30000; ++i) {
      const Vec3 p(place(random), place(random), place(random));
      const double limit = depth(random);
      const auto nearest = solid.nearest(p, 10.0);
      ASSERT_TRUE(nearest);
      const double clear = solid.clear_of(p, limit);
      ASSERT_GE(clear, 0.0);
      ASSERT_LE(clear, std::max(0.0, nearest->distance + limit) + 1e-9) << p.x << " " << p.y << " " << p.z;
      told += clear > 0.0;
      ASSERT_LE(solid.clearance(p), std::abs(nearest->distance));
      if (solid.clearance(p) < 0.05) continue;
      ++far;
      ASSERT_GT(nearest->distance, 0.05);
    }
    EXPECT_GT(told, 20000);
    EXPECT_GT(far, 10000);
  }
}

TEST(Solid, MoreTrianglesThanAGridCanTellApart) {
  // A thousand boxes in each other: the outermost decides.
  Mesh mesh;
  const Vec3 low(-0.3, -0.2, -0.25), high(0.3, 0.2, 0.25);
  for (int i = 0; i < 1000; ++i)
    add_box(low * (1.0 - 1e-4 * i), high * (1.0 - 1e-4 * i), mesh);
  const Solid solid(mesh);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.4, 0.4);
  for (int i = 0; i < 300; ++i) {
    const Vec3 point(place(random), place(random), place(random));
    const auto found = solid.nearest(point, 1.0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->distance, box_distance(low, high, point), 1e-6);
    const double clear = solid.clearance(point);
    EXPECT_TRUE(clear <= 0.0 || clear <= found->distance) << clear << " of " << found->distance;
  }
}

TEST(Solid, NothingIsFoundBeyondTheReach) {
  Mesh mesh;
  add_box({0, 0, 0}, {1, 1, 1}, mesh);
  const Solid solid(mesh);
  EXPECT_FALSE(solid.nearest({1.5, 0.5, 0.5}, 0.49));
  EXPECT_TRUE(solid.nearest({1.5, 0.5, 0.5}, 0.51));
  EXPECT_FALSE(Solid(Mesh{}).nearest({0, 0, 0}, 1e9));
}

TEST(Solid, WhatIsInsideIsWhatTheSurfaceWindsRound) {
  Mesh mesh = sphere(0.1, 16, 24);
  const Solid ball(mesh);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-0.12, 0.12);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p(uniform(random), uniform(random), uniform(random));
    const double radius = std::sqrt(glm::dot(p, p));
    if (radius > 0.0975 && radius < 0.1) continue;  // between the sphere and its flat faces
    EXPECT_EQ(ball.contains(p), radius < 0.0985) << radius;
  }
  // A sphere without its cap still holds what is well inside it, and nothing above the hole.
  mesh.indices.erase(mesh.indices.begin(), mesh.indices.begin() + 3 * 24 * 3);
  const Solid open(mesh);
  EXPECT_TRUE(open.contains(Vec3(0.0)));
  EXPECT_TRUE(open.contains(Vec3(0.0, -0.09, 0.0)));
  EXPECT_FALSE(open.contains(Vec3(0.0, 0.099, 0.0)));
}

}  // namespace
}  // namespace auslan
