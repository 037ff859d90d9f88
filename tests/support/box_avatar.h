// SPDX-License-Identifier: Apache-2.0
// A foreign figure made of boxes on the measured skeleton, as other makers might store it: in any pose, size and
// facing. Small enough to know every number. Tests only.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/avatar.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
#include "measured_skeleton.h"

#include <array>
#include <string>
#include <vector>

namespace auslan::test {

struct BoxAvatar {
  double arms_below = 0.0;    ///< how far the arms hang at rest, radians
  double fingers_bent = 0.0;  ///< every finger joint at rest
  double yaw = 0.0;           ///< of the whole figure about +Y
  double pitch = 0.0;         ///< and then about +X: a quarter turn lays it down
  double scale = 1.0;
  Vec3 place{0.0};
};

/// The role of a node of kNodeNames.
inline HumanRole role_of_node(size_t node) {
  using enum HumanRole;
  constexpr std::array<HumanRole, 3> kTrunk = {kHips, kNeck, kHead};
  if (node < 3) return kTrunk[node];
  const bool left = node < 21;
  const size_t in_arm = (node - 3) % 18;
  if (in_arm < 3) return static_cast<HumanRole>(static_cast<size_t>(left ? kLeftUpperArm : kRightUpperArm) + in_arm);
  return static_cast<HumanRole>(static_cast<size_t>(left ? kLeftThumbMetacarpal : kRightThumbMetacarpal) + in_arm - 3);
}

/// Adds a box from `low` to `high` that follows one joint.
inline void add_box(AvatarVertices& vertices, AvatarSurface& surface, const Vec3& low, const Vec3& high, int joint) {
  const auto first = static_cast<uint32_t>(vertices.positions.size());
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3 corner((i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z);
    vertices.positions.emplace_back(corner);
    vertices.normals.emplace_back(glm::normalize(corner - 0.5 * (low + high)));
    vertices.joints.emplace_back(joint, 0, 0, 0);
    vertices.weights.emplace_back(1.0F, 0.0F, 0.0F, 0.0F);
  }
  constexpr std::array<uint32_t, 36> kCorners = {1, 3, 7, 1, 7, 5, 0, 6, 2, 0, 4, 6, 2, 6, 7, 2, 7, 3,
                                                 0, 1, 5, 0, 5, 4, 4, 5, 7, 4, 7, 6, 0, 3, 1, 0, 2, 3};
  for (const uint32_t corner : kCorners)
    surface.indices.push_back(first + corner);
}

/// Where a node's box ends, from its joint, in the T-pose.
inline Vec3 box_end(const Skeleton& skeleton, size_t node) {
  if (node == 0) return {0.0, 0.45, 0.0};
  if (node == 1) return {0.0, 0.08, 0.0};
  if (node == 2) return {0.0, 0.2, 0.0};
  const size_t in_arm = (node - 3) % 18;
  const double outward = node < 21 ? 1.0 : -1.0;
  if (in_arm == 2) return {outward * 0.09, 0.0, 0.0};
  if (in_arm >= 3 && in_arm % 3 == 2) {
    const Vec3 along = measured_direction((in_arm - 3) / 3);
    return Vec3(outward * along.x, along.y, along.z) * measured_tip((in_arm - 3) / 3);
  }
  return skeleton.node(static_cast<int>(node) + 1).offset;
}

/// Half as thick as it is: trunk, neck, head, arm, palm, finger.
inline Vec3 box_half(size_t node) {
  if (node == 0) return {0.13, 0.0, 0.1};
  if (node == 1) return {0.05, 0.0, 0.05};
  if (node == 2) return {0.075, 0.06, 0.1};
  const size_t in_arm = (node - 3) % 18;
  if (in_arm < 2) return {0.0, 0.04, 0.04};
  return in_arm == 2 ? Vec3(0.0, 0.013, 0.04) : Vec3(0.0, 0.008, 0.008);
}

/// Bones are the 39 nodes, bound in the T-pose; one mesh of one box a bone, so that the skin's joints are the nodes.
/// The head's box reaches from 60 mm below its joint to 260 mm above, its face 100 mm forward. One morph target,
/// jawOpen, moves the face's lower corners down by 30 mm.
inline Avatar box_avatar(const BoxAvatar& wanted = {}) {
  const Skeleton skeleton = measured_skeleton();
  Avatar avatar;
  avatar.name = "boxes";
  avatar.human_node.fill(kNoNode);
  const Quat turn = axis_angle(Vec3(1.0, 0.0, 0.0), wanted.pitch) * axis_angle(Vec3(0.0, 1.0, 0.0), wanted.yaw);
  AvatarSkin skin;
  AvatarVertices vertices;
  AvatarSurface surface;
  surface.base_colour = glm::vec4(0.6F, 0.4F, 0.3F, 1.0F);
  for (size_t n = 0; n < kNodeNames.size(); ++n) {
    const Node& source = skeleton.node(static_cast<int>(n));
    AvatarNode node{.name = source.name, .parent = source.parent, .translation = source.offset};
    const double outward = n < 21 ? 1.0 : -1.0;
    const size_t in_arm = n < 3 ? 0 : (n - 3) % 18;
    if (n >= 3 && in_arm == 0) node.rotation = axis_angle(Vec3(0.0, 0.0, 1.0), -outward * wanted.arms_below);
    if (n >= 3 && in_arm >= 6) node.rotation = axis_angle(Vec3(0.0, 0.0, 1.0), -outward * wanted.fingers_bent);
    if (n == 0) {
      node.translation = turn * source.offset * wanted.scale + wanted.place;
      node.rotation = turn;
      node.scale = Vec3(wanted.scale);
    }
    avatar.human_node[static_cast<size_t>(role_of_node(n))] = static_cast<int>(n);
    avatar.nodes.push_back(node);
    skin.joints.push_back(static_cast<int>(n));
    const Vec3 place = skeleton.rest_position(static_cast<int>(n));
    skin.joint_from_mesh.push_back(
        glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(-place, 1)));
    const Vec3 end = place + box_end(skeleton, n);
    const Vec3 half = box_half(n);
    add_box(vertices, surface, glm::min(place, end) - half, glm::max(place, end) + half, static_cast<int>(n));
  }
  AvatarMorph jaw;
  for (uint32_t i = 0; i < 8; ++i)
    if ((i & 2U) == 0 && (i & 4U) != 0) {  // lower and forward
      jaw.vertices.push_back(2 * 8 + i);
      jaw.positions.emplace_back(0.0F, -0.03F, 0.0F);
    }
  vertices.morphs.push_back(jaw);
  AvatarMesh mesh{.name = "body", .vertices = {}, .surfaces = {}, .morph_names = {"jawOpen"}, .morph_weights = {0.0F}};
  mesh.vertices.push_back(std::move(vertices));
  mesh.surfaces.push_back(std::move(surface));
  avatar.meshes.push_back(std::move(mesh));
  avatar.skins.push_back(std::move(skin));
  avatar.nodes.push_back({.name = "body", .mesh = 0, .skin = 0});
  drive_face(avatar);
  return avatar;
}

}  // namespace auslan::test
