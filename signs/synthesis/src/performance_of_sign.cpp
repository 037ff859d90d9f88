// SPDX-License-Identifier: Apache-2.0
#include "performance_of_sign.h"

#include "kinematics/elementary.h"
#include "phonology/vocabulary.h"
#include "stroke.h"
#include "turning.h"

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
  image.leave = mirror(segment.leave);
  image.approach = mirror(segment.approach);
  image.circle_u = mirror(segment.circle_u);
  image.circle_v = mirror(segment.circle_v);
  image.oscillation.shift = mirror(segment.oscillation.shift);
  image.oscillation.turn = mirror_turn(segment.oscillation.turn);
  image.oscillation.turn_ahead = mirror_turn(segment.oscillation.turn_ahead);
  image.oscillation.pivot = mirror(segment.oscillation.pivot);
  return image;
}

// What grows or shrinks is so much wider at one end.
constexpr double kGrown = 2.5;

/// The shorter axis of an ellipse over the longer one.
double flatness(Size flattening) {
  return flattening == Size::kLarge ? 0.25 : flattening == Size::kMedium ? 0.5 : 0.75;
}

/// How often a circle goes round: a part of a turn is made stroke by stroke, and never in place.
double turns_of(const Movement& movement) {
  const bool whole = movement.eighths % 8 == 0;
  if (movement.from == movement.to || whole)
    return std::max(1, movement.repeats) * std::max(1, (movement.eighths + 7) / 8);
  return movement.eighths / 8.0;
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

Touch touch(const PlacedHand& hand) {
  if (!hand.touching) return {};
  return {hand.normal, hand.part, is_on_other_hand(hand.location)};
}

Touch mirror(const Touch& touch) {
  return {mirror(touch.normal), mirror(touch.part), touch.on_other};
}

TouchedSurfaces mirror(const TouchedSurfaces& touched) {
  return {mirror(touched.from), mirror(touched.to)};
}

/// Where a straight way would leave or meet a surface at a slant, it does so along the normal instead. What slides over
/// a surface stays on it.
void stand_off(const TouchedSurfaces& touched, HandSegment& segment) {
  constexpr double kSteep = 0.7;  // cosine
  const Vec3 way = segment.to.wrist.position - segment.from.wrist.position;
  const double distance = std::sqrt(glm::dot(way, way));
  if (distance < 1e-3 || touched.slides()) return;
  if (touched.from.touches() && glm::dot(way, touched.from.normal) < kSteep * distance)
    segment.leave = lift_of(distance) * touched.from.normal;
  if (touched.to.touches() && -glm::dot(way, touched.to.normal) < kSteep * distance)
    segment.approach = lift_of(distance) * touched.to.normal;
}

/// Lays one sign out for its dominant hand, and for the other as the relation of the hands asks.
class SignBuilder {
 public:
  /// `shift`: by how much what is in the air gives way; none: as the first of its postures asks.
  SignBuilder(const Signer& signer, const Utterance& utterance, const Unit& unit,
              const std::array<HandState, 2>& waiting, const std::optional<Vec3>& shift = std::nullopt)
      : signer_(signer), utterance_(utterance), unit_(unit), sign_(*unit.sign), waiting_(waiting), shift_(shift) {}

  Result<SignPerformance> build();
  /// Of what was built: how many times over what is not seen the worst of its postures and strokes is.
  double trouble(const SignPerformance& built) const;
  /// Whether anything is made in the air.
  bool can_shift() const;

 private:
  const Handshape& shape(const Posture& posture) const { return utterance_.handshapes.find(posture.handshape)->second; }
  Result<void> check() const;
  void place_phases();
  void add_path(const Step& step);
  void add_local(const Step& step);
  void add_tap(const Movement& movement, size_t phase);
  void add_hold(size_t phase, double seconds);
  void quicken();
  void stroke_to(size_t from, size_t to, double factor);
  /// What the hands do between two phases without a movement; the left one only where it has postures of its own.
  std::array<HandSegment, 2> plain(size_t from, size_t to) const;
  /// Whether a movement moves this hand by itself; a mirrored left hand follows the right one.
  bool moves(const Movement& movement, size_t side) const;
  const PlacedHand& placed(size_t side, size_t phase) const { return side == kRight ? dominant_[phase] : base_[phase]; }
  /// Lays what is made once over a way or in place.
  void add_oscillation(const Movement& movement, size_t side, const Oscillation& more,
                       std::array<HandSegment, 2>& hands) const;
  /// Appends a beat from what the hands do and their relation.
  void push(double seconds, bool hold, const std::array<HandSegment, 2>& hands, size_t from, size_t to);
  /// What a hand of its own touches in two phases.
  TouchedSurfaces surfaces(size_t side, size_t from, size_t to) const;
  /// What a hand shows where a segment leaves it; nothing where that is not one of its postures.
  std::optional<HandTarget> shown(const HandState& state, const std::vector<Posture>& postures,
                                  const std::vector<PlacedHand>& placed) const;
  std::array<std::optional<HandTarget>, 2> shown(const std::array<HandState, 2>& states) const;
  Vec3 direction_of(const Movement& movement, const Vec3& otherwise) const;
  Oscillation oscillation_of(const Movement& movement, size_t side, size_t phase) const;
  void circle_of(const Movement& movement, size_t side, size_t phase, HandSegment& segment) const;

  const Signer& signer_;
  const Utterance& utterance_;
  const Unit& unit_;
  const Sign& sign_;
  const std::array<HandState, 2>& waiting_;
  std::optional<Vec3> shift_;
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
  mirrored_ = is_mirrored(sign_.handedness);
  has_base_ = sign_.handedness == Handedness::kDominantBase && !sign_.non_dominant.empty();
  const size_t phases = sign_.dominant.size();
  const auto of_base = [this](size_t i) -> const Posture& {
    return sign_.non_dominant[std::min(i, sign_.non_dominant.size() - 1)];
  };
  // What is there again is there as before. A first posture in the air may give way by itself, which no later one does.
  const auto before = [](size_t i, const auto& same) {
    size_t j = 0;
    while (j < i && !same(j))
      ++j;
    return j < i ? std::optional(j) : std::nullopt;
  };
  for (size_t i = 0; i < phases && has_base_; ++i) {
    const Posture& posture = of_base(i);
    const auto same = [&](size_t j) { return j > 0 && of_base(j) == posture; };
    if (const auto again = before(i, same)) {
      base_.push_back(base_[*again]);
      continue;
    }
    // The base hand finds its own place; what it touches of the other hand comes to it.
    Posture alone = posture;
    if (alone.contact &&
        (is_on_other_hand(alone.location) || (alone.contact->target && is_on_other_hand(*alone.contact->target))))
      alone.contact.reset();
    OtherHand nobody;
    nobody.shift = shift_;
    if (i > 0) nobody.shift = base_.front().shift;
    base_.push_back(signer_.place(alone, shape(posture), Side::kLeft, nobody));
  }
  for (size_t i = 0; i < phases; ++i) {
    const Posture& posture = sign_.dominant[i];
    const auto same = [&](size_t j) {
      return sign_.dominant[j] == posture &&
             (has_base_ ? j > 0 && of_base(j) == of_base(i) : j > 0 || posture.contact.has_value());
    };
    if (const auto again = before(i, same)) {
      dominant_.push_back(dominant_[*again]);
      continue;
    }
    OtherHand other{has_base_ ? &base_[i].state : &waiting_[kLeft], mirrored_, has_base_, shift_};
    // A hand that keeps a place beside the base gives way as the base does.
    if (i > 0 && !shift_) other.shift = dominant_.front().shift;
    dominant_.push_back(signer_.place(posture, shape(posture), Side::kRight, other));
  }
}

Vec3 SignBuilder::direction_of(const Movement& movement, const Vec3& otherwise) const {
  return movement.direction ? to_vector(*movement.direction) : otherwise;
}

Oscillation SignBuilder::oscillation_of(const Movement& movement, size_t side, size_t phase) const {
  Oscillation oscillation;
  const PlacedHand& hand = placed(side, phase);
  const HandFrame& frame = signer_.hand_frame(static_cast<Side>(side));
  const Quat& rotation = hand.state.wrist.rotation;
  const Vec3 palm = rotation * frame.palm;
  const Vec3 fingers = rotation * frame.fingers;
  const Vec3 radial = rotation * frame.radial;
  oscillation.cycles = std::max(1, movement.repeats);
  if (movement.growth == Growth::kIncreasing) oscillation.growth = kGrown;
  if (movement.growth == Growth::kDecreasing) oscillation.growth = 1.0 / kGrown;
  const double shift = stroke::amplitude(movement.size) * 0.5;
  // What touches stays where it touches.
  const Vec3 pivot = hand.touching ? hand.part : Vec3(0.0);
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
      if (hand.touching) axis = across(hand.normal, axis);
      oscillation.shift = axis * shift;
      break;
    }
    case MoveKind::kBounce:
      oscillation.shift = Vec3(0, 1, 0) * shift;
      break;
    case MoveKind::kTwist:
      oscillation.turn = fingers * stroke::turn(movement.size);
      oscillation.pivot = pivot;
      break;
    case MoveKind::kNod:
      oscillation.turn = radial * stroke::turn(movement.size);
      oscillation.pivot = pivot;
      break;
    case MoveKind::kSwing:
      // A wrist gives less to the sides than up and down.
      oscillation.turn = palm * (0.6 * stroke::turn(movement.size));
      oscillation.pivot = pivot;
      break;
    case MoveKind::kStir: {
      const double cone = 0.6 * stroke::turn(movement.size);
      // Clockwise as seen from the wrist along the fingers.
      oscillation.turn = palm * (movement.plane == Plane::kAnticlockwise ? cone : -cone);
      oscillation.turn_ahead = radial * cone;
      oscillation.pivot = pivot;
      break;
    }
    case MoveKind::kWiggle:
      oscillation.wiggle = hand.touching && glm::dot(palm, hand.normal) < -0.3 ? -0.35 : 0.35;
      oscillation.cycles = 1.5 * oscillation.cycles;
      if (!movement.digits.empty()) {
        oscillation.wiggling = 0;
        for (const char digit : movement.digits)
          if (digit >= '1' && digit <= '5') oscillation.wiggling |= 1U << static_cast<unsigned>(digit - '1');
      }
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

void SignBuilder::circle_of(const Movement& movement, size_t side, size_t phase, HandSegment& segment) const {
  const PlacedHand& hand = placed(side, phase);
  const Vec3 palm = hand.state.wrist.rotation * signer_.hand_frame(static_cast<Side>(side)).palm;
  Vec3 normal = hand.touching ? hand.normal : palm;
  if (movement.plane == Plane::kHorizontal) normal = Vec3(0, 1, 0);
  if (movement.plane == Plane::kFrontal) normal = Vec3(0, 0, 1);
  if (movement.plane == Plane::kSagittal || movement.plane == Plane::kVertical || movement.plane == Plane::kToFro)
    normal = Vec3(1, 0, 0);
  normal = direction_of(movement, normal);
  const double radius = stroke::amplitude(movement.size) * 0.8;
  const double sense = movement.plane == Plane::kAnticlockwise ? -radius : radius;
  const Vec3 u = across(normal, movement.start ? to_vector(*movement.start) : Vec3(0, 1, 0));
  segment.circle_u = u * radius;
  segment.circle_v = glm::cross(normal, u) * sense;
  if (movement.ellipse) {
    // The same angle on the ellipse: along its longer axis as wide as the circle.
    const double narrow = flatness(movement.flattening);
    const Vec3 longer = across(normal, to_vector(*movement.ellipse));
    const Vec3 shorter = glm::cross(normal, longer);
    const auto flatten = [&](Vec3& v) { v = longer * glm::dot(v, longer) + shorter * (narrow * glm::dot(v, shorter)); };
    flatten(segment.circle_u);
    flatten(segment.circle_v);
  }
  if (movement.growth == Growth::kIncreasing) {
    segment.circle_u *= 1.0 / kGrown;
    segment.circle_v *= 1.0 / kGrown;
    segment.circle_growth = kGrown;
  } else if (movement.growth == Growth::kDecreasing || movement.kind == MoveKind::kSpiral) {
    segment.circle_growth = 1.0 / kGrown;
  }
  segment.turns = turns_of(movement);
}

std::array<HandSegment, 2> SignBuilder::plain(size_t from, size_t to) const {
  std::array<HandSegment, 2> hands;
  hands[kRight].from = dominant_[from].state;
  hands[kRight].to = dominant_[to].state;
  if (has_base_) {
    hands[kLeft].from = base_[from].state;
    hands[kLeft].to = base_[to].state;
  }
  return hands;
}

bool SignBuilder::moves(const Movement& movement, size_t side) const {
  if (!has_base_) return side == kRight;
  return movement.hands != (side == kRight ? MovingHands::kNonDominant : MovingHands::kDominant);
}

TouchedSurfaces SignBuilder::surfaces(size_t side, size_t from, size_t to) const {
  return {touch(placed(side, from)), touch(placed(side, to))};
}

void SignBuilder::push(double seconds, bool hold, const std::array<HandSegment, 2>& hands, size_t from, size_t to) {
  Beat beat;
  beat.seconds = seconds;
  beat.hold = hold;
  for (const size_t side : {kLeft, kRight}) {
    if (side == kLeft && !has_base_) continue;
    beat.hands[side] = hands[side];
    beat.surfaces[side] = surfaces(side, from, to);
    if (from != to) stand_off(beat.surfaces[side], beat.hands[side]);
  }
  if (mirrored_) {
    beat.hands[kLeft] = mirror(beat.hands[kRight]);
    beat.surfaces[kLeft] = mirror(beat.surfaces[kRight]);
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
        beat.surfaces[kLeft] = mirror(surfaces(kRight, last - from, last - to));
        image.leave = image.approach = Vec3(0.0);
        stand_off(beat.surfaces[kLeft], image);
      } else {
        image.from = mirrored(dominant_[dominant_.size() - 1 - from].state);
        image.to = image.from;
      }
    }
  }
  beat.target = shown({beat.hands[kLeft].to, beat.hands[kRight].to});
  // Where a circle does not lead back to its beginning, the way under it makes up for that: the beat ends in its phase.
  for (HandSegment& segment : beat.hands) {
    if (segment.turns == std::floor(segment.turns) && segment.circle_growth == 1) continue;
    double sn = 0, cs = 1;
    sine_cosine(2.0 * kPi * segment.turns, sn, cs);
    const double size = segment.circle_growth;
    segment.to.wrist.position -= segment.circle_u * (size * cs - 1.0) + segment.circle_v * (size * sn);
  }
  result_.beats.push_back(beat);
}

std::optional<HandTarget> SignBuilder::shown(const HandState& state, const std::vector<Posture>& postures,
                                             const std::vector<PlacedHand>& placed) const {
  for (size_t i = 0; i < placed.size(); ++i) {
    // A hand may change its shape where it is.
    const HandState& there = placed[i].state;
    if (there.wrist != state.wrist || there.angles != state.angles) continue;
    const Posture& posture = postures[std::min(i, postures.size() - 1)];
    HandTarget target;
    target.fingers = to_vector(posture.fingers);
    target.palm = to_vector(posture.palm);
    target.reached = there.wrist.rotation;
    target.angles = there.angles;
    target.touches = placed[i].touching;
    target.stand_off = placed[i].stand_off;
    target.part = placed[i].part;
    target.location = placed[i].location;
    target.trouble = placed[i].trouble;
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
  const std::array<HandSegment, 2> hands = plain(from, to);
  double time = stroke::travel_seconds(hands[kRight].from, hands[kRight].to);
  if (has_base_) time = std::max(time, stroke::travel_seconds(hands[kLeft].from, hands[kLeft].to));
  push(std::max(0.16, time) * factor, false, hands, from, to);
}

void SignBuilder::add_hold(size_t phase, double time) {
  push(time, true, plain(phase, phase), phase, phase);
}

void SignBuilder::add_oscillation(const Movement& movement, size_t side, const Oscillation& more,
                                  std::array<HandSegment, 2>& hands) const {
  Oscillation& sum = hands[side].oscillation;
  sum.shift += more.shift;
  sum.turn += more.turn;
  sum.turn_ahead += more.turn_ahead;
  if (more.turn != Vec3(0.0)) sum.pivot = more.pivot;
  if (more.wiggle != 0) {
    sum.wiggle = more.wiggle;
    sum.wiggling = more.wiggling;
  }
  sum.flex = std::max(sum.flex, more.flex);
  sum.cycles = std::max(sum.cycles, more.cycles);
  sum.growth = more.growth;
  if (side == kLeft && movement.hands == MovingHands::kAlternating) sum.phase = 0.5;
}

void SignBuilder::add_path(const Step& step) {
  const auto from = static_cast<size_t>(step.from), to = static_cast<size_t>(step.to);
  std::array<HandSegment, 2> hands = plain(from, to);
  double time = std::max(0.16, stroke::travel_seconds(hands[kRight].from, hands[kRight].to) + 0.02);
  if (has_base_) time = std::max(time, stroke::travel_seconds(hands[kLeft].from, hands[kLeft].to));
  int repeats = 1;
  double rest = 0, factor = 1;
  for (const Movement* movement : step.movements) {
    for (const size_t side : {kRight, kLeft}) {
      if (!moves(*movement, side)) continue;
      HandSegment& segment = hands[side];
      const Vec3 way = segment.to.wrist.position - segment.from.wrist.position;
      const double distance = std::sqrt(glm::dot(way, way));
      const Vec3 axis = distance > 1e-6 ? way / distance : Vec3(0, 0, 1);
      switch (movement->kind) {
        case MoveKind::kArc: {
          // Where nothing else is written an arc bows up on its way out and across, and away from the body on its way
          // up or down.
          Vec3 bow = std::abs(axis.y) > 0.75 ? Vec3(0, 0, 1) : Vec3(0, 1, 0.35);
          if (movement->bow) bow = to_vector(*movement->bow);
          segment.bulge += across(axis, bow) * std::max(0.3 * distance, stroke::amplitude(movement->size) * 0.6);
          break;
        }
        case MoveKind::kBounce:
          segment.bulge += across(axis, Vec3(0, 1, 0)) * std::max(0.02, 0.25 * distance);
          break;
        case MoveKind::kCircle:
        case MoveKind::kSpiral:
          circle_of(*movement, side, from, segment);
          time = std::max(time, stroke::kTurnOfCircle * segment.turns);
          if (movement->eighths % 8 != 0) repeats = std::max(repeats, movement->repeats);
          break;
        case MoveKind::kShake:
        case MoveKind::kSway:
        case MoveKind::kZigzag:
        case MoveKind::kWavy:
        case MoveKind::kTwist:
        case MoveKind::kNod:
        case MoveKind::kSwing:
        case MoveKind::kStir:
        case MoveKind::kWiggle:
        case MoveKind::kAlternate: {
          // A turn that is all that happens between two phases is the way between them.
          const bool turns = movement->kind == MoveKind::kTwist || movement->kind == MoveKind::kNod;
          if (turns && step.movements.size() == 1) {
            repeats = std::max(repeats, movement->repeats);
            break;
          }
          Oscillation more = oscillation_of(*movement, side, from);
          const bool waves = more.shift != Vec3(0.0);
          const bool path = movement->kind == MoveKind::kZigzag || movement->kind == MoveKind::kWavy;
          if (waves && (path || !movement->direction) && movement->plane == Plane::kNone)
            more.shift = across(axis, movement->bow ? to_vector(*movement->bow) : Vec3(1, 0, 0)) *
                         (stroke::amplitude(movement->size) * 0.5);
          if (waves || more.wiggle != 0) more.cycles = std::max(more.cycles, 2.0);
          add_oscillation(*movement, side, more, hands);
          time = std::max(time, stroke::kCycle * more.cycles);
          break;
        }
        default:
          repeats = std::max(repeats, movement->repeats);
          break;
      }
    }
    // Of what happens at once the most marked manner counts for all.
    const double own = stroke::manner_factor(movement->manner) / movement->pace;
    if (std::max(own, 1.0 / own) > std::max(factor, 1.0 / factor)) factor = own;
    if (movement->manner == Manner::kRest) rest = stroke::kRestHold;
  }
  time *= factor;
  for (int i = 0; i < repeats; ++i) {
    if (i > 0) stroke_to(to, from, 0.8);
    push(time, false, hands, from, to);
  }
  if (rest > 0) add_hold(to, rest);
}

void SignBuilder::add_tap(const Movement& movement, size_t phase) {
  std::array<HandSegment, 2> in = plain(phase, phase);
  double reach = 0;
  for (const size_t side : {kRight, kLeft}) {
    if (!moves(movement, side)) continue;
    const PlacedHand& hand = placed(side, phase);
    // Towards the contact; in the air, where the palm faces or as the entry says.
    const Vec3 towards = hand.touching ? -hand.normal : direction_of(movement, -hand.normal);
    const double back = stroke::amplitude(movement.size) * (hand.touching ? 0.8 : 1.0);
    in[side].from.wrist.position -= towards * back;
    reach = std::max(reach, back);
  }
  std::array<HandSegment, 2> out = in;
  for (HandSegment& segment : out)
    std::swap(segment.from, segment.to);
  const int repeats = std::max(1, movement.repeats);
  const double time = (0.08 + 0.8 * reach) * stroke::manner_factor(movement.manner) / movement.pace;
  // At the beginning the transition ends before the contact, so that the contact itself is a stroke.
  const bool first = result_.beats.empty();
  if (has_base_ && movement.hands == MovingHands::kAlternating) {
    // The other hand goes out while this one comes in.
    const std::array<HandSegment, 2> still = plain(phase, phase);
    const int begin = first ? 1 : 0, end = 2 * repeats;
    for (int i = begin; i <= end; ++i) {
      std::array<HandSegment, 2> hands;
      hands[kRight] = i == end ? still[kRight] : (i % 2 == 0 ? out : in)[kRight];
      hands[kLeft] = i == begin && i % 2 == 0 ? still[kLeft] : (i % 2 == 0 ? in : out)[kLeft];
      push(time, false, hands, phase, phase);
    }
    return;
  }
  for (int i = 0; i < repeats; ++i) {
    if (i > 0 || !first) push(time, false, out, phase, phase);
    push(time, false, in, phase, phase);
  }
}

void SignBuilder::add_local(const Step& step) {
  const auto phase = static_cast<size_t>(step.from);
  std::array<HandSegment, 2> hands = plain(phase, phase);
  double time = 0, rest = 0;
  bool moving = false;
  for (const Movement* movement : step.movements) {
    const double factor = stroke::manner_factor(movement->manner) / movement->pace;
    if (movement->manner == Manner::kRest) rest = stroke::kRestHold;
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
        for (const size_t side : {kRight, kLeft}) {
          if (!moves(*movement, side)) continue;
          HandSegment& segment = hands[side];
          circle_of(*movement, side, phase, segment);
          if (side == kLeft && movement->hands == MovingHands::kAlternating) {
            segment.circle_u = -segment.circle_u;
            segment.circle_v = -segment.circle_v;
          }
          time = std::max(time, stroke::kTurnOfCircle * segment.turns * factor);
        }
        moving = true;
        break;
      default:
        for (const size_t side : {kRight, kLeft}) {
          if (!moves(*movement, side)) continue;
          const Oscillation more = oscillation_of(*movement, side, phase);
          add_oscillation(*movement, side, more, hands);
          time = std::max(time, (0.08 + stroke::kCycle * more.cycles) * factor);
        }
        moving = true;
        break;
    }
  }
  if (moving) push(time, false, hands, phase, phase);
  if (rest > 0) add_hold(phase, rest);
}

/// Brings a long movement nearer to the time of one stroke.
void SignBuilder::quicken() {
  double moving = 0;
  for (const Beat& beat : result_.beats)
    if (!beat.hold) moving += beat.seconds;
  if (moving <= stroke::kLongStroke) return;
  const double factor = (stroke::kLongStroke + stroke::kShareOfRest * (moving - stroke::kLongStroke)) / moving;
  for (Beat& beat : result_.beats)
    if (!beat.hold) beat.seconds *= factor;
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
  quicken();
  add_hold(current, unit_.spelled ? stroke::kLetterHold : stroke::kSignHold);
  const Beat& first = result_.beats.front();
  result_.start = {first.hands[kLeft].from, first.hands[kRight].from};
  result_.start_target = shown(result_.start);
  result_.approach[kRight] = touch(dominant_.front());
  result_.leave[kRight] = touch(dominant_[current]);
  if (mirrored_) {
    result_.approach[kLeft] = mirror(result_.approach[kRight]);
    result_.leave[kLeft] = mirror(result_.leave[kRight]);
  }
  return std::move(result_);
}

bool SignBuilder::can_shift() const {
  const auto in_air = [](const PlacedHand& hand) { return !hand.touching; };
  return std::ranges::any_of(dominant_, in_air) || std::ranges::any_of(base_, in_air);
}

double SignBuilder::trouble(const SignPerformance& built) const {
  constexpr double kSeenDepth = 0.001;  // metres, beyond what a way tolerates
  double worst = 0.0;
  for (const auto* postures : {&dominant_, &base_})
    for (const PlacedHand& posture : *postures)
      worst = std::max(worst, posture.trouble);
  for (const Beat& beat : built.beats) {
    if (beat.hold) continue;
    std::array<HandSegment, 2> segments = beat.hands;
    for (const size_t side : {kLeft, kRight})
      if (built.active[side])
        worst = std::max(worst, clear_stroke(signer_, beat, built.active, side, segments) / kSeenDepth);
  }
  return worst;
}

}  // namespace

double clear_stroke(const Signer& signer, const Beat& beat, const std::array<bool, 2>& active, size_t side,
                    std::array<HandSegment, 2>& segments) {
  const auto hand = static_cast<Side>(side);
  segments[side].turn_middle = turn_through_joints(signer, hand, segments[side]);
  HandSegment left = segments[kLeft];
  return keep_clear(signer, hand, segments[side], beat.surfaces[side],
                    {side == kRight && active[kLeft] ? &left : nullptr});
}

Result<SignPerformance> perform(const Signer& signer, const Utterance& utterance, const Unit& unit,
                                const std::array<HandState, 2>& waiting) {
  SignBuilder builder(signer, utterance, unit, waiting);
  auto best = builder.build();
  if (!best || !signer.seeks_longer() || !builder.can_shift()) return best;
  // Other places for what is made in the air.
  constexpr double kNear = 0.03, kFar = 0.05;  // metres
  // More trouble than this is no matter of some centimetres.
  constexpr double kHopeless = 30.0;
  static constexpr Vec3 kShifts[] = {{0, 0, kNear}, {0, 0, -kNear}, {0, kNear, 0},   {0, -kNear, 0},
                                     {kNear, 0, 0}, {-kNear, 0, 0}, {0, 0, kFar},    {0, kFar, 0},
                                     {0, -kFar, 0}, {kFar, 0, 0},   {0, -kFar, kFar}};
  double least = builder.trouble(*best);
  for (const Vec3& shift : kShifts) {
    if (least <= 1.0 || least > kHopeless) break;
    SignBuilder other(signer, utterance, unit, waiting, shift);
    auto found = other.build();
    if (!found) break;
    const double trouble = other.trouble(*found);
    if (trouble >= least) continue;
    least = trouble;
    best = std::move(found);
  }
  return best;
}

}  // namespace auslan
