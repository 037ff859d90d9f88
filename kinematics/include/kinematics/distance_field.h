// SPDX-License-Identifier: Apache-2.0
// How far points are from a solid's surface, asked many thousand times about the same places: nearly exact, and for a
// hundredth of what the nearest triangle costs.
#pragma once

#include "kinematics/solid.h"

#include <memory>
#include <optional>

namespace auslan {

/// The surface as a point sees it.
struct SurfacePlane {
  double distance = 0.0;  ///< metres; negative for a point inside
  Vec3 normal{0.0};       ///< unit; the way out
};

/// A solid's signed distance in cells of 3.5 to 7 mm, a fifth of its least extent: in each it is that from the plane
/// which touches the surface where it is nearest to the cell's middle. Off a surface of radius r it is short by the
/// square of the way to the side over 2 r, half a millimetre at most on a fingertip; nothing outside a convex body is
/// told to be farther off than it is, and nothing at all is off by more than two cells. Cells are made when they are
/// first asked for; what one answers depends on nothing that was asked before, and threads may ask at the same time.
class DistanceField {
 public:
  explicit DistanceField(Solid solid);
  DistanceField(DistanceField&&) noexcept;
  DistanceField& operator=(DistanceField&&) noexcept;
  ~DistanceField();

  const Solid& solid() const;

  /// How far a point has to move at least to be deeper than `depth` metres; 0 where that is not told without asking the
  /// solid itself.
  double clear_of(const Vec3& point, double depth) const;

  /// A point in the mesh's frame. Total: of a solid that is empty everything is far outside.
  SurfacePlane at(const Vec3& point) const;

  /// The same for a point that lies deeper than `depth` metres (negative: or outside, but nearer than that); nothing
  /// for any other, and then `above` is how far it has to move at least to be so deep, metres.
  std::optional<SurfacePlane> below(const Vec3& point, double depth, double& above) const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace auslan
