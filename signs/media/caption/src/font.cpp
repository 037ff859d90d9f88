// SPDX-License-Identifier: Apache-2.0
#include "font.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <cstring>

namespace auslan {

namespace {

/// A text of every code point at many sizes must not take the memory: beyond this the cache starts afresh.
constexpr size_t kMaxGlyphs = 4096;

FT_Face face_of(void* face) {
  return static_cast<FT_Face>(face);
}

bool is_invisible(uint32_t code_point) {
  return code_point < 0x20 || (code_point >= 0x7F && code_point < 0xA0) ||
         (code_point >= 0x200B && code_point <= 0x200F) || (code_point >= 0x202A && code_point <= 0x202E) ||
         (code_point >= 0x2060 && code_point <= 0x2064) || code_point == 0xFEFF ||
         (code_point >= 0xFE00 && code_point <= 0xFE0F);
}

/// A hollow box as high as a capital letter.
Glyph box(int size_px) {
  Glyph glyph;
  const int line = size_px / 16 > 0 ? size_px / 16 : 1;
  glyph.width = size_px / 2;
  glyph.height = size_px * 3 / 4;
  glyph.left = line;
  glyph.top = glyph.height;
  glyph.advance = int64_t{64} * (glyph.width + 2 * line);
  glyph.coverage.assign(static_cast<size_t>(glyph.width) * static_cast<size_t>(glyph.height), 255);
  for (int y = line; y < glyph.height - line; ++y)
    for (int x = line; x < glyph.width - line; ++x)
      glyph.coverage[static_cast<size_t>(y) * static_cast<size_t>(glyph.width) + static_cast<size_t>(x)] = 0;
  return glyph;
}

}  // namespace

Result<std::unique_ptr<Font>> Font::open(const std::string& path) {
  std::unique_ptr<Font> font(new Font);
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0)
    return fail(ErrorCode::kLimit, "FreeType does not start; free some memory", path);
  font->library_ = library;
  FT_Face face = nullptr;
  if (FT_New_Face(library, path.c_str(), 0, &face) != 0)
    return fail(ErrorCode::kMalformed,
                "this is not a font that FreeType can read; install fonts-dejavu-core, or name a TrueType file in "
                "AUSLANJAM_FONT",
                path);
  font->face_ = face;
  if (!FT_IS_SCALABLE(face) || FT_Select_Charmap(face, FT_ENCODING_UNICODE) != 0)
    return fail(ErrorCode::kMalformed, "this font has no outlines or no Unicode table; use DejaVuSans.ttf", path);
  return font;
}

Font::~Font() {
  if (face_ != nullptr) FT_Done_Face(face_of(face_));
  if (library_ != nullptr) FT_Done_FreeType(static_cast<FT_Library>(library_));
}

const Glyph& Font::glyph(int size_px, uint32_t code_point) {
  const auto key = std::pair(size_px, code_point);
  const auto found = cache_.find(key);
  if (found != cache_.end()) return found->second;
  if (cache_.size() >= kMaxGlyphs) cache_.clear();
  return cache_.emplace(key, render(size_px, code_point)).first->second;
}

Glyph Font::render(int size_px, uint32_t code_point) {
  if (is_invisible(code_point)) return {};
  const FT_Face face = face_of(face_);
  if (size_px != size_px_) {
    if (FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size_px)) != 0) return box(size_px);
    size_px_ = size_px;
  }
  const FT_UInt index = FT_Get_Char_Index(face, code_point);
  if (index == 0) return box(size_px);
  // Without hinting the outlines depend on the font file alone, not on how the interpreter was configured.
  const FT_Int32 flags = FT_LOAD_NO_HINTING | FT_LOAD_NO_AUTOHINT | FT_LOAD_NO_BITMAP | FT_LOAD_TARGET_NORMAL;
  if (FT_Load_Glyph(face, index, flags) != 0 || FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL) != 0)
    return box(size_px);
  const FT_GlyphSlot slot = face->glyph;
  const FT_Bitmap& bitmap = slot->bitmap;
  Glyph glyph;
  // 16.16 to 26.6, rounded; linear advances are not rounded to pixels.
  glyph.advance = (slot->linearHoriAdvance + 512) >> 10;
  if (bitmap.pixel_mode != FT_PIXEL_MODE_GRAY || bitmap.pitch <= 0) return glyph;  // a space
  glyph.left = slot->bitmap_left;
  glyph.top = slot->bitmap_top;
  glyph.width = static_cast<int>(bitmap.width);
  glyph.height = static_cast<int>(bitmap.rows);
  const size_t width = bitmap.width;
  glyph.coverage.resize(width * bitmap.rows);
  for (size_t y = 0; y < bitmap.rows; ++y)
    std::memcpy(glyph.coverage.data() + y * width, bitmap.buffer + y * static_cast<size_t>(bitmap.pitch), width);
  return glyph;
}

}  // namespace auslan
