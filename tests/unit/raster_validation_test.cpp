// SPDX-License-Identifier: Apache-2.0
// What hostile input does: it is counted, never drawn, and never takes the program down.
#include "raster_screen.h"

#include <cmath>
#include <limits>

namespace auslan::raster {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kHuge = std::numeric_limits<float>::max();

class Validation : public OnEveryKernel {};
ON_EVERY_KERNEL(Validation);

// A square over the middle of the frame and, at vertices 4 to 6, a triangle that covers all of it.
struct Scene {
  std::vector<glm::vec3> positions = {glm::vec3(-0.5F, -0.5F, 0.5F), glm::vec3(0.5F, -0.5F, 0.5F),
                                      glm::vec3(0.5F, 0.5F, 0.5F),   glm::vec3(-0.5F, 0.5F, 0.5F),
                                      glm::vec3(-4.0F, -4.0F, 0.9F), glm::vec3(4.0F, -4.0F, 0.9F),
                                      glm::vec3(0.0F, 8.0F, 0.9F)};
  std::vector<glm::vec3> normals = std::vector<glm::vec3>(7, glm::vec3(0.0F, 0.0F, 1.0F));
  std::vector<glm::u8vec4> colours = std::vector<glm::u8vec4>(7, glm::u8vec4(255));
  std::vector<uint32_t> indices = {0, 1, 2, 0, 2, 3};

  MeshView view() const { return MeshView{positions, normals, colours, indices}; }
};

size_t lit(const Screen& screen) {
  size_t count = 0;
  for (const uint32_t pixel : screen.pixels)
    count += pixel != 0U ? 1U : 0U;
  return count;
}

void expect(Screen& screen, const Scene& scene, uint64_t rejected, uint64_t drawn, size_t pixels,
            const glm::mat4& world = glm::mat4(1.0F)) {
  for (const Shading shading : {Shading::kGouraud, Shading::kFlat}) {
    screen.begin();
    screen.renderer.draw(scene.view(), world, shading);
    screen.end();
    EXPECT_EQ(screen.renderer.stats().rejected, rejected);
    EXPECT_EQ(screen.renderer.stats().drawn, drawn);
    EXPECT_EQ(lit(screen), pixels);
  }
}

TEST_P(Validation, TheSceneItselfIsDrawn) {
  Screen screen(16, 16);
  Scene scene;
  expect(screen, scene, 0, 2, 64);
  scene.indices.insert(scene.indices.end(), {4, 5, 6});
  expect(screen, scene, 0, 3, 256);
}

TEST_P(Validation, IndexOutOfRangeRejectsThatTriangleOnly) {
  Screen screen(16, 16);
  for (const uint32_t bad : {7U, 8U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU}) {
    Scene scene;
    scene.indices.insert(scene.indices.end(), {4, 5, bad, bad, 5, 6, 4, bad, 6});
    expect(screen, scene, 3, 2, 64);
  }
}

TEST_P(Validation, PositionsThatAreNotFiniteRejectTheirTriangles) {
  Screen screen(16, 16);
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (int component = 0; component < 3; ++component) {
      Scene scene;
      scene.indices.insert(scene.indices.end(), {4, 5, 6});
      scene.positions[6][component] = bad;
      expect(screen, scene, 1, 2, 64);
    }
  }
}

TEST_P(Validation, PositionsThatOverflowTheTransformAreRejected) {
  Screen screen(16, 16);
  Scene scene;
  scene.indices.insert(scene.indices.end(), {4, 5, 6});
  scene.positions[6].y = kHuge;
  glm::mat4 world(1.0F);
  world[0][0] = world[1][1] = 2.0F;
  expect(screen, scene, 1, 2, 256, world);
}

TEST_P(Validation, NormalsThatAreNotFiniteRejectWhereTheyAreUsed) {
  Screen screen(16, 16);
  Scene scene;
  scene.normals[1].y = kNan;
  screen.renderer.draw(scene.view(), glm::mat4(1.0F), Shading::kGouraud);
  screen.end();
  EXPECT_EQ(screen.renderer.stats().rejected, 1U);
  EXPECT_EQ(screen.renderer.stats().drawn, 1U);
  screen.begin();
  screen.renderer.draw(scene.view(), glm::mat4(1.0F), Shading::kFlat);
  screen.end();
  EXPECT_EQ(screen.renderer.stats().rejected, 0U);
  EXPECT_EQ(screen.renderer.stats().drawn, 2U);
}

TEST_P(Validation, MatrixThatIsNotFiniteRejectsTheDraw) {
  Screen screen(16, 16);
  const Scene scene;
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (int element = 0; element < 16; ++element) {
      glm::mat4 world(1.0F);
      world[element / 4][element % 4] = bad;
      expect(screen, scene, 2, 0, 0, world);
    }
  }
}

TEST_P(Validation, CameraThatIsNotFiniteRejectsTheDraw) {
  Screen screen(16, 16);
  const Scene scene;
  const glm::vec3 eye(0.0F, 0.0F, 2.0F);
  const glm::vec3 up(0.0F, 1.0F, 0.0F);
  const Camera cameras[] = {look_at(glm::vec3(kNan), glm::vec3(0.0F), up, 1.0F, 1.0F, 0.1F),
                            look_at(eye, glm::vec3(0.0F), up, 0.0F, 1.0F, 0.1F),
                            look_at(eye, glm::vec3(0.0F), up, 1.0F, -1.0F, 0.1F),
                            look_at(eye, glm::vec3(0.0F), up, 1.0F, 1.0F, kInfinity),
                            look_at_parallel(eye, glm::vec3(0.0F), up, 1.0F, 1.0F, 2.0F, 2.0F)};
  for (const Camera& camera : cameras) {
    screen.begin();
    screen.renderer.set_camera(camera);
    screen.renderer.draw(scene.view(), glm::mat4(1.0F), Shading::kFlat);
    screen.end();
    EXPECT_EQ(screen.renderer.stats().rejected, 2U);
    EXPECT_EQ(lit(screen), 0U);
  }
}

TEST_P(Validation, ArraysOfOtherLengthsRejectTheDraw) {
  Screen screen(16, 16);
  Scene scene;
  scene.colours.pop_back();
  expect(screen, scene, 2, 0, 0);
  scene = Scene{};
  scene.colours.clear();
  expect(screen, scene, 2, 0, 0);
  scene = Scene{};
  scene.normals.pop_back();
  expect(screen, scene, 2, 0, 0);
  scene = Scene{};
  scene.normals.clear();  // fine without them where they are not used
  screen.begin();
  screen.renderer.draw(scene.view(), glm::mat4(1.0F), Shading::kFlat);
  screen.end();
  EXPECT_EQ(screen.renderer.stats().rejected, 0U);
  EXPECT_EQ(lit(screen), 64U);
}

TEST_P(Validation, LeftOverIndicesCountAsOneRejectedTriangle) {
  Screen screen(16, 16);
  Scene scene;
  scene.indices.push_back(4);
  expect(screen, scene, 1, 2, 64);
  scene.indices.push_back(5);
  expect(screen, scene, 1, 2, 64);
}

TEST_P(Validation, EmptyDrawsDoNothing) {
  Screen screen(16, 16);
  screen.renderer.draw(MeshView{}, glm::mat4(1.0F), Shading::kGouraud);
  screen.end();
  EXPECT_EQ(screen.renderer.stats().submitted, 0U);
  EXPECT_EQ(lit(screen), 0U);
}

TEST_P(Validation, PlacementsWithoutVolumeAreHarmless) {
  Screen screen(16, 16);
  const Scene scene;
  expect(screen, scene, 0, 0, 0, glm::mat4(0.0F));
  glm::mat4 flat(1.0F);
  flat[3][2] = 0.5F;
  flat[2][2] = 0.0F;  // a shadow of itself: still seen from the front
  expect(screen, scene, 0, 2, 64, flat);
}

TEST_P(Validation, LightsThatAreNotFiniteAreDark) {
  Screen screen(16, 16);
  const Scene scene;
  Lighting lighting;
  lighting.key_direction = glm::vec3(kNan);
  lighting.key_colour = glm::vec3(1.0F);
  lighting.fill_direction = glm::vec3(0.0F);
  lighting.fill_colour = glm::vec3(kInfinity);
  lighting.rim_direction = glm::vec3(0.0F, kNan, 1.0F);
  lighting.rim_colour = glm::vec3(1.0F);
  lighting.ambient_sky = glm::vec3(-1.0F);
  lighting.ambient_ground = glm::vec3(kNan);
  for (const Shading shading : {Shading::kGouraud, Shading::kFlat}) {
    screen.begin(0x00FF00U);
    screen.renderer.set_lighting(lighting);
    screen.renderer.draw(scene.view(), glm::mat4(1.0F), shading);
    screen.end();
    EXPECT_EQ(screen.pixel(8, 8), 0U);
    EXPECT_EQ(screen.pixel(0, 0), 0x00FF00U);
  }
}

TEST_P(Validation, FrameSizesAndSamplesOutsideTheLimitsAreRefused) {
  Renderer renderer(1, GetParam());
  const int bad_sizes[] = {0, -1, kMaxImageSize + 1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
  for (const int bad : bad_sizes) {
    EXPECT_EQ(renderer.begin_frame(bad, 16, 1, 0), Status::kBadSize);
    EXPECT_EQ(renderer.begin_frame(16, bad, 1, 0), Status::kBadSize);
  }
  for (const int bad : {0, -1, 3, 5, 6, 7, 9, 16}) {
    EXPECT_EQ(renderer.begin_frame(16, 16, bad, 0), Status::kBadSamples);
  }
  std::vector<uint32_t> pixels(256, 7);
  EXPECT_EQ(renderer.end_frame(pixels), Status::kNoFrame);
  EXPECT_EQ(pixels[0], 7U);
  EXPECT_EQ(renderer.begin_frame(kMaxImageSize, kMaxImageSize, 8, 0), Status::kOk);
  EXPECT_EQ(renderer.begin_frame(16, 16, 1, 0xFF010203U), Status::kOk);
  EXPECT_EQ(renderer.end_frame(std::span(pixels).first(255)), Status::kBadSize);
  EXPECT_EQ(renderer.end_frame({}), Status::kBadSize);
  EXPECT_EQ(pixels[0], 7U);
  EXPECT_EQ(renderer.end_frame(pixels), Status::kOk);
  EXPECT_EQ(pixels[0], 0x010203U);
  EXPECT_EQ(renderer.end_frame(pixels), Status::kNoFrame);
}

TEST_P(Validation, DrawOutsideAFrameDoesNothing) {
  Renderer renderer(1, GetParam());
  const Scene scene;
  renderer.draw(scene.view(), glm::mat4(1.0F), Shading::kFlat);
  EXPECT_EQ(renderer.stats().submitted, 0U);
}

}  // namespace
}  // namespace auslan::raster
