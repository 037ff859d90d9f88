// SPDX-License-Identifier: Apache-2.0
#include "direction.h"
#include "kinematics/elementary.h"
#include "layout.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace auslan::notation {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The radius of a circle as it is performed, metres: what a part of a turn leads to depends on it.
double radius_of(const std::string& size) {
  return size == "small" ? 0.024 : size == "big" ? 0.072 : 0.044;
}

/// The longer axis of an ellipse on its face.
Vec3 ellipse_axis(const std::string& letters) {
  if (letters == "h") return {1, 0, 0};
  if (letters == "v") return {0, 1, 0};
  return letters == "ur" ? Vec3(-1, 1, 0) : Vec3(1, 1, 0);
}

Growth growth_of(const std::string& word) {
  return word == "increasing" ? Growth::kIncreasing : word == "decreasing" ? Growth::kDecreasing : Growth::kNone;
}

/// Eighths of a turn from one place of the clock to another, the way that the circle goes; 0 for the same.
int eighths_between(const std::string& start, const std::string& end, bool towards_signer) {
  static constexpr std::string_view kClock[] = {"u", "ur", "r", "dr", "d", "dl", "l", "ul"};
  const auto at = [](const std::string& letters) {
    return static_cast<int>(std::ranges::find(kClock, std::string_view(letters)) - std::begin(kClock));
  };
  const int way = at(end) - at(start);
  return ((towards_signer ? -way : way) % 8 + 8) % 8;
}

bool successive(const WrittenPosture& posture) {
  const auto is = [](const WrittenHand& hand) { return hand.shape && !hand.shape->successive.empty(); };
  return is(posture.shared) || is(posture.split[0]) || is(posture.split[1]);
}

bool is_clock(const std::string& letters) {
  return letters == "u" || letters == "ur" || letters == "r" || letters == "dr" || letters == "d" || letters == "dl" ||
         letters == "l" || letters == "ul";
}

/// How far a straight movement goes, metres.
double travel(const std::string& size) {
  return size == "small" ? 0.06 : size == "big" ? 0.20 : 0.12;
}

Size size_of(const std::string& size) {
  return size == "small" ? Size::kSmall : size == "big" ? Size::kLarge : Size::kMedium;
}
Vec3 flipped(const Vec3& v, const WrittenPart& part) {
  return {part.mirror_lr ? -v.x : v.x, part.mirror_ud ? -v.y : v.y, part.mirror_oi ? -v.z : v.z};
}
}  // namespace

size_t Layout::append(const Phase& phase) {
  phases_.push_back(phase);
  return phases_.size() - 1;
}

void Layout::shift(Phase& phase, size_t which, const Vec3& by, bool brushing) {
  Hand& hand = phase.hands[which];
  hand.spot.offset += by;
  if (hand.spot.contact && *hand.spot.contact != ContactKind::kNear && !brushing)
    hand.spot.contact = ContactKind::kNear;
  if (brushing && hand.spot.contact) hand.spot.contact = ContactKind::kBrush;
}

void Layout::make_directed(const StrokeItem& item, const Stroke& stroke, bool other_moves, MovingHands moving,
                           Phase& next, std::vector<Movement>& made) {
  const WrittenMotion& motion = *item.motion;
  const auto way = direction(motion.direction, motion.second_direction, motion.mark, "direction");
  if (!way) return;
  double length = travel(motion.size);
  if (!motion.second_size.empty()) length = 0.5 * (length + travel(motion.second_size));
  const Vec3 by = *way * (length * stroke.scale);
  if (item.hands.dominant) shift(next, 0, by, motion.brushing);
  if (other_moves) shift(next, 1, item.hands.dominant ? flipped(by, *part_) : by, motion.brushing);
  Movement path;
  path.hands = moving;
  path.kind = MoveKind::kStraight;
  path.direction = to_direction(*way);
  path.size = size_of(motion.size);
  path.pace = motion.pace;
  if (!motion.curve.empty()) {
    path.kind = MoveKind::kArc;
    path.size = size_of(motion.curve_size);
    if (const auto bow = direction(motion.curve, "", motion.mark, "curve"))
      path.bow = to_direction(carried(*bow, *way));
  }
  if (!motion.waviness.empty()) {
    Movement wave;
    wave.hands = moving;
    wave.kind = motion.waviness == "wavy" ? MoveKind::kWavy : MoveKind::kZigzag;
    wave.size = motion.waviness_size.empty() ? Size::kSmall : size_of(motion.waviness_size);
    wave.growth = growth_of(motion.waviness_growth.empty() ? motion.growth : motion.waviness_growth);
    wave.repeats = 3;
    wave.pace = motion.pace;
    // An arc that is waved says by its bow where its middle is; the waves lie across it.
    if (path.bow) made.push_back(path);
    made.push_back(wave);
  } else {
    if (!motion.growth.empty())
      findings_.warning(motion.mark, "a path that is " + motion.growth + " is signed at its usual width");
    made.push_back(path);
  }
  if (!motion.ellipse.empty())
    findings_.left_out(motion.mark, "the ellipse " + in_quotes(motion.ellipse) + " says nothing on a straight path");
}

void Layout::make_circle(const StrokeItem& item, const Stroke& stroke, bool other_moves, MovingHands moving,
                         Phase& next, std::vector<Movement>& made, bool& changes) {
  const WrittenMotion& motion = *item.motion;
  const auto axis = direction(motion.direction, motion.second_direction, motion.mark, "axis");
  if (!axis) return;
  Movement circle;
  circle.hands = moving;
  circle.kind = MoveKind::kCircle;
  circle.direction = to_direction(*axis);
  circle.size = size_of(motion.size);
  circle.growth = growth_of(motion.growth);
  circle.pace = motion.pace;
  if (!motion.second_size.empty()) findings_.note(motion.mark, "a size between two is signed as the first of them");
  if (!motion.ellipse.empty()) {
    circle.ellipse = to_direction(carried(ellipse_axis(motion.ellipse), *axis));
    circle.flattening = motion.ellipse_size.empty() ? Size::kMedium : size_of(motion.ellipse_size);
  }
  for (const std::string* clock : {&motion.clock_start, &motion.clock_end})
    if (!clock->empty() && !is_clock(*clock))
      findings_.left_out(motion.mark, "the place " + in_quotes(*clock) +
                                          " on a circle is not known (expected u, ur, r, dr, d, dl, l or ul)");
  const bool starts = is_clock(motion.clock_start), ends = is_clock(motion.clock_end);
  const std::string start = starts ? motion.clock_start : "u";
  const Vec3 first = carried(*vector_of_letters(start), *axis);
  if (starts) circle.start = to_direction(first);
  const int part = ends ? eighths_between(start, motion.clock_end, axis->z < -1e-9) : 0;
  circle.eighths = 8 * std::clamp(motion.extra_turns, 0, 6) + (part == 0 ? 8 : part);
  if (part != 0) {
    // It ends elsewhere than it began.
    const double angle = part * kPi / 4;
    double sine_of = 0, cosine_of = 1;
    sine_cosine(angle, sine_of, cosine_of);
    const double size = radius_of(motion.size) * stroke.scale;
    const Vec3 by = (first * (cosine_of - 1.0) + glm::cross(*axis, first) * sine_of) * size;
    if (item.hands.dominant) shift(next, 0, by, motion.brushing);
    if (other_moves) shift(next, 1, item.hands.dominant ? flipped(by, *part_) : by, motion.brushing);
    changes = true;
  }
  made.push_back(circle);
  if (!motion.waviness.empty()) {
    Movement wave;
    wave.hands = moving;
    wave.kind = motion.waviness == "wavy" ? MoveKind::kWavy : MoveKind::kZigzag;
    wave.size = motion.waviness_size.empty() ? Size::kSmall : size_of(motion.waviness_size);
    wave.direction = to_direction(*axis);
    wave.repeats = 3;
    made.push_back(wave);
  }
}

void Layout::make_wrist(const WrittenMotion& motion, MovingHands moving, std::vector<Movement>& made) {
  Movement turn;
  turn.hands = moving;
  turn.size = size_of(motion.size);
  turn.repeats = 2;
  turn.pace = motion.pace;
  if (motion.wrist == "nodding") {
    turn.kind = MoveKind::kNod;
  } else if (motion.wrist == "twisting") {
    turn.kind = MoveKind::kTwist;
  } else if (motion.wrist == "swinging") {
    turn.kind = MoveKind::kSwing;
  } else if (motion.wrist == "stircw" || motion.wrist == "stirccw") {
    turn.kind = MoveKind::kStir;
    turn.plane = motion.wrist == "stircw" ? Plane::kClockwise : Plane::kAnticlockwise;
  } else {
    findings_.left_out(motion.mark, "the wrist movement " + in_quotes(motion.wrist) +
                                        " is not known (expected nodding, swinging, twisting, stircw or stirccw)");
    return;
  }
  made.push_back(turn);
}

void Layout::part_hands() {
  const auto flip = [](std::optional<Direction>& direction, const WrittenPart& part, bool axial) {
    if (!direction) return;
    const Vec3 v = flipped(to_vector(*direction), part);
    // An axis is mirrored together with its sense.
    const bool odd = (part.mirror_lr != part.mirror_ud) != part.mirror_oi;
    direction = to_direction(axial && odd ? -v : v);
  };
  std::vector<Movement> all;
  for (size_t i = 0; i < movements_.size(); ++i) {
    const WrittenPart* part = part_of_movement_[i];
    Movement movement = movements_[i];
    Movement other = movement;
    other.hands = MovingHands::kNonDominant;
    // The way of each hand is in its postures.
    if (part != nullptr && movement.hands == MovingHands::kBoth && movement.kind != MoveKind::kStraight) {
      flip(other.direction, *part, movement.kind == MoveKind::kCircle);
      for (auto* direction : {&other.bow, &other.start, &other.ellipse})
        flip(*direction, *part, false);
      Movement same = other;
      same.hands = MovingHands::kBoth;
      if (!(same == movement)) {
        movement.hands = MovingHands::kDominant;
        all.push_back(movement);
        all.push_back(other);
        continue;
      }
    }
    all.push_back(movement);
  }
  movements_ = std::move(all);
}

void Layout::make(const Stroke& stroke) {
  if (phases_.size() >= kMaxPhases) return;
  if (stroke.restart_from >= 0 && static_cast<size_t>(stroke.restart_from) < stroke_starts_.size()) {
    const size_t start = stroke_starts_[static_cast<size_t>(stroke.restart_from)];
    std::optional<Vec3> farther;
    if (!stroke.shift.empty())
      if (const auto way = direction(stroke.shift, "", stroke.mark, "shift of a repetition"))
        farther = *way * (travel(stroke.shift_size) * stroke.shifts);
    if (start + 1 != phases_.size() || farther) {
      now_ = phases_[start];
      if (farther) {
        shift(now_, 0, *farther, false);
        if (now_.hands[1].present && part_->both_hands) shift(now_, 1, flipped(*farther, *part_), false);
      }
      const size_t index = append(now_);
      Movement back;
      back.kind = MoveKind::kStraight;
      back.hands = now_.hands[1].present ? MovingHands::kBoth : MovingHands::kDominant;
      back.from = static_cast<int>(index) - 1;
      back.to = static_cast<int>(index);
      movements_.push_back(back);
    }
  }
  stroke_starts_.push_back(phases_.size() - 1);
  Phase next = now_;
  bool changes = false;
  std::vector<Movement> made;
  const Manner manner = stroke.halt    ? Manner::kSharp
                        : stroke.tense ? Manner::kTense
                        : stroke.rest  ? Manner::kRest
                        : stroke.fast  ? Manner::kFast
                        : stroke.slow  ? Manner::kSlow
                                       : Manner::kPlain;
  // What the manner has no room for is carried by the pace.
  double pace = written_.pace;
  if (manner != Manner::kFast && stroke.fast && !stroke.halt) pace *= 1.4;
  if (manner != Manner::kSlow && stroke.slow) pace *= 0.6;
  std::array<bool, 2> moved = {false, false};
  for (const StrokeItem& item : stroke.items) {
    const bool other_moves = item.hands.other && now_.hands[1].present && (part_->both_hands || !item.hands.dominant);
    if (item.target != nullptr) {
      changes = changes || !item.target->empty();
      apply(*item.target, item.hands, next);
      if (successive(*item.target)) {
        Movement play;
        play.kind = MoveKind::kWiggle;
        play.plane = Plane::kFingers;
        play.hands = item.hands.dominant && other_moves ? MovingHands::kBoth
                     : item.hands.dominant              ? MovingHands::kDominant
                                                        : MovingHands::kNonDominant;
        made.push_back(play);
        findings_.warning(item.target->mark, "fingers that change one after another are signed by moving fingers");
      }
      moved[0] = moved[0] || item.hands.dominant;
      moved[1] = moved[1] || other_moves;
      continue;
    }
    const WrittenMotion& motion = *item.motion;
    const auto mark_moved = [&] {
      moved[0] = moved[0] || item.hands.dominant;
      moved[1] = moved[1] || other_moves;
    };
    MovingHands moving = MovingHands::kDominant;
    if (item.hands.dominant && other_moves)
      moving = stroke.alternating ? MovingHands::kAlternating : MovingHands::kBoth;
    if (!item.hands.dominant) moving = MovingHands::kNonDominant;
    switch (motion.kind) {
      case WrittenMotion::Kind::kDirected:
        make_directed(item, stroke, other_moves, moving, next, made);
        changes = true;
        mark_moved();
        break;
      case WrittenMotion::Kind::kCircular:
        make_circle(item, stroke, other_moves, moving, next, made, changes);
        mark_moved();
        break;
      case WrittenMotion::Kind::kWrist:
        make_wrist(motion, moving, made);
        mark_moved();
        break;
      case WrittenMotion::Kind::kFingerplay: {
        Movement play;
        play.kind = MoveKind::kWiggle;
        play.repeats = 2;
        play.hands = moving;
        play.digits = motion.digits;
        play.pace = motion.pace;
        play.plane = Plane::kFingers;
        made.push_back(play);
        mark_moved();
        break;
      }
      default:
        break;
    }
  }
  if (now_.hands[1].present && part_->both_hands && moved[0] != moved[1]) hands_differ_ = true;
  if (stroke.alternating && part_->both_hands) alternating_ = true;
  if (!changes && made.empty()) return;
  size_t from = phases_.size() - 1, to = from;
  if (changes) {
    to = append(next);
    if (std::none_of(made.begin(), made.end(), [](const Movement& m) {
          return m.kind == MoveKind::kStraight || m.kind == MoveKind::kArc || m.kind == MoveKind::kWavy ||
                 m.kind == MoveKind::kZigzag || m.eighths % 8 != 0;
        })) {
      Movement path;
      path.kind = MoveKind::kStraight;
      path.hands = moved[0] && moved[1] ? MovingHands::kBoth
                   : moved[1]           ? MovingHands::kNonDominant
                                        : MovingHands::kDominant;
      made.insert(made.begin(), path);
    }
  } else if (std::any_of(movements_.begin(), movements_.end(),
                         [from](const Movement& m) { return static_cast<size_t>(m.from) == from && m.from == m.to; })) {
    // Movements that share a phase happen at once; the later one gets a phase of its own.
    to = append(next);
    Movement link;
    link.kind = MoveKind::kHold;
    link.hands = now_.hands[1].present ? MovingHands::kBoth : MovingHands::kDominant;
    link.from = static_cast<int>(from);
    link.to = static_cast<int>(to);
    movements_.push_back(link);
    from = to;
  }
  for (Movement& movement : made) {
    movement.from = static_cast<int>(from);
    movement.to = static_cast<int>(to);
    movement.manner = manner;
    movement.pace = std::clamp(movement.pace * pace, 0.1, 10.0);
    const bool shakes = movement.kind == MoveKind::kWavy || movement.kind == MoveKind::kZigzag;
    movement.repeats = std::min(24, shakes ? movement.repeats : movement.repeats * stroke.repeats);
    movements_.push_back(movement);
  }
  now_ = next;
}

void Layout::make_strokes(const WrittenPart& part) {
  stroke_starts_.clear();
  const std::vector<Stroke> strokes = timeline_of(part.motions, findings_);
  for (const Stroke& stroke : strokes)
    make(stroke);
  part_of_movement_.resize(movements_.size(), &part);
  if (phases_.size() >= kMaxPhases)
    findings_.left_out(part.mark, "more than " + std::to_string(kMaxPhases) + " postures; the rest is left out");
}

}  // namespace auslan::notation
