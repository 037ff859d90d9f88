// SPDX-License-Identifier: Apache-2.0
// Where the parts of a face are, for figures whose head is not just a head: hair, hats and ears hide its outline.
#pragma once

#include <optional>

namespace auslan {

/// World space at rest, metres.
struct FaceLandmarks {
  double chin_y = 0, top_y = 0;          ///< of the chin, and of the crown as it would be without hair or hat
  double half_width = 0;                 ///< of the head, at the temples
  double middle_z = 0;                   ///< of the head, half way from face to back
  std::optional<double> eye_y, mouth_y;  ///< nothing: by the classical canon
};

}  // namespace auslan
