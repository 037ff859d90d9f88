// SPDX-License-Identifier: Apache-2.0
#include "token_reader.h"

#include <algorithm>
#include <utility>

namespace auslan::notation {
namespace {

using enum SymbolKind;
using Kind = WrittenMotion::Kind;

constexpr int kMaxNesting = 24;

bool starts_shape(SymbolKind kind) {
  return kind == kHandshape || kind == kThumb || kind == kBend;
}
bool starts_place(SymbolKind kind) {
  return kind == kBody || kind == kHandSite || kind == kDigit || kind == kFingerPart || kind == kSide ||
         kind == kContact || kind == kBehind;
}
bool starts_posture(SymbolKind kind) {
  return starts_shape(kind) || kind == kFingers || kind == kPalm || starts_place(kind);
}
bool starts_action(SymbolKind kind) {
  return kind == kMove || kind == kCircle || kind == kWrist || kind == kFingerplay || kind == kReplace ||
         kind == kNoMotion || kind == kBrushing;
}

class Reader {
 public:
  Reader(std::span<const Token> tokens, const Mark& mark, WrittenSign& sign, Findings& findings)
      : tokens_(tokens), mark_(mark), sign_(sign), findings_(findings) {}

  void read() {
    while (at_ < tokens_.size())
      read_part();
  }

 private:
  bool more() const { return at_ < tokens_.size(); }
  SymbolKind kind(size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead].symbol->kind : kOther;
  }
  std::string value() const { return std::string(tokens_[at_].symbol->value); }
  const Mark& mark() const { return at_ < tokens_.size() ? tokens_[at_].mark : mark_; }
  bool take(SymbolKind wanted) {
    if (!more() || kind() != wanted) return false;
    ++at_;
    return true;
  }
  void skip(std::string_view why) {
    const std::string_view value = tokens_[at_].symbol->value;
    if (kind() != kOther || !value.empty())
      findings_.warning(mark(), "the symbol " + in_quotes(tokens_[at_].symbol->name) +
                                    (kind() == kOther ? " (" + std::string(value) + ")" : "") + " " + std::string(why));
    ++at_;
  }
  /// What a bracket is about: the first symbol inside it.
  SymbolKind first_inside(size_t ahead) const {
    size_t i = at_ + ahead;
    while (i < tokens_.size() &&
           (tokens_[i].symbol->kind == kParallelBegin || tokens_[i].symbol->kind == kSequenceBegin ||
            tokens_[i].symbol->kind == kFusionBegin || tokens_[i].symbol->kind == kPlus))
      ++i;
    return i < tokens_.size() ? tokens_[i].symbol->kind : kOther;
  }
  bool action_here() const {
    if (!more()) return false;
    if (starts_action(kind())) return true;
    const bool bracket = kind() == kParallelBegin || kind() == kSequenceBegin || kind() == kFusionBegin;
    return bracket && starts_action(first_inside(0));
  }

  void read_part();
  void read_symmetry(WrittenPart& part);
  void read_posture(WrittenPosture& posture, bool top);
  void read_posture_piece(WrittenPosture& posture, size_t hand, bool split);
  void read_posture_group(WrittenPosture& posture);
  void read_place(WrittenPosture& posture, size_t hand, bool split);
  WrittenShape read_shape(std::optional<WrittenShape>& second);
  void read_one_shape(WrittenShape& shape);
  WrittenHandSite read_hand_site();
  std::string side_word(const std::string& step, bool before) const { return (before ? "left_" : "right_") + step; }
  std::optional<WrittenMotion> read_action(int depth);
  WrittenMotion read_group(int depth);
  void read_modifiers(WrittenMotion& motion);
  void read_repeats(WrittenMotion& motion);
  void read_target(WrittenMotion& motion);

  std::span<const Token> tokens_;
  size_t at_ = 0;
  Mark mark_;
  WrittenSign& sign_;
  Findings& findings_;
};

void Reader::read_symmetry(WrittenPart& part) {
  bool seen = false;
  while (more()) {
    if (kind() == kSymmetry) {
      part.both_hands = true;
      part.mirror_lr = value() == "lr";
      seen = true;
      ++at_;
    } else if (seen && kind() == kSize) {
      if (value() == "big") part.mirror_ud = true;
      if (value() != "big") findings_.warning(mark(), "a small symmetry is not known; left out");
      ++at_;
    } else if (seen && kind() == kBend) {
      part.mirror_oi = true;
      ++at_;
    } else if (seen && kind() == kAlternating) {
      part.out_of_phase = true;
      ++at_;
    } else if (kind() == kNonIpsi) {
      part.literal_space = true;
      ++at_;
    } else if (kind() == kNonDominant) {
      part.non_dominant = true;
      ++at_;
    } else {
      return;
    }
  }
}

void Reader::read_one_shape(WrittenShape& shape) {
  std::string last_digit;
  if (more() && kind() == kHandshape) {
    shape.base = value();
    ++at_;
  }
  bool bent = false;
  while (more()) {
    if (kind() == kThumb) {
      shape.thumb = value();
    } else if (kind() == kBend) {
      // Straight after a digit it bends that digit alone.
      if (!last_digit.empty()) {
        shape.digit_bend[static_cast<size_t>(last_digit[0] - '1')] = value();
        shape.special.erase(std::remove(shape.special.begin(), shape.special.end(), last_digit[0]),
                            shape.special.end());
        shape.exempt.erase(std::remove(shape.exempt.begin(), shape.exempt.end(), last_digit[0]), shape.exempt.end());
      } else {
        shape.bend = value();
        bent = true;
      }
      last_digit.clear();
    } else if (kind() == kDigit && !shape.base.empty()) {
      // A digit before or after a part of a finger: the two fingers touch or cross.
      if (kind(1) == kFingerPart && kind(2) == kDigit) {
        shape.crossed = value() + std::string(tokens_[at_ + 2].symbol->value);
        at_ += 3;
        continue;
      }
      last_digit = value();
      const bool pinch = shape.base.starts_with("pinch") || shape.base.starts_with("cee");
      std::string& digits = bent && !pinch ? shape.exempt : shape.special;
      if (digits.find(last_digit) == std::string::npos) digits += last_digit;
    } else if (kind() == kFingerPart && !shape.base.empty() && !shape.thumb.empty()) {
      findings_.warning(mark(), "the part of the finger that the thumb touches is not carried");
    } else {
      break;
    }
    ++at_;
  }
}

WrittenShape Reader::read_shape(std::optional<WrittenShape>& second) {
  WrittenShape shape;
  read_one_shape(shape);
  while (more() && kind() == kBetween) {
    if (starts_shape(kind(1))) {
      ++at_;
      WrittenShape other;
      read_one_shape(other);
      if (other.base.empty()) {
        // Only a thumb or a bend between: the rest is the same.
        const WrittenShape change = other;
        other = shape;
        if (!change.thumb.empty()) other.thumb = change.thumb;
        if (!change.bend.empty()) other.bend = change.bend;
      }
      second = other;
    } else if (kind(1) == kDigit) {
      ++at_;
      while (more() && kind() == kDigit) {
        shape.thumb_between += value();
        ++at_;
      }
    } else {
      shape.thumb_enclosed = true;
      ++at_;
    }
  }
  return shape;
}

WrittenHandSite Reader::read_hand_site() {
  WrittenHandSite site;
  site.mark = mark();
  while (more()) {
    if (kind() == kDigit) {
      if (site.digits.find(value()) == std::string::npos) site.digits += value();
    } else if (kind() == kFingerPart) {
      if (!site.part.empty() && site.part != value())
        findings_.warning(mark(), "a second part of the hand at one place; " + in_quotes(value()) + " is left out");
      if (site.part.empty()) site.part = value();
    } else if (kind() == kHandSite) {
      // After a part of a finger, palm and back of the hand say on which side.
      if (site.part.empty() && site.digits.empty()) {
        site.part = value();
      } else {
        site.side = value() == "palm" ? "palmar" : value() == "handback" ? "dorsal" : value();
      }
    } else if (kind() == kSide) {
      // Before what it belongs to the left, after it the right; a digit or part must follow or have come.
      const bool before = site.part.empty() && site.digits.empty();
      site.side = side_word(value(), before);
    } else {
      break;
    }
    ++at_;
  }
  return site;
}

void Reader::read_place(WrittenPosture& posture, size_t hand, bool split) {
  const Mark start = mark();
  // Left sides stand before the place, right ones after it.
  std::string side;
  if (kind() == kSide && kind(1) == kBody) {
    side = side_word(value(), true);
    ++at_;
  }
  if (more() && kind() == kBody) {
    WrittenBodySite site;
    site.mark = start;
    site.location = value() == "neutralspace" ? "" : value();
    site.side = side;
    ++at_;
    if (more() && kind() == kSide) {
      // A side between two places belongs to the second one only when that is not a place of a hand.
      site.side = side_word(value(), false);
      ++at_;
    }
    if (more() && kind() == kBetween && (kind(1) == kBody || (kind(1) == kSide && kind(2) == kBody))) {
      ++at_;
      if (kind() == kSide) {
        site.second_side = side_word(value(), true);
        ++at_;
      }
      site.second_location = value();
      ++at_;
      if (more() && kind() == kSide) {
        site.second_side = side_word(value(), false);
        ++at_;
      }
    }
    if (more() && kind() == kBehind) {
      site.behind = true;
      ++at_;
    }
    if (more() && kind() == kContact) {
      site.contact = value();
      if (site.contact == "interlock" || site.contact == "cross") {
        findings_.warning(mark(), "the contact " + in_quotes(site.contact) + " with the body is carried as touching");
        site.contact = "touch";
      }
      ++at_;
    } else if (kind() == kSequenceBegin && kind(1) == kContact) {
      ++at_;
      site.contact = value();
      ++at_;
      site.with = read_hand_site();
      take(kSequenceEnd);
    }
    if (split) posture.split_body = true;
    posture.body[split ? hand : 0] = site;
    return;
  }
  if (kind() == kContact) {
    // Contact without a place: of the hands with each other.
    WrittenMeeting meeting = posture.meeting.value_or(WrittenMeeting{});
    meeting.mark = start;
    meeting.contact = value();
    ++at_;
    posture.meeting = meeting;
    return;
  }
  if (kind() == kBehind) {
    skip("is left out: it names no place");
    return;
  }
  WrittenHandSite site = read_hand_site();
  if (more() && kind() == kContact && !split) {
    site.contact = value();
    ++at_;
  }
  if (site.part.empty() && site.digits.empty()) {
    findings_.warning(start, "a side mark without a place is left out");
    return;
  }
  if (split) {
    WrittenMeeting meeting = posture.meeting.value_or(WrittenMeeting{});
    if (!posture.meeting) meeting.mark = start;
    (hand == 0 ? meeting.dominant : meeting.other) = site;
    posture.meeting = meeting;
    return;
  }
  // Followed by a place on the body, it is the part of the hand that is put there.
  const bool body_follows = kind() == kBody || (kind() == kSide && kind(1) == kBody);
  if (body_follows && site.contact.empty()) {
    read_place(posture, hand, false);
    if (posture.body[0]) posture.body[0]->with = site;
    return;
  }
  posture.on_other = site;
}

void Reader::read_posture_piece(WrittenPosture& posture, size_t hand, bool split) {
  WrittenHand piece;
  piece.mark = mark();
  if (starts_shape(kind())) {
    piece.shape = read_shape(piece.second_shape);
  } else if (kind() == kFingers) {
    piece.fingers = value();
    ++at_;
    if (more() && kind() == kBetween && kind(1) == kFingers) {
      ++at_;
      piece.second_fingers = value();
      ++at_;
    }
  } else if (kind() == kPalm) {
    piece.palm = value();
    ++at_;
    if (more() && kind() == kBetween && kind(1) == kPalm) {
      ++at_;
      piece.second_palm = value();
      ++at_;
    }
  } else if (starts_place(kind())) {
    read_place(posture, hand, split);
    return;
  } else {
    skip("is out of order and left out");
    return;
  }
  if (split) posture.split_hands = true;
  (split ? posture.split[hand] : posture.shared).merge(piece);
}

/// parbegin … [plus …] parend, around parts of a posture.
void Reader::read_posture_group(WrittenPosture& posture) {
  ++at_;
  // Split when a plus comes before the matching end.
  bool split = false;
  int depth = 0;
  for (size_t i = at_; i < tokens_.size() && depth >= 0; ++i) {
    const SymbolKind k = tokens_[i].symbol->kind;
    if (k == kParallelBegin || k == kSequenceBegin || k == kFusionBegin) ++depth;
    if (k == kParallelEnd || k == kSequenceEnd || k == kFusionEnd) --depth;
    if (k == kPlus && depth == 0) split = true;
  }
  size_t hand = 0;
  while (more() && kind() != kParallelEnd) {
    if (kind() == kPlus) {
      if (++hand > 1) findings_.warning(mark(), "a third part of a two-handed bracket; read as the second");
      hand = 1;
      ++at_;
    } else if (starts_posture(kind())) {
      read_posture_piece(posture, hand, split);
    } else {
      skip("is out of order and left out");
    }
  }
  take(kParallelEnd);
  if (posture.meeting && more() && kind() == kContact) {
    posture.meeting->contact = value();
    ++at_;
  }
}

void Reader::read_posture(WrittenPosture& posture, bool top) {
  posture.mark = mark();
  bool second_hand = false;
  while (more()) {
    if (kind() == kParallelBegin && starts_posture(first_inside(0))) {
      read_posture_group(posture);
    } else if (kind() == kSequenceBegin && (kind(1) == kContact || starts_place(kind(1)))) {
      // Contact with a part of the hand, standing apart from its place.
      ++at_;
      std::string contact;
      if (kind() == kContact) {
        contact = value();
        ++at_;
      }
      const WrittenHandSite site = read_hand_site();
      if (posture.body[0]) {
        posture.body[0]->with = site;
        if (!contact.empty()) posture.body[0]->contact = contact;
      } else {
        findings_.warning(site.mark, "a part of the hand without a place to put it is left out");
      }
      while (more() && kind() != kSequenceEnd && !action_here())
        skip("is out of order and left out");
      take(kSequenceEnd);
    } else if (starts_posture(kind())) {
      read_posture_piece(posture, second_hand ? 1 : 0, second_hand);
    } else if (top && kind() == kPlus && starts_posture(kind(1)) && !second_hand) {
      // The two hands one after the other, without a bracket.
      findings_.note(mark(), "what follows is read as the other hand's");
      second_hand = true;
      posture.split_hands = true;
      posture.split[0] = posture.shared;
      posture.shared = {};
      ++at_;
    } else {
      return;
    }
  }
}

void Reader::read_modifiers(WrittenMotion& motion) {
  bool on_curve = false;
  while (more()) {
    switch (kind()) {
      case kSize:
        (on_curve ? motion.curve_size : motion.size) = value();
        break;
      case kArc:
        motion.curve = value();
        on_curve = true;
        break;
      case kWaviness:
        motion.waviness = value();
        break;
      case kClock:
        (motion.clock_start.empty() ? motion.clock_start : motion.clock_end) = value();
        break;
      case kClockFull:
        ++motion.extra_turns;
        break;
      case kEllipse:
      case kGrowth:
        skip("is not carried");
        continue;
      case kManner: {
        const std::string manner = value();
        motion.fast = motion.fast || manner == "fast";
        motion.slow = motion.slow || manner == "slow";
        motion.tense = motion.tense || manner == "tense";
        motion.rest = motion.rest || manner == "rest";
        motion.halt = motion.halt || manner == "halt";
        break;
      }
      case kAlternating:
        motion.alternating = true;
        break;
      case kBrushing:
        motion.brushing = true;
        findings_.note(mark(), "brushing is carried where the hand is");
        break;
      case kBetween:
        if ((kind(1) == kMove && motion.kind == Kind::kDirected) ||
            (kind(1) == kCircle && motion.kind == Kind::kCircular)) {
          ++at_;
          motion.second_direction = value();
        } else if (kind(1) == kSize) {
          ++at_;
          motion.second_size = value();
        } else {
          return;
        }
        break;
      default:
        return;
    }
    ++at_;
  }
}

void Reader::read_repeats(WrittenMotion& motion) {
  while (more() && (kind() == kRepeat || kind() == kAlternating)) {
    if (kind() == kAlternating) {
      motion.alternating = true;
      ++at_;
      continue;
    }
    WrittenMotion repeat;
    repeat.mark = mark();
    repeat.kind = Kind::kRepeat;
    repeat.repetition = value();
    repeat.alternating = motion.alternating;
    ++at_;
    // "once more and once more" nests without end; a few are what people write.
    int levels = 0;
    for (const WrittenMotion* inner = &motion; inner->kind == Kind::kRepeat && !inner->parts.empty();
         inner = &inner->parts[0])
      ++levels;
    if (levels >= 3) {
      findings_.warning(repeat.mark, "a repetition of a repetition of a repetition is left out");
      continue;
    }
    repeat.parts.push_back(std::move(motion));
    motion = std::move(repeat);
  }
}

/// A place or posture after a movement is where it ends.
void Reader::read_target(WrittenMotion& motion) {
  if (!more()) return;
  const bool group = kind() == kParallelBegin && starts_posture(first_inside(0));
  const bool touch = kind() == kSequenceBegin && kind(1) == kContact;
  if (!starts_place(kind()) && !(group && !starts_shape(first_inside(0))) && !touch) return;
  WrittenMotion target;
  target.mark = motion.mark;
  target.kind = Kind::kTarget;
  read_posture(target.target, false);
  if (target.target.empty()) return;
  target.parts.push_back(std::move(motion));
  motion = std::move(target);
}

WrittenMotion Reader::read_group(int depth) {
  WrittenMotion group;
  group.mark = mark();
  const SymbolKind begin = kind();
  const SymbolKind end = begin == kParallelBegin ? kParallelEnd : begin == kSequenceBegin ? kSequenceEnd : kFusionEnd;
  if (begin == kFusionBegin) findings_.warning(mark(), "a fused sequence is carried as a plain one");
  ++at_;
  std::vector<std::vector<WrittenMotion>> sides(1);
  while (more() && kind() != end) {
    if (kind() == kPlus) {
      ++at_;
      if (sides.size() >= 2) findings_.warning(mark(), "a third part of a two-handed bracket; read with the second");
      if (sides.size() < 2) sides.emplace_back();
    } else if (action_here() && depth < kMaxNesting) {
      if (auto action = read_action(depth + 1)) sides.back().push_back(std::move(*action));
    } else if ((starts_posture(kind()) || kind() == kParallelBegin) && depth < kMaxNesting) {
      // A posture within a movement: a change to it at the same time.
      WrittenMotion change;
      change.mark = mark();
      change.kind = Kind::kTarget;
      const size_t before = at_;
      read_posture(change.target, false);
      if (at_ == before) {
        skip("is out of order and left out");
      } else {
        sides.back().push_back(std::move(change));
      }
    } else {
      skip("is out of order and left out");
    }
  }
  if (more()) {
    ++at_;
  } else {
    findings_.warning(group.mark, "a bracket is not closed; it ends with the sign");
  }
  const Kind inside = begin == kParallelBegin ? Kind::kParallel : Kind::kSequence;
  if (sides.size() == 1) {
    group.kind = inside;
    group.parts = std::move(sides[0]);
  } else {
    group.kind = Kind::kSplit;
    for (auto& side : sides) {
      WrittenMotion half;
      half.mark = side.empty() ? group.mark : side.front().mark;
      half.kind = inside;
      half.parts = std::move(side);
      group.parts.push_back(std::move(half));
    }
  }
  return group;
}

std::optional<WrittenMotion> Reader::read_action(int depth) {
  WrittenMotion motion;
  motion.mark = mark();
  switch (kind()) {
    case kMove:
    case kCircle:
      motion.kind = kind() == kMove ? Kind::kDirected : Kind::kCircular;
      motion.direction = value();
      ++at_;
      read_modifiers(motion);
      break;
    case kWrist:
      motion.kind = Kind::kWrist;
      motion.wrist = value();
      ++at_;
      read_modifiers(motion);
      break;
    case kFingerplay: {
      motion.kind = Kind::kFingerplay;
      ++at_;
      if (more() && kind() == kDigit)
        findings_.warning(mark(), "fingerplay of some digits is carried as that of all fingers");
      while (more() && kind() == kDigit)
        ++at_;
      read_modifiers(motion);
      break;
    }
    case kNoMotion:
      ++at_;
      read_modifiers(motion);
      break;
    case kReplace:
      motion.kind = Kind::kTarget;
      ++at_;
      read_modifiers(motion);
      read_posture(motion.target, false);
      if (more() && (kind() == kManner || kind() == kGrowth)) read_modifiers(motion);
      break;
    case kBrushing:
      findings_.warning(mark(), "brushing without a movement is left out");
      ++at_;
      return std::nullopt;
    default:
      motion = read_group(depth);
      read_modifiers(motion);
      break;
  }
  if (motion.kind != Kind::kTarget) read_target(motion);
  read_repeats(motion);
  return motion;
}

void Reader::read_part() {
  const size_t begin = at_;
  WrittenPart part;
  part.mark = mark();
  read_symmetry(part);
  while (more() && !starts_posture(kind()) && !action_here() && kind() != kParallelBegin && kind() != kSymmetry &&
         kind() != kPlus)
    skip("is out of order and left out");
  if (more() && kind() == kSymmetry) read_symmetry(part);
  read_posture(part.start, true);
  bool ended = false;
  while (more() && !ended) {
    if (action_here()) {
      if (auto action = read_action(0)) part.motions.push_back(std::move(*action));
    } else if (kind() == kPlus) {
      // A new manual part: the sign is a compound.
      ++at_;
      ended = true;
    } else if (kind() == kSymmetry || (!part.motions.empty() && kind() == kHandshape)) {
      ended = true;
    } else if (kind() == kRepeat && !part.motions.empty()) {
      read_repeats(part.motions.back());
    } else if (kind() == kRepeat || kind() == kAlternating) {
      if (kind() == kAlternating) part.out_of_phase = true;
      if (kind() == kRepeat) findings_.warning(mark(), "a repetition without a movement before it is left out");
      ++at_;
    } else if (!part.motions.empty() &&
               (starts_posture(kind()) || (kind() == kParallelBegin && starts_posture(first_inside(0))))) {
      WrittenMotion target;
      target.mark = mark();
      target.kind = Kind::kTarget;
      const size_t before = at_;
      read_posture(target.target, false);
      if (at_ == before) {
        skip("is out of order and left out");
      } else {
        part.motions.push_back(std::move(target));
      }
    } else {
      skip("is out of order and left out");
    }
  }
  if (at_ == begin) skip("is out of order and left out");
  if (!part.start.empty() || !part.motions.empty()) sign_.parts.push_back(std::move(part));
}

}  // namespace

void read_tokens(std::span<const Token> tokens, const Mark& mark, WrittenSign& sign, Findings& findings) {
  Reader(tokens, mark, sign, findings).read();
}

}  // namespace auslan::notation
