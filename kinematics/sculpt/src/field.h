// SPDX-License-Identifier: Apache-2.0
// Signed-distance fields: negative inside, in millimetres, and the ray that finds their surface. Blends are polynomial,
// so that a field needs nothing but + - * / and sqrt.
#pragma once

#include "kinematics/vector.h"

#include <functional>

namespace auslan::sculpt {

using Field = std::function<double(const Vec3&)>;

double clamp01(double x);
double mix(double a, double b, double t);
Vec3 mix(const Vec3& a, const Vec3& b, double t);
/// 0 below `low`, 1 above `high`, cubic between; low < high.
double smooth_step(double low, double high, double x);
double length(const Vec3& v);
Vec3 normalised(const Vec3& v);
/// x where it is positive, else 0.
double positive(double x);

/// Distance to a ball, to an ellipsoid (first-order estimate), to a cone with round ends, to a capsule.
double ball(const Vec3& p, const Vec3& centre, double radius);
double ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii);
double round_cone(const Vec3& p, const Vec3& a, double radius_a, const Vec3& b, double radius_b);

/// Union, intersection-with-the-outside and their blends over `k` millimetres (Quilez's polynomial smooth minimum).
double join(double a, double b, double k);
double carve(double a, double b, double k);

/// The outermost point of the field's surface on a ray that starts inside, searched up to `reach`. The origin itself
/// when the ray meets no inside.
Vec3 cast(const Field& field, const Vec3& origin, const Vec3& direction, double reach);

/// A point on the unit circle.
struct Angle {
  double cosine = 1.0;
  double sine = 0.0;
};
/// Cosine and sine of an angle in degrees, within 1e-15; exact at multiples of 90.
Angle angle_deg(double degrees);

}  // namespace auslan::sculpt
