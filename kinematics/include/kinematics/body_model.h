// SPDX-License-Identifier: Apache-2.0
// The paper's interchangeable model classes: what turns a posed skeleton into meshes that can be drawn.
#pragma once

#include "kinematics/figure.h"
#include "kinematics/image_wrap.h"

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>

namespace auslan {

/// One mesh ready to draw. The spans belong to the model and are valid until its next pose() or its end. Positions and
/// normals are in the mesh's own frame; as many normals and colours as positions; three indices a triangle.
struct PosedMesh {
  int node = kNoNode;  ///< the node it is the segment of
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;
  std::span<const glm::u8vec4> colours;
  std::span<const uint32_t> indices;
  glm::mat4 world_from_mesh{1.0F};
  /// Never 0; another number whenever the contents of the spans are not what they were at the last pose().
  uint64_t revision = 1;
  /// An image by which the colours are multiplied, of those that whoever draws has for the figure; -1: none.
  int image = -1;
  std::span<const glm::vec2> texture_coordinates = {};  ///< one a position, as glTF has them
  ImageWrap wrap_u = ImageWrap::kRepeat, wrap_v = ImageWrap::kRepeat;
  float alpha_cutoff = 0.0F;  ///< of the image's alpha: what is below is not drawn
};

class BodyModel {
 public:
  BodyModel() = default;
  BodyModel(const BodyModel&) = delete;
  BodyModel& operator=(const BodyModel&) = delete;
  virtual ~BodyModel() = default;

  /// The meshes of the figure posed so, in node order (nodes without a surface have none). `world_from_node` as
  /// forward() fills it. Applies the face weights to the segments that have morphs. Allocates nothing after the first
  /// call.
  virtual std::span<const PosedMesh> pose(std::span<const Transform> world_from_node, const FaceWeights& face) = 0;
};

/// Rigid segments whose triangles each have corners and a normal of their own: facets show.
std::unique_ptr<BodyModel> make_rigid_flat(const Figure& figure);
/// Rigid segments with the figure's own vertices and normals.
std::unique_ptr<BodyModel> make_rigid_gouraud(const Figure& figure);
/// Segments whose surfaces bend near their joints, so that they pass into each other without a seam; forearm and upper
/// arm twist along their length. Made from the same figure: no weights are needed in it.
std::unique_ptr<BodyModel> make_skinned(const Figure& figure);

}  // namespace auslan
