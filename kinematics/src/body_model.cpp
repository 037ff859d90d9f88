// SPDX-License-Identifier: Apache-2.0
#include "kinematics/body_model.h"

#include "segment.h"

#include <cstddef>
#include <vector>

namespace auslan {
namespace {

class RigidModel final : public BodyModel {
 public:
  RigidModel(const Figure& figure, Normals kind) {
    for (size_t node = 0; node < figure.segments.size(); ++node) {
      const Mesh& mesh = figure.segments[node];
      if (mesh.indices.empty()) continue;
      segments_.emplace_back(static_cast<int>(node), kind == Normals::kOfTriangles ? with_facets(mesh) : mesh, kind);
    }
    // Only now: a segment's vectors must stay where the views point.
    for (const Segment& segment : segments_)
      posed_.push_back(segment.view());
  }

  std::span<const PosedMesh> pose(std::span<const Transform> world_from_node, const FaceWeights& face) override {
    for (size_t i = 0; i < segments_.size(); ++i) {
      segments_[i].apply(face);
      posed_[i].revision = segments_[i].revision();
      posed_[i].world_from_mesh = matrix_of(world_from_node[static_cast<size_t>(posed_[i].node)]);
    }
    return posed_;
  }

 private:
  std::vector<Segment> segments_;
  std::vector<PosedMesh> posed_;
};

}  // namespace

std::unique_ptr<BodyModel> make_rigid_flat(const Figure& figure) {
  return std::make_unique<RigidModel>(figure, Normals::kOfTriangles);
}

std::unique_ptr<BodyModel> make_rigid_gouraud(const Figure& figure) {
  return std::make_unique<RigidModel>(figure, Normals::kOfVertices);
}

}  // namespace auslan
