// SPDX-License-Identifier: Apache-2.0
// From a pose of a foreign figure to the places of its vertices: world matrices, morph targets, linear-blend skinning.
#pragma once

#include "kinematics/avatar.h"

#include <span>
#include <vector>

namespace auslan {

struct AvatarPose {
  std::vector<Quat> rotation;                     ///< parent_from_node, in place of the rest's; one a node, unit
  std::vector<std::vector<float>> morph_weights;  ///< one list a mesh, one weight a morph
  Vec3 translation{0.0};                          ///< added to every root, metres
};

/// The pose in which the file shows the figure; the weights are the meshes'.
AvatarPose rest_pose(const Avatar& avatar);

/// world_from_node for every node, one element each. Allocates nothing.
void place_nodes(const Avatar& avatar, const AvatarPose& pose, std::span<glm::dmat4> world_from_node);

/// Poses one figure again and again without allocating. The avatar outlives it.
class AvatarPoser {
 public:
  /// Vertices of one mesh on one node, in the world (metres).
  struct Part {
    int node = 0;
    int mesh = 0;
    int vertices = 0;  ///< into AvatarMesh::vertices
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  ///< unit
  };

  explicit AvatarPoser(const Avatar& avatar);

  /// Linear-blend skinning; a skinned mesh does not move with its own node (glTF 2.0, 3.7.3.3). Bones turn normals
  /// as they turn positions, which is right as long as they do not scale unevenly.
  void pose(const AvatarPose& pose);
  /// The same with every node placed by the caller; `morph_weights` as in AvatarPose.
  void place(std::span<const glm::dmat4> world_from_node, std::span<const std::vector<float>> morph_weights);

  std::span<const Part> parts() const { return parts_; }
  std::span<const glm::dmat4> world_from_node() const { return world_from_node_; }

 private:
  void pose_parts(std::span<const std::vector<float>> morph_weights);
  void place_joints(int skin_of_node);
  void pose_part(std::span<const std::vector<float>> morph_weights, Part& part);

  const Avatar& avatar_;
  std::vector<glm::dmat4> world_from_node_;
  std::vector<glm::dmat4> world_from_mesh_;  ///< by joint of the skin at hand
  std::vector<Part> parts_;
};

}  // namespace auslan
