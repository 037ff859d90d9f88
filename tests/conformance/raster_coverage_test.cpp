// SPDX-License-Identifier: Apache-2.0
// Two million random triangles of every kind: not one pixel differs from exact arithmetic.
#include "raster_conformance.h"

namespace auslan::raster {
namespace {

class Coverage : public OnEveryKernel {};
ON_EVERY_KERNEL(Coverage);

constexpr int kCell = 16;
constexpr int kAcross = 48;  // 768 pixels: tile borders and cell borders fall together at times only

TEST_P(Coverage, RandomTriangles) {
  expect_exact_in_cells(kCell, kAcross, kAcross, share_of(kTriangleCounts.random), 101, random_triangle);
}

TEST_P(Coverage, TrianglesOnTheHalfPixelLattice) {
  expect_exact_in_cells(kCell, kAcross, kAcross, share_of(kTriangleCounts.lattice), 102, lattice_triangle);
}

TEST_P(Coverage, SubPixelTriangles) {
  expect_exact_in_cells(8, 2 * kAcross, kAcross, share_of(kTriangleCounts.sub_pixel), 103, sub_pixel_triangle);
}

TEST_P(Coverage, Slivers) {
  expect_exact_in_cells(kCell, kAcross, kAcross, share_of(kTriangleCounts.slivers), 104, sliver_triangle);
}

TEST_P(Coverage, TrianglesWithoutAreaDrawNothing) {
  Random random(105);
  Screen screen(64, 64);
  constexpr int kPerFrame = 100;
  const int count = share_of(kTriangleCounts.zero_area);
  for (int done = 0; done < count; done += kPerFrame) {
    screen.begin(0x123456U);
    for (int i = 0; i < kPerFrame; ++i) {
      const int64_t reach = i % 2 == 0 ? 0 : 100000;
      const Triangle t = flat_triangle(random, -reach, 64 * 256 + reach);
      ASSERT_TRUE(doubled_area(t[0], t[1], t[2]) == 0) << text(t);
      screen.add(t);
    }
    screen.end();
    ASSERT_EQ(screen.renderer.stats().culled, static_cast<uint64_t>(kPerFrame));
    for (const uint32_t pixel : screen.pixels)
      ASSERT_EQ(pixel, 0x123456U) << "among the triangles from " << done << " on";
  }
}

TEST_P(Coverage, TrianglesThatReachBeyondTheFrame) {
  expect_exact_in_frame(32, 16, share_of(kTriangleCounts.beyond_the_frame), 106,
                        [](Random& random) { return random_triangle(random, -3000, 32 * 256 + 3000); });
}

TEST_P(Coverage, NeedlesThatReachFarOutside) {
  expect_exact_in_frame(32, 16, share_of(kTriangleCounts.needles), 107, [](Random& random) {
    const Point inside = point_in(random, 0, 16 * 256);
    // Up to the guard band, which lies 2^22 sub-pixels from the middle; both ends outside in every second one.
    const Point far = point_in(random, -4000000, 4000000);
    const Point from = random.once_in(2) ? inside : Point{2 * inside.x - far.x / 2, 2 * inside.y - far.y / 2};
    return Triangle{from, far, moved(far, random, random.once_in(2) ? 400 : 100000)};
  });
}

TEST_P(Coverage, ScreenCoveringTriangles) {
  expect_exact_in_frame(32, 16, share_of(kTriangleCounts.screen_covering), 108,
                        [](Random& random) { return random_triangle(random, -4000000, 4000000); });
}

TEST_P(Coverage, TrianglesOutsideTheFrameDrawNothing) {
  Random random(109);
  Screen screen(32, 16);
  constexpr int kPerFrame = 100;
  const int count = share_of(kTriangleCounts.off_screen);
  for (int done = 0; done < count; done += kPerFrame) {
    screen.begin(0x123456U);
    for (int i = 0; i < kPerFrame;) {
      // Many have boxes that overlap the frame's.
      const int64_t reach = i % 2 == 0 ? 3000 : 4000000;
      const Triangle t = random_triangle(random, -reach, 16 * 256 + reach);
      bool outside = true;
      for (int pixel = 0; pixel < 32 * 16 && outside; ++pixel)
        outside = !covers(t, centre(pixel % 32, pixel / 32));
      if (!outside) continue;
      screen.add(t);
      ++i;
    }
    screen.end();
    for (const uint32_t pixel : screen.pixels)
      ASSERT_EQ(pixel, 0x123456U) << "among the triangles from " << done << " on";
  }
}

// Triangles below 32 pixels in width and height take another path than larger ones.
TEST_P(Coverage, TrianglesAboutThirtyTwoPixelsLarge) {
  expect_exact_in_cells(
      80, 9, 9, share_of(kTriangleCounts.boundary_sizes), 110, [](Random& random, int64_t low, int64_t high) {
        const int64_t width = 32 * 256 + random.between(-3, 3);
        const int64_t height = random.once_in(2) ? 32 * 256 + random.between(-3, 3) : random.between(1, 40 * 256);
        const Point corner = point_in(random, low, high - 41 * 256);
        const Point end = {corner.x + width, corner.y + height};
        const Point between = {random.between(corner.x, end.x), random.between(corner.y, end.y)};
        Triangle t = {corner, end, between};
        if (random.once_in(2)) t = {Point{corner.x, end.y}, Point{end.x, corner.y}, between};
        if (random.once_in(2)) {
          for (Point& p : t)
            p = {p.y - corner.y + corner.x, p.x - corner.x + corner.y};
        }
        return t;
      });
}

TEST_P(Coverage, LargestFrames) {
  const int count = share_of(kTriangleCounts.largest_frames);
  expect_exact_in_cells(kCell, kMaxImageSize / kCell, 2, count / 4, 111, random_triangle);
  expect_exact_in_cells(kCell, 2, kMaxImageSize / kCell, count / 4, 112, lattice_triangle);
  expect_exact_in_cells(kCell, 200, 200, count / 2, 113, sliver_triangle);
}

// The widest and tallest frames, where a 32-bit edge function or a float would overflow or round. Corners stay within
// the guard band: 2^22 sub-pixels from the middle, where both sizes are powers of two.
TEST_P(Coverage, TrianglesThatReachFarInLargestFrames) {
  const auto make = [](int64_t width, int64_t height) {
    return [width, height](Random& random) {
      const int64_t reach_x = width == kMaxImageSize ? 2090000 : 4000000;
      const int64_t reach_y = height == kMaxImageSize ? 2090000 : 4000000;
      Triangle t;
      for (Point& p : t) {
        p.x = random.between(-reach_x, width * 256 + reach_x);
        p.y = random.between(-reach_y, height * 256 + reach_y);
      }
      if (random.once_in(2)) t[1] = moved(t[0], random, 999);
      return t;
    };
  };
  const int count = share_of(kTriangleCounts.far_in_largest_frames);
  expect_exact_in_frame(kMaxImageSize, 4, count / 2, 114, make(kMaxImageSize, 4));
  expect_exact_in_frame(4, kMaxImageSize, count / 2, 115, make(4, kMaxImageSize));
}

}  // namespace
}  // namespace auslan::raster
