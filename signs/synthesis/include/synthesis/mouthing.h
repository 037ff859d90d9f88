// SPDX-License-Identifier: Apache-2.0
// English mouthing: the visible shapes of a word's sounds, read off its spelling by a small set of letter-to-sound
// rules.
#pragma once

#include "kinematics/pose.h"

#include <array>
#include <string_view>
#include <vector>

namespace auslan {

/// The classes of sounds that look alike on the lips: MPEG-4's fourteen and silence (ISO/IEC 14496-2, facial
/// animation).
enum class Viseme { kSilence, kPp, kFf, kTh, kDd, kKk, kCh, kSs, kNn, kRr, kAa, kE, kIh, kOh, kOu };
inline constexpr int kVisemeCount = 15;
/// Their usual short names, in enum order ("PP" as in pea, "ou" as in moon).
inline constexpr std::array<std::string_view, kVisemeCount> kVisemeNames = {
    "sil", "PP", "FF", "TH", "DD", "kk", "CH", "SS", "nn", "RR", "aa", "E", "ih", "oh", "ou"};

/// The visemes of an English word or phrase in order; consecutive equal ones are merged. Letters that are not English
/// give nothing. Spelling is a rough guide to English sounds: this serves the eye, not phonetics.
std::vector<Viseme> visemes_of(std::string_view english);

/// The face of a viseme at its peak.
FaceWeights weights_of(Viseme viseme);

}  // namespace auslan
