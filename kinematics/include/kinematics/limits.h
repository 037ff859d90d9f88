// SPDX-License-Identifier: Apache-2.0
// How far joints go: the norms of the American Academy of Orthopaedic Surgeons, applied by the animation layer only.
#pragma once

#include "kinematics/skeleton.h"

#include <optional>

namespace auslan {

/// The range of a joint, radians, about its own anatomical axes (below). low <= 0 <= high.
struct JointLimits {
  double flexion_low = 0.0, flexion_high = 0.0;      ///< extension is negative flexion
  double abduction_low = 0.0, abduction_high = 0.0;  ///< adduction is negative; wrist: radial positive, ulnar negative
  double twist_low = 0.0, twist_high = 0.0;          ///< about the bone; inward (medial, pronation) is positive
};

/// What a local rotation is in anatomical terms, radians. It is taken apart into a twist about the bone and a swing,
/// and the swing's rotation vector into flexion and abduction. Zero is: the arm hanging (shoulder; so rest is 90
/// degrees of abduction), the forearm straight and neither pronated nor supinated (which is rest: palms down), the hand
/// straight, the thumb as ThumbPose has it (radial abduction counts as abduction, palmar as flexion, opposition as
/// twist), the trunk and head upright (side bend as abduction, to the left positive; turn to the left as twist), the
/// clavicle at rest (protraction as flexion, elevation as abduction).
struct JointAngles {
  double flexion = 0.0, abduction = 0.0, twist = 0.0;
};

/// The range of a node; nothing for nodes that are neither of the 39 nor clavicles.
std::optional<JointLimits> joint_limits(const Skeleton& skeleton, int node);
JointAngles joint_angles(const Skeleton& skeleton, int node, const Quat& local);
Quat from_joint_angles(const Skeleton& skeleton, int node, const JointAngles& angles);

/// How far the local rotation lies beyond the range, radians (root of the sum of squares over the three angles); 0
/// within it, and for nodes that have none.
double limit_violation(const Skeleton& skeleton, int node, const Quat& local);
/// The rotation with each angle brought into its range; `local` itself where it is within.
Quat clamped(const Skeleton& skeleton, int node, const Quat& local);

}  // namespace auslan
