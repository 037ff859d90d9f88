// SPDX-License-Identifier: Apache-2.0
#include "way.h"

#include "kinematics/interpolate.h"
#include "kinematics/rotation.h"
#include "synthesis/performance.h"

#include <algorithm>
#include <cmath>

namespace auslan {
namespace {

// Of a way; where it is waved or goes round there are twice as many. Hands are thin; the body needs every second one
// only.
constexpr int kSamples = 12;
// Depths count from a little above the surface.
constexpr double kTolerated = 0.001, kRoom = 0.003;  // metres
// That a path is bent at most, metres, and as a share of its length.
constexpr double kFarthest = 0.04, kFartherByLength = 0.6;
// Of an arm's length: beyond it an elbow that goes straight turns faster than any elbow.
constexpr double kEasyReach = 0.985;

// Bends to set out with where a way cannot be bent out of everything as it is, of so many metres.
constexpr double kDetour = 0.05;
// What goes deeper is not led out by another bend: hands that hang in a skirt.
constexpr double kHopeless = 0.05;  // metres
constexpr Vec3 kDetours[] = {{0, 0, 1}, {1, 0, 0},  {-1, 0, 0}, {0, 1, 0},  {0, -1, 0},
                             {0, 1, 1}, {0, -1, 1}, {1, 0, 1},  {-1, 0, 1}, {0, 0, -1}};

/// One hand on its way, and what the other does meanwhile.
struct Journey {
  const Signer& signer;
  Side side;
  HandSegment& segment;
  const TouchedSurfaces& touched;
  const Meanwhile& meanwhile;
  int samples = kSamples;

  HandState other_at(double share) const {
    return state_after(*meanwhile.other,
                       std::clamp(meanwhile.from + (meanwhile.to - meanwhile.from) * share, 0.0, 1.0));
  }
  struct Found {
    Depth depth;
    bool in_body = true;
  };
  Found depth(int sample, double at_least = 0.0) const {
    const double share = static_cast<double>(sample) / samples;
    Found found;
    if (sample % 2 != 0 && meanwhile.other == nullptr) return found;
    const HandState state = state_after(segment, share);
    if (sample % 2 == 0) found.depth = signer.depth_in_body(side, state, at_least);
    if (meanwhile.other == nullptr) return found;
    const Depth in_arm = signer.depth_in_arm(side, state, other_at(share), std::max(at_least, found.depth.metres));
    if (in_arm.metres > found.depth.metres) found = {in_arm, false};
    return found;
  }
  /// The way from the middle of the other hand to that of this one.
  Vec3 apart(double share) const {
    const auto middle = [this](Side of, const HandState& state) {
      return apply(state.wrist, signer.hand(of).site(HandPart::kPalm, state.angles).position);
    };
    const Side other = side == Side::kLeft ? Side::kRight : Side::kLeft;
    return unit(middle(side, state_after(segment, share)) - middle(other, other_at(share)));
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
  for (int i = 1; i < journey.samples; ++i) {
    const double share = static_cast<double>(i) / journey.samples;
    double own = std::max({from_depth * (1.0 - 3.0 * share), to_depth * (3.0 * share - 2.0), 0.0});
    // What slides from one to the other is no deeper on the way.
    if (journey.touched.slides()) own = std::max(own, from_depth + (to_depth - from_depth) * share);
    Journey::Found found = journey.depth(i, own + worst.found.depth.metres);
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
  for (int i = 2, times = 0; i < kSamples; i += 2) {
    const double share = static_cast<double>(i) / kSamples;
    while (length(state_after(journey.segment, share).wrist.position - shoulder) > reach && times++ < kTimes)
      journey.segment.bulge *= 0.85;
  }
}

/// Makes the touching part come within about 40 degrees of the normal at last, with the least change of the path: how
/// the hand turns and how the path is bent count as much as where the wrist comes from.
void come_along_normal(const Journey& journey) {
  constexpr double kLast = 0.81;  // share of the time after which a twentieth of the way is left
  constexpr double kSlope = 0.8;  // of what goes along the surface to what goes towards it
  constexpr double kMost = 0.06;  // metres
  const Touch& touch = journey.touched.to;
  HandSegment& segment = journey.segment;
  if (!touch.touches() || journey.touched.slides()) return;
  // As the other hand sees it, where that is what is touched.
  const bool seen_by_other = touch.on_other && journey.meanwhile.other != nullptr;
  const auto part_at = [&](double share) {
    const Vec3 point = apply(state_after(segment, share).wrist, touch.part);
    if (!seen_by_other) return point;
    const Transform then = journey.other_at(share).wrist, last = journey.other_at(1.0).wrist;
    return apply(last, glm::conjugate(then.rotation) * (point - then.position));
  };
  const Vec3 way = part_at(1.0) - part_at(kLast);
  const double towards = -glm::dot(way, touch.normal);
  const Vec3 aside = way + touch.normal * towards;
  const double slant = std::sqrt(glm::dot(aside, aside));
  const double missing = slant - kSlope * towards;
  if (missing <= 0.0) return;
  const double s = minimum_jerk(kLast);
  const double each = missing / (6.75 * s * s * (1.0 - s) * (1.0 + kSlope * kSlope));
  Vec3 more = each * (kSlope * touch.normal + unit(aside));
  const double length = std::sqrt(glm::dot(more, more));
  if (length > kMost) more *= kMost / length;
  segment.approach += more;
}

/// Returns how deep the hand still goes, metres; 0 where that is too little to count.
double bend_out(const Journey& journey) {
  constexpr int kRounds = 5;
  come_along_normal(journey);
  const double from_depth = journey.depth(0).depth.metres, to_depth = journey.depth(journey.samples).depth.metres;
  HandSegment& segment = journey.segment;
  const Vec3 path = segment.to.wrist.position - segment.from.wrist.position;
  const double bent = std::sqrt(glm::dot(segment.bulge, segment.bulge));
  const double farthest = std::max(bent, kFarthest + kFartherByLength * std::sqrt(glm::dot(path, path)));
  double least = 1e9;
  Vec3 best = segment.bulge, before(0.0);
  for (int round = 0;; ++round) {
    const Sample worst = deepest_sample(journey, from_depth, to_depth);
    if (worst.index == 0) return 0.0;
    const Depth& depth = worst.found.depth;
    if (depth.metres < least) {
      least = depth.metres;
      best = segment.bulge;
    }
    if (round == kRounds) {
      segment.bulge = best;
      return least;
    }
    const double share = static_cast<double>(worst.index) / journey.samples;
    const double s = minimum_jerk(share);
    // Round the body forwards, not round its back, to which it may be nearer.
    const double x = state_after(segment, share).wrist.position.x;
    const double beside = std::clamp(x / 0.2, -1.0, 1.0);
    const Vec3& nearer = s < 0.5 ? journey.touched.from.normal : journey.touched.to.normal;
    const Vec3& along = nearer != Vec3(0.0) ? nearer
                        : s < 0.5           ? journey.touched.to.normal
                                            : journey.touched.from.normal;
    Vec3 out = depth.out;
    // Between two things that push each other's way the hands part.
    if (!worst.found.in_body && glm::dot(out, before) < 0.0) out = journey.apart(share);
    if (along != Vec3(0.0) && glm::dot(along, out) > -0.5) {
      // Off what is touched, not round it.
      out = unit(along + 0.5 * out);
    } else if (worst.found.in_body) {
      out = unit(out.z > 0.2 ? out + Vec3(0.0, 0.0, 0.5) : Vec3(beside, 0.0, 1.0));
    }
    before = out;
    segment.bulge += out * ((depth.metres + kRoom) / std::max(0.4, 4.0 * s * (1.0 - s)));
    const double length = std::sqrt(glm::dot(segment.bulge, segment.bulge));
    if (length > farthest) segment.bulge *= farthest / length;
    keep_in_reach(journey);
    come_along_normal(journey);
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
    for (int i = 2; i < kSamples && deepest <= enough; i += 2) {
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

Way find_way(const Signer& signer, Side side, const HandSegment& wanted, const TouchedSurfaces& touched,
             const Meanwhile& meanwhile) {
  Way way;
  way.segment = wanted;
  way.segment.begin = 0;
  way.segment.end = kTicksPerSecond;
  way.depth = keep_clear(signer, side, way.segment, touched, meanwhile);
  return way;
}

double keep_clear(const Signer& signer, Side side, HandSegment& segment, const TouchedSurfaces& touched,
                  const Meanwhile& meanwhile) {
  const Vec3 apart = segment.to.wrist.position - segment.from.wrist.position;
  const bool waved = segment.turns > 0 || segment.oscillation.cycles > 0;
  if (glm::dot(apart, apart) < 1e-4 && !waved) return 0.0;
  const int samples = waved || signer.seeks_longer() ? 2 * kSamples : kSamples;
  const HandSegment wanted = segment;
  double depth = bend_out({signer, side, segment, touched, meanwhile, samples});
  if (depth > 0.0 && depth < kHopeless && signer.seeks_longer()) {
    for (const Vec3& way : kDetours) {
      HandSegment other = wanted;
      other.bulge += kDetour * way;
      const double found = bend_out({signer, side, other, touched, meanwhile, samples});
      if (found >= depth) continue;
      depth = found;
      segment = other;
      if (depth == 0.0) break;
    }
  }
  swing_out(signer, side, segment);
  return depth;
}

}  // namespace auslan
