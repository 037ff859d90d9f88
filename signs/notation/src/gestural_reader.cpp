// SPDX-License-Identifier: Apache-2.0
// Gestural SiGML: sign_manual with its postures and motions.
#include "element.h"

#include <algorithm>
#include <charconv>

namespace auslan::notation {
namespace {

using Kind = WrittenMotion::Kind;

void unknown(const Element& element, std::string_view where) {
  element.findings().left_out(element.mark(), "the element " + in_quotes(element.name()) + " is not known in " +
                                                  std::string(where) + " and is left out");
}

/// One of the words, or told and left out.
std::string word(Element& element, const char* attribute, std::initializer_list<std::string_view> words) {
  const std::string value = element.text(attribute);
  if (value.empty() || std::ranges::find(words, std::string_view(value)) != words.end()) return value;
  std::string expected;
  for (const std::string_view one : words)
    (expected += expected.empty() ? "" : ", ") += one;
  element.findings().left_out(element.mark(), "the value " + in_quotes(value) + " of the attribute " + attribute +
                                                  " is not known and is left out (expected " + expected + ")");
  return {};
}

/// Digits '1' to '5' of the value; others are told.
std::string digits(Element& element, const char* attribute) {
  const std::string value = element.text(attribute);
  std::string result;
  for (const char c : value)
    if (c >= '1' && c <= '5' && result.find(c) == std::string::npos) result += c;
  if (std::ranges::any_of(value, [](char c) { return (c < '1' || c > '5') && c != ' ' && c != ','; }))
    element.findings().left_out(element.mark(), "the value " + in_quotes(value) + " of the attribute " + attribute +
                                                    " names digits other than 1 to 5");
  return result;
}

/// "approximately": what is approximate is signed as it is written.
void approximate(Element& element, std::initializer_list<const char*> attributes) {
  for (const char* attribute : attributes)
    if (element.flag(attribute))
      element.findings().note(element.mark(), std::string(attribute) + ": signed exactly as written");
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
  shape.contact_kind = element.text("contactkind");
  shape.thumb_between = digits(element, "thumbbetween");
  shape.thumb_enclosed = element.flag("thumbenclosed");
  shape.opposed = digits(element, "opposedfinger");
  shape.thumb_contact = element.text("thumbcontact");
  shape.successive = word(element, "successivefingers", {"towards_pinky", "towards_thumb"});
  element.not_carried({"bodypart", "side"});
  WrittenShape second;
  second.base = element.text("second_handshape");
  second.thumb = word(element, "second_thumbpos", {"out", "across", "opposed"});
  second.bend = element.text("second_mainbend");
  second.opening = word(element, "second_ceeopening", {"tight", "slack"});
  second.special = digits(element, "second_specialfingers");
  second.exempt = digits(element, "second_exempteddigits");
  second.crossed = digits(element, "second_contactpair");
  second.contact_kind = element.text("second_contactkind");
  second.thumb_between = digits(element, "second_thumbbetween");
  second.thumb_contact = element.text("second_thumbcontact");
  second.thumb_enclosed = element.flag("second_thumbenclosed");
  if (!shape.empty()) hand.shape = shape;
  if (!second.empty()) {
    // What only the second half of a "between" names leaves the rest as in the first.
    WrittenShape merged = shape;
    if (!second.base.empty()) {
      merged = second;
      if (second.special.empty()) merged.special = shape.special;
      merged.digit_bend = shape.digit_bend;
      if (second.exempt.empty()) merged.exempt = shape.exempt;
    } else {
      if (!second.thumb.empty()) merged.thumb = second.thumb;
      if (!second.bend.empty()) merged.bend = second.bend;
      if (!second.opening.empty()) merged.opening = second.opening;
      if (!second.special.empty()) merged.special = second.special;
      if (!second.exempt.empty()) merged.exempt = second.exempt;
      if (!second.crossed.empty()) merged.crossed = second.crossed;
      if (!second.contact_kind.empty()) merged.contact_kind = second.contact_kind;
      if (!second.thumb_between.empty()) merged.thumb_between = second.thumb_between;
      if (!second.thumb_contact.empty()) merged.thumb_contact = second.thumb_contact;
      merged.thumb_enclosed = merged.thumb_enclosed || second.thumb_enclosed;
    }
    hand.second_shape = merged;
    if (!hand.shape) hand.shape = merged;
  }
  hand.fingers = element.text("extfidir");
  hand.second_fingers = element.text("second_extfidir");
  hand.palm = element.text("palmor");
  hand.second_palm = element.text("second_palmor");
  // SiGML also lets a direction be marked as absolute, or as relative to the path, by its attribute's name or by a mark
  // beside it.
  const auto marked = [&element](const char* name, std::string& letters) {
    const std::string value = element.text(name);
    if (value.empty() || value == "false") return false;
    if (value != "true" && letters.empty()) letters = value;
    return true;
  };
  marked("abs_extfidir", hand.fingers);
  hand.palm_absolute = marked("abs_palmor", hand.palm);
  bool relative = marked("rel_extfidir", hand.fingers);
  relative = marked("rel_palmor", hand.palm) || relative;
  relative = marked("second_rel_extfidir", hand.second_fingers) || relative;
  relative = marked("second_rel_palmor", hand.second_palm) || relative;
  if (relative)
    element.findings().warning(element.mark(),
                               "an orientation that follows the path is signed as it is at the path's beginning");
  approximate(element, {"approx_extfidir", "approx_palmor", "approx_shape", "approx_handshape"});
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
  site.second_part = element.text("second_location");
  site.second_digits = digits(element, "second_digits");
  site.second_side = element.text("second_side");
  site.behind = element.flag("behind");
  approximate(element, {"approx_location", "approx_side"});
  element.not_carried({"def_locname"});
  element.each_child([&site](Element& child) {
    if (child.name() == "location_hand") {
      if (!site.with.empty()) child.findings().left_out(child.mark(), "a second part of the moving hand is left out");
      if (site.with.empty()) site.with.push_back(read_hand_site(child));
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
  approximate(element, {"approx_location", "approx_side"});
  element.not_carried({"second_contact"});
  site.name = element.text("def_locname");
  element.each_child([&site](Element& child) {
    if (child.name() == "location_hand") {
      if (site.with) child.findings().left_out(child.mark(), "a second part of the moving hand is left out");
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
        child.findings().left_out(child.mark(), "a third place in a constellation of two hands is left out");
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
        WrittenBodySite site;
        site.mark = child.mark();
        site.on_hand = read_hand_site(child);
        posture.body[count++] = site;
      } else {
        unknown(child, "a split location");
      }
    });
    posture.split_body = true;
    element.done();
  } else if (name == "handconstellation") {
    read_constellation(element, posture);
  } else if (name == "use_locname") {
    for (const char* attribute : {"name", "locname", "use_locname"})
      if (std::string name_of_place = element.text(attribute); !name_of_place.empty())
        posture.use_name = std::move(name_of_place);
    element.done();
    if (posture.use_name.empty())
      element.findings().left_out(element.mark(), "a place is used again, but not named: left out");
  } else {
    return false;
  }
  return true;
}

bool is_posture(std::string_view name) {
  return name == "handconfig" || name == "split_handconfig" || name == "location_bodyarm" || name == "location_hand" ||
         name == "split_location" || name == "handconstellation" || name == "use_locname";
}

}  // namespace

double read_pace(Element& element) {
  double pace = 1;
  for (const char* attribute : {"speed", "timescale"}) {
    const std::string value = element.text(attribute);
    if (value.empty()) continue;
    double factor = 0;
    const auto [rest, error] = std::from_chars(value.data(), value.data() + value.size(), factor);
    if (error != std::errc() || rest != value.data() + value.size() || !(factor >= 0.05 && factor <= 20)) {
      element.findings().left_out(element.mark(), "the value " + in_quotes(value) + " of the attribute " + attribute +
                                                      " is not a number from 0.05 to 20; left out");
      continue;
    }
    // A scale of time stretches it.
    pace *= attribute == std::string_view("speed") ? factor : 1.0 / factor;
  }
  return std::clamp(pace, 0.1, 10.0);
}

namespace {

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
    element.findings().left_out(element.mark(), "the manner " + in_quotes(manner) +
                                                    " is not known and is left out (expected fast, slow, tense, rest "
                                                    "or halt)");
  }
  if (element.flag("bouncing")) motion.halt = true;
  motion.fused = element.flag("fused");
  if (element.flag("abs_motion"))
    element.findings().note(element.mark(), "an absolute movement: signed in the signer's own directions, as all are");
  motion.pace = read_pace(element);
  element.not_carried({"def_locname", "duration"});
}

std::optional<WrittenMotion> read_motion(Element& element);

void read_parts(Element& element, WrittenMotion& motion, size_t most) {
  element.each_child([&](Element& child) {
    if (motion.parts.size() >= most) {
      child.findings().left_out(child.mark(),
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
    motion.brushed.emplace_back();
    read_posture_element(child, motion.brushed.back());
    child.findings().warning(child.mark(),
                             "the place that is brushed on the way is carried as brushing where the hand is");
  });
}

/// Ellipses, growth and the sizes of waves.
void read_variation(Element& element, WrittenMotion& motion) {
  motion.ellipse = word(element, "ellipse_direction", {"h", "ur", "v", "ul"});
  motion.ellipse_size = word(element, "ellipse_size", {"small", "big"});
  motion.growth = word(element, "incrdecr", {"increasing", "decreasing"});
  motion.growth_size = word(element, "incrdecr_size", {"small", "big"});
  motion.waviness_size = word(element, "zigzag_size", {"small", "big"});
  motion.waviness_growth = word(element, "zigzag_incrdecr", {"increasing", "decreasing"});
  element.not_carried({"zigzag_incrdecr_size", "zigzag_manner"});
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
    read_variation(element, motion);
    approximate(element, {"approx_direction"});
    element.not_carried({"second_curve"});
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
    motion.waviness = word(element, "zigzag_style", {"zigzag", "wavy"});
    read_variation(element, motion);
    read_brushing(element, motion);
  } else if (name == "wristmotion") {
    motion.kind = Kind::kWrist;
    motion.wrist = element.text("motion");
    motion.size = word(element, "size", {"small", "big"});
    read_brushing(element, motion);
  } else if (name == "fingerplay") {
    motion.kind = Kind::kFingerplay;
    motion.digits = digits(element, "digits");
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
    motion.second_repetition = element.text("second_repetition");
    motion.repetition_growth = word(element, "repetition_incrdecr", {"increasing", "decreasing"});
    motion.repetition_growth_size = word(element, "repetition_incrdecr_size", {"small", "big"});
    motion.shift = element.text("repetition_baseshift");
    motion.shift_size = word(element, "baseshift_size", {"small", "big"});
    approximate(element, {"approx_repetition"});
    element.not_carried(
        {"baseshift_incrdecr", "baseshift_incrdecr_size", "second_repetition_incrdecr", "second_repetition_baseshift"});
    read_parts(element, motion, 64);
  } else if (name == "crossmotion" || name == "nonman_motion") {
    element.findings().left_out(element.mark(), "the movement " + in_quotes(name) + " is not carried");
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
        child.findings().left_out(child.mark(), "a posture after the first movement is left out, as in other readers");
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
