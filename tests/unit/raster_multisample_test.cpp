// SPDX-License-Identifier: Apache-2.0
// Multisampling: Direct3D's sample positions, exact coverage of each, and the root mean square of their levels.
#include "raster_screen.h"

#include <cmath>
#include <tuple>

namespace auslan::raster {
namespace {

// Direct3D 11 functional specification, 19.2.4: D3D11_STANDARD_MULTISAMPLE_PATTERN, 1/16 pixel from the centre.
const std::vector<Point>& pattern(int samples) {
  static const std::vector<Point> one = {{0, 0}};
  static const std::vector<Point> two = {{4, 4}, {-4, -4}};
  static const std::vector<Point> four = {{-2, -6}, {6, -2}, {-6, 2}, {2, 6}};
  static const std::vector<Point> eight = {{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}};
  return samples == 1 ? one : samples == 2 ? two : samples == 4 ? four : eight;
}

int covered_samples(const Triangle& t, int column, int row, int samples) {
  int count = 0;
  for (const Point& offset : pattern(samples)) {
    const Point c = centre(column, row);
    count += covers(t, Point{c.x + offset.x * 16, c.y + offset.y * 16}) ? 1 : 0;
  }
  return count;
}

// The root mean square of `covered` samples of one level and the rest of another, rounded to nearest, a half upwards:
// the greatest whole code with (code - 1/2)^2 <= mean of the squares. In whole numbers, so without any rounding.
uint32_t code_of(int covered, int samples, uint32_t level = 255, uint32_t rest = 0) {
  const auto inside = static_cast<uint32_t>(covered);
  const auto all = static_cast<uint32_t>(samples);
  const uint32_t squares = inside * level * level + (all - inside) * rest * rest;
  // From a little below, so that the square root's rounding does not matter.
  auto code = static_cast<uint32_t>(std::sqrt(static_cast<double>(squares) / samples));
  code -= code > 0 ? 1 : 0;
  while ((2 * code + 1) * (2 * code + 1) * all <= 4 * squares)
    ++code;
  return code;
}

class Multisample : public testing::TestWithParam<std::tuple<Kernel, int>> {
 protected:
  void SetUp() override { kernel_under_test() = std::get<0>(GetParam()); }
  static int sample_count() { return std::get<1>(GetParam()); }
};

TEST(RootMeanSquare, OfTheReferenceIsWhatTheFormulaSays) {
  EXPECT_EQ(code_of(8, 8), 255U);
  EXPECT_EQ(code_of(0, 8), 0U);
  EXPECT_EQ(code_of(1, 2), 180U);            // 255 / sqrt(2) = 180.3
  EXPECT_EQ(code_of(1, 4), 128U);            // 127.5
  EXPECT_EQ(code_of(1, 8), 90U);             // 90.2
  EXPECT_EQ(code_of(1, 2, 100, 200), 158U);  // sqrt(25000) = 158.1
}

TEST_P(Multisample, EveryPixelIsTheRootMeanSquareOfItsExactSamples) {
  const int samples = sample_count();
  Random random(30);
  Screen screen(16, 16, samples);
  int64_t partial = 0;
  for (int i = 0; i < cases(8000); ++i) {
    Triangle t;
    const int64_t grid = i % 2 == 0 ? 1 : 16;  // every second triangle has corners on sample positions
    for (Point& p : t) {
      p.x = random.between(-600 / grid, 4700 / grid) * grid;
      p.y = random.between(-600 / grid, 4700 / grid) * grid;
    }
    if (i % 5 == 0) t[2] = Point{t[1].x + random.between(-20, 20), t[1].y + random.between(-20, 20)};
    // Every third is white on black, where all is seen of a wrong sample; the others have any colours.
    const bool plain = i % 3 == 0;
    const uint32_t behind = plain ? 0U : static_cast<uint32_t>(random.next() & 0xFFFFFFU);
    const uint32_t front = plain ? 0xFFFFFFU : static_cast<uint32_t>(random.next() & 0xFFFFFFU);
    screen.begin(behind);
    screen.add(t, glm::u8vec4(red_of(front), green_of(front), blue_of(front), 255));
    screen.end();
    for (int row = 0; row < 16; ++row) {
      for (int column = 0; column < 16; ++column) {
        const int covered = covered_samples(t, column, row, samples);
        partial += covered > 0 && covered < samples ? 1 : 0;
        ASSERT_EQ(screen.pixel(column, row), pack_pixel(code_of(covered, samples, red_of(front), red_of(behind)),
                                                        code_of(covered, samples, green_of(front), green_of(behind)),
                                                        code_of(covered, samples, blue_of(front), blue_of(behind))))
            << covered << " of " << samples << " samples, triangle " << i << ", pixel " << column << ", " << row;
      }
    }
  }
  EXPECT_TRUE(samples == 1 || partial > cases(8000)) << partial << " pixels at an edge";
}

TEST_P(Multisample, TrianglesWithACommonEdgeShareTheSamplesOfEveryPixel) {
  const int samples = sample_count();
  Random random(31);
  Screen screen(16, 16, samples);
  for (int mesh = 0; mesh < cases(300); ++mesh) {
    const Point hub = {random.between(0, 256) * 16, random.between(0, 256) * 16};
    const Point rim[4] = {{-900, -900}, {-900, 5200}, {5200, 5200}, {5200, -900}};
    std::vector<int> sum(256, 0);
    for (size_t i = 0; i < 4; ++i) {
      screen.begin();
      screen.add(Triangle{hub, rim[i], rim[(i + 1) % 4]});
      screen.end();
      for (size_t p = 0; p < 256; ++p) {
        int covered = 0;
        while (covered < samples && code_of(covered, samples) != red_of(screen.pixels[p]))
          ++covered;
        ASSERT_EQ(code_of(covered, samples), red_of(screen.pixels[p]));
        sum[p] += covered;
      }
    }
    for (const int total : sum)
      ASSERT_EQ(total, samples);
  }
}

// A background that shows through keeps its own value: averaging equal samples changes nothing, for every grey.
TEST_P(Multisample, EqualSamplesGiveTheirColourBack) {
  Screen screen(16, 16, sample_count());
  for (uint32_t code = 0; code < 256; ++code) {
    const auto byte = static_cast<uint8_t>(code);
    screen.begin(0xFF00FFU);
    screen.add(Triangle{Point{-99, -99}, Point{-99, 99999}, Point{99999, -99}},
               glm::u8vec4(byte, static_cast<uint8_t>(255 - byte), byte, 255));
    screen.end();
    for (const uint32_t pixel : screen.pixels)
      ASSERT_EQ(pixel, pack_pixel(code, 255 - code, code));
  }
}

// Depth belongs to the sample: two walls that meet inside a pixel share it, whichever is drawn first.
TEST_P(Multisample, DepthIsPerSample) {
  const int samples = sample_count();
  const Triangle whole = {Point{-99, -99}, Point{-99, 99999}, Point{99999, -99}};
  Random random(33);
  for (int i = 0; i < cases(500); ++i) {
    const Triangle t = {Point{random.between(0, 2048), random.between(0, 2048)},
                        Point{random.between(0, 2048), random.between(0, 2048)},
                        Point{random.between(0, 2048), random.between(0, 2048)}};
    Screen near_last(8, 8, samples);
    near_last.add(whole, glm::u8vec4(0, 0, 0, 255), 0.25F);
    near_last.add(t, glm::u8vec4(255), 0.75F);
    near_last.end();
    Screen near_first(8, 8, samples);
    near_first.add(t, glm::u8vec4(255), 0.75F);
    near_first.add(whole, glm::u8vec4(0, 0, 0, 255), 0.25F);
    near_first.end();
    ASSERT_EQ(near_last.pixels, near_first.pixels);
    for (int row = 0; row < 8; ++row) {
      for (int column = 0; column < 8; ++column) {
        ASSERT_EQ(red_of(near_last.pixel(column, row)), code_of(covered_samples(t, column, row, samples), samples));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, Multisample,
                         testing::Combine(testing::ValuesIn(kernels_here()), testing::Values(1, 2, 4, 8)),
                         [](const auto& test) {
                           return std::string(name_of(std::get<0>(test.param))) + "_" +
                                  std::to_string(std::get<1>(test.param));
                         });

}  // namespace
}  // namespace auslan::raster
