// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "phonology/sign.h"

namespace auslan {

/// Which hands a movement moves when the text does not say.
inline MovingHands usual_hands(Handedness handedness) {
  switch (handedness) {
    case Handedness::kSymmetric:
      return MovingHands::kBoth;
    case Handedness::kAlternating:
      return MovingHands::kAlternating;
    case Handedness::kOne:
    case Handedness::kDominantBase:
      break;
  }
  return MovingHands::kDominant;
}

}  // namespace auslan
