// SPDX-License-Identifier: Apache-2.0
#include "reduce.h"

#include "field.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <queue>

namespace auslan::sculpt {

namespace {

constexpr size_t kSpace = 3;
constexpr size_t kDimensions = 6;  ///< place and colour
/// A difference of black and white counts as much as a displacement of so many millimetres.
constexpr double kColourRange = 14.0;
/// What moving a vertex along its own plane costs: little, but slivers cost most.
constexpr double kSpread = 0.003;
/// A triangle may tilt by 75 degrees, and no further, when one of its corners moves.
constexpr double kLeastTilt = 0.26;
/// Cosine of the largest angle between a triangle and the sculpted surface at its corners.
constexpr double kLeastFacing = 0.3;
constexpr double kLeastQuality = 0.04;
constexpr uint32_t kNone = ~uint32_t{0};

using Point = std::array<double, kDimensions>;

double dot(const Point& a, const Point& b) {
  double sum = 0.0;
  for (size_t i = 0; i < kDimensions; ++i)
    sum += a[i] * b[i];
  return sum;
}

/// x' A x + 2 b' x + c.
struct Quadric {
  std::array<double, kDimensions*(kDimensions + 1) / 2> a{};  ///< upper triangle, row by row
  Point b{};
  double c = 0.0;

  void add(const Quadric& other) {
    for (size_t i = 0; i < a.size(); ++i)
      a[i] += other.a[i];
    for (size_t i = 0; i < b.size(); ++i)
      b[i] += other.b[i];
    c += other.c;
  }
  double at(const Point& x) const {
    double sum = c;
    size_t k = 0;
    for (size_t i = 0; i < kDimensions; ++i) {
      sum += a[k++] * x[i] * x[i] + 2.0 * b[i] * x[i];
      for (size_t j = i + 1; j < kDimensions; ++j)
        sum += 2.0 * a[k++] * x[i] * x[j];
    }
    return sum;
  }
};

/// The squared distance from the plane of three points, times `weight`; the plane lies in all dimensions.
Quadric plane(const Point& p, const Point& q, const Point& r, double weight) {
  const auto minus = [](const Point& a, const Point& b, double times) {
    Point d;
    for (size_t i = 0; i < kDimensions; ++i)
      d[i] = a[i] - b[i] * times;
    return d;
  };
  const auto unit = [](Point v) {
    const double norm = std::sqrt(dot(v, v));
    for (double& x : v)
      x = norm > 0.0 ? x / norm : 0.0;
    return v;
  };
  const Point e = unit(minus(q, p, 1.0));
  const Point side = minus(r, p, 1.0);
  const Point f = unit(minus(side, e, dot(side, e)));
  const double along = dot(p, e);
  const double across = dot(p, f);
  Quadric result;
  size_t k = 0;
  for (size_t i = 0; i < kDimensions; ++i) {
    for (size_t j = i; j < kDimensions; ++j)
      result.a[k++] = weight * ((i == j ? 1.0 : 0.0) - e[i] * e[j] - f[i] * f[j]);
    result.b[i] = weight * (e[i] * along + f[i] * across - p[i]);
  }
  result.c = weight * (dot(p, p) - along * along - across * across);
  return result;
}

/// The squared distance from a point in space.
Quadric spot(const Point& p, double weight) {
  Quadric result;
  size_t k = 0;
  for (size_t i = 0; i < kDimensions; ++i) {
    result.a[k] = i < kSpace ? weight : 0.0;
    k += kDimensions - i;
    if (i >= kSpace) continue;
    result.b[i] = -weight * p[i];
    result.c += weight * p[i] * p[i];
  }
  return result;
}

Vec3 place(const Point& p) {
  return {p[0], p[1], p[2]};
}

class Reducer {
 public:
  explicit Reducer(const Sculpture& sculpture) : sculpture_(sculpture) {
    const Mesh& mesh = sculpture.mesh;
    const size_t count = mesh.positions.size();
    for (size_t i = 0; i < count; ++i)
      symmetric_ = symmetric_ || sculpture.mirror[i] != i;
    views_.resize(1 + sculpture.poses.size(), std::vector<Point>(count));
    for (size_t i = 0; i < count; ++i) {
      const Vec3 rest = Vec3(mesh.positions[i]) * 1000.0;
      const glm::u8vec4& colour = mesh.colours[i];
      views_[0][i] = {rest.x, rest.y, rest.z};
      for (size_t channel = 0; channel < 3; ++channel)
        views_[0][i][kSpace + channel] = colour[static_cast<int>(channel)] * (kColourRange / 255.0);
      for (size_t pose = 0; pose < sculpture.poses.size(); ++pose) {
        const Vec3& p = sculpture.poses[pose][i];
        views_[pose + 1][i] = {p.x, p.y, p.z};
      }
    }
    around_.resize(count);
    stamps_.assign(count, 0);
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
      const std::array<uint32_t, 3> corners = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
      // Of a symmetric mesh the half with x >= 0 is reduced; the other half is its image.
      if (symmetric_ && std::ranges::any_of(corners, [&](uint32_t v) { return mesh.positions[v].x < 0.0F; })) continue;
      for (const uint32_t corner : corners)
        around_[corner].push_back(static_cast<uint32_t>(triangles_.size()));
      triangles_.push_back(corners);
    }
    alive_.assign(triangles_.size(), true);
    left_ = triangles_.size();
    quadrics_.assign(views_.size(), std::vector<Quadric>(count));
    for (const auto& corners : triangles_)
      add_plane(corners);
  }

  void run(size_t triangles) {
    const size_t wanted = symmetric_ ? triangles / 2 : triangles;
    for (uint32_t v = 0; v < around_.size(); ++v)
      offer(v);
    while (left_ > wanted && !queue_.empty()) {
      const Collapse next = queue_.top();
      queue_.pop();
      if (stamps_[next.from] != next.from_stamp || stamps_[next.to] != next.to_stamp || !is_legal(next.from, next.to))
        continue;
      collapse(next.from, next.to);
    }
  }

  Mesh result() const {
    const Mesh& mesh = sculpture_.mesh;
    std::vector<uint32_t> kept;
    std::vector<std::array<uint32_t, 3>> triangles;
    std::vector<uint32_t> index(mesh.positions.size(), kNone);
    for (size_t i = 0; i < triangles_.size(); ++i) {
      if (!alive_[i]) continue;
      const auto& [a, b, c] = triangles_[i];
      triangles.push_back({a, b, c});
      if (symmetric_) triangles.push_back({sculpture_.mirror[a], sculpture_.mirror[c], sculpture_.mirror[b]});
    }
    for (const auto& corners : triangles)
      for (const uint32_t corner : corners)
        index[corner] = 0;
    for (uint32_t v = 0; v < index.size(); ++v) {
      if (index[v] == kNone) continue;
      index[v] = static_cast<uint32_t>(kept.size());
      kept.push_back(v);
    }
    Mesh out;
    for (const uint32_t v : kept) {
      out.positions.push_back(mesh.positions[v]);
      out.normals.push_back(mesh.normals[v]);
      out.colours.push_back(mesh.colours[v]);
      out.paint.push_back(mesh.paint[v]);
    }
    for (const auto& corners : triangles)
      for (const uint32_t corner : corners)
        out.indices.push_back(index[corner]);
    for (const Morph& morph : mesh.morphs) {
      Morph less;
      less.channel = morph.channel;
      for (size_t i = 0; i < morph.vertices.size(); ++i) {
        if (index[morph.vertices[i]] == kNone) continue;
        less.vertices.push_back(index[morph.vertices[i]]);
        less.displacement.push_back(morph.displacement[i]);
      }
      out.morphs.push_back(std::move(less));
    }
    return out;
  }

 private:
  struct Collapse {
    double cost;
    uint32_t from, to, from_stamp, to_stamp;
    /// The least cost comes out first; no two are alike.
    bool operator<(const Collapse& other) const {
      if (cost != other.cost) return cost > other.cost;
      if (from != other.from) return from > other.from;
      return to > other.to;
    }
  };

  void add_plane(const std::array<uint32_t, 3>& corners) {
    const auto& [a, b, c] = corners;
    const double importance = (sculpture_.importance[a] + sculpture_.importance[b] + sculpture_.importance[c]) / 3.0;
    for (size_t view = 0; view < views_.size(); ++view) {
      const std::vector<Point>& at = views_[view];
      const double area = 0.5 * length(glm::cross(place(at[b]) - place(at[a]), place(at[c]) - place(at[a])));
      const Quadric flat = plane(at[a], at[b], at[c], area * importance);
      for (const uint32_t corner : corners) {
        quadrics_[view][corner].add(flat);
        if (view == 0) quadrics_[view][corner].add(spot(at[corner], area * importance * kSpread));
      }
    }
  }

  bool on_seam(uint32_t v) const { return symmetric_ && sculpture_.mirror[v] == v; }

  /// Ascending, without v itself.
  std::vector<uint32_t> neighbours(uint32_t v) const {
    std::vector<uint32_t> found;
    for (const uint32_t triangle : around_[v])
      for (const uint32_t corner : triangles_[triangle])
        if (corner != v) found.push_back(corner);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  bool has(uint32_t triangle, uint32_t v) const { return std::ranges::count(triangles_[triangle], v) != 0; }

  size_t triangles_at(uint32_t a, uint32_t b) const {
    return static_cast<size_t>(std::ranges::count_if(around_[a], [&](uint32_t t) { return has(t, b); }));
  }

  void offer(uint32_t v) {
    for (const uint32_t other : neighbours(v)) {
      push(v, other);
      push(other, v);
    }
  }

  void push(uint32_t from, uint32_t to) {
    if (on_seam(from) && !on_seam(to)) return;
    double cost = 0.0;
    for (size_t view = 0; view < views_.size(); ++view) {
      const Point& x = views_[view][to];
      cost += positive(quadrics_[view][from].at(x)) + positive(quadrics_[view][to].at(x));
    }
    queue_.push({cost, from, to, stamps_[from], stamps_[to]});
  }

  bool is_legal(uint32_t from, uint32_t to) const {
    const std::vector<uint32_t> at_from = neighbours(from), at_to = neighbours(to);
    std::vector<uint32_t> common;
    std::ranges::set_intersection(at_from, at_to, std::back_inserter(common));
    // Both ends meet at the triangles of their edge and nowhere else (Dey and others 1999, the link condition).
    const size_t shared = triangles_at(from, to);
    if (shared == 0 || common.size() != shared) return false;
    if (on_seam(from) && shared != 1) return false;
    if (on_seam(to)) {
      // No edge may lead across from seam to seam: its image would be the same edge.
      for (const uint32_t v : at_from) {
        if (v == to || !on_seam(v)) continue;
        if (!on_seam(from) || triangles_at(from, v) != 1) return false;
      }
    }
    for (const uint32_t triangle : around_[from]) {
      if (has(triangle, to)) continue;
      std::array<uint32_t, 3> moved = triangles_[triangle];
      std::ranges::replace(moved, from, to);
      if (!stays_upright(triangles_[triangle], moved)) return false;
      // Two triangles back to back are no body.
      for (const uint32_t other : around_[to])
        if (has(other, moved[0]) && has(other, moved[1]) && has(other, moved[2])) return false;
    }
    return true;
  }

  bool stays_upright(const std::array<uint32_t, 3>& before, const std::array<uint32_t, 3>& after) const {
    const std::vector<glm::vec3>& exact = sculpture_.mesh.positions;
    if (exact[after[0]] == exact[after[1]] || exact[after[1]] == exact[after[2]] || exact[after[2]] == exact[after[0]])
      return false;
    const auto sides = [&](size_t view, const std::array<uint32_t, 3>& corners) {
      const Vec3 a = place(views_[view][corners[0]]);
      return std::array<Vec3, 2>{place(views_[view][corners[1]]) - a, place(views_[view][corners[2]]) - a};
    };
    for (size_t view = 1; view < views_.size(); ++view) {
      const auto [p, q] = sides(view, before);
      const auto [s, t] = sides(view, after);
      const Vec3 old_area = glm::cross(p, q), new_area = glm::cross(s, t);
      if (glm::dot(old_area, new_area) < kLeastTilt * length(old_area) * length(new_area)) return false;
    }
    const auto [p, q] = sides(0, before);
    const auto [s, t] = sides(0, after);
    const Vec3 old_area = glm::cross(p, q), new_area = glm::cross(s, t);
    const double old_size = length(old_area), new_size = length(new_area);
    if (glm::dot(old_area, new_area) < kLeastTilt * old_size * new_size) return false;
    // Many small tilts must not add up to a fold: the surface as it was sculpted decides.
    const auto facing = [&](const std::array<uint32_t, 3>& corners, const Vec3& area, double size) {
      double least = 1.0;
      for (const uint32_t corner : corners)
        least = std::min(least, glm::dot(area, Vec3(sculpture_.mesh.normals[corner])) / size);
      return least;
    };
    if (!(new_size > 0.0) ||
        facing(after, new_area, new_size) < std::min(kLeastFacing, facing(before, old_area, old_size)))
      return false;
    const auto quality = [](const Vec3& u, const Vec3& v, double area) {
      const double edges = glm::dot(u, u) + glm::dot(v, v) + glm::dot(u - v, u - v);
      return edges > 0.0 ? 3.4641016151377544 * area / edges : 0.0;
    };
    const double least = std::min(kLeastQuality, quality(p, q, old_size));
    return quality(s, t, new_size) >= least;
  }

  void collapse(uint32_t from, uint32_t to) {
    for (const uint32_t triangle : around_[from]) {
      if (has(triangle, to)) {
        alive_[triangle] = false;
        --left_;
        for (const uint32_t corner : triangles_[triangle])
          if (corner != from) std::erase(around_[corner], triangle);
        continue;
      }
      std::ranges::replace(triangles_[triangle], from, to);
      around_[to].push_back(triangle);
    }
    around_[from].clear();
    ++stamps_[from];
    ++stamps_[to];
    for (auto& view : quadrics_)
      view[to].add(view[from]);
    offer(to);
    // What was illegal before may now be legal.
    for (const uint32_t v : neighbours(to))
      for (const uint32_t other : neighbours(v))
        if (other != to) push(v, other);
  }

  const Sculpture& sculpture_;
  bool symmetric_ = false;
  std::vector<std::vector<Point>> views_;
  std::vector<std::vector<Quadric>> quadrics_;
  std::vector<std::array<uint32_t, 3>> triangles_;
  std::vector<bool> alive_;
  std::vector<std::vector<uint32_t>> around_;
  std::vector<uint32_t> stamps_;
  std::priority_queue<Collapse> queue_;
  size_t left_ = 0;
};

}  // namespace

Mesh reduced(const Sculpture& sculpture, size_t triangles) {
  if (sculpture.mesh.indices.size() / 3 <= triangles) return sculpture.mesh;
  Reducer reducer(sculpture);
  reducer.run(triangles);
  return reducer.result();
}

}  // namespace auslan::sculpt
