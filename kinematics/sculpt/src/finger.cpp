// SPDX-License-Identifier: Apache-2.0
// The fifteen phalanges of the left hand, with their nails. X runs along the fingers, Y out of the back of the hand, Z
// to the thumb.
#include "kinematics/elementary.h"
#include "layout.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace auslan::sculpt {

namespace {

const DigitMeasurements& measures_of(const Measurements& table, int digit) {
  return table.digits[static_cast<size_t>(digit)];
}

/// Half the breadth of a digit at a joint; beyond the last joint, at the tip.
double half_breadth(const DigitMeasurements& m, size_t joint) {
  return joint < 3 ? 0.5 * m.breadths[joint] : 0.43 * m.breadths[2];
}

}  // namespace

Colour hand_colour(double facing) {
  const Colour skin(Pigment::kSkin);
  const Colour palm(Pigment::kPalm);
  return mix(palm, skin, smooth_step(-0.6, 0.4, facing));
}

Sculpture sculpt_phalanx(const Measurements& table, int digit, int bone) {
  const DigitMeasurements& m = measures_of(table, digit);
  const DigitLine line = digit_line(table, digit);
  const bool thumb = digit == 0;
  const bool last = bone == 2;
  const auto joint = static_cast<size_t>(bone);
  const Vec3 along = line.direction;
  const Vec3 back = line.back;
  const Vec3 side = glm::cross(along, back);
  const double bone_length = m.bones[joint] + (last ? m.tip : 0.0);
  const double near = half_breadth(m, joint);
  const double far = half_breadth(m, joint + 1);
  // A cap that lies inside its parent's must be the smaller of the two, or both surfaces flicker through each other.
  const double root = bone == 0 ? (thumb ? 0.94 : 0.9) * near : 0.965 * near;
  const double waist = (bone == 0 && thumb) ? mix(near, far, 0.62) : mix(near, far, 0.5) * (last ? 1.0 : 0.945);
  const Vec3 middle = along * (bone_length * 0.48);
  // The end ball's outermost point is the fingertip; other bones end in a ball round the next joint.
  const Vec3 end = along * (last ? bone_length - far : bone_length);

  const Field field = [=](const Vec3& p) {
    // Fingers are broader than thick: thickness is stretched before the distance is taken.
    const double height = glm::dot(p, back);
    const Vec3 q = p + back * (height * 0.10);
    double d = join(round_cone(q, Vec3(0.0), root, middle, waist), round_cone(q, middle, waist, end, far), 5.0);
    // The pad under the bone, fuller on the last one.
    const Vec3 pad_centre = along * (bone_length * (last ? 0.50 : 0.46)) - back * (waist * (last ? 0.26 : 0.22));
    const double pad_radius = waist * (last ? 0.90 : 0.88);
    const Vec3 pad_offset = q - pad_centre;
    const double lengthwise = glm::dot(pad_offset, along);
    const Vec3 across = pad_offset - along * lengthwise;
    const double stretched = length(across + along * (lengthwise * pad_radius / (bone_length * 0.52)));
    d = join(d, stretched - pad_radius, 3.0);
    if (last) {
      // The back of the fingertip is flattened under the nail.
      d = carve(d, -(height - 0.80 * far - 0.10 * (bone_length - glm::dot(p, along))), 3.0);
    }
    return d;
  };

  Tube tube;
  tube.start = Vec3(0.0);
  tube.end = end;
  tube.up = back;
  tube.reach = 40.0;
  tube.columns = thumb ? 24 : 20;
  tube.rows = last ? tube_rows(2, refined({0.0, 0.2, 0.4, 0.6, 0.8, 1.0}), 6)
                   : tube_rows(2, refined({0.0, 0.16, 0.36, 0.62, 0.84, 1.0}), 4);
  Grid grid = cast_tube(field, tube, Part::kSkin);

  // Where the nail lies, and how broad it is at each place along it.
  const double nail_half = far * 0.77;
  const double nail_from = bone_length * (thumb ? 0.42 : 0.44);
  const double nail_to = bone_length * 0.985;

  const Colour flush(Pigment::kFlush);
  const Colour crease = mix(flush, Pigment::kLips, 0.35) * 0.86;
  paint(grid, [&](const Vec3& p) {
    const double t = glm::dot(p, along);
    const Vec3 radial = normalised(p - along * t);
    const double facing = glm::dot(radial, back);
    Colour c = hand_colour(facing);
    if (!thumb) {
      // Between the fingers less light arrives: a darker tint there separates them.
      const double sideways = glm::dot(radial, side);
      c = c *
          mix(1.0, 0.86,
              smooth_step(0.55, 0.95, sideways < 0.0 ? -sideways : sideways) * (1.0 - smooth_step(0.6, 1.0, t / 40.0)));
    }
    // Knuckles are redder on the back, and folded on the palm's side.
    const double joint_near = bone > 0 ? 1.0 - smooth_step(0.0, 5.0, t < 0.0 ? -t : t) : 0.0;
    c = mix(c, flush, 0.55 * joint_near * smooth_step(0.1, 0.7, facing));
    // On the palm's side the skin folds: a line at each joint, on what lies before it and behind it alike; the finger's
    // root folds where the web begins.
    const double fold_at = bone > 0 || thumb ? 0.0 : kWebReach;
    const double behind = t - fold_at;
    const double before = last ? 1e3 : t - m.bones[joint];
    const double fold = std::min(behind < 0.0 ? -behind : behind, before < 0.0 ? -before : before);
    c = mix(c, crease, 0.62 * (1.0 - smooth_step(0.5, 2.4, fold)) * smooth_step(0.1, 0.6, -facing));
    if (last) {
      c = mix(c, flush, 0.6 * smooth_step(0.5, 1.0, t / bone_length));
      // The fold of skin round the nail.
      const double sideways = glm::dot(p, side);
      const double across = (sideways < 0.0 ? -sideways : sideways) - nail_half;
      const double rim = std::max(across, nail_from - t);
      c = mix(c, crease,
              0.5 * smooth_step(-1.0, 0.0, rim) * (1.0 - smooth_step(0.4, 2.0, rim)) * smooth_step(0.2, 0.6, facing));
    }
    return c;
  });
  Shape shape;
  append(shape, grid);

  if (last) {
    // The nail: a thin curved plate on the back of the tip, its root sunk in the skin.
    const double outline[5][2] = {{0.0, 0.55}, {0.14, 0.92}, {0.5, 1.0}, {0.82, 0.96}, {1.0, 0.62}};
    Grid nail(5, 8, false, Part::kNail);
    const Colour plate(Pigment::kNail);
    for (int row = 0; row < 5; ++row) {
      const double x = mix(nail_from, nail_to, outline[row][0]);
      const double width = nail_half * outline[row][1];
      for (int column = 0; column < 8; ++column) {
        const Angle turn = angle_deg(45.0 * column);
        const double across = turn.sine * width;
        const Vec3 foot = along * x + side * across;
        const Vec3 skin = cast(field, foot, back, 30.0);
        const bool sunk = row == 0;
        const double lift = turn.cosine > -0.1 ? (sunk ? -0.5 : 0.35 + 0.3 * turn.cosine) : -1.6;
        nail.at(row, column).point = skin + back * lift;
        nail.at(row, column).colour = row == 4 ? Pigment::kNailTip : plate;
      }
    }
    const auto pole = [&](double x) {
      Vertex v;
      v.point = cast(field, along * x, back, 30.0) - back * 0.6;
      v.colour = plate;
      return v;
    };
    nail.first_pole = pole(nail_from - 0.5);
    nail.last_pole = pole(nail_to + 0.15);
    append(shape, nail);
  }
  Sculpture made = finish(shape);
  // Bent at both ends; the ball of the thumb does not bend at its root.
  const auto half = [&](size_t at) {
    return at == 0 ? 0.2 * m.bones[0] : (at == 1 ? 0.34 * std::min(m.bones[0], m.bones[1]) : 0.3 * m.bones[1]);
  };
  for (const double degrees : {100.0, -40.0}) {
    std::vector<Turning> joints;
    if (!(thumb && bone == 0)) joints.push_back({Vec3(0.0), along, side, -half(joint), half(joint), degrees, 0.0});
    if (!last)
      joints.push_back({along * m.bones[joint], along, side, -half(joint + 1), half(joint + 1), 0.0, -degrees});
    made.poses.push_back(turned(points_of(shape), joints));
  }
  return made;
}

}  // namespace auslan::sculpt
