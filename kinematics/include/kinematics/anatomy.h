// SPDX-License-Identifier: Apache-2.0
// Arms and hands by their anatomical names: which nodes they are, where a hand's fingers and palm point, and what a
// handshape's joint angles are as rotations. All axes derive from the skeleton's rest geometry, so that any figure
// takes the same angles; the right hand is the mirror image of the left.
#pragma once

#include "kinematics/pose.h"
#include "kinematics/skeleton.h"

#include <array>
#include <memory>

namespace auslan {

enum class Side { kLeft, kRight };
inline constexpr Side other(Side side) {
  return side == Side::kLeft ? Side::kRight : Side::kLeft;
}

struct ArmNodes {
  int trunk = kNoNode;     ///< what carries the arm: the parent of the clavicle, or of the shoulder where there is none
  int clavicle = kNoNode;  ///< of figures that have one between trunk and shoulder; else kNoNode
  int shoulder = kNoNode, elbow = kNoNode, wrist = kNoNode;
  /// Thumb, index, middle, ring, little; each cmc, mp, ip (thumb) or mp, pip, dip.
  std::array<std::array<int, 3>, 5> digits{};
};
ArmNodes arm_nodes(const Skeleton& skeleton, Side side);

/// Directions of the hand at rest, in world axes (which are the wrist's). Unit and at right angles to each other;
/// left: fingers, palm, radial is left-handed, right: right-handed.
struct HandFrame {
  Vec3 fingers{1.0, 0.0, 0.0};  ///< from the wrist to the knuckle of the middle finger
  Vec3 palm{0.0, -1.0, 0.0};    ///< out of the palm: perpendicular to the fingers and to the line of the knuckles
  Vec3 radial{0.0, 0.0, 1.0};   ///< to the thumb's side
};
HandFrame rest_hand_frame(const Skeleton& skeleton, Side side);

/// world_from_wrist such that the hand's fingers axis points along `fingers` and the palm faces `palm` as nearly as
/// that allows. Lengths do not matter. When palm is within 1e-6 of parallel to fingers, or zero, the palm is where the
/// shortest rotation from rest would leave it.
Quat orient_hand(const HandFrame& rest, const Vec3& fingers, const Vec3& palm);

/// Joint angles of a finger, radians. Flexion bends towards the palm. Abduction leads away from the middle finger (the
/// middle finger: to the thumb's side), from fingers parallel to the middle one; it fades to a quarter as the mcp joint
/// flexes from 50 to 90 degrees, where the collateral ligaments of a real hand stop it.
struct DigitAngles {
  double mcp = 0.0, pip = 0.0, dip = 0.0, abduction = 0.0;

  friend bool operator==(const DigitAngles&, const DigitAngles&) = default;
};

/// Joint angles of the thumb, radians. At zero the thumb is straight and lies alongside the index's metacarpal, its pad
/// half towards the index, half towards where the palm faces.
struct ThumbPose {
  double radial_abduction = 0.0;  ///< out to the side in the plane of the palm; 65 degrees in a thumbs-up
  double palmar_abduction = 0.0;  ///< out of that plane to where the palm faces
  /// 0 to 1: pronation about the metacarpal, 90 degrees in all, pad towards the fingers. It swings the metacarpal up to
  /// 20 degrees across the palm, and from about half of it carries it out to an elevation of 53 degrees, as the saddle
  /// joint does, whatever little palmar abduction is asked for.
  double opposition = 0.0;
  double mp = 0.0, ip = 0.0;  ///< flexion towards the pad

  friend bool operator==(const ThumbPose&, const ThumbPose&) = default;
};

struct HandAngles {
  std::array<DigitAngles, 4> fingers;  ///< index, middle, ring, little
  ThumbPose thumb;

  friend bool operator==(const HandAngles&, const HandAngles&) = default;
};

/// Local rotations of the digits' joints: thumb first, from the root outwards.
using DigitRotations = std::array<std::array<Quat, 3>, 5>;

struct HandGeometry;

/// One hand of a skeleton, measured once and posed as often as wanted. Owns what it needs.
class HandRig {
 public:
  HandRig(const Skeleton& skeleton, Side side);
  DigitRotations rotations(const HandAngles& angles) const;

 private:
  std::shared_ptr<const HandGeometry> geometry_;
};

/// Writes the rotations of the fifteen digit nodes; leaves the others alone.
void pose_hand(const Skeleton& skeleton, Side side, const HandAngles& angles, Pose& pose);

/// Where the thumb's pad faces at rest, perpendicular to its metacarpal, world axes: what pose_hand takes the rest
/// geometry to be, and so what a figure's thumb has to be modelled after.
Vec3 rest_thumb_pad(const Skeleton& skeleton, Side side);

}  // namespace auslan
