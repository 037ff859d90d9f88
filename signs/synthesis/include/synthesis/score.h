// SPDX-License-Identifier: Apache-2.0
// The score: tiers over time (two hands, head, body, face) as plain data. Every tier is continuous in velocity by
// construction: hands move along minimum-jerk strokes that start and end at rest, spans rise and fall along the same
// curve.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/pose.h"
#include "kinematics/vector.h"
#include "phonology/sign.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace auslan {

/// Time inside is an integer number of ticks; 6000 a second divides by every usual frame rate.
using Tick = int64_t;
inline constexpr Tick kTicksPerSecond = 6000;

inline constexpr Tick ticks(double seconds) {
  return static_cast<Tick>(seconds * static_cast<double>(kTicksPerSecond) + (seconds < 0 ? -0.5 : 0.5));
}
inline constexpr double seconds(Tick time) {
  return static_cast<double>(time) / static_cast<double>(kTicksPerSecond);
}

/// Where a hand is and what it does, with the trunk and head at rest.
struct HandState {
  Transform wrist;          ///< world_from_wrist
  double swivel = 0;        ///< of the elbow, radians, as solve_arm takes it
  HandAngles angles;        ///< of the digits, radians
  double follows_head = 0;  ///< 1: the placement moves with the head (contact on the face), 0: with the trunk
  Vec3 on_face{0.0};        ///< the part that moves with the head, in the wrist's frame

  friend bool operator==(const HandState&, const HandState&) = default;
};

/// A movement laid over a segment: value = amplitude * sin(2 pi (cycles * tau + phase)), faded in and out.
struct Oscillation {
  Vec3 shift{0.0};       ///< metres
  Vec3 turn{0.0};        ///< rotation vector of the hand, world axes, radians
  Vec3 turn_ahead{0.0};  ///< the same a quarter cycle ahead: with `turn` the hand stirs
  Vec3 pivot{0.0};       ///< about which it turns, wrist frame: the wrist, or what touches
  /// Finger flexion at the knuckle, radians, each finger a quarter cycle after its neighbour; negative: they are only
  /// lifted off what they touch.
  double wiggle = 0;
  unsigned wiggling = 0x1E;  ///< which digits wiggle: bit 0 the thumb, bit 1 the index …
  double flex = 0;           ///< flexion of all finger joints together, radians, one-sided (closing only)
  double cycles = 0;
  double phase = 0;   ///< in cycles
  double growth = 1;  ///< amplitude at the end over that at the beginning

  friend bool operator==(const Oscillation&, const Oscillation&) = default;
};

/// What one hand does between two times.
struct HandSegment {
  Tick begin = 0, end = 0;
  HandState from, to;
  Vec3 bulge{0.0};  ///< displacement of the middle of the path from the straight line, metres
  /// Metres by which the path stands off where it leaves a surface and where it comes to one: most a third of the way
  /// from that end, so that the hand goes and comes along the surface's normal.
  Vec3 leave{0.0}, approach{0.0};
  std::optional<Quat> turn_middle;  ///< world_from_wrist in the middle of the path; none: the shortest turn is made
  double swivel_bulge = 0;          ///< by which the elbow swings out in the middle of the path, radians
  Vec3 circle_u{0.0};               ///< from the circle's centre to the starting point, metres; zero: no circle
  Vec3 circle_v{0.0};               ///< a quarter turn further
  double turns = 0;
  double circle_growth = 1;  ///< of the circle's size: that at the end over that at the beginning
  double digits_lead = 1;    ///< the digits arrive after this fraction of the segment: handshape leads location
  Oscillation oscillation;

  friend bool operator==(const HandSegment&, const HandSegment&) = default;
};

/// Face weights that rise, hold and fall.
struct FaceSpan {
  Tick begin = 0, end = 0;  ///< full strength is held between begin + onset and end - release
  Tick onset = 0, release = 0;
  FaceWeights weights{};
  bool mouthing =
      false;  ///< one of the shapes that the lips go through: they add up, one falling as the next one rises
};

/// A turn of head and trunk that rises, holds and falls, with an optional oscillation about it.
struct BodySpan {
  Tick begin = 0, end = 0;
  Tick onset = 0, release = 0;
  Vec3 head{0.0};   ///< rotation vector of the head against the trunk, radians
  Vec3 trunk{0.0};  ///< rotation vector of the trunk about the spine base
  Vec3 swing{0.0};  ///< amplitude of a head oscillation, in its middle when the onset is over
  double swing_hz = 0;
};

/// When an entry is on the hands: from the end of the transition into it to the end of its last hold.
struct GlossSpan {
  std::string label;
  Tick begin = 0, end = 0;
  bool spelled = false;
  int unit = 0;  ///< which unit of the utterance
};

/// What a hand shows when it has arrived at a posture: for those who judge a performance, not needed to perform it.
/// Directions are as the entry states them (world axes, trunk at rest), whatever the arm could reach.
struct HandTarget {
  Tick begin = 0, end = 0;  ///< equal: the hand passes without a hold
  Vec3 fingers{0.0}, palm{0.0};
  Quat reached = kIdentity;  ///< world_from_wrist chosen for it: as near to the stated directions as the joints allow
  HandAngles angles;         ///< of the handshape
  bool touches = false;
  double stand_off = 0;  ///< metres that the part keeps from the surface of what it is only near; 0: nothing is said
  Vec3 part{0.0};        ///< what touches or is near, in the wrist's frame
  Location location = Location::kNeutral;
  double trouble = 0;  ///< as PlacedHand has it: above 1 this figure was found no place for it
};

struct Score {
  std::array<std::vector<HandSegment>, 2> hands;   ///< by Side (kLeft, kRight); contiguous from 0 to end
  std::array<std::vector<HandTarget>, 2> targets;  ///< by Side, in the order of their times
  std::vector<FaceSpan> face;
  std::vector<BodySpan> body;
  std::vector<GlossSpan> glosses;
  Tick end = 0;
};

}  // namespace auslan
