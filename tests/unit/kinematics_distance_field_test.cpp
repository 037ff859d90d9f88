// SPDX-License-Identifier: Apache-2.0
// What a distance field tells, against the formulas of a sphere and a box; and that it tells the same whoever asks
// first.
#include "kinematics/distance_field.h"
#include "kinematics/rotation.h"
#include "solid_shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <thread>
#include <vector>

namespace auslan {
namespace {

constexpr double kLargestCell = 0.007;
const double kHalfDiagonal = 0.5 * std::sqrt(3.0) * kLargestCell;

std::vector<Vec3> points_within(double reach, size_t count) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> place(-reach, reach);
  std::vector<Vec3> points(count);
  for (Vec3& point : points)
    point = {place(random), place(random), place(random)};
  return points;
}

TEST(DistanceField, OfASphereItIsOffByWhatATangentPlaneIs) {
  const double radius = 0.03;
  const DistanceField field{Solid(sphere(radius, 90, 180))};
  const double sagitta = radius * (1.0 - std::cos(M_PI / 90)) + 1e-6;
  int asked = 0;
  for (const Vec3& p : points_within(0.06, 20000)) {
    const double from_centre = std::sqrt(glm::dot(p, p));
    if (from_centre < 2.0 * kHalfDiagonal) continue;
    ++asked;
    const SurfacePlane told = field.at(p);
    const double truth = from_centre - radius;
    // With the way a to the side of the cell's middle, r from the centre: sqrt(r^2 + a^2) - r <= a^2 / 2r.
    const double bound = kHalfDiagonal * kHalfDiagonal / (2.0 * (from_centre - kHalfDiagonal));
    ASSERT_LE(told.distance, truth + sagitta);
    ASSERT_GE(told.distance, truth - bound - sagitta);
    ASSERT_NEAR(glm::dot(told.normal, told.normal), 1.0, 1e-6);
    // As seen from the cell's middle.
    ASSERT_GT(glm::dot(told.normal, p / from_centre), std::sqrt(1.0 - std::pow(kHalfDiagonal / from_centre, 2)) - 1e-3);
  }
  EXPECT_GT(asked, 15000);
}

const Vec3 kLow(-0.02, -0.03, -0.05), kHigh(0.03, 0.03, 0.04);

DistanceField field_of_box() {
  Mesh mesh;
  add_box(kLow, kHigh, mesh);
  return DistanceField(Solid(mesh));
}

TEST(DistanceField, OutsideABoxNothingIsToldToBeFartherThanItIs) {
  const DistanceField field = field_of_box();
  int before_face = 0;
  for (const Vec3& p : points_within(0.08, 20000)) {
    const double truth = box_distance(kLow, kHigh, p);
    const double told = field.at(p).distance;
    // Both change by no more than the way from the cell's middle.
    ASSERT_NEAR(told, truth, 2.0 * kHalfDiagonal);
    if (truth < 0.0) continue;
    ASSERT_LE(told, truth + 1e-6);
    int beyond = 0;
    double to_edge = 1.0;
    for (glm::length_t i = 0; i < 3; ++i) {
      beyond += p[i] < kLow[i] || p[i] > kHigh[i];
      if (p[i] >= kLow[i] && p[i] <= kHigh[i]) to_edge = std::min({to_edge, p[i] - kLow[i], kHigh[i] - p[i]});
    }
    if (beyond != 1 || to_edge < kLargestCell) continue;
    ++before_face;
    ASSERT_NEAR(told, truth, 1e-6);  // a plane is its own tangent
  }
  EXPECT_GT(before_face, 1000);
}

TEST(DistanceField, WhatIsDeepIsFoundAndWhatIsNotIsSpared) {
  const DistanceField field = field_of_box();
  for (const double depth : {-0.01, -0.0015, 0.0, 0.003}) {
    int found = 0;
    for (const Vec3& p : points_within(0.08, 20000)) {
      double above = -1.0;
      const auto plane = field.below(p, depth, above);
      const double told = field.at(p).distance;
      const double truth = box_distance(kLow, kHigh, p);
      if (plane) {
        ASSERT_LT(told, -depth);
        ASSERT_EQ(plane->distance, told);
        ASSERT_EQ(above, 0.0);
        ++found;
      } else if (told < -depth) {
        ASSERT_GE(truth, -depth);  // told too deep, and the solid's grid knows
      }
      // The box is convex: what is promised holds for what is outside.
      if (truth > 0.0) {
        ASSERT_LE(above, std::max(0.0, truth + depth) + 1e-6);
        ASSERT_LE(field.clear_of(p, depth), std::max(0.0, truth + depth) + 1e-6);
      }
    }
    EXPECT_GT(found, 300) << depth;
  }
}

TEST(DistanceField, BeyondItsCellsTheSolidIsAsked) {
  Mesh mesh;
  add_box({-0.02, -0.02, -0.02}, {0.02, 0.02, 0.02}, mesh);
  const DistanceField field{Solid(mesh)};
  const SurfacePlane right = field.at({0.5, 0.01, 0.003});
  EXPECT_NEAR(right.distance, 0.48, 1e-7);
  EXPECT_NEAR(right.normal.x, 1.0, 1e-12);
  // As large as a hall: cells do not reach through all of it.
  Mesh hall;
  add_box({-20, -3, -10}, {20, 3, 10}, hall);
  const DistanceField large{Solid(hall)};
  EXPECT_NEAR(large.at({19.5, 0.0, 0.0}).distance, -0.5, 1e-6);
  EXPECT_NEAR(large.at({-19.995, 0.0, 0.0}).distance, -0.005, 2e-6);
  EXPECT_NEAR(large.at({25.0, 0.0, 0.0}).distance, 5.0, 1e-6);
}

TEST(DistanceField, FromWhatIsNowhereEverythingIsFar) {
  const DistanceField field{Solid(Mesh{})};
  double above = 0.0;
  EXPECT_GT(field.at({0, 0, 0}).distance, 1e9);
  EXPECT_FALSE(field.below({0, 0, 0}, -1.0, above));
  EXPECT_GT(above, 1e9);
  EXPECT_GT(field.clear_of({0, 0, 0}, -1.0), 1e9);
}

TEST(DistanceField, TellsTheSameWhoeverAsksFirst) {
  const Mesh mesh = sphere(0.03, 30, 60);
  const std::vector<Vec3> points = points_within(0.05, 20000);
  const auto told_by = [&](const DistanceField& field, std::vector<SurfacePlane>& told, bool from_the_end) {
    told.resize(points.size());
    for (size_t i = 0; i < points.size(); ++i) {
      const size_t at = from_the_end ? points.size() - 1 - i : i;
      told[at] = field.at(points[at]);
    }
  };
  const auto same = [](const std::vector<SurfacePlane>& a, const std::vector<SurfacePlane>& b) {
    return std::ranges::equal(a, b, [](const SurfacePlane& x, const SurfacePlane& y) {
      return x.distance == y.distance && x.normal == y.normal;
    });
  };
  std::vector<SurfacePlane> first;
  told_by(DistanceField{Solid(mesh)}, first, false);
  std::vector<SurfacePlane> backwards;
  told_by(DistanceField{Solid(mesh)}, backwards, true);
  EXPECT_TRUE(same(first, backwards));
  const DistanceField shared{Solid(mesh)};
  std::vector<std::vector<SurfacePlane>> told(4);
  std::vector<std::thread> threads;
  for (size_t t = 0; t < told.size(); ++t)
    threads.emplace_back([&, t] { told_by(shared, told[t], t % 2 == 1); });
  for (std::thread& thread : threads)
    thread.join();
  for (const auto& one : told)
    EXPECT_TRUE(same(first, one));
}

}  // namespace
}  // namespace auslan
