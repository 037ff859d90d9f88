// SPDX-License-Identifier: Apache-2.0
// The same bytes everywhere: digests of fixed frames against one committed list, whatever compiled and ran this.
#include "raster_digest.h"
#include "raster_screen.h"

#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace auslan::raster {
namespace {

class RasterDigests : public OnEveryKernel {};
ON_EVERY_KERNEL(RasterDigests);

std::map<std::string, std::string> committed() {
  std::map<std::string, std::string> list;
  std::ifstream file(AUSLANJAM_SOURCE_DIR "/tests/determinism/raster_digests.txt");
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string name;
    std::string value;
    if (words >> name >> value && name[0] != '#') list[name] = value;
  }
  return list;
}

TEST_P(RasterDigests, EveryFrameHasItsCommittedBytes) {
  const std::map<std::string, std::string> list = committed();
  const std::vector<FrameKind> kinds = frame_kinds();
  EXPECT_EQ(list.size(), kinds.size()) << "tests/determinism/raster_digests.txt should name each frame once";
  const TexturedScene scene;
  for (const int threads : {1, 3}) {
    Renderer renderer(threads, GetParam());
    for (const FrameKind& kind : kinds) {
      std::vector<uint32_t> pixels;
      draw_kind(renderer, scene, kind, pixels);
      const auto found = list.find(kind.name());
      EXPECT_TRUE(found != list.end() && found->second == digest(pixels))
          << "the frame changed, or is new. When that is meant, look at it and put this line into "
             "tests/determinism/raster_digests.txt:\n"
          << kind.name() << ' ' << digest(pixels);
    }
  }
}

// Frames that differ have digests that differ, so that equal digests say something.
TEST_P(RasterDigests, DigestTellsOnePixelApart) {
  const Scene scene;
  Renderer renderer(1, GetParam());
  std::vector<uint32_t> pixels;
  draw_scene(renderer, scene, 320, 180, 1, Shading::kFlat, pixels);
  const std::string before = digest(pixels);
  pixels[pixels.size() / 2] ^= 1U;
  EXPECT_NE(digest(pixels), before);
}

TEST_P(RasterDigests, DrawingTwiceGivesTheSameBytes) {
  const Scene scene;
  Renderer warm(1, GetParam());
  std::vector<uint32_t> first;
  std::vector<uint32_t> between;
  std::vector<uint32_t> second;
  std::vector<uint32_t> fresh;
  for (const int samples : {1, 2, 4, 8}) {
    draw_scene(warm, scene, 320, 180, samples, Shading::kGouraud, first);
    draw_scene(warm, scene, 77, 301, samples == 1 ? 8 : 1, Shading::kFlat, between);
    draw_scene(warm, scene, 320, 180, samples, Shading::kGouraud, second);
    EXPECT_EQ(first, second) << samples;
    Renderer cold(1, GetParam());
    draw_scene(cold, scene, 320, 180, samples, Shading::kGouraud, fresh);
    EXPECT_EQ(first, fresh) << samples;
  }
}

// The tiles that a frame is filled in leave no seam: a frame's middle looks the same wherever their borders fall.
// Moving the picture by whole pixels moves it exactly, because the grid of 1/256 pixel moves with it.
TEST_P(RasterDigests, TilesLeaveNoSeam) {
  Random random(91);
  std::vector<Triangle> triangles;
  for (int i = 0; i < 60; ++i) {
    Triangle t;
    for (Point& p : t)
      p = {random.between(0, 64 * 256), random.between(0, 64 * 256)};
    triangles.push_back(t);
  }
  for (const int samples : {1, 4}) {
    constexpr int kShiftX = 11;
    constexpr int kShiftY = 7;
    Screen still(128, 128, samples);
    Screen moved(128, 128, samples);
    for (size_t i = 0; i < triangles.size(); ++i) {
      const auto red = static_cast<uint8_t>(i * 4);
      Triangle t = triangles[i];
      for (Point& p : t)
        p = {p.x + 32 * 256, p.y + 32 * 256};
      still.add(t, glm::u8vec4(red, 255, 9, 255), 0.25F + 0.01F * static_cast<float>(i));
      for (Point& p : t)
        p = {p.x + kShiftX * 256, p.y + kShiftY * 256};
      moved.add(t, glm::u8vec4(red, 255, 9, 255), 0.25F + 0.01F * static_cast<float>(i));
    }
    still.end();
    moved.end();
    for (int row = 0; row + kShiftY < 128; ++row) {
      for (int column = 0; column + kShiftX < 128; ++column) {
        ASSERT_EQ(still.pixel(column, row), moved.pixel(column + kShiftX, row + kShiftY)) << column << ", " << row;
      }
    }
  }
}

}  // namespace
}  // namespace auslan::raster
