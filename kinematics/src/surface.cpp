// SPDX-License-Identifier: Apache-2.0
#include "kinematics/surface.h"

#include "kinematics/rotation.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace auslan {
namespace {

using Triangle = std::array<Vec3, 3>;

Triangle triangle_at(const Mesh& mesh, size_t first_index) {
  Triangle corners;
  for (size_t i = 0; i < 3; ++i)
    corners[i] = Vec3(mesh.positions[mesh.indices[first_index + i]]);
  return corners;
}

Vec3 outward_normal(const Triangle& t, const Vec3& fallback) {
  // Skin has triangles of a tenth of a millimetre: twice their area is far below what unit() takes for zero.
  const Vec3 n = glm::cross((t[1] - t[0]) * 1e3, (t[2] - t[0]) * 1e3);
  return unit(n, fallback);
}

// Distance along the ray, after Moeller & Trumbore (1997), edges and both faces included.
std::optional<double> distance_to(const Triangle& t, const Vec3& origin, const Vec3& unit_direction) {
  const Vec3 first = t[1] - t[0];
  const Vec3 second = t[2] - t[0];
  const Vec3 p = glm::cross(unit_direction, second);
  const double determinant = glm::dot(first, p);
  if (determinant == 0.0) return std::nullopt;
  const Vec3 from_corner = origin - t[0];
  const double u = glm::dot(from_corner, p) / determinant;
  if (!(u >= 0.0 && u <= 1.0)) return std::nullopt;
  const Vec3 q = glm::cross(from_corner, first);
  const double v = glm::dot(unit_direction, q) / determinant;
  if (!(v >= 0.0 && u + v <= 1.0)) return std::nullopt;
  const double distance = glm::dot(second, q) / determinant;
  if (!(distance >= 0.0)) return std::nullopt;
  return distance;
}

}  // namespace

std::optional<SurfacePoint> cast_ray(const Figure& figure, std::span<const int> nodes, const Vec3& origin,
                                     const Vec3& direction, RayHit which) {
  const Vec3 along = unit(direction, Vec3(0.0));
  if (along == Vec3(0.0)) return std::nullopt;
  std::optional<SurfacePoint> best;
  double best_distance = 0.0;
  for (const int node : nodes) {
    const Mesh& mesh = figure.segments[static_cast<size_t>(node)];
    const Vec3 local_origin = origin - figure.skeleton.rest_position(node);
    for (size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
      const Triangle triangle = triangle_at(mesh, first);
      const std::optional<double> distance = distance_to(triangle, local_origin, along);
      if (!distance) continue;
      if (best && !(which == RayHit::kFirst ? *distance < best_distance : *distance > best_distance)) continue;
      best_distance = *distance;
      best = SurfacePoint{node, local_origin + along * *distance, outward_normal(triangle, along)};
    }
  }
  return best;
}

SurfacePoint extreme_point(const Figure& figure, int node, const Vec3& direction) {
  const Mesh& mesh = figure.segments[static_cast<size_t>(node)];
  const Vec3 along = unit(direction);
  SurfacePoint point{node, Vec3(0.0), along};
  double farthest = 0.0;
  bool found = false;
  for (size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
    const Triangle triangle = triangle_at(mesh, first);
    for (const Vec3& corner : triangle) {
      const double reach = glm::dot(corner, along);
      if (found && !(reach > farthest)) continue;
      found = true;
      farthest = reach;
      point.position = corner;
      point.normal = outward_normal(triangle, along);
    }
  }
  return point;
}

}  // namespace auslan
