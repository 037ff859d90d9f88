// SPDX-License-Identifier: Apache-2.0
// Triangles with common edges share the pixels between them: no gap, no overlap. Each mesh covers more than the frame,
// so that every sample of it must be drawn exactly once, and holds triangles on both sides of 32 pixels, which take
// different paths, next to each other and across the borders of tiles.
#include "raster_conformance.h"

#include <algorithm>
#include <tuple>

namespace auslan::raster {
namespace {

constexpr int kWidth = 256;
constexpr int kHeight = 192;
constexpr int64_t kRight = kWidth * 256;
constexpr int64_t kBottom = kHeight * 256;

struct PlaneMesh {
  std::vector<Point> points;
  std::vector<std::array<uint32_t, 3>> triangles;

  uint32_t add(const Point& p) {
    points.push_back(p);
    return static_cast<uint32_t>(points.size() - 1);
  }
  Triangle corners(size_t i) const {
    const std::array<uint32_t, 3>& t = triangles[i];
    return {points[t[0]], points[t[1]], points[t[2]]};
  }
  // Any order of corners and either winding is the same triangle.
  void shuffle(Random& random) {
    for (std::array<uint32_t, 3>& t : triangles) {
      std::rotate(t.begin(), t.begin() + random.between(0, 2), t.end());
      if (random.once_in(2)) std::swap(t[0], t[1]);
    }
    for (size_t i = triangles.size(); i > 1; --i)
      std::swap(triangles[i - 1], triangles[random.next() % i]);
  }
};

bool positive(const PlaneMesh& mesh, uint32_t a, uint32_t b, uint32_t c) {
  return doubled_area(mesh.points[a], mesh.points[b], mesh.points[c]) > 0;
}

PlaneMesh quadrilateral(Random& random) {
  PlaneMesh mesh;
  const auto beyond = [&random] { return random.between(1, 90000); };
  const int64_t left = -beyond(), top = -beyond(), right = kRight + beyond(), bottom = kBottom + beyond();
  mesh.add({left, top - random.between(0, 5000)});
  mesh.add({right + random.between(0, 5000), top});
  mesh.add({right, bottom + random.between(0, 5000)});
  mesh.add({left - random.between(0, 5000), bottom});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// New points strictly inside random triangles; half of them crowd in one place, so that there are small ones.
PlaneMesh random_triangulation(Random& random) {
  PlaneMesh mesh = quadrilateral(random);
  const Point crowd = {random.between(0, kRight), random.between(0, kBottom)};
  const int64_t lattice = random.once_in(2) ? 1 : 128;
  for (int split = 0; split < 150; ++split) {
    const Point anywhere = {random.between(-2000, kRight + 2000), random.between(-2000, kBottom + 2000)};
    Point p = split % 2 == 0 ? anywhere : moved(crowd, random, 6000);
    p = {p.x / lattice * lattice, p.y / lattice * lattice};
    const uint32_t n = mesh.add(p);
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto [a, b, c] = mesh.triangles[i];
      if (!positive(mesh, a, b, n) || !positive(mesh, b, c, n) || !positive(mesh, c, a, n)) continue;
      mesh.triangles[i] = {a, b, n};
      mesh.triangles.push_back({b, c, n});
      mesh.triangles.push_back({c, a, n});
      break;
    }
  }
  return mesh;
}

// The longest edge of a random triangle is halved, in both of its triangles; again and again, mostly where it is
// crowded.
PlaneMesh refined_triangulation(Random& random) {
  PlaneMesh mesh = quadrilateral(random);
  const Point crowd = {random.between(0, kRight), random.between(0, kBottom)};
  for (int step = 0; step < 600; ++step) {
    size_t chosen = random.next() % mesh.triangles.size();
    if (step % 2 == 0) {
      for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (covers(mesh.corners(i), moved(crowd, random, 4000))) chosen = i;
      }
    }
    // The longest of its edges that another triangle has too.
    uint32_t from = 0, to = 0, mine = 0, theirs = 0;
    size_t across = mesh.triangles.size();
    Wide longest = 0;
    for (size_t e = 0; e < 3; ++e) {
      const std::array<uint32_t, 3>& t = mesh.triangles[chosen];
      const Point p = mesh.points[t[e]];
      const Point q = mesh.points[t[(e + 1) % 3]];
      const Wide length = Wide{q.x - p.x} * (q.x - p.x) + Wide{q.y - p.y} * (q.y - p.y);
      for (size_t i = 0; i < mesh.triangles.size() && length > longest; ++i) {
        for (size_t o = 0; o < 3; ++o) {
          const std::array<uint32_t, 3>& other = mesh.triangles[i];
          if (other[o] != t[(e + 1) % 3] || other[(o + 1) % 3] != t[e]) continue;
          longest = length;
          across = i;
          from = t[e];
          to = t[(e + 1) % 3];
          mine = t[(e + 2) % 3];
          theirs = other[(o + 2) % 3];
        }
      }
    }
    if (across == mesh.triangles.size()) continue;
    const Point p = mesh.points[from];
    const Point q = mesh.points[to];
    const Point middle = {(p.x + q.x) / 2 + random.between(-3, 3), (p.y + q.y) / 2 + random.between(-3, 3)};
    const uint32_t n = mesh.add(middle);
    if (!positive(mesh, from, n, mine) || !positive(mesh, n, to, mine) || !positive(mesh, to, n, theirs) ||
        !positive(mesh, n, from, theirs)) {
      continue;
    }
    mesh.triangles[chosen] = {from, n, mine};
    mesh.triangles[across] = {to, n, theirs};
    mesh.triangles.push_back({n, to, mine});
    mesh.triangles.push_back({n, from, theirs});
  }
  return mesh;
}

// A hub that sees a rim round the frame, at steps from a sub-pixel to a quarter of a side. In every second one it is
// near a corner, where its triangles are small.
PlaneMesh fan(Random& random) {
  PlaneMesh mesh;
  const int64_t lattice = random.once_in(2) ? 1 : 128;
  const int64_t part = random.once_in(2) ? 1 : 32;
  const Point hub = {random.between(0, kRight / part / lattice) * lattice,
                     random.between(0, kBottom / part / lattice) * lattice};
  mesh.add(hub);
  const int64_t left = -256, top = -512, right = kRight + 256, bottom = kBottom + 512;
  const int64_t widest = random.once_in(2) ? 3000 : kRight / 4;
  const auto step = [&random, widest] { return random.between(1, random.once_in(3) ? 500 : widest); };
  for (int64_t x = left; x < right; x += step())
    mesh.add({x, top});
  for (int64_t y = top; y < bottom; y += step())
    mesh.add({right, y});
  for (int64_t x = right; x > left; x -= step())
    mesh.add({x, bottom});
  for (int64_t y = bottom; y > top; y -= step())
    mesh.add({left, y});
  const auto count = static_cast<uint32_t>(mesh.points.size());
  for (uint32_t i = 1; i < count; ++i)
    mesh.triangles.push_back({0, i, i + 1 == count ? 1 : i + 1});
  return mesh;
}

// From `begin` beyond `end` in steps from a pixel to `widest` sub-pixels.
std::vector<int64_t> steps(Random& random, int64_t begin, int64_t end, int64_t widest) {
  std::vector<int64_t> at = {begin};
  while (at.back() < end)
    at.push_back(at.back() + (random.once_in(3) ? random.between(256, 2000) : random.between(256, widest)));
  return at;
}

// A grid without T-junctions, cut along either diagonal. Points wander by less than a quarter of the narrowest cell,
// which keeps every cell convex enough for that.
PlaneMesh grid(Random& random) {
  PlaneMesh mesh;
  const std::vector<int64_t> columns = steps(random, -256, kRight + 256, 20000);
  const std::vector<int64_t> rows = steps(random, -256, kBottom + 256, 20000);
  const int64_t jitter = random.once_in(3) ? 0 : 60;
  for (const int64_t y : rows) {
    for (const int64_t x : columns)
      mesh.add(moved({x, y}, random, jitter));
  }
  const auto across = static_cast<uint32_t>(columns.size());
  for (uint32_t row = 0; row + 1 < rows.size(); ++row) {
    for (uint32_t column = 0; column + 1 < across; ++column) {
      const uint32_t a = row * across + column;
      const uint32_t d = a + across;
      if (random.once_in(2)) {
        mesh.triangles.push_back({a, a + 1, d + 1});
        mesh.triangles.push_back({a, d + 1, d});
      } else {
        mesh.triangles.push_back({a, a + 1, d});
        mesh.triangles.push_back({a + 1, d + 1, d});
      }
    }
  }
  return mesh;
}

// Zigzag strips below each other: each border between two of them has its own points, which both use. Then all of it is
// turned, or left with its borders level.
PlaneMesh strips(Random& random) {
  PlaneMesh mesh;
  std::vector<uint32_t> upper;
  for (const int64_t y : steps(random, -20000, kBottom + 20000, 16000)) {
    std::vector<uint32_t> lower;
    for (const int64_t x : steps(random, -20000, kRight + 20000, 16000))
      lower.push_back(mesh.add({x, y}));
    // Any two borders begin and end at the same columns.
    mesh.points[lower.front()].x = -20000;
    mesh.points[lower.back()].x = kRight + 40000;
    size_t u = 0;
    size_t l = 0;
    while (!upper.empty() && (u + 1 < upper.size() || l + 1 < lower.size())) {
      const bool along_upper =
          l + 1 == lower.size() || (u + 1 < upper.size() && mesh.points[upper[u + 1]].x < mesh.points[lower[l + 1]].x);
      if (along_upper) {
        mesh.triangles.push_back({upper[u], upper[u + 1], lower[l]});
        ++u;
      } else {
        mesh.triangles.push_back({upper[u], lower[l + 1], lower[l]});
        ++l;
      }
    }
    upper = lower;
  }
  const int64_t turn = random.once_in(3) ? 0 : random.between(-12, 12);
  for (Point& p : mesh.points)
    p = {p.x - p.y * turn / 64, p.y + p.x * turn / 64};
  return mesh;
}

using MakeMesh = PlaneMesh (*)(Random&);

class SharedEdges : public testing::TestWithParam<std::tuple<Kernel, int>> {
 protected:
  void SetUp() override { kernel_under_test() = std::get<0>(GetParam()); }

  // Draws each triangle alone, in white on black, and counts the samples of each pixel: a level tells how many there
  // are.
  void count_each(const PlaneMesh& mesh, Screen& screen, std::vector<int>& counts) {
    counts.assign(screen.pixels.size(), 0);
    std::vector<int> samples_of(256, -1);
    for (int covered = 0; covered <= samples_; ++covered) {
      // The root mean square, to nearest; 127.5 upwards.
      int level = 0;
      while ((2 * level + 1) * (2 * level + 1) * samples_ <= 4 * covered * 255 * 255)
        ++level;
      samples_of[static_cast<size_t>(level)] = covered;
    }
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
      screen.begin();
      screen.add(mesh.corners(i));
      screen.end();
      for (size_t at = 0; at < counts.size(); ++at) {
        if (screen.pixels[at] == 0U) continue;
        const int covered = samples_of[red_of(screen.pixels[at])];
        ASSERT_GE(covered, 0) << "no number of samples gives this level";
        counts[at] += covered;
      }
    }
  }

  // All together, as one mesh with shared vertices, first to last and last to first: at equal depth the first one drawn
  // stays, so a pixel that two cover changes.
  void draw_together(const PlaneMesh& mesh, Screen& screen, std::vector<uint32_t>& pixels) {
    screen.begin();
    std::vector<glm::vec3> positions;
    std::vector<glm::u8vec4> colours;
    std::vector<uint32_t> indices;
    for (const std::array<uint32_t, 3>& t : mesh.triangles) {
      // A flat colour is the mean of its corners', so each triangle has its own.
      const auto number = static_cast<uint32_t>(positions.size() / 3) % 0xFFFFU + 1U;
      for (const uint32_t corner : t) {
        indices.push_back(static_cast<uint32_t>(positions.size()));
        positions.push_back(screen.place(mesh.points[corner]));
        colours.emplace_back(255, green_of(number), blue_of(number), 255);
      }
    }
    screen.add_mesh(positions, {}, colours, indices, Shading::kFlat);
    screen.end();
    pixels = screen.pixels;
    screen.begin();
    std::vector<uint32_t> reversed;
    for (size_t i = indices.size(); i > 0; i -= 3)
      reversed.insert(reversed.end(), {indices[i - 3], indices[i - 2], indices[i - 1]});
    screen.add_mesh(positions, {}, colours, reversed, Shading::kFlat);
    screen.end();
  }

  void expect_once(const char* name, uint64_t seed, MakeMesh make, size_t least_triangles) {
    Random random(seed);
    Screen screen(kWidth, kHeight, samples_, 2);
    const int meshes = std::max(share_of(samples_ == 1 ? 40 : 10), 6);
    size_t small = 0;
    size_t large = 0;
    std::vector<int> counts;
    std::vector<uint32_t> pixels;
    for (int number = 0; number < meshes; ++number) {
      PlaneMesh mesh = make(random);
      mesh.shuffle(random);
      ASSERT_GE(mesh.triangles.size(), least_triangles);
      for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle t = mesh.corners(i);
        const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
        const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
        (std::max(right - left, bottom - top) < 32 * 256 ? small : large) += 1;
      }
      count_each(mesh, screen, counts);
      for (size_t at = 0; at < counts.size(); ++at) {
        ASSERT_EQ(counts[at], samples_) << name << " " << number << ", pixel " << at % kWidth << ", " << at / kWidth;
      }
      draw_together(mesh, screen, pixels);
      for (size_t at = 0; at < pixels.size(); ++at) {
        ASSERT_EQ(red_of(pixels[at]), 255U)
            << name << " " << number << ", pixel " << at % kWidth << ", " << at / kWidth;
        ASSERT_EQ(pixels[at], screen.pixels[at])
            << name << " " << number << ", pixel " << at % kWidth << ", " << at / kWidth;
      }
    }
    EXPECT_GT(small, 20U) << name;
    EXPECT_GT(large, 20U) << name;
  }

  int samples_ = std::get<1>(GetParam());
};

TEST_P(SharedEdges, RandomTriangulationsDrawEverySampleOnce) {
  expect_once("triangulation", 401, random_triangulation, 100);
}
TEST_P(SharedEdges, RefinedTriangulationsDrawEverySampleOnce) {
  expect_once("refined triangulation", 402, refined_triangulation, 100);
}
TEST_P(SharedEdges, FansDrawEverySampleOnce) {
  expect_once("fan", 403, fan, 16);
}
TEST_P(SharedEdges, StripsDrawEverySampleOnce) {
  expect_once("strips", 404, strips, 30);
}
TEST_P(SharedEdges, GridsDrawEverySampleOnce) {
  expect_once("grid", 405, grid, 50);
}

INSTANTIATE_TEST_SUITE_P(Kernels, SharedEdges,
                         testing::Combine(testing::ValuesIn(kernels_here()), testing::Values(1, 4)),
                         [](const auto& test) {
                           return std::string(name_of(std::get<0>(test.param))) + "_" +
                                  std::to_string(std::get<1>(test.param));
                         });

}  // namespace
}  // namespace auslan::raster
