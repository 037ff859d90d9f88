// SPDX-License-Identifier: Apache-2.0
// What the kernels need of textures, as plain data (kernel.h).
#pragma once

#include "kernel.h"

namespace auslan::raster {

/// A texel is two words of memory: linear red in the low and green in the high half of the first, blue and alpha in the
/// second; each is 0 to kTexelScale. Two of them weighted with up to 256 fit a product sum of signed 16-bit pairs.
inline constexpr int32_t kTexelScale = 32767;
inline constexpr int kTexelWords = 2;
/// Fraction bits of texel distances, of levels, and of what filters give.
inline constexpr int kFilterBits = 8;

struct TextureLevel {
  float width, height;
  int32_t first;  ///< number of its first texel
  int32_t unused;
};
struct TextureLevels {
  const float* texels;  ///< the words' bits
  const TextureLevel* level;
  int32_t count;
};

/// What a general triangle has beside its shape when its colour is kStandInColour. The levels of the shape are of the
/// light then, always divided by inverse_w.
struct TexturedTriangle {
  Plane coordinate[2];  ///< u, v times inverse_w
  float least[2], greatest[2];
  TextureLevels texture;
  bool repeats[2], mirrors[2];  ///< neither: clamped
  /// Filtered alpha, kTexelScale << kFilterBits at most, below which a pixel is not drawn.
  int32_t cutoff;
  /// It takes the short path where no sliver or perspective of its colours forbids it, and these are its screen
  /// vertices in the order of positive area.
  bool small;
  uint32_t corner[3];
};
/// Coordinates lie at most this far from the first corner's period.
inline constexpr float kFarthestCoordinate = 1048576.0F;

/// Set-up in double precision (as set_up_general); corners in the order of positive area. Leaves the texture to the
/// caller.
void set_up_textured(const Corner& a, const Corner& b, const Corner& c, GeneralTriangle& shape,
                     TexturedTriangle& out) noexcept;

}  // namespace auslan::raster
