// SPDX-License-Identifier: Apache-2.0
// The phonological model of a sign: what the lexicon stores and the synthesis performs. A right-handed signer is
// described; a left-handed one is the exact mirror image.
//
// The parameters are the field's (handshape, extended finger direction, palm orientation, location with contact,
// movement, two-handed relation, non-manual features, mouthing), after Stokoe and HamNoSys.
#pragma once

#include "kinematics/vector.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

// ---------------------------------------------------------------------------------------------------------------------
// Vocabulary. Every enumeration has a table of names in the same order (vocabulary.h), used by text, database and
// output.

/// A direction as seen by the signer: the sum of its parts, made a unit vector. With parts of -1, 0 and +1 it is one of
/// the 26 that entries are usually written with; those between them have larger weights, up to kFinestWeight.
struct Direction {
  int left = 0;  ///< positive: the signer's left, negative: right
  int up = 0;    ///< positive: up, negative: down
  int away = 0;  ///< positive: away from the signer's chest, negative: towards it

  friend bool operator==(const Direction&, const Direction&) = default;
};

inline constexpr int kFinestWeight = 1000;

/// Places on or near the body and on the other hand where an articulating hand can be. `contra` = the side of the
/// non-articulating hand.
enum class Location {
  // head
  kTopHead,
  kForehead,
  kEyebrow,
  kTemple,
  kSideHead,
  kEye,
  kCheekbone,
  kNose,
  kNostrils,
  kFace,
  kCheek,
  kEar,
  kEarlobe,
  kContraEar,
  kUpperLip,
  kMouth,
  kTeeth,
  kTongue,
  kLowerLip,
  kChin,
  kUnderChin,
  kNeck,
  // trunk and arm
  kShoulder,
  kContraShoulder,
  kUpperChest,
  kChest,
  kContraChest,
  kStomach,
  kLowerStomach,
  kWaist,
  kThigh,
  kUpperArm,
  kElbow,
  // signing space
  kHighNeutral,
  kNeutral,
  kLowNeutral,
  kIpsiSpace,
  kContraSpace,
  // the other hand ("nd")
  kOtherPalm,
  kOtherBack,
  kOtherWristBack,
  kOtherWristInner,
  kOtherForearmBack,
  kOtherForearmInner,
  kOtherFingertips,
  kOtherThumb,
  kOtherIndex,
  kOtherMiddle,
  kOtherRing,
  kOtherLittle,
  kOtherUlnar,
  kOtherRadial,
  kOtherFistTop,
  kOtherElbow,
  kHands,  ///< the two hands meet, wherever the non-dominant one is
  kOtherThumbBall,
  kOtherWristRadial,
  kOtherWristUlnar,
  kOtherElbowInside,
  kOtherDigitSites,  ///< the first of the sites of the other hand's digits: other_location(DigitSite) in vocabulary.h
};

/// The part of the articulating hand that touches, or that is placed at the location.
enum class HandPart {
  kPalm,
  kBack,
  kRadial,
  kUlnar,
  kFingertips,
  kIndexTip,
  kMiddleTip,
  kRingTip,
  kLittleTip,
  kThumbTip,
  kThumbIndexTips,
  kIndexMiddleTips,
  kIndexSide,
  kIndexMiddle,
  kFingers,
  kIndexKnuckle,
  kKnuckles,
  kWrist,
  kFistThumbSide,
  kFistUlnar,
  kThumbWeb,
  kIndexBase,
  kIndexMidJoint,
  kThumbSide,
  kIndexPad,  ///< the palmar side of the index between its joints
  kThumbBall,
  kWristBack,
  kWristRadial,
  kWristUlnar,
  kForearm,
  kDigitSites,  ///< the first of the sites of the digits: hand_part(DigitSite) in vocabulary.h
};

/// A place on a digit. The sides of a joint or of the length are those of the digit's own surface.
enum class DigitFeature {
  kTip,
  kNail,
  kTipPad,
  kTipRadial,
  kTipUlnar,
  kMidPalmar,  ///< the joint in the middle of the digit
  kMidDorsal,
  kMidRadial,
  kMidUlnar,
  kBasePalmar,  ///< where the digit leaves the hand
  kBaseDorsal,
  kBaseRadial,
  kBaseUlnar,
  kLengthPalmar,  ///< between the joints
  kLengthDorsal,
  kLengthRadial,
  kLengthUlnar,
};
inline constexpr int kDigits = 5, kDigitFeatures = 17;

struct DigitSite {
  int digit = 0;  ///< 0 the thumb, 1 the index … 4 the little finger
  DigitFeature feature = DigitFeature::kTip;

  friend bool operator==(const DigitSite&, const DigitSite&) = default;
};

enum class ContactKind { kTouch, kHold, kBrush, kNear, kInterlock, kCross };

enum class MoveKind {
  kHold,
  kStraight,
  kArc,
  kCircle,
  kSpiral,
  kZigzag,
  kWavy,
  kTap,
  kBrush,
  kRub,
  kTwist,
  kNod,
  kSwing,  ///< of the wrist, towards the thumb's side and back
  kStir,   ///< of the wrist, the fingers' tips on a circle
  kShake,
  kSway,
  kBounce,
  kOpen,
  kClose,
  kFlick,
  kSqueeze,
  kWiggle,
  kBend,
  kAlternate,
  kCross,
  kSeparate,
  kApproach,
  kStrike,
};

enum class Size { kTiny, kSmall, kMedium, kLarge };
enum class Manner {
  kPlain,
  kSlow,
  kFast,
  kSharp,  ///< ends abruptly
  kTense,
  kRest,  ///< with a rest after it
};
/// How a movement's width changes while it is made.
enum class Growth { kNone, kIncreasing, kDecreasing };
enum class Plane {
  kNone,
  kHorizontal,
  kVertical,
  kFrontal,
  kSagittal,
  kSupinate,
  kPronate,
  kSideToSide,
  kUpDown,
  kToFro,
  kFingers,
  kClockwise,
  kAnticlockwise
};
/// Which hands a movement moves.
enum class MovingHands { kDominant, kNonDominant, kBoth, kAlternating };

/// The relation of the two hands.
enum class Handedness {
  kOne,           ///< the dominant hand alone
  kSymmetric,     ///< both act, mirrored left to right
  kAlternating,   ///< both act, mirrored, half a cycle apart
  kDominantBase,  ///< the dominant hand acts on or beside the other
};
inline bool is_mirrored(Handedness handedness) {
  return handedness == Handedness::kSymmetric || handedness == Handedness::kAlternating;
}

enum class Confidence { kLow, kMedium, kHigh };
enum class ReviewState { kUnreviewed, kReviewed, kRejected };

// ---------------------------------------------------------------------------------------------------------------------
// The sign.

struct Contact {
  ContactKind kind = ContactKind::kTouch;
  std::optional<HandPart>
      part;  ///< of the articulating hand; none = the fingertips its handshape points with, or its palm
  std::optional<Location> target;  ///< where it lands when that is finer than the posture's location

  friend bool operator==(const Contact&, const Contact&) = default;
};

/// One posture of one hand.
struct Posture {
  std::string handshape;       ///< id of a Handshape
  Direction fingers{0, 1, 0};  ///< extended finger direction: along the metacarpals, whatever the fingers do
  Direction palm{0, 0, 1};     ///< where the palm faces
  Location location = Location::kNeutral;
  Vec3 offset{0.0};  ///< metres, world axes (+X the signer's left), from the location to the hand
  std::optional<Contact> contact;

  friend bool operator==(const Posture&, const Posture&) = default;
};

/// A movement. `from` < `to`: the path between two phases; `from` == `to`: a local movement at that phase.
struct Movement {
  MoveKind kind = MoveKind::kHold;
  std::optional<Direction> direction;  ///< of a circle: its axis, round which it goes by the right hand's rule
  std::optional<Direction> bow;        ///< of an arc: where its middle lies; none: up, or away on a steep way. Of
                                       ///< what is waved on the way: to which side first; none: sideways
  std::optional<Direction> start;      ///< of a circle: where on it the hand is first, seen from its centre
  int eighths = 8;                     ///< of a circle: how much of a turn it is; only between phases less than a turn
  std::optional<Direction> ellipse;    ///< of a circle: its longer axis; none: it is round
  Size flattening = Size::kMedium;     ///< of an ellipse
  Growth growth = Growth::kNone;       ///< of a circle (a spiral), or of what is waved on the way
  std::string digits;                  ///< of moving fingers: which, "1" the thumb to "5" the little finger; empty: all
  double pace = 1;                     ///< 2: twice as fast as the manner asks
  Size size = Size::kMedium;
  int repeats = 1;  ///< how often the movement is made, at least 1
  MovingHands hands = MovingHands::kDominant;
  Manner manner = Manner::kPlain;
  Plane plane = Plane::kNone;
  int from = 0;
  int to = 0;

  friend bool operator==(const Movement&, const Movement&) = default;
};

/// A non-manual feature for a part of the sign's time.
struct NonManualFeature {
  std::string tier;         ///< "brows", "eyes" …: a member of NonManual, or "mouthing"
  std::string word;         ///< as that tier has it
  double from = 0, to = 1;  ///< in shares of the sign's time
  double amount = 1;        ///< of the usual strength

  friend bool operator==(const NonManualFeature&, const NonManualFeature&) = default;
};

/// Non-manual features in the lexicon's words ("raise", "furrow", "shake", "puff" …), empty where the sign asks
/// nothing.
struct NonManual {
  std::string brows, eyes, mouth, cheeks, head, shoulders, gaze, face;
  std::string mouthing;                ///< English word mouthed with the sign
  std::vector<NonManualFeature> more;  ///< what does not last for the whole sign, or is one of several on a tier

  friend bool operator==(const NonManual&, const NonManual&) = default;
};

/// What somebody said of an entry after looking at it.
struct Review {
  std::string by;
  std::string on;  ///< ISO date
  ReviewState verdict = ReviewState::kUnreviewed;
  std::string remark;   ///< may be empty
  std::string content;  ///< the entry's content digest at that time; empty: not noted

  friend bool operator==(const Review&, const Review&) = default;
};

/// Where an entry comes from and how sure we are of it.
struct Provenance {
  std::vector<std::string> sources;  ///< tags of assets/SOURCES.md
  std::string form_evidence;         ///< what handshape and location rest on
  std::string movement_evidence;     ///< what the movement rests on: measured, documented, iconic, cognate, memory
  Confidence confidence = Confidence::kLow;
  ReviewState review = ReviewState::kUnreviewed;
  std::string reviewed_by;      ///< empty unless reviewed or rejected
  std::string reviewed_on;      ///< ISO date, empty unless reviewed or rejected
  std::vector<Review> history;  ///< oldest first; the last one is what `review`, by and on say

  friend bool operator==(const Provenance&, const Provenance&) = default;
};

struct Sign {
  std::string gloss;  ///< upper case, the entry's id
  std::string kind;   ///< "sign", "letter" or "number"
  std::string category;
  std::string region;      ///< "all", "north", "south" or a state
  std::string definition;  ///< in our own words
  Handedness handedness = Handedness::kOne;
  std::vector<Posture> dominant;      ///< phases, at least one
  std::vector<Posture> non_dominant;  ///< empty (one-handed); one phase (a base that stays); or one per dominant phase.
                                      ///< In a symmetric sign it is left empty: it is the mirror image
  std::vector<Movement> movements;
  NonManual non_manual;
  bool safety_critical = false;  ///< somebody may come to harm where it is misunderstood
  Provenance provenance;

  friend bool operator==(const Sign&, const Sign&) = default;
};

/// Angles of one digit in degrees: flexion of its three joints, and abduction away from the middle finger.
struct FingerAngles {
  double mcp = 0, pip = 0, dip = 0, abduction = 0;

  friend bool operator==(const FingerAngles&, const FingerAngles&) = default;
};

/// Angles of the thumb. Radial abduction is in the plane of the palm, palmar abduction out of it; opposition turns the
/// thumb's pad from facing sideways (0) to facing the fingers (1).
struct ThumbAngles {
  double radial_abduction = 0, palmar_abduction = 0, opposition = 0, mp = 0, ip = 0;

  friend bool operator==(const ThumbAngles&, const ThumbAngles&) = default;
};

struct Handshape {
  std::string id;
  std::string name;
  std::string base;                     ///< id of the base shape it is a variant of, or its own id
  std::array<FingerAngles, 4> fingers;  ///< index, middle, ring, little
  ThumbAngles thumb;
  std::string selected;     ///< the selected digits, as "index+middle"
  std::string hamnosys;     ///< approximate symbol names, comma-separated, or empty
  std::string description;  ///< in our own words
  std::vector<std::string> aliases;
  bool core = false;       ///< of the 37 core handshapes of Auslan
  int frequency_rank = 0;  ///< among the handshapes of the dictionary, 1 is the most frequent; 0: not counted
  Provenance provenance;

  friend bool operator==(const Handshape&, const Handshape&) = default;
};

}  // namespace auslan
