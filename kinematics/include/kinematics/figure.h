// SPDX-License-Identifier: Apache-2.0
// A figure: a skeleton and, for each node, a closed rigid segment mesh. What the importer makes, the bake stores and
// the models draw.
#pragma once

#include "kinematics/pose.h"
#include "kinematics/skeleton.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace auslan {

/// A displacement of some vertices of a mesh, scaled by one face channel.
struct Morph {
  FaceChannel channel = FaceChannel::kJawOpen;
  std::vector<uint32_t> vertices;       ///< indices into the mesh, ascending
  std::vector<glm::vec3> displacement;  ///< metres at weight 1, same length
};

/// An indexed triangle mesh in its node's frame (metres). Triangles wind counter-clockwise seen from outside.
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;    ///< unit, one per position
  std::vector<glm::u8vec4> colours;  ///< sRGB-encoded red, green, blue and alpha (always 255), one per position
  std::vector<uint32_t> indices;     ///< three per triangle, each below positions.size()
  std::vector<Morph> morphs;
};

struct Figure {
  std::string name;
  Skeleton skeleton;
  std::vector<Mesh> segments;  ///< one per node, in node order; may be empty for nodes without a surface of their own
};

}  // namespace auslan
