// SPDX-License-Identifier: Apache-2.0
// Triangles that cross the near plane, the far plane and the guard band, against exact half-spaces.
#include "clip.h"
#include "placement.h"
#include "raster_screen.h"

#include <algorithm>
#include <cmath>

namespace auslan::raster {
namespace {

class Clip : public OnEveryKernel {};
ON_EVERY_KERNEL(Clip);

constexpr int kSize = 32;
constexpr double kNear = 0.5;
// Vertices are whole multiples of this, so that the reference is exact.
constexpr double kUnit = 1.0 / 64.0;

struct Corner {
  int64_t x, y, z;  ///< 1/64 metre, camera at the origin looking along -z
};
using Solid = std::array<Corner, 3>;

int64_t determinant(const Corner& a, const Corner& b, const Corner& c) {
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
}

enum class Answer { kOutside, kInside, kTooClose };

// Does the ray through a pixel centre meet the triangle beyond the near plane? The ray is (x, y, -1) times the
// distance; a triangle is the intersection of three half-spaces through the eye, and the near plane cuts the ray at a
// distance. kTooClose: within 1/64 pixel of a border, where snapping to the grid of 1/256 pixel may decide.
Answer exact_answer(const Solid& t, int column, int row) {
  const Corner ray = {2 * column + 1 - kSize, kSize - 2 * row - 1, -kSize};
  int64_t total = determinant(t[0], t[1], t[2]);
  if (total == 0) return Answer::kOutside;
  const int64_t sign = total > 0 ? 1 : -1;
  total *= sign;
  // side[i] is linear in the ray: a pixel to the right adds 2 to ray.x.
  int64_t side[3];
  double slack = 1e300;  // pixels to the nearest border
  int64_t sum = 0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  bool inside = true;
  for (size_t i = 0; i < 3; ++i) {
    const Corner& b = t[(i + 1) % 3];
    const Corner& c = t[(i + 2) % 3];
    side[i] = sign * determinant(ray, b, c);
    const double per_x = 2.0 * static_cast<double>(sign * (b.y * c.z - b.z * c.y));
    const double per_y = 2.0 * static_cast<double>(sign * (b.z * c.x - b.x * c.z));
    const double length = std::sqrt(per_x * per_x + per_y * per_y);
    if (length > 0.0) slack = std::min(slack, std::abs(static_cast<double>(side[i])) / length);
    inside = inside && side[i] > 0;
    sum += side[i];
    sum_x += per_x;
    sum_y += per_y;
  }
  // The ray meets the plane at `total / sum` times its own length, and ray.z is kSize long: distance in 1/64 m is
  // kSize * total / sum, to be at least 32.
  const int64_t near_units = std::lround(kNear / kUnit);
  const int64_t beyond = kSize * total - near_units * sum;
  const double slope = static_cast<double>(near_units) * std::sqrt(sum_x * sum_x + sum_y * sum_y);
  if (slope > 0.0) slack = std::min(slack, std::abs(static_cast<double>(beyond)) / slope);
  if (slack < 1.0 / 64.0) return Answer::kTooClose;
  return inside && sum > 0 && beyond > 0 ? Answer::kInside : Answer::kOutside;
}

Camera eye_at_origin() {
  return look_at(glm::vec3(0.0F), glm::vec3(0.0F, 0.0F, -1.0F), glm::vec3(0.0F, 1.0F, 0.0F), 1.0F, 1.0F,
                 static_cast<float>(kNear));
}

void draw_solid(Screen& screen, const Solid& t, CullMode cull = CullMode::kNone) {
  std::array<glm::vec3, 3> positions;
  for (size_t i = 0; i < 3; ++i) {
    positions[i] = glm::vec3(static_cast<float>(static_cast<double>(t[i].x) * kUnit),
                             static_cast<float>(static_cast<double>(t[i].y) * kUnit),
                             static_cast<float>(static_cast<double>(t[i].z) * kUnit));
  }
  screen.add_single(positions, glm::u8vec4(255), cull);
}

void compare(int count, uint64_t seed, int64_t sideways, int64_t behind, int64_t ahead) {
  Random random(seed);
  Screen screen(kSize, kSize);
  int64_t inside = 0;
  int64_t outside = 0;
  int64_t unsure = 0;
  uint64_t cut = 0;
  for (int i = 0; i < count; ++i) {
    Solid t;
    for (Corner& c : t) {
      c.x = random.between(-sideways, sideways);
      c.y = random.between(-sideways, sideways);
      c.z = random.between(-ahead, behind);
    }
    screen.begin();
    screen.renderer.set_camera(eye_at_origin());
    draw_solid(screen, t);
    screen.end();
    cut += screen.renderer.stats().clipped;
    EXPECT_EQ(screen.renderer.stats().rejected, 0U);
    for (int row = 0; row < kSize; ++row) {
      for (int column = 0; column < kSize; ++column) {
        const Answer answer = exact_answer(t, column, row);
        inside += answer == Answer::kInside ? 1 : 0;
        outside += answer == Answer::kOutside ? 1 : 0;
        unsure += answer == Answer::kTooClose ? 1 : 0;
        if (answer == Answer::kTooClose) continue;
        ASSERT_EQ(screen.pixel(column, row) != 0U, answer == Answer::kInside)
            << "triangle " << i << ", pixel " << column << ", " << row;
      }
    }
  }
  EXPECT_GT(cut, static_cast<uint64_t>(count / 4)) << "the triangles should cross the planes";
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
  EXPECT_LT(unsure * 20, inside + outside) << "the reference should be sure of nearly all pixels";
}

TEST_P(Clip, NearPlaneAgainstExactHalfSpaces) {
  compare(8000, 40, 200, 100, 300);
}

// Corners far to the side and just in front of the near plane project far outside the guard band of a small frame.
TEST_P(Clip, GuardBandAgainstExactHalfSpaces) {
  compare(4000, 41, 400000, 30000, 60000);
}

TEST_P(Clip, FrontsStayFrontsWhenCut) {
  Random random(42);
  Screen screen(kSize, kSize);
  int visible = 0;
  for (int i = 0; i < 3000; ++i) {
    Solid t;
    for (Corner& c : t) {
      c.x = random.between(-200, 200);
      c.y = random.between(-200, 200);
      c.z = random.between(-300, 100);
    }
    // Counter-clockwise seen from the eye: the eye is on the side that the face normal points to.
    const bool front = determinant(t[0], t[1], t[2]) < 0;
    screen.begin();
    screen.renderer.set_camera(eye_at_origin());
    draw_solid(screen, t, CullMode::kBack);
    screen.end();
    const bool any = std::any_of(screen.pixels.begin(), screen.pixels.end(), [](uint32_t p) { return p != 0U; });
    visible += any ? 1 : 0;
    ASSERT_TRUE(front || !any) << i;
  }
  EXPECT_GT(visible, 300);
}

// A jittered floor that runs from behind the eye to the horizon: cut triangles share their edges without a gap or
// overlap.
TEST_P(Clip, CutTrianglesWithACommonEdgeDrawEveryPixelOnce) {
  for (uint64_t seed = 0; seed < 4; ++seed) {
    Random random(50 + seed);
    Screen screen(kSize, kSize);
    constexpr int64_t kColumns = 100;
    constexpr int64_t kRows = 12;
    // It rises towards the horizon and fills the middle of the frame.
    std::vector<Corner> points;
    for (int64_t row = 0; row <= kRows; ++row) {
      for (int64_t column = 0; column <= kColumns; ++column) {
        const int64_t x = (column - kColumns / 2) * 24 + random.between(-7, 7);
        const int64_t z = 300 - row * 100 + random.between(-30, 30);
        points.push_back({x, -20 - z / 4, z});
      }
    }
    std::vector<int> counts(screen.pixels.size(), 0);
    uint64_t cut = 0;
    const auto add = [&](size_t a, size_t b, size_t c) {
      const Solid t = {points[a], points[b], points[c]};
      screen.begin();
      screen.renderer.set_camera(eye_at_origin());
      draw_solid(screen, t);
      screen.end();
      cut += screen.renderer.stats().clipped;
      for (size_t i = 0; i < counts.size(); ++i)
        counts[i] += screen.pixels[i] != 0U ? 1 : 0;
    };
    for (int64_t row = 0; row < kRows; ++row) {
      for (int64_t column = 0; column < kColumns; ++column) {
        const auto a = static_cast<size_t>(row * (kColumns + 1) + column);
        const size_t d = a + static_cast<size_t>(kColumns) + 1;
        add(a, a + 1, d + 1);
        add(a, d + 1, d);
      }
    }
    EXPECT_GT(cut, 15U);
    // The floor is a height field under the eye, so a column of pixels sees it once: one run, without holes.
    for (int column = 0; column < kSize; ++column) {
      int runs = 0;
      for (int row = 0; row < kSize; ++row) {
        const int here = counts[static_cast<size_t>(row * kSize + column)];
        const int above = row == 0 ? 0 : counts[static_cast<size_t>((row - 1) * kSize + column)];
        ASSERT_LE(here, 1) << "seed " << seed << " pixel " << column << ", " << row;
        runs += here == 1 && above == 0 ? 1 : 0;
      }
      ASSERT_EQ(runs, 1) << "seed " << seed << " column " << column;
    }
  }
}

// Two triangles name their common edge in opposite directions; the corner at which it is cut has the same bits in both.
TEST(ClipBits, ACommonEdgeIsCutAtTheSameBitsInBothTriangles) {
  Random random(45);
  const Viewport viewport = make_viewport(64, 64);
  for (int i = 0; i < 5000; ++i) {
    ClipVertex v[4];
    for (ClipVertex& c : v) {
      c.x = static_cast<double>(random.real(-1.0F, 1.0F));
      c.y = static_cast<double>(random.real(-1.0F, 1.0F));
      c.z = 0.1;
      c.w = static_cast<double>(random.real(0.2F, 2.0F));
      for (double& level : c.level)
        level = static_cast<double>(random.real(0.0F, 255.0F));
    }
    v[1].w = static_cast<double>(random.real(-1.0F, 0.05F));  // v[1] lies before the near plane, the others beyond it
    ClipPolygon one;
    ClipPolygon other;
    one.count = other.count = 3;
    one.corner[0] = v[0];
    one.corner[1] = v[1];
    one.corner[2] = v[2];
    other.corner[0] = v[1];
    other.corner[1] = v[0];
    other.corner[2] = v[3];
    clip(one, viewport);
    clip(other, viewport);
    ASSERT_EQ(one.count, 4);
    ASSERT_EQ(other.count, 4);
    int shared = 0;
    for (size_t a = 0; a < 4; ++a) {
      for (size_t b = 0; b < 4; ++b) {
        const ClipVertex& p = one.corner[a];
        const ClipVertex& q = other.corner[b];
        const bool same = p.x == q.x && p.y == q.y && p.z == q.z && p.w == q.w && p.level[0] == q.level[0] &&
                          p.level[1] == q.level[1] && p.level[2] == q.level[2];
        shared += same ? 1 : 0;
      }
    }
    ASSERT_EQ(shared, 2) << "the end beyond the plane, and the cut: case " << i;
  }
}

TEST_P(Clip, FarPlaneOfAParallelCameraCutsExactly) {
  // A wall slanted in x from distance 0 to 4 m; far plane at 3 m, near plane at 1 m: only the middle half is seen.
  Screen screen(64, 64);
  screen.renderer.set_camera(look_at_parallel(glm::vec3(0.0F), glm::vec3(0.0F, 0.0F, -1.0F),
                                              glm::vec3(0.0F, 1.0F, 0.0F), 2.0F, 1.0F, 1.0F, 3.0F));
  const glm::vec3 positions[4] = {glm::vec3(-2, -3, 0), glm::vec3(2, -3, -4), glm::vec3(2, 3, -4), glm::vec3(-2, 3, 0)};
  const glm::u8vec4 colours[4] = {glm::u8vec4(255), glm::u8vec4(255), glm::u8vec4(255), glm::u8vec4(255)};
  const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
  screen.renderer.draw(MeshView{positions, {}, colours, indices}, glm::mat4(1.0F), Shading::kFlat);
  screen.end();
  EXPECT_EQ(screen.renderer.stats().clipped, 2U);
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 64; ++column) {
      ASSERT_EQ(screen.pixel(column, row) != 0U, column >= 16 && column < 48) << column << ", " << row;
    }
  }
}

TEST_P(Clip, StatsAddUp) {
  Random random(60);
  Screen screen(kSize, kSize);
  screen.renderer.set_camera(eye_at_origin());
  for (int i = 0; i < 1000; ++i) {
    Solid t;
    for (Corner& c : t)
      c = {random.between(-300, 300), random.between(-300, 300), random.between(-300, 100)};
    draw_solid(screen, t, CullMode::kBack);
  }
  screen.end();
  const DrawStats& stats = screen.renderer.stats();
  EXPECT_EQ(stats.submitted, 1000U);
  EXPECT_EQ(stats.submitted, stats.rejected + stats.culled + stats.drawn);
  EXPECT_LE(stats.clipped, stats.culled + stats.drawn);
  EXPECT_GT(stats.clipped, 0U);
  EXPECT_GT(stats.drawn, 0U);
  EXPECT_GT(stats.culled, 0U);
}

}  // namespace
}  // namespace auslan::raster
