// SPDX-License-Identifier: Apache-2.0
// The only place that sees FreeType: glyphs as grey coverage, cached by size and code point.
#pragma once

#include "kinematics/result.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace auslan {

struct Glyph {
  int left = 0;  ///< from the pen to the first column, pixels
  int top = 0;   ///< from the baseline up to the first row, pixels
  int width = 0;
  int height = 0;
  int64_t advance = 0;            ///< how far the pen moves, 1/64 pixel
  std::vector<uint8_t> coverage;  ///< width * height, 0 to 255
};

class Font {
 public:
  static Result<std::unique_ptr<Font>> open(const std::string& path);
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;
  ~Font();

  /// Never fails: what the font lacks is a box, a control character an empty glyph. The reference holds until the next
  /// call.
  const Glyph& glyph(int size_px, uint32_t code_point);

 private:
  Font() = default;
  Glyph render(int size_px, uint32_t code_point);

  // FreeType's handles, typed only in the source.
  void* library_ = nullptr;
  void* face_ = nullptr;
  int size_px_ = 0;
  std::map<std::pair<int, uint32_t>, Glyph> cache_;
};

}  // namespace auslan
