// SPDX-License-Identifier: Apache-2.0
// Still pictures: PNG in and out, and the comparison of two pictures.
//
// OpenImageIO does the coding. Linking it costs 0.4 s and 131 MB at every start, so it sits in a module of its own
// (libauslan_picture_oiio.so) that is loaded when the first picture is read or written. The module is looked for in
// AUSLANJAM_MODULE_DIR, beside the program, in ../lib and ../lib/auslanjam from there, and where it was built.
#pragma once

#include "kinematics/result.h"
#include "media/frame.h"

#include <cstdint>
#include <string>
#include <vector>

namespace auslan {

/// A picture that owns its pixels; see FrameView for their form.
struct Picture {
  std::vector<uint32_t> pixels;
  int width = 0;
  int height = 0;

  FrameView view() const { return {pixels, width, height}; }
  FrameSpan span() { return {pixels, width, height}; }
};

/// A picture of one colour.
Picture make_picture(int width, int height, uint32_t colour = 0);

/// Writes 8-bit RGB. The same pixels give the same bytes: no date, no program name. Appears whole or not at all.
/// kUsage: the sizes do not agree. kUnwritable: folder or disk. kUnsupported: no picture module (says what to install).
Result<void> write_png(const std::string& path, FrameView frame);

/// Reads a PNG (8 or 16 bits, grey or colour, up to 16384 pixels a side). Transparency is refused unless it is opaque
/// throughout. For pictures of our own, such as golden images. kNotFound, kUnreadable, kMalformed, kLimit,
/// kUnsupported.
Result<Picture> read_png(const std::string& path);

/// What differs between two pictures.
struct Comparison {
  bool same_size = false;  ///< when false nothing else is filled in
  int64_t differing = 0;   ///< pixels that differ in any channel
  int worst_x = 0;         ///< the first pixel, in reading order, with the largest difference in one channel
  int worst_y = 0;
  int worst_difference = 0;  ///< of that channel, 0..255
  uint32_t expected = 0;     ///< the worst pixel in both pictures
  uint32_t actual = 0;

  bool equal() const { return same_size && differing == 0; }
};

Comparison compare(FrameView expected, FrameView actual);
/// "12 pixels differ; worst at (x 3, y 4): expected #102030, actual #112233", or what else is wrong.
std::string to_string(const Comparison& comparison);
/// Where equal, the expected picture darkened to a third; where not, red, brighter with the difference. The sizes must
/// agree.
Picture difference_image(FrameView expected, FrameView actual);

}  // namespace auslan
