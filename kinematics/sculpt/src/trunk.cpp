// SPDX-License-Identifier: Apache-2.0
// The trunk in its shirt, and the neck: both symmetric.
#include "kinematics/elementary.h"
#include "layout.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace auslan::sculpt {

namespace {

/// Half axes of the trunk at a height, as a table of the sculptor's own: where, how broad, how deep, how far forward.
struct Station {
  double height, half_breadth, half_depth, forward;
};

Station between(const std::vector<Station>& stations, double height) {
  if (height <= stations.front().height) return stations.front();
  for (size_t i = 1; i < stations.size(); ++i) {
    const Station& a = stations[i - 1];
    const Station& b = stations[i];
    if (height <= b.height) {
      const double t = smooth_step(0.0, 1.0, (height - a.height) / (b.height - a.height)) * 0.5 +
                       0.5 * (height - a.height) / (b.height - a.height);
      return {height, mix(a.half_breadth, b.half_breadth, t), mix(a.half_depth, b.half_depth, t),
              mix(a.forward, b.forward, t)};
    }
  }
  return stations.back();
}

double neck_radius(const Measurements& table) {
  return table.neck_circumference / (2.0 * kPi);
}

}  // namespace

Sculpture sculpt_trunk(const Measurements& table) {
  const TrunkJoints joints = trunk_joints(table);
  const auto up = [&](double world_height) { return world_height - joints.spine_base.y; };
  const Vec3 shoulder = joints.shoulder - joints.spine_base;
  const Vec3 neck = joints.neck_base - joints.spine_base;
  const Vec3 skull = joints.head_base - joints.spine_base;
  const double cloth = 5.0;  // the shirt stands off the body
  const double armpit = shoulder.y - 75.0;
  const double chest_half = 0.5 * table.chest_breadth + cloth;
  const double chest_deep = 0.5 * table.chest_depth;
  const double waist = up(table.hip_height + 85.0);
  const std::vector<Station> stations = {{-130.0, 0.5 * table.hip_breadth + 4.0, 0.5 * table.waist_depth + 6.0, -8.0},
                                         {-70.0, 0.5 * table.hip_breadth + cloth, 0.5 * table.waist_depth + 8.0, -8.0},
                                         {waist, 0.5 * table.waist_breadth - 4.0, 0.5 * table.waist_depth - 2.0, 0.0},
                                         {mix(waist, armpit, 0.55), chest_half - 2.0, chest_deep - 10.0, 2.0},
                                         {armpit, chest_half + 6.0, chest_deep - 8.0, -2.0},
                                         {shoulder.y, chest_half - 4.0, 78.0, -14.0}};
  // The neckline lies lower in front, where the neck leaves the trunk below the level of its back.
  const auto neckline = [=](double z) { return neck.y + 6.0 - 0.44 * (z + 55.0); };
  const Field shirt = [=](const Vec3& p) {
    const double bounded = p.y > shoulder.y ? shoulder.y : p.y;
    const Station s = between(stations, bounded);
    // A rounded box-like oval: flatter in front and at the back than an ellipse.
    const double x = (p.x < 0.0 ? -p.x : p.x) / s.half_breadth;
    const double z = (p.z - s.forward) / s.half_depth;
    const double x2 = x * x;
    const double z2 = z * z;
    const double ring = std::sqrt(std::sqrt(x2 * x2 + z2 * z2 + 1.1 * x2 * z2));
    double d = (ring - 1.0) * std::min(s.half_breadth, s.half_depth);
    const double lid = p.y - (shoulder.y + 4.0);
    d = -join(-d, -lid, 40.0);
    const double floor = -124.0 - p.y;
    d = -join(-d, -floor, 8.0);
    const Vec3 q(p.x < 0.0 ? -p.x : p.x, p.y, p.z);
    // Deltoid caps, the slope of the trapezius, collar bones, chest and shoulder blades.
    d = join(d, ball(q, shoulder + Vec3(-6.0, -4.0, 0.0), 54.0), 34.0);
    d = join(d, round_cone(q, neck + Vec3(26.0, -2.0, -12.0), 42.0, shoulder + Vec3(-4.0, 8.0, 0.0), 40.0), 30.0);
    d = join(d, ellipsoid(q, Vec3(62.0, armpit - 6.0, chest_deep - 52.0), Vec3(64.0, 56.0, 44.0)), 40.0);
    d = join(d, ellipsoid(q, Vec3(78.0, armpit + 8.0, 18.0 - chest_deep), Vec3(62.0, 70.0, 34.0)), 40.0);
    d = join(d, round_cone(p, neck + Vec3(0.0, -14.0, 4.0), 62.0, mix(neck, skull, 0.10), neck_radius(table) + 6.0),
             26.0);
    // The upper back runs straight from the nape to the shoulder blades.
    d = join(d, round_cone(p, neck + Vec3(0.0, -16.0, -10.0), 46.0, Vec3(0.0, armpit + 40.0, 58.0 - chest_deep), 62.0),
             30.0);
    d = join(d, ellipsoid(p, neck + Vec3(0.0, -62.0, 44.0), Vec3(84.0, 46.0, 40.0)), 36.0);
    d = -join(-d, -0.915 * (p.y - neckline(p.z)), 6.0);
    return d;
  };

  Shape shape;
  Tube tube;
  tube.start = Vec3(0.0, -112.0, -4.0);
  tube.end = Vec3(0.0, shoulder.y - 10.0, -14.0);
  tube.up = normalised(glm::cross(Vec3(1.0, 0.0, 0.0), normalised(tube.end - tube.start)));
  tube.spread_side = 100.0;
  tube.reach = 330.0;
  tube.columns = 72;
  tube.symmetric = true;
  tube.rows = {{0.0, -70.0}, {0.0, -20.0}, {0.0, -10.0}};
  for (int i = 0; i <= 27; ++i)
    tube.rows.push_back({i / 27.0, 0.0});
  for (const double tilt : refined({9.0, 18.0, 27.0, 36.0, 44.0, 52.0, 60.0, 67.0, 73.0, 79.0, 84.0}))
    tube.rows.push_back({1.0, tilt});
  Grid body = cast_tube(shirt, tube, Part::kCloth);
  const Colour cloth_colour(Pigment::kShirt);
  paint(body, [&](const Vec3& p) {
    // Soft folds: a little darker towards the hem and under the arms.
    const double low = 1.0 - smooth_step(-120.0, 40.0, p.y);
    const double under = (1.0 - smooth_step(20.0, 120.0, shoulder.y - 40.0 - p.y)) *
                         smooth_step(95.0, 150.0, p.x < 0.0 ? -p.x : p.x) *
                         (1.0 - smooth_step(shoulder.y - 60.0, shoulder.y - 10.0, p.y));
    return cloth_colour * (1.0 - 0.10 * low - 0.12 * under);
  });
  append(shape, body);

  // The collar: a ribbed band round the foot of the neck, higher at the back.
  const double collar_radius = neck_radius(table) + 9.0;
  Grid collar(48, 10, true, Part::kCloth);
  for (int row = 0; row < 48; ++row) {
    const Angle turn = angle_deg(7.5 * row);
    const Vec3 radial(turn.sine, 0.0, turn.cosine);
    const double front = 0.5 * (1.0 + turn.cosine);
    Vec3 centre = Vec3(neck.x, 0.0, neck.z + 3.0) + radial * (collar_radius + mix(-6.0, 2.0, front));
    centre.y = neckline(centre.z) - 1.0;
    const Vec3 tilted = normalised(Vec3(radial.x * -0.30, 1.0, radial.z * -0.30 + 0.30));
    for (int column = 0; column < 10; ++column) {
      const Angle round = angle_deg(36.0 * column);
      Vertex& v = collar.at(row, column);
      v.point = centre + radial * (round.sine * 4.5) + tilted * (round.cosine * 8.0);
      v.colour = cloth_colour * 0.80;
    }
  }
  append_ring(shape, collar);

  // Hips and thighs down to where no camera looks.
  const Colour trousers(Pigment::kTrousers);
  const double hip = 0.5 * table.hip_breadth;
  const Field legs = [=](const Vec3& p) {
    const Vec3 q(p.x < 0.0 ? -p.x : p.x, p.y, p.z);
    double d = ellipsoid(p, Vec3(0.0, -60.0, -10.0), Vec3(hip - 4.0, 90.0, 0.5 * table.waist_depth - 12.0));
    d = join(d, round_cone(q, Vec3(hip * 0.53, -90.0, -10.0), hip * 0.46, Vec3(hip * 0.5, -235.0, -4.0), hip * 0.43),
             30.0);
    // What lies between the thighs is closed: no camera looks there, and rays have an inside to start from.
    d = join(d, round_cone(p, Vec3(0.0, -90.0, -10.0), 62.0, Vec3(0.0, -235.0, -4.0), 48.0), 20.0);
    return d;
  };
  Tube below;
  below.start = Vec3(0.0, -220.0, -6.0);
  below.end = Vec3(0.0, -20.0, -6.0);
  below.up = Vec3(0.0, 0.0, 1.0);
  below.spread_side = hip * 0.5;
  below.reach = 330.0;
  below.columns = 24;
  below.symmetric = true;
  below.rows = tube_rows(2, {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}, 2);
  Grid seat = cast_tube(legs, below, Part::kCloth);
  paint(seat, [&](const Vec3&) { return trousers; });
  seat.weigh(0.1);
  append(shape, seat);
  return finish(shape);
}

Sculpture sculpt_neck(const Measurements& table) {
  const TrunkJoints joints = trunk_joints(table);
  const Vec3 top = joints.head_base - joints.neck_base;
  const double radius = neck_radius(table);
  const Field field = [=](const Vec3& p) {
    const Vec3 q(p.x < 0.0 ? -p.x : p.x, p.y, p.z);
    // Deeper than broad.
    const Vec3 oval(p.x * 1.08, p.y, p.z * 0.97);
    double d = round_cone(oval, Vec3(0.0, -24.0, 3.0), radius * 0.88, Vec3(0.0, top.y * 0.55, 12.0), radius * 0.98);
    d = join(d,
             round_cone(oval, Vec3(0.0, top.y * 0.5, 12.0), radius * 0.97, Vec3(0.0, top.y + 8.0, top.z - 12.0),
                        radius * 0.95),
             16.0);
    // The two muscles from behind the ear to the breastbone, and the larynx.
    d = join(d, round_cone(q, Vec3(47.0, top.y + 5.0, top.z - 12.0), 9.0, Vec3(12.0, -10.0, radius - 8.0), 7.0), 12.0);
    d = join(d, ball(p, Vec3(0.0, top.y * 0.48, radius + 7.0), 8.0), 12.0);
    return d;
  };
  Tube tube;
  tube.start = Vec3(0.0, -35.0, 4.0);
  tube.end = Vec3(0.0, top.y, 6.0);
  tube.up = Vec3(0.0, 0.0, 1.0);
  tube.reach = 140.0;
  tube.columns = 44;
  tube.symmetric = true;
  tube.rows = tube_rows(1, refined({0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 1.0}), 1);
  Grid grid = cast_tube(field, tube, Part::kSkin);
  const Colour skin(Pigment::kSkin);
  // Under the chin and above the collar less light arrives.
  paint(grid, [&](const Vec3& p) {
    const double chin = smooth_step(20.0, 80.0, p.y) * smooth_step(0.0, 60.0, p.z);
    return skin * (1.0 - 0.08 * chin) * (1.0 - 0.05 * (1.0 - smooth_step(-20.0, 25.0, p.y)));
  });
  Shape shape;
  append(shape, grid);
  Sculpture made = finish(shape);
  const Vec3 up(0.0, 1.0, 0.0);
  for (const double degrees : {60.0, -60.0})
    made.poses.push_back(
        turned(points_of(shape), {{top, up, Vec3(1.0, 0.0, 0.0), -0.9 * top.y, -0.1 * top.y, 0.0, degrees},
                                  {top, up, Vec3(0.0, 0.0, 1.0), -0.9 * top.y, -0.1 * top.y, 0.0, 40.0},
                                  {top, up, up, -0.9 * top.y, -0.1 * top.y, 0.0, degrees}}));
  return made;
}

}  // namespace auslan::sculpt
