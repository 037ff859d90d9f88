// SPDX-License-Identifier: Apache-2.0
// Distances from closed surfaces whose formula is known: a box, a sphere, two boxes that overlap; and against a search
// through every triangle.
#include "kinematics/rotation.h"
#include "kinematics/solid.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace auslan {
namespace {

void add_box(const Vec3& low, const Vec3& high, Mesh& mesh) {
  const auto base = static_cast<uint32_t>(mesh.positions.size());
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                                (i & 4) != 0 ? high.z : low.z);
  const std::vector<std::array<uint32_t, 4>> faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& f : faces)
    for (const size_t corner : {size_t{0}, size_t{1}, size_t{2}, size_t{0}, size_t{2}, size_t{3}})
      mesh.indices.push_back(base + f[corner]);
}

/// Signed distance of a box from its formula.
double box_distance(const Vec3& low, const Vec3& high, const Vec3& p) {
  Vec3 beyond(0.0);
  double within = 1e9;
  for (glm::length_t i = 0; i < 3; ++i) {
    beyond[i] = std::max({low[i] - p[i], p[i] - high[i], 0.0});
    within = std::min({within, p[i] - low[i], high[i] - p[i]});
  }
  return within > 0.0 ? -within : std::sqrt(glm::dot(beyond, beyond));
}

Mesh sphere(double radius, int rings, int around) {
  Mesh mesh;
  mesh.positions.emplace_back(0.0, radius, 0.0);
  for (int r = 1; r < rings; ++r)
    for (int a = 0; a < around; ++a) {
      const double polar = M_PI * r / rings;
      const double turn = 2.0 * M_PI * a / around;
      mesh.positions.emplace_back(radius * std::sin(polar) * std::sin(turn), radius * std::cos(polar),
                                  radius * std::sin(polar) * std::cos(turn));
    }
  mesh.positions.emplace_back(0.0, -radius, 0.0);
  const auto at = [&](int r, int a) {
    if (r == 0) return 0U;
    if (r == rings) return static_cast<uint32_t>(mesh.positions.size() - 1);
    return static_cast<uint32_t>(1 + (r - 1) * around + a % around);
  };
  for (int r = 0; r < rings; ++r)
    for (int a = 0; a < around; ++a) {
      if (r > 0) mesh.indices.insert(mesh.indices.end(), {at(r, a), at(r + 1, a), at(r, a + 1)});
      if (r + 1 < rings) mesh.indices.insert(mesh.indices.end(), {at(r, a + 1), at(r + 1, a), at(r + 1, a + 1)});
    }
  return mesh;
}

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

TEST(Solid, WhatLiesBelowADepthIsWhatTheNearestSurfaceTells) {
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
    int below = 0, clear = 0;
    for (int i = 0; i < 30000; ++i) {
      const Vec3 p(place(random), place(random), place(random));
      const double limit = depth(random);
      const auto nearest = solid.nearest(p, 10.0);
      ASSERT_TRUE(nearest);
      double above = -1.0;
      const auto found = solid.below(p, limit, &above);
      ASSERT_GE(above, 0.0);
      ASSERT_LE(above, std::max(0.0, nearest->distance + limit) + 1e-9);
      ASSERT_EQ(found.has_value(), nearest->distance < -limit) << p.x << " " << p.y << " " << p.z << ", " << limit;
      if (found) {
        ASSERT_EQ(found->distance, nearest->distance);
        ASSERT_EQ(found->position, nearest->position);
        ASSERT_EQ(found->normal, nearest->normal);
      }
      below += found.has_value();
      ASSERT_LE(solid.clearance(p), std::abs(nearest->distance));
      if (solid.clearance(p) < 0.05) continue;
      ++clear;
      ASSERT_GT(nearest->distance, 0.05);
    }
    EXPECT_GT(below, 150);
    EXPECT_GT(clear, 10000);
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
