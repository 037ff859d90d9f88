// SPDX-License-Identifier: Apache-2.0
// The left upper arm with its sleeve, and the left forearm.
#include "kinematics/elementary.h"
#include "layout.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace auslan::sculpt {

Sculpture sculpt_upper_arm(const Measurements& table) {
  const TrunkJoints joints = trunk_joints(table);
  const double span = joints.elbow.x - joints.shoulder.x;
  const double arm = table.upper_arm_circumference / (2.0 * kPi);
  const double elbow = arm * 0.86;
  const Field skin_field = [=](const Vec3& p) {
    const Vec3 q(p.x, p.y, p.z);
    double d = round_cone(q, Vec3(0.0), arm, Vec3(span * 0.55, 0.0, 0.0), arm * 0.96);
    d = join(d, round_cone(q, Vec3(span * 0.55, 0.0, 0.0), arm * 0.95, Vec3(span, 0.0, 0.0), elbow), 12.0);
    // Biceps in front (palms down, the front of the arm faces forward), the point of the elbow behind.
    d = join(d, ellipsoid(q, Vec3(span * 0.55, 0.0, 8.0), Vec3(80.0, arm * 0.84, arm * 0.92)), 14.0);
    d = join(d, ball(q, Vec3(span + 2.0, 0.0, 0.0 - elbow * 0.42), elbow * 0.64), 10.0);
    return d;
  };
  Tube tube;
  tube.end = Vec3(span, 0.0, 0.0);
  tube.start = Vec3(span * 0.5, 0.0, 0.0);
  tube.reach = 140.0;
  tube.columns = 36;
  tube.rows = tube_rows(1, refined({0.3, 0.6, 0.8, 1.0}), 4);
  Grid arm_grid = cast_tube(skin_field, tube, Part::kSkin);
  const Colour skin(Pigment::kSkin);
  paint(arm_grid, [&](const Vec3& p) { return skin * mix(0.90, 1.0, smooth_step(0.70, 0.82, p.x / span)); });

  // The sleeve: cloth from inside the trunk's shoulder to a hem above the elbow, wider than the arm and hollow there.
  const double hem = span * 0.74;
  const Field sleeve = [=](const Vec3& p) {
    double d = round_cone(p, Vec3(0.0, -1.0, 0.0), 55.0, Vec3(span * 0.35, -2.0, 2.0), arm + 9.0);
    d = join(d, round_cone(p, Vec3(span * 0.35, -2.0, 2.0), arm + 8.0, Vec3(hem + 60.0, -4.0, 2.0), arm + 11.0), 20.0);
    return d;
  };
  Tube cloth;
  cloth.end = Vec3(hem, 0.0, 0.0);
  cloth.reach = 140.0;
  cloth.columns = 36;
  cloth.rows = tube_rows(5, refined({0.0, 0.16, 0.33, 0.5, 0.67, 0.84, 0.93, 1.0}), 0);
  Grid outside = cast_tube(sleeve, cloth, Part::kCloth);
  const Colour shirt(Pigment::kShirt);
  paint(outside, [&](const Vec3& p) { return shirt * mix(1.0, 0.80, smooth_step(hem * 0.935, hem * 0.945, p.x)); });
  // Turn the hem inwards: two more rows that lead into the arm, closed there. A wall of its own, as thin as cloth,
  // would come through when the arm twists.
  Grid closed(outside.rows + 2, outside.columns, false, Part::kCloth);
  for (int row = 0; row < closed.rows; ++row) {
    for (int column = 0; column < closed.columns; ++column) {
      Vertex v = outside.at(std::min(row, outside.rows - 1), column);
      const int inner = row - (outside.rows - 1);
      if (inner > 0) {
        const double shrink = inner == 1 ? 0.93 : 0.78;
        v.point = Vec3(v.point.x - (inner == 1 ? 0.0 : 5.0), v.point.y * shrink, v.point.z * shrink);
        v.colour = shirt * (inner == 1 ? 0.72 : 0.4);
      }
      closed.at(row, column) = v;
    }
  }
  closed.first_pole = outside.first_pole;
  closed.last_pole.point = Vec3(hem - 40.0, 0.0, 0.0);
  closed.last_pole.colour = shirt * 0.4;
  Shape shape;
  append(shape, closed);
  append(shape, arm_grid);
  Sculpture made = finish(shape);
  const Vec3 along(1.0, 0.0, 0.0), up(0.0, 1.0, 0.0);
  const double half = 0.15 * table.forearm;
  for (const double degrees : {90.0, -90.0})
    made.poses.push_back(turned(points_of(shape), {{Vec3(0.0), along, along, 0.1 * span, 0.92 * span, -degrees, 0.0},
                                                   {Vec3(span, 0.0, 0.0), along, up, -half, half, 0.0, -130.0}}));
  return made;
}

Sculpture sculpt_forearm(const Measurements& table) {
  const double span = table.forearm;
  const double arm = table.forearm_circumference / (2.0 * kPi);
  const double elbow = table.upper_arm_circumference / (2.0 * kPi) * 0.86;
  const double wrist = table.wrist_circumference / (2.0 * kPi);
  const Field field = [=](const Vec3& p) {
    // Round at the elbow, an oval of half the thickness at the wrist (palms down: broad from front to back).
    const double flat = mix(1.0, 1.40, smooth_step(0.45, 1.0, p.x / span));
    const Vec3 q(p.x, p.y * flat, p.z);
    double d = round_cone(q, Vec3(0.0), elbow * 0.97, Vec3(span * 0.24, 0.0, 0.0), arm * 0.98);
    d = join(d, round_cone(q, Vec3(span * 0.24, 0.0, 0.0), arm, Vec3(span * 0.72, 0.0, 0.0), wrist * 1.14), 16.0);
    d = join(d, round_cone(q, Vec3(span * 0.72, 0.0, 0.0), wrist * 1.13, Vec3(span, 0.0, 0.0), wrist * 1.10), 16.0);
    // The muscle on the thumb's side, and the head of the ulna on the little finger's.
    d = join(d, ellipsoid(q, Vec3(span * 0.27, 2.0, 5.0), Vec3(84.0, arm * 0.97, arm * 0.96)), 14.0);
    d = join(d, ball(p, Vec3(span - 12.0, 8.0, 0.0 - wrist * 0.72), 8.5), 8.0);
    return d;
  };
  Tube tube;
  tube.end = Vec3(span, 0.0, 0.0);
  tube.reach = 90.0;
  tube.columns = 36;
  tube.rows = tube_rows(5, refined({0.0, 0.1, 0.22, 0.36, 0.5, 0.64, 0.78, 0.9, 1.0}), 4);
  Grid grid = cast_tube(field, tube, Part::kSkin);
  const Colour skin(Pigment::kSkin);
  paint(grid, [&](const Vec3&) { return skin; });
  Shape shape;
  append(shape, grid);
  Sculpture made = finish(shape);
  const Vec3 along(1.0, 0.0, 0.0), up(0.0, 1.0, 0.0), side(0.0, 0.0, 1.0);
  const double half_elbow = 0.15 * span, half_wrist = 0.075 * span;
  for (const double degrees : {90.0, -90.0})
    made.poses.push_back(
        turned(points_of(shape), {{Vec3(0.0), along, up, -half_elbow, half_elbow, 130.0, 0.0},
                                  {Vec3(0.0), along, along, 0.1 * span, 0.92 * span, -degrees, 0.0},
                                  {Vec3(span, 0.0, 0.0), along, side, -half_wrist, half_wrist, 0.0, 0.8 * degrees}}));
  return made;
}

}  // namespace auslan::sculpt
