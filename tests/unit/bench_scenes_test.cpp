// SPDX-License-Identifier: Apache-2.0
// The benchmark's scenes are what it says they are, and its way of measuring is fair.
#include "measurement.h"
#include "picture_difference.h"
#include "scene.h"
#include "workload.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace auslan::bench {
namespace {

double twice_area(const SceneMesh& mesh, size_t triangle) {
  const glm::vec3& a = mesh.positions[mesh.indices[3 * triangle]];
  const glm::vec3& b = mesh.positions[mesh.indices[3 * triangle + 1]];
  const glm::vec3& c = mesh.positions[mesh.indices[3 * triangle + 2]];
  return static_cast<double>(b.x - a.x) * static_cast<double>(c.y - a.y) -
         static_cast<double>(b.y - a.y) * static_cast<double>(c.x - a.x);
}

TEST(BenchScenes, TinyTrianglesHaveTwoToFourPixels) {
  const Scene scene = load_scene("tiny");
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_NEAR(static_cast<double>(scene.triangle_count()), 500e3, 1e3);
  // Clip space is 2 by 2, the picture 1920 by 1080.
  const double pixels_of_area = 1920.0 * 1080.0 / 4.0;
  double least = 1e9, most = 0;
  for (size_t i = 0; i < scene.triangle_count(); ++i) {
    const double pixels = twice_area(scene.meshes[0], i) / 2 * pixels_of_area;
    least = std::min(least, pixels);
    most = std::max(most, pixels);
  }
  EXPECT_GE(least, 2.0);
  EXPECT_LE(most, 4.0);
}

TEST(BenchScenes, FillIsFiftyLargeTrianglesInTwoOrders) {
  const Scene random = load_scene("fill");
  const Scene sorted = load_scene("back_to_front");
  ASSERT_EQ(random.triangle_count(), 50U);
  ASSERT_EQ(sorted.triangle_count(), 50U);
  const auto depths = [](const Scene& scene) {
    std::vector<float> first;
    for (size_t i = 0; i < 50; ++i)
      first.push_back(scene.meshes[0].positions[3 * i].z);
    return first;
  };
  for (size_t i = 0; i < 50; ++i)
    EXPECT_GE(twice_area(sorted.meshes[0], i) / 2, 0.3 * 4) << i;
  // Nearer has the greater depth. Sorted, each triangle lies wholly before the one that was drawn earlier.
  for (size_t i = 3; i < 150; ++i)
    for (size_t j = 0; j < 3; ++j)
      EXPECT_GT(sorted.meshes[0].positions[i].z, sorted.meshes[0].positions[i / 3 * 3 - 3 + j].z);
  std::vector<float> mixed = depths(random);
  EXPECT_FALSE(std::ranges::is_sorted(mixed));
  std::ranges::sort(mixed);
  EXPECT_EQ(mixed, depths(sorted));
}

TEST(BenchScenes, SignerHasThreeLevelsOfDetail) {
  const struct {
    const char* name;
    double triangles;
  } kLevels[] = {{"signer_5k", 5e3}, {"signer_22k", 22e3}, {"signer_90k", 90e3}};
  for (const auto& level : kLevels) {
    const Scene scene = load_scene(level.name);
    EXPECT_NEAR(static_cast<double>(scene.triangle_count()), level.triangles, 0.05 * level.triangles);
    const auto moved = std::ranges::count_if(
        scene.meshes, [](const SceneMesh& mesh) { return mesh.world_from_mesh != mesh.moved_world_from_mesh; });
    EXPECT_GT(moved, 0) << level.name;
    EXPECT_LT(static_cast<size_t>(moved), scene.meshes.size() / 2) << level.name << ": one arm is less than half";
    for (const SceneMesh& mesh : scene.meshes) {
      EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
      EXPECT_EQ(mesh.colours.size(), mesh.positions.size());
      for (const glm::vec3& n : mesh.normals)
        EXPECT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1.0F, 1e-3F);
      for (const uint32_t index : mesh.indices)
        ASSERT_LT(index, mesh.positions.size());
    }
  }
}

TEST(BenchScenes, SignerIsTheWorkloadThatTheFiguresWereSetOn) {
  // There 22 thousand triangles at 1280x720 were 10,600 front-facing ones, 9,000 of them over a pixel's centre, with
  // 185,000 fragments. This signer holds both arms before the body: an eighth more faces the eye, in more layers.
  const Workload middle = workload_of(load_scene("signer_22k"), 1280, 720);
  EXPECT_NEAR(static_cast<double>(middle.fragments), 185e3, 0.05 * 185e3);
  EXPECT_NEAR(static_cast<double>(middle.front_facing), 10.6e3, 0.15 * 10.6e3);
  EXPECT_NEAR(static_cast<double>(middle.covering), 9.0e3, 0.15 * 9.0e3);
  EXPECT_NEAR(middle.overdraw(), 1.35, 0.3);
  // The same figure in the other levels: as many fragments, other triangles.
  for (const char* name : {"signer_5k", "signer_90k"})
    EXPECT_NEAR(static_cast<double>(workload_of(load_scene(name), 1280, 720).fragments), 185e3, 0.05 * 185e3) << name;
}

TEST(BenchScenes, WorkloadOfASquareIsItsPixels) {
  // Half of clip space each way on 64 x 64 pixels: 32 x 32 pixels in two triangles, facing the eye.
  Scene square;
  square.perspective = false;
  SceneMesh mesh;
  mesh.positions = {{-0.5F, -0.5F, 0.5F}, {0.5F, -0.5F, 0.5F}, {0.5F, 0.5F, 0.5F}, {-0.5F, 0.5F, 0.5F}};
  mesh.indices = {0, 1, 2, 0, 2, 3, 0, 2, 1};
  square.meshes.push_back(mesh);
  Workload work = workload_of(square, 64, 64);
  EXPECT_EQ(work.front_facing, 2U);
  EXPECT_EQ(work.covering, 2U);
  EXPECT_EQ(work.fragments, 32U * 32U);
  EXPECT_EQ(work.pixels, 32U * 32U);
  // Twice the same: twice the fragments in the same pixels.
  square.meshes.push_back(mesh);
  work = workload_of(square, 64, 64);
  EXPECT_EQ(work.fragments, 2 * 32U * 32U);
  EXPECT_EQ(work.overdraw(), 2.0);
}

TEST(BenchMeasurement, EnginesTakeTurnsAndMediansLeaveTheWarmingFrameOut) {
  std::string turns;
  int frame = 0;
  const auto engine = [&turns, &frame](const std::string& name, double ms) {
    return Engine{name, [&turns, &frame, name, ms](int frames) {
                    turns += name;
                    std::vector<FrameTime> times;
                    for (int i = 0; i < frames; ++i) {
                      ++frame;
                      // The first frame of a turn is slow, as after another engine used the caches.
                      times.push_back({i == 0 ? 1000.0 : ms, i == 0 ? 1000.0 : 2 * ms});
                    }
                    return times;
                  }};
  };
  const std::vector<Figures> figures = measure({engine("a", 3), engine("b", 5)}, {4, 30, 40});
  EXPECT_EQ(turns.substr(turns.size() - 8), "abababab");
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].cpu_ms, 3);
  EXPECT_EQ(figures[0].wall_ms, 6);
  EXPECT_EQ(figures[0].least_cpu_ms, 3);
  EXPECT_EQ(figures[1].cpu_ms, 5);
  // 30 ms a turn: 5 frames of 6 ms wall, 3 frames of 10 ms; 4 rounds.
  EXPECT_EQ(figures[0].frames, 20);
  EXPECT_EQ(figures[1].frames, 12);
}

TEST(BenchMeasurement, AnEngineThatCannotDrawHasNoFigures) {
  const std::vector<Figures> figures = measure({{"gone", [](int) { return std::vector<FrameTime>(); }}}, {2, 1, 1});
  EXPECT_EQ(figures[0].frames, 0);
  EXPECT_EQ(figures[0].cpu_ms, 0);
}

TEST(BenchPictures, DifferenceIsMeasuredInLevels) {
  const std::vector<uint32_t> black(100, 0);
  std::vector<uint32_t> other = black;
  EXPECT_EQ(difference_of(black, other).mean_level, 0);
  EXPECT_EQ(difference_of(black, other).share_far_off, 0);
  for (uint32_t& pixel : other)
    pixel = 0x000300;
  EXPECT_DOUBLE_EQ(difference_of(black, other).mean_level, 1.0);
  EXPECT_EQ(difference_of(black, other).share_far_off, 0);
  other[5] = 0x110000;
  EXPECT_DOUBLE_EQ(difference_of(black, other).share_far_off, 0.01);
  other.pop_back();
  EXPECT_EQ(difference_of(black, other).mean_level, 255) << "sizes that differ";
}

}  // namespace
}  // namespace auslan::bench
