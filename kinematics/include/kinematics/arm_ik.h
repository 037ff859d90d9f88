// SPDX-License-Identifier: Apache-2.0
// From where the hand is to the rotations of clavicle, shoulder, elbow and wrist, in closed form but for one free
// angle.
//
// The elbow lies on a circle about the line from shoulder to wrist; the swivel angle says where (Tolani, Goswami &
// Badler 2000). Swivel 0 is straight down in the frame of the trunk, projected onto the plane of the
// circle; positive leads outwards on both sides. Where the line itself is within 30 degrees of straight down (up), the
// reference leans over to backwards (forwards), so that it is continuous wherever a hand usually goes; it is undefined
// only for a hand about 20 degrees behind straight down or up, where an arbitrary direction is taken.
//
// At the edge of reach the clavicle helps: it turns towards the hand, more the farther that is, by up to 14 degrees,
// and carries the shoulder with it. It depends on the wrist's place alone, smoothly. A hanging arm leaves it at rest.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/pose.h"
#include "kinematics/skeleton.h"

namespace auslan {

struct ArmSolution {
  Quat clavicle = kIdentity;  ///< trunk_from_clavicle; identity for figures without one
  Quat shoulder = kIdentity, elbow = kIdentity, wrist = kIdentity;  ///< local (parent_from_node)
  bool reachable = true;
  double shortfall = 0.0;  ///< metres from the wanted to the reached wrist; 0 when reachable
};

/// The elbow node takes the bend, about the hinge, and then the forearm's pronation; the wrist node keeps only flexion
/// and deviation. A wrist out of reach (too far or too near) is brought along the line from the shoulder to the nearest
/// distance the arm has; its orientation is met in any case. `swivel` in radians.
ArmSolution solve_arm(const Skeleton& skeleton, Side side, const Transform& world_from_trunk,
                      const Transform& world_from_wrist, double swivel);

/// Writes the rotations of the arm's nodes; leaves the digits alone.
void pose_arm(const ArmNodes& nodes, const ArmSolution& arm, Pose& pose);

/// The swivel that breaks the joint limits of the arm least and keeps the elbow out of the trunk and near a natural
/// place, down and slightly out. A soft minimum over a fixed grid, so that it varies continuously with the target.
/// Within [-60, 150] degrees.
double natural_swivel(const Skeleton& skeleton, Side side, const Transform& world_from_trunk,
                      const Transform& world_from_wrist);

}  // namespace auslan
