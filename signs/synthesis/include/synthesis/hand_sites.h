// SPDX-License-Identifier: Apache-2.0
// Parts of a hand, found on the surface of the figure's own hand for any finger angles.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/figure.h"
#include "kinematics/result.h"
#include "phonology/sign.h"
#include "synthesis/body_sites.h"

#include <array>

namespace auslan {

/// The surface of one hand. Owns what it needs.
class HandSites {
 public:
  static Result<HandSites> build(const Figure& figure, Side side);

  /// A part of the hand with these finger angles, in the frame of the wrist (metres; axes of the rest pose).
  Site site(HandPart part, const HandAngles& angles) const;

  /// The place that a location on this hand means to another hand's `touching` part, in the frame of the wrist.
  /// `towards` (wrist frame, unit) points to where the other hand comes from: a finger is touched on that side.
  Site site_for(Location location, HandPart touching, const HandAngles& angles, const Vec3& towards) const;

  /// Local rotations of the digits' joints for some finger angles.
  DigitRotations rotations(const HandAngles& angles) const { return rig_.rotations(angles); }

  /// The joints of the digits (thumb first, from the palm outwards) for some finger angles, in the wrist's frame.
  std::array<std::array<Transform, 3>, 5> digits(const HandAngles& angles) const { return pose(angles).joint; }

 private:
  /// The joints of the digits and their tips for some finger angles, in the wrist's frame.
  struct Posed {
    std::array<std::array<Transform, 3>, 5> joint;
    std::array<Vec3, 5> tip, pad;
  };
  Posed pose(const HandAngles& angles) const;
  /// A point on a finger's surface: on the axis at `along` (0 knuckle … 2 last joint … 3 tip) pushed out towards `out`.
  Site on_digit(const Posed& posed, size_t digit, double along, const Vec3& out) const;
  Site digit_place(const Posed& posed, const DigitSite& site) const;

  HandSites(const Figure& figure, Side side);

  HandRig rig_;
  std::array<std::array<Vec3, 3>, 5> bone_;  ///< from each joint's parent to the joint, metres
  HandFrame frame_;
  std::array<std::array<double, 3>, 5> radius_{};  ///< of each phalanx, metres
  std::array<Vec3, 5> tip_{};                      ///< tip in the last joint's frame
  double palm_depth_ = 0, back_depth_ = 0;         ///< from the plane of the bones to the skin, metres
};

}  // namespace auslan
