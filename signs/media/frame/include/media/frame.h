// SPDX-License-Identifier: Apache-2.0
// A picture as it passes between the rasteriser, the captions, the window and the writers.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace auslan {

/// A picture that is read. Pixels are 0x00RRGGBB, sRGB-encoded, row by row from the top left, without padding between
/// rows: pixels.size() == width * height. The top byte is zero.
struct FrameView {
  std::span<const uint32_t> pixels;
  int width = 0;
  int height = 0;
};

/// The same, to be drawn into.
struct FrameSpan {
  std::span<uint32_t> pixels;
  int width = 0;
  int height = 0;

  operator FrameView() const { return {pixels, width, height}; }  // NOLINT: a view of what can be written is free
};

/// A part of a picture: pixels x .. x+width-1 by y .. y+height-1.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
};

/// What lies in both; empty (width 0) where nothing does.
PixelRect intersection(const PixelRect& a, const PixelRect& b);

/// Whether the sizes are positive and agree with the number of pixels.
inline bool is_well_formed(FrameView frame) {
  return frame.width > 0 && frame.height > 0 &&
         frame.pixels.size() == static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height);
}

/// XXH3 (128 bits, seed 0) of the pixels as 32 hexadecimal digits, as `xxh128sum` prints it. What is hashed is each
/// pixel as four bytes blue, green, red, zero, whatever the processor's own byte order; the size of the picture is not
/// part of it.
std::string frame_digest(FrameView frame);

}  // namespace auslan
