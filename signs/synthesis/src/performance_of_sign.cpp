// SPDX-License-Identifier: Apache-2.0
#include "performance_of_sign.h"

#include "kinematics/elementary.h"
#include "phonology/vocabulary.h"
#include "stroke.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace auslan {
namespace {

constexpr size_t kLeft = static_cast<size_t>(Side::kLeft), kRight = static_cast<size_t>(Side::kRight);

Vec3 mirror(const Vec3& v) {
  return {-v.x, v.y, v.z};
}
/// Rotation vectors are axial: the mirror keeps their x.
Vec3 mirror_turn(const Vec3& v) {
  return {v.x, -v.y, -v.z};
}

HandTarget mirror(const HandTarget& target) {
  HandTarget image = target;
  image.fingers = mirror(target.fingers);
  image.palm = mirror(target.palm);
  image.part = mirror(target.part);
  const Quat& q = target.reached;
  image.reached = Quat(q.w, q.x, -q.y, -q.z);
  return image;
}

HandSegment mirror(const HandSegment& segment) {
  HandSegment image = segment;
  image.from = mirrored(segment.from);
  image.to = mirrored(segment.to);
  image.bulge = mirror(segment.bulge);
  image.circle_u = mirror(segment.circle_u);
  image.circle_v = mirror(segment.circle_v);
  image.oscillation.shift = mirror(segment.oscillation.shift);
  image.oscillation.turn = mirror_turn(segment.oscillation.turn);
  return image;
}

/// Movements that share their phases happen at the same time.
struct Step {
  int from = 0, to = 0;
  std::vector<const Movement*> movements;
};

std::vector<Step> steps_of(const Sign& sign) {
  std::vector<Step> steps;
  for (const Movement& movement : sign.movements) {
    const auto same = std::find_if(steps.begin(), steps.end(), [&](const Step& step) {
      return step.from == movement.from && step.to == movement.to;
    });
    if (same != steps.end()) {
      same->movements.push_back(&movement);
    } else {
      steps.push_back({movement.from, movement.to, {&movement}});
    }
  }
  return steps;
}

/// A unit vector across `axis`, as near to `wish` as possible.
Vec3 across(const Vec3& axis, const Vec3& wish) {
  const Vec3 rest = wish - axis * glm::dot(wish, axis);
  if (glm::dot(rest, rest) > 1e-6) return unit(rest);
  const Vec3 second = Vec3(0, 1, 0) - axis * axis.y;
  return unit(second, Vec3(0, 0, 1));
}

/// Lays one sign out for its dominant hand, and for the other as the relation of the hands asks.
class SignBuilder {
 public:
  SignBuilder(const Signer& signer, const Utterance& utterance, const Unit& unit,
              const std::array<HandState, 2>& waiting)
      : signer_(signer), utterance_(utterance), unit_(unit), sign_(*unit.sign), waiting_(waiting) {}

  Result<SignPerformance> build();

 private:
  const Handshape& shape(const Posture& posture) const { return utterance_.handshapes.find(posture.handshape)->second; }
  Result<void> check() const;
  void place_phases();
  void add_path(const Step& step);
  void add_local(const Step& step);
  void add_tap(const Movement& movement, size_t phase);
  void add_hold(size_t phase, double seconds);
  void stroke_to(size_t from, size_t to, double factor);
  /// Appends a beat from the dominant hand's segment and the relation of the hands.
  void push(double seconds, bool hold, HandSegment dominant, size_t from, size_t to, const Movement* movement);
  /// What a hand shows where a segment leaves it; nothing where that is not one of its postures.
  std::optional<HandTarget> shown(const HandState& state, const std::vector<Posture>& postures,
                                  const std::vector<PlacedHand>& placed) const;
  std::array<std::optional<HandTarget>, 2> shown(const std::array<HandState, 2>& states) const;
  Vec3 direction_of(const Movement& movement, const Vec3& otherwise) const;
  Oscillation oscillation_of(const Movement& movement, size_t phase) const;
  void circle_of(const Movement& movement, size_t phase, HandSegment& segment) const;

  const Signer& signer_;
  const Utterance& utterance_;
  const Unit& unit_;
  const Sign& sign_;
  const std::array<HandState, 2>& waiting_;
  std::vector<PlacedHand> dominant_, base_;
  bool mirrored_ = false;  ///< the left hand is the right hand's image
  bool has_base_ = false;  ///< the left hand has postures of its own
  SignPerformance result_;
};

Result<void> SignBuilder::check() const {
  if (sign_.dominant.empty())
    return fail(ErrorCode::kMalformed, "the sign " + sign_.gloss + " has no posture; add one to its entry");
  const int phases = static_cast<int>(sign_.dominant.size());
  for (const Movement& movement : sign_.movements)
    if (movement.from < 0 || movement.to < movement.from || movement.to >= phases)
      return fail(ErrorCode::kMalformed, "the sign " + sign_.gloss + " moves between postures that it does not have (" +
                                             std::to_string(movement.from) + " to " + std::to_string(movement.to) +
                                             " of " + std::to_string(phases) + ")");
  for (const auto* postures : {&sign_.dominant, &sign_.non_dominant})
    for (const Posture& posture : *postures)
      if (utterance_.handshapes.count(posture.handshape) == 0)
        return fail(ErrorCode::kNotFound,
                    "the sign " + sign_.gloss + " uses the unknown handshape \"" + posture.handshape + "\"");
  return {};
}

void SignBuilder::place_phases() {
  mirrored_ = sign_.handedness == Handedness::kSymmetric || sign_.handedness == Handedness::kAlternating;
  has_base_ = sign_.handedness == Handedness::kDominantBase && !sign_.non_dominant.empty();
  const size_t phases = sign_.dominant.size();
  for (size_t i = 0; i < phases && has_base_; ++i) {
    const Posture& posture = sign_.non_dominant[std::min(i, sign_.non_dominant.size() - 1)];
    // The base hand finds its own place; what it touches of the other hand comes to it.
    Posture alone = posture;
    if (alone.contact &&
        (is_on_other_hand(alone.location) || (alone.contact->target && is_on_other_hand(*alone.contact->target))))
      alone.contact.reset();
    base_.push_back(signer_.place(alone, shape(posture), Side::kLeft, {&waiting_[kRight], false}));
  }
  for (size_t i = 0; i < phases; ++i) {
    const Posture& posture = sign_.dominant[i];
    OtherHand other{has_base_ ? &base_[i].state : &waiting_[kLeft], mirrored_};
    dominant_.push_back(signer_.place(posture, shape(posture), Side::kRight, other));
  }
}

Vec3 SignBuilder::direction_of(const Movement& movement, const Vec3& otherwise) const {
  return movement.direction ? to_vector(*movement.direction) : otherwise;
}

Oscillation SignBuilder::oscillation_of(const Movement& movement, size_t phase) const {
  Oscillation oscillation;
  const HandState& state = dominant_[phase].state;
  const HandFrame& frame = signer_.hand_frame(Side::kRight);
  const Vec3 palm = state.wrist.rotation * frame.palm;
  const Vec3 fingers = state.wrist.rotation * frame.fingers;
  const Vec3 radial = state.wrist.rotation * frame.radial;
  oscillation.cycles = std::max(1, movement.repeats);
  const double shift = stroke::amplitude(movement.size) * 0.5;
  switch (movement.kind) {
    case MoveKind::kShake:
    case MoveKind::kSway:
    case MoveKind::kRub:
    case MoveKind::kZigzag:
    case MoveKind::kWavy:
    case MoveKind::kAlternate: {
      Vec3 axis(1, 0, 0);
      if (movement.plane == Plane::kUpDown || movement.plane == Plane::kVertical) axis = Vec3(0, 1, 0);
      if (movement.plane == Plane::kToFro || movement.plane == Plane::kSagittal) axis = Vec3(0, 0, 1);
      axis = direction_of(movement, axis);
      // On a surface the movement stays in it.
      if (dominant_[phase].touching) axis = across(dominant_[phase].normal, axis);
      oscillation.shift = axis * shift;
      break;
    }
    case MoveKind::kBounce:
      oscillation.shift = Vec3(0, 1, 0) * shift;
      break;
    case MoveKind::kTwist:
      oscillation.turn = fingers * stroke::turn(movement.size);
      break;
    case MoveKind::kNod:
      oscillation.turn = radial * stroke::turn(movement.size);
      break;
    case MoveKind::kWiggle:
      oscillation.wiggle = 0.35;
      oscillation.cycles = 1.5 * oscillation.cycles;
      break;
    case MoveKind::kBend:
    case MoveKind::kSqueeze:
    case MoveKind::kOpen:
    case MoveKind::kClose:
    case MoveKind::kFlick:
      oscillation.flex = 0.6;
      break;
    default:
      oscillation.shift = direction_of(movement, palm) * shift;
      break;
  }
  return oscillation;
}

void SignBuilder::circle_of(const Movement& movement, size_t phase, HandSegment& segment) const {
  const HandState& state = dominant_[phase].state;
  const Vec3 palm = state.wrist.rotation * signer_.hand_frame(Side::kRight).palm;
  Vec3 normal = dominant_[phase].touching ? dominant_[phase].normal : palm;
  if (movement.plane == Plane::kHorizontal) normal = Vec3(0, 1, 0);
  if (movement.plane == Plane::kFrontal) normal = Vec3(0, 0, 1);
  if (movement.plane == Plane::kSagittal || movement.plane == Plane::kVertical || movement.plane == Plane::kToFro)
    normal = Vec3(1, 0, 0);
  const double radius = stroke::amplitude(movement.size) * 0.8;
  const Vec3 u = across(normal, Vec3(0, 1, 0));
  const Vec3 v(normal.y * u.z - normal.z * u.y, normal.z * u.x - normal.x * u.z, normal.x * u.y - normal.y * u.x);
  segment.circle_u = u * radius;
  segment.circle_v = v * (movement.plane == Plane::kAnticlockwise ? -radius : radius);
  segment.turns = std::max(1, movement.repeats);
}

void SignBuilder::push(double seconds, bool hold, HandSegment dominant, size_t from, size_t to,
                       const Movement* movement) {
  Beat beat;
  beat.seconds = seconds;
  beat.hold = hold;
  beat.hands[kRight] = dominant;
  if (mirrored_) {
    beat.hands[kLeft] = mirror(dominant);
    if (sign_.handedness == Handedness::kAlternating) {
      HandSegment& image = beat.hands[kLeft];
      image.oscillation.phase += 0.5;
      // Half a cycle behind on a circle: it starts on the opposite side.
      image.circle_u = -image.circle_u;
      image.circle_v = -image.circle_v;
      // On a path: there while the other is here.
      if (from != to) {
        const size_t last = dominant_.size() - 1;
        image.from = mirrored(dominant_[last - from].state);
        image.to = mirrored(dominant_[last - to].state);
        image.bulge = -image.bulge;
      } else {
        image.from = mirrored(dominant_[dominant_.size() - 1 - from].state);
        image.to = image.from;
      }
    }
  } else if (has_base_) {
    HandSegment& left = beat.hands[kLeft];
    left.from = base_[from].state;
    left.to = base_[to].state;
    if (movement != nullptr && from == to && movement->hands != MovingHands::kDominant) {
      left.oscillation = dominant.oscillation;
      left.circle_u = dominant.circle_u;
      left.circle_v = dominant.circle_v;
      left.turns = dominant.turns;
      if (movement->hands == MovingHands::kAlternating) left.oscillation.phase += 0.5;
      if (movement->hands == MovingHands::kNonDominant) {
        beat.hands[kRight].oscillation = {};
        beat.hands[kRight].turns = 0;
      }
    }
  }
  beat.target = shown({beat.hands[kLeft].to, beat.hands[kRight].to});
  result_.beats.push_back(beat);
}

std::optional<HandTarget> SignBuilder::shown(const HandState& state, const std::vector<Posture>& postures,
                                             const std::vector<PlacedHand>& placed) const {
  for (size_t i = 0; i < placed.size(); ++i) {
    const Transform& wrist = placed[i].state.wrist;
    if (wrist.position != state.wrist.position || wrist.rotation != state.wrist.rotation) continue;
    const Posture& posture = postures[std::min(i, postures.size() - 1)];
    HandTarget target;
    target.fingers = to_vector(posture.fingers);
    target.palm = to_vector(posture.palm);
    target.reached = placed[i].state.wrist.rotation;
    target.angles = placed[i].state.angles;
    target.touches = placed[i].touching;
    target.stand_off = placed[i].stand_off;
    target.part = placed[i].part;
    target.location = placed[i].location;
    return target;
  }
  return std::nullopt;
}

std::array<std::optional<HandTarget>, 2> SignBuilder::shown(const std::array<HandState, 2>& states) const {
  std::array<std::optional<HandTarget>, 2> targets;
  targets[kRight] = shown(states[kRight], sign_.dominant, dominant_);
  if (mirrored_) {
    const auto image = shown(mirrored(states[kLeft]), sign_.dominant, dominant_);
    if (image) targets[kLeft] = mirror(*image);
  } else if (has_base_) {
    targets[kLeft] = shown(states[kLeft], sign_.non_dominant, base_);
  }
  return targets;
}

void SignBuilder::stroke_to(size_t from, size_t to, double factor) {
  HandSegment segment;
  segment.from = dominant_[from].state;
  segment.to = dominant_[to].state;
  double time = stroke::travel_seconds(segment.from, segment.to);
  if (has_base_) time = std::max(time, stroke::travel_seconds(base_[from].state, base_[to].state));
  push(std::max(0.16, time) * factor, false, segment, from, to, nullptr);
}

void SignBuilder::add_hold(size_t phase, double time) {
  HandSegment segment;
  segment.from = segment.to = dominant_[phase].state;
  push(time, true, segment, phase, phase, nullptr);
}

void SignBuilder::add_path(const Step& step) {
  const auto from = static_cast<size_t>(step.from), to = static_cast<size_t>(step.to);
  HandSegment segment;
  segment.from = dominant_[from].state;
  segment.to = dominant_[to].state;
  const Vec3 way = segment.to.wrist.position - segment.from.wrist.position;
  const double distance = std::sqrt(glm::dot(way, way));
  double time = std::max(0.16, stroke::travel_seconds(segment.from, segment.to) + 0.02);
  if (has_base_) time = std::max(time, stroke::travel_seconds(base_[from].state, base_[to].state));
  int repeats = 1;
  const Movement* lead = step.movements.front();
  for (const Movement* movement : step.movements) {
    const Vec3 axis = distance > 1e-6 ? way / distance : Vec3(0, 0, 1);
    switch (movement->kind) {
      case MoveKind::kArc: {
        // The arc bows up on its way out and across, and away from the body on its way up or down.
        const Vec3 bow = std::abs(axis.y) > 0.75 ? Vec3(0, 0, 1) : Vec3(0, 1, 0.35);
        segment.bulge += across(axis, bow) * std::max(0.3 * distance, stroke::amplitude(movement->size) * 0.6);
        break;
      }
      case MoveKind::kBounce:
        segment.bulge += across(axis, Vec3(0, 1, 0)) * std::max(0.02, 0.25 * distance);
        break;
      case MoveKind::kCircle:
      case MoveKind::kSpiral:
        circle_of(*movement, from, segment);
        time = std::max(time, stroke::kTurnOfCircle * segment.turns);
        break;
      case MoveKind::kShake:
      case MoveKind::kSway:
      case MoveKind::kZigzag:
      case MoveKind::kWavy:
      case MoveKind::kWiggle:
      case MoveKind::kAlternate: {
        Oscillation oscillation = oscillation_of(*movement, from);
        if (!movement->direction && movement->kind != MoveKind::kWiggle && movement->plane == Plane::kNone)
          oscillation.shift = across(axis, Vec3(1, 0, 0)) * (stroke::amplitude(movement->size) * 0.5);
        oscillation.cycles = std::max(oscillation.cycles, 2.0);
        segment.oscillation = oscillation;
        time = std::max(time, stroke::kCycle * oscillation.cycles);
        break;
      }
      default:
        repeats = std::max(repeats, movement->repeats);
        break;
    }
    time *= stroke::manner_factor(movement->manner);
  }
  for (int i = 0; i < repeats; ++i) {
    if (i > 0) stroke_to(to, from, 0.8);
    push(time, false, segment, from, to, lead);
  }
}

void SignBuilder::add_tap(const Movement& movement, size_t phase) {
  const PlacedHand& placed = dominant_[phase];
  // Towards the contact; in the air, where the palm faces or as the entry says.
  const Vec3 towards = placed.touching ? -placed.normal : direction_of(movement, -placed.normal);
  const double reach = stroke::amplitude(movement.size) * (placed.touching ? 0.8 : 1.0);
  HandSegment in;
  in.from = in.to = placed.state;
  in.from.wrist.position -= towards * reach;
  HandSegment out = in;
  std::swap(out.from, out.to);
  const int repeats = std::max(1, movement.repeats);
  const double time = (0.08 + 0.8 * reach) * stroke::manner_factor(movement.manner);
  if (result_.beats.empty()) {
    // The transition ends before the contact, so that the contact itself is a stroke.
    for (int i = 0; i < repeats; ++i) {
      if (i > 0) push(time, false, out, phase, phase, &movement);
      push(time, false, in, phase, phase, &movement);
    }
    return;
  }
  for (int i = 0; i < repeats; ++i) {
    push(time, false, out, phase, phase, &movement);
    push(time, false, in, phase, phase, &movement);
  }
}

void SignBuilder::add_local(const Step& step) {
  const auto phase = static_cast<size_t>(step.from);
  HandSegment segment;
  segment.from = segment.to = dominant_[phase].state;
  double time = 0;
  const Movement* lead = nullptr;
  for (const Movement* movement : step.movements) {
    const double factor = stroke::manner_factor(movement->manner);
    switch (movement->kind) {
      case MoveKind::kHold:
        break;
      case MoveKind::kTap:
      case MoveKind::kStrike:
      case MoveKind::kApproach:
      case MoveKind::kStraight:
      case MoveKind::kBrush:
        // One contact is enough inside a spelled word.
        if (!unit_.spelled) add_tap(*movement, phase);
        break;
      case MoveKind::kCircle:
      case MoveKind::kSpiral:
        circle_of(*movement, phase, segment);
        time = std::max(time, stroke::kTurnOfCircle * segment.turns * factor);
        lead = movement;
        break;
      default: {
        const Oscillation more = oscillation_of(*movement, phase);
        Oscillation& sum = segment.oscillation;
        sum.shift += more.shift;
        sum.turn += more.turn;
        sum.wiggle = std::max(sum.wiggle, more.wiggle);
        sum.flex = std::max(sum.flex, more.flex);
        sum.cycles = std::max(sum.cycles, more.cycles);
        time = std::max(time, (0.08 + stroke::kCycle * more.cycles) * factor);
        lead = movement;
        break;
      }
    }
  }
  if (lead != nullptr) push(time, false, segment, phase, phase, lead);
}

Result<SignPerformance> SignBuilder::build() {
  if (const auto checked = check(); !checked) return tl::unexpected(checked.error());
  place_phases();
  result_.active = {mirrored_ || has_base_, true};
  size_t current = 0;
  for (const Step& step : steps_of(sign_)) {
    const auto from = static_cast<size_t>(step.from);
    if (from != current) stroke_to(current, from, 1.0);
    current = static_cast<size_t>(step.to);
    if (step.from == step.to) {
      add_local(step);
    } else {
      add_path(step);
    }
  }
  while (current + 1 < dominant_.size()) {
    stroke_to(current, current + 1, 1.0);
    ++current;
  }
  add_hold(current, unit_.spelled ? stroke::kLetterHold : stroke::kSignHold);
  const Beat& first = result_.beats.front();
  result_.start = {first.hands[kLeft].from, first.hands[kRight].from};
  result_.start_target = shown(result_.start);
  if (dominant_.front().touching) result_.approach[kRight] = dominant_.front().normal;
  if (dominant_[current].touching) result_.leave[kRight] = dominant_[current].normal;
  if (mirrored_) {
    result_.approach[kLeft] = mirror(result_.approach[kRight]);
    result_.leave[kLeft] = mirror(result_.leave[kRight]);
  }
  return std::move(result_);
}

}  // namespace

Result<SignPerformance> perform(const Signer& signer, const Utterance& utterance, const Unit& unit,
                                const std::array<HandState, 2>& waiting) {
  return SignBuilder(signer, utterance, unit, waiting).build();
}

}  // namespace auslan
