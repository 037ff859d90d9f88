// SPDX-License-Identifier: Apache-2.0
// The steps of fit_avatar: size and facing, the joints, the rest pose, the surface.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/avatar_pose.h"
#include "kinematics/signing_avatar.h"

#include <span>

namespace auslan::fit {

inline constexpr size_t kNodes = kNodeNames.size();

/// The figure's node that a role is, or one of AvatarDriver.
int driver_of(HumanRole role);
/// The role of a digit's joint; digit and joint as in ArmNodes.
HumanRole digit_role(Side side, size_t digit, size_t joint);
/// The index in kNodeNames of an arm's nodes and of a digit's joints.
ArmNodes named_arm(Side side);
int parent_of(int node);

inline Side side_of(size_t index) {
  return index == 0 ? Side::kLeft : Side::kRight;
}
inline double sign_of(Side side) {
  return side == Side::kLeft ? 1.0 : -1.0;
}
double length(const Vec3& v);
glm::dmat4 matrix(const Transform& transform);

/// The driver of every node: that of its role, or its parent's.
std::vector<int> drivers(const Avatar& avatar);

/// A vertex of the drawn figure and what moves it most.
struct Skin {
  std::vector<int> driver;  ///< of each vertex of a part
};
/// Of every part of a poser, in its order.
std::vector<Skin> main_drivers(const Avatar& avatar, std::span<const AvatarPoser::Part> parts,
                               std::span<const int> driver);

/// Turns, scales and moves the roots so that the figure stands as SigningAvatar says. Gives the scale.
Result<double> normalise(Avatar& avatar);

/// Where the joints are in the file's rest pose.
struct Joints {
  std::array<Vec3, kNodes> place{};
  std::array<bool, kNodes> is_known{};
};
/// `world_from_node` at rest. Fills what is missing by proportion.
Joints find_joints(const Avatar& avatar, std::span<const glm::dmat4> world_from_node,
                   std::span<const AvatarPoser::Part> parts, std::span<const Skin> skins,
                   std::vector<std::string>& warnings);

/// How far every node of the figure is from the file's rest pose: world in the figure's rest from world in the file's.
std::array<Transform, kNodes> pose_for_rest(const Joints& joints, std::span<const AvatarPoser::Part> parts,
                                            std::span<const Skin> skins);

Skeleton skeleton_of(const Joints& joints, std::span<const Transform> rest_from_file);

/// Replaces joints of upper arms and forearms by chains that twist, in skins that one node shows.
void add_twist(SigningAvatar& fitted);

/// The segments of the figure from the surface in its rest pose; stand-ins for what has none.
void cut_surface(SigningAvatar& fitted, std::span<const AvatarPoser::Part> parts, std::span<const Skin> skins);

/// Whether a surface can be seen at all.
bool is_shown(const AvatarSurface& surface);

/// Measures the face on the head's segment and on what morph targets move. `parts` are in the figure's rest pose.
void measure_face(SigningAvatar& fitted, std::span<const AvatarPoser::Part> parts);

}  // namespace auslan::fit
