// SPDX-License-Identifier: Apache-2.0
// sRGB pixels to Y'CbCr, 8 bits, limited range, in integers: the same bytes on every machine.
//
// With R, G, B in 0..255 and >> rounding down:
//   BT.601  Y  = (16829 R + 33039 G +  6416 B + 16 * 65536 + 32768) >> 16
//           Cb = (-9714 R - 19070 G + 28784 B + 128 * 65536 + 32768) >> 16
//           Cr = (28784 R - 24103 G -  4681 B + 128 * 65536 + 32768) >> 16
//   BT.709  Y  = (11966 R + 40254 G +  4064 B + 16 * 65536 + 32768) >> 16
//           Cb = (-6596 R - 22188 G + 28784 B + 128 * 65536 + 32768) >> 16
//           Cr = (28784 R - 26145 G -  2639 B + 128 * 65536 + 32768) >> 16
// The coefficients are the recommendations' own, scaled by 219/255 (Y) or 112/255 over the larger of the chroma spans
// and by 65536, rounded so that white gives exactly 235 and greys exactly 128.
#pragma once

#include "media/frame.h"

#include <cstdint>
#include <vector>

namespace auslan {

enum class YuvMatrix { kBt601, kBt709 };

/// Planes Y, Cb, Cr one after the other, all of the frame's size. `planes` is resized and overwritten.
void to_yuv444(FrameView frame, YuvMatrix matrix, std::vector<uint8_t>& planes);

/// Planes Y (even_width x even_height), Cb and Cr (half of that each way). An odd width or height grows by repeating
/// its last column or row. Chroma is that of the mean colour of each 2x2 block (sited at its centre).
void to_yuv420(FrameView frame, YuvMatrix matrix, std::vector<uint8_t>& planes);

}  // namespace auslan
