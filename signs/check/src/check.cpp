// SPDX-License-Identifier: Apache-2.0
#include "check/check.h"

#include "body_solids.h"
#include "kinematics/elementary.h"
#include "kinematics/limits.h"
#include "kinematics/rotation.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace auslan {
namespace {

constexpr Tick kStep = kTicksPerSecond / 120;

// The project's limits of quality. What is measured in floats and by vertices of a mesh has a little room.
constexpr std::array<MeasureInfo, kMeasureCount> kInfos = {{
    {"contact", "mm", 0.0, 3.0},
    {"penetration", "mm", 0.0, 0.05},
    {"pressing", "mm", 0.0, 3.0},
    {"direction", "degrees", 0.0, 5.0},
    {"handshape", "degrees", 0.0, 2.0},
    {"joint-limits", "degrees", 0.0, 0.05},
    {"angular-velocity", "%", 0.0, 1.0},
    {"stroke", "peak/mean", 1.7, 2.1},
    {"hold", "ms", 80.0, 1e9},
    {"wrist-speed", "m/s", 0.0, 4.0},
    {"face-hidden", "%", 0.0, 5.0},
}};

// A joint that turns slower than this at its fastest has no jump worth a percentage, radians a second.
constexpr double kSlowestPeak = 0.3;
// Shorter strokes are part of a larger movement, metres.
constexpr double kShortestStroke = 0.03;
// A path that bows out farther than this share of its length is not one from point to point.
constexpr double kStraightest = 0.1;

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

double degrees_between(const Vec3& a, const Vec3& b) {
  return arc_cosine(glm::dot(unit(a), unit(b))) / kDegree;
}

double badness(Measure measure, double value) {
  const MeasureInfo& range = info(measure);
  return value > range.high ? value - range.high : value < range.low ? range.low - value : 0.0;
}

/// The groups of the body that a place belongs to.
std::vector<BodyGroup> groups_of(Location location, Side side) {
  const bool left = side == Side::kLeft;
  if (is_on_head(location)) return {BodyGroup::kHead, BodyGroup::kTrunk};
  if (location == Location::kUpperArm || location == Location::kElbow || location == Location::kOtherElbow)
    return {left ? BodyGroup::kRightUpperArm : BodyGroup::kLeftUpperArm,
            left ? BodyGroup::kRightForearm : BodyGroup::kLeftForearm};
  if (is_on_other_hand(location))
    return {left ? BodyGroup::kRightHand : BodyGroup::kLeftHand,
            left ? BodyGroup::kRightForearm : BodyGroup::kLeftForearm};
  if (is_in_space(location)) return {};
  return {BodyGroup::kTrunk, BodyGroup::kHead};
}

class Judge {
 public:
  Judge(const Signer& signer, const BodySolids& solids, const Score& score, Verdict& verdict)
      : signer_(signer),
        solids_(solids),
        skeleton_(signer.figure().skeleton),
        score_(score),
        performance_(signer, score, {.left_handed = false, .idle = false, .seed = 1}),
        verdict_(verdict),
        world_(static_cast<size_t>(skeleton_.size())),
        arms_{arm_nodes(skeleton_, Side::kLeft), arm_nodes(skeleton_, Side::kRight)} {}

  void run() {
    over_time();
    at_targets();
    at_keys();
    strokes();
    holds();
  }

 private:
  void note(Measure measure, double value, Tick time, std::string where) {
    std::optional<Measured>& worst = verdict_.worst[static_cast<size_t>(measure)];
    const bool worse = !worst || badness(measure, value) > badness(measure, worst->value) ||
                       (badness(measure, worst->value) == 0.0 && value > worst->value);
    if (worse) worst = Measured{value, time, std::move(where)};
  }
  const std::string& name(int node) const { return skeleton_.node(node).name; }
  void pose_at(Tick time) {
    performance_.sample(time, pose_);
    forward(skeleton_, pose_, world_);
  }
  bool may_touch(BodyGroup a, BodyGroup b) const;
  bool is_on_face() const;
  double hidden_share();
  bool hides(const Vec3& eye, const Vec3& point) const;

  void over_time();
  void at_targets();
  void at_keys();
  void strokes();
  void holds();

  const Signer& signer_;
  const BodySolids& solids_;
  const Skeleton& skeleton_;
  const Score& score_;
  Performance performance_;
  Verdict& verdict_;
  Pose pose_;
  std::vector<Transform> world_;
  std::array<ArmNodes, 2> arms_;
};

bool Judge::may_touch(BodyGroup a, BodyGroup b) const {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const BodyGroup hand = side == Side::kLeft ? BodyGroup::kLeftHand : BodyGroup::kRightHand;
    if (a != hand && b != hand) continue;
    const BodyGroup met = a == hand ? b : a;
    for (const HandTarget& target : score_.targets[static_cast<size_t>(side)]) {
      if (!target.touches) continue;
      const auto groups = groups_of(target.location, side);
      if (std::find(groups.begin(), groups.end(), met) != groups.end()) return true;
    }
  }
  return false;
}

bool Judge::is_on_face() const {
  for (const auto& side : score_.targets)
    for (const HandTarget& target : side)
      if (is_on_head(target.location)) return true;
  return false;
}

bool Judge::hides(const Vec3& eye, const Vec3& point) const {
  // A finger is no thinner than this, so that steps of half of it miss none.
  constexpr double kStepLength = 0.005;
  // A hand that hides the face is before it, no farther than an arm reaches.
  constexpr double kReach = 0.6;
  const Vec3 towards = unit(eye - point);
  for (const BodyGroup hand : {BodyGroup::kLeftHand, BodyGroup::kRightHand}) {
    double along = 0.01;
    while (along < kReach) {
      const auto distance = solids_.distance(hand, point + towards * along, kReach, world_);
      if (!distance) break;
      if (*distance <= 0.0) return true;
      along += std::max(kStepLength, *distance);
    }
  }
  return false;
}

void Judge::over_time() {
  const bool face_is_free = !is_on_face();
  const int head = skeleton_.find("head_base");
  const Vec3 head_rest = skeleton_.rest_position(head);
  std::array<Vec3, 3> seen = {signer_.body().site(Location::kMouth, Side::kRight, Vec3(0.0), true).position,
                              signer_.body().site(Location::kEye, Side::kLeft, Vec3(0.0), true).position,
                              signer_.body().site(Location::kEye, Side::kRight, Vec3(0.0), true).position};
  int frames = 0;
  int hidden = 0;
  Tick hidden_at = 0;
  std::array<Vec3, 2> before{};
  for (Tick time = 0; time <= score_.end; time += kStep) {
    pose_at(time);
    for (int node = 0; node < skeleton_.size(); ++node)
      note(Measure::kJointLimits, limit_violation(skeleton_, node, pose_.rotation[static_cast<size_t>(node)]) / kDegree,
           time, name(node));
    for (size_t side = 0; side < 2; ++side) {
      const Vec3 wrist = world_[static_cast<size_t>(arms_[side].wrist)].position;
      if (time > 0) note(Measure::kWristSpeed, length(wrist - before[side]) * 120.0, time, name(arms_[side].wrist));
      before[side] = wrist;
    }
    note(Measure::kPenetration, 0.0, 0, "");
    for (const Overlap& overlap : solids_.overlaps(world_))
      note(may_touch(overlap.a, overlap.b) ? Measure::kPressing : Measure::kPenetration, overlap.depth * 1e3, time,
           name(overlap.node_a) + " in " + name(overlap.node_b));
    if (!face_is_free) continue;
    const Transform& placed = world_[static_cast<size_t>(head)];
    const Vec3 eye = placed.position + Vec3(0.0, 0.0, 3.0);
    ++frames;
    for (const Vec3& point : seen) {
      if (!hides(eye, apply(placed, point - head_rest))) continue;
      ++hidden;
      hidden_at = time;
      break;
    }
  }
  if (frames > 0) note(Measure::kFaceHidden, 100.0 * hidden / frames, hidden_at, "mouth or eyes");
}

void Judge::at_targets() {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const ArmNodes& arm = arms_[static_cast<size_t>(side)];
    const HandFrame& frame = signer_.hand_frame(side);
    for (const HandTarget& target : score_.targets[static_cast<size_t>(side)]) {
      pose_at(target.end);
      const Transform& wrist = world_[static_cast<size_t>(arm.wrist)];
      // What the trunk's turn does to directions is not the hand's fault.
      const Quat trunk = world_[static_cast<size_t>(skeleton_.find("spine_base"))].rotation;
      const Quat turned = glm::conjugate(trunk) * wrist.rotation;
      note(Measure::kDirection, degrees_between(turned * frame.fingers, target.fingers), target.end,
           name(arm.wrist) + " fingers");
      // Of the palm only what lies across the fingers can be stated freely.
      const Vec3 fingers = unit(target.fingers);
      const Vec3 palm = target.palm - fingers * glm::dot(target.palm, fingers);
      if (glm::dot(palm, palm) > 1e-3)
        note(Measure::kDirection, degrees_between(turned * frame.palm, palm), target.end, name(arm.wrist) + " palm");
      Pose stated = pose_;
      pose_hand(skeleton_, side, target.angles, stated);
      for (const auto& digit : arm.digits)
        for (const int node : digit)
          note(Measure::kHandshape,
               angle_between(stated.rotation[static_cast<size_t>(node)], pose_.rotation[static_cast<size_t>(node)]) /
                   kDegree,
               target.end, name(node));
      if (!target.touches) continue;
      const Vec3 part = apply(wrist, target.part);
      double nearest = 0.1;
      for (const BodyGroup group : groups_of(target.location, side))
        if (const auto distance = solids_.distance(group, part, nearest, world_))
          nearest = std::min(nearest, std::abs(*distance));
      note(Measure::kContact, nearest * 1e3, target.end,
           name(arm.wrist) + " to " + std::string(to_name(target.location)));
    }
  }
}

void Judge::at_keys() {
  std::vector<Tick> keys;
  for (const auto& track : score_.hands)
    for (const HandSegment& segment : track)
      keys.push_back(segment.begin);
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
  for (Tick time = 0; time + kStep <= score_.end; time += kStep) {
    const std::vector<Vec3> v = velocities(time, time + kStep);
    std::vector<double>& row = speeds.emplace_back(nodes);
    for (size_t i = 0; i < nodes; ++i)
      row[i] = length(v[i]);
  }
  for (const Tick key : keys) {
    if (key < 1 || key + 1 > score_.end) continue;
    const std::vector<Vec3> before = velocities(key - 1, key);
    const std::vector<Vec3> after = velocities(key, key + 1);
    const auto first = static_cast<size_t>(std::max<Tick>(0, key - kNear) / kStep);
    const auto last = std::min(speeds.size(), static_cast<size_t>((key + kNear) / kStep));
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
    // A letter has to be read on its own.
    const double wanted = gloss.spelled ? 120.0 / 80.0 : 1.0;
    note(Measure::kHold, seconds(longest) * 1e3 / wanted, gloss.begin, gloss.label);
  }
}

}  // namespace

const MeasureInfo& info(Measure measure) {
  return kInfos[static_cast<size_t>(measure)];
}

bool Verdict::good(Measure measure) const {
  const std::optional<Measured>& found = of(measure);
  return !found || badness(measure, found->value) == 0.0;
}

bool Verdict::good() const {
  for (size_t i = 0; i < kMeasureCount; ++i)
    if (!good(static_cast<Measure>(i))) return false;
  return true;
}

struct Checker::State {
  const Signer& signer;
  BodySolids solids;
};

Checker::Checker(const Signer& signer) : state_(new State{signer, BodySolids(signer.figure())}) {}
Checker::Checker(Checker&&) noexcept = default;
Checker& Checker::operator=(Checker&&) noexcept = default;
Checker::~Checker() = default;

Verdict Checker::check(const Score& score) const {
  Verdict verdict;
  Judge(state_->signer, state_->solids, score, verdict).run();
  return verdict;
}

}  // namespace auslan
