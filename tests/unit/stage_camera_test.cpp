// SPDX-License-Identifier: Apache-2.0
#include "stage/stage.h"

#include <gtest/gtest.h>

namespace auslan {
namespace {

TEST(StageCamera, EveryNameIsRead) {
  for (size_t i = 0; i < std::size(kCameraNames); ++i)
    EXPECT_EQ(camera_from_name(kCameraNames[i]), static_cast<CameraName>(i));
  EXPECT_FALSE(camera_from_name("nosuch"));
  EXPECT_FALSE(camera_from_name(""));
}

TEST(StageCamera, ImpossiblePicturesAreRefused) {
  Figure figure;
  StageOptions options;
  for (const auto& [width, height] : {std::pair(0, 10), std::pair(10, -1), std::pair(16385, 10)}) {
    options.width = width;
    options.height = height;
    const auto stage = Stage::build(figure, options);
    ASSERT_FALSE(stage);
    EXPECT_EQ(stage.error().code, ErrorCode::kUsage);
  }
  options.width = options.height = 16;
  for (const int samples : {0, 3, 16, -1}) {
    options.samples = samples;
    EXPECT_FALSE(Stage::build(figure, options)) << samples;
  }
}

}  // namespace
}  // namespace auslan
