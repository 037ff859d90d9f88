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

/// `bulge`: how the path is bent in any case. Where it would lead through head, trunk or the other arm it is bent out
/// of them, and the elbow swung out where the forearm would run into the trunk. What the ends touch may be touched near
/// them too. `other`: what the other arm does at the same time, or null.
Way find_way(const Signer& signer, Side side, const HandState& from, const HandState& to, const Vec3& bulge,
             const HandSegment* other);

/// The same for a path that an entry prescribes. Returns how long it takes at least, seconds.
double keep_clear(const Signer& signer, Side side, HandSegment& segment, const HandSegment* other);

}  // namespace auslan
