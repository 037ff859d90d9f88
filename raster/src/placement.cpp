// SPDX-License-Identifier: Apache-2.0
#include "placement.h"

#include <cmath>

namespace auslan::raster {
namespace {

// a * b in double, one fixed order.
glm::dmat4 product(const glm::dmat4& a, const glm::dmat4& b) {
  glm::dmat4 result(0.0);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      double sum = a[0][row] * b[column][0];
      sum = sum + a[1][row] * b[column][1];
      sum = sum + a[2][row] * b[column][2];
      sum = sum + a[3][row] * b[column][3];
      result[column][row] = sum;
    }
  }
  return result;
}

float larger(float a, float b) {
  return a > b ? a : b;
}

}  // namespace

bool finite(const glm::vec3& v) noexcept {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool finite(const glm::mat4& m) noexcept {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(m[column][row])) return false;
    }
  }
  return true;
}

Placement place(const Camera& camera, const glm::mat4& world_from_mesh) noexcept {
  glm::dmat4 world(world_from_mesh);
  for (int column = 0; column < 4; ++column)
    world[column][3] = column == 3 ? 1.0 : 0.0;
  const glm::dmat4 clip =
      product(product(glm::dmat4(camera.clip_from_view), glm::dmat4(camera.view_from_world)), world);
  Placement placement{};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row)
      placement.clip_from_mesh[row][column] = static_cast<float>(clip[column][row]);
  }

  // Normals turn with the cofactor matrix, which is right for every scale and shear and needs no inverse.
  double cofactor[3][3] = {};
  double size = 0.0;
  for (int c = 0; c < 3; ++c) {
    const int c1 = (c + 1) % 3;
    const int c2 = (c + 2) % 3;
    for (int r = 0; r < 3; ++r) {
      const int r1 = (r + 1) % 3;
      const int r2 = (r + 2) % 3;
      cofactor[c][r] = world[c1][r1] * world[c2][r2] - world[c1][r2] * world[c2][r1];
      size = std::abs(cofactor[c][r]) > size ? std::abs(cofactor[c][r]) : size;
    }
  }
  const double determinant =
      (world[0][0] * cofactor[0][0] + world[0][1] * cofactor[0][1]) + world[0][2] * cofactor[0][2];
  placement.mirrored = determinant < 0.0;
  const double scale = (placement.mirrored ? -1.0 : 1.0) / (size > 0.0 ? size : 1.0);
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r)
      placement.normal_from_mesh[r][c] = static_cast<float>(cofactor[c][r] * scale);
  }
  return placement;
}

glm::vec3 unit_or_zero(const glm::vec3& v) noexcept {
  float x = v.x;
  float y = v.y;
  float z = v.z;
  float square = (x * x + y * y) + z * z;
  if (!(square > 1e-30F && square < 1e30F)) {
    // Too short or too long to be squared in a float: bring the largest component to 1 first.
    const float size = larger(larger(std::abs(x), std::abs(y)), std::abs(z));
    if (!(size > 0.0F)) return glm::vec3(0.0F);
    x = x / size;
    y = y / size;
    z = z / size;
    square = (x * x + y * y) + z * z;
  }
  const float length = std::sqrt(square);
  return glm::vec3(x / length, y / length, z / length);
}

glm::vec3 world_normal(const Placement& placement, const glm::vec3& normal) noexcept {
  const glm::vec3 n = unit_or_zero(normal);
  glm::vec3 world(0.0F);
  for (int r = 0; r < 3; ++r) {
    const float(&row)[3] = placement.normal_from_mesh[r];
    world[r] = (row[0] * n.x + row[1] * n.y) + row[2] * n.z;
  }
  return unit_or_zero(world);
}

bool odd_world_normal(const Placement& placement, const float normal[3], float out[3]) noexcept {
  const glm::vec3 n(normal[0], normal[1], normal[2]);
  const glm::vec3 world = finite(n) ? world_normal(placement, n) : glm::vec3(0.0F);
  for (int axis = 0; axis < 3; ++axis)
    out[axis] = world[axis];
  return finite(n);
}

Viewport make_viewport(int width, int height) noexcept {
  Viewport viewport{};
  viewport.width = width;
  viewport.height = height;
  viewport.half_x = static_cast<float>(width * (kSubPixels / 2));
  viewport.half_y = static_cast<float>(height * (kSubPixels / 2));
  viewport.guard_x = 1.0F;
  viewport.guard_y = 1.0F;
  while (viewport.half_x * viewport.guard_x * 2.0F <= kGuardBand)
    viewport.guard_x *= 2.0F;
  while (viewport.half_y * viewport.guard_y * 2.0F <= kGuardBand)
    viewport.guard_y *= 2.0F;
  return viewport;
}

glm::vec4 clip_position(const Placement& placement, const glm::vec3& p) noexcept {
  glm::vec4 clip(0.0F);
  for (int r = 0; r < 4; ++r) {
    const float(&row)[4] = placement.clip_from_mesh[r];
    clip[r] = ((row[0] * p.x + row[1] * p.y) + row[2] * p.z) + row[3];
  }
  return clip;
}

bool project(const Viewport& viewport, const glm::vec4& clip, Corner& out) noexcept {
  const float inverse_w = 1.0F / clip.w;
  const float from_centre_x = (clip.x * inverse_w) * viewport.half_x;
  const float from_centre_y = (clip.y * inverse_w) * viewport.half_y;
  const float depth = clip.z * inverse_w;
  const float limit = kGuardBand + 256.0F;
  const bool inside = inverse_w > 0.0F && std::isfinite(inverse_w) && from_centre_x >= -limit &&
                      from_centre_x <= limit && from_centre_y >= -limit && from_centre_y <= limit && depth >= -1.0F &&
                      depth <= 2.0F;
  if (!inside) return false;
  // Adding 1.5 * 2^23 leaves no bits below 1, so the sum is rounded to nearest even by the addition itself.
  const float rounder = 12582912.0F;
  out.x = ((from_centre_x + rounder) - rounder) + viewport.half_x;
  out.y = ((rounder - from_centre_y) - rounder) + viewport.half_y;
  out.depth = depth;
  out.inverse_w = inverse_w;
  return true;
}

}  // namespace auslan::raster
