// SPDX-License-Identifier: Apache-2.0
#include "field.h"

#include "kinematics/elementary.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace auslan::sculpt {

double clamp01(double x) {
  return x < 0.0 ? 0.0 : (x > 1.0 ? 1.0 : x);
}
double mix(double a, double b, double t) {
  return a + (b - a) * t;
}
Vec3 mix(const Vec3& a, const Vec3& b, double t) {
  return a + (b - a) * t;
}
double smooth_step(double low, double high, double x) {
  const double t = clamp01((x - low) / (high - low));
  return t * t * (3.0 - 2.0 * t);
}
double length(const Vec3& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}
Vec3 normalised(const Vec3& v) {
  const double norm = length(v);
  return norm > 0.0 ? v / norm : v;
}
double positive(double x) {
  return x > 0.0 ? x : 0.0;
}

double ball(const Vec3& p, const Vec3& centre, double radius) {
  return length(p - centre) - radius;
}

double ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii) {
  const Vec3 q = p - centre;
  const double k0 = length(q / radii);
  const double k1 = length(q / (radii * radii));
  return k1 > 0.0 ? k0 * (k0 - 1.0) / k1 : -radii.y;
}

double round_cone(const Vec3& p, const Vec3& a, double radius_a, const Vec3& b, double radius_b) {
  const Vec3 axis = b - a;
  const double t = clamp01(glm::dot(p - a, axis) / glm::dot(axis, axis));
  return length(p - (a + axis * t)) - mix(radius_a, radius_b, t);
}

double join(double a, double b, double k) {
  const double h = positive(k - (a > b ? a - b : b - a)) / k;
  return (a < b ? a : b) - h * h * k * 0.25;
}
double carve(double a, double b, double k) {
  return -join(-a, b, k);
}

Vec3 cast(const Field& field, const Vec3& origin, const Vec3& direction, double reach) {
  // Inwards by at least a hundred-and-sixtieth of the way, and by half of the distance that the field tells.
  const double least = reach / 160.0;
  double outside = reach;
  double inside = reach;
  for (double distance = field(origin + direction * inside); distance >= 0.0;
       distance = field(origin + direction * inside)) {
    if (inside <= 0.0) return origin;
    outside = inside;
    inside = positive(inside - (0.5 * distance > least ? 0.5 * distance : least));
  }
  for (int step = 0; step < 30; ++step) {
    const double middle = 0.5 * (inside + outside);
    (field(origin + direction * middle) < 0.0 ? inside : outside) = middle;
  }
  return origin + direction * (0.5 * (inside + outside));
}

Angle angle_deg(double degrees) {
  double rest = degrees;
  int quarter = 0;
  while (rest > 45.0) {
    rest -= 90.0;
    ++quarter;
  }
  while (rest < -45.0) {
    rest += 90.0;
    quarter += 3;
  }
  double sine = 0.0;
  double cosine = 1.0;
  sine_cosine(rest * kDegree, sine, cosine);
  switch (quarter % 4) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

}  // namespace auslan::sculpt
