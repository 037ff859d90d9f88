// SPDX-License-Identifier: Apache-2.0
#include "way.h"

#include "kinematics/interpolate.h"
#include "kinematics/rotation.h"
#include "synthesis/performance.h"

#include <algorithm>
#include <cmath>

namespace auslan {
namespace {

constexpr int kSamples = 8;
// Depths count from a little above the surface.
constexpr double kTolerated = 0.0025, kRoom = 0.003;  // metres
constexpr double kFarthest = 0.36;                    // that a path is bent, metres
// Of an arm's length: beyond it an elbow that goes straight turns faster than any elbow.
constexpr double kEasyReach = 0.985;

/// One hand on its way, and what the other does meanwhile.
struct Journey {
  const Signer& signer;
  Side side;
  HandSegment& segment;
  const HandSegment* other;

  struct Found {
    Depth depth;
    bool in_body = true;
  };
  Found depth(double share, double at_least = 0.0) const {
    const HandState state = state_after(segment, share);
    Found found{signer.depth_in_body(side, state, at_least), true};
    if (other == nullptr) return found;
    const Depth in_arm =
        signer.depth_in_arm(side, state, state_after(*other, share), std::max(at_least, found.depth.metres));
    if (in_arm.metres > found.depth.metres) found = {in_arm, false};
    return found;
  }
};

struct Sample {
  int index = 0;  ///< 0: none
  Journey::Found found;
};

/// The sample that lies deepest, counted from what its ends account for.
Sample deepest_sample(const Journey& journey, double from_depth, double to_depth) {
  Sample worst;
  worst.found.depth.metres = kTolerated;
  for (int i = 1; i < kSamples; ++i) {
    const double share = static_cast<double>(i) / kSamples;
    const double own = std::max({from_depth * (1.0 - 3.0 * share), to_depth * (3.0 * share - 2.0), 0.0});
    Journey::Found found = journey.depth(share, own + worst.found.depth.metres);
    found.depth.metres -= own;
    if (found.depth.metres > worst.found.depth.metres) worst = {i, found};
  }
  return worst;
}

/// A bend that would stretch the arm is taken back, little by little, as far as it takes.
void keep_in_reach(const Journey& journey) {
  const Skeleton& skeleton = journey.signer.figure().skeleton;
  const ArmNodes nodes = arm_nodes(skeleton, journey.side);
  const auto length = [](const Vec3& v) { return std::sqrt(glm::dot(v, v)); };
  const double reach =
      kEasyReach * (length(skeleton.node(nodes.elbow).offset) + length(skeleton.node(nodes.wrist).offset));
  const Vec3 shoulder = skeleton.rest_position(nodes.shoulder);
  constexpr int kTimes = 16;
  for (int i = 1, times = 0; i < kSamples; ++i) {
    const double share = static_cast<double>(i) / kSamples;
    while (length(state_after(journey.segment, share).wrist.position - shoulder) > reach && times++ < kTimes)
      journey.segment.bulge *= 0.85;
  }
}

/// Returns how deep the hand still goes, metres; 0 where that is too little to count.
double bend_out(const Journey& journey) {
  constexpr int kRounds = 8;
  const double from_depth = journey.depth(0.0).depth.metres, to_depth = journey.depth(1.0).depth.metres;
  HandSegment& segment = journey.segment;
  for (int round = 0;; ++round) {
    const Sample worst = deepest_sample(journey, from_depth, to_depth);
    if (worst.index == 0) return 0.0;
    if (round == kRounds) return worst.found.depth.metres;
    const double s = minimum_jerk(static_cast<double>(worst.index) / kSamples);
    const Depth& depth = worst.found.depth;
    // Round the body forwards, not round its back, to which it may be nearer.
    const double x = state_after(segment, static_cast<double>(worst.index) / kSamples).wrist.position.x;
    const double beside = std::clamp(x / 0.2, -1.0, 1.0);
    Vec3 out = depth.out;
    if (worst.found.in_body) out = unit(out.z > 0.2 ? out + Vec3(0.0, 0.0, 0.5) : Vec3(beside, 0.0, 1.0));
    segment.bulge += out * ((depth.metres + kRoom) / std::max(0.4, 4.0 * s * (1.0 - s)));
    const double length = std::sqrt(glm::dot(segment.bulge, segment.bulge));
    if (length > kFarthest) segment.bulge *= kFarthest / length;
    keep_in_reach(journey);
  }
}

void swing_out(const Signer& signer, Side side, HandSegment& segment) {
  double least = 1e9;
  double best = 0.0;
  for (const double swing : {0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75}) {
    segment.swivel_bulge = swing;
    double deepest = 0.0;
    // A swing must be worth it.
    const double enough = least - 0.003;
    for (int i = 1; i < kSamples && deepest <= enough; ++i) {
      const HandState state = state_after(segment, static_cast<double>(i) / kSamples);
      deepest = std::max(deepest, signer.forearm_depth(side, state, deepest, 1.001 * enough).metres);
    }
    if (deepest > enough) continue;
    least = deepest;
    best = swing;
    if (least <= kTolerated) break;
  }
  segment.swivel_bulge = best;
}

}  // namespace

Way find_way(const Signer& signer, Side side, const HandSegment& wanted, const HandSegment* other) {
  Way way;
  way.segment = wanted;
  way.segment.begin = 0;
  way.segment.end = kTicksPerSecond;
  way.depth = keep_clear(signer, side, way.segment, other);
  return way;
}

double keep_clear(const Signer& signer, Side side, HandSegment& segment, const HandSegment* other) {
  const Vec3 apart = segment.to.wrist.position - segment.from.wrist.position;
  if (glm::dot(apart, apart) < 1e-4 || segment.turns > 0) return 0.0;
  const double depth = bend_out({signer, side, segment, other});
  swing_out(signer, side, segment);
  return depth;
}

}  // namespace auslan
