// SPDX-License-Identifier: Apache-2.0
// What a camera shows of the shipped figure while it signs: signs are read from hands, so that hands must be in the
// picture.
#include "kinematics/anatomy.h"
#include "shipped.h"
#include "stage/stage.h"

#include <cmath>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace auslan {
namespace {

struct Shape {
  const char* name;
  float aspect;
};

class StageFraming : public ::testing::TestWithParam<CameraName> {};

TEST_P(StageFraming, ShowsEveryFingerOfSignsOfTwoHandsBeforeTheBody) {
  const Figure& figure = shipped().figure;
  const Skeleton& skeleton = figure.skeleton;
  PerformanceOptions still;
  still.idle = false;
  for (const char* gloss : {"WHERE", "HELP", "DOCTOR", "WORK"}) {
    const Score score = score_of({gloss});
    Pose pose;
    Performance(*shipped().signer, score, still).sample(score.glosses.front().end - ticks(0.05), pose);
    std::vector<Transform> world(static_cast<size_t>(skeleton.size()));
    forward(skeleton, pose, world);
    for (const Shape& shape : {Shape{"1280x720", 16.0F / 9.0F}, Shape{"800x480", 5.0F / 3.0F}}) {
      const raster::Camera camera = stage_camera(figure, GetParam(), shape.aspect);
      for (const Side side : {Side::kLeft, Side::kRight}) {
        for (const auto& digit : arm_nodes(skeleton, side).digits) {
          const glm::vec3 last(world[static_cast<size_t>(digit[2])].position);
          const glm::vec4 clip = camera.clip_from_view * camera.view_from_world * glm::vec4(last, 1.0F);
          const std::string what = std::string(gloss) + ' ' + skeleton.node(digit[2]).name + ' ' + shape.name;
          ASSERT_GT(clip.w, 0.0F) << what;
          EXPECT_LT(std::abs(clip.x), clip.w) << what;
          EXPECT_LT(std::abs(clip.y), clip.w) << what;
        }
      }
    }
  }
}

std::string camera_label(const ::testing::TestParamInfo<CameraName>& camera) {
  std::string name(kCameraNames[static_cast<size_t>(camera.param)]);
  std::erase(name, '-');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Cameras, StageFraming,
                         ::testing::Values(CameraName::kFront, CameraName::kThreeQuarter, CameraName::kSide,
                                           CameraName::kSigner, CameraName::kHands),
                         camera_label);

}  // namespace
}  // namespace auslan
