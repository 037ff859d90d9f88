// SPDX-License-Identifier: Apache-2.0
// A warm renderer allocates nothing: every operator new of this program is counted.
#include "raster_scene.h"

#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

namespace {
std::atomic<long> allocations{0};  // of this program, since it started
}

void* operator new(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace auslan::raster {
namespace {

TEST(Allocation, NothingAfterTheFirstFrame) {
  const Scene scene;
  Renderer renderer;
  std::vector<uint32_t> pixels;
  const long cold = allocations;
  draw_scene(renderer, scene, 320, 180, 4, Shading::kGouraud, pixels);
  EXPECT_GT(allocations - cold, 0L) << "the count should see the first frame allocate";
  const long warm = allocations;
  for (int frame = 0; frame < 3; ++frame) {
    draw_scene(renderer, scene, 320, 180, 4, Shading::kGouraud, pixels);
    draw_scene(renderer, scene, 200, 100, 2, Shading::kFlat, pixels);
  }
  EXPECT_EQ(allocations - warm, 0L);
}

}  // namespace
}  // namespace auslan::raster
