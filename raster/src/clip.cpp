// SPDX-License-Identifier: Apache-2.0
#include "clip.h"

#include <cmath>

namespace auslan::raster {
namespace {

// Signed distance, in clip units: not negative inside.
double distance(const ClipVertex& v, uint32_t plane, const Viewport& viewport) {
  switch (plane) {
    case kOutNear:
      return v.w - v.z;
    case kOutFar:
      return v.z;
    case kOutGuardLeft:
      return static_cast<double>(viewport.guard_x) * v.w + v.x;
    case kOutGuardRight:
      return static_cast<double>(viewport.guard_x) * v.w - v.x;
    case kOutGuardBottom:
      return static_cast<double>(viewport.guard_y) * v.w + v.y;
    default:
      return static_cast<double>(viewport.guard_y) * v.w - v.y;
  }
}

ClipVertex crossing(const ClipVertex& inner, double inner_distance, const ClipVertex& outer, double outer_distance) {
  const double t = inner_distance / (inner_distance - outer_distance);
  ClipVertex v;
  v.x = inner.x + t * (outer.x - inner.x);
  v.y = inner.y + t * (outer.y - inner.y);
  v.z = inner.z + t * (outer.z - inner.z);
  v.w = inner.w + t * (outer.w - inner.w);
  for (int channel = 0; channel < 3; ++channel) {
    v.level[channel] = inner.level[channel] + t * (outer.level[channel] - inner.level[channel]);
  }
  for (int axis = 0; axis < 2; ++axis)
    v.coordinate[axis] = inner.coordinate[axis] + t * (outer.coordinate[axis] - inner.coordinate[axis]);
  return v;
}

void clip_at(ClipPolygon& polygon, uint32_t plane, const Viewport& viewport) {
  ClipPolygon kept;
  const auto add = [&kept](const ClipVertex& v) {
    // A polygon that rounding made slightly concave could cross a plane more than twice; it stays within bounds anyway.
    if (kept.count < static_cast<int>(kept.corner.size())) kept.corner[static_cast<size_t>(kept.count++)] = v;
  };
  for (int i = 0; i < polygon.count; ++i) {
    const ClipVertex& from = polygon.corner[static_cast<size_t>(i)];
    const ClipVertex& to = polygon.corner[static_cast<size_t>(i + 1 == polygon.count ? 0 : i + 1)];
    const double from_distance = distance(from, plane, viewport);
    const double to_distance = distance(to, plane, viewport);
    const bool from_inside = from_distance >= 0.0;
    const bool to_inside = to_distance >= 0.0;
    if (from_inside) add(from);
    if (from_inside && !to_inside) add(crossing(from, from_distance, to, to_distance));
    if (!from_inside && to_inside) add(crossing(to, to_distance, from, from_distance));
  }
  polygon = kept;
}

}  // namespace

uint32_t planes_outside(const Viewport& viewport, const glm::vec4& clip) noexcept {
  const float guard_x = viewport.guard_x * clip.w;
  const float guard_y = viewport.guard_y * clip.w;
  if (!(std::isfinite(clip.x) && std::isfinite(clip.y) && std::isfinite(clip.z) && std::isfinite(guard_x) &&
        std::isfinite(guard_y))) {
    return kBroken;
  }
  uint32_t planes = 0;
  if (clip.x < -clip.w) planes |= kOutLeft;
  if (clip.x > clip.w) planes |= kOutRight;
  if (clip.y < -clip.w) planes |= kOutBottom;
  if (clip.y > clip.w) planes |= kOutTop;
  if (clip.z > clip.w) planes |= kOutNear;
  if (clip.z < 0.0F) planes |= kOutFar;
  if (clip.x < -guard_x) planes |= kOutGuardLeft;
  if (clip.x > guard_x) planes |= kOutGuardRight;
  if (clip.y < -guard_y) planes |= kOutGuardBottom;
  if (clip.y > guard_y) planes |= kOutGuardTop;
  return planes;
}

void clip(ClipPolygon& polygon, const Viewport& viewport) noexcept {
  for (uint32_t plane = kOutNear; plane <= kOutGuardTop; plane <<= 1U) {
    clip_at(polygon, plane, viewport);
    if (polygon.count < 3) return;
  }
}

}  // namespace auslan::raster
