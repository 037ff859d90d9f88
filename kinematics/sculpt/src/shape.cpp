// SPDX-License-Identifier: Apache-2.0
#include "shape.h"

#include <glm/geometric.hpp>

namespace auslan::sculpt {

namespace {

Vec3 mirror_of(const Vec3& v) {
  return {0.0 - v.x, v.y, v.z};
}

/// Two triangles of a quad a b c d; which diagonal is the caller's, so that mirrored halves split alike.
void quad(Shape& shape, uint32_t a, uint32_t b, uint32_t c, uint32_t d, bool through_a) {
  if (through_a) {
    shape.triangles.insert(shape.triangles.end(), {a, b, c, a, c, d});
  } else {
    shape.triangles.insert(shape.triangles.end(), {a, b, d, b, c, d});
  }
}

}  // namespace

Grid::Grid(int row_count, int column_count, bool is_symmetric, Part which)
    : rows(row_count),
      columns(column_count),
      symmetric(is_symmetric),
      part(which),
      points(static_cast<size_t>(row_count * column_count)) {}

void Grid::weigh(double importance) {
  for (Vertex& v : points)
    v.importance = importance;
  first_pole.importance = last_pole.importance = importance;
}

void Grid::occlude(double share) {
  for (Vertex& v : points)
    v.occlusion = share;
  first_pole.occlusion = last_pole.occlusion = share;
}

uint32_t append(Shape& shape, Grid grid) {
  const auto base = static_cast<uint32_t>(shape.vertices.size());
  const auto index = [&](int row, int column) {
    return base + 1 + static_cast<uint32_t>(row * grid.columns + (column + grid.columns) % grid.columns);
  };
  const uint32_t first = base;
  const uint32_t last = base + 1 + static_cast<uint32_t>(grid.rows * grid.columns);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      Vertex& v = grid.at(row, column);
      if (grid.symmetric) {
        const int other = (grid.columns - column) % grid.columns;
        if (column > grid.columns / 2) {
          v = grid.at(row, other);
          v.point = mirror_of(v.point);
        } else if (column == other) {
          v.point.x = 0.0;
        }
        v.mirror = index(row, other);
      } else {
        v.mirror = index(row, column);
      }
    }
  }
  for (Vertex* pole : {&grid.first_pole, &grid.last_pole}) {
    if (grid.symmetric) pole->point.x = 0.0;
  }
  grid.first_pole.mirror = first;
  grid.last_pole.mirror = last;
  shape.vertices.push_back(grid.first_pole);
  shape.vertices.insert(shape.vertices.end(), grid.points.begin(), grid.points.end());
  shape.vertices.push_back(grid.last_pole);
  for (int column = 0; column < grid.columns; ++column) {
    const bool near_half = column < grid.columns / 2;
    shape.triangles.insert(shape.triangles.end(), {first, index(0, column + 1), index(0, column)});
    for (int row = 0; row + 1 < grid.rows; ++row) {
      quad(shape, index(row, column), index(row, column + 1), index(row + 1, column + 1), index(row + 1, column),
           near_half || !grid.symmetric);
    }
    shape.triangles.insert(shape.triangles.end(),
                           {index(grid.rows - 1, column), index(grid.rows - 1, column + 1), last});
  }
  return base;
}

uint32_t append_ring(Shape& shape, Grid grid) {
  const auto base = static_cast<uint32_t>(shape.vertices.size());
  const auto index = [&](int row, int column) {
    return base + static_cast<uint32_t>((row % grid.rows) * grid.columns + column % grid.columns);
  };
  for (int row = 0; row < grid.rows; ++row) {
    const int other = (grid.rows - row) % grid.rows;
    for (int column = 0; column < grid.columns; ++column) {
      Vertex& v = grid.at(row, column);
      if (grid.symmetric && row > grid.rows / 2) {
        v = grid.at(other, column);
        v.point = mirror_of(v.point);
      } else if (grid.symmetric && row == other) {
        v.point.x = 0.0;
      }
      v.mirror = grid.symmetric ? index(other, column) : index(row, column);
    }
  }
  shape.vertices.insert(shape.vertices.end(), grid.points.begin(), grid.points.end());
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      quad(shape, index(row, column), index(row, column + 1), index(row + 1, column + 1), index(row + 1, column),
           row < grid.rows / 2 || !grid.symmetric);
    }
  }
  return base;
}

void append_mirrored(Shape& shape, uint32_t first, size_t first_index) {
  const auto end = static_cast<uint32_t>(shape.vertices.size());
  const size_t end_index = shape.triangles.size();
  const uint32_t shift = end - first;
  for (uint32_t i = first; i < end; ++i) {
    Vertex copy = shape.vertices[i];
    copy.point = mirror_of(copy.point);
    copy.mirror = i;
    shape.vertices[i].mirror = i + shift;
    shape.vertices.push_back(copy);
  }
  for (size_t i = first_index; i < end_index; i += 3) {
    const uint32_t a = shape.triangles[i] + shift;
    const uint32_t b = shape.triangles[i + 1] + shift;
    const uint32_t c = shape.triangles[i + 2] + shift;
    shape.triangles.insert(shape.triangles.end(), {a, c, b});
  }
}

std::vector<Vec3> smooth_normals(const Shape& shape) {
  std::vector<Vec3> normals(shape.vertices.size(), Vec3(0.0));
  for (size_t i = 0; i < shape.triangles.size(); i += 3) {
    const uint32_t a = shape.triangles[i];
    const uint32_t b = shape.triangles[i + 1];
    const uint32_t c = shape.triangles[i + 2];
    const Vec3& origin = shape.vertices[a].point;
    const Vec3 area = glm::cross(shape.vertices[b].point - origin, shape.vertices[c].point - origin);
    normals[a] += area;
    normals[b] += area;
    normals[c] += area;
  }
  for (size_t i = 0; i < normals.size(); ++i) {
    const uint32_t other = shape.vertices[i].mirror;
    // The sums of mirror images round differently: the first of each pair decides.
    if (other < i) {
      normals[i] = mirror_of(normals[other]);
      continue;
    }
    if (other == i && shape.vertices[i].point.x == 0.0) normals[i].x = 0.0;
    normals[i] = length(normals[i]) > 0.0 ? normalised(normals[i]) : Vec3(0.0, 1.0, 0.0);
  }
  return normals;
}

Sculpture finish(const Shape& shape) {
  Sculpture out;
  for (const Vertex& v : shape.vertices) {
    out.mesh.positions.emplace_back(v.point * 0.001);
    out.mesh.paint.push_back(paint_of(v.colour));
    out.mirror.push_back(v.mirror);
    out.importance.push_back(v.importance);
    out.occlusion.push_back(v.occlusion);
  }
  out.mesh.colours.assign(shape.vertices.size(), glm::u8vec4(255));
  for (const Vec3& n : smooth_normals(shape))
    out.mesh.normals.emplace_back(n);
  out.mesh.indices = shape.triangles;
  return out;
}

std::vector<Vec3> points_of(const Shape& shape) {
  std::vector<Vec3> points;
  for (const Vertex& v : shape.vertices)
    points.push_back(v.point);
  return points;
}

std::vector<Vec3> turned(std::vector<Vec3> points, const std::vector<Turning>& joints) {
  for (Vec3& point : points) {
    // Where a point was at rest says how much of each turn it takes.
    const Vec3 rest = point;
    for (const Turning& joint : joints) {
      const Vec3 place = rest - joint.joint;
      const double t = glm::dot(place, joint.along);
      const double share = smooth_step(joint.low, joint.high, t);
      const double near = 1.0 - smooth_step(joint.near, joint.far, length(place - joint.along * t));
      const Angle turn = angle_deg(near * mix(joint.before_deg, joint.behind_deg, share));
      const Vec3 arm = point - joint.joint;
      const Vec3 axis = joint.about * glm::dot(joint.about, arm);
      point = joint.joint + axis + (arm - axis) * turn.cosine + glm::cross(joint.about, arm) * turn.sine;
    }
  }
  return points;
}

Mesh mirrored(const Mesh& mesh) {
  Mesh out = mesh;
  for (glm::vec3& p : out.positions)
    p.x = 0.0F - p.x;
  for (glm::vec3& n : out.normals)
    n.x = 0.0F - n.x;
  for (size_t i = 0; i < out.indices.size(); i += 3)
    std::swap(out.indices[i + 1], out.indices[i + 2]);
  return out;
}

std::vector<double> refined(const std::vector<double>& places) {
  std::vector<double> out;
  for (size_t i = 0; i < places.size(); ++i) {
    if (i > 0) out.push_back(0.5 * (places[i - 1] + places[i]));
    out.push_back(places[i]);
  }
  return out;
}

std::vector<TubeRow> tube_rows(int start_cap, const std::vector<double>& body, int end_cap) {
  std::vector<TubeRow> rows;
  for (int i = 1; i <= start_cap; ++i)
    rows.push_back({0.0, -90.0 + 90.0 * i / (start_cap + 1)});
  for (const double along : body)
    rows.push_back({along, 0.0});
  for (int i = 1; i <= end_cap; ++i)
    rows.push_back({1.0, 90.0 * i / (end_cap + 1)});
  return rows;
}

Grid cast_tube(const Field& field, const Tube& tube, Part part) {
  Grid grid(static_cast<int>(tube.rows.size()), tube.columns, tube.symmetric, part);
  const Vec3 axis = normalised(tube.end - tube.start);
  const Vec3 side = glm::cross(axis, tube.up);
  for (int row = 0; row < grid.rows; ++row) {
    const TubeRow& spec = tube.rows[static_cast<size_t>(row)];
    const Angle tilt = angle_deg(spec.tilt_deg);
    for (int column = 0; column < grid.filled_columns(); ++column) {
      const Angle turn = angle_deg(360.0 * column / grid.columns);
      const Vec3 radial = tube.up * turn.cosine + side * turn.sine;
      const Vec3 oval = tube.up * (turn.cosine * tube.spread_up) + side * (turn.sine * tube.spread_side);
      const Vec3 origin = mix(tube.start, tube.end, spec.along) + oval * tilt.cosine;
      grid.at(row, column).point = cast(field, origin, radial * tilt.cosine + axis * tilt.sine, tube.reach);
    }
  }
  grid.first_pole.point = cast(field, tube.start, -axis, tube.reach);
  grid.last_pole.point = cast(field, tube.end, axis, tube.reach);
  return grid;
}

void paint(Grid& grid, const std::function<Colour(const Vec3&)>& colour) {
  for (Vertex& v : grid.points)
    v.colour = colour(v.point);
  grid.first_pole.colour = colour(grid.first_pole.point);
  grid.last_pole.colour = colour(grid.last_pole.point);
}

}  // namespace auslan::sculpt
