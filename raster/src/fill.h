// SPDX-License-Identifier: Apache-2.0
// Filling triangles into a band of rows, and averaging the samples of a row into pixels.
#pragma once

#include "frame.h"

#include <cstdint>
#include <span>
#include <vector>

namespace auslan::raster {

/// Height of the strip that is filled at a time: small enough that its samples stay in the cache.
inline constexpr int kBandRows = 16;

/// The samples of a band of rows: index ((row - first_row) * width + column) * samples + sample.
struct Band {
  int width = 0;
  int first_row = 0;
  int row_count = 0;
  std::vector<uint32_t> colour;  ///< pixels
  std::vector<float> depth;      ///< reversed; 0 where nothing was drawn
};

/// Fills the part of a triangle that lies in the band. What a sample gets depends on the triangle and the sample alone,
/// never on the band: planes are evaluated from the triangle's own first vertex.
void fill(Band& band, int samples, const TriangleRecord& triangle, std::span<const ScreenVertex> vertices) noexcept;

/// Averages each group of `samples` colours in linear light into one pixel.
void resolve(std::span<const uint32_t> colours, int samples, std::span<uint32_t> pixels) noexcept;

}  // namespace auslan::raster
