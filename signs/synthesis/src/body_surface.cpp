// SPDX-License-Identifier: Apache-2.0
#include "synthesis/body_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace auslan {
namespace {

struct PointCounts {
  size_t fine, coarse;
};
constexpr PointCounts kOfDigit{72, 14}, kOfPalm{240, 48}, kOfArm{300, 72};
constexpr uint32_t kPiece = 10;  // points of a piece that is not divided

double squared(const Vec3& v) {
  return glm::dot(v, v);
}

/// Each next point is the one farthest from all before it (Gonzalez 1985).
std::vector<Site> spread(const Mesh& mesh, size_t count) {
  std::vector<Site> points;
  const size_t size = mesh.positions.size();
  std::vector<double> distance(size, 1e9);
  size_t next = 0;
  while (points.size() < std::min(count, size)) {
    const Vec3 point(mesh.positions[next]);
    points.push_back({point, Vec3(mesh.normals[next])});
    size_t farthest = 0;
    for (size_t i = 0; i < size; ++i) {
      distance[i] = std::min(distance[i], squared(Vec3(mesh.positions[i]) - point));
      if (distance[i] > distance[farthest]) farthest = i;
    }
    next = farthest;
  }
  return points;
}

struct Box {
  Vec3 low{0.0}, high{0.0};
};
Box box_round(std::span<const Site> points) {
  if (points.empty()) return {};
  Box box{points.front().position, points.front().position};
  for (const Site& point : points) {
    box.low = glm::min(box.low, point.position);
    box.high = glm::max(box.high, point.position);
  }
  return box;
}

/// A ball about the middle of the box round some points.
SurfacePatch::Piece piece_of(std::span<const Site> points, uint32_t first, uint32_t count) {
  const std::span<const Site> own = points.subspan(first, count);
  const Box box = box_round(own);
  SurfacePatch::Piece piece{0.5 * (box.low + box.high), 0.0, first, count};
  for (const Site& point : own)
    piece.radius = std::max(piece.radius, std::sqrt(squared(point.position - piece.centre)));
  return piece;
}

/// Halves points across the longest side of their box, as often as it takes, into the patch's pieces.
void divide(SurfacePatch& patch, uint32_t first, uint32_t count) {
  if (count <= kPiece) {
    if (count > 0) patch.pieces.push_back(piece_of(patch.points, first, count));
    return;
  }
  const auto begin = patch.points.begin() + first, end = begin + count;
  const Box box = box_round({begin, end});
  const Vec3 extent = box.high - box.low;
  const glm::length_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  std::stable_sort(begin, end, [axis](const Site& a, const Site& b) { return a.position[axis] < b.position[axis]; });
  divide(patch, first, count / 2);
  divide(patch, first + count / 2, count - count / 2);
}

}  // namespace

BodySurface::BodySurface(const Figure& figure)
    : fields_(figure.segments.size()), patches_(figure.segments.size()), coarse_patches_(figure.segments.size()) {
  const auto take = [&](int node, const PointCounts& points) {
    const auto index = static_cast<size_t>(node);
    const Mesh& mesh = figure.segments[index];
    if (mesh.indices.empty()) return;
    fields_[index].emplace(Solid(mesh));
    const std::vector<Site> spread_out = spread(mesh, points.fine);
    patches_[index] = in_pieces(spread_out);
    const size_t few = std::min(points.coarse, spread_out.size());
    coarse_patches_[index] = in_pieces({spread_out.begin(), spread_out.begin() + static_cast<std::ptrdiff_t>(few)});
  };
  for (const char* name : {"spine_base", "neck_base", "head_base"})
    take(figure.skeleton.find(name), {0, 0});
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const ArmNodes arm = arm_nodes(figure.skeleton, side);
    take(arm.shoulder, kOfArm);
    take(arm.elbow, kOfArm);
    take(arm.wrist, kOfPalm);
    for (const auto& digit : arm.digits)
      for (const int node : digit)
        take(node, kOfDigit);
  }
}

SurfacePatch in_pieces(std::vector<Site> points) {
  SurfacePatch patch;
  patch.points = std::move(points);
  const auto count = static_cast<uint32_t>(patch.points.size());
  const SurfacePatch::Piece all = piece_of(patch.points, 0, count);
  patch.centre = all.centre;
  patch.radius = all.radius;
  divide(patch, 0, count);
  return patch;
}

SurfacePatch placed(const SurfacePatch& patch, const Transform& place) {
  SurfacePatch result = patch;
  result.centre = apply(place, patch.centre);
  for (Site& point : result.points)
    point = {apply(place, point.position), place.rotation * point.normal};
  for (SurfacePatch::Piece& piece : result.pieces)
    piece.centre = apply(place, piece.centre);
  return result;
}

}  // namespace auslan
