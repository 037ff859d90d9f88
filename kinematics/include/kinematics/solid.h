// SPDX-License-Identifier: Apache-2.0
// A mesh as a body with an inside: how far a point lies from its surface, or how deep below it.
#pragma once

#include "kinematics/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace auslan {

/// The place of a surface that is nearest to a point, in the mesh's frame.
struct NearestSurface {
  Vec3 position{0.0};
  Vec3 normal{0.0};     ///< unit, outwards; where edges meet, the mean of their triangles weighted by angle
  double distance = 0;  ///< metres; negative for a point inside
};

/// One or more closed parts that may overlap, as a figure's segments are. Built once, asked often; owns what it needs.
///
/// Whether a point is inside is told by the angle-weighted normal of the nearest vertex, edge or triangle of each part
/// (Baerentzen & Aanaes 2005), which is exact for closed parts that do not cut themselves. Parts with a rim, as foreign
/// figures have them, are taken as one surface: near a rim a point may be told on the wrong side.
class Solid {
 public:
  /// The mesh passes check_figure. An empty one makes a solid that is nowhere.
  explicit Solid(const Mesh& mesh);

  /// Nothing when the surface is farther than `within` metres. A point inside several parts is as deep as in the one in
  /// which it is deepest: never deeper than it truly is below the surface of all of them together.
  std::optional<NearestSurface> nearest(const Vec3& point, double within) const;

  /// How far a point has to move at least to be deeper than `depth`, metres, told from the grid alone; 0 where the grid
  /// does not tell that it is not so deep.
  double clear_of(const Vec3& point, double depth) const {
    if (parts_.empty()) return std::numeric_limits<double>::max();
    const Whereabouts at = whereabouts(point);
    return at.side == Grid::Side::kOutside ? std::max(0.0, at.gap + depth) : 0.0;
  }

  /// How far from the surface a point outside is at least, metres, told from the grid alone; negative where the grid
  /// does not tell it to be outside.
  double clearance(const Vec3& point) const;

  /// Whether a part winds round the point by more than half (the generalised winding number of Jacobson, Kavan &
  /// Sorkine-Hornung 2013). It takes every triangle, so it is slow; it is right where the sign of nearest() may not be:
  /// where a surface touches itself, as lips do, and near a rim.
  bool contains(const Vec3& point) const;

  /// A box that holds everything, mesh frame; low > high for an empty solid.
  const Vec3& low() const { return low_; }
  const Vec3& high() const { return high_; }

 private:
  struct Triangle {
    std::array<Vec3, 3> corner;
    Vec3 middle{0.0};                     ///< of a ball that holds it
    double radius = 0.0;                  ///< of that ball
    Vec3 normal{0.0};                     ///< unit, or zero without area
    std::array<Vec3, 3> edge_normal{};    ///< of corner i to corner i + 1; any length
    std::array<Vec3, 3> corner_normal{};  ///< any length
  };
  /// A node of a part's tree: a box round some triangles, two nodes or a few triangles below it.
  struct Box {
    Vec3 low, high;
    uint32_t first = 0;  ///< of its triangles; of a node with children: the first child, the other follows
    uint32_t count = 0;  ///< of its triangles; 0: it has children
  };
  /// Two numbers that are computed side by side, with the same operations as one by itself.
  using Two [[gnu::vector_size(16)]] = double;
  /// Bounds of two boxes side by side, by axis.
  struct Pair {
    std::array<Two, 3> low{}, high{};
  };
  struct Part {
    std::vector<Triangle> triangles;
    std::vector<Box> boxes;   ///< the root first, then the children of one box after the other
    std::vector<Pair> pairs;  ///< boxes 1 and 2, 3 and 4, ...
    bool closed = false;
  };

  /// Of cells in the box round everything: how far from all surfaces each is at least, and on which side of them.
  struct Grid {
    enum class Side : uint8_t { kUnknown, kOutside, kInside };
    struct Cell {
      uint8_t gap = UINT8_MAX;          ///< steps to the next cell that a surface crosses; 0: one crosses this
      Side side = Side::kUnknown;       ///< of a crossed cell unknown
      uint32_t part = 0, triangle = 0;  ///< one that crosses, or crosses the next such cell
    };
    double cell = 0.0, cells_per_metre = 0.0;  ///< length of an edge, metres
    std::array<int, 3> count{};                ///< of cells
    std::vector<Cell> cells;                   ///< the first axis runs fastest
  };
  struct Whereabouts {
    Grid::Side side = Grid::Side::kUnknown;
    double gap = 0.0;                  ///< metres to the surface, at least
    const Grid::Cell* cell = nullptr;  ///< null beyond the box
  };

  static double squared_distance(const Vec3& low, const Vec3& high, const Vec3& point) {
    double sum = 0.0;
    for (glm::length_t i = 0; i < 3; ++i) {
      const double below = low[i] - point[i], above = point[i] - high[i];
      const double larger = below > above ? below : above;
      const double beyond = larger > 0.0 ? larger : 0.0;
      sum += beyond * beyond;
    }
    return sum;
  }
  std::array<int, 3> cell_of(const Vec3& point) const {
    std::array<int, 3> cell{};
    for (size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<glm::length_t>(i);
      cell[i] =
          static_cast<int>(std::clamp((point[axis] - low_[axis]) * grid_.cells_per_metre, 0.0, grid_.count[i] - 1.0));
    }
    return cell;
  }
  void make_grid();
  void mark_crossed();
  void find_sides();
  void find_gaps();
  Whereabouts whereabouts(const Vec3& point) const {
    constexpr double kRounding = 1e-9;
    const double beyond = squared_distance(low_, high_, point);
    if (beyond > 0.0) return {Grid::Side::kOutside, std::sqrt(beyond) - kRounding, nullptr};
    const std::array<int, 3> at = cell_of(point);
    const Grid::Cell& cell =
        grid_.cells[static_cast<size_t>((at[2] * grid_.count[1] + at[1]) * grid_.count[0] + at[0])];
    return {cell.side, (std::max<int>(cell.gap, 1) - 1) * grid_.cell - kRounding, &cell};
  }

  static Part make_part(std::span<const glm::vec3> positions, std::span<const uint32_t> indices,
                        std::span<const uint32_t> triangles);
  static void divide(Part& part, uint32_t box, std::span<uint32_t> order);
  std::optional<NearestSurface> nearest(const Vec3& point, double within, const Whereabouts& at) const;
  /// `guess` may be null: a triangle of the part that may be near.
  static std::optional<NearestSurface> nearest_of(const Part& part, const Vec3& point, double within,
                                                  const Triangle* guess);

  std::vector<Part> parts_;
  Grid grid_;
  Vec3 low_{1.0}, high_{-1.0};
};

}  // namespace auslan
