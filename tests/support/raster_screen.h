// SPDX-License-Identifier: Apache-2.0
// For tests of the rasteriser: triangles given directly on its sub-pixel grid, a seeded generator, and the exact rule
// for which points a triangle covers.
#pragma once

#include "raster/renderer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

namespace auslan::raster {

/// SplitMix64: the same numbers on every machine.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}
  uint64_t next() {
    state_ += 0x9E3779B97F4A7C15ULL;
    uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }
  /// A whole number from `low` to `high`, both included.
  int64_t between(int64_t low, int64_t high) {
    return low + static_cast<int64_t>(next() % static_cast<uint64_t>(high - low + 1));
  }
  /// A number from `low` to `high`.
  float real(float low, float high) { return low + (high - low) * (static_cast<float>(next() >> 40U) / 16777216.0F); }

 private:
  uint64_t state_;
};

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

/// A renderer whose clip space is the world, lit by full white light: colours arrive as they are. Sizes that are powers
/// of two put points of the grid exactly where they belong.
class Screen {
 public:
  Screen(int width, int height, int samples = 1) : width_(width), height_(height), samples_(samples) {
    pixels.resize(pixel_count(width, height));
    begin();
  }

  void begin(uint32_t background = 0) {
    ASSERT_EQ(renderer.begin_frame(width_, height_, samples_, background), Status::kOk);
    renderer.set_camera(Camera{});
    renderer.set_lighting(Lighting{});
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
    const glm::vec3 positions[3] = {place(triangle[0], depth), place(triangle[1], depth), place(triangle[2], depth)};
    const glm::u8vec4 colours[3] = {colour, colour, colour};
    const uint32_t indices[3] = {0, 1, 2};
    renderer.draw(MeshView{positions, {}, colours, indices}, glm::mat4(1.0F), Shading::kFlat, cull);
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
  int width_;
  int height_;
  int samples_;
};

}  // namespace auslan::raster
