// SPDX-License-Identifier: Apache-2.0
// Whether two programs drew the same scene: by how much their pictures differ.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace auslan::bench {

struct PictureDifference {
  double mean_level = 255;   ///< mean over pixels and channels of the difference, levels of 255
  double share_far_off = 1;  ///< of the pixels: those with a channel that is off by more than 16 levels
};

/// Pixels as raster/image.h has them. Pictures of different sizes differ in everything.
PictureDifference difference_of(std::span<const uint32_t> a, std::span<const uint32_t> b);

/// A binary PPM file; false when it cannot be written.
bool write_ppm(const std::string& path, std::span<const uint32_t> pixels, int width);

}  // namespace auslan::bench
