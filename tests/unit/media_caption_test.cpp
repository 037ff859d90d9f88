// SPDX-License-Identifier: Apache-2.0
#include "media/caption.h"
#include "scratch_folder.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>
#include <vector>

namespace {
bool counting = false;
int allocations = 0;
}  // namespace

void* operator new(size_t size) {
  if (counting) ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  std::abort();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
  std::free(memory);
}

namespace auslan {
namespace {

constexpr uint32_t kBlue = 0x2040A0;

struct Canvas {
  explicit Canvas(int w, int h) : width(w), height(h), pixels(static_cast<size_t>(w) * static_cast<size_t>(h), kBlue) {}
  FrameSpan span() { return {pixels, width, height}; }
  uint32_t at(int x, int y) const { return pixels[static_cast<size_t>(y * width + x)]; }

  /// The smallest rectangle that holds every pixel that is not blue any more.
  PixelRect touched() const {
    int x0 = width, y0 = height, x1 = -1, y1 = -1;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        if (at(x, y) == kBlue) continue;
        x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
      }
    return x1 < 0 ? PixelRect{} : PixelRect{x0, y0, x1 - x0 + 1, y1 - y0 + 1};
  }

  int width, height;
  std::vector<uint32_t> pixels;
};

bool contains(const PixelRect& outer, const PixelRect& inner) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

class Caption : public testing::Test {
 protected:
  void SetUp() override {
    auto opened = CaptionPainter::open();
    if (!opened) GTEST_SKIP() << to_string(opened.error());
    painter_.emplace(std::move(*opened));
  }
  std::optional<CaptionPainter> painter_;
};

const char* const kTexts[] = {"Where does it hurt?",
                              "a",
                              "Sit down, please. The doctor will see you in a quarter of an hour, or a little later.",
                              "Llanfairpwllgwyngyllgogerychwyrndrobwllllantysiliogogogochuchaf",
                              "\xFF\xFE broken \xC0\xAF utf-8 \xED\xA0\x80",
                              "\xC3\x85ngstr\xC3\xB6m \xE4\xBD\xA0\xE5\xA5\xBD \xF3\xB0\x80\x80",
                              "one\ntwo\nthree\nfour",
                              "   \n  \t ",
                              "\n\n\nlate"};

TEST_F(Caption, NeverDrawsOutsideItsBand) {
  for (const char* text : kTexts)
    for (const int width : {1, 7, 40, 120, 321})
      for (const int height : {1, 9, 33, 181})
        for (const int size : {6, 18, 60}) {
          CaptionStyle style;
          style.size_px = size;
          Canvas canvas(width, height);
          painter_->paint(canvas.span(), text, style);
          const PixelRect band = caption_band(width, height, style);
          const PixelRect touched = canvas.touched();
          if (touched.width > 0) {
            EXPECT_TRUE(contains(band, touched)) << text << " " << width << "x" << height << " " << size;
          }
        }
}

TEST_F(Caption, EmptyTextDrawsNothing) {
  Canvas canvas(320, 180);
  painter_->paint(canvas.span(), "");
  painter_->paint(canvas.span(), "  \n \t\n");
  EXPECT_EQ(canvas.touched().width, 0);
}

TEST_F(Caption, PlateIsCentredAtTheBottomOfTheBandAndBlendsExactly) {
  CaptionStyle style;
  style.size_px = 20;
  Canvas canvas(400, 200);
  painter_->paint(canvas.span(), "HURT", style);
  const PixelRect band = caption_band(400, 200, style);
  const PixelRect plate = canvas.touched();
  EXPECT_EQ(plate.y + plate.height, band.y + band.height);
  EXPECT_EQ(band.y + band.height, 200 - style.margin_px);
  EXPECT_LE(std::abs((plate.x + plate.x + plate.width) - 400), 1);
  // Black at 178/255 over 0x2040A0: (32, 64, 160) * 77 / 255 = (9.66, 19.3, 48.3).
  EXPECT_EQ(canvas.at(plate.x, plate.y), 0x0A1330U);
  // The text is white where its strokes cover a pixel wholly.
  EXPECT_NE(std::ranges::find(canvas.pixels, 0xFFFFFFU), canvas.pixels.end());
  // Clear and solid plates are exact.
  style.plate_opacity = 0;
  Canvas clear(400, 200);
  painter_->paint(clear.span(), "HURT", style);
  EXPECT_EQ(clear.at(plate.x, plate.y), kBlue);
  style.plate_opacity = 255;
  painter_->paint(clear.span(), "HURT", style);
  EXPECT_EQ(clear.at(plate.x, plate.y), 0U);
}

TEST_F(Caption, WrapsAtSpacesAndCutsWithAnEllipsis) {
  CaptionStyle style;
  style.size_px = 20;
  const auto plate_of = [&](const std::string& text, int width) {
    Canvas canvas(width, 300);
    painter_->paint(canvas.span(), text, style);
    return canvas.touched();
  };
  const auto same_picture = [&](const std::string& a, const std::string& b, int width) {
    Canvas first(width, 300), second(width, 300);
    painter_->paint(first.span(), a, style);
    painter_->paint(second.span(), b, style);
    return first.pixels == second.pixels;
  };
  const int one = plate_of("where does", 2000).height;
  const int two = plate_of("where\ndoes", 2000).height;
  EXPECT_EQ(two - one, painter_->line_height(20));
  // A frame in which "where does it" fits and "where does it hurt" does not.
  const int room = 2 * style.margin_px + 2 * (20 / 3);
  const int width = painter_->width("where does it", 20) + room + 2;
  ASSERT_LT(width, painter_->width("where does it hurt", 20) + room);
  EXPECT_TRUE(same_picture("where does it hurt", "where does it\nhurt", width));
  EXPECT_TRUE(same_picture("  where   does it hurt  ", "where   does it\nhurt",
                           painter_->width("where   does it", 20) + room + 2));
  EXPECT_FALSE(same_picture("where does it hurt", "where does\nit hurt", width));
  // Two lines at most: the rest is an ellipsis, and the cut text is drawn as if it had been written so.
  EXPECT_TRUE(same_picture("where does it hurt\nthird", "where does it\nhurt\xE2\x80\xA6", width));
  style.max_lines = 1;
  EXPECT_TRUE(same_picture("where does it hurt", "where does\xE2\x80\xA6", width));
  style.max_lines = 3;
  EXPECT_TRUE(same_picture("where does it hurt", "where does it\nhurt", width));
}

TEST_F(Caption, BrokenUtf8IsTheReplacementCharacter) {
  // Each byte of an overlong form, a surrogate, a cut sequence.
  EXPECT_EQ(painter_->width("\xC0\xAF", 40), painter_->width("\xEF\xBF\xBD\xEF\xBF\xBD", 40));
  EXPECT_EQ(painter_->width("\xED\xA0\x80", 40), painter_->width("\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD", 40));
  EXPECT_EQ(painter_->width("a\xE2\x80", 40), painter_->width("a\xEF\xBF\xBD\xEF\xBF\xBD", 40));
}

TEST_F(Caption, AMissingGlyphIsABox) {
  // A private-use code point beyond any font of letters: hollow, symmetric.
  Canvas canvas(100, 100);
  painter_->text(canvas.span(), 20, 80, "\xF3\xB0\x80\x80", 48, 0xFFFFFF);
  const PixelRect box = canvas.touched();
  ASSERT_GT(box.width, 10);
  ASSERT_GT(box.height, box.width);
  EXPECT_EQ(box.y + box.height, 80);
  for (int x = box.x; x < box.x + box.width; ++x) {
    EXPECT_EQ(canvas.at(x, box.y), 0xFFFFFFU);
    EXPECT_EQ(canvas.at(x, box.y + box.height - 1), 0xFFFFFFU);
  }
  EXPECT_EQ(canvas.at(box.x + box.width / 2, box.y + box.height / 2), kBlue);
}

TEST_F(Caption, TextIsAlignedAndClipped) {
  const auto touched = [&](TextAlign align) {
    Canvas canvas(300, 60);
    painter_->text(canvas.span(), 150, 40, "HHH", 24, 0xFFFFFF, align);
    return canvas.touched();
  };
  const PixelRect left = touched(TextAlign::kLeft);
  const PixelRect right = touched(TextAlign::kRight);
  const PixelRect centre = touched(TextAlign::kCentre);
  EXPECT_GE(left.x, 150);
  EXPECT_LE(right.x + right.width, 150);
  EXPECT_LE(std::abs(2 * centre.x + centre.width - 300), 3);
  // Capital letters stand on the baseline.
  EXPECT_EQ(left.y + left.height, 40);
  Canvas small(10, 10);
  for (const int x : {-2000000000, -5, 5, 2000000000})
    for (const int y : {-2000000000, 0, 5, 15, 2000000000})
      painter_->text(small.span(), x, y, "HgW", 300, 0xFFFFFF);
}

TEST_F(Caption, WidthIsTheSumOfUnhintedAdvances) {
  // DejaVu Sans: the advance of 'H' is 1540 of 2048 units of the em.
  EXPECT_EQ(painter_->width("H", 400), 301);        // 300.78 rounded up
  EXPECT_EQ(painter_->width("HHHHHHHH", 64), 385);  // 385.0
  EXPECT_EQ(painter_->width("", 64), 0);
}

TEST_F(Caption, NothingIsAllocatedOnceATextHasBeenDrawn) {
  Canvas canvas(320, 180);
  const std::string text = "Where does it hurt? It is a longer sentence that needs an ellipsis at its very end, always";
  painter_->paint(canvas.span(), text);
  allocations = 0;
  counting = true;
  for (int i = 0; i < 10; ++i)
    painter_->paint(canvas.span(), text);
  counting = false;
  EXPECT_EQ(allocations, 0);
}

TEST(CaptionFont, MissingOrBrokenIsSaid) {
  const ScratchFolder folder;
  const auto missing = CaptionPainter::open(folder / "none.ttf");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kNotFound);
  EXPECT_NE(missing.error().message.find("fonts-dejavu-core"), std::string::npos);
  put_bytes(folder / "bad.ttf", "not a font");
  const ScopedVariable font("AUSLANJAM_FONT", (folder / "bad.ttf").c_str());
  const auto broken = CaptionPainter::open();
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().code, ErrorCode::kMalformed);
}

}  // namespace
}  // namespace auslan
