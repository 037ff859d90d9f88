// SPDX-License-Identifier: Apache-2.0
// Which parts of a posed body are inside each other, and how deep.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/figure.h"
#include "kinematics/solid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace auslan {

/// What parts are counted together: two hands that touch may do so with any finger.
enum class BodyGroup {
  kHead,
  kTrunk,
  kLeftUpperArm,
  kLeftForearm,
  kLeftHand,
  kRightUpperArm,
  kRightForearm,
  kRightHand
};
inline constexpr size_t kBodyGroupCount = 8;

struct Overlap {
  BodyGroup a = BodyGroup::kHead, b = BodyGroup::kHead;
  int node_a = kNoNode, node_b = kNoNode;
  double depth = 0.0;  ///< metres
};

/// The place of a group's surface that is nearest to a point, in the world.
struct NearestSkin {
  int node = kNoNode;
  NearestSurface surface;
};

class BodySolids {
 public:
  explicit BodySolids(const Figure& figure);

  /// Groups that are not joined to each other, so that they can be apart.
  static std::span<const std::pair<BodyGroup, BodyGroup>> pairs();

  /// The deepest vertex of one group in the other, when it lies deeper than `floor` metres (at least 0). Two parts that
  /// both are where they were `before` are passed over; empty: none are.
  std::optional<Overlap> overlap(BodyGroup a, BodyGroup b, double floor, std::span<const Transform> world_from_node,
                                 std::span<const Transform> before = {}) const;

  /// The deepest overlap of each of pairs() that overlaps.
  std::vector<Overlap> overlaps(std::span<const Transform> world_from_node) const;

  /// Nothing when the surface is farther than `within` metres. Inside several parts: where it is deepest.
  std::optional<NearestSkin> nearest(BodyGroup group, const Vec3& point, double within,
                                     std::span<const Transform> world_from_node) const;
  /// How far that is, metres, negative inside.
  std::optional<double> distance(BodyGroup group, const Vec3& point, double within,
                                 std::span<const Transform> world_from_node) const;

  /// Whether the line from `from` to `to` passes within a group's bounding balls: if not, it meets nothing of the
  /// group.
  bool may_cross(BodyGroup group, const Vec3& from, const Vec3& to, std::span<const Transform> world_from_node) const;

  std::span<const int> nodes_of(BodyGroup group) const { return nodes_[static_cast<size_t>(group)]; }

 private:
  /// A ball round some vertices, halves of them in two balls below it.
  struct Ball {
    Vec3 centre{0.0};
    double radius = 0.0;
    uint32_t first = 0, count = 0;  ///< of its vertices
    uint32_t below = 0;             ///< the first of its two children, the other follows; 0: none
  };
  struct Part {
    Solid solid;
    std::vector<Vec3> vertices;  ///< node frame, each place once, in the order of the balls
    std::vector<Ball> balls;     ///< the root first
    /// No point of a closed surface lies deeper below it, metres: what is inside a box is no thicker than the box.
    double thickness = 0.0;
  };
  static void divide(Part& part, uint32_t ball);
  /// Calls `found(place in the solid, depth)` for vertices that the solid's surface tells to be inside it; it returns
  /// the depth from which on they are of interest.
  template <typename Found>
  static void each_inside(const Part& points, const Transform& solid_from_points, const Part& solid,
                          const Found& found);
  /// How deep vertices of one part lie in the other, where that is more than `floor`, else `floor`.
  static double depth(const Part& points, const Transform& world_from_points, const Part& solid,
                      const Transform& world_from_solid, double floor);

  std::vector<std::optional<Part>> parts_;  ///< by node; nothing for those without a surface
  std::array<std::vector<int>, kBodyGroupCount> nodes_;
};

}  // namespace auslan
