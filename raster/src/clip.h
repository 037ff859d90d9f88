// SPDX-License-Identifier: Apache-2.0
// Cutting a triangle at the near, far and guard-band planes (Sutherland and Hodgman 1974).
#pragma once

#include "kernels/kernel.h"

#include <array>
#include <glm/vec4.hpp>

namespace auslan::raster {

/// Which planes a clip-space point lies outside of.
enum PlaneBits : uint32_t {
  kOutLeft = 1U << 0U,
  kOutRight = 1U << 1U,
  kOutBottom = 1U << 2U,
  kOutTop = 1U << 3U,
  kOutNear = 1U << 4U,
  kOutFar = 1U << 5U,
  kOutGuardLeft = 1U << 6U,
  kOutGuardRight = 1U << 7U,
  kOutGuardBottom = 1U << 8U,
  kOutGuardTop = 1U << 9U,
  kBroken = 1U << 10U,  ///< not finite
};
inline constexpr uint32_t kInvisibleBits = kOutLeft | kOutRight | kOutBottom | kOutTop | kOutNear | kOutFar;

uint32_t planes_outside(const Viewport& viewport, const glm::vec4& clip) noexcept;

/// A vertex in clip space, in double so that cutting an edge loses nothing of the floats that it came from.
struct ClipVertex {
  double x = 0.0, y = 0.0, z = 0.0, w = 0.0;
  double level[3] = {};
  double coordinate[2] = {};
};

/// A convex polygon: each of the six planes adds at most one corner to a triangle.
struct ClipPolygon {
  std::array<ClipVertex, 9> corner;
  int count = 0;
};

/// Cuts `polygon` at all six planes. Fewer than three corners are left when nothing is.
/// Where an edge crosses a plane the new corner is computed from the inner end towards the outer one: both triangles of
/// a shared edge agree which end that is. And because a triangle is cut at all six planes or at none, what becomes of
/// an edge depends on that edge alone. So both triangles get the same bits, and no gap opens between them.
void clip(ClipPolygon& polygon, const Viewport& viewport) noexcept;

}  // namespace auslan::raster
