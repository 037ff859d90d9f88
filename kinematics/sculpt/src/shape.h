// SPDX-License-Identifier: Apache-2.0
// A mesh while it is being shaped: closed grids of points (rows between two poles, columns round an axis), their
// colours, and which vertex is the mirror image of which. Millimetres, in the node's frame.
#pragma once

#include "field.h"
#include "pigment.h"
#include "reduce.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace auslan::sculpt {

/// What a grid is made of.
enum class Part : uint8_t { kSkin, kEyeball, kBrow, kHair, kEar, kTeeth, kTongue, kNail, kCloth };

struct Vertex {
  Vec3 point{0.0};
  Colour colour;
  double importance = 1.0;  ///< of errors there, when triangles are saved
  double occlusion = 1.0;   ///< how much of baked occlusion it takes
  uint32_t mirror = 0;      ///< its mirror image across x = 0; itself where there is none or it lies on the plane
};

struct Shape {
  std::vector<Vertex> vertices;
  std::vector<uint32_t> triangles;
};

/// A closed surface: `rows` x `columns` points between two poles. Columns turn counter-clockwise seen from the last
/// pole; the surface is then outward. Where `symmetric`, column 0 lies on x = 0 and column c mirrors column -c: only
/// the first half of each row is read.
struct Grid {
  int rows = 0;
  int columns = 0;
  bool symmetric = false;
  Part part = Part::kSkin;
  std::vector<Vertex> points;  ///< row by row
  Vertex first_pole, last_pole;

  Grid(int row_count, int column_count, bool is_symmetric, Part which);
  Vertex& at(int row, int column) { return points[static_cast<size_t>(row * columns + column)]; }
  /// Sets the importance of every point, or how much of baked occlusion it takes.
  void weigh(double importance);
  void occlude(double share);
  /// How many columns of a row have to be filled in.
  int filled_columns() const { return symmetric ? columns / 2 + 1 : columns; }
};

/// Appends the grid; returns the index of its first vertex. Poles come first and last.
uint32_t append(Shape& shape, Grid grid);
/// Appends a closed ring (a torus): rows go round the hole, columns round the tube; no poles. Symmetric as above, with
/// row 0 on the plane and row r mirroring row -r.
uint32_t append_ring(Shape& shape, Grid grid);
/// Appends the mirror image of everything from vertex `first` and triangle index `first_index` on, linked both ways.
void append_mirrored(Shape& shape, uint32_t first, size_t first_index);

/// Metres, float, painted, smooth normals (area-weighted over the triangles round a vertex). Mirrored vertices come out
/// exact. Colours are left to the appearance.
Sculpture finish(const Shape& shape);
/// Unit normals of a shape as it stands.
std::vector<Vec3> smooth_normals(const Shape& shape);
/// A joint that turns what lies before and behind it, and fades from one to the other between `low` and `high`
/// millimetres along a bone: much as the skin of a posed figure does.
struct Turning {
  Vec3 joint{0.0};
  Vec3 along{1.0, 0.0, 0.0};  ///< unit
  Vec3 about{0.0, 1.0, 0.0};  ///< unit
  double low = 0.0, high = 0.0;
  double before_deg = 0.0, behind_deg = 0.0;
  double near = 1e6, far = 2e6;  ///< all of it up to so far from the axis `along`, nothing from there on
};
std::vector<Vec3> points_of(const Shape& shape);
/// The points turned, one joint after the other.
std::vector<Vec3> turned(std::vector<Vec3> points, const std::vector<Turning>& joints);
/// The mirror image of a whole mesh across x = 0.
Mesh mirrored(const Mesh& mesh);

/// A tube round the axis from `start` to `end`, closed by round caps: the rows of a limb.
struct TubeRow {
  double along = 0.0;     ///< origin of the row's rays: 0 at start, 1 at end
  double tilt_deg = 0.0;  ///< rays lean back (negative) or forward (positive) along the axis
};
struct Tube {
  Vec3 start{0.0};
  Vec3 end{0.0};
  Vec3 up{0.0, 1.0, 0.0};  ///< perpendicular to the axis: column 0
  double spread_up = 0.0;  ///< rays start on an oval: how far its half axes exceed a point, along `up` and sideways
  double spread_side = 0.0;
  double reach = 100.0;
  int columns = 12;
  bool symmetric = false;
  std::vector<TubeRow> rows;
};
/// A table with the mean of every two neighbours between them.
std::vector<double> refined(const std::vector<double>& places);
/// Cap rows, then the body's rows at the given places, then cap rows.
std::vector<TubeRow> tube_rows(int start_cap, const std::vector<double>& body, int end_cap);
/// Casts the tube's rays onto the field. Colours are left to the caller.
Grid cast_tube(const Field& field, const Tube& tube, Part part);
/// Sets the colour of every point of the grid, poles included.
void paint(Grid& grid, const std::function<Colour(const Vec3&)>& colour);

}  // namespace auslan::sculpt
