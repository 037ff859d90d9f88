// SPDX-License-Identifier: Apache-2.0
#include "place_of.h"

#include "phonology/vocabulary.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace auslan::notation {
namespace {

// Distances from the chest for hands in signing space, metres: close, without a mark, at arm's length.
constexpr double kCloseDepth = 0.13, kUsualDepth = 0.22, kFarDepth = 0.42;
// How far a hand stands off a place on the head without a mark, and with "close".
constexpr double kStandOff = 0.08, kCloseStandOff = 0.02;
// The steps to the sides before trunk and head.
constexpr double kAtStep = 0.12, kBesideStep = 0.21;
constexpr double kHeadAtStep = 0.03, kHeadBesideStep = 0.08;
// Two hands without contact keep this far from the middle each.
constexpr double kApart = 0.11;
// The three heights of signing space above its middle one, metres, on a person of usual size.
constexpr double kHighAbove = 0.21, kLowAbove = -0.19;

struct BodyPlace {
  std::string_view name;
  Location location;
  bool paired = false;  ///< the location lies on the articulating side by itself
  bool trunk = false;   ///< without contact: signing space at this height
  Vec3 nominal{0.0};    ///< on a person of usual size, metres from the middle of signing space at the chest; a right
                        ///< hand's side
};

const std::array<BodyPlace, 28> kPlaces = {{
    {"head", Location::kFace, false, false, {0, 0.38, 0.10}},
    {"headtop", Location::kTopHead, false, false, {0, 0.53, 0.02}},
    {"forehead", Location::kForehead, false, false, {0, 0.47, 0.09}},
    {"eyebrows", Location::kEyebrow, true, false, {-0.032, 0.44, 0.09}},
    {"eyes", Location::kEye, true, false, {-0.032, 0.42, 0.09}},
    {"uppereyelid", Location::kEye, true, false, {-0.032, 0.426, 0.09}},
    {"lowereyelid", Location::kEye, true, false, {-0.032, 0.414, 0.09}},
    {"nose", Location::kNose, false, false, {0, 0.38, 0.11}},
    {"nostrils", Location::kNostrils, false, false, {0, 0.37, 0.10}},
    {"ear", Location::kEar, true, false, {-0.075, 0.40, 0.0}},
    {"earlobe", Location::kEarlobe, true, false, {-0.07, 0.375, 0.0}},
    {"cheek", Location::kCheek, true, false, {-0.045, 0.365, 0.07}},
    {"lips", Location::kMouth, false, false, {0, 0.345, 0.10}},
    {"upperlip", Location::kUpperLip, false, false, {0, 0.352, 0.10}},
    {"lowerlip", Location::kLowerLip, false, false, {0, 0.338, 0.10}},
    {"tongue", Location::kTongue, false, false, {0, 0.345, 0.10}},
    {"teeth", Location::kTeeth, false, false, {0, 0.345, 0.10}},
    {"upperteeth", Location::kTeeth, false, false, {0, 0.348, 0.10}},
    {"lowerteeth", Location::kTeeth, false, false, {0, 0.342, 0.10}},
    {"chin", Location::kChin, false, false, {0, 0.31, 0.09}},
    {"underchin", Location::kUnderChin, false, false, {0, 0.30, 0.06}},
    {"neck", Location::kNeck, false, false, {0, 0.27, 0.04}},
    {"shouldertop", Location::kShoulder, true, true, {-0.13, 0.25, 0.0}},
    {"shoulders", Location::kUpperChest, false, true, {0, 0.20, 0.0}},
    {"chest", Location::kChest, false, true, {0, 0.08, 0.0}},
    {"stomach", Location::kStomach, false, true, {0, -0.09, 0.0}},
    {"belowstomach", Location::kLowerStomach, false, true, {0, -0.18, 0.0}},
    {"neutralspace", Location::kNeutral, false, true, {0, 0.04, 0.0}},
}};

/// Where the location's own place is, of which `nominal` may be a part: the eye for an eyelid.
Vec3 nominal_of_location(Location location) {
  for (const BodyPlace& place : kPlaces)
    if (place.location == location && place.name != "uppereyelid" && place.name != "upperteeth") return place.nominal;
  return Vec3(0.0);
}

const BodyPlace* find_place(std::string_view name) {
  const auto found = std::ranges::find(kPlaces, name, &BodyPlace::name);
  return found == kPlaces.end() ? nullptr : &*found;
}

/// -2 right beside, -1 right at, 0, 1 left at, 2 left beside; seen from a left hand the other way round.
int side_steps(const std::string& side, bool left_hand, const Mark& mark, Findings& findings) {
  int steps = 0;
  if (side == "left_beside") {
    steps = 2;
  } else if (side == "left_at") {
    steps = 1;
  } else if (side == "right_at") {
    steps = -1;
  } else if (side == "right_beside") {
    steps = -2;
  } else if (!side.empty() && side != "front") {
    findings.left_out(mark,
                      "the side " + in_quotes(side) + " of a place on the body is not carried; its front is meant");
  }
  return left_hand ? -steps : steps;
}

double step_metres(int steps, double at, double beside) {
  const double size = std::abs(steps) == 2 ? beside : std::abs(steps) == 1 ? at : 0.0;
  return steps < 0 ? -size : size;
}

/// Signing space at a height over its middle: the model's nearest height, the rest as offset.
void place_in_space(Spot& spot, double x, double above, double depth) {
  spot.location = Location::kNeutral;
  double base = 0;
  if (above > 0.5 * kHighAbove) {
    spot.location = Location::kHighNeutral;
    base = kHighAbove;
  } else if (above < 0.5 * kLowAbove) {
    spot.location = Location::kLowNeutral;
    base = kLowAbove;
  }
  spot.offset = Vec3(x, above - base, depth);
  spot.contact.reset();
}

/// From the location's own place to a finer one.
Vec3 finer(const BodyPlace& place) {
  return place.nominal - nominal_of_location(place.location);
}

/// As a right hand's.
Spot right_hand_spot(const BodyPlace& place, int steps, const WrittenBodySite& site, bool apart, Findings& findings) {
  Spot spot;
  const bool touching = site.contact == "touch";
  const bool neck_space = place.location == Location::kNeck && !touching;
  if ((place.trunk || neck_space) && !touching) {
    double x = step_metres(steps, kAtStep, kBesideStep);
    if (place.name == "shouldertop" && steps == 0) x = -kAtStep;
    if (apart && steps == 0) x = -kApart;
    const double depth = site.contact == "close"         ? kCloseDepth
                         : site.contact == "armextended" ? kFarDepth
                                                         : kUsualDepth;
    place_in_space(spot, x, place.nominal.y, depth);
    return spot;
  }
  spot.location = place.location;
  if (!place.trunk) spot.offset = finer(place);
  if (place.trunk) {
    // On the trunk itself.
    if (place.location == Location::kNeutral) {
      findings.warning(site.mark, "neutral space cannot be touched; the hand stays before the chest");
      place_in_space(spot, step_metres(steps, kAtStep, kBesideStep), place.nominal.y, kUsualDepth);
      return spot;
    }
    spot.contact = ContactKind::kTouch;
    if (place.location == Location::kShoulder || place.name == "shoulders") {
      if (place.name == "shoulders" && steps != 0) spot.offset = Vec3(0, 0, 0);
      if (steps > 0) spot.location = Location::kContraShoulder;
      if (steps < 0) spot.location = Location::kShoulder;
      if (std::abs(steps) == 2) spot.offset.x += steps > 0 ? 0.04 : -0.04;
    } else if (place.name == "chest" && steps > 0) {
      spot.location = Location::kContraChest;
    } else {
      spot.offset.x += step_metres(steps, 0.07, 0.12);
    }
    return spot;
  }
  // On the head.
  const bool sideways = place.location == Location::kEar || place.location == Location::kEarlobe;
  spot.outward = sideways                                 ? Vec3(-1, 0, 0)
                 : place.location == Location::kTopHead   ? Vec3(0, 1, 0)
                 : place.location == Location::kUnderChin ? Vec3(0, -1, 0.3)
                                                          : Vec3(0, 0, 1);
  if (place.paired) {
    if (steps > 0) {
      if (sideways) {
        spot.location = Location::kContraEar;
        spot.outward = Vec3(1, 0, 0);
        if (place.name == "earlobe") spot.offset.y -= 0.025;
      } else {
        // The other side of the face, measured from this side's place.
        spot.offset.x += place.location == Location::kCheek ? 0.045 : 0.06;
      }
    }
    if (std::abs(steps) == 2)
      spot.offset.x += steps > 0 ? kHeadBesideStep - kHeadAtStep : kHeadAtStep - kHeadBesideStep;
  } else if (place.name == "head" && steps < 0) {
    spot.location = Location::kSideHead;
    spot.outward = Vec3(-1, 0, 0);
    if (steps == -2) spot.offset.x -= kHeadBesideStep - kHeadAtStep;
  } else if (place.name == "forehead" && steps == -2) {
    spot.location = Location::kTemple;
    spot.offset.x -= kHeadAtStep;
  } else {
    spot.offset.x += step_metres(steps, kHeadAtStep, kHeadBesideStep);
    if (apart && steps == 0) spot.offset.x -= place.location == Location::kTopHead ? 0.05 : 0.07;
  }
  if (touching) {
    spot.contact = ContactKind::kTouch;
    if (std::abs(steps) == 2) spot.contact = ContactKind::kNear;  // beside the skin there is nothing to touch
  } else {
    spot.contact = ContactKind::kNear;
    const double distance = site.contact == "close" ? kCloseStandOff : site.contact == "armextended" ? 0.30 : kStandOff;
    spot.offset += spot.outward * distance;
  }
  return spot;
}

Spot mirrored(Spot spot) {
  spot.offset.x = -spot.offset.x;
  spot.outward.x = -spot.outward.x;
  return spot;
}

}  // namespace

Spot neutral_spot(bool left_hand, bool two_hands) {
  Spot spot;
  place_in_space(spot, two_hands ? -kApart : -0.07, 0.04, kUsualDepth);
  return left_hand ? mirrored(spot) : spot;
}

Spot spot_of(const WrittenBodySite& site, bool left_hand, bool apart, Findings& findings) {
  const std::string name = site.location.empty() ? "neutralspace" : site.location;
  const BodyPlace* place = find_place(name);
  if (place == nullptr) {
    findings.left_out(site.mark, "the place " + in_quotes(name) + " on the body is not known; signed in neutral space");
    return neutral_spot(left_hand, apart);
  }
  const int steps = side_steps(site.side, left_hand, site.mark, findings);
  Spot spot = right_hand_spot(*place, steps, site, apart, findings);
  if (!site.second_location.empty()) {
    const BodyPlace* second = find_place(site.second_location);
    if (second == nullptr) {
      findings.left_out(site.mark, "the second place " + in_quotes(site.second_location) + " is not known; left out");
    } else {
      const int second_steps = side_steps(site.second_side, left_hand, site.mark, findings);
      const Spot other = right_hand_spot(*second, second_steps, site, apart, findings);
      const auto above = [](const Spot& s) {
        return s.offset.y + (s.location == Location::kHighNeutral  ? kHighAbove
                             : s.location == Location::kLowNeutral ? kLowAbove
                                                                   : 0.0);
      };
      if (!spot.contact && !other.contact) {
        place_in_space(spot, 0.5 * (spot.offset.x + other.offset.x), 0.5 * (above(spot) + above(other)),
                       0.5 * (spot.offset.z + other.offset.z));
      } else if (spot.location == other.location) {
        spot.offset = (spot.offset + other.offset) * 0.5;
      } else {
        // Half of the way between them on a person of usual size. In signing space heights count from its middle, and
        // depths from the chest.
        const auto whole = [&above](const BodyPlace& body, const Spot& s) {
          return s.contact ? nominal_of_location(body.location) + s.offset : Vec3(s.offset.x, above(s), s.offset.z);
        };
        const bool first_in_space = !spot.contact;
        const Vec3 between = 0.5 * (whole(*place, spot) + whole(*second, other));
        if (first_in_space) {
          place_in_space(spot, between.x, between.y, between.z);
        } else {
          spot.offset = between - nominal_of_location(place->location);
          // Between the skin and a place that is not touched there is nothing to touch.
          if (!other.contact) spot.contact = ContactKind::kNear;
        }
      }
    }
  }
  if (site.behind) {
    if (!spot.contact) {
      findings.warning(site.mark,
                       "behind " + in_quotes(name) + " is signed beside the body, as far back as an arm goes");
      spot.offset = Vec3(-0.24, spot.offset.y, 0.05);
    } else {
      spot.offset.z -= 0.05;
      spot.contact = ContactKind::kNear;
    }
  }
  return left_hand ? mirrored(spot) : spot;
}

bool is_arm_site(const std::string& part) {
  return part == "upperarm" || part == "elbow" || part == "elbowinside" || part == "lowerarm";
}

namespace {

enum class HandSide { kAny, kPalmar, kDorsal, kRadial, kUlnar };

/// Left and right are the signer's: which side of the hand lies there is a matter of how the hand is held.
HandSide side_of(const WrittenHandSite& site, const HeldHand& hand, Findings& findings) {
  const std::string& side = site.side;
  if (side.empty() || side == "front") return site.behind ? HandSide::kDorsal : HandSide::kAny;
  if (side == "palmar") return HandSide::kPalmar;
  if (side == "dorsal" || side == "back") return HandSide::kDorsal;
  if (side == "radial") return HandSide::kRadial;
  if (side == "ulnar") return HandSide::kUlnar;
  double wish = 0;
  if (side.starts_with("left")) wish = 1;
  if (side.starts_with("right")) wish = -1;
  if (wish == 0) {
    findings.left_out(site.mark, "the side " + in_quotes(side) +
                                     " of a place on the hand is not known and is left out (expected palmar, dorsal, "
                                     "radial, ulnar, left_beside or right_beside)");
    return HandSide::kAny;
  }
  // The thumb's side: on a right hand with the fingers up and the palm away it is the left.
  const double radial = (hand.left_hand ? -1.0 : 1.0) * wish * glm::cross(hand.fingers, hand.palm).x;
  const double palmar = wish * hand.palm.x;
  if (std::abs(radial) + 1e-9 >= std::abs(palmar)) return radial >= 0 ? HandSide::kRadial : HandSide::kUlnar;
  return palmar > 0 ? HandSide::kPalmar : HandSide::kDorsal;
}

/// Of several digits the one in their middle.
int middle_digit(std::string_view digits) {
  std::string sorted(digits);
  std::ranges::sort(sorted);
  return sorted[(sorted.size() - 1) / 2] - '1';
}

/// A place on a digit; none where the part is not one of a digit.
std::optional<DigitSite> digit_site_of(const WrittenHandSite& site, HandSide side) {
  using enum DigitFeature;
  const int digit = site.digits.empty() ? 2 : middle_digit(site.digits);
  const auto by_side = [side](DigitFeature any, DigitFeature palmar, DigitFeature dorsal, DigitFeature radial,
                              DigitFeature ulnar) {
    switch (side) {
      case HandSide::kPalmar:
        return palmar;
      case HandSide::kDorsal:
        return dorsal;
      case HandSide::kRadial:
        return radial;
      case HandSide::kUlnar:
        return ulnar;
      case HandSide::kAny:
        break;
    }
    return any;
  };
  if (site.part == "tip") return DigitSite{digit, by_side(kTip, kTipPad, kNail, kTipRadial, kTipUlnar)};
  if (site.part == "nail") return DigitSite{digit, by_side(kNail, kTipPad, kNail, kTipRadial, kTipUlnar)};
  if (site.part == "pad") return DigitSite{digit, by_side(kTipPad, kTipPad, kNail, kTipRadial, kTipUlnar)};
  if (site.part == "midjoint")
    return DigitSite{digit, by_side(kMidDorsal, kMidPalmar, kMidDorsal, kMidRadial, kMidUlnar)};
  if (site.part == "base")
    return DigitSite{digit, by_side(kBaseDorsal, kBasePalmar, kBaseDorsal, kBaseRadial, kBaseUlnar)};
  if (site.part == "side" || (site.part.empty() && !site.digits.empty()))
    return DigitSite{digit, by_side(kLengthRadial, kLengthPalmar, kLengthDorsal, kLengthRadial, kLengthUlnar)};
  return std::nullopt;
}

void tell_middle(const WrittenHandSite& site, Findings& findings) {
  if (site.digits.size() > 1)
    findings.note(site.mark, "of the digits " + in_quotes(site.digits) + " the middle one is placed");
}

void tell_second(const WrittenHandSite& site, Findings& findings) {
  if (!site.second_part.empty() || !site.second_digits.empty() || !site.second_side.empty())
    findings.warning(site.mark, "midway between two places on a hand is signed at the first of them");
}

}  // namespace

HandPart part_of(const WrittenHandSite& site, const HeldHand& hand, Findings& findings) {
  tell_second(site, findings);
  const HandSide side = side_of(site, hand, findings);
  const std::string& part = site.part;
  const std::string& digits = site.digits;
  if (part == "palm" && digits.empty()) return HandPart::kPalm;
  if (part == "handback" && digits.empty()) return HandPart::kBack;
  if (part == "thumbside") return HandPart::kRadial;
  if (part == "pinkyside") return HandPart::kUlnar;
  if (part == "thumbball") return HandPart::kThumbBall;
  if (part == "wristpulse" || part == "wristback") {
    if (side == HandSide::kRadial) return HandPart::kWristRadial;
    if (side == HandSide::kUlnar) return HandPart::kWristUlnar;
    if (side == HandSide::kPalmar || part == "wristpulse") return HandPart::kWrist;
    return HandPart::kWristBack;
  }
  if (is_arm_site(part)) {
    if (part != "lowerarm")
      findings.warning(site.mark, "the part " + in_quotes(part) + " of the moving arm is placed by the forearm");
    return HandPart::kForearm;
  }
  // The older names, where they say the same.
  if (part == "tip" && side == HandSide::kAny) {
    if (digits == "1") return HandPart::kThumbTip;
    if (digits == "2") return HandPart::kIndexTip;
    if (digits == "3") return HandPart::kMiddleTip;
    if (digits == "4") return HandPart::kRingTip;
    if (digits == "5") return HandPart::kLittleTip;
    if (digits == "12" || digits == "21") return HandPart::kThumbIndexTips;
    if (digits == "23" || digits == "32") return HandPart::kIndexMiddleTips;
    return HandPart::kFingertips;
  }
  if (part == "midjoint" && digits == "2" && side == HandSide::kAny) return HandPart::kIndexMidJoint;
  if (part == "base" && digits.empty()) return HandPart::kKnuckles;
  if (part.empty() && side == HandSide::kAny) {
    if (digits == "1") return HandPart::kThumbSide;
    if (digits == "2") return HandPart::kIndexSide;
    if (digits == "23" || digits == "32") return HandPart::kIndexMiddle;
    if (digits.size() > 2) return HandPart::kFingers;
  }
  // Palm and back after a digit are its sides.
  WrittenHandSite of_digit = site;
  if (part == "palm" || part == "handback") of_digit.part.clear();
  const HandSide turned = part == "palm" ? HandSide::kPalmar : part == "handback" ? HandSide::kDorsal : side;
  if (const auto digit = digit_site_of(of_digit, turned)) {
    tell_middle(site, findings);
    return hand_part(*digit);
  }
  findings.left_out(site.mark, "the part " + in_quotes(part) + " of the hand is not known; the palm is meant");
  return HandPart::kPalm;
}

Location on_other_hand(const WrittenHandSite& site, const HeldHand& hand, Findings& findings) {
  tell_second(site, findings);
  const HandSide side = side_of(site, hand, findings);
  const std::string& part = site.part;
  const std::string& digits = site.digits;
  if (part == "palm" && digits.empty()) return Location::kOtherPalm;
  if (part == "handback" && digits.empty()) return Location::kOtherBack;
  if (part == "thumbside") return Location::kOtherRadial;
  if (part == "pinkyside") return Location::kOtherUlnar;
  if (part == "thumbball") return Location::kOtherThumbBall;
  if (part == "wristpulse" || part == "wristback") {
    if (side == HandSide::kRadial) return Location::kOtherWristRadial;
    if (side == HandSide::kUlnar) return Location::kOtherWristUlnar;
    if (side == HandSide::kPalmar || part == "wristpulse") return Location::kOtherWristInner;
    return Location::kOtherWristBack;
  }
  if (part == "lowerarm") return side == HandSide::kPalmar ? Location::kOtherForearmInner : Location::kOtherForearmBack;
  if (part == "upperarm") return Location::kUpperArm;
  if (part == "elbow") return side == HandSide::kPalmar ? Location::kOtherElbowInside : Location::kOtherElbow;
  if (part == "elbowinside") return Location::kOtherElbowInside;
  if (part == "tip" && digits.size() != 1) return Location::kOtherFingertips;
  if (part == "base" && digits.empty()) return Location::kOtherFistTop;
  if (part.empty() && side == HandSide::kAny) {
    if (digits == "1") return Location::kOtherThumb;
    if (digits == "2") return Location::kOtherIndex;
    if (digits == "3") return Location::kOtherMiddle;
    if (digits == "4") return Location::kOtherRing;
    if (digits == "5") return Location::kOtherLittle;
  }
  WrittenHandSite of_digit = site;
  if (part == "palm" || part == "handback") of_digit.part.clear();
  const HandSide turned = part == "palm" ? HandSide::kPalmar : part == "handback" ? HandSide::kDorsal : side;
  if (const auto digit = digit_site_of(of_digit, turned)) {
    tell_middle(site, findings);
    return other_location(*digit);
  }
  findings.left_out(site.mark, "the place " + in_quotes(part) + " on the other hand is not known; its palm is meant");
  return Location::kOtherPalm;
}

HandPart facing_part(const Handshape& shape, const Vec3& fingers, const Vec3& palm, const Vec3& towards,
                     bool left_hand) {
  if (shape.selected == "index") return HandPart::kIndexTip;
  if (shape.selected == "middle") return HandPart::kMiddleTip;
  if (shape.selected == "ring") return HandPart::kRingTip;
  if (shape.selected == "little") return HandPart::kLittleTip;
  if (shape.selected == "thumb") return HandPart::kThumbTip;
  if (shape.selected == "index+middle") return HandPart::kIndexMiddleTips;
  if (shape.selected == "index+thumb") return HandPart::kThumbIndexTips;
  // The thumb's side: on a right hand with the fingers up and the palm away it is the left.
  Vec3 radial = glm::cross(fingers, palm);
  if (left_hand) radial = -radial;
  const bool closed = shape.selected == "none";
  const double on_palm = glm::dot(palm, towards);
  HandPart best = closed ? HandPart::kKnuckles : HandPart::kPalm;
  double most = closed ? on_palm - 0.2 : on_palm + 0.1;
  const auto offer = [&](HandPart part, double value) {
    if (value > most) {
      most = value;
      best = part;
    }
  };
  offer(closed ? HandPart::kKnuckles : HandPart::kFingertips, glm::dot(fingers, towards));
  offer(closed ? HandPart::kFistThumbSide : HandPart::kRadial, glm::dot(radial, towards));
  offer(closed ? HandPart::kFistUlnar : HandPart::kUlnar, -glm::dot(radial, towards));
  offer(HandPart::kBack, -on_palm);
  if (closed && on_palm > 0.5 && most <= on_palm) best = HandPart::kFingers;
  return best;
}

std::optional<ContactKind> contact_of(const std::string& word, const Mark& mark, Findings& findings) {
  if (word == "touch") return ContactKind::kTouch;
  if (word == "close") return ContactKind::kNear;
  if (word == "interlock") return ContactKind::kInterlock;
  if (word == "cross") return ContactKind::kCross;
  if (!word.empty() && word != "armextended")
    findings.left_out(mark, "the contact " + in_quotes(word) +
                                " is not known (expected touch, close, interlock, cross or armextended)");
  return std::nullopt;
}

}  // namespace auslan::notation
