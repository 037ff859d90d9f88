// SPDX-License-Identifier: Apache-2.0
// How deep the trunk is at every height and breadth, measured once on the figure, so that arms can be kept out of it.
#pragma once

#include "kinematics/figure.h"
#include "kinematics/vector.h"

#include <vector>

namespace auslan {

class TrunkProfile {
 public:
  /// Casts rays at the trunk's segment (spine_base) from the front and from behind, on a grid of about 2 cm.
  static TrunkProfile measure(const Figure& figure);

  /// How deep a ball of this radius (metres) at a point (world space, body at rest) lies in the trunk: 0 outside.
  double depth(const Vec3& point, double radius) const;

 private:
  /// Front and back of the trunk at a place; front below back where there is no trunk.
  struct Cell {
    double front = -1, back = 1;
  };
  double left_ = 0, bottom_ = 0, step_ = 0.02;
  int columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace auslan
