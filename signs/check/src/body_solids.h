// SPDX-License-Identifier: Apache-2.0
// Which parts of a posed body are inside each other, and how deep.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/figure.h"
#include "kinematics/solid.h"

#include <array>
#include <optional>
#include <span>
#include <string>
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

class BodySolids {
 public:
  explicit BodySolids(const Figure& figure);

  /// The deepest overlap of each two groups that are not joined to each other, for every such pair that overlaps.
  std::vector<Overlap> overlaps(std::span<const Transform> world_from_node) const;

  /// How far a point in the world lies from the surface of a group, metres, negative inside; nothing when farther than
  /// `within`.
  std::optional<double> distance(BodyGroup group, const Vec3& point, double within,
                                 std::span<const Transform> world_from_node) const;

  std::span<const int> nodes_of(BodyGroup group) const { return nodes_[static_cast<size_t>(group)]; }

 private:
  struct Part {
    Solid solid;
    std::vector<Vec3> vertices;  ///< node frame
    Vec3 centre{0.0};
    double radius = 0.0;
  };
  /// How deep vertices of one part lie in the other.
  double depth(const Part& points, const Transform& world_from_points, const Part& solid,
               const Transform& world_from_solid) const;

  std::vector<std::optional<Part>> parts_;  ///< by node; nothing for those without a surface
  std::array<std::vector<int>, kBodyGroupCount> nodes_;
};

}  // namespace auslan
