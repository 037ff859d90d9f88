// SPDX-License-Identifier: Apache-2.0
// An arm that keeps its joint limits: what a wrist can show at a place when the elbow is somewhere.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/arm_ik.h"
#include "kinematics/skeleton.h"

#include <memory>

namespace auslan {

/// Measures an arm of a skeleton once; then solves as often as wanted. Owns what it needs.
class ArmReach {
 public:
  ArmReach(const Skeleton& skeleton, Side side);
  ArmReach(ArmReach&&) noexcept;
  ArmReach& operator=(ArmReach&&) noexcept;
  ~ArmReach();

  /// A hand brought to a place, in the frame of the trunk.
  struct Reached {
    Transform wrist;
    ArmSolution arm;
    double lean = 0.0;  ///< radians between the wanted and the reached orientation
    double excess =
        0.0;           ///< radians by which the limits are still broken: the place asks for it, however the hand turns
    double off = 0.0;  ///< metres between the wanted and the reached place of the pivot
  };

  /// Puts the hand's `pivot` (wrist frame) on `target`. Where the wanted orientation would break the limits of forearm
  /// or wrist, the hand leans to the nearest one within them: each angle is brought into its range, and as that moves
  /// the wrist, again until it stays, `rounds` times at most. Total: what is out of reach is approached, and told by
  /// `off`.
  Reached reach(const Quat& wanted, const Vec3& pivot, const Vec3& target, double swivel, int rounds = 8) const;
  /// The same to the very ends of the ranges, where limited() draws what is asked from up to a degree beyond them:
  /// what is reached here is to be drawn by limited().
  Reached reach_to_ends(const Quat& wanted, const Vec3& pivot, const Vec3& target, double swivel) const;

  /// solve_arm() for a wrist in the frame of the trunk.
  ArmSolution solve(const Transform& trunk_from_wrist, double swivel) const;

  /// Radians by which shoulder, elbow and wrist break their limits for a wrist that stays as it is: the root of the sum
  /// of squares.
  double excess(const Transform& trunk_from_wrist, double swivel) const;

  /// Brings shoulder, elbow and wrist into their ranges. Within a degree of the end of a range a joint gives way
  /// bit by bit, so that a smooth movement into the limit stays smooth.
  ArmSolution limited(const ArmSolution& arm) const;

 private:
  struct State;
  struct Within;
  Reached reach_within(const Within& within, const Quat& wanted, const Vec3& pivot, const Vec3& target, double swivel,
                       int rounds) const;
  std::unique_ptr<const State> state_;
};

}  // namespace auslan
