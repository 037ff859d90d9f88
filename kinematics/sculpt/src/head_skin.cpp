// SPDX-License-Identifier: Apache-2.0
// The skin of the head: a grid whose rows follow the lids, the lips and the brows, so that each is one line of
// vertices. Front columns look straight ahead: there a vertex stands exactly where its row says. Other columns look
// outwards.
#include "head.h"

#include <algorithm>
#include <cmath>

namespace auslan::sculpt {

namespace {

/// A row from the crown down. Where the eye or mouth opens, its height is base + bulge * coefficient.
struct Row {
  double y = 0.0;
  double eye = 0.0;    ///< times eye_bulge
  double mouth = 0.0;  ///< times mouth_bulge
  Line line = Line::kNone;
  double tilt_deg = 0.0;  ///< rows of the crown and of the underside lean
  double sink = 0.0;      ///< how far behind the surface, in the middle of the opening
};

// clang-format off
constexpr Row kRows[] = {
    {46, 0, 0, Line::kNone, 80, 0}, {46, 0, 0, Line::kNone, 68, 0}, {46, 0, 0, Line::kNone, 55, 0},
    {46, 0, 0, Line::kNone, 42, 0}, {46, 0, 0, Line::kNone, 29, 0}, {46, 0, 0, Line::kNone, 17, 0},
    {46, 0, 0, Line::kNone, 7, 0}, {43, 0, 0, Line::kNone, 0, 0}, {36.5, 0, 0, Line::kNone, 0, 0},
    {31, 0, 0, Line::kNone, 0, 0}, {26.5, 0, 0, Line::kNone, 0, 0}, {22.5, 0, 0, Line::kNone, 0, 0},
    {18.5, 0, 0, Line::kNone, 0, 0}, {14, 1.0, 0, Line::kNone, 0, 0}, {9.6, 2.6, 0, Line::kNone, 0, 0},
    {6.4, 3.4, 0, Line::kNone, 0, 0}, {4.6, 4.2, 0, Line::kLidUpper, 0, 0}, {2.4, 4.6, 0, Line::kLidUpper, 0, 0},
    {0.9, 4.9, 0, Line::kLidUpper, 0, 0}, {0.6, 4.6, 0, Line::kLidUpper, 0, 1.7},
    {0.0, 0.0, 0, Line::kEyePocket, 0, 16},
    {-0.6, -3.9, 0, Line::kLidLower, 0, 1.4}, {-0.9, -4.3, 0, Line::kLidLower, 0, 0},
    {-2.6, -4.6, 0, Line::kLidLower, 0, 0}, {-5.6, -4.2, 0, Line::kNone, 0, 0}, {-10, -2.4, 0, Line::kNone, 0, 0},
    {-15, -1.0, 0, Line::kNone, 0, 0}, {-20.5, 0, 0, Line::kNone, 0, 0}, {-26, 0, 0, Line::kNone, 0, 0},
    {-31, 0, 0, Line::kNone, 0, 0}, {-35.5, 0, 0, Line::kNone, 0, 0}, {-39.5, 0, 0, Line::kNone, 0, 0},
    {-43, 0, 0, Line::kNone, 0, 0}, {-46, 0, 0, Line::kNone, 0, 0}, {-49, 0, 0, Line::kNone, 0, 0},
    {-53, 0, 0.6, Line::kNone, 0, 0}, {-58.5, 0, 3.0, Line::kNone, 0, 0},
    {-66.0, 0, 6.2, Line::kNone, 0, 0}, {-66.3, 0, 5.7, Line::kLipUpper, 0, 0}, {-66.8, 0, 3.0, Line::kLipUpper, 0, 0},
    {-67.2, 0, 0.2, Line::kLipUpper, 0, 1.5},
    {-67.35, 0, 0, Line::kMouthPocket, 0, 6}, {-67.5, 0, 0, Line::kMouthPocket, 0, 26},
    {-67.7, 0, 0, Line::kMouthPocket, 0, 26}, {-67.85, 0, 0, Line::kMouthPocket, 0, 6},
    {-68.0, 0, -0.2, Line::kLipLower, 0, 1.5}, {-68.4, 0, -3.6, Line::kLipLower, 0, 0},
    {-68.9, 0, -7.6, Line::kLipLower, 0, 0}, {-69.2, 0, -8.3, Line::kNone, 0, 0},
    {-74, 0, -7.0, Line::kNone, 0, 0}, {-81, 0, -4.0, Line::kNone, 0, 0}, {-87.5, 0, -1.5, Line::kNone, 0, 0},
    {-92, 0, 0, Line::kNone, 0, 0}, {-92, 0, 0, Line::kNone, -17, 0}, {-92, 0, 0, Line::kNone, -34, 0},
    {-92, 0, 0, Line::kNone, -52, 0}, {-92, 0, 0, Line::kNone, -72, 0}};
// clang-format on
constexpr int kRowCount = static_cast<int>(std::size(kRows));

constexpr double kTop = 46.0;
constexpr double kBottom = -92.0;

double square(double x) {
  return x * x;
}

}  // namespace

double eye_bulge(const HeadSpace& space, double x) {
  return positive(1.0 - square((x - space.eye_x) / kEyeHalfWidth));
}
double mouth_bulge(double x) {
  return positive(1.0 - square(x / kMouthHalfWidth));
}
double upper_lid(const HeadSpace& space, double x) {
  return 0.9 + 4.9 * eye_bulge(space, x) + 0.09 * (x - space.eye_x) * eye_bulge(space, x);
}
double lower_lid(const HeadSpace& space, double x) {
  return -0.9 - 4.3 * eye_bulge(space, x);
}

HeadColumn head_column(const HeadSpace& space, int column) {
  // From the middle of the face over the eye's inner corner, its centre and its outer corner to the side and round.
  constexpr double kEyeColumns[] = {-1.0, -0.8, -0.57, -0.3, 0.0, 0.3, 0.57, 0.8, 1.0};
  constexpr double kSide[][2] = {{1.0, 12.0},   {0.95, 26.0}, {0.85, 42.0}, {0.7, 60.0}, {0.5, 80.0},
                                 {0.35, 102.0}, {0.2, 126.0}, {0.1, 153.0}, {0.0, 180.0}};
  const double inner = space.eye_x - kEyeHalfWidth;
  if (column < 5) return {inner * column / 5.0, 0.0};
  if (column < 14) return {space.eye_x + kEyeHalfWidth * kEyeColumns[column - 5], 0.0};
  return {(space.eye_x + kEyeHalfWidth) * kSide[column - 14][0], kSide[column - 14][1]};
}

void append_skin(Shape& shape, const HeadSpace& space, const Measurements& table) {
  const Field field = head_field(space);
  const Colour skin = colour_of(table.skin);
  const Colour lips = colour_of(table.lips);
  const Colour lash = mix(colour_of(table.hair), Colour(20.0, 14.0, 12.0), 0.5);
  Grid grid(kRowCount, 2 * (kHeadHalfColumns - 1), true, Part::kSkin);
  for (int i = 0; i < kRowCount; ++i) {
    const Row& row = kRows[i];
    for (int column = 0; column < kHeadHalfColumns; ++column) {
      const HeadColumn from = head_column(space, column);
      const Angle turn = angle_deg(from.turn_deg);
      const Angle tilt = angle_deg(row.tilt_deg);
      // Sides and back are spaced evenly whatever the face needs in front.
      const double even = mix(kTop, kBottom + 14.0, clamp01((i - 6.0) / (kRowCount - 11.0)));
      const double base = mix(row.y, row.tilt_deg > 0.0 ? kTop : (row.tilt_deg < 0.0 ? kBottom : even),
                              smooth_step(20.0, 85.0, from.turn_deg));
      // Towards the chin the columns draw together, and start further forward.
      const double low = smooth_step(68.0, 94.0, -base);
      const double x = from.origin_x * mix(1.0, 0.52, low) * tilt.cosine;
      const double eye = from.turn_deg == 0.0 ? eye_bulge(space, x) : 0.0;
      const double mouth = from.turn_deg == 0.0 ? mouth_bulge(x) : 0.0;
      double y = base + row.eye * eye + row.mouth * mouth;
      if (row.eye > 4.0) y += 0.09 * (x - space.eye_x) * eye;
      // The bow of the upper lip dips in the middle.
      if (row.mouth > 5.0) y -= 1.5 * positive(1.0 - x / 6.5);
      const double z = mix(mix(20.0, 40.0, low), 0.0, smooth_step(10.0, 60.0, row.tilt_deg));
      const Vec3 direction(turn.sine * tilt.cosine, tilt.sine, turn.cosine * tilt.cosine);
      Vertex& v = grid.at(kRowCount - 1 - i, column);
      v.point = cast(field, Vec3(x, y, z), direction, 150.0);
      v.line = row.line;
      const double opening =
          row.line == Line::kMouthPocket || row.line == Line::kLipUpper || row.line == Line::kLipLower ? mouth : eye;
      v.point.z -= row.sink * std::sqrt(opening);
    }
  }
  grid.first_pole.point = cast(field, Vec3(0.0, kBottom, 40.0), Vec3(0.0, -1.0, 0.0), 150.0);
  grid.last_pole.point = cast(field, Vec3(0.0, kTop, 0.0), Vec3(0.0, 1.0, 0.0), 150.0);

  const auto tint = [&](Vertex& v) {
    const Vec3 q(v.point.x < 0.0 ? -v.point.x : v.point.x, v.point.y, v.point.z);
    Colour c = skin;
    const Colour flush = skin * Vec3(0.985, 0.86, 0.84);
    c = mix(c, flush, 0.55 * (1.0 - smooth_step(0.0, 22.0, length(q - Vec3(40.0, -32.0, 68.0)))));
    c = mix(c, flush, 0.45 * (1.0 - smooth_step(4.0, 16.0, length(q - Vec3(0.0, -38.0, 112.0)))));
    // Less light reaches the inner corner of the eye, the crease of the lid, the folds beside nose and chin, the
    // nostrils.
    c = c * mix(0.84, 1.0, smooth_step(4.0, 13.0, length(q - Vec3(space.eye_x - 15.0, 5.0, 80.0))));
    c = c * mix(0.90, 1.0, smooth_step(3.0, 9.0, length(q - Vec3(20.0, -43.0, 88.0))));
    c = c * mix(0.90, 1.0, smooth_step(3.0, 10.0, length((q - Vec3(0.0, -83.0, 92.0)) * Vec3(0.5, 1.0, 1.0))));
    c = c * mix(0.38, 1.0, smooth_step(3.2, 5.2, length(q - Vec3(6.6, -45.5, 99.5))));
    c = c * mix(1.0, 0.84, smooth_step(100.0, 112.0, -q.y));
    if (v.point.z > 0.0) {
      const double eye = eye_bulge(space, q.x);
      const double mouth = mouth_bulge(q.x);
      const double crease = q.y - upper_lid(space, q.x) - 3.0;
      if (eye > 0.0 && v.line != Line::kEyePocket)
        c = c * mix(1.0, mix(0.80, 1.0, smooth_step(0.0, 1.6, crease < 0.0 ? -crease : crease)), std::sqrt(eye));
      const bool at_edge = q.y < upper_lid(space, q.x) + 0.2;
      if (v.line == Line::kLidUpper && at_edge && eye > 0.0) c = lash;
      if (v.line == Line::kLidLower && q.y > lower_lid(space, q.x) - 0.2 && eye > 0.0)
        c = skin * Vec3(0.80, 0.62, 0.60);
      if (v.line == Line::kEyePocket && eye > 0.0) c = skin * Vec3(0.55, 0.38, 0.36);
      if ((v.line == Line::kLipUpper || v.line == Line::kLipLower) && mouth > 0.0) {
        c = mix(skin, v.line == Line::kLipUpper ? lips * 0.90 : lips, smooth_step(0.0, 0.12, mouth));
        const double off_line = q.y - kMouthY;
        if (off_line < 0.7 && off_line > -0.7) c = lips * 0.52;
      }
      if (v.line == Line::kMouthPocket && mouth > 0.0) c = Colour(58.0, 18.0, 20.0);
    }
    v.colour = c;
  };
  for (Vertex& v : grid.points)
    tint(v);
  tint(grid.first_pole);
  tint(grid.last_pole);
  append(shape, grid);
}

}  // namespace auslan::sculpt
