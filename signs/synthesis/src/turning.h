// SPDX-License-Identifier: Apache-2.0
// How an arm turns on its way: as its joints go, and no faster than they can.
#pragma once

#include "synthesis/score.h"
#include "synthesis/signer.h"

#include <optional>

namespace auslan {

/// The segment's turn_middle with which forearm and wrist go straight from their first angles to their last ones. The
/// shortest turn of the hand in space may ask a forearm to go through angles that it does not have.
std::optional<Quat> turn_through_joints(const Signer& signer, Side side, const HandSegment& segment);

/// How long the segment has to take so that no joint of arm and hand turns faster than people's, seconds.
double shortest_seconds(const Signer& signer, Side side, const HandSegment& segment);

}  // namespace auslan
