// SPDX-License-Identifier: Apache-2.0
// What the rooms of the head share. Everything is shaped for the mean head of the table (151 x 195 mm, face 118 mm) and
// stretched to the table's numbers at the very end, so that places on the face can be named by plain millimetres.
#pragma once

#include "kinematics/pose.h"
#include "layout.h"

#include <vector>

namespace auslan::sculpt {

/// Which piece of the head a vertex belongs to; its morphs follow from that.
enum class Piece : uint8_t {
  kSkin,
  kMouthPocket,
  kHair,
  kEar,
  kEyeball,
  kUpperLid,
  kLowerLid,
  kBrow,
  kUpperTeeth,
  kLowerTeeth,
  kTongue
};

/// A vertex's place in its piece. Skin and pocket: `ring` millimetres from the line between the lips (negative behind
/// it), `up` +1 straight above the mouth, -1 straight below. Lids: `ring` 0 at the margin to 1 at the hidden end, `up`
/// the place on the axis from corner to corner, -1 to 1. Brow and tongue: `up` 0 to 1 from the inner end, or the root,
/// to the other.
struct Site {
  Piece piece = Piece::kSkin;
  double ring = 0.0;
  double up = 0.0;
  double radius = 0.0;  ///< lids: distance from the eye's centre
};

struct Head {
  Shape shape;
  std::vector<Site> sites;  ///< one per vertex
  double eye_x = 0.0;       ///< the eyes' centres lie at +-eye_x, in the mean head's millimetres
};

inline constexpr double kEyeZ = 75.0;
inline constexpr double kBallRadius = 13.6;
inline constexpr double kMouthY = -23.0;
inline constexpr double kMouthZ = 104.0;
/// The line between the lips rises towards the corners by this much times x squared.
inline constexpr double kMouthLift = 0.0016;
/// Half the mouth's width.
inline constexpr double kMouthHalf = 24.5;

/// The head without hair, ears, eyes and the mouth's inside.
double skull_field(const Vec3& p, double eye_x);
/// Unit, out of the surface near p.
Vec3 field_normal(const Vec3& p, double eye_x);
/// The skin's colour at a place: redder cheeks, nose and chin, shade over the eyes, dark nostrils.
Colour skin_colour(const Vec3& p);

/// Skin with the mouth's pocket.
void add_skin(Head& head);
/// Hair and ears.
void add_hair(Head& head);
void add_ears(Head& head);
/// Eyeballs, lids and brows.
void add_eyes(Head& head);
/// Teeth and tongue.
void add_mouth(Head& head);
/// Appends a grid whose points have the given sites (poles first and last, as append() orders them). `both` appends the
/// mirror image as well.
void add_piece(Head& head, const Grid& grid, const std::vector<Site>& sites, bool both);

/// Where a lid's vertex is, relative to the left eye's centre, when the lid reaches from `margin_deg` above the horizon
/// to `hidden_deg`, where it lies under the skin.
Vec3 lid_point(const Site& site, double margin_deg, double hidden_deg);
/// The lids at rest.
inline constexpr double kUpperOpen = 24.0, kUpperHidden = 88.0, kLowerOpen = -27.0, kLowerHidden = -84.0;

/// The displacement of one vertex by one channel at weight 1, as if the channel were its left one.
Vec3 displacement(FaceChannel channel, const Site& site, const Vec3& p, double eye_x);
/// Every channel's morph of the finished mesh; `stretched` maps the mean head's points to the table's.
std::vector<Morph> face_morphs(const Head& head, const std::function<Vec3(const Vec3&)>& stretched);

}  // namespace auslan::sculpt
