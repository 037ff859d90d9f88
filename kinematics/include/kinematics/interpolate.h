// SPDX-License-Identifier: Apache-2.0
// Between two orientations, and through many of them. Times are seconds.
#pragma once

#include "kinematics/rotation.h"
#include "kinematics/vector.h"

#include <span>
#include <vector>

namespace auslan {

/// Straight line between quaternions, the short way, renormalised: the right path at a varying speed. t in [0, 1].
Quat lerp_normalised(const Quat& a, const Quat& b, double t);
/// The short way at constant angular velocity (Shoemake 1985); below 1e-6 radians apart it is lerp_normalised, which
/// differs there by less than rounding. t in [0, 1].
Quat slerp(const Quat& a, const Quat& b, double t);
/// Straight line between Euler angles (radians by axis), turned into a quaternion: what the paper compares the two
/// with.
Quat lerp_euler(const Vec3& a, const Vec3& b, double t, EulerOrder order);

/// Progress of a movement of least jerk, 10t^3 - 15t^4 + 6t^5 (Flash & Hogan 1985); tau is clamped to [0, 1].
double minimum_jerk(double tau);

struct RotationKey {
  double time = 0.0;
  Quat rotation = kIdentity;
  bool hold = false;  ///< the movement comes to rest here: angular velocity and acceleration are zero
};

/// A smooth rotation through keys. Between two keys it is a polynomial in the rotation vector from the first of them;
/// angular velocity is continuous everywhere. At a key within the track it is the mean of the neighbouring chords'
/// velocities weighted by the other's duration, at an end key that is no hold the chord's own. So two keys without
/// holds give slerp, and two holds give a minimum-jerk movement along the slerp path.
class RotationTrack {
 public:
  RotationTrack() = default;
  /// Keys in ascending time; a key that is not later than the one before it replaces that one.
  explicit RotationTrack(std::span<const RotationKey> keys);

  /// The rotation at a time; before the first and after the last key that key's, the identity without keys.
  Quat sample(double time) const;
  bool empty() const { return keys_.empty(); }
  double start() const { return keys_.empty() ? 0.0 : keys_.front().time; }
  double end() const { return keys_.empty() ? 0.0 : keys_.back().time; }

 private:
  struct Segment {
    Vec3 chord;     ///< rotation vector to the next key
    Vec3 out_rate;  ///< derivative of the rotation vector at both ends, per unit of the segment's duration
    Vec3 in_rate;
  };
  std::vector<RotationKey> keys_;
  std::vector<Segment> segments_;
};

struct ScalarKey {
  double time = 0.0;
  double value = 0.0;
  bool hold = false;  ///< rate and its derivative are zero here
};

/// A smooth scalar through keys, likewise; between two keys it never leaves the range of their values.
class ScalarTrack {
 public:
  ScalarTrack() = default;
  explicit ScalarTrack(std::span<const ScalarKey> keys);
  /// The value at a time; 0 without keys.
  double sample(double time) const;
  bool empty() const { return keys_.empty(); }

 private:
  std::vector<ScalarKey> keys_;
  std::vector<double> rates_;  ///< per second, one per key
};

}  // namespace auslan
