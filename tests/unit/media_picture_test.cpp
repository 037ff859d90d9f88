// SPDX-License-Identifier: Apache-2.0
#include "media/picture.h"
#include "media/picture_module.h"
#include "scratch_folder.h"

#include <gtest/gtest.h>

// libpng leaves OpenImageIO's reader by longjmp when a file is cut short, past the destructor of one string.
// Named by library, because functions have names only where a symbolizer is installed.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOpenImageIO.so";
}

namespace auslan {
namespace {

using Names = std::vector<std::string>;

Picture gradient(int width, int height) {
  Picture picture = make_picture(width, height);
  for (size_t i = 0; i < picture.pixels.size(); ++i)
    picture.pixels[i] = static_cast<uint32_t>(i * 2654435761U >> 4) & 0xFFFFFF;
  return picture;
}

// First in this file: the module is loaded once in a process, so its absence must be tried before.
TEST(APictureModule, ThatIsMissingIsSaidWithThePackage) {
  const ScratchFolder folder;
  const ScopedVariable modules("AUSLANJAM_MODULE_DIR", (folder / "").c_str());
  const auto written = write_png(folder / "a.png", gradient(4, 4).view());
  // When another test of this process has loaded it already, there is nothing to see.
  if (written) GTEST_SKIP() << "the module is loaded already";
  EXPECT_EQ(written.error().code, ErrorCode::kUnsupported);
  EXPECT_NE(written.error().message.find("apt install libopenimageio"), std::string::npos) << written.error().message;
  EXPECT_EQ(folder.contents(), Names{});
}

class PictureFile : public testing::Test {
 protected:
  void SetUp() override {
    if (!load_picture_module()) GTEST_SKIP() << "no picture module";
  }
  ScratchFolder folder_;
};

TEST_F(PictureFile, ReadsBackExactly) {
  const Picture picture = gradient(37, 23);
  ASSERT_TRUE(write_png(folder_ / "a.png", picture.view()));
  const auto read = read_png(folder_ / "a.png");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->width, 37);
  EXPECT_EQ(read->height, 23);
  EXPECT_EQ(read->pixels, picture.pixels);
}

TEST_F(PictureFile, TheSamePixelsGiveTheSameBytesWithoutDateOrProgram) {
  ASSERT_TRUE(write_png(folder_ / "a.png", gradient(64, 64).view()));
  ASSERT_TRUE(write_png(folder_ / "b.png", gradient(64, 64).view()));
  const std::string bytes = bytes_of(folder_ / "a.png");
  EXPECT_EQ(bytes, bytes_of(folder_ / "b.png"));
  EXPECT_EQ(bytes.find("tIME"), std::string::npos);
  EXPECT_EQ(bytes.find("Software"), std::string::npos);
  EXPECT_EQ(bytes.find("DateTime"), std::string::npos);
}

TEST_F(PictureFile, BadFilesAreRefused) {
  EXPECT_EQ(read_png(folder_ / "none.png").error().code, ErrorCode::kNotFound);
  EXPECT_EQ(read_png(folder_ / "").error().code, ErrorCode::kUnreadable);
  put_bytes(folder_ / "text.png", "this is not a picture");
  EXPECT_EQ(read_png(folder_ / "text.png").error().code, ErrorCode::kMalformed);
  ASSERT_TRUE(write_png(folder_ / "a.png", gradient(64, 64).view()));
  put_bytes(folder_ / "cut.png", bytes_of(folder_ / "a.png").substr(0, 200));
  const auto cut = read_png(folder_ / "cut.png");
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().code, ErrorCode::kMalformed);
}

TEST_F(PictureFile, AnUnwritablePlaceLeavesNothing) {
  const auto written = write_png(folder_ / "none/a.png", gradient(4, 4).view());
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kUnwritable);
  EXPECT_EQ(folder_.contents(), Names{});
  const std::vector<uint32_t> three(3);
  EXPECT_EQ(write_png(folder_ / "b.png", {three, 2, 2}).error().code, ErrorCode::kUsage);
}

/// A PNG of 8-bit RGBA, rows as they are: its data is stored, not compressed.
std::string rgba_png(uint32_t width, uint32_t height, const std::string& pixels) {
  const auto big_endian = [](uint32_t value) {
    return std::string{static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
                       static_cast<char>(value)};
  };
  const auto chunk = [&](const std::string& type, const std::string& data) {
    uint32_t crc = 0xFFFFFFFF;
    for (const char c : type + data) {
      crc ^= static_cast<unsigned char>(c);
      for (int bit = 0; bit < 8; ++bit)
        crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320U : 0U);
    }
    return big_endian(static_cast<uint32_t>(data.size())) + type + data + big_endian(~crc);
  };
  std::string rows;
  for (size_t y = 0; y < height; ++y)
    rows += std::string(1, '\0') + pixels.substr(4 * width * y, size_t{4} * width);
  uint32_t a = 1, b = 0;
  for (const char c : rows) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto length = static_cast<uint16_t>(rows.size());
  const std::string stored = {'\x78',
                              '\x01',
                              '\x01',
                              static_cast<char>(length),
                              static_cast<char>(length >> 8),
                              static_cast<char>(~length),
                              static_cast<char>(~length >> 8)};
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", big_endian(width) + big_endian(height) + std::string("\x08\x06\0\0\0", 5)) +
         chunk("IDAT", stored + rows + big_endian(b << 16 | a)) + chunk("IEND", "");
}

Result<Picture> decoded(const std::string& bytes, ImageFormat format, size_t max_pixels = 100) {
  return decode_image(std::span(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()), format, max_pixels,
                      "image");
}

TEST_F(PictureFile, AnImageKeepsItsColoursWhereItIsClear) {
  const auto image = decoded(rgba_png(2, 1, std::string("\x10\x20\x30\x00\xFF\x80\x40\x7F", 8)), ImageFormat::kPng);
  ASSERT_TRUE(image) << to_string(image.error());
  EXPECT_EQ(image->width, 2);
  EXPECT_EQ(image->height, 1);
  EXPECT_EQ(image->pixels, (std::vector<uint32_t>{0x00102030, 0x7FFF8040}));
}

TEST_F(PictureFile, AnImageThatIsTooLargeOrBrokenIsRefused) {
  const std::string png = rgba_png(4, 4, std::string(64, '\x55'));
  EXPECT_TRUE(decoded(png, ImageFormat::kPng, 16));
  EXPECT_EQ(decoded(png, ImageFormat::kPng, 15).error().code, ErrorCode::kLimit);
  EXPECT_FALSE(decoded(png, ImageFormat::kJpeg));
  EXPECT_FALSE(decoded(png.substr(0, png.size() / 2), ImageFormat::kPng));
  EXPECT_FALSE(decoded("", ImageFormat::kPng));
  EXPECT_FALSE(decoded("\xFF\xD8\xFF\xE0 no more", ImageFormat::kJpeg));
}

TEST(Compare, NamesTheWorstPixelAndCountsThem) {
  const Picture expected = make_picture(5, 4, 0x101010);
  Picture actual = expected;
  actual.pixels[7] = 0x101012;   // (2, 1), by 2
  actual.pixels[13] = 0x103010;  // (3, 2), by 32
  actual.pixels[18] = 0x301010;  // (3, 3), by 32 as well, later
  const Comparison result = compare(expected.view(), actual.view());
  EXPECT_FALSE(result.equal());
  EXPECT_EQ(result.differing, 3);
  EXPECT_EQ(result.worst_x, 3);
  EXPECT_EQ(result.worst_y, 2);
  EXPECT_EQ(result.worst_difference, 32);
  EXPECT_EQ(result.expected, 0x101010U);
  EXPECT_EQ(result.actual, 0x103010U);
  EXPECT_EQ(to_string(result), "3 pixels differ; worst at (x 3, y 2): expected #101010, actual #103010");
  const Picture shown = difference_image(expected.view(), actual.view());
  EXPECT_EQ(shown.pixels[0], 0x050505U);
  EXPECT_EQ(shown.pixels[7], 0x810000U);
  EXPECT_EQ(shown.pixels[13], 0x900000U);
}

TEST(Compare, OtherSizesAreNotEqual) {
  EXPECT_FALSE(compare(make_picture(4, 2).view(), make_picture(2, 4).view()).equal());
  EXPECT_FALSE(compare(make_picture(4, 2).view(), {}).equal());
  EXPECT_TRUE(compare(make_picture(4, 2).view(), make_picture(4, 2).view()).equal());
}

}  // namespace
}  // namespace auslan
