// SPDX-License-Identifier: Apache-2.0
// The hair, a closed cap with the hairline as its edge, and the ears.
#include "head.h"

#include <iterator>

namespace auslan::sculpt {

namespace {

/// Seen from here the hairline is a height angle for every bearing.
const Vec3 kHairCentre(0.0, 70.0, 0.0);

struct HairlinePoint {
  double bearing_deg;    ///< from straight ahead towards the side
  double elevation_deg;  ///< of the hairline
};
/// Forehead, receding at the temple, sideburn, free ear, nape.
constexpr HairlinePoint kHairline[] = {{0.0, 29.0},   {20.0, 29.5},   {34.0, 28.0},   {46.0, 22.0},   {56.0, 8.0},
                                       {62.0, -4.0},  {67.0, -24.0},  {82.5, -27.0},  {87.0, -6.0},   {92.0, 0.0},
                                       {104.0, -2.0}, {113.0, -22.0}, {124.0, -40.0}, {145.0, -46.0}, {180.0, -48.0}};

double hairline(double bearing_deg) {
  size_t i = 0;
  while (kHairline[i + 1].bearing_deg < bearing_deg)
    ++i;
  const HairlinePoint& a = kHairline[i];
  const HairlinePoint& b = kHairline[i + 1];
  return mix(a.elevation_deg, b.elevation_deg, (bearing_deg - a.bearing_deg) / (b.bearing_deg - a.bearing_deg));
}

}  // namespace

void add_hair(Head& head) {
  constexpr int kRound = 66;
  /// Share of the way from the hairline to the crown, and how much of the full thickness.
  struct Row {
    double share, thick;
  };
  constexpr Row kRows[] = {{0.0, -1.0}, {0.0, 0.12}, {0.03, 0.42}, {0.08, 0.68}, {0.16, 0.88}, {0.26, 1.0},
                           {0.38, 1.0}, {0.52, 1.0}, {0.66, 1.0},  {0.80, 1.0},  {0.92, 1.0}};
  const Field field = [&](const Vec3& p) { return skull_field(p, head.eye_x); };
  const Colour hair(Pigment::kHair);
  Grid grid(static_cast<int>(std::size(kRows)), kRound, true, Part::kHair);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.filled_columns(); ++column) {
      const double bearing_deg = 360.0 * column / kRound;
      const Angle bearing = angle_deg(bearing_deg);
      // Uneven locks: a hairline drawn with a ruler looks like a cap.
      const double uneven = column % 3 == 0 ? 1.4 : (column % 5 == 0 ? -1.0 : 0.0);
      const Angle rise = angle_deg(mix(hairline(bearing_deg) + uneven, 90.0, kRows[row].share));
      const Vec3 direction(bearing.sine * rise.cosine, rise.sine, bearing.cosine * rise.cosine);
      const Vec3 skin = cast(field, kHairCentre, direction, 160.0);
      // Short at the sides and the nape, full on top and over the forehead.
      const double top = smooth_step(0.1, 0.8, rise.sine);
      const double front = smooth_step(0.2, 0.9, bearing.cosine * rise.cosine);
      const double lock = column % 2 == 0 ? 0.8 : 0.0;
      const double full = 4.0 + 6.0 * top + 3.5 * top * front + lock;
      Vertex& v = grid.at(row, column);
      v.point = skin + direction * (kRows[row].thick < 0.0 ? -5.0 : full * kRows[row].thick);
      v.colour = hair * ((column * 7) % 5 == 0 ? 1.2 : ((column * 3) % 4 == 0 ? 0.86 : 0.97));
    }
  }
  grid.first_pole.point = kHairCentre;
  grid.last_pole.point = cast(field, kHairCentre, {0.0, 1.0, 0.0}, 160.0) + Vec3(0.0, 10.0, 0.0);
  grid.first_pole.colour = grid.last_pole.colour = hair;
  add_piece(head, grid, std::vector<Site>(grid.points.size() + 2, Site{Piece::kHair, 0.0, 0.0, 0.0}), false);
}

void add_ears(Head& head) {
  /// From the root inside the head over the back and the rim into the bowl: share of the outline, height over the head.
  struct Row {
    double share, height, tone;
  };
  constexpr Row kRows[] = {{0.55, -6.0, 1.0}, {0.86, 2.0, 0.9},  {1.0, 6.5, 0.97},  {0.99, 8.6, 1.0},
                           {0.92, 9.4, 1.0},  {0.83, 7.6, 0.86}, {0.72, 5.2, 0.78}, {0.60, 6.6, 0.94},
                           {0.50, 6.2, 0.92}, {0.38, 2.2, 0.72}, {0.2, 0.6, 0.62}};
  constexpr int kRound = 20;
  const Vec3 centre(71.0, 39.0, -6.0);
  const Colour ear = mix(Pigment::kSkin, Pigment::kLips, 0.22);
  Grid grid(static_cast<int>(std::size(kRows)), kRound, false, Part::kEar);
  for (int row = 0; row < grid.rows; ++row) {
    const Row& spec = kRows[row];
    for (int column = 0; column < kRound; ++column) {
      const Angle turn = angle_deg(360.0 * column / kRound);
      // Wide above, narrow at the lobe; leans back; its back edge stands off the head.
      const double y = 29.5 * turn.cosine;
      const double wide = 17.5 * mix(0.66, 1.0, smooth_step(-30.0, 12.0, y));
      const double z = wide * turn.sine;
      // The lobe grows out of the jaw, which is narrower than the skull.
      const double inwards = 0.62 * positive(0.0 - y - 2.0) * spec.share;
      const double lobe = smooth_step(0.55, 0.95, 0.0 - turn.cosine);
      const double height = mix(spec.height, spec.height < 0.0 ? spec.height : 5.0, lobe * 0.8);
      grid.at(row, column).point =
          centre + Vec3(height - 0.34 * z * spec.share - inwards, y * spec.share, (z - 0.22 * y) * spec.share);
      grid.at(row, column).colour = ear * mix(spec.tone, 1.0, lobe);
    }
  }
  grid.first_pole.point = centre + Vec3(-12.0, 0.0, 0.0);
  grid.first_pole.colour = ear;
  grid.last_pole.point = centre + Vec3(0.5, -2.0, 2.0);
  grid.last_pole.colour = ear * 0.55;
  add_piece(head, grid, std::vector<Site>(grid.points.size() + 2, Site{Piece::kEar, 0.0, 0.0, 0.0}), true);
}

}  // namespace auslan::sculpt
