// SPDX-License-Identifier: Apache-2.0
#include "judge.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace auslan {
namespace {

// A joint that turns slower than this at its fastest has no jump worth a percentage, radians a second.
constexpr double kSlowestPeak = 0.3;
// Shorter strokes are part of a larger movement, metres.
constexpr double kShortestStroke = 0.03;
// A path that bows out farther than this share of its length is not one from point to point.
constexpr double kStraightest = 0.1;
// So many in a row before their rate is one of continuous signing: that of fewer is what just these signs take. Letters
// take about as long as each other.
constexpr int kFewestSigns = 5, kFewestLetters = 3;
// Every so many checks the mirror image is looked at.
constexpr Tick kMirrorStep = 4 * kCheckStep;

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

Quat mirrored(const Quat& q) {
  return {q.w, q.x, -q.y, -q.z};
}

/// Of each node the one whose rest position is the mirror image of its own, as nearly as any.
std::vector<size_t> image_nodes(const Skeleton& skeleton) {
  std::vector<size_t> images;
  for (int i = 0; i < skeleton.size(); ++i) {
    Vec3 image = skeleton.rest_position(i);
    image.x = -image.x;
    size_t best = 0;
    double least = 1e9;
    for (int j = 0; j < skeleton.size(); ++j) {
      const double apart = length(skeleton.rest_position(j) - image);
      if (apart >= least) continue;
      least = apart;
      best = static_cast<size_t>(j);
    }
    images.push_back(best);
  }
  return images;
}

}  // namespace

void Judge::at_keys() {
  std::vector<Tick> keys;
  for (const auto& track : score_.hands)
    for (const HandSegment& segment : track)
      keys.push_back(segment.begin);
  for (const BodySpan& span : score_.body)
    for (const Tick key : {span.begin, span.begin + span.onset, span.end - span.release, span.end})
      keys.push_back(key);
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  const auto nodes = static_cast<size_t>(skeleton_.size());
  // Radians a tick of each joint between two times.
  const auto velocities = [&](Tick from, Tick to) {
    Pose a;
    Pose b;
    performance_.sample(from, a);
    performance_.sample(to, b);
    std::vector<Vec3> result(nodes);
    for (size_t i = 0; i < nodes; ++i)
      result[i] = rotation_vector(b.rotation[i] * glm::conjugate(a.rotation[i])) / static_cast<double>(to - from);
    return result;
  };
  // The peak speed of each joint within a quarter of a second.
  constexpr Tick kNear = kTicksPerSecond / 4;
  std::vector<std::vector<double>> speeds;
  for (Tick time = 0; time + kCheckStep <= score_.end; time += kCheckStep) {
    const std::vector<Vec3> v = velocities(time, time + kCheckStep);
    std::vector<double>& row = speeds.emplace_back(nodes);
    for (size_t i = 0; i < nodes; ++i)
      row[i] = length(v[i]);
  }
  for (const Tick key : keys) {
    if (key < 1 || key + 1 > score_.end) continue;
    const std::vector<Vec3> before = velocities(key - 1, key);
    const std::vector<Vec3> after = velocities(key, key + 1);
    const auto first = static_cast<size_t>(std::max<Tick>(0, key - kNear) / kCheckStep);
    const auto last = std::min(speeds.size(), static_cast<size_t>((key + kNear) / kCheckStep));
    for (size_t i = 0; i < nodes; ++i) {
      double peak = 0.0;
      for (size_t row = first; row < last; ++row)
        peak = std::max(peak, speeds[row][i]);
      if (peak * kTicksPerSecond < kSlowestPeak) continue;
      note(Measure::kAngularVelocity, 100.0 * length(after[i] - before[i]) / peak, key, name(static_cast<int>(i)));
    }
  }
}

void Judge::strokes() {
  constexpr Tick kSamples = 100;
  for (size_t side = 0; side < 2; ++side) {
    for (const HandSegment& segment : score_.hands[side]) {
      const Oscillation& o = segment.oscillation;
      if (segment.turns > 0 || o.shift != Vec3(0.0) || o.turn != Vec3(0.0)) continue;
      const double way = length(segment.to.wrist.position - segment.from.wrist.position);
      if (way < kShortestStroke ||
          length(segment.bulge) + length(segment.leave) + length(segment.approach) > kStraightest * way)
        continue;
      double peak = 0.0;
      double sum = 0.0;
      Tick last = segment.begin;
      Vec3 before = state_at(segment, last).wrist.position;
      const Tick step = std::max<Tick>(1, (segment.end - segment.begin) / kSamples);
      for (Tick time = last + step; time <= segment.end; time += step) {
        const Vec3 now = state_at(segment, time).wrist.position;
        peak = std::max(peak, length(now - before) / static_cast<double>(step));
        sum += length(now - before);
        before = now;
        last = time;
      }
      if (sum > 0.0)
        note(Measure::kStroke, peak * static_cast<double>(last - segment.begin) / sum, segment.begin,
             name(arms_[side].wrist));
    }
  }
}

void Judge::holds() {
  for (const GlossSpan& gloss : score_.glosses) {
    Tick longest = 0;
    for (const auto& side : score_.targets)
      for (const HandTarget& target : side)
        if (target.begin >= gloss.begin && target.end <= gloss.end)
          longest = std::max(longest, target.end - target.begin);
    note(gloss.spelled ? Measure::kLetterHold : Measure::kHold, seconds(longest) * 1e3, gloss.begin, gloss.label);
  }
}

void Judge::rates() {
  // Time and number of the steps from one entry to the next, where both are signs, or letters of one word.
  struct Steps {
    int count = 0;
    Tick time = 0, first = 0;
  };
  std::array<Steps, 2> all;
  for (size_t i = 0; i + 1 < score_.glosses.size(); ++i) {
    const GlossSpan& gloss = score_.glosses[i];
    const GlossSpan& next = score_.glosses[i + 1];
    // A pause lies between units that are not neighbours.
    if (gloss.spelled != next.spelled || next.unit != gloss.unit + 1) continue;
    if (gloss.spelled && gloss.label != next.label) continue;
    Steps& steps = all[gloss.spelled ? 1 : 0];
    if (steps.count == 0) steps.first = gloss.begin;
    ++steps.count;
    steps.time += next.begin - gloss.begin;
  }
  for (const size_t spelled : {size_t{0}, size_t{1}}) {
    const Steps& steps = all[spelled];
    if (steps.count + 1 < (spelled == 1 ? kFewestLetters : kFewestSigns)) continue;
    note(spelled == 1 ? Measure::kLetterRate : Measure::kSignRate, steps.count / seconds(steps.time), steps.first,
         std::to_string(steps.count + 1) + (spelled == 1 ? " letters" : " signs"));
  }
}

void Judge::mirror_image() {
  const std::vector<size_t> images = image_nodes(skeleton_);
  const Performance left_handed(signer_, score_, {.left_handed = true, .idle = false, .seed = 1});
  Pose image;
  for (Tick time = 0; time <= score_.end; time += kMirrorStep) {
    performance_.sample(time, pose_);
    left_handed.sample(time, image);
    double most = 0.0;
    size_t at = 0;
    for (size_t i = 0; i < images.size(); ++i) {
      const Quat wanted = mirrored(pose_.rotation[i]);
      const Quat& shown = image.rotation[images[i]];
      if (wanted == shown) continue;
      // What differs in a last bit alone is no exact image either.
      most = std::max({most, angle_between(wanted, shown) / kDegree, 1e-9});
      at = i;
    }
    for (int i = 0; i < kFaceChannelCount; ++i) {
      const auto channel = static_cast<FaceChannel>(i);
      const auto right = static_cast<size_t>(right_of(channel));
      if (pose_.face[static_cast<size_t>(i)] != image.face[right] ||
          pose_.face[right] != image.face[static_cast<size_t>(i)])
        most = std::max(most, 1e-9);
    }
    note(Measure::kMirror, most, time, name(static_cast<int>(at)));
  }
}

}  // namespace auslan
