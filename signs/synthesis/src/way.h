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
  double depth =
      0;  ///< how deep the hand still goes into the trunk on the way, metres; 0 where that is too little to count
};

/// `wanted`: from where to where, and how the path and the hand are bent in any case. Where the path would lead through
/// the trunk it is bent out of it, and the elbow swung out where the forearm would. What the ends touch may be touched
/// near them too.
Way find_way(const Signer& signer, Side side, const HandSegment& wanted);

}  // namespace auslan
