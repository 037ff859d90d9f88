// SPDX-License-Identifier: Apache-2.0
// The pieces of a face that are bodies of their own: eyeballs, lids, brows, teeth and tongue. All closed, all of the
// left side or symmetric.
#include "head.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace auslan::sculpt {

namespace {

constexpr double kLidInside = 15.0;
constexpr double kLidOutside = 16.3;

/// Polar angle from the pupil and colour, from the back of the ball; close pairs make sharp edges.
struct BallRow {
  double polar_deg;
  int tint;  ///< 0 white, 1 the iris' dark rim, 2 iris, 3 pupil
};
constexpr BallRow kBallRows[] = {{130.0, 0}, {92.0, 0}, {68.0, 0}, {52.0, 0}, {40.0, 0}, {30.0, 0}, {29.2, 1},
                                 {25.5, 1},  {24.0, 2}, {16.5, 2}, {13.6, 2}, {12.8, 3}, {6.0, 3}};

void add_ball(Head& head) {
  const Vec3 centre(head.eye_x, kEyeLevel, kEyeZ);
  Grid grid(static_cast<int>(std::size(kBallRows)), 28, false, Part::kEyeball);
  const Colour white(Pigment::kEyeWhite);
  const Colour iris(Pigment::kIris);
  const Colour tints[] = {white, iris * 0.45, iris * 1.2, Pigment::kPupil};
  for (int row = 0; row < grid.rows; ++row) {
    const Angle polar = angle_deg(kBallRows[row].polar_deg);
    for (int column = 0; column < grid.columns; ++column) {
      const Angle turn = angle_deg(360.0 * column / grid.columns);
      Vertex& v = grid.at(row, column);
      v.point = centre + Vec3(turn.cosine * polar.sine, turn.sine * polar.sine, polar.cosine) * kBallRadius;
      v.colour = tints[kBallRows[row].tint];
      // Where somebody looks is read from the iris.
      v.importance = kBallRows[row].polar_deg < 45.0 ? 60.0 : (kBallRows[row].polar_deg < 80.0 ? 2.0 : 0.05);
    }
  }
  grid.first_pole.point = centre - Vec3(0.0, 0.0, kBallRadius);
  grid.first_pole.colour = white;
  grid.first_pole.importance = 0.05;
  grid.last_pole.importance = 60.0;
  grid.last_pole.point = centre + Vec3(0.0, 0.0, kBallRadius);
  grid.last_pole.colour = tints[3];
  grid.occlude(0.0);
  add_piece(head, grid, std::vector<Site>(grid.points.size() + 2, Site{Piece::kEyeball, 0.0, 0.0, 0.0}), true);

  // The light in the eye: without it a drawn eye looks blind.
  Grid glint(2, 8, false, Part::kEyeball);
  const Angle rise = angle_deg(13.0);
  const Vec3 out(0.0, rise.sine, rise.cosine);
  const Vec3 up(0.0, rise.cosine, 0.0 - rise.sine);
  const Vec3 spot = centre + out * kBallRadius;
  for (int column = 0; column < 8; ++column) {
    const Angle turn = angle_deg(45.0 * column);
    const Vec3 side = Vec3(turn.cosine, 0.0, 0.0) + up * turn.sine;
    glint.at(0, column).point = spot + side * 1.35 - out * 0.2;
    glint.at(1, column).point = spot + side * 0.9 + out * 0.3;
  }
  glint.first_pole.point = spot - out * 0.7;
  glint.last_pole.point = spot + out * 0.4;
  paint(glint, [](const Vec3&) { return Colour(Pigment::kGlint); });
  glint.weigh(0.5);
  glint.occlude(0.0);
  add_piece(head, glint, std::vector<Site>(glint.points.size() + 2, Site{Piece::kEyeball, 0.0, 0.0, 0.0}), true);
}

/// A lid is a part of a hollow ball between two half circles from corner to corner: its outside from the first to the
/// last angle, then back on the inside.
void add_lid(Head& head, bool upper) {
  constexpr double kShares[] = {0.0, 0.05, 0.11, 0.19, 0.28, 0.41, 0.55, 0.78, 1.0};
  constexpr int kSteps = static_cast<int>(std::size(kShares));
  constexpr int kRows = 21;
  const Vec3 centre(head.eye_x, kEyeLevel, kEyeZ);
  Grid grid(kRows, 2 * kSteps, false, Part::kSkin);
  std::vector<Site> sites(grid.points.size() + 2);
  const Piece piece = upper ? Piece::kUpperLid : Piece::kLowerLid;
  const double margin = upper ? kUpperOpen : kLowerOpen;
  const double hidden = upper ? kUpperHidden : kLowerHidden;
  const Colour skin = mix(Pigment::kSkin, Pigment::kLips, upper ? 0.14 : 0.10) * (upper ? 0.97 : 1.0);
  const Colour lash = upper ? Colour(Pigment::kHair) * 0.6 : skin * 0.62;
  for (int row = 0; row < kRows; ++row) {
    const double along = angle_deg(-90.0 + 180.0 * (row + 1) / (kRows + 1)).sine;
    for (int column = 0; column < grid.columns; ++column) {
      const bool outside = column < kSteps;
      const int step = outside ? column : grid.columns - 1 - column;
      // The outside of the upper lid runs from its hidden end down to the margin, the lower one's the other way.
      const double share = kShares[upper ? kSteps - 1 - step : step];
      Site& site = sites[1 + static_cast<size_t>(row * grid.columns + column)];
      site = {piece, share, along, outside ? kLidOutside : kLidInside};
      Vertex& v = grid.at(row, column);
      v.point = centre + lid_point(site, margin, hidden);
      const bool dark = share < (upper ? 0.08 : 0.03);
      v.colour = dark ? lash : (share < 0.15 ? skin * 0.97 : skin);
      v.importance = outside && share < 0.5 ? 20.0 : 0.3;
    }
  }
  sites.front() = {piece, 0.0, -1.0, 0.5 * (kLidInside + kLidOutside)};
  sites.back() = {piece, 0.0, 1.0, 0.5 * (kLidInside + kLidOutside)};
  grid.first_pole.point = centre + lid_point(sites.front(), margin, hidden);
  grid.last_pole.point = centre + lid_point(sites.back(), margin, hidden);
  grid.first_pole.colour = grid.last_pole.colour = skin;
  grid.occlude(0.0);
  add_piece(head, grid, sites, true);
}

void add_brow(Head& head) {
  constexpr int kRows = 21;
  constexpr int kRound = 12;
  const Field field = [&](const Vec3& p) { return skull_field(p, head.eye_x); };
  Grid grid(kRows, kRound, false, Part::kBrow);
  std::vector<Site> sites(grid.points.size() + 2);
  const auto middle = [&](double t) {
    // Rises to two thirds of its length, then falls towards the temple.
    const double arch = 1.0 - (t - 0.56) * (t - 0.56) / 0.31;
    return cast(field, {mix(10.5, 53.0, t), 69.0 + 3.6 * arch, 20.0}, {0.0, 0.0, 1.0}, 110.0);
  };
  for (int row = 0; row < kRows; ++row) {
    const double t = (row + 0.5) / kRows;
    const Vec3 p = middle(t);
    const Vec3 out = field_normal(p, head.eye_x);
    const Vec3 run = normalised(middle(t + 0.02) - middle(t - 0.02));
    const Vec3 up = normalised(glm::cross(out, run));
    const double tall = mix(2.9, 5.0, smooth_step(-0.05, 0.16, t)) * (1.0 - 0.62 * smooth_step(0.45, 1.0, t));
    for (int column = 0; column < kRound; ++column) {
      const Angle turn = angle_deg(360.0 * column / kRound);
      grid.at(row, column).point = p + up * (tall * turn.cosine) + out * (2.6 * turn.sine - 0.4);
      sites[1 + static_cast<size_t>(row * kRound + column)] = {Piece::kBrow, 0.0, t, 0.0};
    }
  }
  grid.first_pole.point = middle(-0.015);
  grid.last_pole.point = middle(1.02);
  sites.front() = {Piece::kBrow, 0.0, 0.0, 0.0};
  sites.back() = {Piece::kBrow, 0.0, 1.0, 0.0};
  paint(grid, [&](const Vec3&) { return Colour(Pigment::kHair); });
  grid.weigh(8.0);
  grid.occlude(0.0);
  add_piece(head, grid, sites, true);
}

/// A row of teeth: an oval block, its midline and the gaps a little darker.
void add_teeth(Head& head, bool upper) {
  constexpr int kRound = 42;
  const double biting = kMouthY + (upper ? -1.5 : -3.8);
  const double rise = upper ? 1.0 : -1.0;
  struct Level {
    double height, share;
  };
  constexpr Level kLevels[] = {{0.0, 0.92}, {1.2, 0.985}, {7.5, 1.0}, {8.5, 0.99}, {13.0, 0.92}};
  constexpr int kRows = static_cast<int>(std::size(kLevels));
  Grid grid(kRows, kRound, true, Part::kTeeth);
  const Colour tooth(Pigment::kTooth);
  const Colour gum(Pigment::kGum);
  for (int row = 0; row < kRows; ++row) {
    const Level& level = kLevels[upper ? row : kRows - 1 - row];
    for (int column = 0; column < kRound; ++column) {
      const Angle turn = angle_deg(360.0 * column / kRound);
      const double wide = upper ? 22.8 : 21.2;
      const double deep = upper ? 15.5 : 14.0;
      const bool gap = column % 3 == 0;
      const double inset = gap && level.height < 8.0 ? 0.975 : 1.0;
      Vertex& v = grid.at(row, column);
      v.point = Vec3(wide * level.share * inset * turn.sine, biting + rise * level.height,
                     79.5 + deep * level.share * inset * turn.cosine);
      v.colour = level.height > 8.0 ? gum : (gap ? tooth * 0.86 : tooth);
    }
  }
  grid.first_pole = grid.last_pole = grid.points.front();
  grid.first_pole.point = Vec3(0.0, upper ? biting : biting - 13.0, 79.5);
  grid.last_pole.point = Vec3(0.0, upper ? biting + 13.0 : biting, 79.5);
  (upper ? grid.last_pole : grid.first_pole).colour = gum;
  grid.weigh(0.2);
  const Piece piece = upper ? Piece::kUpperTeeth : Piece::kLowerTeeth;
  grid.occlude(0.0);
  add_piece(head, grid, std::vector<Site>(grid.points.size() + 2, Site{piece, 0.0, 0.0, 0.0}), false);
}

void add_tongue(Head& head) {
  constexpr int kRows = 10;
  constexpr int kRound = 16;
  Grid grid(kRows, kRound, true, Part::kTongue);
  std::vector<Site> sites(grid.points.size() + 2);
  const Colour pink(Pigment::kTongue);
  for (int row = 0; row < kRows; ++row) {
    const Angle bow = angle_deg(180.0 * (row + 1) / (kRows + 1));
    const double t = 0.5 - 0.5 * bow.cosine;
    const double wide = 15.0 * std::sqrt(bow.sine);
    for (int column = 0; column < kRound; ++column) {
      const Angle turn = angle_deg(360.0 * column / kRound);
      // A furrow along the middle.
      const double furrow = column == 0 ? 0.9 : 0.0;
      Vertex& v = grid.at(row, column);
      v.point = Vec3(0.0 - wide * turn.sine, kMouthY - 4.0 + 4.6 * std::sqrt(bow.sine) * turn.cosine - furrow,
                     mix(60.0, 92.0, t));
      v.colour = column == 0 ? pink * 0.84 : pink;
      sites[1 + static_cast<size_t>(row * kRound + column)] = {Piece::kTongue, 0.0, t, 0.0};
    }
  }
  grid.first_pole.point = Vec3(0.0, kMouthY - 4.0, 60.0);
  grid.last_pole.point = Vec3(0.0, kMouthY - 4.0, 92.0);
  grid.first_pole.colour = grid.last_pole.colour = pink;
  sites.front() = {Piece::kTongue, 0.0, 0.0, 0.0};
  sites.back() = {Piece::kTongue, 0.0, 1.0, 0.0};
  grid.occlude(0.0);
  add_piece(head, grid, sites, false);
}

}  // namespace

Vec3 lid_point(const Site& site, double margin_deg, double hidden_deg) {
  const Angle rise = angle_deg(mix(margin_deg, hidden_deg, site.ring));
  const double radius = site.radius * std::sqrt(positive(1.0 - site.up * site.up));
  const double x = site.radius * site.up;
  // The outer corner lies higher than the inner one.
  return {x, radius * rise.sine + 0.05 * x, radius * rise.cosine};
}

void add_eyes(Head& head) {
  add_ball(head);
  add_lid(head, true);
  add_lid(head, false);
  add_brow(head);
}

void add_mouth(Head& head) {
  add_teeth(head, true);
  add_teeth(head, false);
  add_tongue(head);
}

}  // namespace auslan::sculpt
