// SPDX-License-Identifier: Apache-2.0
// Lambert lighting of a point in linear light, and its encoding to sRGB levels.
#pragma once

#include "raster/renderer.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace auslan::raster {

/// Lighting with unit directions and nothing that is negative or not finite.
struct PreparedLights {
  glm::vec3 key_direction, key_colour;
  glm::vec3 fill_direction, fill_colour;
  glm::vec3 ambient_middle;  ///< received by a surface that faces the horizon
  glm::vec3 ambient_swing;   ///< added times the normal's y
};

PreparedLights prepare(const Lighting& lighting) noexcept;

/// Unit vector along `v`, at any finite length; zero where v is zero.
glm::vec3 unit_or_zero(const glm::vec3& v) noexcept;

/// Light that a surface with this unit normal (world) receives; a zero normal gets the middle of the ambient light.
glm::vec3 received_light(const PreparedLights& lights, const glm::vec3& normal) noexcept;

}  // namespace auslan::raster
