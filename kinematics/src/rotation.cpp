// SPDX-License-Identifier: Apache-2.0
#include "kinematics/rotation.h"

#include "kinematics/elementary.h"

#include <array>
#include <cmath>

namespace auslan {
namespace {

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

Vec3 vector_part(const Quat& q) {
  return {q.x, q.y, q.z};
}

Quat quat(double w, const Vec3& v) {
  return {w, v.x, v.y, v.z};
}

// The three axes of an order, and +1 when they are an even permutation of X, Y, Z.
struct Axes {
  std::array<int, 3> of;
  double parity;
};

Axes axes_of(EulerOrder order) {
  switch (order) {
    case EulerOrder::kXYZ:
      return {{0, 1, 2}, 1.0};
    case EulerOrder::kXZY:
      return {{0, 2, 1}, -1.0};
    case EulerOrder::kYXZ:
      return {{1, 0, 2}, -1.0};
    case EulerOrder::kYZX:
      return {{1, 2, 0}, 1.0};
    case EulerOrder::kZXY:
      return {{2, 0, 1}, 1.0};
    case EulerOrder::kZYX:
      return {{2, 1, 0}, -1.0};
  }
  return {{0, 1, 2}, 1.0};
}

Vec3 world_axis(int index) {
  Vec3 axis(0.0);
  axis[index] = 1.0;
  return axis;
}

}  // namespace

Quat axis_angle(const Vec3& unit_axis, double radians) {
  double s = 0.0;
  double c = 0.0;
  sine_cosine(0.5 * radians, s, c);
  return quat(c, unit_axis * s);
}

Vec3 rotation_vector(const Quat& q) {
  Vec3 v = vector_part(q);
  double w = q.w;
  if (w == 0.0) {
    const double first = v.x != 0.0 ? v.x : (v.y != 0.0 ? v.y : v.z);
    if (first < 0.0) v = -v;
  } else if (w < 0.0) {
    v = -v;
    w = -w;
  }
  const double s = length(v);
  if (s < 1e-12) return 2.0 * v;
  return v * (2.0 * arc_tangent(s, w) / s);
}

Quat from_rotation_vector(const Vec3& v) {
  const double angle = length(v);
  if (angle < 1e-4) {
    // sin(a/2)/a and cos(a/2) to the second order; the next terms are below 1e-17.
    const double a2 = angle * angle;
    return renormalised(quat(1.0 - a2 / 8.0, v * (0.5 - a2 / 48.0)));
  }
  double s = 0.0;
  double c = 0.0;
  sine_cosine(0.5 * angle, s, c);
  return quat(c, v * (s / angle));
}

Quat rotation_between(const Vec3& from, const Vec3& to) {
  const double scale = std::sqrt(glm::dot(from, from)) * std::sqrt(glm::dot(to, to));
  if (!(scale > 1e-300)) return kIdentity;
  const Vec3 a = unit(from);
  const Vec3 b = unit(to);
  const Vec3 half = a + b;
  if (glm::dot(half, half) > 1e-24) {
    // Between nearly opposite vectors the sum is mostly rounding, but it is known to be perpendicular to the
    // difference.
    const Vec3 difference = a - b;
    const double square = glm::dot(difference, difference);
    const Vec3 h = unit(square > 1.0 ? half - difference * (glm::dot(half, difference) / square) : half);
    return renormalised(quat(glm::dot(a, h), glm::cross(a, h)));
  }
  const double x = a.x < 0.0 ? -a.x : a.x;
  const double y = a.y < 0.0 ? -a.y : a.y;
  const double z = a.z < 0.0 ? -a.z : a.z;
  const int least = (x <= y && x <= z) ? 0 : (y <= z ? 1 : 2);
  return quat(0.0, unit(glm::cross(a, world_axis(least))));
}

double angle_between(const Quat& a, const Quat& b) {
  const Quat relative = glm::conjugate(a) * b;
  const double w = relative.w < 0.0 ? -relative.w : relative.w;
  return 2.0 * arc_tangent(length(vector_part(relative)), w);
}

Quat renormalised(const Quat& q) {
  const double square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  if (!(square > 1e-300 && square < 1e300)) return kIdentity;
  const double scale = 1.0 / std::sqrt(square);
  return {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
}

Vec3 unit(const Vec3& v, const Vec3& fallback) {
  const double n = length(v);
  if (!(n >= 1e-12)) return fallback;
  return v * (1.0 / n);
}

Quat rotation_between_frames(const Vec3& a0, const Vec3& b0, const Vec3& a1, const Vec3& b1) {
  const Vec3 c0 = unit(glm::cross(a0, b0));
  const Vec3 c1 = unit(glm::cross(a1, b1));
  const Mat3 from(a0, glm::cross(c0, a0), c0);
  const Mat3 to(a1, glm::cross(c1, a1), c1);
  const Quat q = renormalised(glm::quat_cast(to * glm::transpose(from)));
  return q.w < 0.0 ? -q : q;  // so that mirrored frames give exactly mirrored quaternions
}

SwingTwist swing_twist(const Quat& q, const Vec3& unit_axis) {
  const double along = glm::dot(vector_part(q), unit_axis);
  const double n = std::sqrt(q.w * q.w + along * along);
  if (n < 1e-12) return {q, kIdentity};
  const double scale = (q.w < 0.0 ? -1.0 : 1.0) / n;
  const Quat twist = quat(q.w * scale, unit_axis * (along * scale));
  return {q * glm::conjugate(twist), twist};
}

double twist_angle(const Quat& q, const Vec3& unit_axis) {
  const Quat twist = swing_twist(q, unit_axis).twist;
  return 2.0 * arc_tangent(glm::dot(vector_part(twist), unit_axis), twist.w);
}

Quat from_euler(const Vec3& radians, EulerOrder order) {
  const Axes axes = axes_of(order);
  Quat q = kIdentity;
  for (const int axis : axes.of)
    q = q * axis_angle(world_axis(axis), radians[axis]);
  return q;
}

Vec3 to_euler(const Quat& q, EulerOrder order) {
  const Axes axes = axes_of(order);
  const int i = axes.of[0];
  const int j = axes.of[1];
  const int k = axes.of[2];
  const Mat3 columns = glm::mat3_cast(q);
  const auto at = [&](int row, int column) { return columns[column][row]; };
  const double cosine_of_middle = std::sqrt(at(i, i) * at(i, i) + at(i, j) * at(i, j));
  Vec3 angles(0.0);
  angles[j] = arc_tangent(axes.parity * at(i, k), cosine_of_middle);
  if (cosine_of_middle > 1e-7) {
    angles[i] = arc_tangent(-axes.parity * at(j, k), at(k, k));
    angles[k] = arc_tangent(-axes.parity * at(i, j), at(i, i));
  } else {
    angles[i] = arc_tangent(axes.parity * at(k, j), at(j, j));
  }
  return angles;
}

}  // namespace auslan
