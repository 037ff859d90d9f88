// SPDX-License-Identifier: Apache-2.0
#include "kinematics/solid.h"

#include "kinematics/elementary.h"
#include "kinematics/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace auslan {
namespace {

constexpr uint32_t kLeaf = 4;  // triangles of a box that is not divided
constexpr size_t kDeepest = 64;
// The grid: so many cells at most, and none smaller than this.
constexpr double kMostCells = 20000.0, kSmallestCell = 0.008;  // metres
// Cells that all triangles together may lie in; a figure's segment takes some ten thousand.
constexpr size_t kMostMarks = size_t{1} << 22;

double square(const Vec3& v) {
  return glm::dot(v, v);
}

/// The triangles' corners with one number for all vertices in one place: texture seams do not take a surface apart.
std::vector<uint32_t> welded_indices(const Mesh& mesh) {
  std::vector<uint32_t> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto before = [&mesh](uint32_t a, uint32_t b) {
    const glm::vec3& p = mesh.positions[a];
    const glm::vec3& q = mesh.positions[b];
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  };
  std::stable_sort(order.begin(), order.end(), before);
  std::vector<uint32_t> first(order.size());
  for (size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && !before(order[i - 1], order[i]) ? first[order[i - 1]] : order[i];
  std::vector<uint32_t> indices;
  for (const uint32_t index : mesh.indices)
    indices.push_back(first[index]);
  return indices;
}

/// Which part each vertex belongs to: vertices of one triangle belong together.
std::vector<uint32_t> part_of_vertices(std::span<const uint32_t> indices, size_t vertices) {
  std::vector<uint32_t> parent(vertices);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&parent](uint32_t vertex) {
    while (parent[vertex] != vertex)
      vertex = parent[vertex] = parent[parent[vertex]];
    return vertex;
  };
  for (size_t i = 0; i + 2 < indices.size(); i += 3) {
    for (const size_t corner : {i + 1, i + 2}) {
      const auto [low, high] = std::minmax({root(indices[i]), root(indices[corner])});
      parent[high] = low;
    }
  }
  for (uint32_t vertex = 0; vertex < parent.size(); ++vertex)
    parent[vertex] = root(vertex);
  return parent;
}

bool is_closed(std::span<const uint32_t> indices, std::span<const uint32_t> triangles) {
  std::vector<std::pair<uint32_t, uint32_t>> edges;
  for (const uint32_t triangle : triangles) {
    const auto corner = indices.subspan(3 * size_t{triangle}, 3);
    for (size_t c = 0; c < 3; ++c)
      edges.push_back(std::minmax({corner[c], corner[(c + 1) % 3]}));
  }
  std::ranges::sort(edges);
  for (size_t i = 0; i < edges.size(); i += 2)
    if (i + 1 == edges.size() || edges[i] != edges[i + 1]) return false;
  return true;
}

/// Where a point is nearest to a triangle: the weights of its corners, after Ericson, Real-Time Collision Detection
/// (2005), 5.1.5. A weight is exactly 0 where the place lies on the edge opposite to that corner.
Vec3 nearest_weights(const std::array<Vec3, 3>& corner, const Vec3& point) {
  const Vec3 ab = corner[1] - corner[0];
  const Vec3 ac = corner[2] - corner[0];
  const Vec3 ap = point - corner[0];
  const double d1 = glm::dot(ab, ap);
  const double d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const Vec3 bp = point - corner[1];
  const double d3 = glm::dot(ab, bp);
  const double d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 / (d1 - d3);
    return {1.0 - v, v, 0.0};
  }
  const Vec3 cp = point - corner[2];
  const double d5 = glm::dot(ab, cp);
  const double d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 / (d2 - d6);
    return {1.0 - w, 0.0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0.0, 1.0 - w, w};
  }
  const double sum = (va + vb) + vc;
  return {va / sum, vb / sum, vc / sum};
}

/// Of a triangle seen from the origin, steradians, positive from behind (van Oosterom & Strackee 1983).
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = std::sqrt(square(a));
  const double lb = std::sqrt(square(b));
  const double lc = std::sqrt(square(c));
  const double above = glm::dot(a, glm::cross(b, c));
  const double below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2.0 * arc_tangent(above, below);
}

double corner_angle(const Vec3& from, const Vec3& a, const Vec3& b) {
  return arc_cosine(glm::dot(unit(a - from, Vec3(0.0)), unit(b - from, Vec3(0.0))));
}

}  // namespace

Solid::Solid(const Mesh& mesh) {
  const std::vector<uint32_t> indices = welded_indices(mesh);
  const std::vector<uint32_t> part_of = part_of_vertices(indices, mesh.positions.size());
  std::map<uint32_t, std::vector<uint32_t>> triangles_of;
  for (uint32_t i = 0; i < indices.size() / 3; ++i)
    triangles_of[part_of[indices[3 * size_t{i}]]].push_back(i);
  std::vector<uint32_t> open;
  for (const auto& [vertex, triangles] : triangles_of) {
    if (is_closed(indices, triangles)) {
      parts_.push_back(make_part(mesh.positions, indices, triangles));
      parts_.back().closed = true;
    } else {
      open.insert(open.end(), triangles.begin(), triangles.end());
    }
  }
  if (!open.empty()) parts_.push_back(make_part(mesh.positions, indices, open));
  for (size_t i = 0; i < parts_.size(); ++i) {
    const Box& box = parts_[i].boxes.front();
    low_ = i == 0 ? box.low : glm::min(low_, box.low);
    high_ = i == 0 ? box.high : glm::max(high_, box.high);
  }
  if (!parts_.empty()) make_grid();
}

Solid::Part Solid::make_part(std::span<const glm::vec3> positions, std::span<const uint32_t> indices,
                             std::span<const uint32_t> triangles) {
  Part part;
  std::vector<Vec3> of_corner(positions.size(), Vec3(0.0));
  struct Edge {
    std::pair<uint32_t, uint32_t> ends;
    size_t triangle, corner;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  part.triangles.reserve(triangles.size());
  const auto index = [&](uint32_t triangle, size_t corner) { return indices[3 * size_t{triangle} + corner % 3]; };
  const auto edge = [&](uint32_t triangle, size_t corner) {
    return std::minmax({index(triangle, corner), index(triangle, corner + 1)});
  };
  for (const uint32_t i : triangles) {
    Triangle triangle;
    for (size_t c = 0; c < 3; ++c)
      triangle.corner[c] = Vec3(positions[index(i, c)]);
    // In millimetres: twice the area of a triangle of skin is far below what unit() takes for zero.
    const std::array<Vec3, 3>& at = triangle.corner;
    triangle.normal = unit(glm::cross((at[1] - at[0]) * 1e3, (at[2] - at[0]) * 1e3), Vec3(0.0));
    triangle.middle = (1.0 / 3.0) * ((at[0] + at[1]) + at[2]);
    for (const Vec3& corner : at)
      triangle.radius = std::max(triangle.radius, (1.0 + 1e-12) * std::sqrt(square(corner - triangle.middle)) + 1e-12);
    for (size_t c = 0; c < 3; ++c) {
      of_corner[index(i, c)] += triangle.normal * corner_angle(at[c], at[(c + 1) % 3], at[(c + 2) % 3]);
      edges.push_back({edge(i, c), part.triangles.size(), c});
    }
    part.triangles.push_back(triangle);
  }
  for (size_t i = 0; i < triangles.size(); ++i)
    for (size_t c = 0; c < 3; ++c)
      part.triangles[i].corner_normal[c] = of_corner[index(triangles[i], c)];
  std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
    return std::tie(a.ends, a.triangle, a.corner) < std::tie(b.ends, b.triangle, b.corner);
  });
  for (size_t first = 0, last = 0; first < edges.size(); first = last) {
    Vec3 sum(0.0);
    for (last = first; last < edges.size() && edges[last].ends == edges[first].ends; ++last)
      sum += part.triangles[edges[last].triangle].normal;
    for (size_t i = first; i < last; ++i)
      part.triangles[edges[i].triangle].edge_normal[edges[i].corner] = sum;
  }
  // The tree is made of numbers; the triangles are moved once.
  std::vector<uint32_t> order(part.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  part.boxes.push_back({Vec3(0.0), Vec3(0.0), 0, static_cast<uint32_t>(order.size())});
  divide(part, 0, order);
  for (size_t i = 1; i + 1 < part.boxes.size(); i += 2) {
    Pair pair;
    const Box &a = part.boxes[i], &b = part.boxes[i + 1];
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      pair.low[static_cast<size_t>(axis)] = Two{a.low[axis], b.low[axis]};
      pair.high[static_cast<size_t>(axis)] = Two{a.high[axis], b.high[axis]};
    }
    part.pairs.push_back(pair);
  }
  std::vector<Triangle> sorted;
  sorted.reserve(order.size());
  for (const uint32_t triangle : order)
    sorted.push_back(part.triangles[triangle]);
  part.triangles = std::move(sorted);
  return part;
}

void Solid::divide(Part& part, uint32_t box_index, std::span<uint32_t> order) {
  Box box = part.boxes[box_index];
  const std::span<uint32_t> own = order.subspan(box.first, box.count);
  box.low = Vec3(std::numeric_limits<double>::max());
  box.high = -box.low;
  for (const uint32_t triangle : own) {
    for (const Vec3& corner : part.triangles[triangle].corner) {
      box.low = glm::min(box.low, corner);
      box.high = glm::max(box.high, corner);
    }
  }
  const uint32_t count = box.count;
  if (count <= kLeaf) {
    // In the order of the mesh, so that ties do not depend on how a library selects.
    std::ranges::sort(own);
    part.boxes[box_index] = box;
    return;
  }
  const Vec3 extent = box.high - box.low;
  const glm::length_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const auto middle = [&part, axis](uint32_t triangle) {
    const std::array<Vec3, 3>& corner = part.triangles[triangle].corner;
    return (corner[0][axis] + corner[1][axis]) + corner[2][axis];
  };
  std::nth_element(own.begin(), own.begin() + count / 2, own.end(), [&middle](uint32_t a, uint32_t b) {
    const double x = middle(a), y = middle(b);
    return x < y || (x == y && a < b);
  });
  const auto children = static_cast<uint32_t>(part.boxes.size());
  part.boxes.push_back({Vec3(0.0), Vec3(0.0), box.first, count / 2});
  part.boxes.push_back({Vec3(0.0), Vec3(0.0), box.first + count / 2, count - count / 2});
  box.first = children;
  box.count = 0;
  part.boxes[box_index] = box;
  divide(part, children, order);
  divide(part, children + 1, order);
}

std::optional<NearestSurface> Solid::nearest_of(const Part& part, const Vec3& point, double within,
                                                const Triangle* guess) {
  double best = within * within;
  const Triangle* nearest = nullptr;
  Vec3 weights(0.0);
  double reach = std::sqrt(best);
  const auto consider = [&](const Triangle& triangle) {
    const double touching = reach + triangle.radius;
    if (square(point - triangle.middle) > touching * touching) return;
    const Vec3 w = nearest_weights(triangle.corner, point);
    const Vec3 place = (triangle.corner[0] * w.x + triangle.corner[1] * w.y) + triangle.corner[2] * w.z;
    const double distance = square(point - place);
    // Of triangles that are equally near, one with an area tells inside from outside.
    if (distance > best || (distance == best && nearest != nullptr && triangle.normal == Vec3(0.0))) return;
    best = distance;
    reach = std::sqrt(best);
    nearest = &triangle;
    weights = w;
  };
  // A near one to begin with spares most of the others; it is met again in its turn.
  if (guess != nullptr) consider(*guess);
  struct Waiting {
    uint32_t box;
    double distance;  // squared, from the point to the box
  };
  std::array<Waiting, kDeepest> stack;
  const std::array<Two, 3> at = {Two{point.x, point.x}, Two{point.y, point.y}, Two{point.z, point.z}};
  size_t depth = 0;
  const auto wait = [&](uint32_t box, double distance) {
    if (distance <= best) stack[depth++] = {box, distance};
  };
  wait(0, squared_distance(part.boxes[0].low, part.boxes[0].high, point));
  while (depth > 0) {
    const Waiting next = stack[--depth];
    if (next.distance > best) continue;
    const Box& box = part.boxes[next.box];
    if (box.count == 0) {
      const Pair& pair = part.pairs[(box.first - 1) / 2];
      Two to{};
      for (size_t axis = 0; axis < 3; ++axis) {
        const Two below = pair.low[axis] - at[axis], above = at[axis] - pair.high[axis];
        const Two larger = below > above ? below : above;
        const Two beyond = larger > 0.0 ? larger : Two{};
        to += beyond * beyond;
      }
      // The nearer one is taken next.
      const uint32_t nearer = to[0] <= to[1] ? 0 : 1;
      wait(box.first + 1 - nearer, to[1 - nearer]);
      wait(box.first + nearer, to[nearer]);
      continue;
    }
    for (uint32_t i = box.first; i < box.first + box.count; ++i)
      consider(part.triangles[i]);
  }
  if (nearest == nullptr) return std::nullopt;
  NearestSurface found;
  found.position = (nearest->corner[0] * weights.x + nearest->corner[1] * weights.y) + nearest->corner[2] * weights.z;
  Vec3 normal = nearest->normal;
  for (glm::length_t i = 0; i < 3; ++i) {
    const glm::length_t next = (i + 1) % 3;
    const glm::length_t last = (i + 2) % 3;
    if (weights[last] == 0.0 && weights[i] != 0.0 && weights[next] != 0.0)
      normal = nearest->edge_normal[static_cast<size_t>(i)];
    if (weights[next] == 0.0 && weights[last] == 0.0) normal = nearest->corner_normal[static_cast<size_t>(i)];
  }
  found.normal = unit(normal, nearest->normal);
  const double side = glm::dot(point - found.position, normal);
  found.distance = side < 0.0 ? -std::sqrt(best) : std::sqrt(best);
  return found;
}

void Solid::make_grid() {
  const Vec3 extent = glm::max(high_ - low_, Vec3(1e-6));
  grid_.cell = kSmallestCell;
  const auto too_many = [&] {
    double cells = 1.0;
    for (glm::length_t i = 0; i < 3; ++i)
      cells *= extent[i] / grid_.cell + 1.0;
    return cells > kMostCells;
  };
  while (too_many())
    grid_.cell *= 1.0625;
  grid_.cells_per_metre = 1.0 / grid_.cell;
  size_t size = 1;
  for (size_t i = 0; i < 3; ++i) {
    grid_.count[i] = static_cast<int>(extent[static_cast<glm::length_t>(i)] * grid_.cells_per_metre) + 1;
    size *= static_cast<size_t>(grid_.count[i]);
  }
  grid_.cells.resize(size);
  mark_crossed();
  find_sides();
  find_gaps();
}

void Solid::mark_crossed() {
  size_t left = kMostMarks;
  for (uint32_t p = 0; p < parts_.size(); ++p) {
    for (uint32_t t = 0; t < parts_[p].triangles.size(); ++t) {
      const auto& [a, b, c] = parts_[p].triangles[t].corner;
      const std::array<int, 3> first = cell_of(glm::min(glm::min(a, b), c)),
                               last = cell_of(glm::max(glm::max(a, b), c));
      size_t marks = 1;
      for (size_t i = 0; i < 3; ++i)
        marks *= static_cast<size_t>(last[i] - first[i] + 1);
      if (marks > left) {
        // Of triangles that are all as large as the whole a grid knows nothing.
        std::ranges::fill(grid_.cells, Grid::Cell{0, Grid::Side::kUnknown, 0, 0});
        return;
      }
      left -= marks;
      for (int z = first[2]; z <= last[2]; ++z)
        for (int y = first[1]; y <= last[1]; ++y)
          for (int x = first[0]; x <= last[0]; ++x)
            grid_.cells[static_cast<size_t>((z * grid_.count[1] + y) * grid_.count[0] + x)] = {0, Grid::Side::kUnknown,
                                                                                               p, t};
    }
  }
}

void Solid::find_sides() {
  // What can be reached without crossing a surface lies on one side of it.
  std::vector<std::array<int, 3>> waiting;
  const auto index = [this](const std::array<int, 3>& at) {
    return static_cast<size_t>((at[2] * grid_.count[1] + at[1]) * grid_.count[0] + at[0]);
  };
  const auto flood = [&](const std::array<int, 3>& from) {
    const Vec3 middle = low_ + (Vec3(from[0], from[1], from[2]) + 0.5) * grid_.cell;
    const auto surface = nearest(middle, std::numeric_limits<double>::max(), {});
    const auto side = surface && surface->distance < 0.0 ? Grid::Side::kInside : Grid::Side::kOutside;
    grid_.cells[index(from)].side = side;
    waiting.push_back(from);
    while (!waiting.empty()) {
      const std::array<int, 3> at = waiting.back();
      waiting.pop_back();
      for (size_t axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) {
          std::array<int, 3> next = at;
          next[axis] += step;
          if (next[axis] < 0 || next[axis] >= grid_.count[axis]) continue;
          const size_t i = index(next);
          if (grid_.cells[i].gap == 0 || grid_.cells[i].side != Grid::Side::kUnknown) continue;
          grid_.cells[i].side = side;
          waiting.push_back(next);
        }
      }
    }
  };
  for (int z = 0; z < grid_.count[2]; ++z)
    for (int y = 0; y < grid_.count[1]; ++y)
      for (int x = 0; x < grid_.count[0]; ++x)
        if (const size_t i = index({x, y, z}); grid_.cells[i].gap != 0 && grid_.cells[i].side == Grid::Side::kUnknown)
          flood({x, y, z});
  // A surface with a rim does not part inside from outside.
  for (const Part& part : parts_) {
    if (part.closed) continue;
    const std::array<int, 3> first = cell_of(part.boxes.front().low), last = cell_of(part.boxes.front().high);
    for (int z = first[2]; z <= last[2]; ++z)
      for (int y = first[1]; y <= last[1]; ++y)
        for (int x = first[0]; x <= last[0]; ++x)
          grid_.cells[index({x, y, z})].side = Grid::Side::kUnknown;
  }
}

void Solid::find_gaps() {
  // The chessboard's distance in two sweeps (Rosenfeld & Pfaltz 1968).
  const int nx = grid_.count[0], ny = grid_.count[1], nz = grid_.count[2];
  const int row = nx, layer = nx * ny;
  // Half of a cell's neighbours: those that a sweep has passed.
  const auto sweep = [&](int x, int y, int z, int sign) {
    const int at = z * layer + y * row + x;
    Grid::Cell& own = grid_.cells[static_cast<size_t>(at)];
    if (own.gap == 0) return;
    const auto take = [&](int dx, int dy, int dz) {
      const int i = x + sign * dx, j = y + sign * dy, k = z + sign * dz;
      if (i < 0 || j < 0 || k < 0 || i >= nx || j >= ny || k >= nz) return;
      const Grid::Cell& other = grid_.cells[static_cast<size_t>(k * layer + j * row + i)];
      if (other.gap + 1 >= own.gap) return;
      own.gap = static_cast<uint8_t>(other.gap + 1);
      own.part = other.part;
      own.triangle = other.triangle;
    };
    take(-1, 0, 0);
    for (int dx = -1; dx <= 1; ++dx) {
      take(dx, -1, 0);
      for (int dy = -1; dy <= 1; ++dy)
        take(dx, dy, -1);
    }
  };
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x)
        sweep(x, y, z, 1);
  for (int z = nz; z-- > 0;)
    for (int y = ny; y-- > 0;)
      for (int x = nx; x-- > 0;)
        sweep(x, y, z, -1);
}

double Solid::clearance(const Vec3& point) const {
  if (parts_.empty()) return std::numeric_limits<double>::max();
  const Whereabouts at = whereabouts(point);
  return at.side == Grid::Side::kOutside ? at.gap : -1.0;
}

std::optional<NearestSurface> Solid::nearest(const Vec3& point, double within) const {
  if (parts_.empty()) return std::nullopt;
  return nearest(point, within, whereabouts(point));
}

std::optional<NearestSurface> Solid::nearest(const Vec3& point, double within, const Whereabouts& at) const {
  if (at.gap > within) return std::nullopt;
  std::optional<NearestSurface> outside;
  std::optional<NearestSurface> inside;
  for (uint32_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    // Beyond a part's box a point is outside the part, and only a nearer surface counts.
    const Box& box = part.boxes.front();
    const bool beyond = squared_distance(box.low, box.high, point) > 0.0;
    if (beyond && inside) continue;
    const Triangle* guess = at.cell != nullptr && at.cell->part == i ? &part.triangles[at.cell->triangle] : nullptr;
    auto found = nearest_of(part, point, beyond && outside ? outside->distance : within, guess);
    if (!found) continue;
    // The way past a rim may come from behind the surface.
    if (beyond) found->distance = std::abs(found->distance);
    if (found->distance < 0.0) {
      if (!inside || found->distance < inside->distance) inside = found;
    } else if (!outside || found->distance < outside->distance) {
      outside = found;
    }
  }
  return inside ? inside : outside;
}

bool Solid::contains(const Vec3& point) const {
  return std::ranges::any_of(parts_, [&point](const Part& part) {
    const Box& all = part.boxes.front();
    if (squared_distance(all.low, all.high, point) > 0.0) return false;
    double angle = 0.0;
    for (const Triangle& triangle : part.triangles)
      angle += solid_angle(triangle.corner[0] - point, triangle.corner[1] - point, triangle.corner[2] - point);
    return angle > 2.0 * kPi;
  });
}

}  // namespace auslan
