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
constexpr double kNowhere = 1e9;  // metres

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

double squared_distance(const Vec3& low, const Vec3& high, const Vec3& point) {
  const double x = std::max(std::max(low.x - point.x, point.x - high.x), 0.0);
  const double y = std::max(std::max(low.y - point.y, point.y - high.y), 0.0);
  const double z = std::max(std::max(low.z - point.z, point.z - high.z), 0.0);
  return (x * x + y * y) + z * z;
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
    } else {
      open.insert(open.end(), triangles.begin(), triangles.end());
    }
  }
  if (!open.empty()) parts_.push_back(make_part(mesh.positions, indices, open));
  for (size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    low_ = i == 0 ? part.low : glm::min(low_, part.low);
    high_ = i == 0 ? part.high : glm::max(high_, part.high);
  }
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
    triangle.middle = (at[0] + at[1] + at[2]) / 3.0;
    for (const Vec3& corner : at)
      triangle.radius = std::max(triangle.radius, std::sqrt(square(corner - triangle.middle)));
    triangle.radius *= 1.0 + 1e-9;
    triangle.normal = unit(glm::cross((at[1] - at[0]) * 1e3, (at[2] - at[0]) * 1e3), Vec3(0.0));
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
  std::vector<Box> boxes = {{Vec3(0.0), Vec3(0.0), 0, static_cast<uint32_t>(order.size())}};
  divide(part, boxes, 0, order);
  part.low = boxes.front().low;
  part.high = boxes.front().high;
  add_four(part, boxes, 0);
  std::vector<Triangle> sorted;
  sorted.reserve(order.size());
  for (const uint32_t triangle : order)
    sorted.push_back(part.triangles[triangle]);
  part.triangles = std::move(sorted);
  return part;
}

void Solid::divide(const Part& part, std::vector<Box>& boxes, uint32_t box_index, std::span<uint32_t> order) {
  Box box = boxes[box_index];
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
    boxes[box_index] = box;
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
  const auto children = static_cast<uint32_t>(boxes.size());
  boxes.push_back({Vec3(0.0), Vec3(0.0), box.first, count / 2});
  boxes.push_back({Vec3(0.0), Vec3(0.0), box.first + count / 2, count - count / 2});
  box.first = children;
  box.count = 0;
  boxes[box_index] = box;
  divide(part, boxes, children, order);
  divide(part, boxes, children + 1, order);
}

uint32_t Solid::add_four(Part& part, std::span<const Box> boxes, uint32_t box) {
  // Those two levels below, or leaves above that.
  std::vector<uint32_t> below = {box};
  for (int level = 0; level < 2; ++level) {
    std::vector<uint32_t> next;
    for (const uint32_t one : below) {
      if (boxes[one].count > 0)
        next.push_back(one);
      else
        next.insert(next.end(), {boxes[one].first, boxes[one].first + 1});
    }
    below = std::move(next);
  }
  const auto index = static_cast<uint32_t>(part.tree.size());
  part.tree.emplace_back();
  FourBoxes four;
  for (size_t c = 0; c < 4; ++c) {
    const Box* const child = c < below.size() ? &boxes[below[c]] : nullptr;
    for (size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<glm::length_t>(axis);
      four.middle[axis][c] = child != nullptr ? 0.5 * (child->low[i] + child->high[i]) : kNowhere;
      // A little more, for what is rounded.
      four.half[axis][c] = child != nullptr ? 0.5 * (child->high[i] - child->low[i]) * (1.0 + 1e-9) + 1e-12 : 0.0;
    }
    if (child == nullptr) continue;
    four.count[c] = child->count;
    four.first[c] = child->count > 0 ? child->first : add_four(part, boxes, below[c]);
  }
  part.tree[index] = four;
  return index;
}

std::optional<NearestSurface> Solid::nearest_of(const Part& part, const Vec3& point, double within) {
  double best = within * within, radius = within;
  const Triangle* nearest = nullptr;
  Vec3 weights(0.0);
  const auto take = [&](const Triangle& triangle) {
    // A ball that holds the triangle tells most of those that are too far.
    const double reach = radius + triangle.radius;
    if (square(point - triangle.middle) > reach * reach) return;
    const Vec3 w = nearest_weights(triangle.corner, point);
    const Vec3 place = (triangle.corner[0] * w.x + triangle.corner[1] * w.y) + triangle.corner[2] * w.z;
    const double distance = square(point - place);
    // Of triangles that are equally near, one with an area tells inside from outside; of these the first.
    if (distance > best) return;
    if (distance == best && nearest != nullptr &&
        (triangle.normal == Vec3(0.0) || (nearest < &triangle && nearest->normal != Vec3(0.0))))
      return;
    best = distance;
    radius = std::sqrt(best);
    nearest = &triangle;
    weights = w;
  };
  struct Waiting {
    uint32_t first, count;
    double distance;  // squared, from the point to the box
  };
  std::array<Waiting, 3 * kDeepest> stack;
  stack[0] = {0, 0, 0.0};
  size_t depth = 1;
  while (depth > 0) {
    const Waiting next = stack[--depth];
    if (next.distance > best) continue;
    if (next.count > 0) {
      for (uint32_t i = next.first; i < next.first + next.count; ++i)
        take(part.triangles[i]);
      continue;
    }
    const FourBoxes& four = part.tree[next.first];
    std::array<double, 4> distance{};
    for (size_t axis = 0; axis < 3; ++axis) {
      const double at = point[static_cast<glm::length_t>(axis)];
      for (size_t c = 0; c < 4; ++c) {
        const double beyond = std::abs(at - four.middle[axis][c]) - four.half[axis][c];
        const double twice = beyond + std::abs(beyond);  // 0 within
        distance[c] += 0.25 * (twice * twice);
      }
    }
    // The nearest on top.
    const size_t base = depth;
    for (size_t c = 0; c < 4; ++c) {
      if (!(distance[c] <= best)) continue;
      size_t at = depth++;
      for (; at > base && stack[at - 1].distance < distance[c]; --at)
        stack[at] = stack[at - 1];
      stack[at] = {four.first[c], four.count[c], distance[c]};
    }
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

std::optional<NearestSurface> Solid::nearest(const Vec3& point, double within) const {
  std::optional<NearestSurface> outside;
  std::optional<NearestSurface> inside;
  for (const Part& part : parts_) {
    // Beyond a part's box a point is outside the part, and only a nearer surface counts.
    const bool beyond = squared_distance(part.low, part.high, point) > 0.0;
    if (beyond && inside) continue;
    const auto found = nearest_of(part, point, beyond && outside ? outside->distance : within);
    if (!found) continue;
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
    if (squared_distance(part.low, part.high, point) > 0.0) return false;
    double angle = 0.0;
    for (const Triangle& triangle : part.triangles)
      angle += solid_angle(triangle.corner[0] - point, triangle.corner[1] - point, triangle.corner[2] - point);
    return angle > 2.0 * kPi;
  });
}

}  // namespace auslan
