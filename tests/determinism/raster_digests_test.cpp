// SPDX-License-Identifier: Apache-2.0
// The same bytes everywhere: digests of fixed frames against one committed list, whatever compiled and ran this.
#include "raster_scene.h"

#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace auslan::raster {
namespace {

// FNV-1a, 64 bits, over the bytes of the pixels from low to high.
std::string digest(const std::vector<uint32_t>& pixels) {
  uint64_t hash = 0xCBF29CE484222325ULL;
  for (const uint32_t pixel : pixels) {
    for (uint32_t shift = 0; shift < 32; shift += 8)
      hash = (hash ^ ((pixel >> shift) & 255U)) * 0x100000001B3ULL;
  }
  std::string text(16, '0');
  for (size_t i = 0; i < 16; ++i)
    text[i] = "0123456789abcdef"[(hash >> (60U - 4U * i)) & 15U];
  return text;
}

struct FrameKind {
  int width, height, samples;
  Shading shading;

  std::string name() const {
    std::ostringstream out;
    out << width << 'x' << height << '_' << samples << (shading == Shading::kFlat ? "_flat" : "_gouraud");
    return out.str();
  }
};

std::vector<FrameKind> frame_kinds() {
  std::vector<FrameKind> kinds;
  for (const int samples : {1, 2, 4, 8}) {
    for (const Shading shading : {Shading::kFlat, Shading::kGouraud})
      kinds.push_back({320, 180, samples, shading});
  }
  kinds.push_back({1280, 720, 4, Shading::kGouraud});
  kinds.push_back({640, 480, 1, Shading::kGouraud});
  kinds.push_back({333, 217, 2, Shading::kGouraud});
  kinds.push_back({17, 1031, 8, Shading::kFlat});
  kinds.push_back({16384, 3, 1, Shading::kGouraud});
  kinds.push_back({1, 1, 8, Shading::kGouraud});
  return kinds;
}

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

TEST(RasterDigests, EveryFrameHasItsCommittedBytes) {
  const std::map<std::string, std::string> list = committed();
  const std::vector<FrameKind> kinds = frame_kinds();
  EXPECT_EQ(list.size(), kinds.size()) << "tests/determinism/raster_digests.txt should name each frame once";
  const Scene scene;
  Renderer renderer;
  for (const FrameKind& kind : kinds) {
    std::vector<uint32_t> pixels;
    draw_scene(renderer, scene, kind.width, kind.height, kind.samples, kind.shading, pixels);
    const auto found = list.find(kind.name());
    EXPECT_TRUE(found != list.end() && found->second == digest(pixels))
        << "the frame changed, or is new. When that is meant, look at it and put this line into "
           "tests/determinism/raster_digests.txt:\n"
        << kind.name() << ' ' << digest(pixels);
  }
}

// Frames that differ have digests that differ, so that equal digests say something.
TEST(RasterDigests, DigestTellsOnePixelApart) {
  const Scene scene;
  Renderer renderer;
  std::vector<uint32_t> pixels;
  draw_scene(renderer, scene, 320, 180, 1, Shading::kFlat, pixels);
  const std::string before = digest(pixels);
  pixels[pixels.size() / 2] ^= 1U;
  EXPECT_NE(digest(pixels), before);
}

TEST(RasterDigests, DrawingTwiceGivesTheSameBytes) {
  const Scene scene;
  Renderer warm;
  std::vector<uint32_t> first;
  std::vector<uint32_t> between;
  std::vector<uint32_t> second;
  std::vector<uint32_t> fresh;
  for (const int samples : {1, 2, 4, 8}) {
    draw_scene(warm, scene, 320, 180, samples, Shading::kGouraud, first);
    draw_scene(warm, scene, 77, 301, samples == 1 ? 8 : 1, Shading::kFlat, between);
    draw_scene(warm, scene, 320, 180, samples, Shading::kGouraud, second);
    EXPECT_EQ(first, second) << samples;
    Renderer cold;
    draw_scene(cold, scene, 320, 180, samples, Shading::kGouraud, fresh);
    EXPECT_EQ(first, fresh) << samples;
  }
}

// The strips that a frame is filled in leave no seam: a frame's middle looks the same wherever the strips fall. Moving
// the picture by whole pixels moves it exactly, because the grid of 1/256 pixel moves with it.
TEST(RasterDigests, StripsLeaveNoSeam) {
  Random random(91);
  std::vector<Triangle> triangles;
  for (int i = 0; i < 60; ++i) {
    Triangle t;
    for (Point& p : t)
      p = {random.between(0, 64 * 256), random.between(0, 64 * 256)};
    triangles.push_back(t);
  }
  for (const int samples : {1, 4}) {
    Screen still(128, 128, samples);
    Screen moved(128, 128, samples);
    constexpr int kShift = 7;
    for (size_t i = 0; i < triangles.size(); ++i) {
      const auto red = static_cast<uint8_t>(i * 4);
      Triangle t = triangles[i];
      for (Point& p : t)
        p.y += 32 * 256;
      still.add(t, glm::u8vec4(red, 255, 9, 255), 0.25F + 0.01F * static_cast<float>(i));
      for (Point& p : t)
        p.y += kShift * 256;
      moved.add(t, glm::u8vec4(red, 255, 9, 255), 0.25F + 0.01F * static_cast<float>(i));
    }
    still.end();
    moved.end();
    for (int row = 0; row + kShift < 128; ++row) {
      for (int column = 0; column < 128; ++column) {
        ASSERT_EQ(still.pixel(column, row), moved.pixel(column, row + kShift)) << column << ", " << row;
      }
    }
  }
}

}  // namespace
}  // namespace auslan::raster
