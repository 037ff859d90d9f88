// SPDX-License-Identifier: Apache-2.0
// A foreign figure on the stage: the same pixels from every kernel and number of threads, no memory after the first
// frame, its images on its skin, all of its head in the picture.
#include "box_avatar.h"
#include "counted_memory.h"
#include "kinematics/avatar_model.h"
#include "stage/stage.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <optional>
#include <vector>

namespace auslan {
namespace {

constexpr int kWidth = 160, kHeight = 120;
constexpr uint32_t kBackground = 0x00FF00;

/// A red and blue checkerboard of four texels, the lower right one clear.
std::optional<raster::Texture> checkers() {
  const std::array<glm::u8vec4, 4> texels = {glm::u8vec4(255, 0, 0, 255), glm::u8vec4(0, 0, 255, 255),
                                             glm::u8vec4(0, 0, 255, 255), glm::u8vec4(255, 0, 0, 0)};
  return raster::Texture::from_srgb(2, 2, texels);
}

Avatar dressed(const test::BoxAvatar& wanted) {
  Avatar avatar = test::box_avatar(wanted);
  AvatarVertices& vertices = avatar.meshes[0].vertices[0];
  for (const glm::vec3& position : vertices.positions)
    vertices.texture_coordinates.emplace_back(position.x * 5.0F, position.y * 5.0F);
  AvatarSurface& surface = avatar.meshes[0].surfaces[0];
  surface.base_colour = glm::vec4(1.0F);
  surface.image = 0;
  surface.alpha_cutoff = 0.5F;
  surface.is_double_sided = true;
  avatar.images.emplace_back();
  return avatar;
}

Pose waving(const Skeleton& skeleton, double angle) {
  Pose pose = rest_pose(skeleton);
  const auto turn = [&](std::string_view name, const Vec3& axis, double radians) {
    pose.rotation[static_cast<size_t>(skeleton.find(name))] = axis_angle(axis, radians);
  };
  turn("shoulder_l", Vec3(0.0, 0.0, 1.0), -1.2);
  turn("shoulder_r", Vec3(0.0, 0.6, 0.8), 0.4 + angle);
  turn("elbow_r", Vec3(0.8, 0.6, 0.0), 1.3);
  turn("head_base", Vec3(0.0, 1.0, 0.0), angle);
  pose.face[static_cast<size_t>(FaceChannel::kJawOpen)] = static_cast<float>(angle);
  return pose;
}

StageOptions small(raster::Kernel kernel, int threads) {
  StageOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.threads = threads;
  options.kernel = kernel;
  options.background = kBackground;
  return options;
}

class AvatarStage : public testing::Test {
 protected:
  Stage stage(raster::Kernel kernel, int threads, Textures textures) const {
    return Stage::build(avatar_.figure, make_avatar_model(avatar_), textures, small(kernel, threads)).value();
  }
  std::vector<uint32_t> drawn(Stage& stage, double angle) const {
    std::vector<uint32_t> pixels(size_t{kWidth} * kHeight);
    stage.render(waving(avatar_.figure.skeleton, angle), pixels);
    return pixels;
  }

  const SigningAvatar avatar_ = fit_avatar(dressed({.arms_below = 0.8, .yaw = kPi, .scale = 0.2})).value();
  const std::array<std::optional<raster::Texture>, 1> textures_ = {checkers()};
};

TEST_F(AvatarStage, EveryKernelAndNumberOfThreadsDrawsTheSamePixels) {
  Stage first = stage(raster::Kernel::kScalar, 1, textures_);
  for (const double angle : {0.0, 0.5}) {
    const std::vector<uint32_t> wanted = drawn(first, angle);
    EXPECT_GT(std::ranges::count_if(wanted, [](uint32_t pixel) { return pixel != kBackground; }), 1000);
    for (const raster::Kernel kernel : raster::runnable_kernels())
      for (const int threads : {1, 3}) {
        Stage other = stage(kernel, threads, textures_);
        EXPECT_EQ(drawn(other, angle), wanted) << raster::name_of(kernel) << ' ' << threads;
      }
  }
}

TEST_F(AvatarStage, OnlyWhatChangedIsDrawnAndItIsTheSame) {
  Stage whole = stage(raster::Kernel::kScalar, 1, textures_);
  Stage kept = stage(raster::Kernel::kScalar, 1, textures_);
  std::vector<uint32_t> pixels = drawn(kept, 0.0);
  for (const double angle : {0.2, 0.2, 0.4}) {
    kept.render(waving(avatar_.figure.skeleton, angle), pixels, raster::Canvas::kLastFrame);
    EXPECT_EQ(pixels, drawn(whole, angle)) << angle;
  }
}

TEST_F(AvatarStage, TheFirstFrameTakesAllTheMemory) {
  Stage one = stage(raster::Kernel::kScalar, 1, textures_);
  std::vector<uint32_t> pixels = drawn(one, 0.3);
  const Pose pose = waving(avatar_.figure.skeleton, 0.6);
  one.render(pose, pixels);
  test::peak_bytes = test::live_bytes.load();
  one.render(waving(avatar_.figure.skeleton, 0.6), pixels);
  const Pose other = waving(avatar_.figure.skeleton, 0.4);
  const size_t before = test::live_bytes;
  test::peak_bytes = before;
  one.render(other, pixels);
  EXPECT_EQ(test::peak_bytes, before);
}

TEST_F(AvatarStage, ImagesColourTheSkinAndCutHolesIntoIt) {
  const std::array<glm::u8vec4, 1> white = {glm::u8vec4(255, 255, 255, 255)};
  const std::array<std::optional<raster::Texture>, 1> whole = {raster::Texture::from_srgb(1, 1, white)};
  Stage plain = stage(raster::Kernel::kScalar, 1, whole);
  Stage worn = stage(raster::Kernel::kScalar, 1, textures_);
  const std::vector<uint32_t> bare = drawn(plain, 0.0);
  const std::vector<uint32_t> pixels = drawn(worn, 0.0);
  const auto count = [](const std::vector<uint32_t>& of, auto is) { return std::ranges::count_if(of, is); };
  const auto is_red = [](uint32_t p) { return raster::red_of(p) > raster::blue_of(p) + 60; };
  const auto is_blue = [](uint32_t p) { return raster::blue_of(p) > raster::red_of(p) + 60; };
  EXPECT_EQ(count(bare, is_red) + count(bare, is_blue), 0);
  EXPECT_GT(count(pixels, is_red), 50);
  EXPECT_GT(count(pixels, is_blue), 50);
  // Through a quarter of every surface what is behind it shows.
  const auto is_empty = [](uint32_t p) { return p == kBackground; };
  EXPECT_GT(count(pixels, is_empty), count(bare, is_empty) + 50);
}

TEST_F(AvatarStage, WhatAnImageWouldCutOutIsNotDrawnWithoutIt) {
  Stage bare = stage(raster::Kernel::kScalar, 1, {});
  const std::vector<uint32_t> pixels = drawn(bare, 0.0);
  EXPECT_TRUE(std::ranges::all_of(pixels, [](uint32_t pixel) { return pixel == kBackground; }));
}

TEST(AvatarCamera, AHeadAsTallAsTheTrunkIsInThePicture) {
  Avatar source = test::box_avatar();
  const Vec3 head = test::measured_skeleton().rest_position(2);
  test::add_box(source.meshes[0].vertices[0], source.meshes[0].surfaces[0], head - Vec3(0.2, 0.0, 0.2),
                head + Vec3(0.2, 0.6, 0.2), 2);
  const SigningAvatar avatar = fit_avatar(std::move(source)).value();
  for (const CameraName camera :
       {CameraName::kFront, CameraName::kThreeQuarter, CameraName::kSide, CameraName::kFace}) {
    StageOptions options = small(raster::Kernel::kScalar, 1);
    options.camera = camera;
    Stage stage = Stage::build(avatar.figure, make_avatar_model(avatar), {}, options).value();
    std::vector<uint32_t> pixels(size_t{kWidth} * kHeight);
    stage.render(rest_pose(avatar.figure.skeleton), pixels);
    const auto is_drawn = [](uint32_t pixel) { return pixel != kBackground; };
    EXPECT_TRUE(std::none_of(pixels.begin(), pixels.begin() + 2 * kWidth, is_drawn)) << static_cast<int>(camera);
    EXPECT_TRUE(std::any_of(pixels.begin(), pixels.begin() + kWidth * kHeight / 4, is_drawn))
        << static_cast<int>(camera);
  }
}

}  // namespace
}  // namespace auslan
