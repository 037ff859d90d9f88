// SPDX-License-Identifier: Apache-2.0
// The harness that judges pictures is itself judged: it has to fail where it should.
#include "golden.h"
#include "media/picture.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

namespace auslan {
namespace {

namespace fs = std::filesystem;

class GoldenHarness : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(::testing::TempDir()) /
            (std::string("golden_harness_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(root_);
    fs::create_directories(root_ / "golden");
    folders_ = {(root_ / "golden").string(), (root_ / "kept").string()};
  }
  void TearDown() override { fs::remove_all(root_); }

  /// Sixteen by nine pixels in which no two are alike.
  static Picture drawing() {
    Picture picture = make_picture(16, 9);
    for (size_t i = 0; i < picture.pixels.size(); ++i) {
      picture.pixels[i] = static_cast<uint32_t>(i * 0x010203U + 0x202020U);
    }
    return picture;
  }
  void accept(const Picture& picture) {
    ASSERT_TRUE(write_png(folders_.golden + "/drawing.png", picture.view()).has_value());
  }
  bool is_kept(const std::string& kind) const { return fs::exists(folders_.kept + "/drawing." + kind + ".png"); }
  ::testing::AssertionResult judge(const Picture& picture) const {
    return matches_golden(picture.view(), "drawing", folders_);
  }

  fs::path root_;
  GoldenFolders folders_;
};

TEST_F(GoldenHarness, EqualPicturePasses) {
  accept(drawing());
  const auto verdict = judge(drawing());
  EXPECT_TRUE(verdict) << verdict.message();
  EXPECT_FALSE(is_kept("actual"));
}

TEST_F(GoldenHarness, MissingGoldenFailsAndLeavesACandidateOnly) {
  const auto verdict = judge(drawing());
  EXPECT_FALSE(verdict);
  EXPECT_NE(std::string(verdict.message()).find("tests/golden/accept drawing"), std::string::npos) << verdict.message();
  ASSERT_TRUE(is_kept("candidate"));
  EXPECT_FALSE(is_kept("actual"));
  EXPECT_TRUE(fs::is_empty(folders_.golden)) << "the harness accepted a picture by itself";
  const auto candidate = read_png(folders_.kept + "/drawing.candidate.png");
  ASSERT_TRUE(candidate.has_value());
  EXPECT_EQ(candidate->pixels, drawing().pixels);
  EXPECT_FALSE(judge(drawing())) << "a candidate must not count as accepted on the second run";
}

TEST_F(GoldenHarness, OnePixelOneLevelOffFailsAndIsNamed) {
  accept(drawing());
  for (const uint32_t one_level : {0x010000U, 0x000100U, 0x000001U}) {
    Picture changed = drawing();
    changed.pixels[5 * 16 + 11] += one_level;
    const auto verdict = judge(changed);
    EXPECT_FALSE(verdict);
    const std::string message = verdict.message();
    EXPECT_NE(message.find("x 11"), std::string::npos) << message;
    EXPECT_NE(message.find("y 5"), std::string::npos) << message;
    ASSERT_TRUE(is_kept("actual") && is_kept("expected") && is_kept("difference"));
    EXPECT_FALSE(is_kept("candidate"));
    EXPECT_EQ(read_png(folders_.kept + "/drawing.actual.png")->pixels, changed.pixels);
    EXPECT_EQ(read_png(folders_.kept + "/drawing.expected.png")->pixels, drawing().pixels);
    EXPECT_EQ(read_png(folders_.golden + "/drawing.png")->pixels, drawing().pixels) << "the golden picture changed";
  }
}

TEST_F(GoldenHarness, CornersCount) {
  accept(drawing());
  for (const size_t corner : {size_t{0}, size_t{15}, size_t{8 * 16}, size_t{9 * 16 - 1}}) {
    Picture changed = drawing();
    changed.pixels[corner] ^= 1U;
    EXPECT_FALSE(judge(changed)) << corner;
  }
}

TEST_F(GoldenHarness, OtherSizeFailsEvenWithTheSamePixels) {
  accept(drawing());
  Picture turned = drawing();
  turned.width = 9;
  turned.height = 16;
  EXPECT_FALSE(judge(turned));
  EXPECT_TRUE(is_kept("actual") && is_kept("expected"));
  EXPECT_FALSE(is_kept("difference"));
}

TEST_F(GoldenHarness, DamagedGoldenFails) {
  std::ofstream(folders_.golden + "/drawing.png") << "this is not a picture";
  EXPECT_FALSE(judge(drawing()));
  EXPECT_TRUE(is_kept("actual"));
}

TEST_F(GoldenHarness, PassingClearsWhatAnEarlierFailureKept) {
  accept(drawing());
  Picture changed = drawing();
  changed.pixels[0] ^= 1U;
  EXPECT_FALSE(judge(changed));
  EXPECT_TRUE(is_kept("actual"));
  EXPECT_TRUE(judge(drawing()));
  EXPECT_FALSE(is_kept("actual") || is_kept("expected") || is_kept("difference"));
}

TEST_F(GoldenHarness, NameCannotLeaveTheFolder) {
  EXPECT_FALSE(matches_golden(drawing().view(), "../drawing", folders_));
  EXPECT_FALSE(matches_golden(drawing().view(), "", folders_));
}

}  // namespace
}  // namespace auslan
