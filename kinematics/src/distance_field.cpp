// SPDX-License-Identifier: Apache-2.0
#include "kinematics/distance_field.h"

#include "kinematics/rotation.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace auslan {
namespace {

// The edge of a cell: a part of the solid's least extent, within bounds; metres.
constexpr double kCellsAcross = 5.0, kSmallest = 0.0035, kLargest = 0.007;
// About the solid's box cells are made, too, metres.
constexpr double kMargin = 0.016;
// Nearer to the surface than this its normal is the way out, metres.
constexpr double kOnSurface = 1e-5;
constexpr uint32_t kBlock = 4;  // cells along the edge of a block
// So many along an axis are nearly two metres; what is larger has cells at one of its corners only.
constexpr int kMostBlocks = 64;

struct Cell {
  enum Status : uint32_t { kEmpty, kBeingMade, kMade };
  std::atomic<uint32_t> status = kEmpty;
  float distance = 0.0F;
  std::array<float, 3> normal{};
};
using Block = std::array<Cell, size_t{kBlock} * kBlock * kBlock>;

SurfacePlane seen_from(const Solid& solid, const Vec3& point) {
  const auto nearest = solid.nearest(point, std::numeric_limits<double>::max());
  if (!nearest) return {std::numeric_limits<double>::max(), Vec3(0.0, 0.0, 1.0)};
  const Vec3 normal = std::abs(nearest->distance) > kOnSurface
                          ? unit((point - nearest->position) / nearest->distance, nearest->normal)
                          : nearest->normal;
  return {nearest->distance, normal};
}

}  // namespace

struct DistanceField::State {
  explicit State(Solid of) : solid(std::move(of)) {
    const Vec3 extent = solid.high() - solid.low();
    if (extent.x < 0.0) return;
    cell = std::clamp(std::min({extent.x, extent.y, extent.z}) / kCellsAcross, kSmallest, kLargest);
    cells_per_metre = 1.0 / cell;
    origin = solid.low() - kMargin;
    size_t all = 1;
    for (size_t i = 0; i < 3; ++i) {
      const double cells = (extent[static_cast<glm::length_t>(i)] + 2.0 * kMargin) / cell;
      blocks_along[i] = static_cast<uint32_t>(std::min(cells / kBlock, kMostBlocks - 1.0)) + 1;
      cells_along[i] = blocks_along[i] * kBlock;
      all *= blocks_along[i];
    }
    blocks = std::make_unique<std::atomic<Block*>[]>(all);
    size = all;
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    for (size_t i = 0; i < size; ++i)
      delete blocks[i].load(std::memory_order_relaxed);
  }

  Block& block(size_t index) const {
    std::atomic<Block*>& slot = blocks[index];
    Block* found = slot.load(std::memory_order_acquire);
    if (found != nullptr) return *found;
    auto made = std::make_unique<Block>();
    if (slot.compare_exchange_strong(found, made.get(), std::memory_order_acq_rel)) return *made.release();
    return *found;  // another thread was faster
  }

  /// Nothing for a point beyond the field.
  std::optional<SurfacePlane> find(const Vec3& point) const {
    std::array<uint32_t, 3> index{};
    Vec3 middle(0.0);
    for (size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<glm::length_t>(i);
      const double along = (point[axis] - origin[axis]) * cells_per_metre;
      if (!(along >= 0.0 && along < cells_along[i])) return std::nullopt;
      index[i] = static_cast<uint32_t>(static_cast<int>(along));
      middle[axis] = origin[axis] + (index[i] + 0.5) * cell;
    }
    const auto in_block = [&index](size_t i) { return index[i] % kBlock; };
    Block& cells =
        block((index[2] / kBlock * blocks_along[1] + index[1] / kBlock) * blocks_along[0] + index[0] / kBlock);
    Cell& own = cells[(in_block(2) * kBlock + in_block(1)) * kBlock + in_block(0)];
    if (own.status.load(std::memory_order_acquire) == Cell::kMade)
      return linear(own.distance, own.normal, point - middle);
    const SurfacePlane seen = seen_from(solid, middle);
    const std::array<float, 3> normal = {static_cast<float>(seen.normal.x), static_cast<float>(seen.normal.y),
                                         static_cast<float>(seen.normal.z)};
    const auto distance = static_cast<float>(seen.distance);
    uint32_t empty = Cell::kEmpty;
    if (own.status.compare_exchange_strong(empty, Cell::kBeingMade, std::memory_order_acq_rel)) {
      own.distance = distance;
      own.normal = normal;
      own.status.store(Cell::kMade, std::memory_order_release);
    }
    return linear(distance, normal, point - middle);
  }
  static SurfacePlane linear(float distance, const std::array<float, 3>& normal, const Vec3& off) {
    const Vec3 n(normal[0], normal[1], normal[2]);
    return {static_cast<double>(distance) + glm::dot(n, off), n};
  }

  Solid solid;
  double cell = 1.0, cells_per_metre = 1.0;  ///< metres
  Vec3 origin{0.0};
  std::array<uint32_t, 3> blocks_along{};
  std::array<double, 3> cells_along{};
  std::unique_ptr<std::atomic<Block*>[]> blocks;
  size_t size = 0;
};

DistanceField::DistanceField(Solid solid) : state_(std::make_unique<State>(std::move(solid))) {}
DistanceField::DistanceField(DistanceField&&) noexcept = default;
DistanceField& DistanceField::operator=(DistanceField&&) noexcept = default;
DistanceField::~DistanceField() = default;

const Solid& DistanceField::solid() const {
  return state_->solid;
}

double DistanceField::clear_of(const Vec3& point, double depth) const {
  const double by_grid = state_->solid.clear_of(point, depth);
  if (by_grid > 0.0) return by_grid;
  const auto plane = state_->find(point);
  return plane ? std::max(0.0, plane->distance + depth) : 0.0;
}

SurfacePlane DistanceField::at(const Vec3& point) const {
  const auto found = state_->find(point);
  return found ? *found : seen_from(state_->solid, point);
}

std::optional<SurfacePlane> DistanceField::below(const Vec3& point, double depth, double& above) const {
  above = state_->solid.clear_of(point, depth);
  if (above > 0.0) return std::nullopt;
  const SurfacePlane plane = at(point);
  above = std::max(0.0, plane.distance + depth);
  return plane.distance < -depth ? std::optional(plane) : std::nullopt;
}

}  // namespace auslan
