// SPDX-License-Identifier: Apache-2.0
// What the models have in common: a segment that can be drawn, and its face morphs. Everything here is float, as the
// meshes are: only + - * / and sqrt, in a fixed order.
#pragma once

#include "kinematics/body_model.h"

#include <cstdint>
#include <vector>

namespace auslan {

enum class Normals { kOfTriangles, kOfVertices };

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& fallback);
glm::mat4 matrix_of(const Transform& placement);

/// Each triangle gets three vertices of its own, the flat normal at each, and its colours averaged.
Mesh with_facets(const Mesh& mesh);

/// One segment that can be drawn, with what its morphs need.
class Segment {
 public:
  Segment(int node, Mesh mesh, Normals kind);

  /// Placed nowhere yet. The spans stay valid as long as the segment is not moved.
  PosedMesh view() const;
  uint64_t revision() const { return revision_; }
  const Mesh& rest() const { return mesh_; }

  void apply(const FaceWeights& face);

 private:
  bool same_weights(const FaceWeights& face) const;
  void find_affected();
  void flat_normals();
  void sum_areas(const std::vector<glm::vec3>& positions);
  void smooth_normals();

  int node_;
  Normals kind_;
  Mesh mesh_;
  std::vector<glm::vec3> posed_positions_, posed_normals_;
  std::vector<glm::vec3> sums_, rest_sums_;
  std::vector<uint32_t> moved_, tilted_;  // vertices, ascending
  std::vector<uint32_t> triangles_;       // first indices of the triangles at the tilted vertices
  FaceWeights applied_{};
  uint64_t revision_ = 1;
};

}  // namespace auslan
