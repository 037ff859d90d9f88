// SPDX-License-Identifier: Apache-2.0
// HamNoSys symbols from the written form: the reverse of token_reader.cpp and token_postures.cpp.
#include "converter.h"
#include "notation/symbols.h"

#include <algorithm>

namespace auslan::notation {
namespace {

using enum SymbolKind;
using Kind = WrittenMotion::Kind;

/// Letters of a direction in any order: "uo" is "ou".
bool same_letters(std::string_view a, std::string_view b) {
  std::string x(a), y(b);
  std::ranges::sort(x);
  std::ranges::sort(y);
  return x == y;
}

class SymbolWriter {
 public:
  SymbolWriter(WrittenElement& manual, Findings& findings) : manual_(manual), findings_(findings) {}

  void part(const WrittenPart& part, bool last) {
    if (part.both_hands) {
      put(part.mirror_lr ? "hamsymmlr" : "hamsymmpar");
      if (part.mirror_ud) put("hamlargemod");
      if (part.mirror_oi) put("hamfingerbendmod");
      if (part.out_of_phase) put("hamalternatingmotion");
    } else if (part.mirror_lr || part.mirror_ud || part.mirror_oi || part.out_of_phase) {
      lost(part.mark, "symmetry of a sign that is not of both hands");
    }
    if (part.literal_space) put("hamnonipsi");
    if (part.non_dominant) put("hamnondominant");
    posture(part.start);
    for (const WrittenMotion& one : part.motions)
      motion(one, {});
    if (last) return;
    // Without a movement a plus would begin the other hand.
    if (part.motions.empty()) put("hamnomotion");
    put("hamplus");
  }

 private:
  void put(std::string_view name) { manual_.add(name); }
  void lost(const Mark& mark, std::string_view what) {
    findings_.left_out(mark, std::string(what) + " cannot be written in HamNoSys symbols");
  }
  /// The symbol of a kind that says the value; nothing for an empty one.
  bool put(SymbolKind kind, std::string_view value, const Mark& mark, std::string_view what) {
    if (value.empty()) return false;
    for (const HamSymbol& symbol : ham_symbols())
      if (symbol.kind == kind && same_letters(symbol.value, value)) {
        put(symbol.name);
        return true;
      }
    lost(mark, std::string(what) + " " + in_quotes(value));
    return false;
  }
  void digits(std::string_view list, const Mark& mark) {
    for (const char digit : list)
      put(kDigit, std::string_view(&digit, 1), mark, "the digit");
  }

  void shape(const WrittenShape& shape, const Mark& mark) {
    const bool grip = shape.base.starts_with("pinch") || shape.base.starts_with("cee");
    put(kHandshape, shape.base, mark, "the handshape");
    if (put(kThumb, shape.thumb, mark, "the thumb")) put(kFingerPart, shape.thumb_contact, mark, "the thumb's contact");
    if (shape.thumb.empty() && !shape.opening.empty())
      put(shape.opening == "tight" ? "hamthumbacrossmod" : "hamthumbopenmod");
    // After a digit a bend is that digit's; before it, digits are spared by it.
    if (!shape.special.empty() && !shape.bend.empty() && !grip) lost(mark, "a bend of chosen digits alone");
    put(kBend, shape.bend, mark, "the bend");
    if (shape.bend.empty() || grip) digits(shape.special, mark);
    if (!shape.bend.empty() && !grip) digits(shape.exempt, mark);
    if (!shape.exempt.empty() && (shape.bend.empty() || grip)) lost(mark, "a digit that no bend spares");
    for (size_t i = 0; i < shape.digit_bend.size(); ++i)
      if (!shape.digit_bend[i].empty()) {
        digits(std::string(1, static_cast<char>('1' + i)), mark);
        put(kBend, shape.digit_bend[i], mark, "the bend");
      }
    if (shape.crossed.size() == 2) {
      digits(shape.crossed.substr(0, 1), mark);
      if (!put(kFingerPart, shape.contact_kind, mark, "the contact")) {
        put("hamfingermidjoint");
        lost(mark, "crossed digits without a place at which they touch");
      }
      digits(shape.crossed.substr(1), mark);
    }
    if (!shape.thumb_between.empty()) {
      put("hambetween");
      digits(shape.thumb_between, mark);
    }
    if (shape.thumb_enclosed) put("hambetween");
    if (!shape.splay.empty()) lost(mark, "the spread of the fingers in numbers");
    if (!shape.opposed.empty()) lost(mark, "the digit that the thumb opposes");
  }

  void letters(SymbolKind kind, const std::string& first, const std::string& second, const Mark& mark,
               std::string_view what) {
    if (!put(kind, first, mark, what) || second.empty()) return;
    put("hambetween");
    if (!put(kind, second, mark, what)) manual_.children.pop_back();
  }

  void hand(const WrittenHand& hand) {
    if (hand.shape) {
      shape(*hand.shape, hand.mark);
      if (hand.second_shape) {
        put("hambetween");
        shape(*hand.second_shape, hand.mark);
      }
    }
    letters(kFingers, hand.fingers, hand.second_fingers, hand.mark, "the finger direction");
    if (hand.palm_absolute && !hand.palm.empty()) lost(hand.mark, "an absolute palm orientation");
    letters(kPalm, hand.palm, hand.second_palm, hand.mark, "the palm orientation");
  }

  static std::string_view side_symbol(std::string_view side) {
    return side.ends_with("beside") ? "hamlrbeside" : "hamlrat";
  }
  static bool is_left(std::string_view side) { return side.starts_with("left"); }
  static bool is_right(std::string_view side) { return side.starts_with("right"); }

  void hand_site(const WrittenHandSite& site) {
    if (!site.second_part.empty() || !site.second_digits.empty()) lost(site.mark, "midway between places on a hand");
    if (!site.with.empty()) lost(site.mark, "the part of the moving hand at a place on the other");
    if (is_left(site.side)) put(side_symbol(site.side));
    digits(site.digits, site.mark);
    const bool on_digit = std::ranges::any_of(ham_symbols(), [&site](const HamSymbol& symbol) {
      return symbol.kind == kFingerPart && symbol.value == site.part;
    });
    put(on_digit ? kFingerPart : kHandSite, site.part, site.mark, "the place");
    if (is_right(site.side)) put(side_symbol(site.side));
    if (site.side == "palmar") put("hampalm");
    if (site.side == "dorsal" || site.side == "back" || site.behind) put("hamhandback");
    if (site.side == "radial") put("hamthumbside");
    if (site.side == "ulnar") put("hampinkyside");
  }

  void body_place(const std::string& location, const std::string& side, const Mark& mark) {
    if (is_left(side)) put(side_symbol(side));
    if (location.empty()) {
      put("hamneutralspace");
    } else {
      const bool on_arm = std::ranges::any_of(ham_symbols(), [&location](const HamSymbol& symbol) {
        return symbol.kind == kHandSite && symbol.value == location;
      });
      put(on_arm ? kHandSite : kBody, location, mark, "the place");
    }
    if (is_right(side)) put(side_symbol(side));
  }

  void body_site(const WrittenBodySite& site) {
    if (site.on_hand) {
      hand_site(*site.on_hand);
      put(kContact, site.on_hand->contact, site.mark, "the contact");
      return;
    }
    if (!site.name.empty()) lost(site.mark, "the name of a place");
    const bool touch_with = site.with && !site.contact.empty();
    if (site.with && !touch_with) hand_site(*site.with);
    body_place(site.location, site.side, site.mark);
    if (!site.second_location.empty()) {
      put("hambetween");
      body_place(site.second_location, site.second_side, site.mark);
    }
    if (site.behind) put("hambehind");
    if (touch_with) {
      put("hamseqbegin");
      put(kContact, site.contact, site.mark, "the contact");
      hand_site(*site.with);
      put("hamseqend");
    } else {
      put(kContact, site.contact, site.mark, "the contact");
    }
  }

  /// Two halves in a bracket.
  template <typename Write>
  void both(Write write) {
    put("hamparbegin");
    write(0);
    put("hamplus");
    write(1);
    put("hamparend");
  }

  void posture(const WrittenPosture& posture) {
    hand(posture.shared);
    if (posture.split_hands) both([&](size_t i) { hand(posture.split[i]); });
    if (posture.meeting) {
      const WrittenMeeting& meeting = *posture.meeting;
      if (meeting.dominant || meeting.other)
        both([&](size_t i) {
          if (const auto& site = i == 0 ? meeting.dominant : meeting.other) hand_site(*site);
        });
      if (!put(kContact, meeting.contact, meeting.mark, "the contact") && !meeting.dominant)
        lost(meeting.mark, "a constellation without places and contact");
    }
    if (posture.split_body) {
      both([&](size_t i) {
        if (posture.body[i]) body_site(*posture.body[i]);
      });
    } else if (posture.body[0]) {
      body_site(*posture.body[0]);
    }
    if (posture.on_other) {
      hand_site(*posture.on_other);
      put(kContact, posture.on_other->contact, posture.mark, "the contact");
    }
    if (!posture.use_name.empty()) lost(posture.mark, "the use of a named place");
  }

  /// What a bracket round a movement has of its own, given to the movement.
  struct Manner {
    bool fast = false, slow = false, tense = false, rest = false, halt = false, alternating = false;
    Manner with(const WrittenMotion& motion) const {
      return {fast || motion.fast, slow || motion.slow, tense || motion.tense,
              rest || motion.rest, halt || motion.halt, alternating || motion.alternating};
    }
  };
  void manner(const Manner& manner) {
    if (manner.fast) put("hamfast");
    if (manner.slow) put("hamslow");
    if (manner.tense) put("hamtense");
    if (manner.rest) put("hamrest");
    if (manner.halt) put("hamhalt");
    if (manner.alternating) put("hamalternatingmotion");
  }

  void modifiers(const WrittenMotion& motion, const Manner& own) {
    const Mark& mark = motion.mark;
    put(kSize, motion.size, mark, "the size");
    if (!motion.second_size.empty()) {
      put("hambetween");
      put(kSize, motion.second_size, mark, "the size");
    }
    put(kClock, motion.clock_start, mark, "the start");
    if (!motion.clock_end.empty() && motion.clock_start.empty()) put("hamclocku");
    put(kClock, motion.clock_end, mark, "the end");
    for (int i = 0; i < std::min(motion.extra_turns, 8); ++i)
      put("hamclockfull");
    if (put(kArc, motion.curve, mark, "the curve")) put(kSize, motion.curve_size, mark, "the size");
    if (put(kEllipse, motion.ellipse, mark, "the ellipse")) put(kSize, motion.ellipse_size, mark, "the size");
    if (put(kGrowth, motion.growth, mark, "the growth")) put(kSize, motion.growth_size, mark, "the size");
    if (put(kWaviness, motion.waviness, mark, "the waves")) put(kSize, motion.waviness_size, mark, "the size");
    if (!motion.waviness_growth.empty()) lost(mark, "the growth of waves");
    manner(own);
    if (motion.brushing) put("hambrushing");
    if (!motion.brushed.empty()) lost(mark, "the place that is brushed");
    if (motion.pace != 1) lost(mark, "a speed in numbers");
  }

  void group(const std::vector<WrittenMotion>& parts, std::string_view begin, std::string_view end, const Manner& own) {
    put(begin);
    for (const WrittenMotion& part : parts)
      motion(part, own);
    put(end);
  }

  void target(const WrittenMotion& motion, const Manner& own) {
    const bool change = motion.parts.empty() || (motion.parts.size() == 1 && motion.parts[0].kind == Kind::kChange);
    if (change) {
      put("hamreplace");
      manner(motion.parts.empty() ? own : own.with(motion.parts[0]));
      return posture(motion.target);
    }
    const bool place_only = motion.target.shared.empty() && !motion.target.split_hands && motion.parts.size() == 1 &&
                            !motion.target.empty();
    if (place_only) {
      this->motion(motion.parts[0], own);
      return posture(motion.target);
    }
    // At the same time, so that both end together.
    put("hamparbegin");
    if (motion.parts.size() == 1) {
      this->motion(motion.parts[0], own);
    } else {
      group(motion.parts, "hamseqbegin", "hamseqend", own);
    }
    put("hamreplace");
    posture(motion.target);
    put("hamparend");
  }

  void repeat(const WrittenMotion& motion, const Manner& outer) {
    // What alternates does so in its repetition.
    Manner inner = outer;
    inner.fast = inner.fast || motion.fast;
    inner.slow = inner.slow || motion.slow;
    inner.tense = inner.tense || motion.tense;
    inner.rest = inner.rest || motion.rest;
    inner.halt = inner.halt || motion.halt;
    if (motion.parts.size() == 1) {
      this->motion(motion.parts[0], inner);
    } else {
      group(motion.parts, "hamseqbegin", "hamseqend", inner);
    }
    put(kRepeat, motion.repetition, motion.mark, "the repetition");
    if (motion.alternating) put("hamalternatingmotion");
    if (!motion.second_repetition.empty()) lost(motion.mark, "a repetition between two kinds");
    if (!motion.repetition_growth.empty()) lost(motion.mark, "the growth of a repetition");
    if (!motion.shift.empty()) lost(motion.mark, "the shift of a repetition");
  }

  void motion(const WrittenMotion& motion, const Manner& outer) {
    const Manner own = outer.with(motion);
    switch (motion.kind) {
      case Kind::kDirected:
      case Kind::kCircular:
        letters(motion.kind == Kind::kDirected ? kMove : kCircle, motion.direction, motion.second_direction,
                motion.mark, "the direction");
        return modifiers(motion, own);
      case Kind::kWrist:
        put(kWrist, motion.wrist, motion.mark, "the wrist movement");
        return modifiers(motion, own);
      case Kind::kFingerplay:
        put("hamfingerplay");
        digits(motion.digits, motion.mark);
        return modifiers(motion, own);
      case Kind::kChange:
      case Kind::kNothing:
        put("hamnomotion");
        return manner(own);
      case Kind::kSequence:
        return group(motion.parts, motion.fused ? "hamfusionbegin" : "hamseqbegin",
                     motion.fused ? "hamfusionend" : "hamseqend", own);
      case Kind::kParallel:
        return group(motion.parts, "hamparbegin", "hamparend", own);
      case Kind::kSplit:
        return both([&](size_t i) {
          if (i < motion.parts.size()) this->motion(motion.parts[i], own);
        });
      case Kind::kTarget:
        return target(motion, own);
      case Kind::kRepeat:
        return repeat(motion, outer);
    }
  }

  WrittenElement& manual_;
  Findings& findings_;
};

}  // namespace

void write_symbols(const WrittenSign& written, WrittenElement& sign, Findings& findings) {
  WrittenElement manual;
  manual.name = "hamnosys_manual";
  SymbolWriter writer(manual, findings);
  for (size_t i = 0; i < written.parts.size(); ++i)
    writer.part(written.parts[i], i + 1 == written.parts.size());
  sign.children.push_back(std::move(manual));
}

}  // namespace auslan::notation
