// SPDX-License-Identifier: Apache-2.0
// Places on an arm as it is held, found on the figure's own surface.
#pragma once

#include "kinematics/anatomy.h"
#include "synthesis/signer.h"

namespace auslan {

/// Places above the wrist: upper arm, elbow and forearm.
bool is_on_arm(Location location);

struct HeldArm {
  const Figure& figure;
  const ArmNodes& nodes;
  const HandFrame& hand;  ///< at rest
  ArmPlacement placed;
};

/// The place for a hand that comes from `comes_from` (unit, world), displaced across the limb by `offset` (metres). For
/// locations that are none of is_on_arm the elbow's tip.
Site arm_site(const HeldArm& arm, Location location, const Vec3& comes_from, const Vec3& offset);

}  // namespace auslan
