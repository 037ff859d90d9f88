// SPDX-License-Identifier: Apache-2.0
// The dark line round the parts of the body, on the shipped figure: at edges, and nowhere else.
#include "shipped.h"
#include "stage/stage.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace auslan {
namespace {

constexpr int kSide = 320;

int brightness(uint32_t pixel) {
  return static_cast<int>((pixel >> 16 & 255U) + (pixel >> 8 & 255U) + (pixel & 255U));
}

class StageOutline : public ::testing::Test {
 protected:
  StageOutline() {
    PerformanceOptions still;
    still.idle = false;
    const Score score = score_of({"WHERE"});
    Performance(*shipped().signer, score, still).sample(score.glosses.front().end - ticks(0.05), pose_);
    options_.width = options_.height = kSide;
    options_.samples = 1;
    options_.camera = CameraName::kHands;
  }
  std::vector<uint32_t> picture(bool outline) {
    options_.outline = outline;
    Stage stage = Stage::build(shipped().figure, options_).value();
    std::vector<uint32_t> pixels(size_t{kSide} * kSide);
    stage.render(pose_, pixels);
    return pixels;
  }

  Pose pose_;
  StageOptions options_;
};

TEST_F(StageOutline, OnlyDarkensAndOnlyAtEdges) {
  const auto plain = picture(false);
  const auto edged = picture(true);
  int changed = 0;
  int inside = 0;
  for (int y = 2; y < kSide - 2; ++y) {
    for (int x = 2; x < kSide - 2; ++x) {
      const auto at = static_cast<size_t>(y * kSide + x);
      if (plain[at] == edged[at]) continue;
      ++changed;
      EXPECT_LT(brightness(edged[at]), 160) << x << ' ' << y;
      // Where a surface goes on, its colour changes little from pixel to pixel.
      int least = 765;
      int most = 0;
      for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
          const int there = brightness(plain[at + static_cast<size_t>(dy * kSide + dx)]);
          least = std::min(least, there);
          most = std::max(most, there);
        }
      }
      inside += most - least < 12;
    }
  }
  EXPECT_GT(changed, 500);
  EXPECT_LT(inside, changed / 20);
}

TEST_F(StageOutline, NothingIsDrawnAgainWhenNothingMoved) {
  options_.outline = true;
  Stage stage = Stage::build(shipped().figure, options_).value();
  std::vector<uint32_t> pixels(size_t{kSide} * kSide);
  stage.render(pose_, pixels);
  stage.render(pose_, pixels, raster::Canvas::kLastFrame);
  EXPECT_TRUE(stage.damage().empty());
}

}  // namespace
}  // namespace auslan
