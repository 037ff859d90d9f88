// SPDX-License-Identifier: Apache-2.0
// What is in a texture.
#pragma once

#include "kernels/texture.h"
#include "raster/texture.h"

#include <vector>

namespace auslan::raster {

struct Texture::Data {
  std::vector<float> texels;
  std::vector<TextureLevel> levels;  ///< the largest first
  uint64_t serial = 0;               ///< no other texture of this program has it, above 0

  TextureLevels view() const noexcept { return {texels.data(), levels.data(), static_cast<int32_t>(levels.size())}; }
};

}  // namespace auslan::raster
