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
