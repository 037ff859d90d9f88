// SPDX-License-Identifier: Apache-2.0
// Gestural SiGML from the written form: the reverse of gestural_reader.cpp.
#include "converter.h"

#include <array>
#include <charconv>

namespace auslan::notation {
namespace {

using Kind = WrittenMotion::Kind;

void flag(WrittenElement& element, std::string_view name, bool value) {
  if (value) element.put(name, "true");
}

std::string decimal(double value) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed).ptr;
  return {buffer.data(), end};
}

class GesturalWriter {
 public:
  explicit GesturalWriter(Findings& findings) : findings_(findings) {}

  void part(const WrittenPart& part, WrittenElement& sign) {
    WrittenElement& manual = sign.add("sign_manual");
    flag(manual, "both_hands", part.both_hands);
    flag(manual, "lr_symm", part.mirror_lr);
    flag(manual, "ud_symm", part.mirror_ud);
    flag(manual, "oi_symm", part.mirror_oi);
    flag(manual, "outofphase", part.out_of_phase);
    flag(manual, "realspace", part.literal_space);
    flag(manual, "nondominant", part.non_dominant);
    posture(part.start, manual);
    for (const WrittenMotion& one : part.motions)
      motion(one, manual);
  }

 private:
  static void shape(const WrittenShape& shape, WrittenElement& element) {
    element.put("handshape", shape.base);
    element.put("thumbpos", shape.thumb);
    element.put("mainbend", shape.bend);
    static constexpr std::array<std::string_view, 5> kBends = {"bend1", "bend2", "bend3", "bend4", "bend5"};
    for (size_t i = 0; i < kBends.size(); ++i)
      element.put(kBends[i], shape.digit_bend[i]);
    element.put("ceeopening", shape.opening);
    element.put("splay", shape.splay);
    element.put("specialfingers", shape.special);
    element.put("exempteddigits", shape.exempt);
    element.put("contactpair", shape.crossed);
    element.put("contactkind", shape.contact_kind);
    element.put("opposedfinger", shape.opposed);
    element.put("thumbcontact", shape.thumb_contact);
    element.put("thumbbetween", shape.thumb_between);
    element.put("successivefingers", shape.successive);
    flag(element, "thumbenclosed", shape.thumb_enclosed);
  }

  static void second_shape(const WrittenShape& first, const WrittenShape& shape, WrittenElement& element) {
    // A second base form stands for itself; without one the rest changes the first.
    const bool changed = shape.base != first.base;
    if (changed) element.put("second_handshape", shape.base);
    const auto put = [&](std::string_view name, const std::string& own, const std::string& other) {
      if (changed || own != other) element.put(name, own);
    };
    // Where something of the first is not in the second, the base form is written again: it begins anew.
    const bool fewer = (shape.thumb.empty() && !first.thumb.empty()) || (shape.bend.empty() && !first.bend.empty()) ||
                       (shape.opening.empty() && !first.opening.empty());
    if (fewer && !changed) {
      element.put("second_handshape", shape.base);
      element.put("second_thumbpos", shape.thumb);
      element.put("second_mainbend", shape.bend);
      element.put("second_ceeopening", shape.opening);
    } else {
      put("second_thumbpos", shape.thumb, first.thumb);
      put("second_mainbend", shape.bend, first.bend);
      put("second_ceeopening", shape.opening, first.opening);
    }
    put("second_specialfingers", shape.special, first.special);
    put("second_exempteddigits", shape.exempt, first.exempt);
    put("second_contactpair", shape.crossed, first.crossed);
    put("second_contactkind", shape.contact_kind, first.contact_kind);
    put("second_thumbbetween", shape.thumb_between, first.thumb_between);
    put("second_thumbcontact", shape.thumb_contact, first.thumb_contact);
    if (shape.thumb_enclosed && (changed || !first.thumb_enclosed)) flag(element, "second_thumbenclosed", true);
  }

  void hand(const WrittenHand& hand, WrittenElement& parent) {
    WrittenElement& element = parent.add("handconfig");
    if (hand.shape) shape(*hand.shape, element);
    if (hand.shape && hand.second_shape) {
      second_shape(*hand.shape, *hand.second_shape, element);
      if (hand.second_shape->digit_bend != hand.shape->digit_bend)
        findings_.left_out(hand.mark, "the bends of single digits of a second handshape have no attributes");
    }
    element.put("extfidir", hand.fingers);
    element.put("second_extfidir", hand.second_fingers);
    element.put(hand.palm_absolute ? "abs_palmor" : "palmor", hand.palm);
    element.put("second_palmor", hand.second_palm);
  }

  void hand_site(const WrittenHandSite& site, WrittenElement& parent) {
    WrittenElement& element = parent.add("location_hand");
    element.put("location", site.part);
    element.put("digits", site.digits);
    element.put("side", site.side);
    element.put("second_location", site.second_part);
    element.put("second_digits", site.second_digits);
    element.put("second_side", site.second_side);
    element.put("contact", site.contact);
    flag(element, "behind", site.behind);
    for (const WrittenHandSite& with : site.with)
      hand_site(with, element);
  }

  void body_site(const WrittenBodySite& site, WrittenElement& parent) {
    if (site.on_hand) return hand_site(*site.on_hand, parent);
    WrittenElement& element = parent.add("location_bodyarm");
    element.put("location", site.location);
    element.put("second_location", site.second_location);
    element.put("side", site.side);
    element.put("second_side", site.second_side);
    element.put("contact", site.contact);
    flag(element, "behind", site.behind);
    element.put("def_locname", site.name);
    if (site.with) hand_site(*site.with, element);
  }

  void posture(const WrittenPosture& posture, WrittenElement& parent) {
    if (!posture.shared.empty()) hand(posture.shared, parent);
    if (posture.split_hands) {
      WrittenElement split;
      split.name = "split_handconfig";
      for (const WrittenHand& one : posture.split)
        hand(one, split);
      parent.children.push_back(std::move(split));
    }
    const bool pair = posture.meeting.has_value();
    if (!pair) places(posture, parent);
    if (pair) {
      WrittenElement element;
      element.name = "handconstellation";
      element.put("contact", posture.meeting->contact);
      if (posture.meeting->dominant) hand_site(*posture.meeting->dominant, element);
      if (posture.meeting->other) {
        if (!posture.meeting->dominant)
          findings_.left_out(posture.meeting->mark, "a constellation names the dominant hand's place first");
        hand_site(*posture.meeting->other, element);
      }
      if (!posture.split_body && posture.body[0]) body_site(*posture.body[0], element);
      parent.children.push_back(std::move(element));
      if (posture.split_body) places(posture, parent);
    }
    if (posture.on_other) hand_site(*posture.on_other, parent);
    if (!posture.use_name.empty()) parent.add("use_locname").put("name", posture.use_name);
  }

  void places(const WrittenPosture& posture, WrittenElement& parent) {
    if (posture.split_body) {
      WrittenElement split;
      split.name = "split_location";
      for (const auto& site : posture.body)
        if (site) body_site(*site, split);
      if (!posture.body[0] && posture.body[1])
        findings_.left_out(posture.mark, "a split location names the dominant hand's place first");
      parent.children.push_back(std::move(split));
    } else if (posture.body[0]) {
      body_site(*posture.body[0], parent);
    }
  }

  void manner(const WrittenMotion& motion, WrittenElement& element) {
    flag(element, "fast", motion.fast);
    flag(element, "slow", motion.slow);
    flag(element, "tense", motion.tense);
    flag(element, "rest", motion.rest);
    flag(element, "halt", motion.halt);
    flag(element, "alternating", motion.alternating);
    flag(element, "fused", motion.fused);
    if (motion.pace != 1) element.put("speed", decimal(motion.pace));
  }

  void motion(const WrittenMotion& motion, WrittenElement& parent) {
    static constexpr std::array<std::string_view, 11> kNames = {
        "directedmotion", "circularmotion", "wristmotion",  "fingerplay", "changeposture", "nomotion",
        "seq_motion",     "par_motion",     "split_motion", "tgt_motion", "rpt_motion"};
    WrittenElement element;
    element.name = kNames[static_cast<size_t>(motion.kind)];
    if (motion.kind == Kind::kDirected) {
      element.put("direction", motion.direction);
      element.put("second_direction", motion.second_direction);
      element.put("curve", motion.curve);
      element.put("curve_size", motion.curve_size);
    } else if (motion.kind == Kind::kCircular) {
      element.put("axis", motion.direction);
      element.put("second_axis", motion.second_direction);
      element.put("start", motion.clock_start);
      element.put("end", motion.clock_end);
      flag(element, "clockplus", motion.extra_turns > 0);
      flag(element, "second_clockplus", motion.extra_turns > 1);
      if (motion.extra_turns > 2) findings_.left_out(motion.mark, "more than two further turns have no attributes");
    } else if (motion.kind == Kind::kWrist) {
      element.put("motion", motion.wrist);
    } else if (motion.kind == Kind::kFingerplay) {
      element.put("digits", motion.digits);
    } else if (motion.kind == Kind::kRepeat) {
      element.put("repetition", motion.repetition);
      element.put("second_repetition", motion.second_repetition);
      element.put("repetition_incrdecr", motion.repetition_growth);
      element.put("repetition_incrdecr_size", motion.repetition_growth_size);
      element.put("repetition_baseshift", motion.shift);
      element.put("baseshift_size", motion.shift_size);
    }
    const bool path = motion.kind == Kind::kDirected || motion.kind == Kind::kCircular;
    if (path || motion.kind == Kind::kWrist) element.put("size", motion.size);
    if (path) {
      element.put("second_size", motion.second_size);
      element.put("zigzag_style", motion.waviness);
      element.put("zigzag_size", motion.waviness_size);
      element.put("zigzag_incrdecr", motion.waviness_growth);
      element.put("ellipse_direction", motion.ellipse);
      element.put("ellipse_size", motion.ellipse_size);
      element.put("incrdecr", motion.growth);
      element.put("incrdecr_size", motion.growth_size);
    }
    manner(motion, element);
    for (const WrittenPosture& place : motion.brushed)
      posture(place, element);
    if (motion.brushing && motion.brushed.empty())
      findings_.left_out(motion.mark, "brushing without a place has no attribute");
    for (const WrittenMotion& part : motion.parts)
      this->motion(part, element);
    if (motion.kind == Kind::kTarget) {
      // A change of posture needs a movement that carries it.
      if (motion.parts.empty()) element.add("changeposture");
      posture(motion.target, element);
    }
    parent.children.push_back(std::move(element));
  }

  Findings& findings_;
};

}  // namespace

void write_gestural(const WrittenSign& written, WrittenElement& sign, Findings& findings) {
  GesturalWriter writer(findings);
  // The parts of a compound lie in one manual part.
  if (written.parts.size() > 1) {
    WrittenElement compound;
    compound.name = "sign_manual";
    for (const WrittenPart& part : written.parts)
      writer.part(part, compound);
    sign.children.push_back(std::move(compound));
  } else {
    for (const WrittenPart& part : written.parts)
      writer.part(part, sign);
  }
}

}  // namespace auslan::notation
