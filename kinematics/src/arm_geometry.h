// SPDX-License-Identifier: Apache-2.0
// An arm's bones and axes at rest: what arm_ik.cpp solves with and limits.cpp measures by.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/arm_ik.h"
#include "kinematics/limits.h"

#include <optional>

namespace auslan {

struct ArmGeometry {
  Vec3 shoulder_offset;        ///< of the shoulder at rest from the trunk's node, metres
  Vec3 upper_bone, fore_bone;  ///< unit, shoulder to elbow and elbow to wrist
  double upper_length = 0.0, fore_length = 0.0;
  Vec3 hinge;                           ///< axis of elbow flexion, perpendicular to the upper arm
  double side_sign = 1.0;               ///< +1 left, -1 right
  std::optional<Vec3> clavicle_offset;  ///< of the sternoclavicular joint from the trunk's node, metres

  /// Where the shoulder is in the trunk's frame.
  Vec3 shoulder_place(const Quat& clavicle) const {
    if (!clavicle_offset) return shoulder_offset;
    return *clavicle_offset + clavicle * (shoulder_offset - *clavicle_offset);
  }
};

ArmGeometry arm_geometry(const Skeleton& skeleton, Side side);

/// solve_arm in the frame of the trunk.
ArmSolution solve_in_trunk(const ArmGeometry& arm, const Transform& trunk_from_wrist, double swivel);

/// How a joint's local rotation is read as angles: undo `zero`, twist about `bone`, swing about the other two.
struct JointAxes {
  Vec3 bone, flexion, abduction;  ///< orthonormal, in the parent's frame
  double twist_sign = 1.0;
  Quat zero = kIdentity;  ///< the local rotation at which all angles are zero
};

JointAxes clavicle_axes(const ArmGeometry& arm);
JointAxes shoulder_axes(const ArmGeometry& arm);
JointAxes elbow_axes(const ArmGeometry& arm);
JointAxes wrist_axes(const HandFrame& hand, double side_sign);

JointAngles angles_about(const JointAxes& axes, const Quat& local);
Quat rotation_about(const JointAxes& axes, const JointAngles& angles);
/// Square of what limit_violation returns.
double squared_excess(const JointLimits& limits, const JointAngles& angles);

/// The ranges of the three joints of an arm.
JointLimits shoulder_limits();
JointLimits elbow_limits();
JointLimits wrist_limits();

}  // namespace auslan
