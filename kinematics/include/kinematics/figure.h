// SPDX-License-Identifier: Apache-2.0
// A figure: a skeleton and, for each node, a closed rigid segment mesh. What the importer makes, the bake stores and
// the models draw.
#pragma once

#include "kinematics/pose.h"
#include "kinematics/result.h"
#include "kinematics/skeleton.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

/// A displacement of some vertices of a mesh, scaled by one face channel.
struct Morph {
  FaceChannel channel = FaceChannel::kJawOpen;
  std::vector<uint32_t> vertices;       ///< indices into the mesh, ascending
  std::vector<glm::vec3> displacement;  ///< metres at weight 1, same length
};

/// What a vertex is painted with, whatever the colours are: a mixture of two pigments of the figure's appearance, made
/// darker or lighter. Occlusion that moves with the segment is part of the shade.
struct Paint {
  uint8_t first = 0, second = 0;  ///< pigments
  uint8_t share = 0;              ///< of the second, in 255ths
  uint8_t shade = kFullShade;     ///< the mixture is multiplied by shade / kFullShade
  static constexpr uint8_t kFullShade = 200;
  bool operator==(const Paint&) const = default;
};

/// The colours of one look of a figure.
struct Appearance {
  std::string name;
  glm::u8vec3 background{0};          ///< sRGB; what hands and face stand out against
  std::vector<glm::u8vec3> pigments;  ///< sRGB; as many in each appearance of a figure
};

/// An indexed triangle mesh in its node's frame (metres). Triangles wind counter-clockwise seen from outside.
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;    ///< unit, one per position
  std::vector<glm::u8vec4> colours;  ///< sRGB-encoded red, green, blue and alpha (always 255), one per position
  std::vector<Paint> paint;          ///< one per position, or none: then no appearance changes the colours
  std::vector<uint32_t> indices;     ///< three per triangle, each below positions.size()
  std::vector<Morph> morphs;
};

struct Figure {
  std::string name;
  Skeleton skeleton;
  std::vector<Mesh> segments;  ///< one per node, in node order; may be empty for nodes without a surface of their own
  std::vector<Appearance> appearances;  ///< looks to choose from; as it comes, a figure has the colours of the first
};

/// The colour of a paint, opaque: pigments mixed as sRGB code values, rounded, at most 255. Integers only.
glm::u8vec4 painted(const Paint& paint, const Appearance& appearance);

/// Gives every painted mesh the colours of an appearance, which is returned. kUsage, with the names there are, for a
/// name that the figure does not have.
Result<const Appearance*> put_on(Figure& figure, std::string_view name);

}  // namespace auslan
