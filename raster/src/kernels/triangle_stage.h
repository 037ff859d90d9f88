// SPDX-License-Identifier: Apache-2.0
// Once a triangle: what cannot be seen goes, before anything is computed for its pixels; the rest goes to its tiles.
#pragma once

#include "kernel.h"

namespace auslan::raster {

template <class L>
struct TriangleStage {
  using F = typename L::F;
  using I = typename L::I;

  // What the loop over eights carries.
  struct State {
    TriangleCounts counts;
    I least_columns, greatest_columns, least_rows, greatest_rows;  ///< first in the low, last in the high halves
    uint32_t listed;  ///< small triangles that are in the lists of their tiles; the rest of those appended follow
  };
  // So many wait to be listed: few enough to stay near, enough for a loop that seldom ends.
  static constexpr uint32_t kWaiting = 256;

  // How many of eight bits are set; without an instruction for it the compiler would call a function.
  static uint32_t count(uint32_t bits) {
#if defined(__x86_64__) && !defined(__POPCNT__)
    constexpr uint64_t kOfNibble = 0x4332322132212110U;
    return static_cast<uint32_t>((kOfNibble >> (4 * (bits & 15U)) & 15U) + (kOfNibble >> (4 * (bits >> 4U)) & 15U));
#else
    return static_cast<uint32_t>(__builtin_popcount(bits));
#endif
  }

  // Eight triangles; the lanes of `wanted` are real ones with good indices.
  static void eight(const TriangleJob& job, const I (&index)[3], uint32_t wanted, size_t first, State& state) {
    I corner[3];
    F x[3], y[3];
    for (size_t c = 0; c < 3; ++c) {
      alignas(32) uint32_t number[8];
      corner[c] = index[c] + L::set(static_cast<int32_t>(job.first_vertex));
      L::store(number, corner[c]);
      L::gather_pairs(&job.points->x, number, sizeof(ScreenPoint) / sizeof(float), x[c], y[c]);
    }
    const F left = L::min(L::min(x[0], x[1]), x[2]);
    const F right = L::max(L::max(x[0], x[1]), x[2]);
    const F top = L::min(L::min(y[0], y[1]), y[2]);
    const F bottom = L::max(L::max(y[0], y[1]), y[2]);
    const uint32_t cut = wanted & L::signs(L::greater(right, L::set(0.5F * kOutside)));

    // Numbers of cut triangles mean nothing from here on, nor the area of large ones; they are not used.
    const I before = L::set(kSubPixels / 2 - 1 - job.reach);
    const I behind = L::set(job.reach - kSubPixels / 2);
    const I first_column = L::template shift_right<kSubPixelBits>(L::truncate(left) + before);
    const I last_column = L::template shift_right<kSubPixelBits>(L::truncate(right) + behind);
    const I first_row = L::template shift_right<kSubPixelBits>(L::truncate(top) + before);
    const I last_row = L::template shift_right<kSubPixelBits>(L::truncate(bottom) + behind);
    const I right_edge = L::set(job.width - 1);
    const I bottom_edge = L::set(job.height - 1);
    // A sign below is set where something is negative that must not be.
    I unseen = (last_column - first_column) | (last_row - first_row);
    unseen = unseen | last_column | last_row | (right_edge - first_column) | (bottom_edge - first_row);

    const F extent = L::set(static_cast<float>(kSmallExtent));
    const I is_small = L::greater(extent, right - left) & L::greater(extent, bottom - top);
    const uint32_t small = L::signs(is_small);
    const I area = L::dot(L::pair(L::truncate(x[1] - x[0]), L::truncate(y[0] - y[1])),
                          L::pair(L::truncate(y[2] - y[0]), L::truncate(x[2] - x[0])));
    const uint32_t negative = L::signs(area);
    const uint32_t positive = L::signs(L::set(0) - area);
    // Counter-clockwise in the world, y up, is a negative area on the screen, y down.
    const uint32_t front = job.mirrored ? positive : negative;
    const uint32_t facing = job.two_sided ? positive | negative : front;
    const uint32_t seen = wanted & ~cut & ~L::signs(unseen);
    const uint32_t kept = cut | (seen & (~small | facing));
    if (kept == 0U) return;

    // Small triangles in the order of positive area.
    const I turned = L::sign_mask(area) & is_small;
    const I second = L::select(turned, corner[2], corner[1]);
    const I third = L::select(turned, corner[1], corner[2]);
    const I zero = L::set(0);
    const I tile_left = L::template shift_right<kTileWidthBits>(L::max(first_column, zero));
    const I tile_right = L::template shift_right<kTileWidthBits>(L::min(last_column, right_edge));
    const I tile_top = L::template shift_right<kTileHeightBits>(L::max(first_row, zero));
    const I tile_bottom = L::template shift_right<kTileHeightBits>(L::min(last_row, bottom_edge));
    const I columns = L::pair(tile_left, tile_right);
    const I rows = L::pair(tile_top, tile_bottom);
    const I hidden = L::sign_mask(unseen);
    state.least_columns = L::min16(state.least_columns, L::select(hidden, L::set(0x7FFF), columns));
    state.greatest_columns = L::max16(state.greatest_columns, L::select(hidden, zero, columns));
    state.least_rows = L::min16(state.least_rows, L::select(hidden, L::set(0x7FFF), rows));
    state.greatest_rows = L::max16(state.greatest_rows, L::select(hidden, zero, rows));

    const I first_tile = L::dot(L::pair(tile_left, tile_top), L::set(1 | job.tiles_across << 16));
    const I more_columns = L::template shift_left<kTileBits>(tile_right - tile_left);
    const I more_rows = L::template shift_left<kTileBits + kTileColumnBits>(tile_bottom - tile_top);
    const I tiles = (first_tile | more_columns) | more_rows;
    const uint32_t ordinary = job.small != nullptr ? small & ~cut : 0U;
    if ((kept & ~ordinary) != 0U) {
      const I number[4] = {corner[0], second, third, tiles};
      return one_by_one(job, number, Kinds{kept, ordinary, small, cut}, first, state);
    }
    const I word = tiles | L::set(static_cast<int32_t>(kGouraudColour));
    SmallTriangle* out = job.small + job.first_small + state.counts.appended;
    L::store_kept(reinterpret_cast<uint32_t*>(out), kept, corner[0], second, third, word);
    state.counts.appended += count(kept);
  }

  struct Kinds {
    uint32_t kept, ordinary, small, cut;  ///< bit i is lane i
  };

  // Eight triangles of which not all are the stage's own to append. `number`: corners and tiles.
  [[gnu::noinline]] static void one_by_one(const TriangleJob& job, const I (&number)[4], const Kinds& kinds,
                                           size_t first, State& state) {
    alignas(32) uint32_t lanes[4][8];
    for (size_t k = 0; k < 4; ++k)
      L::store(lanes[k], number[k]);
    for (uint32_t left_over = kinds.kept; left_over != 0U; left_over &= left_over - 1U) {
      const auto i = static_cast<size_t>(__builtin_ctz(left_over));
      if ((kinds.ordinary >> i & 1U) != 0U) {
        job.small[job.first_small + state.counts.appended++] =
            SmallTriangle{{lanes[0][i], lanes[1][i], lanes[2][i]}, lanes[3][i] | kGouraudColour};
        continue;
      }
      list(job, state);
      const Route route = (kinds.cut >> i & 1U) != 0U     ? Route::kCut
                          : (kinds.small >> i & 1U) != 0U ? Route::kSmall
                                                          : Route::kLarge;
      const Survivor survivor{
          {lanes[0][i], lanes[1][i], lanes[2][i]}, static_cast<uint32_t>(first + i), route, lanes[3][i]};
      job.sink.take(job.sink.context, survivor);
    }
  }

  // Puts what waits into the lists of its tiles.
  [[gnu::noinline]] static void list(const TriangleJob& job, State& state) {
    const uint32_t end = state.counts.appended;
    if (state.listed == end) return;
    const SmallTriangle* small = job.small + job.first_small;
    uint32_t** tails = job.tails;
    const auto append = [&job, tails](size_t tile, uint32_t number) {
      uint32_t* tail = tails[tile];
      if (reinterpret_cast<uintptr_t>(tail) % sizeof(EntryBlock) == 0) tail = job.sink.extend(job.sink.context, tile);
      *tail = number;
      tails[tile] = tail + 1;
    };
    for (uint32_t i = state.listed; i < end; ++i) {
      const uint32_t word = small[i].word;
      const uint32_t number = job.first_small + i;
      const uint32_t tile = word & kTileMask;
      append(tile, number);
      const uint32_t more = (word & ~kGouraudColour) >> kTileBits;
      if (more == 0U) continue;
      const uint32_t across = more & kTileColumnMask;
      for (uint32_t k = 1; k <= across; ++k)
        append(tile + k, number);
      uint32_t row = tile;
      for (uint32_t rows = more >> kTileColumnBits; rows != 0U; --rows) {
        row += static_cast<uint32_t>(job.tiles_across);
        for (uint32_t k = 0; k <= across; ++k)
          append(row + k, number);
      }
    }
    state.listed = end;
  }

  // The least of the low halves and the greatest of the high halves.
  static void bounds(I least, I greatest, uint32_t& first, uint32_t& last) {
    uint32_t low[8];
    uint32_t high[8];
    L::store(low, least);
    L::store(high, greatest);
    for (size_t i = 0; i < 8; ++i) {
      first = (low[i] & 0xFFFFU) < first ? low[i] & 0xFFFFU : first;
      last = high[i] >> 16U > last ? high[i] >> 16U : last;
    }
  }

  // Eight triangles of which the first `real` are some. `limit`: the number of vertices with its sign turned round.
  static void some(const TriangleJob& job, const uint32_t* indices, size_t real, size_t first, I limit, State& state) {
    I index[3];
    L::load_triples(indices, index[0], index[1], index[2]);
    // Unsigned comparison by turning the sign bit round.
    I good = L::set(-1);
    for (const I& i : index)
      good = good & L::greater(limit, i ^ L::set(static_cast<int32_t>(0x80000000U)));
    const uint32_t in_range = L::signs(good);
    const uint32_t wanted = in_range & ((1U << real) - 1U);
    if (in_range != 0xFFU) {
      for (I& i : index)
        i = L::select(good, i, L::set(0));
      state.counts.rejected += real - count(wanted);
    }
    if (wanted != 0U) eight(job, index, wanted, first, state);
  }

  static TriangleCounts run(const TriangleJob& job) {
    State state;
    state.least_columns = L::set(0x7FFF);
    state.least_rows = L::set(0x7FFF);
    state.greatest_columns = L::set(0);
    state.greatest_rows = L::set(0);
    state.listed = 0;
    const I limit = L::set(static_cast<int32_t>(job.vertex_count ^ 0x80000000U));
    size_t first = job.begin;
    for (; first + 8 <= job.end; first += 8) {
      some(job, job.indices + 3 * first, 8, first, limit, state);
      if (state.counts.appended - state.listed >= kWaiting) list(job, state);
    }
    if (first < job.end) {
      uint32_t rest[24] = {};
      for (size_t i = 0; i < 3 * (job.end - first); ++i)
        rest[i] = job.indices[3 * first + i];
      some(job, rest, job.end - first, first, limit, state);
    }
    list(job, state);
    bounds(state.least_columns, state.greatest_columns, state.counts.first_tile_column, state.counts.last_tile_column);
    bounds(state.least_rows, state.greatest_rows, state.counts.first_tile_row, state.counts.last_tile_row);
    return state.counts;
  }
};

}  // namespace auslan::raster
