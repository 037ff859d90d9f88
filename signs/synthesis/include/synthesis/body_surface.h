// SPDX-License-Identifier: Apache-2.0
// What of a figure can touch and be touched: each segment as a solid, and points spread over its surface.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/distance_field.h"
#include "kinematics/figure.h"
#include "synthesis/body_sites.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace auslan {

/// The points of one segment, a ball that holds them, and smaller ones round a few neighbours each; in the frame that
/// the caller states.
struct SurfacePatch {
  struct Piece {
    Vec3 centre{0.0};
    double radius = 0.0;            ///< metres
    uint32_t first = 0, count = 0;  ///< of the patch's points
  };
  std::vector<Site> points;
  Vec3 centre{0.0};
  double radius = 0.0;  ///< metres
  std::vector<Piece> pieces;
};

class BodySurface {
 public:
  /// Measures the head, neck, trunk, arms and hands of a figure in the rest pose. `closely`: with points between the
  /// corners of large triangles too, and more of the few.
  explicit BodySurface(const Figure& figure, bool closely = false);

  /// Nothing for a node without a surface.
  const DistanceField* field(int node) const {
    const auto& field = fields_[static_cast<size_t>(node)];
    return field ? &*field : nullptr;
  }
  /// Spread as evenly as the mesh allows; node frame.
  const SurfacePatch& patch(int node) const { return patches_[static_cast<size_t>(node)]; }
  /// The same with far fewer points, for what need not be told so closely.
  const SurfacePatch& coarse_patch(int node) const { return coarse_patches_[static_cast<size_t>(node)]; }

 private:
  std::vector<std::optional<DistanceField>> fields_;
  std::vector<SurfacePatch> patches_, coarse_patches_;
};

/// Points in an order in which neighbours follow each other, and balls round them.
SurfacePatch in_pieces(std::vector<Site> points);

/// All points of a patch in the frame that `place` leads to.
SurfacePatch placed(const SurfacePatch& patch, const Transform& place);

/// A patch where `place` leads to.
struct PlacedPatch {
  const SurfacePatch* patch = nullptr;
  Transform place;
};

}  // namespace auslan
