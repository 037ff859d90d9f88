// SPDX-License-Identifier: Apache-2.0
#include "letterbox.h"

#include <algorithm>
#include <cassert>

namespace auslan {

Placement fit(int width, int height, int canvas_width, int canvas_height) {
  assert(width > 0 && height > 0 && canvas_width > 0 && canvas_height > 0);
  Placement placed;
  const int64_t by_width = int64_t{canvas_width} * height;  // compare canvas_width / width with canvas_height / height
  const int64_t by_height = int64_t{canvas_height} * width;
  if (by_width <= by_height) {
    placed.width = canvas_width;
    placed.height = std::max(1, static_cast<int>(by_width / width));
  } else {
    placed.height = canvas_height;
    placed.width = std::max(1, static_cast<int>(by_height / height));
  }
  placed.x = (canvas_width - placed.width) / 2;
  placed.y = (canvas_height - placed.height) / 2;
  return placed;
}

void letterbox(FrameView frame, const Canvas& canvas) {
  const Placement placed = fit(frame.width, frame.height, canvas.width, canvas.height);
  for (int y = 0; y < canvas.height; ++y) {
    uint32_t* row = canvas.pixels + static_cast<ptrdiff_t>(y) * canvas.stride;
    const int inner = y - placed.y;
    if (inner < 0 || inner >= placed.height) {
      std::fill_n(row, canvas.width, 0U);
      continue;
    }
    const auto source_y = static_cast<size_t>(int64_t{inner} * frame.height / placed.height);
    const uint32_t* source = frame.pixels.data() + source_y * static_cast<size_t>(frame.width);
    std::fill_n(row, placed.x, 0U);
    if (placed.width == frame.width) {
      std::copy_n(source, frame.width, row + placed.x);
    } else {
      // column * width / placed.width without a division each: whole steps, and a remainder that is carried.
      const int step = frame.width / placed.width;
      const int remainder = frame.width % placed.width;
      int column = 0;
      int carried = 0;
      for (int x = 0; x < placed.width; ++x) {
        row[placed.x + x] = source[column];
        column += step;
        carried += remainder;
        if (carried >= placed.width) {
          carried -= placed.width;
          ++column;
        }
      }
    }
    std::fill(row + placed.x + placed.width, row + canvas.width, 0U);
  }
}

}  // namespace auslan
