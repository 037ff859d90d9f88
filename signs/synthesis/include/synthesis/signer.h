// SPDX-License-Identifier: Apache-2.0
// The signer: a figure together with what synthesis has to know of its surface, built once per figure; and the geometry
// that turns a posture (phonology) into the place of a hand (motion).
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/figure.h"
#include "kinematics/result.h"
#include "kinematics/solid.h"
#include "phonology/sign.h"
#include "synthesis/body_sites.h"
#include "synthesis/hand_sites.h"
#include "synthesis/score.h"

#include <array>
#include <optional>

namespace auslan {

/// The nodes of an arm, placed in the world.
struct ArmPlacement {
  Transform shoulder, elbow, wrist;
};

/// A posture on this figure: where the hand is, and, where it touches something, from which side it came.
struct PlacedHand {
  HandState state;
  bool touching = false;
  double stand_off = 0;        ///< metres that it keeps from what it is near, where the entry says so; else 0
  Vec3 normal{0.0, 0.0, 1.0};  ///< outward normal of the surface that is touched, or of the palm's facing in the air
  Vec3 part{0.0};              ///< what is brought to the place, in the wrist's frame
  Location location = Location::kNeutral;  ///< the posture's, or the finer one that its contact names
};

/// What a posture is placed against.
struct OtherHand {
  const HandState* state = nullptr;  ///< null: the other hand is not there
  bool mirrored = false;             ///< the other hand is the mirror image of this one: they meet in the middle plane
};

/// How deep something lies in the body, and the way out.
struct Depth {
  double metres = 0;        ///< 0: outside
  Vec3 out{0.0, 0.0, 1.0};  ///< unit; the surface's normal where it is nearest
};

/// Digit angles of a handshape, radians.
HandAngles hand_angles(const Handshape& handshape);
/// The mirror image in the plane x = 0.
HandState mirrored(const HandState& state);

/// What a signer cannot tell from a figure's segments.
struct FigureTraits {
  std::optional<FaceLandmarks> face;  ///< as in BodySites::build
  /// How deep a forearm may press into the trunk before the elbow gives way, metres: into a shirt.
  double trunk_gives = 0.012;
};

class Signer {
 public:
  /// kUnsupported where a body part that signs need has no surface. The figure must outlive the signer.
  static Result<Signer> build(const Figure& figure, const FigureTraits& traits = {});

  const Figure& figure() const { return *figure_; }
  const BodySites& body() const { return body_; }
  const HandSites& hand(Side side) const { return hands_[static_cast<size_t>(side)]; }
  const HandFrame& hand_frame(Side side) const { return frames_[static_cast<size_t>(side)]; }

  /// Solves a posture for a hand of `side`. Directions and offsets are the signer's own for either hand; only locations
  /// such as `contra_chest` depend on the side. Total: a place that cannot be reached is approached as far as the arm
  /// allows.
  PlacedHand place(const Posture& posture, const Handshape& handshape, Side side, const OtherHand& counterpart) const;

  /// The arm that puts the wrist where `state` says, trunk at rest.
  ArmPlacement place_arm(Side side, const HandState& state) const;

  /// A natural swivel for a wrist, moved on where it would put the forearm into the trunk.
  double swivel_for(Side side, const Transform& world_from_wrist) const;

  /// How deep a hand, and how deep its forearm, lie in the trunk at rest. Both are taken as balls.
  Depth hand_depth(Side side, const HandState& state) const;
  Depth forearm_depth(Side side, const HandState& state) const;

  /// The hand hanging beside the hip: the start and end of all signing.
  HandState rest(Side side) const;

 private:
  Signer(const Figure& figure, const FigureTraits& traits, BodySites body, std::array<HandSites, 2> hands);
  /// A ball that lies deeper in the trunk than `depth` takes its place.
  void sink(const Vec3& centre, double radius, Depth& depth) const;
  /// Radians by which the arm breaks its joint limits to put the hand there, over shoulder, elbow and wrist.
  double strain(Side side, const HandState& state) const;
  /// Puts the hand's `part` (wrist frame) on `target`, leaning from the wanted orientation as far as the joint limits
  /// ask.
  void reach_comfortably(Side side, const Vec3& part, const Vec3& target, HandState& state) const;
  /// The place on the other hand or arm, world space.
  Site other_site(Location location, HandPart touching, Side other_side, const HandState& other, const Vec3& comes_from,
                  const Vec3& offset) const;

  const Figure* figure_;
  FigureTraits traits_;
  BodySites body_;
  std::array<HandSites, 2> hands_;
  Solid trunk_;
  Vec3 trunk_place_{0.0};  ///< world, at rest
  std::array<HandFrame, 2> frames_;
};

}  // namespace auslan
