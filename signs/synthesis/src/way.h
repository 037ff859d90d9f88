// SPDX-License-Identifier: Apache-2.0
// The way of a hand from one place to the next when nothing says how it goes: round the body, not through it, and no
// faster than people move.
#pragma once

#include "synthesis/score.h"
#include "synthesis/signer.h"

namespace auslan {

/// A segment without times, and how long it takes at least.
struct Way {
  HandSegment segment;
  double seconds = 0;
};

/// `bulge`: how the path is bent in any case. Where it would lead through the trunk it is bent out of it, and the elbow
/// swung out where the forearm would. What the ends touch may be touched near them too.
Way find_way(const Signer& signer, Side side, const HandState& from, const HandState& to, const Vec3& bulge);

}  // namespace auslan
