// SPDX-License-Identifier: Apache-2.0
// What of a figure can touch and be touched: each segment as a solid, and points spread over its surface.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/figure.h"
#include "kinematics/solid.h"
#include "synthesis/body_sites.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace auslan {

/// The points of one segment, and a ball that holds them; in the frame that the caller states.
struct SurfacePatch {
  std::vector<Site> points;
  Vec3 centre{0.0};
  double radius = 0.0;  ///< metres
};

class BodySurface {
 public:
  /// Measures the head, neck, trunk, arms and hands of a figure in the rest pose.
  explicit BodySurface(const Figure& figure);

  /// Nothing for a node without a surface.
  const Solid* solid(int node) const {
    const auto& solid = solids_[static_cast<size_t>(node)];
    return solid ? &*solid : nullptr;
  }
  /// Spread as evenly as the mesh allows, as are the first few of them; node frame.
  const SurfacePatch& patch(int node) const { return patches_[static_cast<size_t>(node)]; }

 private:
  std::vector<std::optional<Solid>> solids_;
  std::vector<SurfacePatch> patches_;
};

/// The same points with a ball about their mean.
SurfacePatch balled(SurfacePatch patch);

/// All points of a patch in the frame that `place` leads to.
SurfacePatch placed(const SurfacePatch& patch, const Transform& place);

/// The first `count` points of a patch, or all, where `place` leads to.
struct PlacedPatch {
  const SurfacePatch* patch = nullptr;
  Transform place;
  size_t count = SIZE_MAX;
};

}  // namespace auslan
