// SPDX-License-Identifier: Apache-2.0
// The head as one blend of round forms, in the mean head's millimetres.
#include "head.h"

namespace auslan::sculpt {

double skull_field(const Vec3& point, double eye_x) {
  const Vec3 p(point.x < 0.0 ? 0.0 - point.x : point.x, point.y, point.z);
  // Cranium and forehead.
  double d = ellipsoid(p, {0.0, 84.0, 0.0}, {75.0, 77.0, 94.0});
  d = join(d, ellipsoid(p, {0.0, 84.0, 50.0}, {58.0, 54.0, 48.0}), 14.0);
  // The skull's base over the neck.
  d = join(d, round_cone(p, {0.0, 20.0, -18.0}, 58.0, {0.0, -8.0, -10.0}, 52.0), 16.0);
  // Middle of the face, jaw, chin.
  d = join(d, ellipsoid(p, {0.0, 16.0, 40.0}, {60.0, 64.0, 54.0}), 14.0);
  d = join(d, round_cone(p, {40.0, -18.0, 24.0}, 14.0, {12.0, -51.0, 80.0}, 13.5), 28.0);
  d = join(d, ellipsoid(p, {0.0, -53.0, 84.0}, {19.0, 13.0, 16.0}), 14.0);
  d = join(d, round_cone(p, {0.0, -40.0, 70.0}, 20.0, {0.0, -26.0, 20.0}, 34.0), 20.0);
  // Cheekbones and the flesh below.
  d = join(d, ellipsoid(p, {45.0, 24.0, 54.0}, {20.0, 17.0, 25.0}), 18.0);
  d = join(d, ellipsoid(p, {36.0, -4.0, 56.0}, {21.0, 30.0, 28.0}), 20.0);
  // The outer rim of the eye socket runs into the temple.
  d = join(d, round_cone(p, {54.0, 66.0, 52.0}, 14.0, {54.0, 36.0, 52.0}, 13.0), 14.0);
  // Muzzle, brow ridge.
  d = join(d, ellipsoid(p, {0.0, -17.0, 72.0}, {33.0, 26.0, 30.0}), 12.0);
  d = join(d, round_cone(p, {8.0, 67.0, 84.0}, 12.0, {46.0, 66.0, 66.0}, 12.0), 14.0);
  // Eye sockets.
  d = carve(d, ellipsoid(p, {eye_x + 0.3, 52.0, 95.0}, {16.0, 11.0, 17.5}), 7.0);
  // The flesh that carries the lower lid.
  d = join(d, ellipsoid(p, {eye_x - 0.5, 34.5, 71.0}, {21.0, 8.5, 13.5}), 7.0);
  // Nose: bridge, tip, wings.
  d = join(d, round_cone(p, {0.0, 54.0, 88.0}, 7.5, {0.0, 14.0, 108.0}, 9.5), 11.0);
  d = join(d, ball(p, {0.0, 9.0, 110.0}, 11.0), 5.0);
  d = join(d, ellipsoid(p, {10.5, 5.5, 101.0}, {7.2, 6.6, 9.5}), 9.0);
  // Lips: two rolls that meet in a groove.
  const double back = 0.011 * p.x * p.x;
  const double thin = 1.0 - smooth_step(6.0, 27.0, p.x);
  const double end = 30.0 * smooth_step(18.0, 36.0, p.x);
  // The corners lie a little higher: a face at rest, not a stern one.
  const Vec3 q(0.0, p.y - kMouthLift * p.x * p.x, p.z + back);
  d = join(d, ball(q, {0.0, kMouthY + 4.6, 100.0}, 3.0 + 3.6 * thin) + end, 6.0 * (0.4 + thin));
  d = join(d, ball(q, {0.0, kMouthY - 5.0, 98.5}, 3.0 + 4.2 * thin) + end, 6.0 * (0.4 + thin));
  return d;
}

Vec3 field_normal(const Vec3& p, double eye_x) {
  // A wide difference: folds narrower than the mesh should not show in its shading.
  constexpr double kStep = 1.5;
  const auto slope = [&](const Vec3& step) { return skull_field(p + step, eye_x) - skull_field(p - step, eye_x); };
  return normalised(Vec3(slope({kStep, 0.0, 0.0}), slope({0.0, kStep, 0.0}), slope({0.0, 0.0, kStep})));
}

}  // namespace auslan::sculpt
