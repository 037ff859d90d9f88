// SPDX-License-Identifier: Apache-2.0
// Rotations as unit quaternions, rotation vectors and Euler angles, without the C library's trigonometry.
// A rotation vector is axis * angle (radians); its quaternion is (cos(angle/2), axis sin(angle/2)).
#pragma once

#include "kinematics/vector.h"

namespace auslan {

/// Rotation by `radians`, counter-clockwise seen against `unit_axis`.
Quat axis_angle(const Vec3& unit_axis, double radians);
/// The shortest rotation vector of a unit quaternion, of length at most pi. q and -q give the same vector, except at
/// exactly pi, where the sign of the first non-zero component decides.
Vec3 rotation_vector(const Quat& q);
Quat from_rotation_vector(const Vec3& v);

/// The shortest rotation that takes the direction of `from` to that of `to` (any non-zero lengths; a zero vector gives
/// the identity). For opposite vectors it is the half turn about the cross product of `from` with the world axis it is
/// least aligned with (ties: X before Y before Z).
Quat rotation_between(const Vec3& from, const Vec3& to);
/// The angle of the rotation that leads from one orientation to the other, in [0, pi]; accurate for small angles too.
double angle_between(const Quat& a, const Quat& b);
/// q scaled to unit length; the identity when q is zero or not finite.
Quat renormalised(const Quat& q);
/// v scaled to unit length; `fallback` when v is shorter than 1e-12.
Vec3 unit(const Vec3& v, const Vec3& fallback = Vec3(1.0, 0.0, 0.0));
/// The rotation that takes the frame spanned by (a0, b0) to that spanned by (a1, b1): a0 goes to a1 exactly, b0 to the
/// half plane of b1. w >= 0. All unit; b is made perpendicular to a first and must not be parallel to it.
Quat rotation_between_frames(const Vec3& a0, const Vec3& b0, const Vec3& a1, const Vec3& b1);

struct SwingTwist {
  Quat swing = kIdentity;  ///< turns about an axis perpendicular to the twist axis
  Quat twist = kIdentity;  ///< turns about the axis, w >= 0
};
/// q = swing * twist. The twist is the identity when the swing is a half turn, where it is not defined.
SwingTwist swing_twist(const Quat& q, const Vec3& unit_axis);
/// Signed angle of the twist about the axis, in (-pi, pi].
double twist_angle(const Quat& q, const Vec3& unit_axis);

/// Intrinsic axis orders: kXYZ turns about X, then about the new Y, then about the newest Z, so that the rotation is
/// Rx * Ry * Rz (the same as the extrinsic order Z, Y, X about fixed axes).
enum class EulerOrder { kXYZ, kXZY, kYXZ, kYZX, kZXY, kZYX };
/// The order of the interpolation experiment of the paper, section 4.2: of the six it is the only one for which
/// (90, 270, 90) and (0, 270, 0) degrees are the same orientation, as the paper says they are. With the middle angle
/// at 270 the outer two turn about opposite axes there: Rx(a) Ry(270) Rz(c) = Ry(270) Rz(c - a).
inline constexpr EulerOrder kPaperOrder = EulerOrder::kXYZ;

/// `radians` holds the angle about X, Y and Z in its x, y and z, whatever the order.
Quat from_euler(const Vec3& radians, EulerOrder order);
/// The angles whose middle one (in the order) lies in [-pi/2, pi/2]. Within 1e-7 of gimbal lock the last angle is 0.
Vec3 to_euler(const Quat& q, EulerOrder order);

}  // namespace auslan
