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
constexpr double kTolerated = 0.003, kRoom = 0.01;  // metres
constexpr double kFarthest = 0.36;                  // that a path is bent, metres
constexpr double kFastest = 3.6;                    // of a wrist, metres a second; the limit of the project is 4

HandState state_after(const HandSegment& segment, double share) {
  return state_at(segment, static_cast<Tick>(share * static_cast<double>(segment.end)));
}

struct Sample {
  int index = 0;  ///< 0: none
  Depth depth;
};

/// The sample that lies deepest in the trunk, counted from what its ends account for.
Sample deepest_sample(const Signer& signer, Side side, const HandSegment& segment) {
  const double from_depth = signer.hand_depth(side, segment.from).metres;
  const double to_depth = signer.hand_depth(side, segment.to).metres;
  Sample worst;
  worst.depth.metres = kTolerated;
  for (int i = 1; i < kSamples; ++i) {
    const double share = static_cast<double>(i) / kSamples;
    const double own = std::max({from_depth * (1.0 - 3.0 * share), to_depth * (3.0 * share - 2.0), 0.0});
    Depth depth = signer.hand_depth(side, state_after(segment, share));
    depth.metres -= own;
    if (depth.metres > worst.depth.metres) worst = {i, depth};
  }
  return worst;
}

void bend_out(const Signer& signer, Side side, HandSegment& segment) {
  constexpr int kRounds = 8;
  for (int round = 0; round < kRounds; ++round) {
    const Sample worst = deepest_sample(signer, side, segment);
    if (worst.index == 0) return;
    const double s = minimum_jerk(static_cast<double>(worst.index) / kSamples);
    // Forwards rather than round the back, to which it may be nearer.
    const double x = state_after(segment, static_cast<double>(worst.index) / kSamples).wrist.position.x;
    const double beside = std::clamp(x / 0.2, -1.0, 1.0);
    const Vec3 out = unit(worst.depth.out.z > 0.2 ? worst.depth.out + Vec3(0.0, 0.0, 0.5) : Vec3(beside, 0.0, 1.0));
    segment.bulge += out * ((worst.depth.metres + kRoom) / std::max(0.4, 4.0 * s * (1.0 - s)));
    const double length = std::sqrt(glm::dot(segment.bulge, segment.bulge));
    if (length > kFarthest) segment.bulge *= kFarthest / length;
  }
}

void swing_out(const Signer& signer, Side side, HandSegment& segment) {
  double least = 1e9;
  double best = 0.0;
  for (const double swing : {0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75}) {
    segment.swivel_bulge = swing;
    double deepest = 0.0;
    for (int i = 1; i < kSamples; ++i)
      deepest =
          std::max(deepest, signer.forearm_depth(side, state_after(segment, static_cast<double>(i) / kSamples)).metres);
    // A swing must be worth it.
    if (deepest > least - 0.005) continue;
    least = deepest;
    best = swing;
    if (least <= kTolerated) break;
  }
  segment.swivel_bulge = best;
}

/// The greatest speed of the wrist when the way takes a second, metres a second.
double peak_speed(const HandSegment& segment) {
  constexpr int kSteps = 32;
  double peak = 0.0;
  Vec3 before = segment.from.wrist.position;
  for (int i = 1; i <= kSteps; ++i) {
    const Vec3 now = state_after(segment, static_cast<double>(i) / kSteps).wrist.position;
    peak = std::max(peak, std::sqrt(glm::dot(now - before, now - before)) * kSteps);
    before = now;
  }
  return peak;
}

}  // namespace

Way find_way(const Signer& signer, Side side, const HandSegment& wanted) {
  Way way;
  way.segment = wanted;
  way.segment.begin = 0;
  way.segment.end = kTicksPerSecond;
  const Vec3 apart = wanted.to.wrist.position - wanted.from.wrist.position;
  if (glm::dot(apart, apart) < 1e-4) return way;
  bend_out(signer, side, way.segment);
  swing_out(signer, side, way.segment);
  const Sample left = deepest_sample(signer, side, way.segment);
  if (left.index != 0) way.depth = left.depth.metres;
  way.seconds = peak_speed(way.segment) / kFastest;
  return way;
}

}  // namespace auslan
