// SPDX-License-Identifier: Apache-2.0
// From what is to be signed to the score: postures solved on the figure, strokes, holds, transitions without a return
// to rest inside a sentence, and the non-manual tiers in time with the hands.
#pragma once

#include "kinematics/result.h"
#include "synthesis/score.h"
#include "synthesis/signer.h"
#include "synthesis/utterance.h"

namespace auslan {

struct ChoreographyOptions {
  double speed = 1.0;             ///< 0.25 to 4; every duration is divided by it
  double letters_per_second = 3;  ///< of fingerspelling at speed 1
  bool mouthing = true;
};

/// kUsage for a speed outside its range or an utterance without units; kNotFound for a handshape that the utterance
/// uses and does not hold; kMalformed for a sign whose movements name phases that it does not have.
Result<Score> choreograph(const Signer& signer, const Utterance& utterance, const ChoreographyOptions& options = {});

}  // namespace auslan
