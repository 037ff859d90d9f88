// SPDX-License-Identifier: Apache-2.0
// The camera: world (metres, right-handed, Y up) to view (right-handed, looking along -Z, Y up) to clip space.
//
// Clip space: a point is inside when -w <= x <= w (left to right), -w <= y <= w (bottom to top) and 0 <= z <= w. Depth
// is REVERSED: z / w is 1 on the near plane and 0 at infinity. In perspective z / w = near / distance, which is linear
// over the screen; in a float its error is relative (2^-24 of the value), so that two surfaces 2 mm apart are thousands
// of steps apart at 0.3 m and at 3 m alike. A plain depth puts all those values next to 1, where a float is coarsest.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace auslan::raster {

/// Column-major as GLM has it; points are column vectors. Default: clip space is the world.
struct Camera {
  glm::mat4 view_from_world{1.0F};
  glm::mat4 clip_from_view{1.0F};
};

/// A perspective camera at `eye` looking at `target` (metres, world), infinite far plane, reversed depth.
/// `cot_half_fov_y`: cotangent of half the vertical field of view (2.0 is 53.1 degrees). `aspect`: width over height.
/// `near_plane`: metres; closer surfaces are cut away.
/// Total: with eye == target it looks along -Z; with `up` along the view another axis replaces it; numbers that are not
/// finite, or not above 0 where they must be, give a camera that the renderer draws nothing with.
Camera look_at(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up, float cot_half_fov_y, float aspect,
               float near_plane) noexcept;

/// As look_at, but parallel: `half_height` metres are seen above and below the target; depth is reversed and linear
/// from the near plane to the far plane (metres from the eye), beyond which surfaces are cut away.
Camera look_at_parallel(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up, float half_height,
                        float aspect, float near_plane, float far_plane) noexcept;

}  // namespace auslan::raster
