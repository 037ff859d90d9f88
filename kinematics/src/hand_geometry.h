// SPDX-License-Identifier: Apache-2.0
// The axes of a hand's joints, as anatomy.cpp derives them from the rest geometry; limits.cpp reads the same ones.
#pragma once

#include "kinematics/anatomy.h"

namespace auslan {

/// Placement of the thumb's metacarpal: the first three members of ThumbPose.
struct ThumbCarriage {
  double radial_abduction = 0.0, palmar_abduction = 0.0, opposition = 0.0;
};

struct FingerAxes {
  Vec3 bone;                 ///< from the mp to the pip joint at rest
  std::array<Vec3, 3> bend;  ///< flexion axis of mp, pip, dip
  double rest_splay = 0.0;   ///< angle of the bone from the hand's axis towards the thumb's side
  double outward = 1.0;      ///< +1 when abduction leads to the thumb's side, -1 when away from it
};

struct HandGeometry {
  HandFrame frame;
  Vec3 spread_axis;  ///< a positive turn about it leads from the fingers' direction to the thumb's side
  std::array<FingerAxes, 4> fingers;

  Vec3 thumb_zero;         ///< along the index's metacarpal, in the palm's plane
  Vec3 thumb_out;          ///< in the palm's plane, perpendicular to it, to the thumb's side
  Vec3 thumb_bone;         ///< cmc to mp at rest
  Vec3 thumb_pad;          ///< rest_thumb_pad
  Vec3 thumb_mp_axis;      ///< flexion axis, in the frame of the cmc node
  Vec3 thumb_ip_axis;      ///< flexion axis, in the frame of the mp node
  Quat thumb_mp_straight;  ///< what the mp node needs to bring the phalanx into line with the metacarpal
};

HandGeometry hand_geometry(const Skeleton& skeleton, const ArmNodes& nodes, Side side);

/// Local rotation of the cmc node, and back.
Quat thumb_rotation(const HandGeometry& hand, const ThumbCarriage& carriage);
ThumbCarriage thumb_carriage(const HandGeometry& hand, const Quat& local);

}  // namespace auslan
