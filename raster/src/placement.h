// SPDX-License-Identifier: Apache-2.0
// Where a draw puts its mesh: matrices, and single vertices for the rare paths. Every operation here is the same, in
// the same order, as the kernels' (vertex_stage.h).
#pragma once

#include "kernels/kernel.h"
#include "raster/camera.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace auslan::raster {

bool finite(const glm::vec3& v) noexcept;
bool finite(const glm::mat4& m) noexcept;

/// Precondition: all matrices are finite. The bottom row of world_from_mesh is ignored.
Placement place(const Camera& camera, const glm::mat4& world_from_mesh) noexcept;

/// Unit vector along `v`, at any finite length; zero where v is zero.
glm::vec3 unit_or_zero(const glm::vec3& v) noexcept;

/// Unit world normal of a mesh normal of any length; zero where that is zero.
glm::vec3 world_normal(const Placement& placement, const glm::vec3& normal) noexcept;

/// The mapping of a frame, 1 to 16384 pixels each way.
Viewport make_viewport(int width, int height) noexcept;

glm::vec4 clip_position(const Placement& placement, const glm::vec3& position) noexcept;

/// Projects a clip-space point that lies inside near, far and guard planes. False where the result is not finite or
/// would leave the guard band; `out` is then unspecified. Levels are not touched.
bool project(const Viewport& viewport, const glm::vec4& clip, Corner& out) noexcept;

}  // namespace auslan::raster
