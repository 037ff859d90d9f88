// SPDX-License-Identifier: Apache-2.0
#include "synthesis/performance.h"

#include "kinematics/arm_ik.h"
#include "kinematics/elementary.h"
#include "kinematics/interpolate.h"
#include "kinematics/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace auslan {
namespace {

constexpr double kBlinkSeconds = 0.16;
constexpr double kRamp = 0.3;  // of a circle, in turns: in which its speed rises
constexpr double kBreathHz = 0.24;
constexpr double kBreath = 0.35 * kDegree;
// A body that stands at ease is never quite still: slow turns whose times do not fit together, so that they never
// repeat within a sentence.
constexpr double kSwayTrunk = 0.35 * kDegree, kSwayHead = 0.6 * kDegree;

constexpr std::array<double, 3> kSwayHz = {0.11, 0.071, 0.173};

/// Rises over the onset, holds, falls over the release; the ramps are minimum-jerk curves.
double envelope(Tick time, Tick begin, Tick end, Tick onset, Tick release) {
  if (time <= begin || time >= end) return 0;
  const double up = onset > 0 ? minimum_jerk(static_cast<double>(time - begin) / static_cast<double>(onset)) : 1.0;
  const double down = release > 0 ? minimum_jerk(static_cast<double>(end - time) / static_cast<double>(release)) : 1.0;
  return up * down;
}

double mix(double a, double b, double t) {
  return a + (b - a) * t;
}

HandAngles mix(const HandAngles& a, const HandAngles& b, double t) {
  HandAngles m;
  for (size_t i = 0; i < 4; ++i) {
    m.fingers[i].mcp = mix(a.fingers[i].mcp, b.fingers[i].mcp, t);
    m.fingers[i].pip = mix(a.fingers[i].pip, b.fingers[i].pip, t);
    m.fingers[i].dip = mix(a.fingers[i].dip, b.fingers[i].dip, t);
    m.fingers[i].abduction = mix(a.fingers[i].abduction, b.fingers[i].abduction, t);
  }
  m.thumb.radial_abduction = mix(a.thumb.radial_abduction, b.thumb.radial_abduction, t);
  m.thumb.palmar_abduction = mix(a.thumb.palmar_abduction, b.thumb.palmar_abduction, t);
  m.thumb.opposition = mix(a.thumb.opposition, b.thumb.opposition, t);
  m.thumb.mp = mix(a.thumb.mp, b.thumb.mp, t);
  m.thumb.ip = mix(a.thumb.ip, b.thumb.ip, t);
  return m;
}

/// Progress at one speed that rises from rest in the first `ramp` of the time and falls to it in the last; the ramps
/// are minimum-jerk curves. Round after round of a circle is the same but for them. ramp in (0, 0.5].
double steady(double tau, double ramp) {
  const double early = tau <= 0.5 ? tau : 1.0 - tau;
  const double x = std::min(1.0, early / ramp);
  // The integral of 10x^3 - 15x^4 + 6x^5 is a half at 1.
  const double gone = ramp * (x * x * x * x * (2.5 + x * (x - 3.0))) + std::max(0.0, early - ramp);
  const double share = gone / (1.0 - ramp);
  return tau <= 0.5 ? share : 1.0 - share;
}

/// From a through the middle (s = 1/2) to b: a parabola in the rotation vector from the middle, which is slerp where
/// the three lie on one turn.
Quat through(const Quat& a, const Quat& middle, const Quat& b, double s) {
  const Quat back = glm::conjugate(middle);
  const Vec3 to_a = rotation_vector(a * back), to_b = rotation_vector(b * back);
  return from_rotation_vector(to_a * ((1.0 - s) * (1.0 - 2.0 * s)) + to_b * (s * (2.0 * s - 1.0))) * middle;
}

void oscillate(const Oscillation& oscillation, double tau, HandState& state) {
  if (oscillation.cycles <= 0) return;
  // Fades in over the first and out over the last quarter cycle, so that it starts and ends at rest.
  const double edge = std::min(0.5, 0.25 / oscillation.cycles + 0.05);
  // What grows or shrinks is largest as wide as it was asked for.
  const double most = std::max(1.0, oscillation.growth);
  const double size = mix(1.0, oscillation.growth, tau) / most;
  const double fade = minimum_jerk(tau / edge) * minimum_jerk((1.0 - tau) / edge) * size;
  const double angle = 2.0 * kPi * (oscillation.cycles * tau + oscillation.phase);
  const double wave = fade * sine(angle);
  state.wrist.position += oscillation.shift * wave;
  if (oscillation.turn != Vec3(0.0) || oscillation.turn_ahead != Vec3(0.0)) {
    Vec3 turn = oscillation.turn * wave;
    if (oscillation.turn_ahead != Vec3(0.0)) turn += oscillation.turn_ahead * (fade * cosine(angle));
    const Vec3 held = apply(state.wrist, oscillation.pivot);
    state.wrist.rotation = from_rotation_vector(turn) * state.wrist.rotation;
    if (oscillation.pivot != Vec3(0.0)) state.wrist.position = held - state.wrist.rotation * oscillation.pivot;
  }
  if (oscillation.flex != 0) {
    // Towards the fist, and no farther: a joint with less room moves less instead of stopping short.
    const double closing = fade * 0.5 * (1.0 - cosine(angle));
    for (DigitAngles& finger : state.angles.fingers) {
      finger.mcp += closing * std::clamp(90 * kDegree - finger.mcp, 0.0, oscillation.flex);
      finger.pip += closing * std::clamp(105 * kDegree - finger.pip, 0.0, oscillation.flex);
    }
  }
  if (oscillation.wiggle != 0) {
    if ((oscillation.wiggling & 1U) != 0 && oscillation.wiggle > 0) {
      const double bend = fade * (0.5 - 0.5 * cosine(angle)) * oscillation.wiggle;
      state.angles.thumb.mp += 0.6 * bend;
      state.angles.thumb.ip += bend;
    }
    for (size_t i = 0; i < 4; ++i) {
      if ((oscillation.wiggling & (2U << i)) == 0) continue;
      const double of_finger = angle + 0.5 * kPi * static_cast<double>(i);
      if (oscillation.wiggle < 0) {
        state.angles.fingers[i].mcp += fade * (0.5 - 0.5 * cosine(of_finger)) * oscillation.wiggle;
        continue;
      }
      const double finger = fade * sine(of_finger) * oscillation.wiggle;
      state.angles.fingers[i].mcp += 0.6 * finger + 0.4 * oscillation.wiggle * fade;
      state.angles.fingers[i].pip += 0.4 * finger + 0.4 * oscillation.wiggle * fade;
    }
  }
}

std::vector<int> mirror_table(const Skeleton& skeleton) {
  std::vector<int> table;
  for (int i = 0; i < skeleton.size(); ++i) {
    std::string name = skeleton.node(i).name;
    int image = i;
    if (name.size() > 2 && name[name.size() - 2] == '_' && (name.back() == 'l' || name.back() == 'r')) {
      name.back() = name.back() == 'l' ? 'r' : 'l';
      const int found = skeleton.find(name);
      if (found != kNoNode) image = found;
    }
    table.push_back(image);
  }
  return table;
}

void mirror_pose(const std::vector<int>& table, Pose& pose) {
  for (size_t i = 0; i < table.size(); ++i) {
    const auto j = static_cast<size_t>(table[i]);
    if (j < i) continue;
    const Quat a = pose.rotation[i], b = pose.rotation[j];
    pose.rotation[i] = Quat(b.w, b.x, -b.y, -b.z);
    pose.rotation[j] = Quat(a.w, a.x, -a.y, -a.z);
  }
  pose.root_translation.x = -pose.root_translation.x;
  for (int i = 0; i < kFaceChannelCount; ++i) {
    const auto left = static_cast<FaceChannel>(i);
    if (const FaceChannel right = right_of(left); right != left)
      std::swap(pose.face[static_cast<size_t>(left)], pose.face[static_cast<size_t>(right)]);
  }
}

}  // namespace

HandState state_at(const HandSegment& segment, Tick time) {
  const double length = static_cast<double>(std::max<Tick>(1, segment.end - segment.begin));
  return state_after(segment, std::clamp(static_cast<double>(time - segment.begin) / length, 0.0, 1.0));
}

HandState state_after(const HandSegment& segment, double tau) {
  const double s = minimum_jerk(tau);
  const HandState &a = segment.from, &b = segment.to;
  HandState state;
  state.wrist.position = a.wrist.position + (b.wrist.position - a.wrist.position) * s +
                         segment.bulge * (4.0 * s * (1.0 - s)) +
                         (segment.leave * (1.0 - s) + segment.approach * s) * (6.75 * s * (1.0 - s));
  if (segment.turns > 0) {
    double sn = 0, cs = 1;
    sine_cosine(2.0 * kPi * segment.turns * steady(tau, std::min(0.5, kRamp / segment.turns)), sn, cs);
    if (segment.circle_growth == 1) {
      state.wrist.position += segment.circle_u * (cs - 1.0) + segment.circle_v * sn;
    } else {
      // The centre stays; the distance from it grows or shrinks.
      const double size = mix(1.0, segment.circle_growth, s);
      state.wrist.position += segment.circle_u * (size * cs - 1.0) + segment.circle_v * (size * sn);
    }
  }
  state.wrist.rotation = segment.turn_middle ? through(a.wrist.rotation, *segment.turn_middle, b.wrist.rotation, s)
                                             : slerp(a.wrist.rotation, b.wrist.rotation, s);
  state.swivel = mix(a.swivel, b.swivel, s) + segment.swivel_bulge * (4.0 * s * (1.0 - s));
  // Off the face, in the first half of the way, a hand leaves the head to itself; to the face it joins it in the
  // second.
  const double leaving = a.follows_head > b.follows_head ? 2.0 * tau : 2.0 * tau - 1.0;
  state.follows_head = mix(a.follows_head, b.follows_head, minimum_jerk(std::clamp(leaving, 0.0, 1.0)));
  if (a.follows_head == 0.0) {
    state.on_face = b.on_face;
  } else {
    state.on_face = b.follows_head == 0.0 ? a.on_face : a.on_face + (b.on_face - a.on_face) * s;
  }
  state.angles = mix(a.angles, b.angles, minimum_jerk(tau / std::max(0.05, segment.digits_lead)));
  oscillate(segment.oscillation, tau, state);
  return state;
}

Performance::Performance(const Signer& signer, Score score, const PerformanceOptions& options)
    : signer_(&signer), score_(std::move(score)), options_(options), mirror_(mirror_table(signer.figure().skeleton)) {
  // Blinks every 2.5 to 5 seconds, from a linear congruential generator (Knuth's MMIX constants).
  uint64_t random = options.seed * 6364136223846793005ULL + 1442695040888963407ULL;
  Tick next = ticks(0.9);
  while (options.idle && next < score_.end) {
    blinks_.push_back(next);
    random = random * 6364136223846793005ULL + 1442695040888963407ULL;
    next += ticks(2.5) + static_cast<Tick>((random >> 33U) % static_cast<uint64_t>(ticks(2.5)));
  }
  for (double& phase : sway_phase_) {
    random = random * 6364136223846793005ULL + 1442695040888963407ULL;
    phase = static_cast<double>(random >> 33U) / 2147483648.0;
  }
}

void Performance::sample_hand(Side side, Tick time, const Transform& trunk, const Transform& head, Pose& pose) const {
  const auto& track = score_.hands[static_cast<size_t>(side)];
  HandState state = signer_->rest(side);
  if (!track.empty()) {
    auto segment = std::upper_bound(track.begin(), track.end(), time,
                                    [](Tick t, const HandSegment& candidate) { return t < candidate.end; });
    if (segment == track.end()) --segment;
    state = state_at(*segment, time);
  }
  // The hand goes where the body carries it. While it touches the face it goes with the place that it touches, and
  // stays turned as it is: an arm has no room for a nod at the end of its range.
  Transform wrist{trunk.rotation * state.wrist.rotation, apply(trunk, state.wrist.position)};
  if (state.follows_head > 0) {
    const Vec3 part = apply(state.wrist, state.on_face);
    wrist.position += (apply(head, part) - apply(trunk, part)) * state.follows_head;
  }
  const Skeleton& skeleton = signer_->figure().skeleton;
  const ArmNodes nodes = arm_nodes(skeleton, side);
  const Transform base{trunk.rotation, apply(trunk, skeleton.rest_position(nodes.trunk))};
  pose_arm(nodes, signer_->reach(side).limited(solve_arm(skeleton, side, base, wrist, state.swivel)), pose);
  pose_hand(skeleton, side, state.angles, pose);
}

void Performance::sample_face(Tick time, FaceWeights& face) const {
  face = {};
  FaceWeights lips{};
  // Features of one channel meet without a kink: what one leaves, the next takes its share of.
  const auto join = [](float a, float b) { return a + b - a * b; };
  for (const FaceSpan& span : score_.face) {
    if (time <= span.begin || time >= span.end) continue;
    const auto strength = static_cast<float>(envelope(time, span.begin, span.end, span.onset, span.release));
    for (size_t i = 0; i < face.size(); ++i) {
      if (span.mouthing) {
        lips[i] += strength * span.weights[i];
      } else {
        face[i] = join(face[i], strength * span.weights[i]);
      }
    }
  }
  for (size_t i = 0; i < face.size(); ++i)
    face[i] = join(face[i], std::min(1.0F, lips[i]));
  for (const Tick blink : blinks_) {
    const Tick half = ticks(kBlinkSeconds) / 2;
    const auto closed = static_cast<float>(envelope(time, blink, blink + 2 * half, half, half));
    for (const FaceChannel lid : {FaceChannel::kEyeBlinkLeft, FaceChannel::kEyeBlinkRight}) {
      float& weight = face[static_cast<size_t>(lid)];
      weight = join(weight, closed);
    }
  }
}

void Performance::sample(Tick time, Pose& pose) const {
  time = std::clamp<Tick>(time, 0, score_.end);
  const Skeleton& skeleton = signer_->figure().skeleton;
  pose.rotation.resize(static_cast<size_t>(skeleton.size()), kIdentity);
  Vec3 head_turn(0.0), trunk_turn(0.0);
  for (const BodySpan& span : score_.body) {
    const double strength = envelope(time, span.begin, span.end, span.onset, span.release);
    if (strength <= 0) continue;
    head_turn += span.head * strength;
    trunk_turn += span.trunk * strength;
    if (span.swing_hz > 0)
      head_turn += span.swing * (strength * sine(2.0 * kPi * span.swing_hz * seconds(time - span.begin - span.onset)));
  }
  if (options_.idle) {
    trunk_turn.x -= kBreath * sine(2.0 * kPi * kBreathHz * seconds(time));
    const auto sway = [&](size_t i) { return sine(2.0 * kPi * (kSwayHz[i] * seconds(time) + sway_phase_[i])); };
    trunk_turn.z += kSwayTrunk * sway(0);
    trunk_turn.y += kSwayTrunk * sway(1);
    // The head stays on the addressee: it gives back what the trunk turns, and has a life of its own.
    head_turn.z -= 0.5 * kSwayTrunk * sway(0);
    head_turn.y += kSwayHead * sway(2) - kSwayTrunk * sway(1);
  }
  const int spine = skeleton.find("spine_base"), neck = skeleton.find("neck_base"), head = skeleton.find("head_base");
  const Quat trunk = from_rotation_vector(trunk_turn);
  const Quat half_turn = from_rotation_vector(head_turn * 0.5);
  pose.rotation[static_cast<size_t>(spine)] = trunk;
  pose.rotation[static_cast<size_t>(neck)] = half_turn;
  pose.rotation[static_cast<size_t>(head)] = half_turn;
  pose.root_translation = Vec3(0.0);
  // How trunk and head are displaced from rest.
  const auto about = [](const Quat& rotation, const Vec3& rest, const Vec3& now) {
    return Transform{rotation, now - rotation * rest};
  };
  const Vec3 spine_rest = skeleton.rest_position(spine), neck_rest = skeleton.rest_position(neck),
             head_rest = skeleton.rest_position(head);
  const Transform trunk_moved = about(trunk, spine_rest, spine_rest);
  const Vec3 head_now = apply(trunk_moved, neck_rest) + (trunk * half_turn) * (head_rest - neck_rest);
  const Transform head_moved = about(trunk * half_turn * half_turn, head_rest, head_now);
  sample_hand(Side::kLeft, time, trunk_moved, head_moved, pose);
  sample_hand(Side::kRight, time, trunk_moved, head_moved, pose);
  sample_face(time, pose.face);
  if (options_.left_handed) mirror_pose(mirror_, pose);
}

}  // namespace auslan
