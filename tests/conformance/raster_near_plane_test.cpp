// SPDX-License-Identifier: Apache-2.0
// Triangles that cross the near plane: the polygon that is left, in rational arithmetic, snapped to the grid of 1/256
// pixel; not one pixel differs. Left out are polygons of which the grid does not say enough: a corner that lies so near
// to the middle between two grid points that the rounding of a float decides, and one that snapping makes concave.
#include "raster_conformance.h"

#include <cmath>
#include <optional>

namespace auslan::raster {
namespace {

constexpr int kSize = 32;
constexpr int64_t kHalf = kSize * 128;  // sub-pixels
constexpr int64_t kSideways = 65536;    // units of x and y in a metre
constexpr int64_t kAlong = 64;          // units of the distance in a metre
constexpr int64_t kNear = kAlong / 2;   // the near plane

struct Corner {
  int64_t x, y;      ///< 1/kSideways metre, y up
  int64_t distance;  ///< 1/kAlong metre before the eye, negative behind it
};
using Solid = std::array<Corner, 3>;

// numerator / denominator, above 0.
struct Ratio {
  Wide numerator, denominator;
};

// The nearest whole number, of two the even one. Nothing when floats may round it otherwise.
std::optional<int64_t> snapped(const Ratio& r, bool exact) {
  Wide whole = r.numerator / r.denominator;
  if (whole * r.denominator > r.numerator) --whole;
  const Wide rest2 = 2 * (r.numerator - whole * r.denominator);  // twice the part beyond, of the denominator
  if (!exact) {
    const double from_tie = std::abs(static_cast<double>(rest2) / static_cast<double>(r.denominator) - 1.0) / 2.0;
    const double value = static_cast<double>(r.numerator) / static_cast<double>(r.denominator);
    // A few roundings to 24 bits on the way from metres to sub-pixels.
    if (from_tie < std::ldexp(std::abs(value), -21) + 1e-6) return std::nullopt;
  }
  const bool up = rest2 > r.denominator || (rest2 == r.denominator && whole % 2 != 0);
  return static_cast<int64_t>(whole + (up ? 1 : 0));
}

// Where (x, y) / denominator metres at a distance of `distance` units falls.
std::optional<Point> projected(Wide x, Wide y, Wide denominator, Wide distance, bool exact) {
  const Wide scale = Wide{kHalf} * kAlong;
  const Wide below = denominator * distance * kSideways;
  const std::optional<int64_t> column = snapped({x * scale, below}, exact);
  const std::optional<int64_t> row = snapped({-y * scale, below}, exact);
  if (!column || !row) return std::nullopt;
  return Point{kHalf + *column, kHalf + *row};
}

// The corners of what lies beyond the near plane, on the grid.
std::optional<std::vector<Point>> visible_polygon(const Solid& solid, bool exact) {
  std::vector<Point> polygon;
  for (size_t i = 0; i < 3; ++i) {
    const Corner& from = solid[i];
    const Corner& to = solid[(i + 1) % 3];
    if (from.distance >= kNear) {
      const std::optional<Point> corner = projected(from.x, from.y, 1, from.distance, exact);
      if (!corner) return std::nullopt;
      polygon.push_back(*corner);
    }
    if ((from.distance >= kNear) == (to.distance >= kNear)) continue;
    // x = (from.x * (whole - part) + to.x * part) / whole
    Wide whole = from.distance - to.distance;
    Wide part = from.distance - kNear;
    if (whole < 0) {
      whole = -whole;
      part = -part;
    }
    const Wide x = from.x * (whole - part) + to.x * part;
    const Wide y = from.y * (whole - part) + to.y * part;
    const std::optional<Point> corner = projected(x, y, whole, kNear, exact);
    if (!corner) return std::nullopt;
    polygon.push_back(*corner);
  }
  return polygon;
}

// Turns one way only, or not at all. (With at most four corners that is enough.)
bool convex(const std::vector<Point>& polygon) {
  bool left = false;
  bool right = false;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Wide turn = doubled_area(polygon[i], polygon[(i + 1) % polygon.size()], polygon[(i + 2) % polygon.size()]);
    left = left || turn < 0;
    right = right || turn > 0;
  }
  return !(left && right);
}

bool covered_by(const std::vector<Point>& polygon, const Point& p) {
  for (size_t i = 2; i < polygon.size(); ++i) {
    if (covers(Triangle{polygon[0], polygon[i - 1], polygon[i]}, p)) return true;
  }
  return false;
}

class NearPlane : public OnEveryKernel {
 protected:
  struct Tally {
    int compared = 0, cut = 0, left_out = 0;
    int64_t covered = 0;
  };

  template <typename Make>
  Tally compare(int count, uint64_t seed, bool exact, Make make) {
    Random random(seed);
    Screen screen(kSize, kSize);
    const float near_plane = static_cast<float>(kNear) / static_cast<float>(kAlong);
    const Camera camera =
        look_at(glm::vec3(0.0F), glm::vec3(0.0F, 0.0F, -1.0F), glm::vec3(0.0F, 1.0F, 0.0F), 1.0F, 1.0F, near_plane);
    Tally tally;
    while (tally.compared < count) {
      const Solid solid = make(random);
      const std::optional<std::vector<Point>> polygon = visible_polygon(solid, exact);
      if (!polygon || !convex(*polygon)) {
        ++tally.left_out;
        continue;
      }
      std::array<glm::vec3, 3> positions;
      for (size_t i = 0; i < 3; ++i) {
        positions[i] = glm::vec3(static_cast<float>(solid[i].x) / static_cast<float>(kSideways),
                                 static_cast<float>(solid[i].y) / static_cast<float>(kSideways),
                                 -static_cast<float>(solid[i].distance) / static_cast<float>(kAlong));
      }
      screen.begin();
      screen.renderer.set_camera(camera);
      screen.add_single(positions, glm::u8vec4(255), CullMode::kNone);
      screen.end();
      ++tally.compared;
      tally.cut += screen.renderer.stats().clipped != 0U ? 1 : 0;
      int wrong = 0;
      for (int row = 0; row < kSize; ++row) {
        for (int column = 0; column < kSize; ++column) {
          const bool expected = covered_by(*polygon, centre(column, row));
          tally.covered += expected ? 1 : 0;
          if (screen.pixel(column, row) == (expected ? 0xFFFFFFU : 0U) || ++wrong > 1) continue;
          ADD_FAILURE() << "triangle " << tally.compared << ", pixel " << column << ", " << row
                        << (expected ? " is missing" : " is too many");
          for (const Corner& c : solid)
            ADD_FAILURE() << "  corner " << c.x << ", " << c.y << " at " << c.distance;
        }
      }
      if (HasFailure()) break;
    }
    return tally;
  }
};
ON_EVERY_KERNEL(NearPlane);

TEST_P(NearPlane, CutTrianglesAreTheExactPolygons) {
  const int count = share_of(kTriangleCounts.near_plane) / 2;
  const Tally tally = compare(count, 301, false, [](Random& random) {
    Solid solid;
    const int64_t reach = kSideways * random.between(1, 5);
    for (Corner& c : solid) {
      c.x = random.between(-reach, reach);
      c.y = random.between(-reach, reach);
      c.distance = random.between(-2 * kAlong, 4 * kAlong);
    }
    return solid;
  });
  EXPECT_GT(tally.cut, count / 3);
  EXPECT_LT(tally.left_out, count / 2);
  EXPECT_GT(tally.covered, count * int64_t{20});
}

// Distances such that nothing is rounded on the way to the grid: corners in the middle between two grid points count
// too, and go to the even one.
TEST_P(NearPlane, CornersBetweenTwoGridPointsGoToTheEvenOne) {
  const int count = share_of(kTriangleCounts.near_plane) / 2;
  const Tally tally = compare(count, 302, true, [](Random& random) {
    Solid solid;
    for (Corner& c : solid) {
      c.x = random.between(-10000, 10000) * 8;  // 1/8192 m: 1/2 sub-pixel at 1 m, 1/4 at 2 m, 1 at the near plane
      c.y = random.between(-10000, 10000) * 8;
      // The cut lies at 1/2, 3/4 or 7/8 of an edge that ends beside the eye.
      c.distance = random.once_in(3) ? 0 : kAlong << random.between(0, 2);
    }
    return solid;
  });
  EXPECT_GT(tally.cut, count / 3);
  EXPECT_GT(tally.covered, count * int64_t{20});
}

}  // namespace
}  // namespace auslan::raster
