// SPDX-License-Identifier: Apache-2.0
#include "direction.h"
#include "handshape_of.h"
#include "layout.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace auslan::notation {
namespace {

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
}  // namespace

std::optional<Vec3> Layout::direction(const std::string& letters, const std::string& second, const Mark& mark,
                                      std::string_view what) {
  auto vector = vector_of_letters(letters);
  if (!vector) {
    findings_.left_out(mark, "the " + std::string(what) + " " + in_quotes(letters) +
                                 " is not a direction (letters u d l r o i); it is left as it was");
    return std::nullopt;
  }
  if (!second.empty()) {
    if (const auto other = vector_of_letters(second)) {
      vector = midway(*vector, *other);
    } else {
      findings_.left_out(mark,
                         "the second " + std::string(what) + " " + in_quotes(second) + " is not a direction; left out");
    }
  }
  return vector;
}

namespace {

/// Made perpendicular to the fingers; as it is where it lies along them.
Vec3 across(const Vec3& palm, const Vec3& fingers) {
  const Vec3 flat = palm - fingers * glm::dot(fingers, palm);
  const double size = std::sqrt(glm::dot(flat, flat));
  return size > 1e-3 ? flat / size : Vec3(fingers.y, fingers.z, fingers.x);
}

}  // namespace

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
      if (!change.crossed.empty()) shape.crossed = change.crossed;
      if (!change.contact_kind.empty()) shape.contact_kind = change.contact_kind;
      if (!change.opposed.empty()) shape.opposed = change.opposed;
      if (!change.thumb_contact.empty()) shape.thumb_contact = change.thumb_contact;
      if (!change.thumb_between.empty()) shape.thumb_between = change.thumb_between;
      if (!change.exempt.empty()) shape.exempt = change.exempt;
      if (!change.splay.empty()) shape.splay = change.splay;
      shape.thumb_enclosed = shape.thumb_enclosed || change.thumb_enclosed;
      for (size_t i = 0; i < 5; ++i)
        if (!change.digit_bend[i].empty()) shape.digit_bend[i] = change.digit_bend[i];
    }
    if (shape.base.empty()) {
      findings_.warning(config.shape_mark, "thumb or bends without a base handshape; signed with a flat hand");
      shape.base = "flat";
    }
    std::optional<WrittenShape> second = config.second_shape;
    if (second && second->base.empty()) second->base = shape.base;
    hand.shape = handshape_of(shape, second, config.shape_mark, findings_);
    hand.written = shape;
    hand.present = true;
  }
  bool turned = false;
  if (!config.fingers.empty())
    if (const auto fingers =
            direction(config.fingers, config.second_fingers, config.fingers_mark, "extended finger direction")) {
      hand.fingers = *fingers;
      turned = true;
    }
  if (!config.palm.empty()) {
    const auto flat = [](const std::string& letters) { return letters.find_first_of("oi") == std::string::npos; };
    const bool eight = flat(config.palm) && flat(config.second_palm);
    if (!eight && !config.palm_absolute)
      findings_.warning(config.palm_mark, "the palm orientation " + in_quotes(config.palm) +
                                              " is not one of the eight (u ur r dr d dl l ul); read as the direction "
                                              "in which the palm faces");
    if (const auto palm = direction(config.palm, config.second_palm, config.palm_mark, "palm orientation")) {
      hand.palm_letter = *palm;
      hand.palm_absolute = !eight || config.palm_absolute;
      turned = true;
    }
  }
  if (turned)
    hand.palm = hand.palm_absolute ? across(hand.palm_letter, hand.fingers) : palm_of(hand.palm_letter, hand.fingers);
}

void Layout::apply_body(const WrittenBodySite& site, size_t which, Phase& phase) {
  // A place on the other hand or arm, however it is written.
  static constexpr std::string_view kOnHand[] = {"upperarm",  "elbow",     "elbowinside", "lowerarm",
                                                 "wristback", "thumbball", "palm",        "handback",
                                                 "thumbside", "pinkyside", "wristpulse"};
  if (site.on_hand || std::ranges::find(kOnHand, std::string_view(site.location)) != std::end(kOnHand)) {
    WrittenHandSite place;
    if (site.on_hand) {
      place = *site.on_hand;
    } else {
      place.mark = site.mark;
      place.part = site.location;
      place.side = site.side;
      place.contact = site.contact;
      place.behind = site.behind;
      if (site.with) place.with.push_back(*site.with);
    }
    if (which == 0) return apply_on_other(place, phase);
    findings_.warning(place.mark,
                      "the other hand is placed on the dominant one: it stays, and the dominant one comes to it");
    return;
  }
  if (!site.name.empty()) {
    std::erase_if(named_, [&site](const WrittenBodySite& known) { return known.name == site.name; });
    if (named_.size() < 16) named_.push_back(site);
  }
  Hand& hand = phase.hands[which];
  const bool apart = part_->both_hands && !phase.meeting;
  hand.spot = spot_of(site, which == 1, apart, findings_);
  hand.other_location.reset();
  hand.placed = true;
  hand.part.reset();
  if (site.with) {
    hand.part = part_of(*site.with, held(phase, which), findings_);
    // A named part before the chest is placed itself, not the palm.
    if (!hand.spot.contact && site.contact != "touch") hand.spot.contact = ContactKind::kNear;
  } else if (hand.spot.contact) {
    hand.part = facing_part(hand.shape, hand.fingers, hand.palm, -hand.spot.outward, which == 1);
  }
}

HeldHand Layout::held(const Phase& phase, size_t which) const {
  return {phase.hands[which].fingers, phase.hands[which].palm, which == 1};
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
  hand.other_location = on_other_hand(site, held(phase, 1), findings_);
  const auto contact = contact_of(site.contact, site.mark, findings_);
  hand.spot = Spot{};
  hand.spot.location = *hand.other_location;
  hand.spot.contact = contact ? *contact : ContactKind::kNear;
  if (!contact) hand.spot.offset = Vec3(0, 0.05, 0.03);
  hand.part = site.with.empty() ? facing_part(hand.shape, hand.fingers, hand.palm, Vec3(0.6, -0.6, 0.3), false)
                                : part_of(site.with.front(), held(phase, 0), findings_);
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
  Findings quiet;  // a place on the other hand is told once
  // Without a named site each hand offers what faces the other.
  meeting.part = written.dominant ? part_of(*written.dominant, held(phase, 0), findings_)
                                  : facing_part(hand.shape, hand.fingers, hand.palm, Vec3(1, 0, 0), false);
  if (written.other) {
    meeting.other_part = part_of(*written.other, held(phase, 1), quiet);
    meeting.other_location = on_other_hand(*written.other, held(phase, 1), findings_);
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
    findings_.warning(posture.on_other->mark,
                      "the other hand is placed on the dominant one: it stays, and the dominant one comes to it");
  if (!posture.use_name.empty()) {
    const auto known =
        std::ranges::find_if(named_, [&](const WrittenBodySite& site) { return site.name == posture.use_name; });
    if (known == named_.end()) {
      findings_.left_out(posture.mark, "the place named " + in_quotes(posture.use_name) + " was not named before");
    } else {
      const WrittenBodySite site = *known;
      if (hands.dominant) apply_body(site, 0, phase);
    }
  }
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

}  // namespace auslan::notation
