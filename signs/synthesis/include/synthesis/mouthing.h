// SPDX-License-Identifier: Apache-2.0
// English mouthing: the visible shapes of a word's sounds, read off its spelling by a small set of letter-to-sound
// rules.
#pragma once

#include "kinematics/pose.h"

#include <string_view>
#include <vector>

namespace auslan {

/// The classes of sounds that look alike on the lips (after the MPEG-4 and SAPI viseme lists).
enum class Viseme { kClosed, kLipTeeth, kTongue, kAlveolar, kRounded, kBack, kR, kW, kO, kA, kE, kI };

/// The visemes of an English word or phrase in order; consecutive equal ones are merged. Letters that are not English
/// give nothing. Spelling is a rough guide to English sounds: this serves the eye, not phonetics.
std::vector<Viseme> visemes_of(std::string_view english);

/// The face of a viseme at its peak.
FaceWeights weights_of(Viseme viseme);

}  // namespace auslan
