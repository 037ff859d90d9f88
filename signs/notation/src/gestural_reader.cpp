// SPDX-License-Identifier: Apache-2.0
// Gestural SiGML: sign_manual with its postures and motions.
#include "element.h"

#include <algorithm>

namespace auslan::notation {
namespace {

using Kind = WrittenMotion::Kind;

void unknown(const Element& element, std::string_view where) {
  element.findings().warning(element.mark(), "the element " + in_quotes(element.name()) + " is not known in " +
                                                 std::string(where) + " and is left out");
}

/// One of the words, or told and left out.
std::string word(Element& element, const char* attribute, std::initializer_list<std::string_view> words) {
  const std::string value = element.text(attribute);
  if (value.empty() || std::ranges::find(words, std::string_view(value)) != words.end()) return value;
  element.findings().warning(element.mark(), "the value " + in_quotes(value) + " of the attribute " + attribute +
                                                 " is not known and is left out");
  return {};
}

/// Digits '1' to '5' of the value; others are told.
std::string digits(Element& element, const char* attribute) {
  const std::string value = element.text(attribute);
  std::string result;
  for (const char c : value)
    if (c >= '1' && c <= '5' && result.find(c) == std::string::npos) result += c;
  if (std::ranges::any_of(value, [](char c) { return (c < '1' || c > '5') && c != ' ' && c != ','; }))
    element.findings().warning(element.mark(), "the value " + in_quotes(value) + " of the attribute " + attribute +
                                                   " names digits other than 1 to 5");
  return result;
}

WrittenHand read_hand(Element& element) {
  WrittenHand hand;
  hand.mark = element.mark();
  WrittenShape shape;
  shape.base = element.text("handshape");
  shape.thumb = word(element, "thumbpos", {"out", "across", "opposed"});
  shape.bend = element.text("mainbend");
  static constexpr const char* kBends[] = {"bend1", "bend2", "bend3", "bend4", "bend5"};
  for (size_t i = 0; i < 5; ++i)
    shape.digit_bend[i] = element.text(kBends[i]);
  shape.opening = word(element, "ceeopening", {"tight", "slack"});
  shape.splay = word(element, "splay", {"0", "1", "2"});
  shape.special = digits(element, "specialfingers");
  shape.exempt = digits(element, "exempteddigits");
  shape.crossed = digits(element, "contactpair");
  if (const std::string kind = element.text("contactkind"); !kind.empty() && !shape.crossed.empty())
    element.findings().warning(element.mark(), "the kind of contact " + in_quotes(kind) +
                                                   " between two fingers is carried as crossed fingers");
  shape.thumb_between = digits(element, "thumbbetween");
  shape.thumb_enclosed = element.flag("thumbenclosed");
  element.not_carried({"opposedfinger", "thumbcontact", "successivefingers", "second_contactpair", "second_contactkind",
                       "second_thumbbetween", "second_thumbenclosed", "second_thumbcontact", "bodypart", "side",
                       "second_specialfingers", "second_exempteddigits"});
  WrittenShape second;
  second.base = element.text("second_handshape");
  second.thumb = word(element, "second_thumbpos", {"out", "across", "opposed"});
  second.bend = element.text("second_mainbend");
  second.opening = word(element, "second_ceeopening", {"tight", "slack"});
  if (!shape.empty()) hand.shape = shape;
  if (!second.empty()) {
    // What only the second half of a "between" names leaves the rest as in the first.
    WrittenShape merged = shape;
    if (!second.base.empty()) {
      merged = second;
      merged.special = shape.special;
      merged.digit_bend = shape.digit_bend;
      merged.exempt = shape.exempt;
    } else {
      if (!second.thumb.empty()) merged.thumb = second.thumb;
      if (!second.bend.empty()) merged.bend = second.bend;
      if (!second.opening.empty()) merged.opening = second.opening;
    }
    hand.second_shape = merged;
    if (!hand.shape) hand.shape = merged;
  }
  hand.fingers = element.text("extfidir");
  hand.second_fingers = element.text("second_extfidir");
  hand.palm = element.text("palmor");
  hand.second_palm = element.text("second_palmor");
  if (hand.fingers.empty() && element.has("abs_extfidir")) hand.fingers = element.text("abs_extfidir");
  if (hand.palm.empty() && element.has("abs_palmor")) hand.palm = element.text("abs_palmor");
  element.not_carried({"rel_extfidir", "rel_palmor", "second_rel_extfidir", "second_rel_palmor", "approx_extfidir",
                       "approx_palmor", "approx_shape", "approx_handshape"});
  element.each_child([](Element& child) { unknown(child, "a hand's configuration"); });
  element.done();
  return hand;
}

WrittenHandSite read_hand_site(Element& element) {
  WrittenHandSite site;
  site.mark = element.mark();
  site.part = element.text("location");
  site.digits = digits(element, "digits");
  site.side = element.text("side");
  site.contact = element.text("contact");
  element.not_carried({"second_location", "second_side", "second_digits", "approx_location", "behind", "def_locname"});
  element.each_child([](Element& child) {
    if (child.name() == "location_hand") {
      child.findings().warning(child.mark(), "the part of the moving hand at a place on the other hand is not carried");
    } else {
      unknown(child, "a place on the hand");
    }
  });
  element.done();
  return site;
}

WrittenBodySite read_body_site(Element& element) {
  WrittenBodySite site;
  site.mark = element.mark();
  site.location = element.text("location");
  site.second_location = element.text("second_location");
  site.side = element.text("side");
  site.second_side = element.text("second_side");
  site.contact = word(element, "contact", {"touch", "close", "armextended"});
  site.behind = element.flag("behind");
  element.not_carried({"approx_location", "second_contact", "approx_side"});
  element.not_carried({"def_locname"});
  element.each_child([&site](Element& child) {
    if (child.name() == "location_hand") {
      if (site.with) child.findings().warning(child.mark(), "a second part of the moving hand is left out");
      if (!site.with) site.with = read_hand_site(child);
    } else {
      unknown(child, "a place on the body");
    }
  });
  element.done();
  return site;
}

void read_constellation(Element& element, WrittenPosture& posture) {
  WrittenMeeting meeting;
  meeting.mark = element.mark();
  meeting.contact = word(element, "contact", {"touch", "close", "interlock", "cross", "armextended"});
  element.each_child([&](Element& child) {
    if (child.name() == "location_hand") {
      const WrittenHandSite site = read_hand_site(child);
      if (!meeting.dominant) {
        meeting.dominant = site;
      } else if (!meeting.other) {
        meeting.other = site;
      } else {
        child.findings().warning(child.mark(), "a third place in a constellation of two hands is left out");
      }
    } else if (child.name() == "location_bodyarm") {
      posture.body[0] = read_body_site(child);
    } else {
      unknown(child, "a hand constellation");
    }
  });
  element.done();
  posture.meeting = meeting;
}

bool read_posture_element(Element& element, WrittenPosture& posture) {
  const std::string_view name = element.name();
  if (posture.empty()) posture.mark = element.mark();
  if (name == "handconfig") {
    posture.shared.merge(read_hand(element));
  } else if (name == "split_handconfig") {
    std::vector<WrittenHand> hands;
    element.each_child([&](Element& child) {
      if (child.name() == "handconfig" && hands.size() < 2) {
        hands.push_back(read_hand(child));
      } else {
        unknown(child, "a split hand configuration");
      }
    });
    element.done();
    hands.resize(2);
    posture.split_hands = true;
    for (size_t i = 0; i < 2; ++i)
      posture.split[i].merge(hands[i]);
  } else if (name == "location_bodyarm") {
    posture.body[0] = read_body_site(element);
  } else if (name == "location_hand") {
    posture.on_other = read_hand_site(element);
  } else if (name == "split_location") {
    size_t count = 0;
    element.each_child([&](Element& child) {
      if (child.name() == "location_bodyarm" && count < 2) {
        posture.body[count++] = read_body_site(child);
      } else if (child.name() == "location_hand" && count < 2) {
        child.findings().warning(child.mark(), "a place on a hand within a split location is not carried");
        ++count;
      } else {
        unknown(child, "a split location");
      }
    });
    posture.split_body = true;
    element.done();
  } else if (name == "handconstellation") {
    read_constellation(element, posture);
  } else if (name == "use_locname") {
    element.not_carried({"name", "locname", "use_locname"});
    element.done();
    element.findings().warning(element.mark(), "a place named before is not carried");
  } else {
    return false;
  }
  return true;
}

bool is_posture(std::string_view name) {
  return name == "handconfig" || name == "split_handconfig" || name == "location_bodyarm" || name == "location_hand" ||
         name == "split_location" || name == "handconstellation" || name == "use_locname";
}

void read_manner(Element& element, WrittenMotion& motion) {
  motion.fast = element.flag("fast");
  motion.slow = element.flag("slow");
  motion.tense = element.flag("tense");
  motion.rest = element.flag("rest");
  motion.halt = element.flag("halt");
  motion.alternating = element.flag("alternating") || element.flag("second_alternating");
  const std::string manner = element.text("manner");
  if (manner == "fast") {
    motion.fast = true;
  } else if (manner == "slow") {
    motion.slow = true;
  } else if (manner == "halt") {
    motion.halt = true;
  } else if (manner == "tense") {
    motion.tense = true;
  } else if (manner == "rest") {
    motion.rest = true;
  } else if (!manner.empty()) {
    element.findings().warning(element.mark(), "the manner " + in_quotes(manner) + " is not known and is left out");
  }
  element.not_carried({"bouncing", "fused", "abs_motion", "def_locname", "speed", "timescale", "duration"});
}

std::optional<WrittenMotion> read_motion(Element& element);

void read_parts(Element& element, WrittenMotion& motion, size_t most) {
  element.each_child([&](Element& child) {
    if (motion.parts.size() >= most) {
      child.findings().warning(child.mark(),
                               "one movement too many in " + in_quotes(element.name()) + "; it is left out");
      return;
    }
    if (auto part = read_motion(child)) motion.parts.push_back(std::move(*part));
  });
}

/// Places inside a simple movement: contact in passing.
void read_brushing(Element& element, WrittenMotion& motion) {
  element.each_child([&](Element& child) {
    if (!is_posture(child.name())) {
      unknown(child, "a movement");
      return;
    }
    motion.brushing = true;
    WrittenPosture passed;
    read_posture_element(child, passed);
    child.findings().warning(child.mark(),
                             "the place that is brushed on the way is carried as brushing where the hand is");
  });
}

std::optional<WrittenMotion> read_motion(Element& element) {
  const std::string_view name = element.name();
  WrittenMotion motion;
  motion.mark = element.mark();
  read_manner(element, motion);
  if (name == "directedmotion") {
    motion.kind = Kind::kDirected;
    motion.direction = element.text("direction");
    motion.second_direction = element.text("second_direction");
    motion.size = word(element, "size", {"small", "big"});
    motion.second_size = word(element, "second_size", {"small", "big"});
    motion.curve = element.text("curve");
    motion.curve_size = word(element, "curve_size", {"small", "big"});
    motion.waviness = word(element, "zigzag_style", {"zigzag", "wavy"});
    element.not_carried({"zigzag_size", "ellipse_direction", "ellipse_size", "incrdecr", "incrdecr_size",
                         "second_curve", "zigzag_incrdecr", "zigzag_incrdecr_size", "zigzag_manner",
                         "approx_direction"});
    read_brushing(element, motion);
  } else if (name == "circularmotion") {
    motion.kind = Kind::kCircular;
    motion.direction = element.text("axis");
    motion.second_direction = element.text("second_axis");
    motion.size = word(element, "size", {"small", "big"});
    motion.second_size = word(element, "second_size", {"small", "big"});
    motion.clock_start = element.text("start");
    motion.clock_end = element.text("end");
    if (element.flag("clockplus")) motion.extra_turns = 1;
    if (element.flag("second_clockplus")) ++motion.extra_turns;
    element.not_carried({"ellipse_direction", "ellipse_size", "zigzag_style", "zigzag_size", "incrdecr",
                         "incrdecr_size", "zigzag_incrdecr", "zigzag_incrdecr_size", "zigzag_manner"});
    read_brushing(element, motion);
  } else if (name == "wristmotion") {
    motion.kind = Kind::kWrist;
    motion.wrist = element.text("motion");
    motion.size = word(element, "size", {"small", "big"});
    read_brushing(element, motion);
  } else if (name == "fingerplay") {
    motion.kind = Kind::kFingerplay;
    element.not_carried({"digits"});
  } else if (name == "changeposture") {
    motion.kind = Kind::kChange;
  } else if (name == "nomotion" || name == "no_motion") {
    motion.kind = Kind::kNothing;
  } else if (name == "seq_motion") {
    motion.kind = Kind::kSequence;
    read_parts(element, motion, 64);
  } else if (name == "par_motion") {
    motion.kind = Kind::kParallel;
    read_parts(element, motion, 16);
  } else if (name == "split_motion") {
    motion.kind = Kind::kSplit;
    read_parts(element, motion, 2);
  } else if (name == "tgt_motion") {
    motion.kind = Kind::kTarget;
    element.each_child([&](Element& child) {
      if (read_posture_element(child, motion.target)) return;
      if (auto part = read_motion(child)) motion.parts.push_back(std::move(*part));
    });
  } else if (name == "rpt_motion") {
    motion.kind = Kind::kRepeat;
    motion.repetition = element.text("repetition");
    element.not_carried({"second_repetition", "repetition_incrdecr", "repetition_incrdecr_size", "repetition_baseshift",
                         "baseshift_size", "baseshift_incrdecr", "baseshift_incrdecr_size", "approx_repetition",
                         "second_repetition_incrdecr", "second_repetition_baseshift"});
    read_parts(element, motion, 64);
  } else if (name == "crossmotion" || name == "nonman_motion") {
    element.findings().warning(element.mark(), "the movement " + in_quotes(name) + " is not carried");
    return std::nullopt;
  } else {
    unknown(element, "a movement");
    return std::nullopt;
  }
  element.done();
  return motion;
}

}  // namespace

void read_manual(Element& manual, WrittenSign& sign) {
  bool compound = false;
  manual.each_child([&](Element& child) {
    if (child.name() != "sign_manual") return;
    compound = true;
    read_manual(child, sign);
  });
  WrittenPart part;
  part.mark = manual.mark();
  part.both_hands = manual.flag("both_hands");
  part.mirror_lr = manual.flag("lr_symm");
  part.mirror_ud = manual.flag("ud_symm");
  part.mirror_oi = manual.flag("oi_symm");
  part.out_of_phase = manual.flag("outofphase");
  part.literal_space = manual.flag("realspace");
  part.non_dominant = manual.flag("nondominant");
  if (manual.flag("holdover")) manual.findings().note(manual.mark(), "the other hand keeps its last posture");
  manual.done();
  bool moved = false;
  manual.each_child([&](Element& child) {
    if (child.name() == "sign_manual") return;
    if (is_posture(child.name())) {
      if (moved)
        child.findings().warning(child.mark(), "a posture after the first movement is left out, as in other readers");
      if (!moved) read_posture_element(child, part.start);
    } else if (auto motion = read_motion(child)) {
      part.motions.push_back(std::move(*motion));
      moved = true;
    }
  });
  if (compound && part.start.empty() && part.motions.empty()) return;
  sign.parts.push_back(std::move(part));
}

}  // namespace auslan::notation
