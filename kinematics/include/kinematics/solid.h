// SPDX-License-Identifier: Apache-2.0
// A mesh as a body with an inside: how far a point lies from its surface, or how deep below it.
#pragma once

#include "kinematics/figure.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace auslan {

/// The place of a surface that is nearest to a point, in the mesh's frame.
struct NearestSurface {
  Vec3 position{0.0};
  Vec3 normal{0.0};     ///< unit, outwards; where edges meet, the mean of their triangles weighted by angle
  double distance = 0;  ///< metres; negative for a point inside
};

/// One or more closed parts that may overlap, as a figure's segments are. Built once, asked often; owns what it needs.
///
/// Whether a point is inside is told by the angle-weighted normal of the nearest vertex, edge or triangle of each part
/// (Baerentzen & Aanaes 2005), which is exact for closed parts that do not cut themselves. Parts with a rim, as foreign
/// figures have them, are taken as one surface: near a rim a point may be told on the wrong side.
class Solid {
 public:
  /// The mesh passes check_figure. An empty one makes a solid that is nowhere.
  explicit Solid(const Mesh& mesh);

  /// Nothing when the surface is farther than `within` metres. A point inside several parts is as deep as in the one in
  /// which it is deepest: never deeper than it truly is below the surface of all of them together.
  std::optional<NearestSurface> nearest(const Vec3& point, double within) const;

  /// Whether a part winds round the point by more than half (the generalised winding number of Jacobson, Kavan &
  /// Sorkine-Hornung 2013). It takes every triangle, so it is slow; it is right where the sign of nearest() may not be:
  /// where a surface touches itself, as lips do, and near a rim.
  bool contains(const Vec3& point) const;

  /// A box that holds everything, mesh frame; low > high for an empty solid.
  const Vec3& low() const { return low_; }
  const Vec3& high() const { return high_; }

 private:
  struct Triangle {
    std::array<Vec3, 3> corner;
    Vec3 middle{0.0};                     ///< of a ball that holds it
    double radius = 0.0;                  ///< metres
    Vec3 normal{0.0};                     ///< unit, or zero without area
    std::array<Vec3, 3> edge_normal{};    ///< of corner i to corner i + 1; any length
    std::array<Vec3, 3> corner_normal{};  ///< any length
  };
  /// A node of a part's tree: a box round some triangles, two nodes or a few triangles below it.
  struct Box {
    Vec3 low, high;
    uint32_t first = 0;  ///< of its triangles; of a node with children: the first child, the other follows
    uint32_t count = 0;  ///< of its triangles; 0: it has children
  };
  /// The same tree as it is asked: four boxes side by side. Unused ones are far away.
  struct FourBoxes {
    std::array<std::array<double, 4>, 3> middle, half;  ///< by axis
    std::array<uint32_t, 4> first{};  ///< of a box's triangles, or the four boxes below it
    std::array<uint32_t, 4> count{};  ///< of a box's triangles; 0: there are boxes below it
  };
  struct Part {
    std::vector<Triangle> triangles;
    Vec3 low{0.0}, high{0.0};
    std::vector<FourBoxes> tree;  ///< the root first
  };

  static Part make_part(std::span<const glm::vec3> positions, std::span<const uint32_t> indices,
                        std::span<const uint32_t> triangles);
  static void divide(const Part& part, std::vector<Box>& boxes, uint32_t box, std::span<uint32_t> order);
  static uint32_t add_four(Part& part, std::span<const Box> boxes, uint32_t box);
  static std::optional<NearestSurface> nearest_of(const Part& part, const Vec3& point, double within);

  std::vector<Part> parts_;
  Vec3 low_{1.0}, high_{-1.0};
};

}  // namespace auslan
