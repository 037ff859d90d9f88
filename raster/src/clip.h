// SPDX-License-Identifier: Apache-2.0
// Cutting a triangle at the near, far and guard-band planes (Sutherland and Hodgman 1974).
#pragma once

#include "frame.h"

#include <array>

namespace auslan::raster {

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
