// SPDX-License-Identifier: Apache-2.0
// Random triangles of every kind against the exact rule, many to a frame: each in a square cell of its own, or one
// after the other in a small frame that they may reach far out of.
#pragma once

#include "raster_screen.h"

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace auslan::raster {

/// How many triangles of each kind the fastest kernel is compared with; every other one with a tenth of them.
struct TriangleCounts {
  int random = 600000, lattice = 300000, sub_pixel = 300000, slivers = 200000, zero_area = 100000;
  int beyond_the_frame = 100000, needles = 100000, screen_covering = 60000, off_screen = 50000;
  int boundary_sizes = 40000, largest_frames = 100000, far_in_largest_frames = 1000;
  int perspective = 100000, overlapping = 20000, multisampled = 150000, near_plane = 100000;

  constexpr int total() const {
    return random + lattice + sub_pixel + slivers + zero_area + beyond_the_frame + needles + screen_covering +
           off_screen + boundary_sizes + largest_frames + far_in_largest_frames + perspective + overlapping +
           multisampled + near_plane;
  }
};
inline constexpr TriangleCounts kTriangleCounts;
static_assert(kTriangleCounts.total() >= 2000000);

/// The part of a count that the kernel under test has to do.
inline int share_of(int count) {
  return kernel_under_test() == chosen_kernel().value_or(Kernel::kScalar) ? count : count / 10;
}

inline std::string text(const Triangle& t) {
  std::ostringstream out;
  for (const Point& p : t)
    out << "(" << p.x << ", " << p.y << ") ";
  return out.str();
}

inline Point point_in(Random& random, int64_t low, int64_t high) {
  const int64_t x = random.between(low, high);
  const int64_t y = random.between(low, high);
  return {x, y};
}
inline Point moved(const Point& p, Random& random, int64_t reach) {
  const Point step = point_in(random, -reach, reach);
  return {p.x + step.x, p.y + step.y};
}

// The kinds: corners in sub-pixels between `low` and `high` in x and y, unless their names say otherwise.

inline Triangle random_triangle(Random& random, int64_t low, int64_t high) {
  Triangle t;
  for (Point& p : t)
    p = point_in(random, low, high);
  return t;
}
/// Corners on pixel centres and corners: edges pass exactly through many centres, so that the rule for ties decides.
inline Triangle lattice_triangle(Random& random, int64_t low, int64_t high) {
  Triangle t;
  for (Point& p : t) {
    p = point_in(random, low / 128, high / 128);
    p = {p.x * 128, p.y * 128};
  }
  return t;
}
inline Point held(const Point& p, int64_t low, int64_t high) {
  const auto between = [low, high](int64_t v) { return v < low ? low : v > high ? high : v; };
  return {between(p.x), between(p.y)};
}
/// No longer or wider than 400 sub-pixels, many of them around a pixel centre.
inline Triangle sub_pixel_triangle(Random& random, int64_t low, int64_t high) {
  Point a = point_in(random, low, high);
  if (random.once_in(2)) a = {a.x / 256 * 256 + random.between(98, 158), a.y / 256 * 256 + random.between(98, 158)};
  const int64_t reach = random.once_in(2) ? 200 : 40;
  const Point b = moved(a, random, reach);
  const Point c = moved(a, random, reach);
  return {held(a, low, high), held(b, low, high), held(c, low, high)};
}
/// The third corner lies a few sub-pixels beside the line through the others.
inline Triangle sliver_triangle(Random& random, int64_t low, int64_t high) {
  const Point a = point_in(random, low, high);
  const Point b = point_in(random, low, high);
  const int64_t t = random.between(0, 256);
  const Point on_line = {a.x + (b.x - a.x) * t / 256, a.y + (b.y - a.y) * t / 256};
  return {a, b, held(moved(on_line, random, 3), low, high)};
}
/// Three corners on one line, or two or three of them equal.
inline Triangle flat_triangle(Random& random, int64_t low, int64_t high) {
  const Point a = point_in(random, low, high);
  const int64_t reach = (high - low) / 16;
  const Point step = point_in(random, -reach, reach);
  const auto at = [&](int64_t m) { return Point{a.x + m * step.x, a.y + m * step.y}; };
  const auto inside = [&](const Point& p) { return p.x >= low && p.x <= high && p.y >= low && p.y <= high; };
  Triangle t = {a, at(random.between(-9, 9)), at(random.between(-9, 9))};
  for (Point& p : t)
    p = inside(p) ? p : a;
  return t;
}

/// Compares `count` triangles, each moved to a cell of `cell` pixels a side; `make` keeps to it. A frame has
/// `columns` x `rows` cells. Colours are numbers, so that a pixel tells which triangle drew it.
template <typename Make>
void expect_exact_in_cells(int cell, int columns, int rows, int count, uint64_t seed, Make make) {
  Random random(seed);
  Screen screen(cell * columns, cell * rows);
  const int per_frame = columns * rows;
  int64_t covered = 0;
  int wrong = 0;
  std::vector<Triangle> triangles;
  for (int done = 0; done < count && wrong < 5; done += per_frame) {
    std::vector<glm::vec3> positions;
    std::vector<glm::u8vec4> colours;
    std::vector<uint32_t> indices;
    triangles.clear();
    for (int i = 0; i < per_frame; ++i) {
      Triangle t = make(random, int64_t{0}, int64_t{cell} * 256);
      for (Point& p : t)
        p = {p.x + i % columns * int64_t{cell} * 256, p.y + i / columns * int64_t{cell} * 256};
      triangles.push_back(t);
      const auto number = static_cast<uint32_t>(i + 1);
      for (const Point& p : t) {
        indices.push_back(static_cast<uint32_t>(positions.size()));
        positions.push_back(screen.place(p));
        colours.emplace_back(red_of(number), green_of(number), blue_of(number), 255);
      }
    }
    screen.begin();
    screen.add_mesh(std::move(positions), {}, std::move(colours), std::move(indices), Shading::kFlat);
    screen.end();
    for (int i = 0; i < per_frame; ++i) {
      const Triangle& t = triangles[static_cast<size_t>(i)];
      for (int y = 0; y < cell; ++y) {
        for (int x = 0; x < cell; ++x) {
          const int column = i % columns * cell + x;
          const int row = i / columns * cell + y;
          const bool expected = covers(t, centre(column, row));
          covered += expected ? 1 : 0;
          if (screen.pixel(column, row) == (expected ? static_cast<uint32_t>(i + 1) : 0U)) continue;
          if (++wrong > 5) continue;
          ADD_FAILURE() << "triangle " << done + i << " " << text(t) << "pixel " << column << ", " << row
                        << (expected ? " is not its own" : " is not the background's") << ", it holds "
                        << screen.pixel(column, row);
        }
      }
    }
  }
  EXPECT_GT(covered, 0) << "the triangles of this test cover nothing";
}

/// Compares `count` triangles one after the other, wherever they lie, in a frame of `width` x `height`.
template <typename Make>
void expect_exact_in_frame(int width, int height, int count, uint64_t seed, Make make) {
  Random random(seed);
  Screen screen(width, height);
  int64_t covered = 0;
  int wrong = 0;
  for (int i = 0; i < count && wrong < 5; ++i) {
    const Triangle t = make(random);
    screen.begin();
    screen.add(t);
    screen.end();
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const bool expected = covers(t, centre(column, row));
        covered += expected ? 1 : 0;
        if (screen.pixel(column, row) == (expected ? 0xFFFFFFU : 0U)) continue;
        if (++wrong > 5) continue;
        ADD_FAILURE() << "triangle " << i << " " << text(t) << "pixel " << column << ", " << row
                      << (expected ? " is missing" : " is too many");
      }
    }
  }
  EXPECT_GT(covered, 0) << "the triangles of this test cover nothing";
}

}  // namespace auslan::raster
