// SPDX-License-Identifier: Apache-2.0
#include "synthesis/body_surface.h"

#include "kinematics/rotation.h"

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
// Closely: what the corners of an arm's large triangles leave out, a breast may go into.
constexpr PointCounts kCloselyOfDigit{72, 42}, kCloselyOfPalm{240, 144}, kCloselyOfArm{900, 216};
constexpr uint32_t kPiece = 10;  // points of a piece that is not divided

double squared(const Vec3& v) {
  return glm::dot(v, v);
}

/// A mesh's vertices, and the middles of its triangles if they are wanted.
std::vector<Site> sites_of(const Mesh& mesh, bool middles) {
  std::vector<Site> sites;
  for (size_t i = 0; i < mesh.positions.size(); ++i)
    sites.push_back({Vec3(mesh.positions[i]), Vec3(mesh.normals[i])});
  for (size_t i = 0; middles && i + 2 < mesh.indices.size(); i += 3) {
    const Site &a = sites[mesh.indices[i]], &b = sites[mesh.indices[i + 1]], &c = sites[mesh.indices[i + 2]];
    sites.push_back({(a.position + b.position + c.position) / 3.0, unit(a.normal + b.normal + c.normal, a.normal)});
  }
  return sites;
}

/// Each next point is the one farthest from all before it (Gonzalez 1985).
std::vector<Site> spread(std::span<const Site> sites, size_t count) {
  std::vector<Site> points;
  std::vector<double> distance(sites.size(), 1e9);
  size_t next = 0;
  while (points.size() < std::min(count, sites.size())) {
    points.push_back(sites[next]);
    size_t farthest = 0;
    for (size_t i = 0; i < sites.size(); ++i) {
      distance[i] = std::min(distance[i], squared(sites[i].position - points.back().position));
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

BodySurface::BodySurface(const Figure& figure, bool closely)
    : fields_(figure.segments.size()), patches_(figure.segments.size()), coarse_patches_(figure.segments.size()) {
  const auto take = [&](int node, const PointCounts& points) {
    const auto index = static_cast<size_t>(node);
    const Mesh& mesh = figure.segments[index];
    if (mesh.indices.empty()) return;
    fields_[index].emplace(Solid(mesh));
    const std::vector<Site> spread_out = spread(sites_of(mesh, closely), points.fine);
    patches_[index] = in_pieces(spread_out);
    const size_t few = std::min(points.coarse, spread_out.size());
    coarse_patches_[index] = in_pieces({spread_out.begin(), spread_out.begin() + static_cast<std::ptrdiff_t>(few)});
  };
  for (const char* name : {"spine_base", "neck_base", "head_base"})
    take(figure.skeleton.find(name), {0, 0});
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const ArmNodes arm = arm_nodes(figure.skeleton, side);
    take(arm.shoulder, closely ? kCloselyOfArm : kOfArm);
    take(arm.elbow, closely ? kCloselyOfArm : kOfArm);
    take(arm.wrist, closely ? kCloselyOfPalm : kOfPalm);
    for (const auto& digit : arm.digits)
      for (const int node : digit)
        take(node, closely ? kCloselyOfDigit : kOfDigit);
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
