// SPDX-License-Identifier: Apache-2.0
// Where the joints are, in the rest pose, and what the rooms of the sculptor share about a hand. Millimetres.
#pragma once

#include "sculpt/measurements.h"
#include "shape.h"

#include <array>

namespace auslan::sculpt {

/// The trunk's joints in world space.
struct TrunkJoints {
  Vec3 spine_base{0.0}, neck_base{0.0}, head_base{0.0}, clavicle{0.0}, shoulder{0.0}, elbow{0.0},
      wrist{0.0};  ///< left side
};
TrunkJoints trunk_joints(const Measurements& table);

/// The joints of one digit of the left hand relative to the wrist, and the place of its tip.
struct DigitLine {
  std::array<Vec3, 3> joints{};
  Vec3 tip{0.0};
  Vec3 direction{0.0};  ///< unit, from root to tip
  Vec3 back{0.0};       ///< unit, out of the nail, perpendicular to `direction`
};
/// 0 the thumb, 1 index to 4 little.
DigitLine digit_line(const Measurements& table, int digit);

/// Eye level above head_base.
inline constexpr double kEyeLevel = 50.0;
/// From the middle to the joint of breastbone and clavicle, millimetres.
inline constexpr double kSternoclavicular = 25.0;

/// How far the webs between the fingers reach beyond the knuckles' joints; longer ones turn inside out in some poses.
inline constexpr double kWebReach = 8.5;

/// The skin of the hand: the back a little darker than the palm; `facing` is 1 on the back, -1 on the palm's side.
Colour hand_colour(double facing);

/// The meshes, each in its node's frame; arms and hands of the left side.
Sculpture sculpt_trunk(const Measurements& table);
Sculpture sculpt_neck(const Measurements& table);
Sculpture sculpt_head(const Measurements& table);
Sculpture sculpt_upper_arm(const Measurements& table);
Sculpture sculpt_forearm(const Measurements& table);
Sculpture sculpt_palm(const Measurements& table);
/// bone: 0 the one at the root.
Sculpture sculpt_phalanx(const Measurements& table, int digit, int bone);

}  // namespace auslan::sculpt
