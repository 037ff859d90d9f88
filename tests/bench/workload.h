// SPDX-License-Identifier: Apache-2.0
// How much work a scene is, counted without a rasteriser of the benchmark: the numbers that say whether two benchmarks
// draw the same amount.
#pragma once

#include "scene.h"

#include <cstdint>

namespace auslan::bench {

struct Workload {
  uint64_t front_facing = 0;  ///< triangles that face the eye, with an area on the 1/256 pixel grid
  uint64_t covering = 0;      ///< those of them that cover a pixel's centre (of the picture)
  uint64_t fragments = 0;     ///< pixels' centres that they cover, hidden or not
  uint64_t pixels = 0;        ///< pixels that show one of them
  double overdraw() const { return static_cast<double>(fragments) / static_cast<double>(pixels); }
};

/// Counts with the rules of raster/renderer.h. Of scenes that no clip plane cuts and that have no deeper guard band
/// than a picture: all of the benchmark's signers.
Workload workload_of(const Scene& scene, int width, int height);

}  // namespace auslan::bench
