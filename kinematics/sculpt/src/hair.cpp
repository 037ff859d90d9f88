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
      const double root = mix(smooth_step(-0.04, 0.13, share), smooth_step(-0.18, 0.32, share), side);
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

namespace {

/// A round hump of height 1 at a place of the ear's plane (up, forwards), gone `radius` millimetres away.
double hump(double up, double forwards, double centre_up, double centre_forwards, double radius) {
  return 1.0 - smooth_step(0.15 * radius, radius, length(Vec3(up - centre_up, forwards - centre_forwards, 0.0)));
}

/// How high the ear's front stands over its plane, and its tone: 1 on what is lit, less in the hollows.
struct EarRelief {
  double height, tone;
};
/// `share` of the way from the canal to the outline, millimetres up and forwards.
EarRelief ear_relief(double share, double up, double forwards) {
  const double back = smooth_step(-8.0, 2.0, 0.0 - forwards);
  const double lobe = smooth_step(15.0, 22.0, 0.0 - up);
  // The rolled rim from the front round the top and the back, and the groove inside it.
  const double helix = smooth_step(0.80, 0.92, share) * (1.0 - lobe);
  // The second ridge behind the bowl; above it forks, and the hollow between its arms shows.
  const double ridge = smooth_step(0.44, 0.56, share) * (1.0 - smooth_step(0.62, 0.76, share));
  const double fork = hump(up, forwards, 13.5, 2.0, 6.5);
  const double antihelix = ridge * back * (1.0 - lobe) * (1.0 - 0.8 * fork);
  // The bowl, divided by the root of the rim that runs into it from the front.
  const double bowl = 1.0 - smooth_step(0.34, 0.52, share);
  const double crus = hump(up, forwards, 1.5, 6.5, 5.5);
  // Before the canal the tragus, opposite it the antitragus.
  const double tragus = hump(up, forwards, -4.0, 10.0, 6.5);
  const double antitragus = hump(up, forwards, -13.0, 1.0, 6.0);
  const double height = 2.6 + 6.4 * helix + 5.6 * antihelix - 4.4 * bowl * (1.0 - 0.6 * crus) - 1.6 * fork +
                        5.0 * tragus + 3.4 * antitragus + 3.8 * lobe;
  const double tone = 0.74 + 0.26 * helix + 0.26 * antihelix - 0.24 * bowl * (1.0 - 0.5 * crus) - 0.07 * fork +
                      0.2 * tragus + 0.14 * antitragus + 0.2 * lobe;
  return {height, tone < 1.0 ? tone : 1.0};
}

}  // namespace

void add_ears(Head& head) {
  /// From the root inside the head over the back to the outline: share of the outline, height over the head. Then the
  /// front, whose height is that of its relief.
  struct Row {
    double share, height;
  };
  constexpr Row kBack[] = {{0.55, -6.0}, {0.86, 1.0}, {1.0, 6.0}};
  constexpr double kFront[] = {0.985, 0.93, 0.85, 0.77, 0.69, 0.61, 0.53, 0.44, 0.34, 0.2};
  constexpr int kRound = 24;
  constexpr int kBackRows = static_cast<int>(std::size(kBack));
  const Vec3 centre(71.0, 39.0, -6.0);
  const Colour ear = mix(Pigment::kSkin, Pigment::kLips, 0.22);
  Grid grid(kBackRows + static_cast<int>(std::size(kFront)), kRound, false, Part::kEar);
  for (int row = 0; row < grid.rows; ++row) {
    const bool behind = row < kBackRows;
    const double share = behind ? kBack[row].share : kFront[row - kBackRows];
    for (int column = 0; column < kRound; ++column) {
      const Angle turn = angle_deg(360.0 * column / kRound);
      // Wide above, narrow at the lobe; leans back; its back edge stands off the head.
      const double y = 29.5 * turn.cosine;
      const double wide = 17.5 * mix(0.84, 1.0, smooth_step(-30.0, 8.0, y));
      const double z = wide * turn.sine;
      // The lobe grows out of the jaw, which is narrower than the skull.
      const double inwards = 0.62 * positive(0.0 - y - 2.0) * share;
      const double lobe = smooth_step(0.55, 0.95, 0.0 - turn.cosine);
      const EarRelief relief = behind ? EarRelief{kBack[row].height, 0.95} : ear_relief(share, y * share, z * share);
      const double height = behind && row > 1 ? mix(relief.height, 5.0, 0.8 * lobe) : relief.height;
      grid.at(row, column).point =
          centre + Vec3(height - 0.34 * z * share - inwards, y * share, (z - 0.22 * y) * share);
      grid.at(row, column).colour = ear * relief.tone;
    }
  }
  grid.first_pole.point = centre + Vec3(-12.0, 0.0, 0.0);
  grid.first_pole.colour = ear;
  grid.last_pole.point = centre + Vec3(-1.5, -3.0, 3.0);
  grid.last_pole.colour = ear * 0.5;
  grid.weigh(2.0);
  add_piece(head, grid, std::vector<Site>(grid.points.size() + 2, Site{Piece::kEar, 0.0, 0.0, 0.0}), true);
}

}  // namespace auslan::sculpt
