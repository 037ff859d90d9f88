// SPDX-License-Identifier: Apache-2.0
#include "lights.h"

#include <cmath>

namespace auslan::raster {
namespace {

float larger(float a, float b) {
  return a > b ? a : b;
}

float dot(const glm::vec3& a, const glm::vec3& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

float sane(float light) {
  return std::isfinite(light) && light > 0.0F ? light : 0.0F;
}

glm::vec3 sane(const glm::vec3& light) {
  return glm::vec3(sane(light.x), sane(light.y), sane(light.z));
}

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::vec3 direction(const glm::vec3& towards) {
  return finite(towards) ? unit_or_zero(towards) : glm::vec3(0.0F);
}

}  // namespace

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

PreparedLights prepare(const Lighting& lighting) noexcept {
  const glm::vec3 sky = sane(lighting.ambient_sky);
  const glm::vec3 ground = sane(lighting.ambient_ground);
  PreparedLights lights{};
  lights.key_direction = direction(lighting.key_direction);
  lights.key_colour = sane(lighting.key_colour);
  lights.fill_direction = direction(lighting.fill_direction);
  lights.fill_colour = sane(lighting.fill_colour);
  for (int channel = 0; channel < 3; ++channel) {
    lights.ambient_middle[channel] = 0.5F * sky[channel] + 0.5F * ground[channel];
    lights.ambient_swing[channel] = 0.5F * sky[channel] - 0.5F * ground[channel];
  }
  return lights;
}

glm::vec3 received_light(const PreparedLights& lights, const glm::vec3& normal) noexcept {
  const float key = larger(dot(normal, lights.key_direction), 0.0F);
  const float fill = larger(dot(normal, lights.fill_direction), 0.0F);
  glm::vec3 light(0.0F);
  for (int channel = 0; channel < 3; ++channel) {
    const float ambient = lights.ambient_middle[channel] + normal.y * lights.ambient_swing[channel];
    light[channel] = (ambient + key * lights.key_colour[channel]) + fill * lights.fill_colour[channel];
  }
  return light;
}

}  // namespace auslan::raster
