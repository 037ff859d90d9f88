// SPDX-License-Identifier: Apache-2.0
// Text on pictures: captions in a band at the bottom, and lines of text for plots and marks.
//
// One named font (DejaVu Sans, Debian package fonts-dejavu-core), unhinted grey coverage, whole-pixel pen positions
// from 26.6 fixed-point advances, integer blending: the same FreeType and font give the same pixels everywhere. No
// shaping: one glyph a code point, left to right. What the font lacks is drawn as a box.
#pragma once

#include "kinematics/result.h"
#include "media/frame.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace auslan {

enum class TextAlign { kLeft, kCentre, kRight };

struct CaptionStyle {
  int size_px = 24;    ///< size of the font's em square in pixels, 6 to 400
  int max_lines = 2;   ///< text beyond them ends in an ellipsis
  int margin_px = 12;  ///< between the plate and the edge of the frame
  uint32_t text_colour = 0xFFFFFF;
  uint32_t plate_colour = 0x000000;
  int plate_opacity = 178;  ///< 0 (clear) to 255
};

/// Where paint() may draw: the band at the bottom of a frame that holds max_lines of text. Empty for an empty frame.
PixelRect caption_band(int frame_width, int frame_height, const CaptionStyle& style);

/// Draws text. Glyphs are cached at first use, so that nothing is allocated once a text has been drawn; the cache makes
/// an object a matter for one thread at a time. Invalid UTF-8 is shown as U+FFFD.
class CaptionPainter {
 public:
  /// Opens the font of AUSLANJAM_FONT, or DejaVuSans.ttf where systems keep it. kNotFound names the package;
  /// kMalformed: FreeType cannot read the file.
  static Result<CaptionPainter> open();
  static Result<CaptionPainter> open(const std::string& font_path);

  CaptionPainter(CaptionPainter&&) noexcept;
  CaptionPainter& operator=(CaptionPainter&&) noexcept;
  ~CaptionPainter();

  /// A caption: wrapped at spaces (a longer word anywhere), '\n' breaks a line, centred on a plate as wide as the text,
  /// at the bottom of caption_band(). An empty text draws nothing. Draws nowhere outside the band.
  void paint(FrameSpan frame, std::string_view utf8, const CaptionStyle& style = {}) const noexcept;

  /// One line of text, its baseline at y and its left end, middle or right end at x; clipped to the frame. `colour` is
  /// 0x00RRGGBB. size_px: 6 to 400.
  void text(FrameSpan frame, int x, int y, std::string_view utf8, int size_px, uint32_t colour,
            TextAlign align = TextAlign::kLeft) const noexcept;

  /// Width of one line of text in pixels: how far the pen moves.
  int width(std::string_view utf8, int size_px) const noexcept;
  /// From the baseline up to the top of the tallest letter, and from baseline to baseline, in pixels.
  int ascent(int size_px) const noexcept;
  int line_height(int size_px) const noexcept;

 private:
  struct Font;
  explicit CaptionPainter(std::unique_ptr<Font> font);
  std::unique_ptr<Font> font_;
};

}  // namespace auslan
