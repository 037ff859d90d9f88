// SPDX-License-Identifier: Apache-2.0
// The palm of the left hand, from the wrist to the knuckles. X runs along the fingers, Y out of the back of the hand, Z
// to the thumb.
#include "kinematics/elementary.h"
#include "layout.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace auslan::sculpt {

Sculpture sculpt_palm(const Measurements& table) {
  const double wrist = table.wrist_circumference / (2.0 * kPi);
  const double thick = table.palm_thickness;
  const DigitLine thumb = digit_line(table, 0);
  std::array<DigitLine, 5> lines;
  for (int digit = 0; digit < 5; ++digit)
    lines[static_cast<size_t>(digit)] = digit_line(table, digit);
  const auto knuckle = [&](int digit) { return lines[static_cast<size_t>(digit)].joints[0]; };
  const double breadth = table.hand_breadth;
  const std::array<double, 5> radius = {0.0, 0.5 * table.digits[1].breadths[0], 0.5 * table.digits[2].breadths[0],
                                        0.5 * table.digits[3].breadths[0], 0.5 * table.digits[4].breadths[0]};

  constexpr double kWebHalf = 3.6;  // half its thickness
  const auto knuckle_at = [lines](int digit) { return lines[static_cast<size_t>(digit)].joints[0]; };
  // Places in the palm are those of a mean hand.
  const Vec3 size(table.hand_length / 187.0, thick / 29.0, breadth / 83.0);
  const auto sized = [size](double x, double y, double z) { return Vec3(x, y, z) * size; };
  const Field field = [=](const Vec3& p) {
    // Wrist: an oval stub that runs back into the forearm's end.
    const Vec3 q(p.x, p.y * 1.42, p.z);
    double d = round_cone(q, Vec3(-4.0, 0.0, 0.0), wrist * 1.06, Vec3(14.0, 0.0, 0.0), wrist * 1.1);
    // One ray of bone and muscle for each finger, from the carpus to a ball round the knuckle.
    for (int digit = 1; digit <= 4; ++digit) {
      const Vec3 head = lines[static_cast<size_t>(digit)].joints[0];
      const Vec3 base = sized(20.0, -1.0, 0.0) + Vec3(0.0, 0.0, head.z * 0.48);
      const double r = radius[static_cast<size_t>(digit)];
      d = join(d, round_cone(p, base, thick * 0.46, head, r), digit == 1 ? 10.0 : 7.0);
      // The knuckle stands out on the back, and the tendon that runs up to it from the wrist.
      d = join(d, ball(p, head + Vec3(-3.0, 2.2, 0.0), r * 0.94), 4.0);
      d = join(
          d, round_cone(p, Vec3(30.0 * size.x, thick * 0.40, head.z * 0.62), 2.0, head + Vec3(-8.0, r - 1.2, 0.0), 2.2),
          6.0);
    }
    // The pads under the knuckles and the heel of the little finger's side; the hollow between them.
    d = join(d, ellipsoid(p, sized(84.0, -7.0, 8.0), sized(14.0, 8.5, 28.2)), 7.0);
    d = join(d, ellipsoid(p, sized(78.0, -7.5, -20.0), sized(14.0, 8.0, 14.0)), 7.0);
    d = join(d, ellipsoid(p, sized(36.0, -8.0, -19.0), sized(30.0, 11.0, 14.0)), 8.0);
    // The ball of the thumb and the web that ties the thumb to the index's metacarpal.
    const Vec3 thenar = thumb.joints[0] + thumb.direction * (16.0 * size.x) + sized(4.0, -2.0, -4.0);
    d = join(d, ellipsoid(p, thenar, sized(25.0, 12.0, 15.0)), 10.0);
    d = join(d,
             round_cone(p, sized(44.0, -4.0, 20.0), 10.0,
                        thumb.joints[0] + thumb.direction * (34.0 * size.x) + sized(-1.0, 0.0, -3.0), 6.5),
             12.0);
    // The webs between the fingers: one fold of skin along the knuckles, hidden in the fingers' roots where they are.
    for (int digit = 1; digit < 4; ++digit) {
      const Vec3 forward(kWebReach * size.x - kWebHalf, -3.5, 0.0);
      d = join(d, round_cone(p, knuckle_at(digit) + forward, kWebHalf, knuckle_at(digit + 1) + forward, kWebHalf), 6.0);
    }
    d = carve(d, ellipsoid(p, sized(56.0, -22.0, 0.0), sized(26.0, 9.5, 14.0)), 9.0);
    // Tendons leave shallow furrows between the knuckles on the back.
    for (int digit = 1; digit < 4; ++digit) {
      const Vec3 furrow =
          mix(lines[static_cast<size_t>(digit)].joints[0], lines[static_cast<size_t>(digit) + 1].joints[0], 0.5);
      d = carve(d, ellipsoid(p, furrow + sized(2.0, 12.5, 0.0), sized(19.0, 5.0, 4.5)), 4.0);
    }
    return d;
  };

  Tube tube;
  tube.start = Vec3(2.0, -1.0, 0.0);
  tube.end = Vec3(knuckle(2).x - 7.0, -2.0, -1.0);
  tube.up = Vec3(0.0, 1.0, 0.0);
  tube.spread_side = breadth * 0.40;
  tube.reach = 90.0;
  tube.columns = 72;
  tube.rows =
      tube_rows(0, refined({0.0, 0.07, 0.14, 0.22, 0.3, 0.38, 0.46, 0.54, 0.62, 0.7, 0.78, 0.86, 0.93, 1.0}), 9);
  // At the wrist rays start close to the axis; further on from the whole breadth.
  Grid grid(static_cast<int>(tube.rows.size()) + 2, tube.columns, false, Part::kSkin);
  const auto ring = [&](int row, double spread, double start_x, double tilt_deg) {
    const Angle tilt = angle_deg(tilt_deg);
    for (int column = 0; column < tube.columns; ++column) {
      const Angle turn = angle_deg(360.0 * column / tube.columns);
      const Vec3 origin(start_x, mix(-1.0, -2.0, clamp01(start_x / 90.0)), turn.sine * spread * tilt.cosine);
      const Vec3 direction(tilt.sine, turn.cosine * tilt.cosine, turn.sine * tilt.cosine);
      grid.at(row, column).point = cast(field, origin, direction, tube.reach);
    }
  };
  ring(0, 0.0, 2.0, -60.0);
  ring(1, 3.0, 2.0, -30.0);
  for (int row = 0; row < static_cast<int>(tube.rows.size()); ++row) {
    const TubeRow& spec = tube.rows[static_cast<size_t>(row)];
    ring(row + 2, mix(6.0, tube.spread_side, smooth_step(-0.1, 0.45, spec.along)),
         mix(tube.start.x, tube.end.x, spec.along), spec.tilt_deg);
  }
  grid.first_pole.point = cast(field, tube.start, Vec3(-1.0, 0.0, 0.0), tube.reach);
  grid.last_pole.point = cast(field, tube.end, Vec3(1.0, 0.0, 0.0), tube.reach);

  const Colour skin(Pigment::kSkin);
  const Colour flush(Pigment::kFlush);
  const auto colour_at = [&](const Vec3& p, const Vec3& normal) {
    Colour c = hand_colour(normal.y);
    for (int digit = 1; digit <= 4; ++digit) {
      const double near = length(p - knuckle(digit) - Vec3(0.0, 7.0, 0.0));
      c = mix(c, flush, 0.6 * (1.0 - smooth_step(3.0, 10.0, near)) * smooth_step(0.0, 0.6, normal.y));
    }
    // The webs between the fingers, and the lines of the palm: round the thumb's ball and across below the fingers.
    const double ahead = smooth_step(0.35, 0.85, normal.x) * smooth_step(60.0, 75.0, p.x / size.x);
    c = c * mix(1.0, 0.88, ahead);
    if (normal.y < -0.2) {
      const Vec3 q = p / size;
      const double arc = length(Vec3(q.x - 28.0, 0.0, (q.z - 32.0) * 1.25)) - 34.0;
      const double heart = q.x - 76.0 + 0.006 * (q.z - 26.0) * (q.z - 26.0);
      const double line = std::min(arc < 0.0 ? -arc : arc, heart < 0.0 ? -heart : heart);
      c = c * mix(0.90, 1.0, smooth_step(0.8, 3.4, line));
    }
    return c;
  };
  Shape shape;
  append(shape, grid);
  const std::vector<Vec3> normals = smooth_normals(shape);
  for (size_t i = 0; i < shape.vertices.size(); ++i)
    shape.vertices[i].colour = colour_at(shape.vertices[i].point, normals[i]);
  Sculpture made = finish(shape);
  // The wrist bends at its beginning, the knuckles at its end.
  const Vec3 along(1.0, 0.0, 0.0), side(0.0, 0.0, 1.0), up(0.0, 1.0, 0.0);
  const double half = 0.075 * table.forearm;
  const double gap = length(knuckle(1) - knuckle(4)) / 3.0;
  for (const double degrees : {-90.0, 40.0}) {
    std::vector<Turning> joints = {{Vec3(0.0), along, side, -half, half, -0.8 * degrees, 0.0},
                                   {Vec3(0.0), along, up, -half, half, 0.4 * degrees, 0.0}};
    for (int digit = 1; digit <= 4; ++digit) {
      const double reach = 0.2 * table.digits[static_cast<size_t>(digit)].bones[0];
      const double splay = (digit % 2 == 0 ? 0.3 : -0.3) * degrees;
      joints.push_back({knuckle(digit), along, up, -reach, reach, 0.0, splay, 0.5 * gap, gap});
      joints.push_back({knuckle(digit), along, side, -reach, reach, 0.0, degrees, 0.5 * gap, gap});
    }
    made.poses.push_back(turned(points_of(shape), joints));
  }
  return made;
}

}  // namespace auslan::sculpt
