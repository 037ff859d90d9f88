// SPDX-License-Identifier: Apache-2.0
// The frames whose digests are committed in tests/determinism/raster_digests.txt. Knows no test library, so that a
// program for another processor can print them.
#pragma once

#include "raster_textured.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace auslan::raster {

/// FNV-1a, 64 bits, over the bytes of the pixels from low to high.
inline std::string digest(const std::vector<uint32_t>& pixels) {
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
  bool textured = false;

  std::string name() const {
    return std::to_string(width) + 'x' + std::to_string(height) + '_' + std::to_string(samples) +
           (shading == Shading::kFlat ? "_flat" : "_gouraud") + (textured ? "_textured" : "");
  }
};

inline std::vector<FrameKind> frame_kinds() {
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
  for (const int samples : {1, 2, 4, 8})
    kinds.push_back({320, 180, samples, Shading::kGouraud, true});
  kinds.push_back({333, 217, 4, Shading::kFlat, true});
  kinds.push_back({1280, 720, 1, Shading::kGouraud, true});
  return kinds;
}

inline void draw_kind(Renderer& renderer, const TexturedScene& scene, const FrameKind& kind,
                      std::vector<uint32_t>& pixels) {
  draw_list(renderer,
            kind.textured ? scene.draws(kind.width, kind.height, kind.shading)
                          : scene_draws(scene.bare, kind.width, kind.height, kind.shading),
            {kind.width, kind.height, kind.samples}, pixels);
}

}  // namespace auslan::raster
