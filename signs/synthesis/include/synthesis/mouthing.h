// SPDX-License-Identifier: Apache-2.0
// English mouthing: the visible shapes of a word's sounds, read off its spelling by a small set of letter-to-sound
// rules.
#pragma once

#include "kinematics/pose.h"

#include <array>
#include <cstddef>
#include <span>
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

/// The most visible of the visemes, at most `most` but always one where there is one, in their order: quick mouthing
/// lets go of what the lips show least.
std::vector<Viseme> reduced(std::vector<Viseme> visemes, size_t most);

/// How a word's visemes look side by side: sounds that are made behind the lips take on the lips of their neighbours,
/// the next one more than the last one.
std::vector<FaceWeights> coarticulated(std::span<const Viseme> visemes);

/// How long a viseme lasts beside the others, and which share of that it is held.
struct VisemeTiming {
  double length = 1.0, held = 0.2;
};
VisemeTiming timing_of(Viseme viseme);

/// The face of a viseme at its peak.
FaceWeights weights_of(Viseme viseme);

}  // namespace auslan
