// SPDX-License-Identifier: Apache-2.0
#include "lights.h"

#include "placement.h"
#include "raster/srgb.h"

#include <cmath>

namespace auslan::raster {
namespace {

float larger(float a, float b) {
  return a > b ? a : b;
}

float dot(const float (&a)[3], const glm::vec3& b) {
  return (a[0] * b.x + a[1] * b.y) + a[2] * b.z;
}

float sane(float light) {
  return std::isfinite(light) && light > 0.0F ? light : 0.0F;
}

void set_direction(const glm::vec3& towards, float (&out)[3]) {
  const glm::vec3 unit = finite(towards) ? unit_or_zero(towards) : glm::vec3(0.0F);
  for (int axis = 0; axis < 3; ++axis)
    out[axis] = unit[axis];
}

// The unit normal of a face in its mesh; zero where it has no area.
glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::dvec3 u = glm::dvec3(b) - glm::dvec3(a);
  const glm::dvec3 v = glm::dvec3(c) - glm::dvec3(a);
  const double x = u.y * v.z - u.z * v.y;
  const double y = u.z * v.x - u.x * v.z;
  const double z = u.x * v.y - u.y * v.x;
  const double length = std::sqrt((x * x + y * y) + z * z);
  const double scale = std::isfinite(length) && length > 0.0 ? 1.0 / length : 0.0;
  if (!(scale > 0.0 && std::isfinite(scale))) return glm::vec3(0.0F);
  return glm::vec3(static_cast<float>(x * scale), static_cast<float>(y * scale), static_cast<float>(z * scale));
}

}  // namespace

PreparedLights prepare(const Lighting& lighting) noexcept {
  PreparedLights lights{};
  set_direction(lighting.key_direction, lights.key_direction);
  set_direction(lighting.fill_direction, lights.fill_direction);
  set_direction(lighting.rim_direction, lights.rim_direction);
  for (int c = 0; c < 3; ++c) {
    lights.key_colour[c] = sane(lighting.key_colour[c]);
    lights.fill_colour[c] = sane(lighting.fill_colour[c]);
    lights.rim_colour[c] = sane(lighting.rim_colour[c]);
    lights.rim = lights.rim || lights.rim_colour[c] > 0.0F;
    const float sky = sane(lighting.ambient_sky[c]);
    const float ground = sane(lighting.ambient_ground[c]);
    lights.ambient_middle[c] = 0.5F * sky + 0.5F * ground;
    lights.ambient_swing[c] = 0.5F * sky - 0.5F * ground;
  }
  return lights;
}

uint32_t flat_colour(const MeshView& mesh, const uint32_t corner[3], const Placement& placement,
                     const PreparedLights& lights) noexcept {
  const glm::vec3 normal = face_normal(mesh.positions[corner[0]], mesh.positions[corner[1]], mesh.positions[corner[2]]);
  const glm::vec3 world = world_normal(placement, normal);
  const float key = larger(dot(lights.key_direction, world), 0.0F);
  const float fill = larger(dot(lights.fill_direction, world), 0.0F);
  const float rim = larger(dot(lights.rim_direction, world), 0.0F);
  uint32_t pixel = 0;
  for (int c = 0; c < 3; ++c) {
    const float ambient = lights.ambient_middle[c] + world.y * lights.ambient_swing[c];
    const float front = (ambient + key * lights.key_colour[c]) + fill * lights.fill_colour[c];
    const float light = front + rim * lights.rim_colour[c];
    float surface = 0.0F;
    for (int i = 0; i < 3; ++i)
      surface = surface + linear_from_srgb(mesh.colours[corner[i]][c]);
    pixel = (pixel << 8U) | static_cast<uint32_t>(srgb_level_from_linear(light * (surface / 3.0F)) + 0.5F);
  }
  return pixel;
}

}  // namespace auslan::raster
