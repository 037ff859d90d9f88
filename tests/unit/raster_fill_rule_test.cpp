// SPDX-License-Identifier: Apache-2.0
// Coverage against exact arithmetic: which pixel centres a triangle covers, and that triangles with a common edge share
// every pixel between them without a gap and without an overlap.
#include "raster_screen.h"

#include <sstream>
#include <string>

namespace auslan::raster {
namespace {

constexpr uint32_t kWhite = 0xFFFFFFU;

class FillRule : public OnEveryKernel {};
ON_EVERY_KERNEL(FillRule);
class SharedEdges : public OnEveryKernel {};
ON_EVERY_KERNEL(SharedEdges);

std::string text(const Triangle& t) {
  std::ostringstream out;
  for (const Point& p : t)
    out << "(" << p.x << ", " << p.y << ") ";
  return out.str();
}

// Draws `count` triangles, each on a frame of its own, and compares every pixel with the reference.
template <typename Make>
void expect_exact(int width, int height, int count, uint64_t seed, Make make) {
  Random random(seed);
  Screen screen(width, height);
  int wrong = 0;
  int64_t covered = 0;
  for (int i = 0; i < cases(count) && wrong < 5; ++i) {
    const Triangle triangle = make(random);
    screen.begin();
    screen.add(triangle);
    screen.end();
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const bool expected = covers(triangle, centre(column, row));
        covered += expected ? 1 : 0;
        if (screen.pixel(column, row) == (expected ? kWhite : 0U)) continue;
        ++wrong;
        ADD_FAILURE() << "triangle " << i << " " << text(triangle) << "pixel " << column << ", " << row
                      << (expected ? " is missing" : " is too many");
      }
    }
  }
  EXPECT_GT(covered, 0) << "the triangles of this test cover nothing";
}

Point anywhere(Random& r, int64_t margin, int64_t width, int64_t height) {
  const int64_t x = r.between(-margin, width * 256 + margin);
  const int64_t y = r.between(-margin, height * 256 + margin);
  return {x, y};
}

TEST_P(FillRule, RandomTriangles) {
  expect_exact(32, 16, 80000, 1, [](Random& r) {
    const Point a = anywhere(r, 2000, 32, 16);
    const Point b = anywhere(r, 2000, 32, 16);
    const Point c = anywhere(r, 2000, 32, 16);
    return Triangle{a, b, c};
  });
}

// Corners on pixel centres and corners: edges pass exactly through many centres, so that the rule for ties decides.
TEST_P(FillRule, TrianglesOnTheHalfPixelLattice) {
  expect_exact(16, 16, 60000, 2, [](Random& r) {
    Triangle t;
    for (Point& p : t) {
      p.x = r.between(-4, 36) * 128;
      p.y = r.between(-4, 36) * 128;
    }
    return t;
  });
}

TEST_P(FillRule, SubPixelTriangles) {
  expect_exact(4, 4, 60000, 3, [](Random& r) {
    const Point a = anywhere(r, 0, 4, 4);
    const Point b = {a.x + r.between(-200, 200), a.y + r.between(-200, 200)};
    const Point c = {a.x + r.between(-200, 200), a.y + r.between(-200, 200)};
    return Triangle{a, b, c};
  });
}

TEST_P(FillRule, Slivers) {
  expect_exact(32, 16, 30000, 4, [](Random& r) {
    const Point a = anywhere(r, 3000, 32, 16);
    const Point b = anywhere(r, 3000, 32, 16);
    const int64_t t = r.between(0, 256);  // near the line from a to b, a few sub-pixels beside it
    const Point c = {a.x + (b.x - a.x) * t / 256 + r.between(-3, 3), a.y + (b.y - a.y) * t / 256 + r.between(-3, 3)};
    return Triangle{a, b, c};
  });
}

TEST_P(FillRule, NeedlesThatReachFarBeyondTheFrame) {
  expect_exact(32, 16, 20000, 5, [](Random& r) {
    const Point a = anywhere(r, 0, 32, 16);
    const Point b = anywhere(r, 4000000, 32, 16);
    const Point c = {b.x + r.between(-400, 400), b.y + r.between(-400, 400)};
    return Triangle{a, b, c};
  });
}

TEST_P(FillRule, ScreenCoveringTriangles) {
  expect_exact(32, 16, 20000, 6, [](Random& r) {
    return Triangle{anywhere(r, 4000000, 32, 16), anywhere(r, 4000000, 32, 16), anywhere(r, 4000000, 32, 16)};
  });
}

TEST_P(FillRule, ZeroAreaCoversNothing) {
  Random random(7);
  Screen screen(16, 16);
  for (int i = 0; i < 2000; ++i) {
    const Point a = anywhere(random, 500, 16, 16);
    const Point step = {random.between(-300, 300), random.between(-300, 300)};
    const int64_t m = random.between(-9, 9);
    const Triangle line = {a, Point{a.x + step.x, a.y + step.y}, Point{a.x + m * step.x, a.y + m * step.y}};
    screen.begin();
    screen.add(line);
    screen.end();
    EXPECT_EQ(screen.renderer.stats().culled, 1U);
    for (const uint32_t pixel : screen.pixels)
      ASSERT_EQ(pixel, 0U) << text(line);
  }
}

TEST_P(FillRule, OffScreenTrianglesLeaveTheBackground) {
  Random random(8);
  Screen screen(16, 16);
  for (int i = 0; i < 2000; ++i) {
    Triangle t = {anywhere(random, 900, 16, 16), anywhere(random, 900, 16, 16), anywhere(random, 900, 16, 16)};
    const int64_t shift_x = random.between(0, 1) != 0 ? 6000 : -6000;
    for (Point& p : t)
      p.x += shift_x;
    screen.begin(0x123456);
    screen.add(t);
    screen.end();
    for (const uint32_t pixel : screen.pixels)
      ASSERT_EQ(pixel, 0x123456U) << text(t);
  }
}

// The widest and tallest frames, where a 32-bit edge function or a float would overflow or round.
TEST_P(FillRule, LargestFrames) {
  const auto make = [](int64_t width, int64_t height) {
    return [width, height](Random& r) {
      const int64_t reach_x = width == 16384 ? 2090000 : 4000000;
      const int64_t reach_y = height == 16384 ? 2090000 : 4000000;
      Triangle t;
      for (Point& p : t) {
        p.x = r.between(-reach_x, width * 256 + reach_x);
        p.y = r.between(-reach_y, height * 256 + reach_y);
      }
      if (r.between(0, 1) != 0) t[1] = Point{t[0].x + r.between(-999, 999), t[0].y + r.between(-999, 999)};
      return t;
    };
  };
  expect_exact(16384, 4, 150, 9, make(16384, 4));
  expect_exact(4, 16384, 150, 10, make(4, 16384));
}

// Sizes that are not powers of two: the projection rounds, but by far less than half a sub-pixel near the frame.
TEST_P(FillRule, OddFrameSizes) {
  for (const int size : {1, 3, 7, 33}) {
    expect_exact(size, 9, 3000, 11, [size](Random& r) {
      const Point a = anywhere(r, 600, size, 9);
      const Point b = anywhere(r, 600, size, 9);
      const Point c = anywhere(r, 600, size, 9);
      return Triangle{a, b, c};
    });
  }
}

TEST_P(FillRule, BothWindingsCoverTheSamePixelsAndOnlyOneIsAFront) {
  Random random(12);
  Screen screen(16, 16);
  for (int i = 0; i < 3000; ++i) {
    const Triangle t = {anywhere(random, 400, 16, 16), anywhere(random, 400, 16, 16), anywhere(random, 400, 16, 16)};
    // y runs down: counter-clockwise to the eye is a negative area.
    const bool front = doubled_area(t[0], t[1], t[2]) < 0;
    screen.begin();
    screen.add(t, glm::u8vec4(255), 0.5F, CullMode::kBack);
    screen.end();
    for (int row = 0; row < 16; ++row) {
      for (int column = 0; column < 16; ++column) {
        const bool expected = front && covers(t, centre(column, row));
        ASSERT_EQ(screen.pixel(column, row), expected ? kWhite : 0U) << text(t);
      }
    }
  }
}

// How often each pixel is covered by a set of triangles, each drawn alone.
std::vector<int> cover_counts(Screen& screen, const std::vector<Triangle>& triangles) {
  std::vector<int> counts(screen.pixels.size(), 0);
  for (const Triangle& t : triangles) {
    screen.begin();
    screen.add(t);
    screen.end();
    for (size_t i = 0; i < counts.size(); ++i)
      counts[i] += screen.pixels[i] == kWhite ? 1 : 0;
  }
  return counts;
}

TEST_P(SharedEdges, RandomTriangulationDrawsEveryPixelOnce) {
  Random random(20);
  Screen screen(32, 32);
  for (int mesh = 0; mesh < 60; ++mesh) {
    // A quadrilateral round the frame, split again and again at random lattice points inside random triangles.
    const Point corner[4] = {{-300, -200}, {-100, 9000}, {8900, 8400}, {8500, -700}};
    std::vector<Triangle> triangles = {Triangle{corner[0], corner[1], corner[2]},
                                       Triangle{corner[0], corner[2], corner[3]}};
    const int64_t lattice = mesh % 2 == 0 ? 1 : 128;
    for (int split = 0; split < 40; ++split) {
      const Point p = {random.between(0, 8192 / lattice) * lattice, random.between(0, 8192 / lattice) * lattice};
      for (size_t i = 0; i < triangles.size(); ++i) {
        const Triangle t = triangles[i];
        const Wide s0 = doubled_area(t[0], t[1], p);
        const Wide s1 = doubled_area(t[1], t[2], p);
        const Wide s2 = doubled_area(t[2], t[0], p);
        if (!(s0 < 0 && s1 < 0 && s2 < 0)) continue;  // strictly inside only, so that no corner lies on an edge
        triangles[i] = Triangle{t[0], t[1], p};
        triangles.push_back(Triangle{t[1], t[2], p});
        triangles.push_back(Triangle{t[2], t[0], p});
        break;
      }
    }
    ASSERT_GT(triangles.size(), 20U);
    for (const int count : cover_counts(screen, triangles))
      ASSERT_EQ(count, 1) << "mesh " << mesh;
  }
}

TEST_P(SharedEdges, FanDrawsEveryPixelOnce) {
  Random random(21);
  Screen screen(32, 32);
  for (int mesh = 0; mesh < 60; ++mesh) {
    const Point hub = {random.between(0, 64) * 128, random.between(0, 64) * 128};
    // Round a rectangle, so that the hub sees the rim in order, at random steps along its sides.
    const auto along = [&random](int64_t i) { return i * 1088 + (i == 0 ? 0 : random.between(0, 900)); };
    std::vector<Point> rim;
    for (int64_t i = 0; i < 8; ++i)
      rim.push_back({-256 + along(i), -256});
    for (int64_t i = 0; i < 8; ++i)
      rim.push_back({8448, -256 + along(i)});
    for (int64_t i = 0; i < 8; ++i)
      rim.push_back({8448 - along(i), 8448});
    for (int64_t i = 0; i < 8; ++i)
      rim.push_back({-256, 8448 - along(i)});
    std::vector<Triangle> triangles;
    for (size_t i = 0; i < rim.size(); ++i)
      triangles.push_back(Triangle{hub, rim[i], rim[(i + 1) % rim.size()]});
    for (const int count : cover_counts(screen, triangles))
      ASSERT_EQ(count, 1) << "mesh " << mesh;
  }
}

TEST_P(SharedEdges, JitteredGridDrawsEveryPixelOnce) {
  Random random(22);
  Screen screen(32, 32);
  constexpr size_t kCells = 10;
  for (int mesh = 0; mesh < 20; ++mesh) {
    // Jitter of up to a third of a cell keeps every cell convex enough to be cut along either diagonal.
    std::vector<Point> points;
    for (size_t row = 0; row <= kCells; ++row) {
      for (size_t column = 0; column <= kCells; ++column) {
        const int64_t x = -500 + static_cast<int64_t>(column) * 950 + random.between(-230, 230);
        const int64_t y = -500 + static_cast<int64_t>(row) * 950 + random.between(-230, 230);
        points.push_back({x, y});
      }
    }
    std::vector<Triangle> triangles;
    for (size_t row = 0; row < kCells; ++row) {
      for (size_t column = 0; column < kCells; ++column) {
        const Point& a = points[row * (kCells + 1) + column];
        const Point& b = points[row * (kCells + 1) + column + 1];
        const Point& c = points[(row + 1) * (kCells + 1) + column + 1];
        const Point& d = points[(row + 1) * (kCells + 1) + column];
        if (random.between(0, 1) != 0) {
          triangles.push_back(Triangle{a, b, c});
          triangles.push_back(Triangle{a, c, d});
        } else {
          triangles.push_back(Triangle{a, b, d});
          triangles.push_back(Triangle{b, c, d});
        }
      }
    }
    for (const int count : cover_counts(screen, triangles))
      ASSERT_EQ(count, 1) << "mesh " << mesh;
  }
}

}  // namespace
}  // namespace auslan::raster
