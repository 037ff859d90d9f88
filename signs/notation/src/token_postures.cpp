// SPDX-License-Identifier: Apache-2.0
#include "token_parser.h"

#include <algorithm>

namespace auslan::notation {

using enum SymbolKind;

void TokenReader::read_one_shape(WrittenShape& shape) {
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
        shape.contact_kind = tokens_[at_ + 1].symbol->value;
        shape.crossed = value() + std::string(tokens_[at_ + 2].symbol->value);
        at_ += 3;
        continue;
      }
      last_digit = value();
      const bool pinch = shape.base.starts_with("pinch") || shape.base.starts_with("cee");
      std::string& digits = bent && !pinch ? shape.exempt : shape.special;
      if (digits.find(last_digit) == std::string::npos) digits += last_digit;
    } else if (kind() == kFingerPart && !shape.base.empty() && !shape.thumb.empty()) {
      shape.thumb_contact = value();
    } else {
      break;
    }
    ++at_;
  }
  // On a grip like a C the thumb says how far it is open.
  if (shape.base.starts_with("cee") && shape.thumb != "out" && !shape.thumb.empty()) {
    shape.opening = shape.thumb == "across" ? "tight" : "slack";
    shape.thumb.clear();
  }
}

WrittenShape TokenReader::read_shape(std::optional<WrittenShape>& second) {
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

WrittenHandSite TokenReader::read_hand_site() {
  WrittenHandSite site;
  site.mark = mark();
  while (more()) {
    if (kind() == kDigit) {
      if (site.digits.find(value()) == std::string::npos) site.digits += value();
    } else if (kind() == kFingerPart) {
      if (!site.part.empty() && site.part != value())
        findings_.left_out(mark(), "a second part of the hand at one place; " + in_quotes(value()) + " is left out");
      if (site.part.empty()) site.part = value();
    } else if (kind() == kHandSite) {
      // After a part of a finger, palm and back of the hand say on which side.
      if (site.part.empty() && site.digits.empty()) {
        site.part = value();
      } else {
        site.side = value() == "palm"        ? "palmar"
                    : value() == "handback"  ? "dorsal"
                    : value() == "thumbside" ? "radial"
                    : value() == "pinkyside" ? "ulnar"
                                             : value();
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

void TokenReader::read_place(WrittenPosture& posture, size_t hand, bool split) {
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
    findings_.left_out(start, "a side mark without a place is left out");
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

void TokenReader::read_posture_piece(WrittenPosture& posture, size_t hand, bool split) {
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
void TokenReader::read_posture_group(WrittenPosture& posture) {
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

void TokenReader::read_posture(WrittenPosture& posture, bool top) {
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
        findings_.left_out(site.mark, "a part of the hand without a place to put it is left out");
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

}  // namespace auslan::notation
