// SPDX-License-Identifier: Apache-2.0
#include "direction.h"
#include "layout.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <cmath>

namespace auslan::notation {
namespace {

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

void Layout::tell_dropped(const WrittenMotion& motion) {
  if (!motion.clock_start.empty() || !motion.clock_end.empty())
    findings_.warning(motion.mark, "where on the circle the movement starts or ends is not carried");
  if (!motion.second_size.empty()) findings_.note(motion.mark, "a size between two is carried as the first of them");
  if (motion.tense) findings_.warning(motion.mark, "tension is carried as a slow movement");
  if (motion.rest) findings_.warning(motion.mark, "a rest is carried as a slow movement");
}

Movement Layout::arc_or_line(const WrittenMotion& motion, const Vec3& by) {
  Movement movement;
  movement.kind = MoveKind::kStraight;
  movement.direction = nearest_direction(by);
  movement.size = size_of(motion.size);
  if (!motion.waviness.empty()) {
    movement.kind = motion.waviness == "wavy" ? MoveKind::kWavy : MoveKind::kZigzag;
    movement.size = Size::kSmall;
    movement.repeats = 3;
    movement.direction.reset();
  } else if (!motion.curve.empty()) {
    movement.kind = MoveKind::kArc;
    movement.size = motion.curve_size.empty() ? Size::kMedium : size_of(motion.curve_size);
    const double rise = std::sqrt(by.y * by.y / std::max(1e-12, glm::dot(by, by)));
    // The model's arcs bow up, or away where the path is steep.
    const bool carried = rise > 0.75 ? motion.curve == "d" || motion.curve == "u" : motion.curve == "u";
    if (!carried || !vector_of_letters(motion.curve))
      findings_.warning(motion.mark, "an arc that bows " + in_quotes(motion.curve) + " is carried as one that bows " +
                                         (rise > 0.75 ? "away" : "up"));
  }
  return movement;
}

void Layout::make(const Stroke& stroke) {
  if (phases_.size() >= kMaxPhases) return;
  if (stroke.restart_from >= 0 && static_cast<size_t>(stroke.restart_from) < stroke_starts_.size()) {
    const size_t start = stroke_starts_[static_cast<size_t>(stroke.restart_from)];
    if (start + 1 != phases_.size()) {
      now_ = phases_[start];
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
  Manner manner = stroke.halt   ? Manner::kSharp
                  : stroke.fast ? Manner::kFast
                  : stroke.slow ? Manner::kSlow
                                : Manner::kPlain;
  std::array<bool, 2> moved = {false, false};
  for (const StrokeItem& item : stroke.items) {
    const bool other_moves = item.hands.other && now_.hands[1].present && (part_->both_hands || !item.hands.dominant);
    if (item.target != nullptr) {
      changes = changes || !item.target->empty();
      apply(*item.target, item.hands, next);
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
    tell_dropped(motion);
    switch (motion.kind) {
      case WrittenMotion::Kind::kDirected: {
        const auto way = direction(motion.direction, motion.second_direction, motion.mark, "direction");
        if (!way) break;
        const Vec3 by = *way * travel(motion.size);
        if (item.hands.dominant) shift(next, 0, by, motion.brushing);
        if (other_moves) shift(next, 1, item.hands.dominant ? flipped(by, *part_) : by, motion.brushing);
        Movement path = arc_or_line(motion, by);
        path.hands = moving;
        made.push_back(path);
        changes = true;
        mark_moved();
        break;
      }
      case WrittenMotion::Kind::kCircular: {
        const auto axis = direction(motion.direction, motion.second_direction, motion.mark, "axis");
        if (!axis) break;
        Movement circle;
        circle.kind = MoveKind::kCircle;
        circle.direction = nearest_direction(*axis);
        circle.size = size_of(motion.size);
        circle.repeats = 1 + std::clamp(motion.extra_turns, 0, 8);
        const Vec3 a(std::abs(axis->x), std::abs(axis->y), std::abs(axis->z));
        circle.plane = a.y >= a.x && a.y >= a.z ? Plane::kHorizontal : a.z >= a.x ? Plane::kFrontal : Plane::kSagittal;
        if (axis->x + axis->y + axis->z < 0.99 || std::max({a.x, a.y, a.z}) < 0.99)
          findings_.warning(motion.mark, "a circle about " + in_quotes(motion.direction) +
                                             " keeps its axis as a direction, but is performed in the " +
                                             std::string(to_name(circle.plane)) + " plane in that plane's own sense");
        circle.hands = moving;
        made.push_back(circle);
        mark_moved();
        break;
      }
      case WrittenMotion::Kind::kWrist: {
        Movement turn;
        turn.size = size_of(motion.size);
        turn.repeats = 2;
        if (motion.wrist == "nodding") {
          turn.kind = MoveKind::kNod;
        } else if (motion.wrist == "twisting") {
          turn.kind = MoveKind::kTwist;
        } else if (motion.wrist == "swinging") {
          turn.kind = MoveKind::kShake;
          turn.direction = nearest_direction(glm::cross(next.hands[0].fingers, next.hands[0].palm));
          findings_.warning(motion.mark, "swinging of the wrist is carried as a small shake towards the thumb's side");
        } else if (motion.wrist == "stircw" || motion.wrist == "stirccw") {
          turn.kind = MoveKind::kCircle;
          turn.size = Size::kTiny;
          turn.plane = motion.wrist == "stircw" ? Plane::kClockwise : Plane::kAnticlockwise;
          findings_.warning(motion.mark, "stirring of the wrist is carried as a tiny circle before the palm");
        } else {
          findings_.warning(motion.mark, "the wrist movement " + in_quotes(motion.wrist) +
                                             " is not known (expected nodding, swinging, twisting, stircw or stirccw)");
          break;
        }
        turn.hands = moving;
        made.push_back(turn);
        mark_moved();
        break;
      }
      case WrittenMotion::Kind::kFingerplay: {
        Movement play;
        play.kind = MoveKind::kWiggle;
        play.repeats = 2;
        play.hands = moving;
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
                 m.kind == MoveKind::kZigzag;
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
  if (phases_.size() >= kMaxPhases)
    findings_.warning(part.mark, "more than " + std::to_string(kMaxPhases) + " postures; the rest is left out");
}

}  // namespace auslan::notation
