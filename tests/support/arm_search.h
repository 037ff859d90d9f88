// SPDX-License-Identifier: Apache-2.0
// What an arm can do at all, found without the solver under test: by trying its own angles.
#pragma once

#include "direction.h"
#include "kinematics/arm_ik.h"
#include "kinematics/elementary.h"
#include "kinematics/limits.h"
#include "kinematics/rotation.h"
#include "phonology/vocabulary.h"
#include "shipped.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace auslan {

inline constexpr double kWithin = 5.0;     // degrees of a direction
inline constexpr double kInLimits = 0.05;  // degrees, the room that `auslanjam check` leaves

/// The 26 of the notation.
inline std::vector<Direction> directions() {
  std::vector<Direction> all;
  for (int up = 1; up >= -1; --up)
    for (int left = 1; left >= -1; --left)
      for (int away = 1; away >= -1; --away)
        if (left != 0 || up != 0 || away != 0) all.push_back({left, up, away});
  return all;
}
/// Its eight palms, as their symbols are named for fingers that point away.
inline constexpr std::array<const char*, 8> kPalmLetters = {"u", "ur", "r", "dr", "d", "dl", "l", "ul"};
inline Direction palm_across(const Direction& fingers, const char* letters) {
  const Vec3 along = to_vector(fingers);
  return notation::palm_direction(notation::palm_of(*notation::vector_of_letters(letters), along), along);
}

/// Of the built-in figure, its trunk at rest.
class Reach {
 public:
  Reach() : signer_(*shipped().signer), skeleton_(shipped().figure.skeleton) {}

  const Signer& signer() const { return signer_; }

  Transform parent(Side side) const { return {kIdentity, skeleton_.rest_position(arm_nodes(skeleton_, side).trunk)}; }
  /// The arm as it is drawn, brought within its limits.
  struct Posed {
    Transform wrist;
    double strain = 0.0;  ///< degrees by which it breaks its limits all the same
  };
  Posed posed(Side side, const HandState& state) const {
    const ArmNodes nodes = arm_nodes(skeleton_, side);
    const ArmSolution arm =
        signer_.reach(side).limited(solve_arm(skeleton_, side, parent(side), state.wrist, state.swivel));
    Pose pose = rest_pose(skeleton_);
    pose_arm(nodes, arm, pose);
    std::vector<Transform> world(static_cast<size_t>(skeleton_.size()));
    forward(skeleton_, pose, world);
    return {world[static_cast<size_t>(nodes.wrist)],
            (limit_violation(skeleton_, nodes.shoulder, arm.shoulder) +
             limit_violation(skeleton_, nodes.elbow, arm.elbow) + limit_violation(skeleton_, nodes.wrist, arm.wrist)) /
                kDegree};
  }
  /// Degrees by which the arm breaks its limits; nothing where the wrist is out of reach.
  std::optional<double> strain(Side side, const Transform& wrist, double swivel) const {
    const ArmNodes nodes = arm_nodes(skeleton_, side);
    const ArmSolution arm = solve_arm(skeleton_, side, parent(side), wrist, swivel);
    if (!arm.reachable) return std::nullopt;
    return (limit_violation(skeleton_, nodes.shoulder, arm.shoulder) +
            limit_violation(skeleton_, nodes.elbow, arm.elbow) + limit_violation(skeleton_, nodes.wrist, arm.wrist)) /
           kDegree;
  }
  /// Whether forearm and elbow are in head or trunk.
  bool is_in_body(Side side, const Transform& wrist, double swivel) const {
    constexpr double kKeptOff = 0.003;  // metres; depths are counted from there
    HandState state = signer_.rest(side);
    state.wrist = wrist;
    state.swivel = swivel;
    return signer_.forearm_depth(side, state, kKeptOff, 1.0).metres > kKeptOff;
  }
  /// The least strain over all swivels at which the arm is in nothing, ended early where there is none.
  double least_strain(Side side, const Transform& wrist, double step) const {
    double least = 1e9;
    for (double swivel = -90.0; swivel <= 180.0 && least > kInLimits; swivel += step) {
      const auto found = strain(side, wrist, swivel * kDegree);
      if (found && *found < least && !is_in_body(side, wrist, swivel * kDegree)) least = *found;
    }
    return least;
  }
  /// The least strain with a hand's part at a place, leaning by no more than may be.
  double possible(Side side, const Vec3& part, const Vec3& place, const Quat& wanted) const {
    double least = 1e9;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1 && least > kInLimits; ++z) {
          const Vec3 axis(x, y, z);
          const double size = std::sqrt(glm::dot(axis, axis));
          const Quat lean = size > 0 ? axis_angle(axis / size, 0.98 * kWithin * kDegree) : kIdentity;
          Transform wrist;
          wrist.rotation = lean * wanted;
          wrist.position = place - wrist.rotation * part;
          least = std::min(least, least_strain(side, wrist, 2.5));
        }
    return least;
  }
  /// The same anywhere before the body where hands sign.
  bool possible_somewhere(Side side, const Quat& wanted) const {
    const Vec3 middle = signer_.body().sternum();
    for (double x = -0.3; x <= 0.31; x += 0.1)
      for (double y = -0.3; y <= 0.31; y += 0.1)
        for (double z = 0.1; z <= 0.51; z += 0.1)
          if (least_strain(side, {wanted, middle + Vec3(x, y, z)}, 10.0) <= kInLimits) return true;
    return false;
  }

 private:
  const Signer& signer_;
  const Skeleton& skeleton_;
};

}  // namespace auslan
