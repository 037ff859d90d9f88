// SPDX-License-Identifier: Apache-2.0
// The head's skin: one closed surface whose rings start in the throat, pass the lips and go round the face to the back
// of the head, so that the rings near the mouth are the lips' own lines.
#include "head.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace auslan::sculpt {

namespace {

/// The head is star-shaped seen from here: even the nose's underside and the chin's.
const Vec3 kInside(0.0, 55.0, 10.0);
constexpr int kColumns = 112;

/// Rings round the mouth in millimetres from the line between the lips.
const std::vector<double> kNearRings =
    refined({0.0, 1.2, 2.8, 4.8, 7.0, 9.0, 11.0, 13.5, 16.0, 18.5, 21.0, 24.0, 27.5, 31.5, 36.0});
/// Then rings by their angle from the face's axis, degrees, seen from kInside.
const std::vector<double> kFarRings = [] {
  std::vector<double> rings = refined({16.5, 18.2, 20.0, 22.0, 24.0, 26.0, 28.0, 30.0, 32.0, 34.0, 36.0,
                                       38.0, 40.0, 42.0, 44.0, 46.0, 48.5, 51.0, 54.0, 57.5, 61.5, 66.0});
  rings.insert(rings.end(), {71.0, 77.0, 84.0, 92.0, 101.0, 111.0, 122.0, 135.0, 150.0, 165.0});
  return rings;
}();
constexpr double kFirstFar = 15.0;

double tangent_of_half(double degrees) {
  const Angle half = angle_deg(0.5 * degrees);
  return half.sine / half.cosine;
}

Vec3 near_direction(double ring, const Angle& turn) {
  const double wide = std::sqrt(ring * ring + kMouthHalf * kMouthHalf * (1.0 - ring * ring / 4000.0));
  const double x = wide * turn.sine;
  // The lips' outline is a lens with pointed corners; the face's rings are round.
  const double rise = turn.cosine < 0.0 ? 0.0 - turn.cosine : turn.cosine;
  const double height = ring * turn.cosine * mix(mix(1.0, rise, 0.25), 1.0, smooth_step(8.0, 24.0, ring));
  // Cupid's bow: two low peaks on the upper lip's edge.
  const double side = x < 0.0 ? 0.0 - x : x;
  const double bow = turn.cosine > 0.0 ? smooth_step(0.0, 6.5, side) * (1.0 - smooth_step(6.5, 20.0, side)) : 0.0;
  const double raised = 1.7 * bow * smooth_step(1.0, 7.0, ring) * (1.0 - smooth_step(8.0, 22.0, ring));
  return normalised(
      Vec3(x, kMouthY + raised + kMouthLift * x * x * (1.0 - ring / 36.0) + height, kMouthZ - 0.012 * x * x) - kInside);
}

/// Beyond the last near ring the columns run on along great circles (straight lines in the stereographic plane) and
/// their rings become round.
Vec3 far_direction(double degrees, const Angle& turn) {
  const Vec3 axis = normalised(Vec3(0.0, kMouthY - 2.0, kMouthZ) - kInside);
  const Vec3 up(0.0, axis.z, 0.0 - axis.y);
  const Vec3 edge = near_direction(36.0, turn);
  const double along = edge.y * axis.y + edge.z * axis.z;
  const double u = edge.x / (1.0 + along);
  const double v = (edge.y * up.y + edge.z * up.z) / (1.0 + along);
  const double reach = std::sqrt(u * u + v * v);
  const double ratio = mix(reach / tangent_of_half(kFirstFar), 1.0, smooth_step(kFirstFar, 70.0, degrees));
  const double scale = tangent_of_half(degrees) * ratio / reach;
  const double s = u * scale;
  const double t = v * scale;
  const double square = s * s + t * t;
  return (Vec3(2.0 * s, 0.0, 0.0) + up * (2.0 * t) + axis * (1.0 - square)) / (1.0 + square);
}

struct PocketRow {
  double depth, half_width, half_height;
};
/// From the throat to just behind the lips.
constexpr PocketRow kPocket[] = {
    {42.0, 14.0, 7.0}, {32.0, 21.0, 12.0}, {18.0, 25.0, 12.0}, {9.0, 25.0, 7.0}, {4.0, 24.5, 2.2}};

double colour_bump(const Vec3& p, const Vec3& centre, double radius) {
  return 1.0 - smooth_step(0.2 * radius, radius, length(p - centre));
}

}  // namespace

Colour skin_colour(const Vec3& p) {
  const Vec3 q(p.x < 0.0 ? 0.0 - p.x : p.x, p.y, p.z);
  const Colour skin(Pigment::kSkin);
  const Colour flush = mix(skin, Pigment::kLips, 0.42);
  Colour c = mix(skin, flush, 0.55 * colour_bump(q, {44.0, 12.0, 80.0}, 34.0));
  c = mix(c, flush, 0.5 * colour_bump(q, {0.0, 8.0, 120.0}, 22.0));
  c = mix(c, flush, 0.35 * colour_bump(q, {0.0, -58.0, 100.0}, 20.0));
  // Round the eyes the skin is thin and in shade; the nostrils are holes too small for the mesh.
  c = mix(c, flush * 0.9, 0.5 * colour_bump(q, {31.5, 55.0, 86.0}, 22.0));
  c = mix(c, flush * 0.5, 0.9 * colour_bump(q, {6.5, -0.5, 112.0}, 6.0));
  return c;
}

namespace {

/// Faces in which the reduced head has to hold its form.
using FacePose = std::vector<FaceChannel>;
const std::vector<FacePose> kFacePoses = {
    {FaceChannel::kJawOpen, FaceChannel::kBrowInnerUp, FaceChannel::kBrowOuterUpLeft, FaceChannel::kBrowOuterUpRight},
    {FaceChannel::kEyeBlinkLeft, FaceChannel::kEyeBlinkRight, FaceChannel::kMouthPucker, FaceChannel::kBrowDownLeft,
     FaceChannel::kBrowDownRight},
    {FaceChannel::kMouthSmileLeft, FaceChannel::kMouthSmileRight, FaceChannel::kCheekPuff, FaceChannel::kTongueOut}};

std::vector<Vec3> posed(const Mesh& mesh, const FacePose& channels) {
  std::vector<Vec3> points;
  for (const glm::vec3& p : mesh.positions)
    points.push_back(Vec3(p) * 1000.0);
  for (const Morph& morph : mesh.morphs) {
    if (std::find(channels.begin(), channels.end(), morph.channel) == channels.end()) continue;
    for (size_t i = 0; i < morph.vertices.size(); ++i)
      points[morph.vertices[i]] += Vec3(morph.displacement[i]) * 1000.0;
  }
  return points;
}

}  // namespace

void add_piece(Head& head, const Grid& grid, const std::vector<Site>& sites, bool both) {
  const size_t first_index = head.shape.triangles.size();
  const uint32_t first = append(head.shape, grid);
  head.sites.insert(head.sites.end(), sites.begin(), sites.end());
  if (!both) return;
  append_mirrored(head.shape, first, first_index);
  head.sites.insert(head.sites.end(), sites.begin(), sites.end());
}

void add_skin(Head& head) {
  const Field field = [&](const Vec3& p) { return skull_field(p, head.eye_x); };
  const int pocket = static_cast<int>(std::size(kPocket));
  const int near = static_cast<int>(kNearRings.size());
  const int far = static_cast<int>(kFarRings.size());
  Grid grid(pocket + near + far, kColumns, true, Part::kSkin);
  std::vector<Site> sites(grid.points.size() + 2);
  // Lips without paint are half skin.
  const Colour lips = mix(Pigment::kLips, Pigment::kSkin, 0.22);
  const Colour dark(Pigment::kMouth);
  // The nose stands out of the face and has little colour of its own: its form has to carry it.
  const auto nose = [](Vertex& vertex) {
    const double away = length((vertex.point - Vec3(0.0, 10.0, 104.0)) / Vec3(22.0, 28.0, 22.0));
    vertex.importance *= mix(6.0, 1.0, smooth_step(0.5, 1.4, away));
  };
  for (int column = 0; column < kColumns; ++column) {
    // Closer columns above the mouth, where the nose and the eyes are.
    const double even = 360.0 * column / kColumns;
    const Angle turn = angle_deg(even - 19.0 * angle_deg(even).sine);
    for (int row = 0; row < grid.rows; ++row) {
      Site& site = sites[1 + static_cast<size_t>(row * kColumns + column)];
      site.up = turn.cosine;
      Vertex& vertex = grid.at(row, column);
      if (row < pocket) {
        const PocketRow& hole = kPocket[row];
        site.piece = Piece::kMouthPocket;
        site.ring = 0.0 - hole.depth;
        const double x = hole.half_width * turn.sine;
        vertex.point = Vec3(x, kMouthY + kMouthLift * x * x + hole.half_height * turn.cosine,
                            kMouthZ - hole.depth - 0.012 * x * x);
        vertex.colour = mix(lips * 0.55, dark, smooth_step(3.0, 14.0, hole.depth));
        vertex.importance = 0.3;
        vertex.occlusion = 0.0;
      } else if (row < pocket + near) {
        site.ring = kNearRings[static_cast<size_t>(row - pocket)];
        vertex.point = cast(field, kInside, near_direction(site.ring, turn), 160.0);
        // The lip's colour ends on a ring; the line where the lips meet is darker.
        const Colour lip = site.ring < 1.0 ? lips * 0.62 : mix(lips * 0.86, lips, smooth_step(1.0, 4.0, site.ring));
        // Towards the corners the lips' colour runs out into the skin.
        const double side = turn.sine < 0.0 ? 0.0 - turn.sine : turn.sine;
        const double pale = site.ring < 1.0 ? 0.0 : 0.8 * smooth_step(0.84, 1.0, side);
        const Colour skin = skin_colour(vertex.point);
        vertex.colour = site.ring < 8.0 ? mix(lip, skin, pale) : skin;
        vertex.importance = site.ring < 10.0 ? 40.0 : 4.0;
        nose(vertex);
        vertex.occlusion = smooth_step(6.0, 20.0, site.ring);
      } else {
        const double degrees = kFarRings[static_cast<size_t>(row - pocket - near)];
        site.ring = 36.0 + 2.3 * (degrees - kFirstFar);
        vertex.point = cast(field, kInside, far_direction(degrees, turn), 160.0);
        vertex.colour = skin_colour(vertex.point);
        // The back of the skull is under the hair.
        const bool bare = vertex.point.z > 20.0 || vertex.point.y < 30.0;
        vertex.importance = vertex.point.z > 55.0 ? 4.0 : (bare ? 1.0 : 0.2);
        nose(vertex);
      }
    }
  }
  grid.first_pole.point = Vec3(0.0, kMouthY, kMouthZ - 46.0);
  grid.first_pole.colour = dark;
  sites.front() = {Piece::kMouthPocket, -46.0, 0.0, 0.0};
  grid.last_pole.point = cast(field, kInside, normalised(kInside - Vec3(0.0, kMouthY - 2.0, kMouthZ)), 160.0);
  grid.last_pole.colour = Pigment::kSkin;
  grid.first_pole.importance = grid.last_pole.importance = 0.1;
  sites.back() = {Piece::kSkin, 400.0, 0.0, 0.0};
  add_piece(head, grid, sites, false);
}

Sculpture sculpt_head(const Measurements& table) {
  const Vec3 stretch(table.head_breadth / 151.0, 1.0, table.head_length / 195.0);
  const double above = table.eye_to_vertex / 111.0;
  const double below = table.face_height / 118.0;
  const auto stretched = [&](const Vec3& p) {
    const double y = p.y - kEyeLevel;
    return Vec3(p.x * stretch.x, kEyeLevel + y * (y > 0.0 ? above : below), p.z * stretch.z);
  };
  Head head;
  head.eye_x = 0.5 * table.interpupillary / stretch.x;
  add_skin(head);
  add_hair(head);
  add_ears(head);
  add_eyes(head);
  add_mouth(head);
  Shape sized = head.shape;
  for (Vertex& v : sized.vertices)
    v.point = stretched(v.point);
  Sculpture made = finish(sized);
  Mesh& mesh = made.mesh;
  // The skin's shading follows the form itself, not the triangles that approach it.
  for (size_t i = 0; i < head.sites.size(); ++i) {
    const Site& site = head.sites[i];
    const bool skin = site.piece == Piece::kSkin && site.ring > 0.0;
    const bool lower_lid = site.piece == Piece::kLowerLid && site.ring > 0.03;
    if (!skin && !lower_lid) continue;
    const Vec3& p = head.shape.vertices[i].point;
    const Vec3 out =
        normalised(field_normal(p, head.eye_x) / Vec3(stretch.x, p.y > kEyeLevel ? above : below, stretch.z));
    // The lower lid runs on into the cheek without an edge of its own.
    mesh.normals[i] = glm::vec3(skin ? out : normalised(out * 0.8 + Vec3(mesh.normals[i]) * 0.2));
  }
  mesh.morphs = face_morphs(head, stretched);
  for (const auto& weights : kFacePoses)
    made.poses.push_back(posed(mesh, weights));
  return made;
}

}  // namespace auslan::sculpt
