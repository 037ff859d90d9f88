// SPDX-License-Identifier: Apache-2.0
// One entry as a list of beats: what both hands do from its first posture to its last, without regard to what comes
// before and after.
#pragma once

#include "kinematics/result.h"
#include "synthesis/score.h"
#include "synthesis/signer.h"
#include "synthesis/utterance.h"
#include "way.h"

#include <optional>
#include <vector>

namespace auslan {

/// A stretch of time in which each active hand makes one segment. Times of the segments are relative: 0 to `seconds`.
struct Beat {
  double seconds = 0;
  std::array<TouchedSurfaces, 2> surfaces;          ///< by Side: what each hand touches at the beginning and the end
  bool hold = false;                                ///< a hold at a phonological target
  std::array<HandSegment, 2> hands;                 ///< by Side; only that of an active hand counts
  std::array<std::optional<HandTarget>, 2> target;  ///< what the hand shows at the end, or during a hold; no times yet
};

struct SignPerformance {
  std::array<bool, 2> active{};                           ///< by Side
  std::array<HandState, 2> start;                         ///< where the transition into the sign ends
  std::array<std::optional<HandTarget>, 2> start_target;  ///< what the hand shows there
  std::array<Touch, 2> approach, leave;                   ///< what is touched at the start and at the end
  std::vector<Beat> beats;
};

/// Turns a hand of a stroke as its joints go and bends its path as keep_clear() does, against what the left hand does
/// in `segments` meanwhile. Returns the depth that is left, metres.
double clear_stroke(const Signer& signer, const Beat& beat, const std::array<bool, 2>& active, size_t side,
                    std::array<HandSegment, 2>& segments);

/// `waiting`: where a hand is that the sign does not use (its arm may be touched).
Result<SignPerformance> perform(const Signer& signer, const Utterance& utterance, const Unit& unit,
                                const std::array<HandState, 2>& waiting);

}  // namespace auslan
