// SPDX-License-Identifier: Apache-2.0
// Written places in the model's words. Where the model is coarser than the notation, a warning names both.
#pragma once

#include "kinematics/vector.h"
#include "written_sign.h"

namespace auslan::notation {

/// Where a hand is put on or before the body.
struct Spot {
  Location location = Location::kNeutral;
  Vec3 offset{0.0};                    ///< metres, world axes; in signing space z is the distance from the chest
  std::optional<ContactKind> contact;  ///< none in signing space
  Vec3 outward{0, 0, 1};               ///< away from the body at this place
};

/// `left_hand`: the place is for the other hand. `apart`: two hands share the place, so each keeps to its own side.
Spot spot_of(const WrittenBodySite& site, bool left_hand, bool apart, Findings& findings);
/// Where a hand is when nothing is written.
Spot neutral_spot(bool left_hand, bool two_hands);

/// How a hand is held: on which of its sides the signer's left is.
struct HeldHand {
  Vec3 fingers{0, 1, 0}, palm{0, 0, 1};
  bool left_hand = false;
};

/// The part of the articulating hand that `site` names.
HandPart part_of(const WrittenHandSite& site, const HeldHand& hand, Findings& findings);
/// The same place on the other hand or arm, as a location; `hand` is that hand.
Location on_other_hand(const WrittenHandSite& site, const HeldHand& hand, Findings& findings);
/// True for sites that only the other arm can offer.
bool is_arm_site(const std::string& part);
/// The part that touches when none is written: the fingertips that the handshape points with, else the side of the hand
/// that faces `towards`.
HandPart facing_part(const Handshape& shape, const Vec3& fingers, const Vec3& palm, const Vec3& towards,
                     bool left_hand);

/// What the words "touch", "close", "interlock", "cross" mean; none for "armextended" and nothing.
std::optional<ContactKind> contact_of(const std::string& word, const Mark& mark, Findings& findings);

}  // namespace auslan::notation
