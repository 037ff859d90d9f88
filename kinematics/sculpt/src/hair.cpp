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
/// Forehead with a peak in the middle, receding above the temple, its point, sideburn, free ear, nape.
constexpr HairlinePoint kHairline[] = {{0.0, 32.8},   {8.0, 33.5},    {16.0, 36.0},   {25.0, 40.3},   {32.0, 41.0},
                                       {38.0, 35.0},  {43.0, 25.0},   {48.0, 15.0},   {53.0, 8.0},    {60.0, 2.0},
                                       {64.0, -6.0},  {68.0, -22.0},  {79.0, -25.0},  {86.0, -6.0},   {92.0, 1.0},
                                       {103.0, -1.0}, {111.0, -18.0}, {122.0, -37.0}, {145.0, -45.0}, {180.0, -48.0}};

double hairline(double bearing_deg) {
  size_t i = 0;
  while (kHairline[i + 1].bearing_deg < bearing_deg)
    ++i;
  const HairlinePoint& a = kHairline[i];
  const HairlinePoint& b = kHairline[i + 1];
  return mix(a.elevation_deg, b.elevation_deg, (bearing_deg - a.bearing_deg) / (b.bearing_deg - a.bearing_deg));
}

/// Between -1 and 1, without a pattern that an eye would find.
double scattered(int column, int row) {
  return ((column * 37 + row * 53 + column * column * 11 + row * column * 7) % 17) / 8.0 - 1.0;
}

}  // namespace

void add_hair(Head& head) {
  constexpr int kRound = 80;
  /// Shares of the way from the hairline to the crown; the first row lies under the skin.
  constexpr double kShares[] = {0.0, 0.0, 0.025, 0.06, 0.11, 0.17, 0.24, 0.33, 0.45, 0.58, 0.72, 0.86, 0.95};
  /// Locks round the head: some 15 mm each.
  constexpr double kLocks = 30.0;
  const Field field = [&](const Vec3& p) { return skull_field(p, head.eye_x); };
  const Colour hair(Pigment::kHair);
  const Colour skin(Pigment::kSkin);
  Grid grid(static_cast<int>(std::size(kShares)), kRound, true, Part::kHair);
  for (int row = 0; row < grid.rows; ++row) {
    const double share = kShares[row];
    for (int column = 0; column < grid.filled_columns(); ++column) {
      const double bearing_deg = 360.0 * column / kRound;
      const Angle bearing = angle_deg(bearing_deg);
      const double front = 1.0 - smooth_step(24.0, 58.0, bearing_deg);
      const double side = smooth_step(44.0, 56.0, bearing_deg);
      // Uneven tips: a hairline drawn with a ruler looks like a cap.
      const double uneven = mix(2.0, 0.7, side) * scattered(column, 3);
      const double elevation_deg = mix(hairline(bearing_deg) + uneven, 90.0, share);
      const Angle rise = angle_deg(elevation_deg);
      const Vec3 direction(bearing.sine * rise.cosine, rise.sine, bearing.cosine * rise.cosine);
      const Vec3 on_skin = cast(field, kHairCentre, direction, 160.0);
      // Cropped at the sides and the nape, longer upwards; over the forehead it stands up before it lies back.
      const double top = smooth_step(8.0, 62.0, elevation_deg);
      const double standing = front * smooth_step(0.02, 0.20, share) * (1.0 - smooth_step(0.24, 0.75, share));
      const double root = mix(smooth_step(-0.04, 0.13, share), smooth_step(-0.12, 0.32, share), side);
      // Locks lean a little to the back as they run up, and are deeper where the hair is longer.
      const double lock = angle_deg(kLocks * bearing_deg + 250.0 * share).sine;
      const double relief = (0.45 + 0.95 * top) * (0.7 * lock + 0.5 * scattered(column, row)) * root;
      const double full = 3.2 + 8.6 * top + 8.5 * standing;
      Vertex& v = grid.at(row, column);
      v.point = on_skin + direction * (row == 0 ? -5.0 : full * root + relief * smooth_step(0.0, 0.05, share));
      // Strands, light on what faces the sky; towards the cropped edge the skin shows through.
      const double strand = 1.0 + 0.17 * lock + 0.13 * scattered(column, row / 3);
      const double shine =
          1.0 + 0.22 * smooth_step(24.0, 46.0, elevation_deg) * (1.0 - smooth_step(52.0, 80.0, elevation_deg));
      const double bare =
          mix(0.4 * (1.0 - smooth_step(0.0, 0.05, share)), 0.46 * (1.0 - smooth_step(0.02, 0.17, share)), side);
      v.colour = mix(hair * (strand * shine), skin * 0.8, bare);
    }
  }
  grid.first_pole.point = kHairCentre;
  grid.last_pole.point = cast(field, kHairCentre, {0.0, 1.0, 0.0}, 160.0) + Vec3(0.0, 11.0, 0.0);
  grid.first_pole.colour = grid.last_pole.colour = hair;
  grid.weigh(0.3);
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
