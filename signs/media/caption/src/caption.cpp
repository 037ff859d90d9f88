// SPDX-License-Identifier: Apache-2.0
#include "media/caption.h"

#include "font.h"
#include "line_break.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <unistd.h>
#include <utility>

namespace auslan {

namespace {

constexpr std::array<const char*, 4> kFontPaths = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",    // Debian, Ubuntu
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",  // Fedora
    "/usr/share/fonts/TTF/DejaVuSans.ttf",                // Arch
    "/usr/share/fonts/dejavu/DejaVuSans.ttf",             // Alpine and others
};

constexpr int kMaxLines = 8;

int clamped_size(int size_px) {
  return std::clamp(size_px, 6, 400);
}
int line_height_of(int size_px) {
  return (5 * size_px + 3) / 4;
}
/// From the top of a line to its baseline: DejaVu's ascent and descent, centred in the line.
int baseline_of(int size_px) {
  return (31 * size_px + 16) / 32;
}
int padding_of(int size_px) {
  return size_px / 3;
}

/// dst + (src - dst) * a / 255, rounded, exact at both ends.
uint32_t blend(uint32_t dst, uint32_t src, uint32_t a) {
  uint32_t out = 0;
  for (const int shift : {16, 8, 0}) {
    const uint32_t d = dst >> shift & 255;
    const uint32_t s = src >> shift & 255;
    out |= (d * (255 - a) + s * a + 127) / 255 << shift;
  }
  return out;
}

uint32_t& pixel_at(FrameSpan frame, int x, int y) {
  return frame.pixels[static_cast<size_t>(y) * static_cast<size_t>(frame.width) + static_cast<size_t>(x)];
}

void fill(FrameSpan frame, const PixelRect& rect, uint32_t colour, uint32_t opacity) {
  for (int y = rect.y; y < rect.y + rect.height; ++y)
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      uint32_t& pixel = pixel_at(frame, x, y);
      pixel = blend(pixel, colour, opacity);
    }
}

void draw_glyph(FrameSpan frame, const PixelRect& clip, const Glyph& glyph, int64_t pen_x, int64_t baseline,
                uint32_t colour) {
  const int64_t left = pen_x + glyph.left;
  const int64_t top = baseline - glyph.top;
  // Far off the frame; also keeps the sums below within int.
  if (left > clip.x + clip.width || left + glyph.width < clip.x || top > clip.y + clip.height ||
      top + glyph.height < clip.y)
    return;
  const PixelRect drawn =
      intersection(clip, {static_cast<int>(left), static_cast<int>(top), glyph.width, glyph.height});
  for (int y = drawn.y; y < drawn.y + drawn.height; ++y)
    for (int x = drawn.x; x < drawn.x + drawn.width; ++x) {
      const int64_t source = (y - top) * glyph.width + (x - left);
      uint32_t& pixel = pixel_at(frame, x, y);
      pixel = blend(pixel, colour, glyph.coverage[static_cast<size_t>(source)]);
    }
}

struct SizedFont {
  Font* font;
  int size_px;
};

int64_t advance_of(const void* context, uint32_t code_point) noexcept {
  const auto* sized = static_cast<const SizedFont*>(context);
  return sized->font->glyph(sized->size_px, code_point).advance;
}

/// In 1/64 pixel.
int64_t run_width(const SizedFont& sized, std::string_view utf8) noexcept {
  int64_t sum = 0;
  while (!utf8.empty())
    sum += advance_of(&sized, take_code_point(utf8));
  return sum;
}

int64_t run_width(const SizedFont& sized, const Line& line) noexcept {
  return run_width(sized, line.text) + (line.ellipsis ? advance_of(&sized, kEllipsis) : 0);
}

/// `pen` in 1/64 pixel. Returns where the pen ends.
int64_t draw_run(FrameSpan frame, const PixelRect& clip, const SizedFont& sized, int64_t pen, int64_t baseline,
                 std::string_view utf8, uint32_t colour) noexcept {
  while (!utf8.empty()) {
    const Glyph& glyph = sized.font->glyph(sized.size_px, take_code_point(utf8));
    draw_glyph(frame, clip, glyph, (pen + 32) >> 6, baseline, colour);
    pen += glyph.advance;
  }
  return pen;
}

int pixels_up(int64_t sixty_fourths) {
  return static_cast<int>(std::min<int64_t>((sixty_fourths + 63) >> 6, 1 << 30));
}

}  // namespace

struct CaptionPainter::Font {
  std::unique_ptr<auslan::Font> cached;

  SizedFont at(int size_px) const { return {cached.get(), clamped_size(size_px)}; }
};

CaptionPainter::CaptionPainter(std::unique_ptr<Font> font) : font_(std::move(font)) {}
CaptionPainter::CaptionPainter(CaptionPainter&&) noexcept = default;
CaptionPainter& CaptionPainter::operator=(CaptionPainter&&) noexcept = default;
CaptionPainter::~CaptionPainter() = default;

Result<CaptionPainter> CaptionPainter::open() {
  const char* named = std::getenv("AUSLANJAM_FONT");
  if (named != nullptr && *named != '\0') return open(named);
  for (const char* path : kFontPaths)
    if (access(path, R_OK) == 0) return open(path);
  return fail(ErrorCode::kNotFound,
              "captions need the font DejaVu Sans, which is not installed; install it (Debian: apt install "
              "fonts-dejavu-core), or name its file in AUSLANJAM_FONT");
}

Result<CaptionPainter> CaptionPainter::open(const std::string& font_path) {
  if (access(font_path.c_str(), R_OK) != 0)
    return fail(
        ErrorCode::kNotFound,
        "the font is not there or cannot be read; install it (Debian: apt install fonts-dejavu-core), or correct "
        "AUSLANJAM_FONT",
        font_path);
  auto font = auslan::Font::open(font_path);
  if (!font) return tl::unexpected(font.error());
  auto owned = std::make_unique<Font>();
  owned->cached = std::move(*font);
  return CaptionPainter(std::move(owned));
}

PixelRect caption_band(int frame_width, int frame_height, const CaptionStyle& style) {
  if (frame_width <= 0 || frame_height <= 0) return {};
  const int size = clamped_size(style.size_px);
  const int lines = std::clamp(style.max_lines, 1, kMaxLines);
  const int margin = std::clamp(style.margin_px, 0, 1 << 20);
  const int height = lines * line_height_of(size) + 2 * padding_of(size);
  return intersection({0, 0, frame_width, frame_height},
                      {margin, frame_height - margin - height, frame_width - 2 * margin, height});
}

void CaptionPainter::paint(FrameSpan frame, std::string_view utf8, const CaptionStyle& style) const noexcept {
  const PixelRect band = caption_band(frame.width, frame.height, style);
  if (band.width == 0 || !is_well_formed(frame)) return;
  const SizedFont sized = font_->at(style.size_px);
  const int padding = padding_of(sized.size_px);
  const int64_t limit = int64_t{64} * std::max(1, band.width - 2 * padding);
  const Measure measure{&sized, advance_of};

  std::array<Line, kMaxLines> lines;
  size_t count = 0;
  int64_t widest = 0;
  const size_t most = static_cast<size_t>(std::clamp(style.max_lines, 1, kMaxLines));
  for (std::string_view rest = utf8; !rest.empty() && count < most;) {
    const Line line = take_line(rest, limit, measure, count + 1 == most);
    if (line.text.empty() && !line.ellipsis) continue;
    widest = std::max(widest, run_width(sized, line));
    lines[count++] = line;
  }
  if (count == 0) return;

  const int height = static_cast<int>(count) * line_height_of(sized.size_px) + 2 * padding;
  const int width = std::min(band.width, pixels_up(widest) + 2 * padding);
  const PixelRect plate =
      intersection(band, {band.x + (band.width - width) / 2, band.y + band.height - height, width, height});
  fill(frame, plate, style.plate_colour, static_cast<uint32_t>(std::clamp(style.plate_opacity, 0, 255)));
  for (size_t i = 0; i < count; ++i) {
    const int64_t baseline = int64_t{band.y} + band.height - height + padding +
                             static_cast<int64_t>(i) * line_height_of(sized.size_px) + baseline_of(sized.size_px);
    int64_t pen = int64_t{64} * band.x + (int64_t{64} * band.width - run_width(sized, lines[i])) / 2;
    pen = draw_run(frame, plate, sized, pen, baseline, lines[i].text, style.text_colour);
    if (lines[i].ellipsis) draw_run(frame, plate, sized, pen, baseline, "\u2026", style.text_colour);
  }
}

void CaptionPainter::text(FrameSpan frame, int x, int y, std::string_view utf8, int size_px, uint32_t colour,
                          TextAlign align) const noexcept {
  if (!is_well_formed(frame)) return;
  const SizedFont sized = font_->at(size_px);
  int64_t pen = int64_t{64} * x;
  if (align == TextAlign::kCentre) pen -= run_width(sized, utf8) / 2;
  if (align == TextAlign::kRight) pen -= run_width(sized, utf8);
  draw_run(frame, {0, 0, frame.width, frame.height}, sized, pen, y, utf8, colour);
}

int CaptionPainter::width(std::string_view utf8, int size_px) const noexcept {
  return pixels_up(run_width(font_->at(size_px), utf8));
}

int CaptionPainter::ascent(int size_px) const noexcept {
  return font_->cached->glyph(clamped_size(size_px), 'l').top;
}

int CaptionPainter::line_height(int size_px) const noexcept {
  return line_height_of(clamped_size(size_px));
}

}  // namespace auslan
