// SPDX-License-Identifier: Apache-2.0
// The measured skeleton with two boxes on it: small enough to know every number. Tests only.
#pragma once

#include "kinematics/figure.h"
#include "measured_skeleton.h"

#include <array>
#include <vector>

namespace auslan::test {

/// A cube of half width 20 mm about the origin: eight vertices shared by twelve triangles, normals along the diagonals.
inline Mesh box_mesh() {
  Mesh mesh;
  const float diagonal = 0.57735026919F;
  for (int i = 0; i < 8; ++i) {
    const glm::vec3 corner((i & 1) != 0 ? 1.0F : -1.0F, (i & 2) != 0 ? 1.0F : -1.0F, (i & 4) != 0 ? 1.0F : -1.0F);
    mesh.positions.push_back(corner * 0.02F);
    mesh.normals.push_back(corner * diagonal);
    mesh.colours.emplace_back(30 * i, 100, 200, 255);
  }
  mesh.indices = {1, 3, 7, 1, 7, 5,   // +x
                  0, 6, 2, 0, 4, 6,   // -x
                  2, 6, 7, 2, 7, 3,   // +y
                  0, 1, 5, 0, 5, 4,   // -y
                  4, 5, 7, 4, 7, 6,   // +z
                  0, 3, 1, 0, 2, 3};  // -z
  return mesh;
}

/// Boxes for head_base and wrist_l. The head's jaw channel lifts the top (+y) corners by 40 mm; its pucker channel
/// moves one corner (+x +y +z) by 20 mm along z.
inline Figure box_figure() {
  Figure figure;
  figure.name = "boxes";
  figure.skeleton = measured_skeleton();
  figure.segments.resize(static_cast<size_t>(figure.skeleton.size()));
  Mesh head = box_mesh();
  head.morphs.push_back({FaceChannel::kJawOpen, {2, 3, 6, 7}, std::vector<glm::vec3>(4, glm::vec3(0.0F, 0.04F, 0.0F))});
  head.morphs.push_back({FaceChannel::kMouthPucker, {7}, {glm::vec3(0.0F, 0.0F, 0.02F)}});
  figure.segments[static_cast<size_t>(figure.skeleton.find("head_base"))] = head;
  figure.segments[static_cast<size_t>(figure.skeleton.find("wrist_l"))] = box_mesh();
  return figure;
}

}  // namespace auslan::test
