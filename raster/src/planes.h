// SPDX-License-Identifier: Apache-2.0
// Gradients of what is linear over a triangle on the screen, in double precision.
#pragma once

#include "kernels/kernel.h"

namespace auslan::raster {

/// Corner differences and area of a triangle, for its planes.
struct Slopes {
  double x1, y1, x2, y2, area;
};

inline Slopes slopes_of(const Corner& a, const Corner& b, const Corner& c) noexcept {
  Slopes slopes{};
  slopes.x1 = static_cast<double>(b.x - a.x);
  slopes.y1 = static_cast<double>(b.y - a.y);
  slopes.x2 = static_cast<double>(c.x - a.x);
  slopes.y2 = static_cast<double>(c.y - a.y);
  slopes.area = slopes.x1 * slopes.y2 - slopes.x2 * slopes.y1;
  return slopes;
}

inline Plane make_plane(const Slopes& s, float v0, float v1, float v2) noexcept {
  const double d1 = static_cast<double>(v1) - static_cast<double>(v0);
  const double d2 = static_cast<double>(v2) - static_cast<double>(v0);
  Plane plane{};
  plane.origin = v0;
  plane.per_x = static_cast<float>((d1 * s.y2 - d2 * s.y1) / s.area);
  plane.per_y = static_cast<float>((d2 * s.x1 - d1 * s.x2) / s.area);
  const float low = v0 < v1 ? v0 : v1;
  const float high = v0 < v1 ? v1 : v0;
  plane.least = v2 < low ? v2 : low;
  plane.greatest = v2 > high ? v2 : high;
  return plane;
}

}  // namespace auslan::raster
