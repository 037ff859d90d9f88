// SPDX-License-Identifier: Apache-2.0
// How long movements take and how wide they are: the numbers of the choreography, with their sources.
#pragma once

#include "kinematics/rotation.h"
#include "phonology/sign.h"
#include "synthesis/score.h"

#include <algorithm>
#include <cmath>

namespace auslan::stroke {

// A stroke of fluent signing takes about 0.2 to 0.5 s, a transition 0.15 to 0.45 s; holds at phonological targets are
// at least 80 ms, at letters 120 ms (reference on motion and the project's quality limits).
inline constexpr double kSignHold = 0.085;
inline constexpr double kLetterHold = 0.15;
inline constexpr double kLeastSignHold = 0.08;  ///< at any speed
inline constexpr double kLeastLetterHold = 0.12;
// What is made several times is made quicker: of a movement that takes longer than a stroke of fluent signing, half of
// the rest is left. Two signs are then seldom more than two thirds of a second apart.
inline constexpr double kLongStroke = 0.35, kShareOfRest = 0.35;
inline constexpr double kRestHold = 0.30;  ///< after a movement that is written with a rest
inline constexpr double kShortestTransition = 0.15;
inline constexpr double kLongestTransition = 0.45;
// A letter or number that is made twice is made anew, as a small movement to the side or a contact made again; else the
// two look like one that is held.
inline constexpr double kAnew = 0.26, kAnewWidth = 0.035;  ///< seconds at least, metres
inline constexpr double kTurnOfCircle = 0.28;              ///< once round
inline constexpr double kCycle = 0.17;                     ///< of a shake, a twist, a nod
inline constexpr double kFromRest = 0.50;                  ///< raising the hands at the start, lowering them at the end
inline constexpr double kAnticipation = 0.10;              ///< by which the base hand sets out before it has to
inline constexpr double kFinalLengthening = 0.12;          ///< of the last sign of a phrase, as a share of it
inline constexpr double kSentencePause = 0.4;              ///< a pause at least this long ends a sentence
inline constexpr double kQuestionHold = 0.24;
inline constexpr double kShortestViseme = 0.055;  ///< lips that go through more shapes than that show none of them
inline constexpr double kMouthingReach = 0.10;    ///< by which the lips move before and after their sign
inline constexpr double kBrowOnset = 0.18;
inline constexpr double kBrowRelease = 0.25;

/// Amplitude of a local movement, metres.
inline double amplitude(Size size) {
  switch (size) {
    case Size::kTiny:
      return 0.015;
    case Size::kSmall:
      return 0.03;
    case Size::kMedium:
      return 0.055;
    case Size::kLarge:
      return 0.09;
  }
  return 0.055;
}

/// Amplitude of a turn of wrist or forearm, radians.
inline double turn(Size size) {
  switch (size) {
    case Size::kTiny:
      return 0.16;
    case Size::kSmall:
      return 0.30;
    case Size::kMedium:
      return 0.50;
    case Size::kLarge:
      return 0.75;
  }
  return 0.5;
}

inline double manner_factor(Manner manner) {
  switch (manner) {
    case Manner::kPlain:
      return 1.0;
    case Manner::kSlow:
      return 1.6;
    case Manner::kFast:
      return 0.72;
    case Manner::kSharp:
      return 0.65;
    case Manner::kTense:
      return 1.7;
    case Manner::kRest:
      return 1.0;
  }
  return 1.0;
}

inline double largest_digit_change(const HandAngles& a, const HandAngles& b) {
  double largest = 0;
  for (size_t i = 0; i < 4; ++i)
    largest = std::max(
        {largest, std::abs(a.fingers[i].mcp - b.fingers[i].mcp), std::abs(a.fingers[i].pip - b.fingers[i].pip)});
  return largest;
}

/// Seconds for a hand to get from one state to another at an unhurried pace: distance, turning and the fingers each ask
/// for their time. The peak of a minimum-jerk stroke is 1.875 times its mean, so 0.6 m in 0.3 s peaks at 3.7 m/s.
inline double travel_seconds(const HandState& a, const HandState& b) {
  const Vec3 way = b.wrist.position - a.wrist.position;
  const double distance = std::sqrt(glm::dot(way, way));
  const double turning = angle_between(a.wrist.rotation, b.wrist.rotation);
  const double fingers = largest_digit_change(a.angles, b.angles);
  return std::max({0.08 + 0.37 * distance, 0.07 + 0.08 * turning, 0.07 + 0.045 * fingers});
}

}  // namespace auslan::stroke
