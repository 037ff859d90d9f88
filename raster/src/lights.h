// SPDX-License-Identifier: Apache-2.0
// Lambert lighting in linear light: what kernels need of it, and of a whole face at once.
#pragma once

#include "kernels/kernel.h"
#include "raster/renderer.h"

namespace auslan::raster {

/// Lighting with unit directions and nothing that is negative or not finite.
PreparedLights prepare(const Lighting& lighting) noexcept;

/// The colour of a flat face: lit by its own normal, its surface the mean of its corners' in linear light.
/// Precondition: the corners are below mesh.positions.size().
uint32_t flat_colour(const MeshView& mesh, const uint32_t corner[3], const Placement& placement,
                     const PreparedLights& lights) noexcept;

}  // namespace auslan::raster
