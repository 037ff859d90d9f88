// SPDX-License-Identifier: Apache-2.0
// What a picture is: uint32_t pixels 0x00RRGGBB, sRGB-encoded, row-major, top-left pixel first, no padding between
// rows.
#pragma once

#include <cstddef>
#include <cstdint>

namespace auslan::raster {

inline constexpr int kMaxImageSize = 16384;  ///< largest width and largest height of a frame, pixels

/// A pixel from its channels, 0 to 255 each, sRGB-encoded.
constexpr uint32_t pack_pixel(uint32_t red, uint32_t green, uint32_t blue) {
  return (red << 16U) | (green << 8U) | blue;
}

/// Channels of a pixel, 0 to 255.
constexpr uint32_t red_of(uint32_t pixel) {
  return (pixel >> 16U) & 255U;
}
constexpr uint32_t green_of(uint32_t pixel) {
  return (pixel >> 8U) & 255U;
}
constexpr uint32_t blue_of(uint32_t pixel) {
  return pixel & 255U;
}

/// How many pixels a frame holds. Precondition: both sizes lie in 1..kMaxImageSize.
constexpr size_t pixel_count(int width, int height) {
  return static_cast<size_t>(width) * static_cast<size_t>(height);
}

}  // namespace auslan::raster
