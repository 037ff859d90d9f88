// SPDX-License-Identifier: Apache-2.0
// For tests of the rasteriser: triangles given directly on its sub-pixel grid, the exact rule for which points a
// triangle covers, and tests that run on every kernel.
#pragma once

#include "raster/renderer.h"
#include "raster_random.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace auslan::raster {

/// A point on the screen in 1/256 pixel from the top-left corner, y down.
struct Point {
  int64_t x = 0;
  int64_t y = 0;
};
using Triangle = std::array<Point, 3>;

__extension__ typedef __int128 Wide;  // a typedef: __extension__ does not reach into an alias

/// Twice the signed area, exact.
inline Wide doubled_area(const Point& a, const Point& b, const Point& c) {
  return static_cast<Wide>(b.x - a.x) * (c.y - a.y) - static_cast<Wide>(c.x - a.x) * (b.y - a.y);
}

/// The top-left rule as one statement without cases: a triangle covers a point when the point, moved right by an
/// infinitesimal amount and down by an infinitely smaller one, lies strictly inside. Exact in 128 bits.
inline bool covers(const Triangle& triangle, const Point& p) {
  const Wide area = doubled_area(triangle[0], triangle[1], triangle[2]);
  if (area == 0) return false;
  for (size_t i = 0; i < 3; ++i) {
    const Point& from = triangle[i];
    const Point& to = triangle[(i + 1) % 3];
    // The side of p + (e, e^2): the terms in 1, e and e^2, of which the first that is not zero decides.
    const Wide terms[3] = {doubled_area(from, to, p), static_cast<Wide>(from.y - to.y),
                           static_cast<Wide>(to.x - from.x)};
    Wide side = 0;
    for (const Wide term : terms) {
      if (side == 0) side = term;
    }
    if ((side > 0) != (area > 0)) return false;
  }
  return true;
}

/// The centre of a pixel.
inline Point centre(int column, int row) {
  return {int64_t{column} * 256 + 128, int64_t{row} * 256 + 128};
}

/// The kernel of every Screen that is made from now on.
inline Kernel& kernel_under_test() {
  static Kernel kernel = chosen_kernel().value_or(Kernel::kScalar);
  return kernel;
}

/// A fixture whose tests run once with each kernel that runs here; ON_EVERY_KERNEL(Suite) after the class.
class OnEveryKernel : public testing::TestWithParam<Kernel> {
 protected:
  void SetUp() override { kernel_under_test() = GetParam(); }
};

inline std::string kernel_test_name(const testing::TestParamInfo<Kernel>& kernel) {
  return std::string(name_of(kernel.param));
}

inline std::vector<Kernel> kernels_here() {
  const std::span<const Kernel> kernels = runnable_kernels();
  return {kernels.begin(), kernels.end()};
}

// Sanitizers slow the scalar kernel down fifty times.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int kPartOf = 5;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr int kPartOf = 5;
#else
inline constexpr int kPartOf = 1;
#endif
#else
inline constexpr int kPartOf = 1;
#endif
/// How many of `count` random cases to try: all of them, or a part in a build with sanitizers.
inline constexpr int cases(int count) {
  return count < kPartOf ? 1 : count / kPartOf;
}

#define ON_EVERY_KERNEL(suite) \
  INSTANTIATE_TEST_SUITE_P(Kernel, suite, testing::ValuesIn(kernels_here()), kernel_test_name)

/// A renderer whose clip space is the world, lit by full white light: colours arrive as they are. Sizes that are powers
/// of two put points of the grid exactly where they belong.
class Screen {
 public:
  Screen(int width, int height, int samples = 1, int threads = 1)
      : renderer(threads, kernel_under_test()), width_(width), height_(height), samples_(samples) {
    pixels.resize(pixel_count(width, height));
    begin();
  }

  /// Starts a frame; the meshes of the last one are gone then.
  void begin(uint32_t background = 0) {
    ASSERT_EQ(renderer.begin_frame(width_, height_, samples_, background), Status::kOk);
    renderer.set_camera(Camera{});
    renderer.set_lighting(Lighting{});
    single_.clear();
    kept_.clear();
  }

  /// Where a grid point lies in clip space, w = 1.
  glm::vec3 place(const Point& p, float depth = 0.5F) const {
    const double half_x = width_ * 128.0;
    const double half_y = height_ * 128.0;
    return glm::vec3(static_cast<float>((static_cast<double>(p.x) - half_x) / half_x),
                     static_cast<float>((half_y - static_cast<double>(p.y)) / half_y), depth);
  }

  void add(const Triangle& triangle, const glm::u8vec4& colour = glm::u8vec4(255), float depth = 0.5F,
           CullMode cull = CullMode::kNone) {
    add_single({place(triangle[0], depth), place(triangle[1], depth), place(triangle[2], depth)}, colour, cull);
  }

  /// One flat triangle, anywhere.
  void add_single(const std::array<glm::vec3, 3>& positions, const glm::u8vec4& colour, CullMode cull) {
    static constexpr uint32_t kIndices[3] = {0, 1, 2};
    const Single& kept = single_.emplace_back(Single{positions, {colour, colour, colour}});
    renderer.draw(MeshView{kept.positions, {}, kept.colours, kIndices}, glm::mat4(1.0F), Shading::kFlat, cull);
  }

  /// A mesh that this screen keeps for the rest of the frame.
  void add_mesh(std::vector<glm::vec3> positions, std::vector<glm::vec3> normals, std::vector<glm::u8vec4> colours,
                std::vector<uint32_t> indices, Shading shading, CullMode cull = CullMode::kNone,
                const glm::mat4& world = glm::mat4(1.0F)) {
    const Kept& kept =
        kept_.emplace_back(Kept{std::move(positions), std::move(normals), std::move(colours), std::move(indices)});
    renderer.draw(MeshView{kept.positions, kept.normals, kept.colours, kept.indices}, world, shading, cull);
  }

  void end() { ASSERT_EQ(renderer.end_frame(pixels), Status::kOk); }

  uint32_t pixel(int column, int row) const {
    return pixels[static_cast<size_t>(row) * static_cast<size_t>(width_) + static_cast<size_t>(column)];
  }
  int width() const { return width_; }
  int height() const { return height_; }

  Renderer renderer;
  std::vector<uint32_t> pixels;

 private:
  // A renderer reads its meshes until the frame ends; the elements of a deque stay where they are.
  struct Single {
    std::array<glm::vec3, 3> positions;
    std::array<glm::u8vec4, 3> colours;
  };
  struct Kept {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::u8vec4> colours;
    std::vector<uint32_t> indices;
  };
  std::deque<Single> single_;
  std::deque<Kept> kept_;
  int width_;
  int height_;
  int samples_;
};

}  // namespace auslan::raster
