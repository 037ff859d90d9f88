// SPDX-License-Identifier: Apache-2.0
// From the written sign to postures and movements: both hands are kept explicitly while the sign is laid out; only at
// the end is a sign whose hands are mirror images told as a symmetric one.
#include "direction.h"
#include "handshape_of.h"
#include "phonology/vocabulary.h"
#include "place_of.h"
#include "timeline.h"

#include <algorithm>
#include <cmath>

namespace auslan::notation {
namespace {

constexpr size_t kMaxPhases = 96;
// Rounding to 26 directions below this angle is not worth telling.
constexpr double kToldRounding = 5.0;

/// How far a straight movement goes, metres.
double travel(const std::string& size) {
  return size == "small" ? 0.06 : size == "big" ? 0.20 : 0.12;
}

Size size_of(const std::string& size) {
  return size == "small" ? Size::kSmall : size == "big" ? Size::kLarge : Size::kMedium;
}

/// One hand within the layout.
struct Hand {
  bool present = false;
  std::optional<WrittenShape> written;  ///< what later changes build on
  Handshape shape;
  Vec3 fingers{0, 1, 0};
  Vec3 palm_letter{1, 0, 0}, palm{1, 0, 0};
  Spot spot;
  std::optional<HandPart> part;            ///< the part that is placed
  std::optional<Location> other_location;  ///< placed at the other hand or arm, `spot.offset` from it
  bool placed = false;                     ///< by the notation, not by default
};

/// The two hands at each other: from where on, and with which parts.
struct Meeting {
  HandPart part = HandPart::kPalm, other_part = HandPart::kPalm;
  Location other_location = Location::kHands;
  ContactKind contact = ContactKind::kTouch;
  Vec3 dominant_offset{0.0}, other_offset{0.0};  ///< of the two hands when they met
};

struct Phase {
  std::array<Hand, 2> hands;
  std::optional<Meeting> meeting;
};

/// The same configuration for the other hand, as the symmetry of the part asks. A palm letter mirrored together with
/// the finger letters gives the mirrored palm; towards and away are in the fingers alone.
WrittenHand mirrored(WrittenHand hand, const WrittenPart& part) {
  const auto flip = [&part](std::string& letters) {
    for (char& letter : letters) {
      if (part.mirror_lr && (letter == 'l' || letter == 'r')) letter = letter == 'l' ? 'r' : 'l';
      if (part.mirror_ud && (letter == 'u' || letter == 'd')) letter = letter == 'u' ? 'd' : 'u';
      if (part.mirror_oi && (letter == 'o' || letter == 'i')) letter = letter == 'o' ? 'i' : 'o';
    }
  };
  for (std::string* letters : {&hand.fingers, &hand.second_fingers, &hand.palm, &hand.second_palm})
    flip(*letters);
  return hand;
}

Vec3 flipped(const Vec3& v, const WrittenPart& part) {
  return {part.mirror_lr ? -v.x : v.x, part.mirror_ud ? -v.y : v.y, part.mirror_oi ? -v.z : v.z};
}

bool same(const Vec3& a, const Vec3& b) {
  const Vec3 d = a - b;
  return glm::dot(d, d) < 1e-12;
}

Vec3 image(const Vec3& v) {
  return {-v.x, v.y, v.z};
}

class Layout {
 public:
  Layout(const WrittenSign& written, Findings& findings) : written_(written), findings_(findings) {}
  NotatedSign run();

 private:
  // postures
  void begin_part(const WrittenPart& part);
  void apply(const WrittenPosture& posture, Hands hands, Phase& phase);
  void apply_config(const WrittenHand& config, size_t which, Phase& phase);
  void apply_body(const WrittenBodySite& site, size_t which, Phase& phase);
  void apply_meeting(const WrittenMeeting& meeting, Phase& phase);
  void apply_on_other(const WrittenHandSite& site, Phase& phase);
  void mirror_place(Phase& phase);
  void default_base(Phase& phase, const Mark& mark, bool arm);
  std::optional<Vec3> direction(const std::string& letters, const std::string& second, const Mark& mark,
                                std::string_view what);
  // movements
  void make_strokes(const WrittenPart& part);
  void make(const Stroke& stroke);
  void shift(Phase& phase, size_t which, const Vec3& by, bool brushing);
  void tell_dropped(const WrittenMotion& motion);
  Movement arc_or_line(const WrittenMotion& motion, const Vec3& by);
  size_t append(const Phase& phase);
  // the model
  Posture posture_of(const Phase& phase, size_t which, bool symmetric);
  bool is_mirror(const Phase& phase) const;
  void keep_shape(const Handshape& shape);

  const WrittenSign& written_;
  Findings& findings_;
  const WrittenPart* part_ = nullptr;
  Phase now_;
  std::vector<Phase> phases_;
  std::vector<size_t> stroke_starts_;  ///< phase at which each stroke of this part began
  std::vector<Movement> movements_;
  bool hands_differ_ = false;  ///< some movement moves the hands differently
  bool alternating_ = false;
  NotatedSign result_;
};

std::optional<Vec3> Layout::direction(const std::string& letters, const std::string& second, const Mark& mark,
                                      std::string_view what) {
  auto vector = vector_of_letters(letters);
  if (!vector) {
    findings_.warning(mark, "the " + std::string(what) + " " + in_quotes(letters) +
                                " is not a direction (letters u d l r o i); it is left as it was");
    return std::nullopt;
  }
  if (!second.empty()) {
    if (const auto other = vector_of_letters(second)) {
      vector = midway(*vector, *other);
    } else {
      findings_.warning(mark,
                        "the second " + std::string(what) + " " + in_quotes(second) + " is not a direction; left out");
    }
  }
  return vector;
}

void Layout::apply_config(const WrittenHand& config, size_t which, Phase& phase) {
  Hand& hand = phase.hands[which];
  if (config.shape) {
    WrittenShape shape = *config.shape;
    if (shape.base.empty() && hand.written) {
      // A change of thumb or bend alone keeps the base form.
      const WrittenShape change = shape;
      shape = *hand.written;
      if (!change.thumb.empty()) shape.thumb = change.thumb;
      if (!change.bend.empty()) shape.bend = change.bend;
      if (!change.special.empty()) shape.special = change.special;
      if (!change.opening.empty()) shape.opening = change.opening;
      for (size_t i = 0; i < 5; ++i)
        if (!change.digit_bend[i].empty()) shape.digit_bend[i] = change.digit_bend[i];
    }
    if (shape.base.empty()) {
      findings_.warning(config.mark, "thumb or bends without a base handshape; signed with a flat hand");
      shape.base = "flat";
    }
    std::optional<WrittenShape> second = config.second_shape;
    if (second && second->base.empty()) second->base = shape.base;
    hand.shape = handshape_of(shape, second, config.mark, findings_);
    hand.written = shape;
    hand.present = true;
  }
  bool turned = false;
  if (!config.fingers.empty())
    if (const auto fingers =
            direction(config.fingers, config.second_fingers, config.mark, "extended finger direction")) {
      hand.fingers = *fingers;
      turned = true;
    }
  if (!config.palm.empty()) {
    const auto flat = [](const std::string& letters) { return letters.find_first_of("oi") == std::string::npos; };
    if (!flat(config.palm) || !flat(config.second_palm)) {
      findings_.warning(config.mark, "the palm orientation " + in_quotes(config.palm) +
                                         " is not one of the eight (u ur r dr d dl l ul); it is left as it was");
    } else if (const auto palm = direction(config.palm, config.second_palm, config.mark, "palm orientation")) {
      hand.palm_letter = *palm;
      turned = true;
    }
  }
  if (turned) hand.palm = palm_of(hand.palm_letter, hand.fingers);
}

void Layout::apply_body(const WrittenBodySite& site, size_t which, Phase& phase) {
  Hand& hand = phase.hands[which];
  const bool apart = part_->both_hands && !phase.meeting;
  hand.spot = spot_of(site, which == 1, apart, findings_);
  hand.other_location.reset();
  hand.placed = true;
  hand.part.reset();
  if (site.with) {
    hand.part = part_of(*site.with, findings_);
    // A named part before the chest is placed itself, not the palm.
    if (!hand.spot.contact && site.contact != "touch") hand.spot.contact = ContactKind::kNear;
  } else if (hand.spot.contact) {
    hand.part = facing_part(hand.shape, hand.fingers, hand.palm, -hand.spot.outward, which == 1);
  }
}

/// The other hand's place as the image of the dominant one's.
void Layout::mirror_place(Phase& phase) {
  const Hand& hand = phase.hands[0];
  Hand& other = phase.hands[1];
  other.spot = hand.spot;
  other.spot.offset.x = part_->literal_space ? hand.spot.offset.x : -hand.spot.offset.x;
  other.spot.outward = image(hand.spot.outward);
  other.part = hand.part;
  other.other_location = hand.other_location;
  other.placed = hand.placed;
}

void Layout::default_base(Phase& phase, const Mark& mark, bool arm) {
  Hand& other = phase.hands[1];
  if (other.present) return;
  WrittenShape flat;
  flat.base = arm ? "fist" : "flat";
  other.written = flat;
  other.shape = handshape_of(flat, std::nullopt, mark, findings_);
  other.present = true;
  other.fingers = Vec3(-1, 0, 0);
  other.palm_letter = Vec3(0, -1, 0);
  other.palm = palm_of(other.palm_letter, other.fingers);
  other.spot = neutral_spot(true, true);
  other.spot.offset = Vec3(0.05, -0.04, 0.18);
  findings_.warning(mark, "the other " + std::string(arm ? "arm" : "hand") +
                              " is touched but not described; it is held before the chest, " +
                              (arm ? "a fist" : "flat") + " with the palm down");
}

void Layout::apply_on_other(const WrittenHandSite& site, Phase& phase) {
  Hand& hand = phase.hands[0];
  default_base(phase, site.mark, is_arm_site(site.part) || site.part == "wristback" || site.part == "wristpulse");
  hand.other_location = on_other_hand(site, findings_);
  const auto contact = contact_of(site.contact, site.mark, findings_);
  hand.spot = Spot{};
  hand.spot.location = *hand.other_location;
  hand.spot.contact = contact ? *contact : ContactKind::kNear;
  if (!contact) hand.spot.offset = Vec3(0, 0.05, 0.03);
  hand.part = facing_part(hand.shape, hand.fingers, hand.palm, Vec3(0.6, -0.6, 0.3), false);
  hand.placed = true;
  phase.meeting.reset();
}

void Layout::apply_meeting(const WrittenMeeting& written, Phase& phase) {
  Meeting meeting;
  default_base(phase, written.mark, false);
  const auto contact = contact_of(written.contact, written.mark, findings_);
  meeting.contact = contact ? *contact : ContactKind::kNear;
  const Hand& hand = phase.hands[0];
  const Hand& other = phase.hands[1];
  // Without a named site each hand offers what faces the other.
  meeting.part = written.dominant ? part_of(*written.dominant, findings_)
                                  : facing_part(hand.shape, hand.fingers, hand.palm, Vec3(1, 0, 0), false);
  if (written.other) {
    meeting.other_part = part_of(*written.other, findings_);
    meeting.other_location = on_other_hand(*written.other, findings_);
  } else {
    meeting.other_part = facing_part(other.shape, other.fingers, other.palm, Vec3(-1, 0, 0), true);
    switch (meeting.other_part) {
      case HandPart::kPalm:
        meeting.other_location = Location::kOtherPalm;
        break;
      case HandPart::kBack:
        meeting.other_location = Location::kOtherBack;
        break;
      case HandPart::kUlnar:
      case HandPart::kFistUlnar:
        meeting.other_location = Location::kOtherUlnar;
        break;
      case HandPart::kRadial:
      case HandPart::kFistThumbSide:
        meeting.other_location = Location::kOtherRadial;
        break;
      case HandPart::kThumbTip:
        meeting.other_location = Location::kOtherThumb;
        break;
      case HandPart::kKnuckles:
        meeting.other_location = Location::kOtherFistTop;
        break;
      default:
        meeting.other_location = Location::kOtherFingertips;
        break;
    }
  }
  meeting.dominant_offset = hand.spot.offset;
  meeting.other_offset = other.spot.offset;
  phase.meeting = meeting;
}

void Layout::apply(const WrittenPosture& posture, Hands hands, Phase& phase) {
  const bool both = part_->both_hands;
  if (!posture.shared.empty()) {
    if (hands.dominant) apply_config(posture.shared, 0, phase);
    // Written for the other hand alone it is in that hand's own directions; written for both it is mirrored.
    if (hands.other && (both || phase.hands[1].present) && (both || !hands.dominant))
      apply_config(hands.dominant ? mirrored(posture.shared, *part_) : posture.shared, 1, phase);
  }
  if (posture.split_hands) {
    if (hands.dominant && !posture.split[0].empty()) apply_config(posture.split[0], 0, phase);
    if (hands.other && !posture.split[1].empty()) apply_config(posture.split[1], 1, phase);
  }
  const bool dominant_body = posture.body[0].has_value();
  if (posture.meeting && !dominant_body) {
    // Where the pair is stays as it is; before the chest if nothing is known.
    for (size_t i = 0; i < 2; ++i)
      if (phase.hands[i].other_location) {
        phase.hands[i].other_location.reset();
        phase.hands[i].spot = neutral_spot(i == 1, true);
      }
  }
  if (dominant_body) {
    if (!posture.meeting && hands.dominant) phase.meeting.reset();
    if (posture.meeting) phase.meeting = Meeting{};
    if (hands.dominant) apply_body(*posture.body[0], 0, phase);
    if (posture.split_body && posture.body[1]) {
      if (hands.other) apply_body(*posture.body[1], 1, phase);
    } else if (hands.other && !hands.dominant) {
      if (both || phase.hands[1].present) apply_body(*posture.body[0], 1, phase);
    } else if (hands.other && both) {
      mirror_place(phase);
    }
  } else if (posture.body[1] && hands.other) {
    apply_body(*posture.body[1], 1, phase);
  }
  if (posture.on_other && hands.dominant) apply_on_other(*posture.on_other, phase);
  if (posture.on_other && !hands.dominant)
    findings_.warning(posture.on_other->mark, "a place on the dominant hand for the other hand is not carried");
  if (posture.meeting) apply_meeting(*posture.meeting, phase);
}

void Layout::begin_part(const WrittenPart& part) {
  part_ = &part;
  const bool first = phases_.empty();
  Phase phase = now_;
  if (!first) phase.meeting.reset();
  if (first || !part.start.body[0]) {
    const bool pair = part.both_hands || part.start.split_hands;
    for (size_t i = 0; i < 2; ++i) {
      phase.hands[i].spot = neutral_spot(i == 1, pair);
      phase.hands[i].part.reset();
      phase.hands[i].other_location.reset();
    }
  }
  if (part.both_hands || part.start.split_hands) phase.hands[1].present = true;
  apply(part.start, {true, part.both_hands || part.start.split_hands || part.start.split_body}, phase);
  if (part.start.meeting && !part.start.body[0]) {
    // A pair without a place: the base hand near the middle, before the chest.
    for (size_t i = 0; i < 2; ++i)
      phase.hands[i].spot.offset.x = i == 0 ? -0.03 : 0.03;
    phase.meeting->dominant_offset = phase.hands[0].spot.offset;
    phase.meeting->other_offset = phase.hands[1].spot.offset;
  }
  if (part.non_dominant)
    findings_.warning(part.mark, "a sign of the non-dominant hand alone is carried on the dominant one");
  if (part.start.shared.fingers.empty() && part.start.split[0].fingers.empty() && first)
    findings_.warning(part.mark, "no extended finger direction is written; the fingers point up");
  if (part.start.shared.palm.empty() && part.start.split[0].palm.empty() && first)
    findings_.warning(part.mark, "no palm orientation is written; the palm faces left");
  now_ = phase;
  const size_t index = append(now_);
  if (!first && index > 0) {
    Movement link;
    link.kind = MoveKind::kStraight;
    link.hands = part.both_hands ? MovingHands::kBoth : MovingHands::kDominant;
    link.from = static_cast<int>(index) - 1;
    link.to = static_cast<int>(index);
    movements_.push_back(link);
  }
}

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

bool Layout::is_mirror(const Phase& phase) const {
  const Hand& a = phase.hands[0];
  const Hand& b = phase.hands[1];
  if (a.shape.id != b.shape.id || !same(a.fingers, image(b.fingers)) || !same(a.palm, image(b.palm))) return false;
  if (phase.meeting && (phase.meeting->part != phase.meeting->other_part)) return false;
  if (a.other_location || b.other_location) return false;
  if (phase.meeting) return std::abs(a.spot.offset.y - b.spot.offset.y) < 1e-9;
  return a.spot.location == b.spot.location && same(a.spot.offset, image(b.spot.offset)) && a.part == b.part;
}

Posture Layout::posture_of(const Phase& phase, size_t which, bool symmetric) {
  const Hand& hand = phase.hands[which];
  Posture posture;
  posture.handshape = hand.shape.id;
  posture.fingers = nearest_direction(hand.fingers);
  posture.palm = nearest_palm(hand.palm, posture.fingers);
  posture.location = hand.spot.location;
  posture.offset = hand.spot.offset;
  const auto at = [&](ContactKind kind) {
    Contact contact;
    contact.kind = kind;
    contact.part = hand.part;
    posture.contact = contact;
  };
  if (hand.spot.contact) at(*hand.spot.contact);
  if (phase.meeting) {
    const Meeting& meeting = *phase.meeting;
    const Vec3 apart =
        (phase.hands[0].spot.offset - meeting.dominant_offset) - (phase.hands[1].spot.offset - meeting.other_offset);
    const bool still = glm::dot(apart, apart) < 1e-9;
    const HandPart part = which == 0 ? meeting.part : meeting.other_part;
    posture.contact = Contact{still ? meeting.contact : ContactKind::kNear, part, std::nullopt};
    if (symmetric && std::abs(apart.x) < 1e-9) {
      posture.contact->target = Location::kHands;
    } else if (!symmetric && which == 0) {
      posture.location = meeting.other_location;
      posture.offset = apart;
    }
  }
  // Space has a front: nothing is signed inside the chest.
  const bool in_space = posture.location >= Location::kHighNeutral && posture.location <= Location::kContraSpace;
  if (in_space) posture.offset.z = std::clamp(posture.offset.z, 0.05, 0.60);
  return posture;
}

void Layout::keep_shape(const Handshape& shape) {
  for (const Handshape& kept : result_.handshapes)
    if (kept.id == shape.id) return;
  result_.handshapes.push_back(shape);
}

NotatedSign Layout::run() {
  Sign& sign = result_.sign;
  sign.gloss = written_.gloss.empty() ? "UNNAMED" : written_.gloss;
  sign.kind = "sign";
  sign.category = "notation";
  sign.region = "all";
  sign.non_manual = written_.non_manual;
  sign.provenance.form_evidence = "read from a sign notation";
  sign.provenance.movement_evidence = "documented";
  bool has_manual = false;
  for (const WrittenPart& part : written_.parts) {
    if (part.start.empty() && part.motions.empty()) continue;
    if (!part.start.has_shape() && !now_.hands[0].present) {
      findings_.error(part.mark, "no handshape is written: there is nothing to sign");
      return std::move(result_);
    }
    has_manual = true;
    begin_part(part);
    make_strokes(part);
    if (part.out_of_phase) alternating_ = true;
  }
  if (!has_manual) {
    findings_.error(written_.mark,
                    "the sign " + in_quotes(sign.gloss) + " has no manual part: there is nothing to sign");
    return std::move(result_);
  }
  // A hand that comes in later waits in its first posture.
  bool two = false;
  for (size_t i = phases_.size(); i-- > 0;) {
    if (phases_[i].hands[1].present) {
      two = true;
    } else if (two) {
      phases_[i].hands[1] = phases_[i + 1].hands[1];
    }
  }
  if (two)
    for (size_t i = 1; i < phases_.size(); ++i)
      if (!phases_[i].hands[1].present) phases_[i].hands[1] = phases_[i - 1].hands[1];
  for (Phase& phase : phases_) {
    // A shape is needed for a hand that was only placed.
    if (phase.hands[1].present && phase.hands[1].shape.id.empty()) {
      phase.hands[1].shape = phase.hands[0].shape;
      phase.hands[1].written = phase.hands[0].written;
    }
  }
  const bool mirror = two && !hands_differ_ && std::all_of(phases_.begin(), phases_.end(), [this](const Phase& phase) {
                        return is_mirror(phase);
                      });
  if (!two) {
    sign.handedness = Handedness::kOne;
  } else if (mirror) {
    sign.handedness = alternating_ ? Handedness::kAlternating : Handedness::kSymmetric;
  } else {
    sign.handedness = Handedness::kDominantBase;
    if (alternating_)
      for (Movement& movement : movements_)
        if (movement.hands == MovingHands::kBoth) movement.hands = MovingHands::kAlternating;
  }
  for (const Phase& phase : phases_) {
    sign.dominant.push_back(posture_of(phase, 0, mirror));
    keep_shape(phase.hands[0].shape);
    if (two && !mirror) {
      sign.non_dominant.push_back(posture_of(phase, 1, false));
      keep_shape(phase.hands[1].shape);
    }
  }
  for (Movement& movement : movements_)
    if (mirror && movement.hands == MovingHands::kBoth && alternating_) movement.hands = MovingHands::kAlternating;
  sign.movements = movements_;
  double worst = 0;
  for (size_t i = 0; i < phases_.size(); ++i)
    for (size_t hand = 0; hand < (sign.non_dominant.empty() ? 1U : 2U); ++hand) {
      const Posture& posture = hand == 0 ? sign.dominant[i] : sign.non_dominant[i];
      worst = std::max({worst, angle_deg(to_vector(posture.fingers), phases_[i].hands[hand].fingers)});
    }
  if (worst > kToldRounding)
    findings_.note(written_.mark, "finger directions between the model's 26 are rounded, by up to " +
                                      std::to_string(static_cast<int>(worst + 0.5)) + " degrees");
  result_.signable = true;
  return std::move(result_);
}

}  // namespace

NotatedSign sign_of(const WrittenSign& written, Findings& findings) {
  NotatedSign sign = Layout(written, findings).run();
  sign.diagnostics = findings.take();
  return sign;
}

}  // namespace auslan::notation
