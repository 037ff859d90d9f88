// SPDX-License-Identifier: Apache-2.0
// Points on a figure's surface: found once in the rest pose, then carried along with the node they lie on.
#pragma once

#include "kinematics/figure.h"

#include <optional>
#include <span>

namespace auslan {

/// A point of a node's segment, in the node's frame (metres), with the outward unit normal of its triangle.
struct SurfacePoint {
  int node = kNoNode;
  Vec3 position{0.0};
  Vec3 normal{0.0, 0.0, 1.0};
};

enum class RayHit {
  kFirst,     ///< the nearest to the origin
  kFarthest,  ///< the outermost surface along the ray
};

/// Where a ray meets the segments of `nodes`, in the world space of the rest pose (face at rest). Both sides of a
/// triangle count. Nothing when it misses, or when the direction is zero. The lower node, then triangle, wins a tie.
std::optional<SurfacePoint> cast_ray(const Figure& figure, std::span<const int> nodes, const Vec3& origin,
                                     const Vec3& direction, RayHit which = RayHit::kFirst);

/// The vertex of a node's segment that lies farthest along a direction (node frame, any length). A segment without a
/// surface gives the node's origin and the direction itself.
SurfacePoint extreme_point(const Figure& figure, int node, const Vec3& direction);

/// The same point in the posed world. `world_from_node` as forward() fills it.
inline Vec3 placed_position(const SurfacePoint& point, std::span<const Transform> world_from_node) {
  return apply(world_from_node[static_cast<size_t>(point.node)], point.position);
}
inline Vec3 placed_normal(const SurfacePoint& point, std::span<const Transform> world_from_node) {
  return world_from_node[static_cast<size_t>(point.node)].rotation * point.normal;
}

}  // namespace auslan
