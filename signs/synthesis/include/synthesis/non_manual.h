// SPDX-License-Identifier: Apache-2.0
// Non-manual features: what the lexicon's words ("raise", "furrow", "shake" …) mean for the face, the head and the
// trunk.
#pragma once

#include "kinematics/pose.h"
#include "kinematics/vector.h"

#include <string_view>

namespace auslan {

/// A posture or movement of head and trunk.
struct BodyFeature {
  Vec3 head{0.0};   ///< rotation vector of the head, radians: +x forward and down, +y to the signer's left, +z to the
                    ///< right shoulder
  Vec3 trunk{0.0};  ///< the same for the trunk
  Vec3 swing{0.0};  ///< amplitude of a repeated head movement, radians
  double swing_hz = 0;
};

/// Adds the weights of a word to `weights` (each channel limited to 1). False when the tier does not know the word; an
/// empty word and "neutral" add nothing and are known.
bool add_brows(std::string_view word, FaceWeights& weights);
bool add_eyes(std::string_view word, FaceWeights& weights);
/// Knows the lexicon's words and the codes of SiGML's mouth gestures.
bool add_mouth(std::string_view word, FaceWeights& weights);
/// "D01" to "D09", "J01" to "J04", "L01" to "L35", "C01" to "C13", "T01" to "T17".
bool add_mouth_gesture(std::string_view code, FaceWeights& weights);
bool add_cheeks(std::string_view word, FaceWeights& weights);
bool add_face(std::string_view word, FaceWeights& weights);
bool add_head(std::string_view word, BodyFeature& feature);
bool add_shoulders(std::string_view word, BodyFeature& feature);
bool add_gaze(std::string_view word, BodyFeature& feature, FaceWeights& weights);

}  // namespace auslan
