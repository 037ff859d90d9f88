// SPDX-License-Identifier: Apache-2.0
#include "media/yuv.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace auslan {

namespace {

struct Coefficients {
  std::array<int64_t, 3> y, cb, cr;
};

constexpr Coefficients kBt601 = {{16829, 33039, 6416}, {-9714, -19070, 28784}, {28784, -24103, -4681}};
constexpr Coefficients kBt709 = {{11966, 40254, 4064}, {-6596, -22188, 28784}, {28784, -26145, -2639}};

const Coefficients& coefficients(YuvMatrix matrix) {
  return matrix == YuvMatrix::kBt601 ? kBt601 : kBt709;
}

struct Colour {
  int64_t r = 0, g = 0, b = 0;
};

Colour colour_of(uint32_t pixel) {
  return {static_cast<int64_t>((pixel >> 16) & 255), static_cast<int64_t>((pixel >> 8) & 255),
          static_cast<int64_t>(pixel & 255)};
}

/// `shift` is 16 for one pixel, 18 for the sum of four.
uint8_t component(const std::array<int64_t, 3>& c, const Colour& sum, int64_t offset, int shift) {
  const int64_t scaled = c[0] * sum.r + c[1] * sum.g + c[2] * sum.b + (offset << shift) + (int64_t{1} << (shift - 1));
  return static_cast<uint8_t>(scaled >> shift);
}

}  // namespace

void to_yuv444(FrameView frame, YuvMatrix matrix, std::vector<uint8_t>& planes) {
  assert(is_well_formed(frame));
  const Coefficients& c = coefficients(matrix);
  const size_t count = frame.pixels.size();
  planes.resize(3 * count);
  for (size_t i = 0; i < count; ++i) {
    const Colour colour = colour_of(frame.pixels[i]);
    planes[i] = component(c.y, colour, 16, 16);
    planes[count + i] = component(c.cb, colour, 128, 16);
    planes[2 * count + i] = component(c.cr, colour, 128, 16);
  }
}

void to_yuv420(FrameView frame, YuvMatrix matrix, std::vector<uint8_t>& planes) {
  assert(is_well_formed(frame));
  const Coefficients& c = coefficients(matrix);
  const int half_width = (frame.width + 1) / 2;
  const int half_height = (frame.height + 1) / 2;
  const size_t stride = 2 * static_cast<size_t>(half_width);
  const size_t luma = stride * 2 * static_cast<size_t>(half_height);
  const size_t chroma = luma / 4;
  planes.resize(luma + 2 * chroma);
  size_t block = 0;
  for (int row = 0; row < half_height; ++row) {
    for (int column = 0; column < half_width; ++column, ++block) {
      Colour sum;
      for (int inner = 0; inner < 4; ++inner) {
        const int x = 2 * column + (inner & 1);
        const int y = 2 * row + (inner >> 1);
        const size_t source = static_cast<size_t>(std::min(y, frame.height - 1)) * static_cast<size_t>(frame.width) +
                              static_cast<size_t>(std::min(x, frame.width - 1));
        const Colour colour = colour_of(frame.pixels[source]);
        sum.r += colour.r;
        sum.g += colour.g;
        sum.b += colour.b;
        planes[static_cast<size_t>(y) * stride + static_cast<size_t>(x)] = component(c.y, colour, 16, 16);
      }
      planes[luma + block] = component(c.cb, sum, 128, 18);
      planes[luma + chroma + block] = component(c.cr, sum, 128, 18);
    }
  }
}

}  // namespace auslan
