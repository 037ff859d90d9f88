// SPDX-License-Identifier: Apache-2.0
// The way of a hand from one place to the next when nothing says how it goes: round the body, not through it, and no
// faster than people move.
#pragma once

#include "synthesis/score.h"
#include "synthesis/signer.h"

#include <algorithm>

namespace auslan {

/// What a hand touches.
struct Touch {
  Vec3 normal{0.0};       ///< outwards, world; zero: nothing is touched
  Vec3 part{0.0};         ///< of the hand, in its wrist's frame
  bool on_other = false;  ///< it is the other hand or its forearm

  bool touches() const { return normal != Vec3(0.0); }

  friend bool operator==(const Touch&, const Touch&) = default;
};

/// Where a way begins and ends. A hand leaves what it touches and comes to it along the normal.
struct TouchedSurfaces {
  Touch from, to;

  /// From a place on a surface to another one: the hand stays on it.
  bool slides() const { return glm::dot(from.normal, to.normal) > 0.5; }

  friend bool operator==(const TouchedSurfaces&, const TouchedSurfaces&) = default;
};

/// What the other arm does while a hand goes its way.
struct Meanwhile {
  const HandSegment* other = nullptr;  ///< null: nothing that matters
  double from = 0.0, to = 1.0;         ///< where on its segment the other is as the way begins and ends, shares of time
};

/// By how much a way of this length stands off the surfaces at its ends, metres.
inline double lift_of(double distance) {
  return std::min(0.07, 0.35 * distance);
}

/// A segment without times, and how long the arm takes for it at least.
struct Way {
  HandSegment segment;
  double seconds = 0;
  double depth = 0;  ///< how deep the hand still goes into something on the way, metres; 0 where too little to count
};

/// `wanted`: from where to where, and how the path and the hand are bent in any case. Where the path would lead through
/// head, trunk or the other arm it is bent out of them, and the elbow swung out where the forearm would run into the
/// trunk. What the ends touch may be touched near them too.
Way find_way(const Signer& signer, Side side, const HandSegment& wanted, const TouchedSurfaces& touched,
             const Meanwhile& meanwhile);

/// The same for a path that an entry prescribes: bends it as little as it takes. Returns the depth that is left.
double keep_clear(const Signer& signer, Side side, HandSegment& segment, const TouchedSurfaces& touched,
                  const Meanwhile& meanwhile);

}  // namespace auslan
