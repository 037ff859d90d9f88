// SPDX-License-Identifier: Apache-2.0
// The long path: a triangle of any size in one tile, over cells of 8 x 8 pixels. Only depth and a promise of the colour
// are written (kGeneralTriangle); what lies behind everything that a cell already shows is left out (hierarchical
// depth, Greene, Kass and Miller 1993).
#pragma once

#include "resolve.h"

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

  static int64_t least_step(int32_t a, int32_t b, int32_t across, int32_t down) {
    return (a < 0 ? int64_t{a} * across : 0) + (b < 0 ? int64_t{b} * down : 0);
  }
  static int64_t greatest_step(int32_t a, int32_t b, int32_t across, int32_t down) {
    return (a > 0 ? int64_t{a} * across : 0) + (b > 0 ? int64_t{b} * down : 0);
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
    if (highest + greatest_step(out.a, out.b, kTileWidth - 1, kTileHeight - 1) < 0) return false;
    if (lowest + least_step(out.a, out.b, kTileWidth - 1, kTileHeight - 1) >= 0) {
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

  // The same of eight pixels from `pixel` on, across or down.
  static F eight_from(int32_t pixel, int32_t corner) {
    return L::set(centre_from(pixel, corner)) + lane_steps(static_cast<float>(kSubPixels));
  }

  // Eight pixels side by side have kSamples vectors of samples. Of each lane: its pixel, in the first vector and
  // altogether, and where its sample lies, in sub-pixels.
  struct alignas(32) SampleLanes {
    float pixel[kSamples][8] = {};
    uint32_t number[kSamples][8] = {};
    float x[8] = {}, y[8] = {};
    static constexpr SampleLanes make() {
      SampleLanes t;
      for (size_t i = 0; i < 8 * kSamples; ++i) {
        t.number[i / 8][i % 8] = static_cast<uint32_t>(i / kSamples);
        t.pixel[i / 8][i % 8] = static_cast<float>(i / kSamples * kSubPixels);
      }
      for (size_t i = 0; i < 8; ++i) {
        t.x[i] = static_cast<float>(Pattern::kX[i % kSamples]);
        t.y[i] = static_cast<float>(Pattern::kY[i % kSamples]);
      }
      return t;
    }
    static const SampleLanes kLanes;
  };

  // Depth at a sample is its row's number of these plus its column's.
  struct Depths {
    alignas(32) float row[kCellSize][8];
    F across[kSamples];
    Depths(const TileJob& job, const GeneralTriangle& t, int32_t first_row) {
      const F origin = L::set(t.depth.origin);
      const F per_y = L::set(t.depth.per_y);
      for (int32_t j = 0; j < kCellSize; ++j) {
        const F dy = L::set(centre_from(job.y + first_row + j, t.y[0]));
        L::store(row[j], origin + (dy + L::load(SampleLanes::kLanes.y)) * per_y);
      }
    }
    void at_column(const TileJob& job, const GeneralTriangle& t, int32_t column) {
      const F dx = L::set(centre_from(job.x + column, t.x[0]));
      for (size_t v = 0; v < kSamples; ++v)
        across[v] =
            ((dx + L::load(SampleLanes::kLanes.pixel[v])) + L::load(SampleLanes::kLanes.x)) * L::set(t.depth.per_x);
    }
  };

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

  /// `word`: names the triangle. `tile_depth`: a lower bound of the tile's depth, kept up.
  static void run(const TileJob& job, const GeneralTriangle& t, uint32_t word, float& tile_depth) {
    const uint32_t promise = promise_of(t, word);
    const Plane& plane = t.depth;
    constexpr float kReach = static_cast<float>(Pattern::kReach);
    const float x0 = centre_from(job.x, t.x[0]);
    const float y0 = centre_from(job.y, t.y[0]);
    constexpr float kWide = static_cast<float>((kTileWidth - 1) * kSubPixels);
    constexpr float kTall = static_cast<float>((kTileHeight - 1) * kSubPixels);
    if (!(nearest(plane, x0 - kReach, x0 + kWide + kReach, y0 - kReach, y0 + kTall + kReach) > tile_depth)) return;
    Edge edges[3];
    for (size_t e = 0; e < 3; ++e) {
      if (!set_edge(job, t, e, e == 2 ? 0 : e + 1, edges[e])) return;
    }

    // Cells that the box touches.
    const int32_t first_cell_row = t.first_row > job.y ? (t.first_row - job.y) / kCellSize : 0;
    const int32_t bottom = t.last_row - job.y < job.height - 1 ? t.last_row - job.y : job.height - 1;
    const int32_t last_cell_row = bottom / kCellSize;
    I any_steps[3], all_steps[3], down_steps[3];
    for (size_t e = 0; e < 3; ++e) {
      const Edge& edge = edges[e];
      const I steps = multiples(edge.a * kCellSize);
      const int32_t down = edge.b * kCellSize * first_cell_row;
      any_steps[e] = steps + L::set(edge.highest + down +
                                    static_cast<int32_t>(greatest_step(edge.a, edge.b, kCellSize - 1, kCellSize - 1)));
      all_steps[e] = steps + L::set(edge.lowest + down +
                                    static_cast<int32_t>(least_step(edge.a, edge.b, kCellSize - 1, kCellSize - 1)));
      down_steps[e] = L::set(edge.b * kCellSize);
    }
    bool wrote = false;
    for (int32_t cell_row = first_cell_row; cell_row <= last_cell_row; ++cell_row) {
      // Eight cells side by side.
      const I any = any_steps[0] | any_steps[1] | any_steps[2];
      const I all = all_steps[0] | all_steps[1] | all_steps[2];
      for (size_t e = 0; e < 3; ++e) {
        any_steps[e] = any_steps[e] + down_steps[e];
        all_steps[e] = all_steps[e] + down_steps[e];
      }
      const float cell_y = y0 + static_cast<float>(cell_row * kCellSize * kSubPixels);
      constexpr float kCellWide = static_cast<float>((kCellSize - 1) * kSubPixels);
      const F cell_x = L::set(x0) + lane_steps(static_cast<float>(kCellSize * kSubPixels));
      const auto corner_depth = [&](bool nearest_corner) {
        const float corner_y = (plane.per_y > 0.0F) == nearest_corner ? cell_y + kCellWide + kReach : cell_y - kReach;
        const float corner_x = (plane.per_x > 0.0F) == nearest_corner ? kCellWide + kReach : -kReach;
        return L::set(plane.origin + corner_y * plane.per_y) + (cell_x + L::set(corner_x)) * L::set(plane.per_x);
      };
      const F nearest_depth = corner_depth(true);
      const F farthest_depth = corner_depth(false);
      const F bound = L::min(L::max(nearest_depth, L::set(plane.least)), L::set(plane.greatest));
      const uint32_t in_range = L::signs(L::at_least(L::set(plane.greatest), nearest_depth) &
                                         L::at_least(farthest_depth, L::set(plane.least)));
      float* least = job.buffers.cell_least + cell_row * kCellsAcross;
      float* greatest = job.buffers.cell_greatest + cell_row * kCellsAcross;
      const I near_enough = L::greater(bound, L::load(least));
      uint32_t touched = ~L::signs(any) & L::signs(near_enough) & 0xFFU;
      const uint32_t whole = ~L::signs(all);
      if (touched == 0U) continue;
      wrote = true;
      // Cells that this triangle fills altogether, in front of all that they show.
      const uint32_t covered = touched & whole & in_range & L::signs(L::greater(farthest_depth, L::load(greatest)));
      if (covered != 0U) {
        const I mask = lanes_of(covered);
        uint32_t* owner = job.buffers.cell_owner + cell_row * kCellsAcross;
        const bool stays = word != kScratchTriangle;  // as long as the tile is in hand
        L::store(owner, L::select(mask, L::set(stays ? static_cast<int32_t>(word) : 0), L::load(owner)));
        if (!stays) write_cells(job, t, covered, cell_row, promise);
        L::store(least, L::select(mask, farthest_depth, L::load(least)));
        L::store(greatest, L::select(mask, bound, L::load(greatest)));
        touched &= ~covered;
        if (touched == 0U) continue;
      }
      L::store(greatest, L::select(lanes_of(touched), L::max(bound, L::load(greatest)), L::load(greatest)));
      for (; touched != 0U; touched &= touched - 1U) {
        const int32_t cell = __builtin_ctz(touched);
        const uint32_t bit = 1U << static_cast<uint32_t>(cell);
        release(job, cell, cell_row);
        if ((whole & in_range & bit) != 0U) {
          least[cell] = fill_whole_cell<false>(job, t, cell, cell_row, promise);
        } else if ((whole & bit) != 0U) {
          least[cell] = fill_whole_cell<true>(job, t, cell, cell_row, promise);
        } else {
          least[cell] = fill_crossed_cell(job, t, edges, cell, cell_row);
        }
      }
    }
    if (!wrote) return;
    F least = L::load(job.buffers.cell_least);
    for (size_t i = 1; i < kCellsDown; ++i)
      least = L::min(least, L::load(job.buffers.cell_least + i * kCellsAcross));
    tile_depth = least_of(least);
  }

  // What is written where a triangle is seen.
  static uint32_t promise_of(const GeneralTriangle& t, uint32_t word) {
    return t.colour != kGouraudColour ? t.colour : word;
  }

  // Brings a cell's memory up to date.
  static void release(const TileJob& job, int32_t cell, int32_t cell_row) {
    uint32_t& owner = job.buffers.cell_owner[cell_row * kCellsAcross + cell];
    if (owner == 0U) return;
    const GeneralTriangle& t = Resolve<L, kSamples>::promised(job, owner);
    write_cells(job, t, 1U << static_cast<uint32_t>(cell), cell_row, promise_of(t, owner));
    owner = 0;
  }
  static void release_all(const TileJob& job) {
    for (int32_t row = 0; row < kCellsDown; ++row) {
      for (int32_t cell = 0; cell < kCellsAcross; ++cell)
        release(job, cell, row);
    }
  }

  // A mask of the lanes whose bits are set.
  static I lanes_of(uint32_t bits) {
    static constexpr uint32_t kBits[8] = {1, 2, 4, 8, 16, 32, 64, 128};
    const I bit = L::load(kBits);
    return L::equal(L::set(static_cast<int32_t>(bits)) & bit, bit);
  }

  static I multiples(int32_t step) { return multiples(step, lane_numbers()); }
  static I multiples(int32_t step, I number) {
    // step * number below 8 by additions: 32-bit products are slow or missing.
    const I one = L::set(step);
    const I two = one + one;
    const I four = two + two;
    const I zero = L::set(0);
    const I bit0 = L::sign_mask(L::template shift_left<31>(number));
    const I bit1 = L::sign_mask(L::template shift_left<30>(number));
    const I bit2 = L::sign_mask(L::template shift_left<29>(number));
    return L::select(bit0, one, zero) + L::select(bit1, two, zero) + L::select(bit2, four, zero);
  }

  // The triangle's colours along the rows of one cell.
  struct CellColours {
    using Shader = typename Resolve<L, kSamples>::Shader;
    const GeneralTriangle& t;
    const I flat;
    const bool gouraud;
    const int32_t column, first_row;
    const F dx;
    F across[3];
    alignas(32) float rows[3][kCellSize];

    CellColours(const GeneralTriangle& triangle, int32_t cell_column, int32_t cell_first_row, F from_corner, F dy)
        : t(triangle),
          flat(L::set(static_cast<int32_t>(triangle.colour))),
          gouraud(triangle.colour == kGouraudColour),
          column(cell_column),
          first_row(cell_first_row),
          dx(from_corner) {
      if (!gouraud || t.perspective) return;
      for (size_t c = 0; c < 3; ++c) {
        across[c] = dx * L::set(t.level[c].per_x);
        L::store(rows[c], L::set(t.level[c].origin) + dy * L::set(t.level[c].per_y));
      }
    }
    I at(size_t j) const {
      if (!gouraud) return flat;
      if (t.perspective) return Shader(t, first_row + static_cast<int32_t>(j)).at(column);
      I channel[3];
      for (size_t c = 0; c < 3; ++c) {
        const F value =
            L::min(L::max(L::spread(&rows[c][j]) + across[c], L::set(t.level[c].least)), L::set(t.level[c].greatest));
        channel[c] = L::truncate(value + L::set(0.5F));
      }
      return L::template shift_left<16>(channel[0]) | L::template shift_left<8>(channel[1]) | channel[2];
    }
  };

  // A cell that an edge crosses; colours are computed at once, for promises of several triangles in one pixel or in
  // eight would be kept one by one. Returns a lower bound of the depth in it.
  static float fill_crossed_cell(const TileJob& job, const GeneralTriangle& t, const Edge (&edges)[3], int32_t cell,
                                 int32_t cell_row) {
    const Plane plane = t.depth;
    const int32_t column = cell * kCellSize;
    const int32_t first_row = cell_row * kCellSize;
    Depths depths(job, t, first_row);
    depths.at_column(job, t, column);
    const F least_before = L::spread(job.buffers.cell_least + cell_row * kCellsAcross + cell);
    const CellColours colours(t, job.x + column, job.y + first_row, eight_from(job.x + column, t.x[0]),
                              eight_from(job.y + first_row, t.y[0]));
    I edge[3][kSamples], edge_down[3], edge_step[3];
    for (size_t e = 0; e < 3; ++e) {
      alignas(32) int32_t start[8];
      for (size_t i = 0; i < 8; ++i)
        start[i] = edges[e].start[i % kSamples];
      const I corner = L::load(start) + L::set(edges[e].a * column + edges[e].b * first_row);
      for (size_t v = 0; v < kSamples; ++v)
        edge[e][v] = multiples(edges[e].a, L::load(SampleLanes::kLanes.number[v])) + corner;
      edge_down[e] = L::set(0);
      edge_step[e] = L::set(edges[e].b);
    }
    const F least = L::set(plane.least);
    const F greatest = L::set(plane.greatest);
    const size_t corner = static_cast<size_t>(first_row) * kRowWords + static_cast<size_t>(column) * kSamples;
    float* depth = job.buffers.depth + corner;
    uint32_t* colour = job.buffers.colour + corner;
    F lowest = L::set(2.0F);
    for (size_t j = 0; j < kCellSize; ++j, depth += kRowWords, colour += kRowWords) {
      I shade[kSamples]{};
      bool shaded = false;
      const F row_depth = L::load(depths.row[j]);
      for (size_t v = 0; v < kSamples; ++v) {
        const I outside = (edge[0][v] + edge_down[0]) | (edge[1][v] + edge_down[1]) | (edge[2][v] + edge_down[2]);
        if (L::signs(outside) == 0xFFU) {
          lowest = L::min(lowest, least_before);
          continue;
        }
        const F z = L::min(L::max(row_depth + depths.across[v], least), greatest);
        const F stored = L::load(depth + 8 * v);
        const I visible = L::and_not(L::sign_mask(outside), L::greater(z, stored));
        const F kept = L::select(visible, z, stored);
        lowest = L::min(lowest, kept);
        if (L::signs(visible) == 0U) continue;
        if (!shaded) Resolve<L, kSamples>::expand(colours.at(j), shade);
        shaded = true;
        L::store(depth + 8 * v, kept);
        uint32_t* words = colour + 8 * v;
        L::store(words, L::select(visible, shade[v], L::load(words)));
      }
      for (size_t e = 0; e < 3; ++e)
        edge_down[e] = edge_down[e] + edge_step[e];
    }
    return least_of(lowest);
  }

  // Cells of one row that are one triangle's altogether: neither what they hold nor the plane's range needs a look.
  static void write_cells(const TileJob& job, const GeneralTriangle& t, uint32_t cells, int32_t cell_row,
                          uint32_t promise) {
    const int32_t first_row = cell_row * kCellSize;
    Depths depths(job, t, first_row);
    const I word = L::set(static_cast<int32_t>(promise));
    for (; cells != 0U; cells &= cells - 1U) {
      const int32_t column = __builtin_ctz(cells) * kCellSize;
      depths.at_column(job, t, column);
      const size_t corner = static_cast<size_t>(first_row) * kRowWords + static_cast<size_t>(column) * kSamples;
      float* depth = job.buffers.depth + corner;
      uint32_t* colour = job.buffers.colour + corner;
      for (size_t j = 0; j < kCellSize; ++j, depth += kRowWords, colour += kRowWords) {
        const F row_depth = L::load(depths.row[j]);
        for (size_t v = 0; v < kSamples; ++v) {
          L::store(depth + 8 * v, row_depth + depths.across[v]);
          L::store(colour + 8 * v, word);
        }
      }
    }
  }

  // A cell that is all inside. kHeld: the plane may leave the range of its corners here, if only by rounding. Returns
  // the least depth in it.
  template <bool kHeld>
  static float fill_whole_cell(const TileJob& job, const GeneralTriangle& t, int32_t cell, int32_t cell_row,
                               uint32_t promise) {
    const Plane plane = t.depth;
    const int32_t column = cell * kCellSize;
    const int32_t first_row = cell_row * kCellSize;
    Depths depths(job, t, first_row);
    depths.at_column(job, t, column);
    const F least = L::set(plane.least);
    const F greatest = L::set(plane.greatest);
    const I word = L::set(static_cast<int32_t>(promise));
    const size_t corner = static_cast<size_t>(first_row) * kRowWords + static_cast<size_t>(column) * kSamples;
    float* depth = job.buffers.depth + corner;
    uint32_t* colour = job.buffers.colour + corner;
    F lowest = L::set(2.0F);
    for (size_t j = 0; j < kCellSize; ++j, depth += kRowWords, colour += kRowWords) {
      const F row_depth = L::load(depths.row[j]);
      for (size_t v = 0; v < kSamples; ++v) {
        F z = row_depth + depths.across[v];
        if constexpr (kHeld) z = L::min(L::max(z, least), greatest);
        const F stored = L::load(depth + 8 * v);
        const I visible = L::greater(z, stored);
        const F kept = L::max(z, stored);
        L::store(depth + 8 * v, kept);
        L::store(colour + 8 * v, L::select(visible, word, L::load(colour + 8 * v)));
        lowest = L::min(lowest, kept);
      }
    }
    return least_of(lowest);
  }
};

template <class L, size_t kSamples>
inline constexpr typename FillGeneral<L, kSamples>::SampleLanes FillGeneral<L, kSamples>::SampleLanes::kLanes = make();

}  // namespace auslan::raster
