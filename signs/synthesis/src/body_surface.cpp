// SPDX-License-Identifier: Apache-2.0
#include "synthesis/body_surface.h"

#include <algorithm>
#include <cmath>

namespace auslan {
namespace {

constexpr size_t kDigitPoints = 20, kPalmPoints = 72, kArmPoints = 48;

double squared(const Vec3& v) {
  return glm::dot(v, v);
}

/// Each next point is the one farthest from all before it (Gonzalez 1985).
SurfacePatch spread(const Mesh& mesh, size_t count) {
  SurfacePatch patch;
  const size_t size = mesh.positions.size();
  if (size == 0) return patch;
  Vec3 low(mesh.positions[0]), high = low;
  for (const glm::vec3& position : mesh.positions) {
    low = glm::min(low, Vec3(position));
    high = glm::max(high, Vec3(position));
  }
  patch.centre = 0.5 * (low + high);
  std::vector<double> distance(size, 1e9);
  size_t next = 0;
  while (patch.points.size() < std::min(count, size)) {
    const Vec3 point(mesh.positions[next]);
    patch.points.push_back({point, Vec3(mesh.normals[next])});
    patch.radius = std::max(patch.radius, std::sqrt(squared(point - patch.centre)));
    size_t farthest = 0;
    for (size_t i = 0; i < size; ++i) {
      distance[i] = std::min(distance[i], squared(Vec3(mesh.positions[i]) - point));
      if (distance[i] > distance[farthest]) farthest = i;
    }
    next = farthest;
  }
  return patch;
}

}  // namespace

BodySurface::BodySurface(const Figure& figure) : solids_(figure.segments.size()), patches_(figure.segments.size()) {
  const auto take = [&](int node, size_t points) {
    const Mesh& mesh = figure.segments[static_cast<size_t>(node)];
    if (mesh.indices.empty()) return;
    solids_[static_cast<size_t>(node)].emplace(mesh);
    patches_[static_cast<size_t>(node)] = spread(mesh, points);
  };
  for (const char* name : {"spine_base", "neck_base", "head_base"})
    take(figure.skeleton.find(name), 0);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const ArmNodes arm = arm_nodes(figure.skeleton, side);
    take(arm.shoulder, kArmPoints);
    take(arm.elbow, kArmPoints);
    take(arm.wrist, kPalmPoints);
    for (const auto& digit : arm.digits)
      for (const int node : digit)
        take(node, kDigitPoints);
  }
}

SurfacePatch balled(SurfacePatch patch) {
  Vec3 sum(0.0);
  for (const Site& point : patch.points)
    sum += point.position;
  patch.centre = patch.points.empty() ? sum : sum / static_cast<double>(patch.points.size());
  double farthest = 0.0;
  for (const Site& point : patch.points)
    farthest = std::max(farthest, squared(point.position - patch.centre));
  patch.radius = std::sqrt(farthest);
  return patch;
}

SurfacePatch placed(const SurfacePatch& patch, const Transform& place) {
  SurfacePatch result;
  result.centre = apply(place, patch.centre);
  result.radius = patch.radius;
  result.points.reserve(patch.points.size());
  for (const Site& point : patch.points)
    result.points.push_back({apply(place, point.position), place.rotation * point.normal});
  return result;
}

}  // namespace auslan
