// SPDX-License-Identifier: Apache-2.0
// What avatar.h promises of a figure that was read, looked at one by one.
#pragma once

#include "kinematics/avatar_pose.h"

#include <cmath>
#include <string>

namespace auslan::test {

inline bool is_below(int index, size_t count) {
  return index >= 0 && static_cast<size_t>(index) < count;
}

/// The promise that a vertex set breaks, or "".
inline std::string broken_promise(const AvatarVertices& vertices, size_t morph_names) {
  const size_t count = vertices.positions.size();
  const auto is_whole = [count](size_t size) { return size == 0 || size == count; };
  if (vertices.normals.size() != count || !is_whole(vertices.texture_coordinates.size()) ||
      !is_whole(vertices.colours.size()) || !is_whole(vertices.joints.size()) ||
      vertices.weights.size() != vertices.joints.size())
    return "attributes of one length";
  if (vertices.morphs.size() > morph_names) return "morphs have names";
  for (const glm::vec3& normal : vertices.normals)
    if (!(std::fabs(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z - 1.0F) < 1e-3F))
      return "unit normals";
  for (const glm::vec4& weights : vertices.weights)
    if (!(weights.x >= 0 && weights.y >= 0 && weights.z >= 0 && weights.w >= 0 &&
          std::fabs(weights.x + weights.y + weights.z + weights.w - 1.0F) < 1e-3F))
      return "weights of sum 1";
  for (const AvatarMorph& morph : vertices.morphs) {
    if (morph.vertices.size() != morph.positions.size() || morph.normal_vertices.size() != morph.normals.size())
      return "morphs of one length";
    for (const auto* list : {&morph.vertices, &morph.normal_vertices})
      for (size_t i = 0; i < list->size(); ++i)
        if ((*list)[i] >= count || (i > 0 && (*list)[i] <= (*list)[i - 1])) return "morph vertices ascend";
  }
  return "";
}

/// The promise of avatar.h that the figure breaks, or "".
inline std::string broken_promise(const Avatar& avatar) {
  for (size_t i = 0; i < avatar.nodes.size(); ++i) {
    const AvatarNode& node = avatar.nodes[i];
    if (node.parent != kNoNode && !(node.parent >= 0 && static_cast<size_t>(node.parent) < i)) return "parents first";
    if (node.mesh != -1 && !is_below(node.mesh, avatar.meshes.size())) return "meshes of nodes exist";
    if (node.skin != -1 && !is_below(node.skin, avatar.skins.size())) return "skins of nodes exist";
    if (node.mesh == -1 || node.skin == -1) continue;
    for (const AvatarVertices& vertices : avatar.meshes[static_cast<size_t>(node.mesh)].vertices)
      for (const glm::u16vec4& joints : vertices.joints)
        for (int k = 0; k < 4; ++k)
          if (!is_below(joints[k], avatar.skins[static_cast<size_t>(node.skin)].joints.size())) return "joints exist";
  }
  for (const AvatarSkin& skin : avatar.skins) {
    if (skin.joints.empty() || skin.joints.size() != skin.joint_from_mesh.size()) return "a matrix a joint";
    for (const int joint : skin.joints)
      if (!is_below(joint, avatar.nodes.size())) return "joints are nodes";
  }
  for (const AvatarMesh& mesh : avatar.meshes) {
    if (mesh.morph_names.size() != mesh.morph_weights.size()) return "a weight a morph";
    for (const AvatarVertices& vertices : mesh.vertices)
      if (std::string broken = broken_promise(vertices, mesh.morph_names.size()); !broken.empty()) return broken;
    for (const AvatarSurface& surface : mesh.surfaces) {
      if (!is_below(surface.vertices, mesh.vertices.size()) || surface.indices.size() % 3 != 0)
        return "whole triangles";
      if (surface.image != -1 && !is_below(surface.image, avatar.images.size())) return "images exist";
      for (const uint32_t index : surface.indices)
        if (index >= mesh.vertices[static_cast<size_t>(surface.vertices)].positions.size()) return "indices in range";
    }
  }
  for (const int node : avatar.human_node)
    if (node != kNoNode && !is_below(node, avatar.nodes.size())) return "roles are played by nodes";
  const auto is_bind = [&](const MorphBind& bind) {
    return is_below(bind.mesh, avatar.meshes.size()) &&
           is_below(bind.morph, avatar.meshes[static_cast<size_t>(bind.mesh)].morph_names.size()) &&
           bind.weight >= 0.0 && bind.weight <= 1.0;
  };
  for (const AvatarExpression& expression : avatar.expressions)
    for (const MorphBind& bind : expression.binds)
      if (!is_bind(bind)) return "binds of expressions exist";
  for (const FaceDrive& drive : avatar.face)
    for (const MorphBind& bind : drive.binds)
      if (!is_bind(bind)) return "binds of the face exist";
  if (triangle_count(avatar) == 0 || triangle_count(avatar) > kMaxAvatarTriangles) return "some triangles";
  AvatarPoser poser(avatar);
  poser.pose(rest_pose(avatar));
  for (const AvatarPoser::Part& part : poser.parts())
    for (const glm::vec3& position : part.positions)
      for (int c = 0; c < 3; ++c)
        if (!(std::fabs(static_cast<double>(position[c])) <= kMaxAvatarExtent)) return "the figure is no giant";
  return "";
}

}  // namespace auslan::test
