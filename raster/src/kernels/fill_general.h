// SPDX-License-Identifier: Apache-2.0
// The long path: a triangle of any size in one tile, over cells of 8 x 8 pixels. Only depth and a promise of the colour
// are written (kDeferred); what lies behind everything that a cell already shows is left out (hierarchical depth,
// Greene, Kass and Miller 1993).
#pragma once

#include "kernel.h"

namespace auslan::raster {

template <class L, size_t kSamples>
struct FillGeneral {
  using F = typename L::F;
  using I = typename L::I;
  using Pattern = SamplePattern<kSamples>;
  static constexpr size_t kRowWords = size_t{kTileStride} * kSamples;

  // An edge within one tile, in whole pixels from the tile's first pixel centre as in SmallGroup; where the edge misses
  // the tile with all of it inside, zeros.
  struct Edge {
    int32_t a, b;
    int32_t start[kSamples];
    int32_t lowest, highest;
  };

  static I lane_numbers() {
    static constexpr uint32_t kNumbers[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    return L::load(kNumbers);
  }
  static F lane_steps(float step) {
    const float steps[8] = {0.0F, step, 2.0F * step, 3.0F * step, 4.0F * step, 5.0F * step, 6.0F * step, 7.0F * step};
    return L::load(steps);
  }

  static int64_t least_step(int32_t a, int32_t b, int32_t reach) {
    return (a < 0 ? int64_t{a} * reach : 0) + (b < 0 ? int64_t{b} * reach : 0);
  }
  static int64_t greatest_step(int32_t a, int32_t b, int32_t reach) {
    return (a > 0 ? int64_t{a} * reach : 0) + (b > 0 ? int64_t{b} * reach : 0);
  }

  // False when nothing of the tile is inside. Edge values are below 2^49: |a|, |b| < 2^24, positions too.
  static bool set_edge(const TileJob& job, const GeneralTriangle& t, size_t from, size_t to, Edge& out) {
    const int64_t dx = int64_t{t.x[to]} - t.x[from];
    const int64_t dy = int64_t{t.y[to]} - t.y[from];
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    const int64_t px = int64_t{job.x} * kSubPixels + kSubPixels / 2 - t.x[from];
    const int64_t py = int64_t{job.y} * kSubPixels + kSubPixels / 2 - t.y[from];
    const int64_t value = dx * py - dy * px - (top_left ? 0 : 1);
    out.a = static_cast<int32_t>(-dy);
    out.b = static_cast<int32_t>(dx);
    int64_t start[kSamples];
    int64_t lowest = 0;
    int64_t highest = 0;
    for (size_t s = 0; s < kSamples; ++s) {
      start[s] = (value - dy * Pattern::kX[s] + dx * Pattern::kY[s]) >> kSubPixelBits;
      if (s == 0 || start[s] < lowest) lowest = start[s];
      if (s == 0 || start[s] > highest) highest = start[s];
    }
    if (highest + greatest_step(out.a, out.b, kTileSize - 1) < 0) return false;
    if (lowest + least_step(out.a, out.b, kTileSize - 1) >= 0) {
      out = Edge{};
      return true;
    }
    // The edge crosses the tile, so no value within it is farther from 0 than the tile is wide: below 2^31.
    for (size_t s = 0; s < kSamples; ++s)
      out.start[s] = static_cast<int32_t>(start[s]);
    out.lowest = static_cast<int32_t>(lowest);
    out.highest = static_cast<int32_t>(highest);
    return true;
  }

  // Sub-pixel coordinate of a tile's pixel centre, from the triangle's first corner; exact in a float.
  static float centre_from(int32_t pixel, int32_t corner) {
    return static_cast<float>(pixel * kSubPixels + kSubPixels / 2 - corner);
  }

  static float held(float value, const Plane& plane) {
    const float above = value > plane.least ? value : plane.least;
    return above < plane.greatest ? above : plane.greatest;
  }

  // The greatest depth that the plane takes on between two points: by rounding's monotony, at a corner.
  static float nearest(const Plane& p, float x0, float x1, float y0, float y1) {
    return held((p.origin + (p.per_y > 0.0F ? y1 : y0) * p.per_y) + (p.per_x > 0.0F ? x1 : x0) * p.per_x, p);
  }

  static float least_of(F a) {
    float lanes[8];
    L::store(lanes, a);
    float least = lanes[0];
    for (size_t i = 1; i < 8; ++i)
      least = lanes[i] < least ? lanes[i] : least;
    return least;
  }

  /// `promise`: what to write where the triangle is seen. `tile_depth`: a lower bound of the tile's depth, kept up.
  static void run(const TileJob& job, const GeneralTriangle& t, uint32_t promise, float& tile_depth) {
    const Plane& plane = t.depth;
    constexpr float kReach = static_cast<float>(Pattern::kReach);
    const float x0 = centre_from(job.x, t.x[0]);
    const float y0 = centre_from(job.y, t.y[0]);
    constexpr float kWide = static_cast<float>((kTileSize - 1) * kSubPixels);
    if (!(nearest(plane, x0 - kReach, x0 + kWide + kReach, y0 - kReach, y0 + kWide + kReach) > tile_depth)) return;
    Edge edges[3];
    for (size_t e = 0; e < 3; ++e) {
      if (!set_edge(job, t, e, e == 2 ? 0 : e + 1, edges[e])) return;
    }

    // Cells that the box touches.
    const int32_t first_cell_row = t.first_row > job.y ? (t.first_row - job.y) / kCellSize : 0;
    const int32_t bottom = t.last_row - job.y < job.height - 1 ? t.last_row - job.y : job.height - 1;
    const int32_t last_cell_row = bottom / kCellSize;
    bool wrote = false;
    for (int32_t cell_row = first_cell_row; cell_row <= last_cell_row; ++cell_row) {
      // Eight cells side by side.
      I any = L::set(0);
      I all = L::set(0);
      for (const Edge& edge : edges) {
        const I steps = multiples(edge.a * kCellSize);
        const int32_t down = edge.b * kCellSize * cell_row;
        any = any | (L::set(edge.highest + down + static_cast<int32_t>(greatest_step(edge.a, edge.b, kCellSize - 1))) +
                     steps);
        all = all |
              (L::set(edge.lowest + down + static_cast<int32_t>(least_step(edge.a, edge.b, kCellSize - 1))) + steps);
      }
      const float cell_y = y0 + static_cast<float>(cell_row * kCellSize * kSubPixels);
      constexpr float kCellWide = static_cast<float>((kCellSize - 1) * kSubPixels);
      const float corner_y = plane.per_y > 0.0F ? cell_y + kCellWide + kReach : cell_y - kReach;
      const float corner_x = plane.per_x > 0.0F ? x0 + kCellWide + kReach : x0 - kReach;
      const F corner_depth =
          L::set(plane.origin + corner_y * plane.per_y) +
          (L::set(corner_x) + lane_steps(static_cast<float>(kCellSize * kSubPixels))) * L::set(plane.per_x);
      const F bound = L::min(L::max(corner_depth, L::set(plane.least)), L::set(plane.greatest));
      float* cells = job.buffers.cell_depth + cell_row * kCellsAcross;
      const I near_enough = L::greater(bound, L::load(cells));
      uint32_t touched = ~L::signs(any) & L::signs(near_enough) & 0xFFU;
      const uint32_t whole = ~L::signs(all);
      for (; touched != 0U; touched &= touched - 1U) {
        const int32_t cell = __builtin_ctz(touched);
        const bool full = (whole >> static_cast<uint32_t>(cell) & 1U) != 0U;
        cells[cell] = full ? fill_cell<true>(job, t, edges, cell, cell_row, promise)
                           : fill_cell<false>(job, t, edges, cell, cell_row, promise);
        wrote = true;
      }
    }
    if (!wrote) return;
    F least = L::load(job.buffers.cell_depth);
    for (size_t i = 1; i < kCellsAcross; ++i)
      least = L::min(least, L::load(job.buffers.cell_depth + i * kCellsAcross));
    tile_depth = least_of(least);
  }

  static I multiples(int32_t step) {
    // step * lane by additions: 32-bit products are slow or missing.
    const I one = L::set(step);
    const I two = one + one;
    const I four = two + two;
    const I number = lane_numbers();
    const I zero = L::set(0);
    const I bit0 = L::sign_mask(L::template shift_left<31>(number));
    const I bit1 = L::sign_mask(L::template shift_left<30>(number));
    const I bit2 = L::sign_mask(L::template shift_left<29>(number));
    return L::select(bit0, one, zero) + L::select(bit1, two, zero) + L::select(bit2, four, zero);
  }

  // Fills one cell; returns the least depth in it.
  template <bool kWhole>
  static float fill_cell(const TileJob& job, const GeneralTriangle& t, const Edge (&edges)[3], int32_t cell,
                         int32_t cell_row, uint32_t promise) {
    const Plane& plane = t.depth;
    const F least = L::set(plane.least);
    const F greatest = L::set(plane.greatest);
    const I word = L::set(static_cast<int32_t>(promise));
    const int32_t column = cell * kCellSize;
    const int32_t first_row = cell_row * kCellSize;
    const size_t corner = static_cast<size_t>(first_row) * kRowWords + static_cast<size_t>(column);
    const F dx = L::set(centre_from(job.x + column, t.x[0])) + lane_steps(static_cast<float>(kSubPixels));
    F across[kSamples];
    for (size_t s = 0; s < kSamples; ++s)
      across[s] = (dx + L::set(static_cast<float>(Pattern::kX[s]))) * L::set(plane.per_x);
    I edge_row[3];
    if constexpr (!kWhole) {
      for (size_t e = 0; e < 3; ++e)
        edge_row[e] = multiples(edges[e].a) + L::set(edges[e].a * column + edges[e].b * first_row);
    }
    F lowest = L::set(2.0F);
    for (int32_t j = 0; j < kCellSize; ++j) {
      const float dy = centre_from(job.y + first_row + j, t.y[0]);
      for (size_t s = 0; s < kSamples; ++s) {
        const size_t at = corner + static_cast<size_t>(j) * kRowWords + s * kTileStride;
        const float row_depth = plane.origin + (dy + static_cast<float>(Pattern::kY[s])) * plane.per_y;
        const F z = L::min(L::max(L::set(row_depth) + across[s], least), greatest);
        const F stored = L::load(job.buffers.depth + at);
        I visible = L::greater(z, stored);
        if constexpr (!kWhole) {
          I outside = edge_row[0] + L::set(edges[0].start[s]);
          outside = outside | (edge_row[1] + L::set(edges[1].start[s]));
          outside = outside | (edge_row[2] + L::set(edges[2].start[s]));
          visible = L::and_not(L::sign_mask(outside), visible);
        }
        const F kept = L::select(visible, z, stored);
        L::store(job.buffers.depth + at, kept);
        L::store(job.buffers.colour + at, L::select(visible, word, L::load(job.buffers.colour + at)));
        lowest = L::min(lowest, kept);
      }
      if constexpr (!kWhole) {
        for (size_t e = 0; e < 3; ++e)
          edge_row[e] = edge_row[e] + L::set(edges[e].b);
      }
    }
    return least_of(lowest);
  }
};

}  // namespace auslan::raster
