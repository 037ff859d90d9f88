// SPDX-License-Identifier: Apache-2.0
#include "kinematics/avatar_pose.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace auslan {
namespace {

glm::dmat4 parent_from_node(const AvatarNode& node, const Quat& rotation, const Vec3& translation) {
  const Mat3 turned = glm::mat3_cast(rotation);
  return {glm::dvec4(turned[0] * node.scale.x, 0.0), glm::dvec4(turned[1] * node.scale.y, 0.0),
          glm::dvec4(turned[2] * node.scale.z, 0.0), glm::dvec4(translation, 1.0)};
}

glm::vec3 unit_or_up(const Vec3& v) {
  const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0F, 1.0F, 0.0F);
}

}  // namespace

AvatarPose rest_pose(const Avatar& avatar) {
  AvatarPose pose;
  for (const AvatarNode& node : avatar.nodes)
    pose.rotation.push_back(node.rotation);
  for (const AvatarMesh& mesh : avatar.meshes)
    pose.morph_weights.push_back(mesh.morph_weights);
  for (const AvatarNode& node : avatar.nodes)
    if (node.mesh >= 0 && !node.morph_weights.empty())
      pose.morph_weights[static_cast<size_t>(node.mesh)] = node.morph_weights;
  return pose;
}

void place_nodes(const Avatar& avatar, const AvatarPose& pose, std::span<glm::dmat4> world_from_node) {
  assert(pose.rotation.size() == avatar.nodes.size() && world_from_node.size() == avatar.nodes.size());
  for (size_t i = 0; i < avatar.nodes.size(); ++i) {
    const AvatarNode& node = avatar.nodes[i];
    if (node.parent == kNoNode)
      world_from_node[i] = parent_from_node(node, pose.rotation[i], node.translation + pose.translation);
    else
      world_from_node[i] = world_from_node[static_cast<size_t>(node.parent)] *
                           parent_from_node(node, pose.rotation[i], node.translation);
  }
}

AvatarPoser::AvatarPoser(const Avatar& avatar) : avatar_(avatar), world_from_node_(avatar.nodes.size()) {
  size_t most_joints = 0;
  for (const AvatarSkin& skin : avatar.skins)
    most_joints = std::max(most_joints, skin.joints.size());
  world_from_mesh_.resize(most_joints);
  for (size_t i = 0; i < avatar.nodes.size(); ++i) {
    const int mesh = avatar.nodes[i].mesh;
    if (mesh < 0) continue;
    const std::vector<AvatarVertices>& vertices = avatar.meshes[static_cast<size_t>(mesh)].vertices;
    for (size_t v = 0; v < vertices.size(); ++v)
      parts_.push_back({.node = static_cast<int>(i),
                        .mesh = mesh,
                        .vertices = static_cast<int>(v),
                        .positions = vertices[v].positions,
                        .normals = vertices[v].normals});
  }
}

void AvatarPoser::pose(const AvatarPose& pose) {
  place_nodes(avatar_, pose, world_from_node_);
  pose_parts(pose.morph_weights);
}

void AvatarPoser::place(std::span<const glm::dmat4> world_from_node,
                        std::span<const std::vector<float>> morph_weights) {
  assert(world_from_node.size() == avatar_.nodes.size());
  std::ranges::copy(world_from_node, world_from_node_.begin());
  pose_parts(morph_weights);
}

void AvatarPoser::pose_parts(std::span<const std::vector<float>> morph_weights) {
  assert(morph_weights.size() == avatar_.meshes.size());
  int node = kNoNode;
  for (Part& part : parts_) {
    if (part.node != node) place_joints(avatar_.nodes[static_cast<size_t>(part.node)].skin);
    node = part.node;
    pose_part(morph_weights, part);
  }
}

void AvatarPoser::place_joints(int skin_of_node) {
  if (skin_of_node < 0) return;
  const AvatarSkin& skin = avatar_.skins[static_cast<size_t>(skin_of_node)];
  for (size_t j = 0; j < skin.joints.size(); ++j)
    world_from_mesh_[j] = world_from_node_[static_cast<size_t>(skin.joints[j])] * skin.joint_from_mesh[j];
}

void AvatarPoser::pose_part(std::span<const std::vector<float>> morph_weights, Part& part) {
  const AvatarNode& node = avatar_.nodes[static_cast<size_t>(part.node)];
  const AvatarVertices& vertices =
      avatar_.meshes[static_cast<size_t>(part.mesh)].vertices[static_cast<size_t>(part.vertices)];
  std::ranges::copy(vertices.positions, part.positions.begin());
  std::ranges::copy(vertices.normals, part.normals.begin());
  const std::vector<float>& weights = morph_weights[static_cast<size_t>(part.mesh)];
  for (size_t m = 0; m < vertices.morphs.size() && m < weights.size(); ++m) {
    if (weights[m] == 0.0F) continue;
    const AvatarMorph& morph = vertices.morphs[m];
    for (size_t i = 0; i < morph.vertices.size(); ++i)
      part.positions[morph.vertices[i]] += morph.positions[i] * weights[m];
    for (size_t i = 0; i < morph.normal_vertices.size(); ++i)
      part.normals[morph.normal_vertices[i]] += morph.normals[i] * weights[m];
  }

  const bool is_skinned = node.skin >= 0 && !vertices.joints.empty();
  for (size_t i = 0; i < part.positions.size(); ++i) {
    glm::dmat4 world_from_mesh = world_from_node_[static_cast<size_t>(part.node)];
    if (is_skinned) {
      world_from_mesh = glm::dmat4(0.0);
      for (int k = 0; k < 4; ++k)
        if (vertices.weights[i][k] > 0.0F)
          world_from_mesh += world_from_mesh_[vertices.joints[i][k]] * static_cast<double>(vertices.weights[i][k]);
    }
    part.positions[i] = glm::vec3(glm::dvec3(world_from_mesh * glm::dvec4(part.positions[i], 1.0)));
    part.normals[i] = unit_or_up(glm::dvec3(world_from_mesh * glm::dvec4(part.normals[i], 0.0)));
  }
}

}  // namespace auslan
