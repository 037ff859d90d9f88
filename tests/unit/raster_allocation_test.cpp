// SPDX-License-Identifier: Apache-2.0
// A warm renderer allocates nothing: every operator new of this program is counted.
#include "raster_scene.h"
#include "raster_screen.h"
#include "raster_textured.h"

#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

namespace {
std::atomic<long> allocations{0};  // of this program, since it started
}

// Not inlined: g++ 12 would compare one half of a pair that it sees through with one that it does not.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto step = static_cast<std::size_t>(alignment);
  void* memory = std::aligned_alloc(step, (size / step + 1) * step);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace auslan::raster {
namespace {

class Allocation : public OnEveryKernel {};
ON_EVERY_KERNEL(Allocation);

constexpr FrameSize kLarge{320, 180, 4};
constexpr FrameSize kSmall{200, 100, 2};

TEST_P(Allocation, NothingAfterTheFirstFrame) {
  const Scene scene;
  const std::vector<SceneDraw> large = scene_draws(scene, kLarge.width, kLarge.height, Shading::kGouraud);
  const std::vector<SceneDraw> small = scene_draws(scene, kSmall.width, kSmall.height, Shading::kFlat);
  for (const int threads : {1, 3}) {
    Renderer renderer(threads, GetParam());
    std::vector<uint32_t> pixels(pixel_count(kLarge.width, kLarge.height));
    const long cold = allocations;
    draw_list(renderer, large, kLarge, pixels);
    EXPECT_GT(allocations - cold, 0L) << "the count should see the first frame allocate";
    draw_list(renderer, small, kSmall, pixels);
    const long warm = allocations;
    for (int frame = 0; frame < 20; ++frame) {
      draw_list(renderer, large, kLarge, pixels);
      draw_list(renderer, small, kSmall, pixels);
    }
    EXPECT_EQ(allocations - warm, 0L) << threads << " threads";
  }
}

TEST_P(Allocation, NothingForTexturesAndMasks) {
  const TexturedScene scene;
  const std::vector<SceneDraw> large = scene.draws(kLarge.width, kLarge.height, Shading::kGouraud);
  const std::vector<SceneDraw> small = scene.draws(kSmall.width, kSmall.height, Shading::kFlat);
  for (const int threads : {1, 3}) {
    Renderer renderer(threads, GetParam());
    std::vector<uint32_t> pixels(pixel_count(kLarge.width, kLarge.height));
    draw_list(renderer, large, kLarge, pixels);
    draw_list(renderer, small, kSmall, pixels);
    const long warm = allocations;
    for (int frame = 0; frame < 20; ++frame) {
      draw_list(renderer, large, kLarge, pixels);
      draw_list(renderer, small, kSmall, pixels);
    }
    EXPECT_EQ(allocations - warm, 0L) << threads << " threads";
  }
}

// Frames that follow each other, some of them still, in which one thing moves to and fro and another is gone every
// third time: after the first round nothing is allocated.
TEST_P(Allocation, NothingWhereOnlyChangesAreDrawn) {
  const Scene scene;
  std::vector<SceneDraw> all = scene_draws(scene, kLarge.width, kLarge.height, Shading::kGouraud);
  for (SceneDraw& draw : all)
    draw.mesh.revision = 1;
  std::vector<SceneDraw> fewer = all;
  fewer.pop_back();
  for (const int threads : {1, 3}) {
    Renderer renderer(threads, GetParam());
    std::vector<uint32_t> pixels;
    const auto round = [&] {
      for (const float x : {0.0F, 0.1F, 0.1F, -0.3F, 0.0F, 0.0F}) {
        std::vector<SceneDraw>& draws = x < 0.0F ? fewer : all;
        draws[1].world_from_mesh[3][0] = x;
        draw_list(renderer, draws, kLarge, pixels, SIZE_MAX, Canvas::kLastFrame);
      }
    };
    round();
    const long warm = allocations;
    for (int frame = 0; frame < 5; ++frame)
      round();
    EXPECT_EQ(allocations - warm, 0L) << threads << " threads";
    EXPECT_TRUE(renderer.damage().empty()) << "the last frame of a round is a still one";
  }
}

// Workers take what work there is, so that how much one of them gets differs from frame to frame: their memory must not
// grow with their luck.
TEST_P(Allocation, NothingInManyFramesOfManyThreads) {
  const Scene scene;
  const std::vector<SceneDraw> draws = scene_draws(scene, 640, 480, Shading::kGouraud);
  Renderer renderer(8, GetParam());
  std::vector<uint32_t> pixels;
  draw_list(renderer, draws, {640, 480, 1}, pixels);
  const long warm = allocations;
  for (int frame = 0; frame < 100; ++frame)
    draw_list(renderer, draws, {640, 480, 1}, pixels);
  EXPECT_EQ(allocations - warm, 0L);
}

}  // namespace
}  // namespace auslan::raster
