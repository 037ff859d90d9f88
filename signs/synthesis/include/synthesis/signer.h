// SPDX-License-Identifier: Apache-2.0
// The signer: a figure together with what synthesis has to know of its surface, built once per figure; and the geometry
// that turns a posture (phonology) into the place of a hand (motion).
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/arm_reach.h"
#include "kinematics/figure.h"
#include "kinematics/result.h"
#include "phonology/sign.h"
#include "synthesis/body_sites.h"
#include "synthesis/body_surface.h"
#include "synthesis/hand_sites.h"
#include "synthesis/score.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace auslan {

struct HandFit;
struct Obstacle;
struct MirrorPlane;

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
  Vec3 part{0.0};              ///< what is brought to the place, or touches there, in the wrist's frame
  Location location = Location::kNeutral;  ///< the posture's, or the finer one that its contact names
  Vec3 shift{0.0};                         ///< by which a hand in the air gave way to the direction, metres
  /// How many times over what is not seen the worst of it is: gap, depth, leaning, what the arm's limits take away.
  /// Only where the signer seeks longer, else 0.
  double trouble = 0.0;
};

/// What a posture is placed against.
struct OtherHand {
  const HandState* state = nullptr;  ///< null: the other hand is not there
  bool mirrored = false;             ///< the other hand is the mirror image of this one: they meet in the middle plane
  bool acts = false;                 ///< it has postures of its own, and is to be kept clear of
  /// By how much the sign's first posture gave way, metres: the later ones give way alike, so that paths keep their
  /// form. None: this is the first.
  std::optional<Vec3> shift;
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
  bool is_foreign = false;  ///< entries were not tried on it: what does not come right at once is sought for longer
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

  /// Whether what does not come right at once is sought for longer.
  bool seeks_longer() const { return seeks_longer_; }

  const ArmReach& reach(Side side) const { return reach_[static_cast<size_t>(side)]; }

  /// The arm that puts the wrist where `state` says, trunk at rest; `limited`: as it is sampled, eased into its limits.
  ArmPlacement place_arm(Side side, const HandState& state, bool limited = false) const;

  /// How deep a hand with its forearm lies in head, neck and trunk at rest, and in the other arm; counted from a little
  /// above their surface.
  /// What lies no deeper than `at_least` metres counts as outside.
  Depth depth_in_body(Side side, const HandState& state, double at_least = 0.0) const;
  Depth depth_in_arm(Side side, const HandState& state, const HandState& other_arm, double at_least = 0.0) const;
  /// How deep the forearm alone does, or how deep it does at least where that is `enough`.
  Depth forearm_depth(Side side, const HandState& state, double at_least, double enough) const;

  /// The hand hanging beside the hip: the start and end of all signing.
  HandState rest(Side side) const;

 private:
  Signer(const Figure& figure, BodySites body, std::array<HandSites, 2> hands, bool seeks_longer);
  /// What is asked of a hand.
  struct Wish {
    Quat rotation = kIdentity;
    Vec3 pivot{0.0}, target{0.0};  ///< the part of the hand (wrist frame), and where it is to be
    bool free = false;             ///< in the air: the place may give way to the direction
    bool lifts = false;            ///< the elbow may be high
    double mirrored_at = 0.0;      ///< the sign of x on which the arm stays, its image on the other; 0: no matter
  };

  /// What of a hand is to come where.
  struct Meeting {
    HandPart part = HandPart::kPalm;
    Site local;            ///< of the part, wrist frame
    Site site;             ///< world
    bool contact = false;  ///< the entry names one, be it only to be near
  };
  /// Brings a hand, posed and turned as the entry states it, to its place: on what it touches, out of all else, within
  /// the arm's limits.
  void bring(Side side, const Meeting& meeting, const OtherHand& counterpart, PlacedHand& placed) const;

  /// The elbow's place and the hand's lean for which the limits of the arm and the room for the forearm ask. Returns by
  /// how much the place gave way, metres.
  Vec3 settle(Side side, const Wish& wish, std::span<const Obstacle> obstacles, HandState& state) const;
  /// A hand in the air that leans by more than anyone is to see, though the arm could show what is stated with its
  /// elbow elsewhere: puts the elbow there, no farther than it takes.
  void turn_true(Side side, const Wish& wish, std::span<const Obstacle> of_arm, HandState& state) const;
  /// How deep forearm and elbow are in something, or beyond the plane between an arm and its image, metres; once it is
  /// `enough`, nothing deeper is looked for.
  double arm_depth(Side side, const HandState& state, std::span<const Obstacle> obstacles, double mirrored_at,
                   double enough) const;
  /// How high the elbow is lifted, of the upper arm's length: 0 up to 30 degrees below the level, half at the level.
  double elbow_height(Side side, const ArmSolution& arm) const;
  /// How many times over what is not seen the worst of a fit is: gap, depth of the hand and of the forearm, leaning,
  /// and what the arm's limits take away.
  double trouble(Side side, const Wish& wish, bool touches, std::span<const Obstacle> of_arm, const HandState& state,
                 const HandFit& fit) const;
  Depth coarse_depth(Side side, const HandState& state, std::span<const Obstacle> obstacles, double at_least) const;
  /// A few points of a hand, world space.
  std::array<PlacedPatch, 16> hand_points(Side side, const HandState& state) const;
  void add_forearm(Side side, const HandState& state, std::vector<Obstacle>& obstacles) const;
  /// Head, neck and trunk at rest; `touches`: the hand is to touch them.
  std::vector<Obstacle> body_obstacles(bool touches) const;
  /// The other arm with its hand.
  void add_other_arm(Side other_side, const HandState& other, bool touches, std::vector<Obstacle>& obstacles) const;
  /// A hand alone, in the frame in which `wrist` is given.
  std::vector<Obstacle> hand_obstacles(Side side, const Transform& wrist, const HandAngles& angles, double allowed,
                                       bool touches) const;
  /// The surface of a hand in the wrist's frame.
  std::vector<SurfacePatch> hand_patches(Side side, const HandAngles& angles) const;
  /// The surface of the forearm and of the lower half of the upper arm, world space.
  std::array<PlacedPatch, 2> arm_patches(Side side, const HandState& state) const;
  /// The points of a hand within `radius` of a site that face as it does, by the cosine `facing` at least; the site
  /// itself where there is none; wrist frame.
  static std::vector<Vec3> points_about(const Site& site, std::span<const SurfacePatch> hand, double radius,
                                        double facing);
  /// The place on the other hand or arm, world space.
  Site other_site(Location location, HandPart touching, Side other_side, const HandState& other, const Vec3& comes_from,
                  const Vec3& offset) const;

  const Figure* figure_;
  bool seeks_longer_;  ///< on this figure what does not come right at once is sought for longer
  BodySites body_;
  std::array<HandSites, 2> hands_;
  BodySurface surface_;
  std::array<ArmReach, 2> reach_;
  std::array<HandFrame, 2> frames_;
  std::array<ArmNodes, 2> nodes_;
  std::array<Vec3, 2> trunk_;                    ///< the node that carries the arm, world, at rest
  std::array<SurfacePatch, 2> lower_upper_arm_;  ///< the half of an upper arm that the trunk does not hold; node frame
};

}  // namespace auslan
