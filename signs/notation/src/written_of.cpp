// SPDX-License-Identifier: Apache-2.0
#include "written_of.h"

#include "direction.h"
#include "handshape_of.h"
#include "kinematics/rotation.h"
#include "notation/symbols.h"
#include "phonology/vocabulary.h"
#include "place_of.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace auslan::notation {
namespace {

using Kind = WrittenMotion::Kind;

constexpr std::array<std::string_view, 8> kAround = {"u", "ur", "r", "dr", "d", "dl", "l", "ul"};
// What differs by less is the same place, metres, and the same handshape, degrees of a joint on average.
constexpr double kSamePlace = 0.025, kSameShape = 4.0;

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

std::string in_cm(double metres) {
  return std::to_string(static_cast<int>(std::lround(metres * 100.0))) + " cm";
}

// ---------------------------------------------------------------------------------------------------------------------
// Handshapes

struct ShapeChoice {
  WrittenShape written;
  Handshape read;
};

/// Everything that base forms, thumbs, bends and chosen digits say, as it is read.
const std::vector<ShapeChoice>& shape_choices() {
  static const std::vector<ShapeChoice> all = [] {
    std::vector<ShapeChoice> made;
    const auto offer = [&made](WrittenShape shape) {
      Findings findings;
      Handshape read = handshape_of(shape, std::nullopt, {}, findings);
      if (nothing_left_out(findings.take())) made.push_back({std::move(shape), std::move(read)});
    };
    for (const HamSymbol& base : ham_symbols()) {
      if (base.kind != SymbolKind::kHandshape) continue;
      for (const std::string_view thumb : {"", "out", "across", "opposed"})
        for (const std::string_view bend : {"", "bent", "round", "hooked", "dblbent", "dblhooked", "halfbent"}) {
          // Bent fists are read as bent flat hands, which say it better.
          if (base.value == "fist" && !bend.empty()) continue;
          WrittenShape shape;
          shape.base = base.value;
          shape.thumb = thumb;
          shape.bend = bend;
          offer(shape);
          if (!bend.empty() || (base.value != "finger2" && base.value != "finger23" && base.value != "finger2345" &&
                                base.value != "pinch12" && base.value != "pinch12open"))
            continue;
          // Other digits than the base form's: each set of fingers, with the thumb and without.
          for (unsigned set = 1; set < 32; ++set) {
            shape.special.clear();
            for (unsigned digit = 0; digit < 5; ++digit)
              if ((set >> digit & 1U) != 0) shape.special += static_cast<char>('1' + digit);
            offer(shape);
          }
        }
    }
    return made;
  }();
  return all;
}

/// Degrees of a joint on average.
double apart(const Handshape& a, const Handshape& b) {
  double sum = 0.0;
  for (size_t i = 0; i < 4; ++i) {
    const FingerAngles &x = a.fingers[i], &y = b.fingers[i];
    for (const double d : {x.mcp - y.mcp, x.pip - y.pip, x.dip - y.dip, x.abduction - y.abduction})
      sum += d * d;
  }
  const ThumbAngles &s = a.thumb, &t = b.thumb;
  for (const double d : {s.radial_abduction - t.radial_abduction, s.palmar_abduction - t.palmar_abduction,
                         90.0 * (s.opposition - t.opposition), s.mp - t.mp, s.ip - t.ip})
    sum += d * d;
  return std::sqrt(sum / 21.0);
}

// ---------------------------------------------------------------------------------------------------------------------
// Directions

/// Letters of one of the 26 directions, and what they are read as; `second` where only the middle of two is near.
struct Letters {
  std::string first, second;
  Vec3 read{0.0, 1.0, 0.0};
};

std::vector<Letters> plain_directions(bool corners) {
  std::vector<Letters> all;
  for (const std::string_view up : {"u", "", "d"})
    for (const std::string_view side : {"l", "", "r"})
      for (const std::string_view depth : {"o", "", "i"}) {
        const std::string letters = std::string(up) + std::string(side) + std::string(depth);
        if (letters.empty() || (letters.size() == 3 && !corners)) continue;
        all.push_back({letters, "", *vector_of_letters(letters)});
      }
  return all;
}

Letters letters_of(const Vec3& direction, NotationForm form) {
  const bool corners = form == NotationForm::kGestural;
  const std::vector<Letters> plain = plain_directions(corners);
  Letters best = plain.front();
  const auto offer = [&](const Letters& letters) {
    if (glm::dot(letters.read, direction) > glm::dot(best.read, direction) + 1e-9) best = letters;
  };
  for (const Letters& letters : plain)
    offer(letters);
  if (angle_deg(best.read, direction) < 5.0) return best;
  for (size_t i = 0; i < plain.size(); ++i)
    for (size_t j = i + 1; j < plain.size(); ++j)
      if (glm::dot(plain[i].read, plain[j].read) > -0.5)
        offer({plain[i].first, plain[j].first, midway(plain[i].read, plain[j].read)});
  return best;
}

// ---------------------------------------------------------------------------------------------------------------------
// Places

/// Every way to name a place on a hand.
const std::vector<WrittenHandSite>& hand_sites() {
  static const std::vector<WrittenHandSite> all = [] {
    std::vector<WrittenHandSite> made;
    for (const std::string_view part :
         {"palm", "handback", "thumbside", "pinkyside", "thumbball", "wristpulse", "wristback", "lowerarm", "elbow",
          "elbowinside", "upperarm", "tip", "nail", "pad", "midjoint", "base", "side", ""})
      for (const std::string_view digits : {"", "1", "2", "3", "4", "5", "12", "23", "2345"})
        for (const std::string_view side : {"", "palmar", "dorsal", "radial", "ulnar"}) {
          WrittenHandSite site;
          site.part = part;
          site.digits = digits;
          site.side = side;
          if (!site.part.empty() || !site.digits.empty()) made.push_back(std::move(site));
        }
    return made;
  }();
  return all;
}

template <class Read, class Value>
std::optional<WrittenHandSite> find_site(const Read& read, const Value& wanted) {
  for (const WrittenHandSite& site : hand_sites()) {
    Findings findings;
    if (read(site, findings) == wanted && findings.take().empty()) return site;
  }
  return std::nullopt;
}

std::optional<WrittenHandSite> site_of_part(HandPart part) {
  // Parts that other words stand for.
  static const std::map<HandPart, HandPart> same = {{HandPart::kFistThumbSide, HandPart::kRadial},
                                                    {HandPart::kFistUlnar, HandPart::kUlnar},
                                                    {HandPart::kIndexKnuckle, HandPart::kIndexMidJoint},
                                                    {HandPart::kThumbWeb, HandPart::kRadial},
                                                    {HandPart::kIndexPad, HandPart::kIndexSide}};
  const auto read = [](const WrittenHandSite& site, Findings& findings) { return part_of(site, {}, findings); };
  if (auto found = find_site(read, part)) return found;
  const auto other = same.find(part);
  return other == same.end() ? std::nullopt : find_site(read, other->second);
}

std::optional<WrittenHandSite> site_of_location(Location location) {
  const auto read = [](const WrittenHandSite& site, Findings& findings) { return on_other_hand(site, {}, findings); };
  return find_site(read, location);
}

std::string contact_word(ContactKind kind) {
  switch (kind) {
    case ContactKind::kNear:
      return "close";
    case ContactKind::kInterlock:
      return "interlock";
    case ContactKind::kCross:
      return "cross";
    default:
      return "touch";
  }
}

/// A place in signing space from its middle; nothing for one on the body. Before the trunk, not touching it, is signing
/// space, too.
std::optional<Vec3> in_space(Location location, const Vec3& offset, bool left_hand, bool touches) {
  const double own = left_hand ? 1.0 : -1.0;
  constexpr double kBefore = 0.05;  // metres
  if (!touches) {
    switch (location) {
      case Location::kShoulder:
        return offset + Vec3(own * 0.13, 0.25, kBefore);
      case Location::kContraShoulder:
        return offset + Vec3(own * -0.13, 0.25, kBefore);
      case Location::kUpperChest:
        return offset + Vec3(0.0, 0.20, kBefore);
      case Location::kChest:
        return offset + Vec3(0.0, 0.08, kBefore);
      case Location::kContraChest:
        return offset + Vec3(own * -0.1, 0.08, kBefore);
      case Location::kStomach:
        return offset + Vec3(0.0, -0.09, kBefore);
      case Location::kLowerStomach:
        return offset + Vec3(0.0, -0.18, kBefore);
      case Location::kWaist:
        return offset + Vec3(own * 0.12, -0.18, kBefore);
      case Location::kThigh:
        return offset + Vec3(own * 0.12, -0.30, kBefore);
      default:
        break;
    }
  }
  switch (location) {
    case Location::kNeutral:
      return offset;
    case Location::kHighNeutral:
      return offset + Vec3(0.0, 0.21, 0.0);
    case Location::kLowNeutral:
      return offset + Vec3(0.0, -0.19, 0.0);
    case Location::kIpsiSpace:
      return offset + Vec3(own * 0.2, 0.0, 0.0);
    case Location::kContraSpace:
      return offset + Vec3(own * -0.2, 0.0, 0.0);
    default:
      return std::nullopt;
  }
}

/// Of places that the notation has no word for, or none that can be touched, the nearest that it has; and how far from
/// there they are, metres, of a right hand.
std::pair<Location, Vec3> written_place(Location location, bool touches) {
  switch (location) {
    case Location::kCheekbone:
      return {Location::kCheek, Vec3(0.0, 0.02, 0.0)};
    case Location::kTemple:
      if (touches) return {Location::kForehead, Vec3(-0.06, -0.03, 0.0)};
      break;
    case Location::kSideHead:
      if (touches) return {Location::kEar, Vec3(0.0, 0.06, 0.0)};
      break;
    case Location::kWaist:
    case Location::kThigh:
      if (touches) return {Location::kLowerStomach, Vec3(-0.12, 0.0, 0.0)};
      break;
    default:
      break;
  }
  return {location, Vec3(0.0)};
}

struct PlaceChoice {
  WrittenBodySite written;
  Spot read;
  double off = 1e9;  ///< metres
};

/// The place on or before the body that is read most nearly as this posture's.
PlaceChoice place_of(const Posture& posture, bool left_hand, bool apart) {
  const bool touches = posture.contact && posture.contact->kind != ContactKind::kNear;
  const auto [location, beside] = written_place(posture.location, touches);
  const Vec3 offset = posture.offset + (left_hand ? Vec3(-beside.x, beside.y, beside.z) : beside);
  const auto wanted = in_space(location, offset, left_hand, touches);
  PlaceChoice best;
  std::vector<std::string_view> names = {"neutralspace"};
  for (const HamSymbol& symbol : ham_symbols())
    if (symbol.kind == SymbolKind::kBody) names.push_back(symbol.value);
  for (const std::string_view name : names)
    for (const std::string_view side : {"", "left_at", "right_at", "left_beside", "right_beside"})
      for (const std::string_view contact : {"", "close", "touch", "armextended"}) {
        WrittenBodySite site;
        site.location = name;
        site.side = side;
        site.contact = contact;
        Findings findings;
        const Spot spot = spot_of(site, left_hand, apart, findings);
        if (!findings.take().empty()) continue;
        const bool spot_touches = spot.contact && *spot.contact != ContactKind::kNear;
        double off = 1e9;
        if (wanted) {
          const auto read = in_space(spot.location, spot.offset, left_hand, false);
          if (read && !spot.contact) off = length(*read - *wanted);
        } else if (spot.location == location && spot_touches == touches) {
          // On the skin only what leads along it counts; a place that is near may be nearer.
          Vec3 apart_by = spot.offset - offset;
          const Vec3 out = unit(spot.outward);
          if (touches) apart_by -= out * glm::dot(apart_by, out);
          off = length(apart_by);
        }
        if (off < best.off - 1e-9) best = {site, spot, off};
      }
  return best;
}

// ---------------------------------------------------------------------------------------------------------------------
// The sign

class Writer {
 public:
  Writer(const Sign& sign, std::span<const Handshape> handshapes, NotationForm form, Findings& findings)
      : sign_(sign), handshapes_(handshapes), form_(form), findings_(findings) {}

  WrittenSign run() {
    WrittenSign written;
    written.gloss = sign_.gloss;
    if (sign_.dominant.empty()) return written;
    WrittenPart part;
    mirrored_ = is_mirrored(sign_.handedness);
    has_base_ = sign_.handedness == Handedness::kDominantBase && !sign_.non_dominant.empty();
    part.both_hands = mirrored_ || has_base_;
    part.mirror_lr = mirrored_;
    part.out_of_phase = sign_.handedness == Handedness::kAlternating;
    part.start = posture(0);
    size_t at = 0;
    for (size_t i = 0; i < sign_.movements.size();) {
      const Movement& first = sign_.movements[i];
      std::vector<const Movement*> together;
      for (; i < sign_.movements.size() && sign_.movements[i].from == first.from && sign_.movements[i].to == first.to;
           ++i)
        together.push_back(&sign_.movements[i]);
      const auto from = static_cast<size_t>(std::max(0, first.from)), to = static_cast<size_t>(std::max(0, first.to));
      if (from >= sign_.dominant.size() || to >= sign_.dominant.size()) continue;
      if (from != at) part.motions.push_back(change_to(from));
      part.motions.push_back(motion(together, from, to));
      at = to;
    }
    for (++at; at < sign_.dominant.size(); ++at)
      part.motions.push_back(change_to(at));
    written.parts.push_back(std::move(part));
    return written;
  }

 private:
  void lost(std::string what) { findings_.left_out({}, std::move(what)); }

  const Handshape* find(const std::string& id) const {
    const auto found = std::ranges::find(handshapes_, id, &Handshape::id);
    return found == handshapes_.end() ? nullptr : &*found;
  }

  WrittenShape shape(const std::string& id) {
    const auto known = shapes_.find(id);
    if (known != shapes_.end()) return known->second;
    WrittenShape written;
    written.base = "flat";
    if (const Handshape* wanted = find(id)) {
      double least = 1e9;
      for (const ShapeChoice& choice : shape_choices()) {
        // No symbol bends by half.
        if (form_ == NotationForm::kSymbols && choice.written.bend == "halfbent") continue;
        const double off = apart(choice.read, *wanted);
        if (off >= least - 1e-9) continue;
        least = off;
        written = choice.written;
      }
      if (least > kSameShape)
        findings_.warning({}, "the handshape " + in_quotes(id) +
                                  " is written as the nearest form, whose joints differ by " +
                                  std::to_string(static_cast<int>(std::lround(least))) + " degrees on average");
    } else {
      lost("the handshape " + in_quotes(id) + " is not known; a flat hand is written");
    }
    return shapes_.emplace(id, written).first->second;
  }

  WrittenHand hand(const Posture& posture) {
    WrittenHand hand;
    hand.shape = shape(posture.handshape);
    const Letters fingers = letters_of(to_vector(posture.fingers), form_);
    hand.fingers = fingers.first;
    hand.second_fingers = fingers.second;
    if (const double off = angle_deg(fingers.read, to_vector(posture.fingers)); off > 12.0)
      findings_.warning({}, "the direction " + to_name(posture.fingers) + " of the fingers is written " +
                                std::to_string(static_cast<int>(std::lround(off))) + " degrees off");
    const Vec3 along = fingers.read, facing = to_vector(posture.palm);
    const Vec3 palm = unit(facing - along * glm::dot(facing, along), facing);
    double most = -2.0;
    for (const std::string_view letters : kAround) {
      const double likeness = glm::dot(palm_of(*vector_of_letters(letters), along), palm);
      if (likeness <= most + 1e-9) continue;
      most = likeness;
      hand.palm = letters;
    }
    return hand;
  }

  /// The part of the hand that is placed, where the entry names one.
  std::optional<WrittenHandSite> part(const Posture& posture) {
    if (!posture.contact || !posture.contact->part) return std::nullopt;
    auto site = site_of_part(*posture.contact->part);
    if (!site)
      lost("the part " + std::string(to_name(*posture.contact->part)) +
           " of the hand has no word; the hand is written");
    return site;
  }

  WrittenBodySite body(const Posture& posture, bool left_hand) {
    const PlaceChoice choice = place_of(posture, left_hand, mirrored_);
    WrittenBodySite site = choice.written;
    if (choice.off > 1.0) {
      lost("the place " + std::string(to_name(posture.location)) + " has no word; neutral space is written");
      site.location = "neutralspace";
    } else if (choice.off > kSamePlace) {
      findings_.warning({}, "the place " + std::string(to_name(posture.location)) + " is written " + in_cm(choice.off) +
                                " off, as near as the notation has one");
    }
    if (const auto with = part(posture)) site.with = *with;
    return site;
  }

  WrittenPosture posture(size_t phase) {
    const Posture& own = sign_.dominant[phase];
    WrittenPosture written;
    const Posture* base = base_at(phase);
    if (base != nullptr) {
      written.split_hands = true;
      written.split = {hand(own), hand(*base)};
    } else {
      written.shared = hand(own);
    }
    Location place = own.location;
    if (own.contact && own.contact->target) place = *own.contact->target;
    const std::string contact = own.contact ? contact_word(own.contact->kind) : "";
    const bool at_hand = is_on_other_hand(place) || place == Location::kUpperArm || place == Location::kElbow;
    if (at_hand && place == Location::kHands) {
      WrittenMeeting meeting;
      meeting.contact = contact.empty() ? "close" : contact;
      meeting.dominant = part(own);
      if (meeting.dominant) meeting.other = meeting.dominant;
      written.meeting = meeting;
      if (!is_on_other_hand(own.location)) {
        Posture where = own;
        where.contact.reset();
        written.body[0] = body(where, false);
      }
    } else if (at_hand) {
      const Location named = place == Location::kElbow ? Location::kOtherElbow : place;
      if (auto site = site_of_location(named)) {
        site->contact = contact.empty() ? "close" : contact;
        if (const auto with = part(own)) site->with = {*with};
        if (base != nullptr) {
          written.split_body = true;
          WrittenBodySite on;
          on.on_hand = *site;
          written.body[0] = on;
        } else {
          written.on_other = *site;
        }
      } else {
        lost("the place " + std::string(to_name(place)) + " has no word");
      }
      if (length(own.offset) > kSamePlace)
        findings_.warning({}, "the place " + std::string(to_name(place)) + " is written without its offset of " +
                                  in_cm(length(own.offset)));
    } else {
      written.body[0] = body(own, false);
      if (base != nullptr) written.split_body = true;
    }
    if (base != nullptr) {
      Posture waits = *base;
      if (is_on_other_hand(waits.location)) {
        waits.location = Location::kNeutral;
        waits.offset = Vec3(0.0, 0.0, 0.2);
      }
      if (waits.contact && is_on_other_hand(waits.contact->target.value_or(Location::kNeutral))) waits.contact.reset();
      written.body[1] = body(waits, true);
    }
    return written;
  }

  const Posture* base_at(size_t phase) const {
    return has_base_ ? &sign_.non_dominant[std::min(phase, sign_.non_dominant.size() - 1)] : nullptr;
  }

  /// What is not as it was in the phase before.
  WrittenPosture target(size_t from, size_t to) {
    WrittenPosture written = posture(to);
    const auto same_hand = [](const Posture* a, const Posture* b) {
      return a == b || (a->handshape == b->handshape && a->fingers == b->fingers && a->palm == b->palm);
    };
    if (same_hand(&sign_.dominant[from], &sign_.dominant[to]) && same_hand(base_at(from), base_at(to))) {
      written.shared = {};
      written.split_hands = false;
    }
    return written;
  }

  WrittenMotion change_to(size_t phase) {
    WrittenMotion motion;
    motion.kind = Kind::kTarget;
    WrittenMotion change;
    change.kind = Kind::kChange;
    motion.parts.push_back(change);
    motion.target = posture(phase);
    return motion;
  }

  static std::string size_word(Size size) {
    return size == Size::kLarge ? "big" : size == Size::kMedium ? "" : "small";
  }

  Vec3 way(const Movement& movement, size_t from, size_t to) const {
    if (movement.direction) return to_vector(*movement.direction);
    const Posture &a = sign_.dominant[from], &b = sign_.dominant[to];
    const Vec3 by = b.offset - a.offset;
    if (a.location == b.location && length(by) > 1e-3) return unit(by);
    return to_vector(sign_.dominant[from].palm);
  }

  void set_direction(const Vec3& direction, WrittenMotion& motion) {
    const Letters letters = letters_of(direction, form_);
    motion.direction = letters.first;
    motion.second_direction = letters.second;
  }

  WrittenMotion one(const Movement& movement, size_t from, size_t to) {
    WrittenMotion motion;
    motion.size = size_word(movement.size);
    motion.fast = movement.manner == Manner::kFast;
    motion.slow = movement.manner == Manner::kSlow;
    motion.tense = movement.manner == Manner::kTense;
    motion.halt = movement.manner == Manner::kSharp;
    motion.rest = movement.manner == Manner::kRest;
    switch (movement.kind) {
      case MoveKind::kHold:
        motion.kind = Kind::kNothing;
        motion.size.clear();
        break;
      case MoveKind::kCircle:
      case MoveKind::kSpiral: {
        motion.kind = Kind::kCircular;
        Vec3 axis = to_vector(sign_.dominant[from].palm);
        if (movement.plane == Plane::kHorizontal) axis = Vec3(0, 1, 0);
        if (movement.plane == Plane::kFrontal) axis = Vec3(0, 0, 1);
        if (movement.plane == Plane::kSagittal || movement.plane == Plane::kVertical) axis = Vec3(1, 0, 0);
        if (movement.direction) axis = to_vector(*movement.direction);
        if (movement.plane == Plane::kAnticlockwise) axis = -axis;
        set_direction(axis, motion);
        if (movement.kind == MoveKind::kSpiral) motion.growth = "decreasing";
        break;
      }
      case MoveKind::kTwist:
      case MoveKind::kNod:
      case MoveKind::kSwing:
      case MoveKind::kStir:
        motion.kind = Kind::kWrist;
        motion.wrist = movement.kind == MoveKind::kTwist         ? "twisting"
                       : movement.kind == MoveKind::kNod         ? "nodding"
                       : movement.kind == MoveKind::kSwing       ? "swinging"
                       : movement.plane == Plane::kAnticlockwise ? "stirccw"
                                                                 : "stircw";
        break;
      case MoveKind::kWiggle:
        motion.kind = Kind::kFingerplay;
        motion.digits = movement.digits;
        motion.size.clear();
        break;
      case MoveKind::kOpen:
      case MoveKind::kClose:
      case MoveKind::kFlick:
      case MoveKind::kBend:
      case MoveKind::kSqueeze:
        motion.kind = Kind::kChange;
        motion.size.clear();
        if (from == to) return fingers_in_place(movement, from);
        break;
      case MoveKind::kZigzag:
      case MoveKind::kWavy:
        motion.kind = Kind::kDirected;
        motion.waviness = movement.kind == MoveKind::kWavy ? "wavy" : "zigzag";
        motion.size.clear();
        motion.waviness_size = size_word(movement.size);
        set_direction(way(movement, from, to), motion);
        break;
      default: {
        motion.kind = Kind::kDirected;
        Vec3 direction = way(movement, from, to);
        if (movement.plane == Plane::kSideToSide) direction = Vec3(1, 0, 0);
        if (movement.plane == Plane::kUpDown) direction = Vec3(0, 1, 0);
        if (movement.plane == Plane::kToFro) direction = Vec3(0, 0, 1);
        set_direction(direction, motion);
        if (from != to && waves(movement.kind)) {
          motion.waviness = "wavy";
          motion.waviness_size = size_word(movement.size);
          motion.size.clear();
          set_direction(way({}, from, to), motion);
        }
        motion.brushing = movement.kind == MoveKind::kBrush && form_ == NotationForm::kSymbols;
        if (movement.kind == MoveKind::kArc || movement.kind == MoveKind::kBounce) {
          motion.curve = "u";
          double most = -2.0;
          const Vec3 bow = movement.bow                   ? to_vector(*movement.bow)
                           : std::abs(direction.y) > 0.75 ? Vec3(0, 0, 1)
                                                          : Vec3(0, 1, 0);
          for (const std::string_view letters : kAround) {
            const double likeness = glm::dot(carried(*vector_of_letters(letters), direction), bow);
            if (likeness <= most + 1e-9) continue;
            most = likeness;
            motion.curve = letters;
          }
          motion.curve_size = size_word(movement.size);
          motion.size.clear();
        }
        break;
      }
    }
    return motion;
  }

  static bool waves(MoveKind kind) {
    return kind == MoveKind::kShake || kind == MoveKind::kSway || kind == MoveKind::kRub ||
           kind == MoveKind::kAlternate;
  }

  static WrittenMotion repeated(WrittenMotion motion, std::string_view how) {
    WrittenMotion again;
    again.kind = Kind::kRepeat;
    again.repetition = how;
    again.parts.push_back(std::move(motion));
    return again;
  }

  /// Fingers that move within one posture are written as the change to another and back.
  WrittenMotion fingers_in_place(const Movement& movement, size_t phase) {
    const bool opens = movement.kind == MoveKind::kOpen || movement.kind == MoveKind::kFlick;
    findings_.warning({}, "the fingers' movement " + in_quotes(to_name(movement.kind)) +
                              " within one posture is written as a change of the hand and back");
    WrittenMotion change = change_to(phase);
    WrittenHand changed;
    changed.shape = shape(sign_.dominant[phase].handshape);
    if (opens) {
      changed.shape = WrittenShape();
      changed.shape->base = "finger2345";
    } else {
      changed.shape->bend = movement.kind == MoveKind::kBend ? "hooked" : "round";
      changed.shape->special.clear();
    }
    change.target = {};
    if (has_base_) {
      change.target.split_hands = true;
      change.target.split = {changed, hand(sign_.non_dominant[std::min(phase, sign_.non_dominant.size() - 1)])};
    } else {
      change.target.shared = changed;
    }
    WrittenMotion back = repeated(std::move(change), "reverse");
    if (movement.repeats < 2) return back;
    return repeated(std::move(back), movement.repeats > 2 ? "fromstart_several" : "fromstart");
  }

  WrittenMotion motion(const std::vector<const Movement*>& together, size_t from, size_t to) {
    WrittenMotion all;
    int repeats = 1;
    bool to_and_fro = false, alternating = false;
    std::vector<WrittenMotion> parts;
    for (const Movement* movement : together) {
      parts.push_back(one(*movement, from, to));
      alternating = alternating || movement->hands == MovingHands::kAlternating;
      // A wrist's and the fingers' movement is several times by itself, and so is what is waved.
      const Kind kind = parts.back().kind;
      if (kind == Kind::kWrist || kind == Kind::kFingerplay || kind == Kind::kRepeat || !parts.back().waviness.empty())
        continue;
      repeats = std::max(repeats, movement->repeats);
      to_and_fro = to_and_fro || (from == to && waves(movement->kind));
    }
    if (parts.size() == 1) {
      all = parts.front();
    } else {
      all.kind = Kind::kParallel;
      all.parts = std::move(parts);
    }
    if (from != to) {
      WrittenMotion target;
      target.kind = Kind::kTarget;
      target.target = this->target(from, to);
      target.parts.push_back(std::move(all));
      all = std::move(target);
    }
    all.alternating = all.alternating || alternating;
    if (to_and_fro) all = repeated(std::move(all), "reverse");
    if (repeats < 2) return all;
    return repeated(std::move(all), repeats > 2 ? "fromstart_several" : "fromstart");
  }

  const Sign& sign_;
  std::span<const Handshape> handshapes_;
  NotationForm form_;
  Findings& findings_;
  bool mirrored_ = false, has_base_ = false;
  std::map<std::string, WrittenShape> shapes_;
};

}  // namespace

WrittenSign written_of(const Sign& sign, std::span<const Handshape> handshapes, NotationForm form, Findings& findings) {
  return Writer(sign, handshapes, form, findings).run();
}

void write_non_manual(const NonManual& face, WrittenElement& sign, Findings& findings) {
  WrittenElement elements;
  elements.name = "hamnosys_nonmanual";
  const auto add = [&](std::string_view tier, std::string_view word) {
    if (word.empty()) return;
    if (tier == "mouthing") {
      elements.add("hnm_mouthpicture").put("picture", word);
    } else if (const auto feature = feature_of(tier, word)) {
      elements.add(feature->element).put("tag", feature->tag);
    } else {
      findings.left_out({}, "the " + std::string(tier) + " " + in_quotes(word) + " have no tag");
    }
  };
  add("shoulders", face.shoulders);
  add("head", face.head);
  add("gaze", face.gaze);
  add("brows", face.brows);
  add("eyes", face.eyes);
  add("face", face.face);
  add("cheeks", face.cheeks);
  add("mouth", face.mouth);
  add("mouthing", face.mouthing);
  for (const NonManualFeature& feature : face.more) {
    if (feature.from != 0 || feature.to != 1)
      findings.left_out({}, "when in the sign the " + feature.tier + " " + in_quotes(feature.word) + " are shown");
    add(feature.tier, feature.word);
  }
  if (!elements.children.empty()) sign.children.push_back(std::move(elements));
}

}  // namespace auslan::notation
