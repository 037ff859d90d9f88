// SPDX-License-Identifier: Apache-2.0
// Scaling a picture into another of any size, in integers.
#pragma once

#include "media/frame.h"

namespace auslan {

/// A target picture whose rows may be padded.
struct Canvas {
  uint32_t* pixels = nullptr;
  int width = 0;
  int height = 0;
  int stride = 0;  ///< pixels from row to row, at least width
};

/// Where a picture of one size lies in a canvas: as large as it fits with its shape kept, in the middle.
struct Placement {
  int x = 0, y = 0, width = 0, height = 0;
};
Placement fit(int width, int height, int canvas_width, int canvas_height);

/// Copies the frame there, the nearest pixel for each, and blackens the rest.
void letterbox(FrameView frame, const Canvas& canvas);

}  // namespace auslan
