// SPDX-License-Identifier: Apache-2.0
#include "media/yuv.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace auslan {
namespace {

struct Luma {
  double red, blue;
};
constexpr Luma kBt601{0.299, 0.114};
constexpr Luma kBt709{0.2126, 0.0722};

/// The recommendations' own formula, in real numbers.
std::array<double, 3> recommended(const Luma& k, double r, double g, double b) {
  const double y = k.red * r + (1 - k.red - k.blue) * g + k.blue * b;
  return {16 + 219 * y / 255, 128 + 224 * (b - y) / (2 * (1 - k.blue)) / 255,
          128 + 224 * (r - y) / (2 * (1 - k.red)) / 255};
}

TEST(Yuv, EveryColourIsTheRecommendationsToTheNearestStep) {
  for (const auto matrix : {YuvMatrix::kBt601, YuvMatrix::kBt709}) {
    const Luma& k = matrix == YuvMatrix::kBt601 ? kBt601 : kBt709;
    std::vector<uint32_t> pixels;
    for (uint32_t r = 0; r < 256; r += 5)
      for (uint32_t g = 0; g < 256; g += 5)
        for (uint32_t b = 0; b < 256; b += 5)
          pixels.push_back(r << 16 | g << 8 | b);
    std::vector<uint8_t> planes;
    to_yuv444({pixels, static_cast<int>(pixels.size()), 1}, matrix, planes);
    double worst = 0;
    for (size_t i = 0; i < pixels.size(); ++i) {
      const auto real = recommended(k, pixels[i] >> 16, pixels[i] >> 8 & 255, pixels[i] & 255);
      for (size_t plane = 0; plane < 3; ++plane)
        worst = std::max(worst, std::abs(planes[plane * pixels.size() + i] - real[plane]));
    }
    // Half a step, and what 16 bits of coefficient may add.
    EXPECT_LT(worst, 0.51);
  }
}

TEST(Yuv, GreysHaveNoColourAndWhiteIs235) {
  std::vector<uint32_t> pixels;
  for (uint32_t v = 0; v < 256; ++v)
    pixels.push_back(v << 16 | v << 8 | v);
  for (const auto matrix : {YuvMatrix::kBt601, YuvMatrix::kBt709}) {
    std::vector<uint8_t> planes;
    to_yuv444({pixels, 256, 1}, matrix, planes);
    EXPECT_EQ(planes[0], 16);
    EXPECT_EQ(planes[255], 235);
    for (size_t i = 256; i < planes.size(); ++i)
      ASSERT_EQ(planes[i], 128) << i;
  }
}

TEST(Yuv, AnOddSizeGrowsByItsLastColumnAndRow) {
  // 3x1: black, white, red. The second block holds red alone, repeated.
  const std::vector<uint32_t> pixels = {0x000000, 0xFFFFFF, 0xFF0000};
  std::vector<uint8_t> planes;
  to_yuv420({pixels, 3, 1}, YuvMatrix::kBt601, planes);
  // Red in BT.601 is (81, 90, 240).
  const std::vector<uint8_t> expected = {16, 235, 81, 81, 16, 235, 81, 81, 128, 90, 128, 240};
  EXPECT_EQ(planes, expected);
}

TEST(Yuv, ChromaIsThatOfTheMeanColourOfFour) {
  const std::vector<uint32_t> pixels = {0xFF0000, 0x00FF00, 0x0000FF, 0xFFFFFF};
  std::vector<uint8_t> planes;
  to_yuv420({pixels, 2, 2}, YuvMatrix::kBt709, planes);
  // The mean is grey (127.5 in each), so the chroma is exactly the middle.
  EXPECT_EQ(planes[4], 128);
  EXPECT_EQ(planes[5], 128);
}

}  // namespace
}  // namespace auslan
