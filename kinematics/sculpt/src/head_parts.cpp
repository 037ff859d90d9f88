// SPDX-License-Identifier: Apache-2.0
// What stands on or in the head as closed parts of its own: eyeballs, brows, ears, hair, teeth and tongue.
#include "head.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace auslan::sculpt {

void append_eyes(Shape& shape, const HeadSpace& space, const Measurements& table) {
  const Vec3 centre(space.eye_x, 0.0, kEyeZ);
  const Colour iris = colour_of(table.iris);
  const Colour white(238.0, 235.0, 230.0);
  const Colour pupil(14.0, 12.0, 14.0);
  struct Ring {
    double from_front_deg;
    Colour colour;
  };
  // Pairs of rings close together keep the borders of pupil and iris sharp.
  const Ring rings[] = {{140.0, white * 0.9}, {95.0, white * 0.92}, {66.0, white * 0.95}, {42.0, white},
                        {29.5, white},        {28.3, iris * 0.42},  {25.0, iris * 0.9},   {18.0, iris * 1.1},
                        {13.6, iris * 0.8},   {12.6, pupil},        {6.0, pupil}};
  constexpr int kColumns = 18;
  const auto first = static_cast<uint32_t>(shape.vertices.size());
  const size_t first_index = shape.triangles.size();
  Grid grid(static_cast<int>(std::size(rings)), kColumns, false, Part::kEyeball);
  for (int row = 0; row < grid.rows; ++row) {
    const Angle tilt = angle_deg(rings[row].from_front_deg);
    for (int column = 0; column < kColumns; ++column) {
      const Angle turn = angle_deg(360.0 * column / kColumns);
      Vertex& v = grid.at(row, column);
      v.point = centre + Vec3(turn.cosine * tilt.sine, turn.sine * tilt.sine, tilt.cosine) * kEyeRadius;
      // The upper lid's shadow.
      v.colour = rings[row].colour * mix(1.0, 0.66, smooth_step(1.0, 7.0, v.point.y));
    }
  }
  grid.first_pole.point = centre - Vec3(0.0, 0.0, kEyeRadius);
  grid.first_pole.colour = white * 0.9;
  grid.last_pole.point = centre + Vec3(0.0, 0.0, kEyeRadius);
  grid.last_pole.colour = pupil;
  append(shape, grid);

  // The light's reflection: a small lens on the cornea.
  Grid glint(2, 8, false, Part::kEyeball);
  const Angle up = angle_deg(13.0);
  const Vec3 out(0.0, up.sine, up.cosine);
  const Vec3 foot = centre + out * kEyeRadius;
  const Vec3 rise(0.0, up.cosine, -up.sine);
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 8; ++column) {
      const Angle turn = angle_deg(45.0 * column);
      Vertex& v = glint.at(row, column);
      v.point = foot + (Vec3(1.0, 0.0, 0.0) * turn.cosine + rise * turn.sine) * (row == 0 ? 1.5 : 1.35) +
                out * (row == 0 ? -0.3 : 0.12);
      v.colour = Colour(255.0);
    }
  }
  glint.first_pole.point = foot - out * 0.8;
  glint.last_pole.point = foot + out * 0.22;
  glint.first_pole.colour = glint.last_pole.colour = Colour(255.0);
  append(shape, glint);
  append_mirrored(shape, first, first_index);
}

void append_brows(Shape& shape, const HeadSpace& space, const Measurements& table) {
  const Field field = head_field(space);
  const Colour hair = colour_of(table.hair) * 0.92;
  constexpr int kRows = 11;
  const auto first = static_cast<uint32_t>(shape.vertices.size());
  const size_t first_index = shape.triangles.size();
  Grid brow(kRows, 8, false, Part::kBrow);
  const auto middle = [&](double t) {
    const double x = mix(space.eye_x - 19.0, space.eye_x + 17.5, t);
    const double arch = 1.0 - (t - 0.62) * (t - 0.62) / 0.3844;
    const double y = 15.5 + 6.6 * arch - 2.4 * t;
    return Vec3(x, y, cast(field, Vec3(x, y, 20.0), Vec3(0.0, 0.0, 1.0), 150.0).z);
  };
  for (int row = 0; row < kRows; ++row) {
    const double t = row / (kRows - 1.0);
    const Vec3 centre = middle(t);
    const double half = mix(3.3, 1.1, t * t) * mix(0.72, 1.0, smooth_step(0.0, 0.15, t));
    for (int column = 0; column < 8; ++column) {
      const Angle turn = angle_deg(45.0 * column);
      Vertex& v = brow.at(row, column);
      const double y = centre.y + half * turn.cosine;
      const double z = cast(field, Vec3(centre.x, y, 20.0), Vec3(0.0, 0.0, 1.0), 150.0).z;
      v.point = Vec3(centre.x, y, z + (turn.sine > 0.5 ? 1.5 : (turn.sine < -0.5 ? -2.0 : -0.2)) + 0.3);
      v.colour = hair;
    }
  }
  brow.first_pole.point = middle(0.0) + Vec3(-1.5, 0.0, 0.1);
  brow.last_pole.point = middle(1.0) + Vec3(1.5, -0.6, 0.0);
  brow.first_pole.colour = brow.last_pole.colour = hair;
  append(shape, brow);
  append_mirrored(shape, first, first_index);
}

void append_ears(Shape& shape, const HeadSpace&, const Measurements& table) {
  const Colour skin = colour_of(table.skin);
  const Vec3 centre(71.5, -13.0, -4.0);
  const Vec3 out = normalised(Vec3(0.90, 0.0, 0.40));
  const Vec3 ahead = normalised(Vec3(-0.40, -0.12, 0.90));
  const Vec3 up = glm::cross(ahead, out);
  struct Ring {
    double size, height, tone;
  };
  // From behind the ear over its rim into the hollow.
  const Ring rings[] = {{0.50, -12.0, 0.9}, {0.80, 0.0, 0.9},  {0.98, 5.0, 0.97}, {1.0, 7.5, 1.0},  {0.92, 9.0, 1.0},
                        {0.80, 6.0, 0.84},  {0.64, 7.6, 0.96}, {0.46, 3.0, 0.78}, {0.24, 0.8, 0.68}};
  constexpr int kColumns = 16;
  const auto first = static_cast<uint32_t>(shape.vertices.size());
  const size_t first_index = shape.triangles.size();
  Grid ear(static_cast<int>(std::size(rings)), kColumns, false, Part::kEar);
  for (int row = 0; row < ear.rows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const Angle turn = angle_deg(360.0 * column / kColumns);
      const double width = mix(12.0, 18.5, smooth_step(-1.0, 0.6, turn.cosine));
      // The front edge lies against the head.
      const double flat = turn.sine > 0.0 ? 0.72 : 1.0;
      const Ring& ring = rings[row];
      Vertex& v = ear.at(row, column);
      v.point = centre + up * (turn.cosine * 31.0 * ring.size) + ahead * (turn.sine * width * flat * ring.size) +
                out * (ring.height - 7.0 * smooth_step(0.2, 1.0, turn.sine));
      v.colour = skin * Vec3(1.0, 0.95, 0.94) * ring.tone;
    }
  }
  ear.first_pole.point = centre - out * 14.0;
  ear.last_pole.point = centre + out * 0.4;
  ear.first_pole.colour = ear.last_pole.colour = skin * 0.66;
  append(shape, ear);
  append_mirrored(shape, first, first_index);
}

void append_hair(Shape& shape, const HeadSpace& space, const Measurements& table) {
  const Field field = head_field(space);
  const Colour hair = colour_of(table.hair);
  // How far down the hair reaches, column by column: below 1 a lean of the ray from the crown, above it a height.
  constexpr double kReach[kHeadHalfColumns] = {0.80, 0.80, 0.80, 0.80, 0.80, 0.805, 0.81, 0.815, 0.82, 0.83, 0.84, 0.86,
                                               0.89, 0.94, 1.10, 1.45, 1.95, 2.02,  1.62, 1.62,  2.55, 2.80, 2.85};
  constexpr double kAlong[] = {1.06, 1.0, 0.96, 0.87, 0.76, 0.64, 0.51, 0.38, 0.25, 0.12};
  constexpr double kLift[] = {-5.0, -0.5, 4.0, 7.2, 9.0, 10.0, 10.6, 11.0, 11.2, 11.2};
  Grid grid(static_cast<int>(std::size(kAlong)), 2 * (kHeadHalfColumns - 1), true, Part::kHair);
  const auto at = [&](int column, double reach, double lift) {
    const HeadColumn from = head_column(space, column);
    const double tilt_deg = reach < 1.0 ? 90.0 * (1.0 - reach) : 0.0;
    const Angle tilt = angle_deg(tilt_deg);
    const Angle turn = angle_deg(from.turn_deg);
    const double y = reach < 1.0 ? 36.0 : 36.0 - 58.0 * (reach - 1.0);
    const Vec3 origin(from.origin_x * tilt.cosine, y, mix(18.0, 0.0, smooth_step(0.0, 60.0, tilt_deg)));
    const Vec3 direction(turn.sine * tilt.cosine, tilt.sine, turn.cosine * tilt.cosine);
    return cast(field, origin, direction, 150.0) + direction * lift;
  };
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < kHeadHalfColumns; ++column) {
      // A wave along the hair's edge, and strands of two tones.
      const double reach = kReach[column] * kAlong[row];
      const double thin = column >= 16 && column <= 17 ? 0.55 : 1.0;
      Vertex& v = grid.at(row, column);
      v.point = at(column, reach, kLift[row] * (kLift[row] > 0.0 ? thin : 1.0));
      v.colour = hair * (column % 2 == 0 ? 1.0 : 1.16) * mix(0.86, 1.0, smooth_step(0.0, 3.0, row));
    }
  }
  grid.first_pole.point = Vec3(0.0, 10.0, 0.0);
  grid.last_pole.point = at(0, 0.0, 11.2);
  grid.first_pole.colour = grid.last_pole.colour = hair;
  append(shape, grid);
}

void append_mouth_parts(Shape& shape) {
  // Upper teeth: a band on an arc, hidden above the lips' line until they part.
  Grid teeth(13, 8, false, Part::kTeeth);
  constexpr double kRadius = 25.0;
  const Vec3 middle(0.0, -62.6, 64.0);
  for (int row = 0; row < teeth.rows; ++row) {
    const Angle turn = angle_deg(-66.0 + 11.0 * row);
    const Vec3 radial(turn.sine, 0.0, turn.cosine);
    for (int column = 0; column < 8; ++column) {
      const Angle round = angle_deg(45.0 * column);
      Vertex& v = teeth.at(row, column);
      v.point = middle + radial * (kRadius + 1.8 * round.sine) + Vec3(0.0, 4.2 * round.cosine, 0.0);
      v.colour = Colour(240.0, 236.0, 226.0) * (row % 2 == 0 ? 1.0 : 0.97);
    }
  }
  const auto end = [&](double degrees) {
    const Angle turn = angle_deg(degrees);
    Vertex v;
    v.point = middle + Vec3(turn.sine, 0.0, turn.cosine) * kRadius;
    v.colour = Colour(230.0, 224.0, 214.0);
    return v;
  };
  teeth.first_pole = end(-70.0);
  teeth.last_pole = end(70.0);
  const auto first = static_cast<uint32_t>(shape.vertices.size());
  append(shape, teeth);
  // The band is its own mirror image: row r is that of row -r.
  const auto vertex = [&](int row, int column) { return first + 1 + static_cast<uint32_t>(row * 8 + column); };
  for (int row = 0; row < teeth.rows; ++row) {
    for (int column = 0; column < 8; ++column) {
      Vertex& v = shape.vertices[vertex(row, column)];
      v.mirror = vertex(teeth.rows - 1 - row, column);
      if (2 * row == teeth.rows - 1) v.point.x = 0.0;
      if (v.mirror > vertex(row, column)) continue;
      const Vec3& other = shape.vertices[v.mirror].point;
      if (v.mirror != vertex(row, column)) v.point = Vec3(0.0 - other.x, other.y, other.z);
    }
  }
  const uint32_t last = first + 1 + static_cast<uint32_t>(teeth.rows * 8);
  shape.vertices[first].mirror = last;
  shape.vertices[last].mirror = first;
  shape.vertices[last].point =
      Vec3(0.0 - shape.vertices[first].point.x, shape.vertices[first].point.y, shape.vertices[first].point.z);

  // The tongue: a flat oval, thinner at its tip.
  Tube tube;
  tube.start = Vec3(0.0, -73.6, 62.0);
  tube.end = Vec3(0.0, -73.6, 76.0);
  tube.up = Vec3(0.0, 1.0, 0.0);
  tube.reach = 60.0;
  tube.columns = 14;
  tube.symmetric = true;
  tube.rows = tube_rows(2, {0.0, 0.5, 1.0}, 4);
  const Field field = [](const Vec3& p) { return ellipsoid(p, Vec3(0.0, -73.6, 68.0), Vec3(15.0, 4.4, 21.0)); };
  Grid tongue = cast_tube(field, tube, Part::kTongue);
  paint(tongue, [](const Vec3& p) { return Colour(196.0, 92.0, 96.0) * mix(0.6, 1.0, smooth_step(60.0, 82.0, p.z)); });
  append(shape, tongue);
}

}  // namespace auslan::sculpt
