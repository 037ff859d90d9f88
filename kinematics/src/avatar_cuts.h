// SPDX-License-Identifier: Apache-2.0
// Where the surface of a foreign figure is cut into segments, and the lids that close them.
#pragma once

#include "kinematics/figure.h"

#include <array>
#include <span>
#include <vector>

namespace auslan::fit {

/// The edges of the triangles that each segment got, or nobody.
class Cuts {
 public:
  /// A triangle, world space. kNoNode: it is left out.
  void add(int node, const std::array<glm::vec3, 3>& corner);

  /// Closes every cut with a fan about the middle of its rim, so that a segment has an inside that ends at its joints.
  /// What is open in the file stays open.
  void close(Figure& figure);

 private:
  /// Between two places, as a triangle of the segment has it: from low to high, or turned.
  struct Edge {
    glm::vec3 low, high;
    int node;
    bool turned;
  };

  /// A fan for each of the rims that hang together.
  static void add_fans(std::span<const Edge> edges, const glm::vec3& origin, Mesh& mesh);
  static void add_fan(std::span<const Edge> rim, const glm::vec3& origin, Mesh& mesh);

  std::vector<Edge> edges_;
};

}  // namespace auslan::fit
