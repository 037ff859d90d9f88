// SPDX-License-Identifier: Apache-2.0
#include "occlusion.h"

#include "field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace auslan::sculpt {

namespace {

constexpr int kRays = 40;
/// No more than so much of the half space counts as hidden.
constexpr double kMost = 0.45;
/// Rays start so far above the surface, millimetres, that they do not hit where they start.
constexpr double kLift = 0.6;

struct Triangle {
  Vec3 a, ab, ac;
};

struct Box {
  Vec3 low{1e30}, high{-1e30};
  void add(const Vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

/// Triangles in a tree of boxes. Millimetres, world space.
class Scene {
 public:
  explicit Scene(std::span<const Occluder> occluders) {
    for (const Occluder& occluder : occluders) {
      const Mesh& mesh = occluder.sculpture->mesh;
      const std::vector<double>& share = occluder.sculpture->occlusion;
      const auto point = [&](size_t i) { return (Vec3(mesh.positions[mesh.indices[i]]) + occluder.place) * 1000.0; };
      for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        if (share[mesh.indices[i]] + share[mesh.indices[i + 1]] + share[mesh.indices[i + 2]] <= 0.0) continue;
        const Vec3 a = point(i);
        triangles_.push_back({a, point(i + 1) - a, point(i + 2) - a});
      }
    }
    if (!triangles_.empty()) split(0, triangles_.size());
  }

  /// The distance to the nearest triangle within `reach`, else `reach`. `direction` is unit.
  double nearest(const Vec3& origin, const Vec3& direction, double reach) const {
    double best = reach;
    std::array<uint32_t, 64> waiting{};
    size_t count = 0;
    if (!nodes_.empty()) waiting[count++] = 0;
    while (count > 0) {
      const Node& node = nodes_[waiting[--count]];
      if (!crosses(node.box, origin, direction, best)) continue;
      if (node.second == 0) {
        for (size_t i = node.begin; i < node.end; ++i)
          hit(triangles_[i], origin, direction, best);
        continue;
      }
      waiting[count++] = static_cast<uint32_t>(&node - nodes_.data()) + 1;
      waiting[count++] = node.second;
    }
    return best;
  }

 private:
  struct Node {
    Box box;
    size_t begin = 0, end = 0;
    uint32_t second = 0;  ///< the second child; the first follows its parent. 0: a leaf
  };

  void split(size_t begin, size_t end) {
    constexpr size_t kLeaf = 6;
    const size_t self = nodes_.size();
    nodes_.emplace_back();
    Box box, middles;
    for (size_t i = begin; i < end; ++i) {
      const Triangle& t = triangles_[i];
      box.add(t.a);
      box.add(t.a + t.ab);
      box.add(t.a + t.ac);
      middles.add(t.a);
    }
    nodes_[self].box = box;
    nodes_[self].begin = begin;
    nodes_[self].end = end;
    const Vec3 extent = middles.high - middles.low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
    if (end - begin <= kLeaf || !(extent[axis] > 0.0)) return;
    // Stable, so that equal places keep their order on every machine.
    std::stable_sort(triangles_.begin() + static_cast<std::ptrdiff_t>(begin),
                     triangles_.begin() + static_cast<std::ptrdiff_t>(end),
                     [axis](const Triangle& p, const Triangle& q) { return p.a[axis] < q.a[axis]; });
    const size_t middle = begin + (end - begin) / 2;
    split(begin, middle);
    nodes_[self].second = static_cast<uint32_t>(nodes_.size());
    split(middle, end);
  }

  static bool crosses(const Box& box, const Vec3& origin, const Vec3& direction, double reach) {
    double enter = 0.0, leave = reach;
    for (int axis = 0; axis < 3; ++axis) {
      if (direction[axis] == 0.0) {
        if (origin[axis] < box.low[axis] || origin[axis] > box.high[axis]) return false;
        continue;
      }
      const double p = (box.low[axis] - origin[axis]) / direction[axis];
      const double q = (box.high[axis] - origin[axis]) / direction[axis];
      enter = std::max(enter, std::min(p, q));
      leave = std::min(leave, std::max(p, q));
    }
    return enter <= leave;
  }

  /// Moeller and Trumbore 1997, both sides.
  static void hit(const Triangle& t, const Vec3& origin, const Vec3& direction, double& best) {
    const Vec3 p = glm::cross(direction, t.ac);
    const double determinant = glm::dot(t.ab, p);
    if (determinant == 0.0) return;
    const Vec3 from = origin - t.a;
    const double u = glm::dot(from, p) / determinant;
    if (u < 0.0 || u > 1.0) return;
    const Vec3 q = glm::cross(from, t.ab);
    const double v = glm::dot(direction, q) / determinant;
    if (v < 0.0 || u + v > 1.0) return;
    const double along = glm::dot(t.ac, q) / determinant;
    if (along > 0.0 && along < best) best = along;
  }

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

/// Directions over the half space round +Z, denser about the pole as the cosine is (Malley's method), along the golden
/// spiral.
std::vector<Vec3> cosine_directions() {
  std::vector<Vec3> directions;
  for (int i = 0; i < kRays; ++i) {
    const double share = (i + 0.5) / kRays;
    const double radius = std::sqrt(share);
    const Angle turn = angle_deg(137.50776405003785 * i);
    directions.emplace_back(radius * turn.cosine, radius * turn.sine, std::sqrt(1.0 - share));
  }
  return directions;
}

}  // namespace

void bake_occlusion(Sculpture& sculpture, const Vec3& place, std::span<const Occluder> occluders, double reach,
                    double strength) {
  const Scene scene(occluders);
  const std::vector<Vec3> directions = cosine_directions();
  Mesh& mesh = sculpture.mesh;
  for (uint32_t i = 0; i < mesh.positions.size(); ++i) {
    const uint32_t other = sculpture.mirror[i];
    if (other < i) {
      mesh.paint[i].shade = mesh.paint[other].shade;
      continue;
    }
    if (sculpture.occlusion[i] <= 0.0) continue;
    const Vec3 normal(mesh.normals[i]);
    const Vec3 side =
        normalised(glm::cross(normal.y * normal.y < 0.8 ? Vec3(0.0, 1.0, 0.0) : Vec3(1.0, 0.0, 0.0), normal));
    const Vec3 up = glm::cross(normal, side);
    const Vec3 origin = (Vec3(mesh.positions[i]) + place) * 1000.0 + normal * kLift;
    double hidden = 0.0;
    for (const Vec3& d : directions) {
      const double far = scene.nearest(origin, side * d.x + up * d.y + normal * d.z, reach) / reach;
      hidden += (1.0 - far) * (1.0 - far);
    }
    // What is buried in another part would darken the visible end of its edges.
    const double share = std::min(hidden / kRays, kMost);
    const double light = 1.0 - strength * sculpture.occlusion[i] * share;
    mesh.paint[i].shade = static_cast<uint8_t>(mesh.paint[i].shade * light + 0.5);
  }
}

}  // namespace auslan::sculpt
