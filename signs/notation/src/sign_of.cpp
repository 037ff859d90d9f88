// SPDX-License-Identifier: Apache-2.0
#include "direction.h"
#include "layout.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <cmath>

namespace auslan::notation {
namespace {

bool same(const Vec3& a, const Vec3& b) {
  const Vec3 d = a - b;
  return glm::dot(d, d) < 1e-12;
}

}  // namespace

bool Layout::is_mirror(const Phase& phase) const {
  const Hand& a = phase.hands[0];
  const Hand& b = phase.hands[1];
  if (a.shape.id != b.shape.id || !same(a.fingers, image(b.fingers)) || !same(a.palm, image(b.palm))) return false;
  if (phase.meeting && (phase.meeting->part != phase.meeting->other_part)) return false;
  if (a.other_location || b.other_location) return false;
  if (phase.meeting) return std::abs(a.spot.offset.y - b.spot.offset.y) < 1e-9;
  return a.spot.location == b.spot.location && same(a.spot.offset, image(b.spot.offset)) && a.part == b.part;
}

Posture Layout::posture_of(const Phase& phase, size_t which, bool symmetric) {
  const Hand& hand = phase.hands[which];
  Posture posture;
  posture.handshape = hand.shape.id;
  posture.fingers = to_direction(hand.fingers);
  posture.palm = palm_direction(hand.palm, hand.fingers);
  posture.location = hand.spot.location;
  posture.offset = hand.spot.offset;
  const auto at = [&](ContactKind kind) {
    Contact contact;
    contact.kind = kind;
    contact.part = hand.part;
    posture.contact = contact;
  };
  if (hand.spot.contact) at(*hand.spot.contact);
  if (phase.meeting) {
    const Meeting& meeting = *phase.meeting;
    const Vec3 apart =
        (phase.hands[0].spot.offset - meeting.dominant_offset) - (phase.hands[1].spot.offset - meeting.other_offset);
    const bool still = glm::dot(apart, apart) < 1e-9;
    const HandPart part = which == 0 ? meeting.part : meeting.other_part;
    posture.contact = Contact{still ? meeting.contact : ContactKind::kNear, part, std::nullopt};
    if (symmetric && std::abs(apart.x) < 1e-9) {
      posture.contact->target = Location::kHands;
    } else if (!symmetric && which == 0) {
      posture.location = meeting.other_location;
      posture.offset = apart;
    }
  }
  // Space has a front: nothing is signed inside the chest.
  const bool in_space = posture.location >= Location::kHighNeutral && posture.location <= Location::kContraSpace;
  if (in_space) posture.offset.z = std::clamp(posture.offset.z, 0.05, 0.60);
  // To a micrometre, as the lexicon's text has it.
  for (glm::length_t i = 0; i < 3; ++i)
    posture.offset[i] = std::round(posture.offset[i] * 1e6) / 1e4 / 100.0;
  return posture;
}

void Layout::keep_shape(const Handshape& shape) {
  for (const Handshape& kept : result_.handshapes)
    if (kept.id == shape.id) return;
  result_.handshapes.push_back(shape);
}

NotatedSign Layout::run() {
  Sign& sign = result_.sign;
  sign.gloss = written_.gloss.empty() ? "UNNAMED" : written_.gloss;
  sign.kind = "sign";
  sign.category = "notation";
  sign.region = "all";
  sign.non_manual = written_.non_manual;
  sign.provenance.form_evidence = "read from a sign notation";
  sign.provenance.movement_evidence = "documented";
  bool has_manual = false;
  for (const WrittenPart& part : written_.parts) {
    if (part.start.empty() && part.motions.empty()) continue;
    if (!part.start.has_shape() && !now_.hands[0].present) {
      findings_.error(part.mark, "no handshape is written: there is nothing to sign");
      return std::move(result_);
    }
    has_manual = true;
    begin_part(part);
    make_strokes(part);
    if (part.out_of_phase) alternating_ = true;
  }
  if (!has_manual) {
    findings_.error(written_.mark,
                    "the sign " + in_quotes(sign.gloss) + " has no manual part: there is nothing to sign");
    return std::move(result_);
  }
  // A hand that comes in later waits in its first posture.
  bool two = false;
  for (size_t i = phases_.size(); i-- > 0;) {
    if (phases_[i].hands[1].present) {
      two = true;
    } else if (two) {
      phases_[i].hands[1] = phases_[i + 1].hands[1];
    }
  }
  if (two)
    for (size_t i = 1; i < phases_.size(); ++i)
      if (!phases_[i].hands[1].present) phases_[i].hands[1] = phases_[i - 1].hands[1];
  for (Phase& phase : phases_) {
    // A shape is needed for a hand that was only placed.
    if (phase.hands[1].present && phase.hands[1].shape.id.empty()) {
      phase.hands[1].shape = phase.hands[0].shape;
      phase.hands[1].written = phase.hands[0].written;
    }
  }
  const bool mirror = two && !hands_differ_ && std::all_of(phases_.begin(), phases_.end(), [this](const Phase& phase) {
                        return is_mirror(phase);
                      });
  if (!two) {
    sign.handedness = Handedness::kOne;
  } else if (mirror) {
    sign.handedness = alternating_ ? Handedness::kAlternating : Handedness::kSymmetric;
  } else {
    sign.handedness = Handedness::kDominantBase;
    if (alternating_)
      for (Movement& movement : movements_)
        if (movement.hands == MovingHands::kBoth) movement.hands = MovingHands::kAlternating;
  }
  for (const Phase& phase : phases_) {
    sign.dominant.push_back(posture_of(phase, 0, mirror));
    keep_shape(phase.hands[0].shape);
    if (two && !mirror) {
      sign.non_dominant.push_back(posture_of(phase, 1, false));
      keep_shape(phase.hands[1].shape);
    }
  }
  for (Movement& movement : movements_)
    if (mirror && movement.hands == MovingHands::kBoth && alternating_) movement.hands = MovingHands::kAlternating;
  if (!mirror) part_hands();
  sign.movements = movements_;
  result_.signable = true;
  return std::move(result_);
}

NotatedSign sign_of(const WrittenSign& written, Findings& findings) {
  NotatedSign sign = Layout(written, findings).run();
  sign.diagnostics = findings.take();
  return sign;
}

}  // namespace auslan::notation
