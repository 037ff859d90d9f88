// SPDX-License-Identifier: Apache-2.0
// What a triangle gets from the texture that its mesh wears.
#pragma once

#include "kernels/texture.h"
#include "raster/texture.h"

namespace auslan::raster {

bool finite(const glm::vec2& coordinates) noexcept;

/// u, v of three corners less whole periods of the first one, held within kFarthestCoordinate. False when one is not
/// finite. Precondition: the corners are below use.coordinates.size().
bool coordinates_of(const TextureUse& use, const uint32_t corner[3], double (&out)[3][2]) noexcept;

/// Sets what all triangles of a mesh share.
void dress(const TextureUse& use, TexturedTriangle& triangle) noexcept;

}  // namespace auslan::raster
