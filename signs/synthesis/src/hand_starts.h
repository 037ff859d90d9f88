// SPDX-License-Identifier: Apache-2.0
// Where a hand sets out from that did not come right: what an entry leaves open is tried in turn.
#pragma once

#include "kinematics/vector.h"

#include <vector>

namespace auslan {

struct HandStart {
  Quat turn = kIdentity;  ///< from the rotation that the entry states, world axes
  Vec3 slide{0.0};        ///< from the place that the entry states, over the skin, metres
  double swivel = 0.0;    ///< of the elbow, radians
};

/// Those first that change least. `way`: out of what the hand meets, unit.
std::vector<HandStart> hand_starts(const Vec3& way);

}  // namespace auslan
