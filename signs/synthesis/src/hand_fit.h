// SPDX-License-Identifier: Apache-2.0
// A hand on what it touches, and out of everything else: small shifts and turns of the wrist, found by damped least
// squares (Levenberg's) on the figure's own surfaces.
#pragma once

#include "synthesis/body_surface.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace auslan {

/// How far off a surface the points of a hand are kept that touches it, and those of a hand or an arm that does not,
/// metres: what lies between the points goes deeper than they do.
inline constexpr double kTouchesWithin = 0.0012, kKeepsOff = 0.003;

/// What a hand may come near to.
struct Obstacle {
  const DistanceField* field = nullptr;
  Transform world_from_solid;
  Vec3 centre{0.0};      ///< of a ball that holds it, world
  double radius = 0.0;   ///< metres
  double allowed = 0.0;  ///< how deep below its surface; negative: the hand keeps away, metres
  bool touched = false;  ///< the contact is with this
};
Obstacle make_obstacle(const DistanceField& field, const Transform& world_from_solid, double allowed, bool touched);

/// The plane x = 0, in which a hand meets its mirror image: nothing of it goes beyond.
struct MirrorPlane {
  double side = -1.0;  ///< the sign of x on which the hand stays
  double allowed = 0.0;
  bool touched = false;
};

/// The other hand, whose points are to stay out of the hand that is fitted: a fingertip is too small to be met by the
/// points of a palm.
struct MetHand {
  Transform world_from_wrist;
  std::span<const SurfacePatch> patches;  ///< its surface, in its wrist's frame
  std::span<const Obstacle> own;          ///< the segments of the hand that is fitted, in its own wrist's frame
};

struct HandFitGoal {
  Quat wanted = kIdentity;       ///< world_from_wrist as the entry states it
  double free_lean = 0.0;        ///< radians from there that cost little
  Vec3 pivot{0.0}, target{0.0};  ///< what of the hand (wrist frame) is to be near which place
  std::span<const Vec3> region;  ///< points of which one has to touch (wrist frame); empty: no contact is asked for
  std::span<const Obstacle> obstacles;
  std::optional<MirrorPlane> mirror;
  std::optional<MetHand> met;
  /// Brings a wrist, and the swivel with it, to where the arm keeps its limits, turning about a point of the hand
  /// (wrist frame); returns the radians that are still missing.
  std::function<double(const Vec3& pivot, Transform& world_from_wrist, double& swivel)> admit;
};

struct HandFit {
  Transform wrist;
  double swivel = 0.0;
  Vec3 touching{0.0};    ///< the point of the region that is nearest to what is touched, wrist frame
  Vec3 normal{0.0};      ///< outwards, of what is touched there; zero: nothing is near
  double gap = 0.0;      ///< metres between them; negative: it presses in
  double deepest = 0.0;  ///< metres by which anything is deeper than allowed
  double cost = 0.0;     ///< of all that is not as wished, metres; contact counts twice, it is what is read
};

/// Moves the wrist, and the elbow with it, as little as it takes. Total: what cannot be met is approached. `missing`:
/// what admit() has returned for where it begins. What is far from a cost below `to_beat` after a few rounds is given
/// up.
HandFit fit_hand(const Transform& world_from_wrist, double swivel, std::span<const SurfacePatch> hand,
                 const HandFitGoal& goal, double missing = 0.0, double to_beat = 1e9);

/// How far a hand has to go along `way` (unit, world), turned as it is, until it is out of everything; metres. Total:
/// what it does not get out of within `farthest` is left.
double way_out(const Transform& world_from_wrist, std::span<const SurfacePatch> hand, const HandFitGoal& goal,
               const Vec3& way, double farthest);

/// Between which depths it matters how deep something lies, metres.
struct DepthsThatMatter {
  double more_than = 0.0;  ///< what lies no deeper counts as outside
  double enough = 1e9;     ///< once this is found nothing deeper is looked for
};

/// The deepest that any of the points lie beyond what their obstacle allows, and the way out; world space.
struct Depth;
Depth depth_in(std::span<const PlacedPatch> points, std::span<const Obstacle> obstacles,
               const DepthsThatMatter& matter = {});

}  // namespace auslan
