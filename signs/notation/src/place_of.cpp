// SPDX-License-Identifier: Apache-2.0
#include "place_of.h"

#include "phonology/vocabulary.h"

#include <algorithm>
#include <array>

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
  double x = 0, y = 0;    ///< metres from the location
  bool paired = false;    ///< the location lies on the articulating side by itself
  bool trunk = false;     ///< without contact: signing space at `above`
  double above = 0;       ///< height over the middle of signing space
  std::string_view loss;  ///< what the model calls it, where it is coarser
};

constexpr std::array<BodyPlace, 28> kPlaces = {{
    {"head", Location::kFace, 0, 0, false, false, 0, ""},
    {"headtop", Location::kTopHead, 0, 0, false, false, 0, ""},
    {"forehead", Location::kForehead, 0, 0, false, false, 0, ""},
    {"eyebrows", Location::kForehead, 0, -0.025, false, false, 0, "the lower forehead"},
    {"eyes", Location::kEye, 0, 0, true, false, 0, ""},
    {"uppereyelid", Location::kEye, 0, 0.006, true, false, 0, "the eye"},
    {"lowereyelid", Location::kEye, 0, -0.006, true, false, 0, "the eye"},
    {"nose", Location::kNose, 0, 0, false, false, 0, ""},
    {"nostrils", Location::kNose, 0, -0.008, false, false, 0, "the nose"},
    {"ear", Location::kEar, 0, 0, true, false, 0, ""},
    {"earlobe", Location::kEar, 0, -0.025, true, false, 0, "the ear"},
    {"cheek", Location::kCheek, 0, 0, true, false, 0, ""},
    {"lips", Location::kMouth, 0, 0, false, false, 0, ""},
    {"upperlip", Location::kMouth, 0, 0.008, false, false, 0, "the mouth"},
    {"lowerlip", Location::kMouth, 0, -0.008, false, false, 0, "the mouth"},
    {"tongue", Location::kMouth, 0, 0, false, false, 0, "the mouth"},
    {"teeth", Location::kMouth, 0, 0, false, false, 0, "the mouth"},
    {"upperteeth", Location::kMouth, 0, 0.005, false, false, 0, "the mouth"},
    {"lowerteeth", Location::kMouth, 0, -0.005, false, false, 0, "the mouth"},
    {"chin", Location::kChin, 0, 0, false, false, 0, ""},
    {"underchin", Location::kChin, 0, -0.02, false, false, 0, "the chin"},
    {"neck", Location::kNeck, 0, 0, false, false, 0, ""},
    {"shouldertop", Location::kShoulder, 0, 0.02, true, true, 0.25, ""},
    {"shoulders", Location::kChest, 0, 0.09, false, true, 0.20, "the upper chest"},
    {"chest", Location::kChest, 0, 0, false, true, 0.08, ""},
    {"stomach", Location::kStomach, 0, 0, false, true, -0.09, ""},
    {"belowstomach", Location::kStomach, 0, -0.08, false, true, -0.18, "the lower stomach"},
    {"neutralspace", Location::kNeutral, 0, 0, false, true, 0.04, ""},
}};

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
    findings.warning(mark,
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
    place_in_space(spot, x, neck_space ? 0.27 : place.above, depth);
    return spot;
  }
  spot.location = place.location;
  spot.offset = Vec3(place.x, place.y, 0);
  if (!place.loss.empty())
    findings.warning(site.mark, "the place " + in_quotes(place.name) + " is carried as " + std::string(place.loss) +
                                    " (" + std::string(to_name(place.location)) + ")");
  if (place.trunk) {
    // On the trunk itself.
    if (place.location == Location::kNeutral) {
      findings.warning(site.mark, "neutral space cannot be touched; the hand stays before the chest");
      place_in_space(spot, step_metres(steps, kAtStep, kBesideStep), place.above, kUsualDepth);
      return spot;
    }
    spot.contact = ContactKind::kTouch;
    if (place.location == Location::kShoulder || place.name == "shoulders") {
      if (place.name == "shoulders" && steps != 0) spot.offset = Vec3(0, 0, 0);
      if (steps > 0) spot.location = Location::kContraShoulder;
      if (steps < 0) spot.location = Location::kShoulder;
      if (std::abs(steps) == 2)
        findings.warning(site.mark, "beside the shoulder is carried as on the shoulder (" +
                                        std::string(to_name(spot.location)) + ")");
    } else if (place.name == "chest" && steps > 0) {
      spot.location = Location::kContraChest;
    } else {
      spot.offset.x += step_metres(steps, 0.07, 0.12);
    }
    return spot;
  }
  // On the head.
  const bool sideways = place.location == Location::kEar;
  spot.outward = sideways ? Vec3(-1, 0, 0) : place.location == Location::kTopHead ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  if (place.paired) {
    if (steps > 0) {
      if (sideways) {
        findings.warning(site.mark, "the left " + std::string(place.name) +
                                        " is out of the model's words; signed at the right one (ear)");
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
    findings.warning(site.mark, "the place " + in_quotes(name) + " on the body is not known; signed in neutral space");
    return neutral_spot(left_hand, apart);
  }
  if (site.behind) findings.warning(site.mark, "behind the place " + in_quotes(name) + " is carried as at its front");
  const int steps = side_steps(site.side, left_hand, site.mark, findings);
  Spot spot = right_hand_spot(*place, steps, site, apart, findings);
  if (!site.second_location.empty()) {
    const BodyPlace* second = find_place(site.second_location);
    if (second == nullptr) {
      findings.warning(site.mark, "the second place " + in_quotes(site.second_location) + " is not known; left out");
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
        findings.warning(site.mark, "midway between " + in_quotes(name) + " and " + in_quotes(site.second_location) +
                                        " is carried as the first (" + std::string(to_name(spot.location)) + ")");
      }
    }
  }
  return left_hand ? mirrored(spot) : spot;
}

bool is_arm_site(const std::string& part) {
  return part == "upperarm" || part == "elbow" || part == "elbowinside" || part == "lowerarm";
}

HandPart part_of(const WrittenHandSite& site, Findings& findings) {
  const auto loss = [&](HandPart part) {
    findings.warning(site.mark, "the part " +
                                    in_quotes(site.part + (site.digits.empty() ? "" : " of digit " + site.digits)) +
                                    (site.side.empty() ? "" : ", side " + in_quotes(site.side)) + " is carried as " +
                                    std::string(to_name(part)));
    return part;
  };
  const std::string& part = site.part;
  const std::string& digits = site.digits;
  if (part == "palm") return HandPart::kPalm;
  if (part == "handback") return HandPart::kBack;
  if (part == "thumbside") return HandPart::kRadial;
  if (part == "pinkyside") return HandPart::kUlnar;
  if (part == "wristback" || part == "wristpulse") return site.side.empty() ? HandPart::kWrist : loss(HandPart::kWrist);
  if (part == "thumbball") return loss(HandPart::kPalm);
  if (is_arm_site(part)) return loss(HandPart::kWrist);
  const auto tips = [&digits]() {
    if (digits == "1") return HandPart::kThumbTip;
    if (digits == "2") return HandPart::kIndexTip;
    if (digits == "3") return HandPart::kMiddleTip;
    if (digits == "4") return HandPart::kRingTip;
    if (digits == "5") return HandPart::kLittleTip;
    if (digits == "12" || digits == "21") return HandPart::kThumbIndexTips;
    if (digits == "23" || digits == "32") return HandPart::kIndexMiddleTips;
    return HandPart::kFingertips;
  };
  const bool plain = site.side.empty();
  if (part == "tip") return plain ? tips() : loss(tips());
  if (part == "nail" || part == "pad") return loss(tips());
  if (part == "midjoint")
    return digits == "2" && plain ? HandPart::kIndexMidJoint
           : digits == "2"        ? loss(HandPart::kIndexMidJoint)
           : digits == "1"        ? loss(HandPart::kThumbSide)
                                  : loss(HandPart::kFingers);
  if (part == "base") {
    if (digits == "2")
      return site.side == "dorsal" ? HandPart::kIndexKnuckle
             : plain               ? HandPart::kIndexBase
                                   : loss(HandPart::kIndexBase);
    if (digits == "1") return loss(HandPart::kThumbSide);
    return plain && digits.empty() ? HandPart::kKnuckles : loss(HandPart::kKnuckles);
  }
  if (part == "side") {
    if (digits == "1") return HandPart::kThumbSide;
    if (digits == "2") return HandPart::kIndexSide;
    if (digits == "5") return loss(HandPart::kUlnar);
    return loss(HandPart::kFingers);
  }
  // Digits alone: their length.
  if (part.empty() && digits == "1") return HandPart::kThumbSide;
  if (part.empty() && digits == "2") return HandPart::kIndexSide;
  if (part.empty() && (digits == "23" || digits == "32")) return HandPart::kIndexMiddle;
  if (part.empty() && !digits.empty()) return digits.size() > 1 ? HandPart::kFingers : loss(HandPart::kFingers);
  findings.warning(site.mark, "the part " + in_quotes(part) + " of the hand is not known; the palm is meant");
  return HandPart::kPalm;
}

Location on_other_hand(const WrittenHandSite& site, Findings& findings) {
  const auto loss = [&](Location location) {
    findings.warning(site.mark, "the place " +
                                    in_quotes(site.part + (site.digits.empty() ? "" : " of digit " + site.digits)) +
                                    (site.side.empty() ? "" : ", side " + in_quotes(site.side)) +
                                    " on the other hand is carried as " + std::string(to_name(location)));
    return location;
  };
  const std::string& part = site.part;
  const std::string& digits = site.digits;
  const bool inner = site.side == "palmar" || site.side == "front";
  const bool plain = site.side.empty();
  if (part == "palm") return Location::kOtherPalm;
  if (part == "handback") return Location::kOtherBack;
  if (part == "thumbside") return Location::kOtherRadial;
  if (part == "pinkyside") return Location::kOtherUlnar;
  if (part == "thumbball") return loss(Location::kOtherPalm);
  if (part == "wristpulse") return Location::kOtherWristInner;
  if (part == "wristback")
    return inner                                                   ? Location::kOtherWristInner
           : plain || site.side == "dorsal" || site.side == "back" ? Location::kOtherWristBack
                                                                   : loss(Location::kOtherWristBack);
  if (part == "lowerarm") return inner ? Location::kOtherForearmInner : Location::kOtherForearmBack;
  if (part == "upperarm") return plain ? Location::kUpperArm : loss(Location::kUpperArm);
  if (part == "elbow") return Location::kOtherElbow;
  if (part == "elbowinside") return loss(Location::kOtherElbow);
  const auto digit = [&digits]() {
    if (digits == "1") return Location::kOtherThumb;
    if (digits == "2") return Location::kOtherIndex;
    if (digits == "3") return Location::kOtherMiddle;
    if (digits == "4") return Location::kOtherRing;
    if (digits == "5") return Location::kOtherLittle;
    return Location::kOtherFingertips;
  };
  if (part == "tip") return digits.size() == 1 ? loss(digit()) : Location::kOtherFingertips;
  if (part == "base" && digits.empty()) return loss(Location::kOtherFistTop);
  if (digits.size() == 1 && part.empty()) return digit();
  if (!digits.empty()) return loss(digits.size() == 1 ? digit() : Location::kOtherFingertips);
  if (part == "nail" || part == "pad" || part == "midjoint" || part == "side") return loss(Location::kOtherFingertips);
  findings.warning(site.mark, "the place " + in_quotes(part) + " on the other hand is not known; its palm is meant");
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
  if (word == "interlock" || word == "cross") {
    findings.warning(mark, "the contact " + in_quotes(word) + " is carried as touching");
    return ContactKind::kTouch;
  }
  if (!word.empty() && word != "armextended")
    findings.warning(mark, "the contact " + in_quotes(word) +
                               " is not known (expected touch, close, interlock, cross or armextended)");
  return std::nullopt;
}

}  // namespace auslan::notation
