// SPDX-License-Identifier: Apache-2.0
// Where a joint bends the skin: the stretch of the body over which a rotation fades in.
#pragma once

#include "kinematics/skeleton.h"

#include <vector>

namespace auslan {

/// A stretch along an axis through a joint, metres: nothing before `low`, everything behind `high`, cubic between.
struct Ramp {
  double low = 0.0, high = 0.0;
  double at(double along) const;
};

/// Places are counted from the joint, in world axes at rest. What a place takes of the joint's rotation depends on the
/// place alone, not on the segment it is asked for: two segments that meet there move alike.
struct JointZone {
  int node = kNoNode;
  Vec3 axis{1.0, 0.0, 0.0};  ///< unit, along the bone
  Ramp bend;                 ///< of the rotation that tilts the axis
  Ramp twist;                ///< of the rotation about the axis: over a forearm's whole length, not at the elbow
  bool bends_parent = true;  ///< else all of the bend is the segment's own
  /// Of the parent's surface only what is near the axis bends, for a palm has five fingers: all up to `near`, nothing
  /// from `far` on. 0: all of it.
  double near = 0.0, far = 0.0;

  /// How much the parent's surface at a place is the joint's business.
  double closeness(const Vec3& place) const;
};

/// The zones of the joints that bend skin; none for the root and for nodes that are not in the design contract. Lengths
/// are shares of the skeleton's bones.
std::vector<JointZone> joint_zones(const Skeleton& skeleton);

}  // namespace auslan
