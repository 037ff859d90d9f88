// SPDX-License-Identifier: Apache-2.0
// Pixels of a small triangle, where each has one sample, from the corner of its box on: in blocks of 4 x 2 where it is
// at most four pixels wide, else in rows of 8 that stand below each other in columns. Where a register holds four
// lanes, all but those of triangles from 5 to 8 wide are rows of 4.
#pragma once

#include "set_up.h"

namespace auslan::raster {

/// How eight lanes lie on the screen.
template <bool kTall>
struct alignas(32) BlockShape {
  static constexpr int32_t kWidth = kTall ? 4 : 8;
  static constexpr int32_t kHeight = kTall ? 2 : 1;
  uint32_t lanes[8] = {};  ///< i and j of each lane as SmallGroup::ab has a and b
  float across[8] = {}, down[8] = {};
  uint32_t both_across[8] = {}, both_down[8] = {};  ///< i, and j, in both halves

  static constexpr BlockShape make() {
    BlockShape t;
    for (uint32_t lane = 0; lane < 8; ++lane) {
      const uint32_t i = lane % uint32_t{kWidth};
      const uint32_t j = lane / uint32_t{kWidth};
      t.lanes[lane] = i | j << 16U;
      t.across[lane] = static_cast<float>(i);
      t.down[lane] = static_cast<float>(j);
      t.both_across[lane] = i | i << 16U;
      t.both_down[lane] = j | j << 16U;
    }
    return t;
  }
  static const BlockShape kShape;
};
template <bool kTall>
inline constexpr BlockShape<kTall> BlockShape<kTall>::kShape = make();

template <class L>
struct FillSmall {
  using F = typename L::F;
  using I = typename L::I;
  using Q = decltype(L::template sample_lanes<1>());
  using Group = SmallGroup<1>;
  static constexpr size_t kRowWords = kTileStride;

  // Fixed-point colours of eight pixels, as SmallGroup has them.
  struct Colours {
    I blue_red, green;
    friend Colours operator+(const Colours& a, const Colours& b) {
      return {L::add16(a.blue_red, b.blue_red), L::add16(a.green, b.green)};
    }
    friend Colours operator*(const Colours& a, I halves) {
      return {L::multiply16(a.blue_red, halves), L::multiply16(a.green, halves)};
    }
  };
  static Colours spread(const typename Group::Colours& colours, size_t k) {
    return {L::spread(&colours.blue_red[k]), L::spread(&colours.green[k])};
  }
  static bool is_gouraud(const Group& g, size_t k) { return (g.word[k] & kGouraudColour) != 0U; }
  static Colours flat_colours(uint32_t word) {
    // Red has the bit above it too: kStandInColour is to come out as it is.
    return {L::set(static_cast<int32_t>((word & 0xFFU) << kLevelBits | (word >> 16U & 0x1FFU) << (16 + kLevelBits))),
            L::set(static_cast<int32_t>((word >> 8U & 0xFFU) << (kLevelBits + 1)))};
  }

  // Eight pixels: the place, and what changes from block to block of a triangle.
  struct Block {
    I edge[3];
    Colours colour;
    float* depths;
    uint32_t* pixels;

    void move(const I (&edge_step)[3], const Colours& colour_step, size_t words) {
      for (size_t e = 0; e < 3; ++e)
        edge[e] = edge[e] + edge_step[e];
      colour = colour + colour_step;
      depths += words;
      pixels += words;
    }
    I shade() const { return L::template shift_right16<kLevelBits>(colour.blue_red) | (colour.green & L::set(0xFF00)); }
  };

  template <bool kTall, class T>
  static auto load(const T* p) {
    if constexpr (kTall) {
      return L::load_2x4(p, kRowWords);
    } else {
      return L::load(p);
    }
  }
  template <bool kTall, class T, class V>
  static void store(T* p, const V& v) {
    if constexpr (kTall) {
      L::store_2x4(p, kRowWords, v);
    } else {
      L::store(p, v);
    }
  }

  // `depth`: at the pixels' centres.
  template <bool kTall>
  static void fill(const Block& block, F depth) {
    F stored = load<kTall>(block.depths);
    const I visible = L::keep_greater(block.edge[0] | block.edge[1] | block.edge[2], depth, stored);
    store<kTall>(block.depths, stored);
    store<kTall>(block.pixels, L::select(visible, block.shade(), load<kTall>(block.pixels)));
  }

  // The block at the triangle's corner.
  template <bool kTall>
  static Block first_block(const TileBuffers& buffers, const Group& g, size_t k) {
    using Shape = BlockShape<kTall>;
    const I lanes = L::load(Shape::kShape.lanes);
    Block block;
    for (size_t e = 0; e < 3; ++e)
      block.edge[e] = L::spread(&g.start[e][k]) + L::dot(L::spread(&g.ab[e][k]), lanes);
    if (is_gouraud(g, k)) {
      block.colour = spread(g.colour, k) + spread(g.colour_x, k) * L::load(Shape::kShape.both_across);
      if constexpr (kTall && L::kLanes == 8)
        block.colour = block.colour + spread(g.colour_y, k) * L::load(Shape::kShape.both_down);
    } else {
      block.colour = flat_colours(g.word[k]);
    }
    block.depths = buffers.depth + g.place[k];
    block.pixels = buffers.colour + g.place[k];
    return block;
  }
  template <int32_t kRows>
  static void steps_down(const Group& g, size_t k, I (&edge)[3], Colours& colour) {
    for (size_t e = 0; e < 3; ++e)
      edge[e] = L::dot(L::spread(&g.ab[e][k]), L::set(kRows << 16));
    colour = Colours{L::set(0), L::set(0)};
    if (!is_gouraud(g, k)) return;
    colour = spread(g.colour_y, k);
    if constexpr (kRows == 2) colour = colour + colour;
  }

  // Up to four pixels wide: blocks of 4 x 2.
  static void fill_narrow(const TileBuffers& buffers, const Group& g, size_t k) {
    using Shape = BlockShape<true>;
    Block block = first_block<true>(buffers, g, k);
    const F origin = L::spread(&g.depth[k]);
    const F depth_down = L::spread(&g.depth_y[k]);
    const F depth_across = (L::spread(&g.across[k]) + L::load(Shape::kShape.across)) * L::spread(&g.depth_x[k]);
    F down = L::spread(&g.down[k]) + L::load(Shape::kShape.down);
    fill<true>(block, (origin + down * depth_down) + depth_across);
    int32_t rows = g.height[k] - 2;
    if (rows <= 0) return;
    I edge_down[3];
    Colours colour_down;
    steps_down<2>(g, k, edge_down, colour_down);
    for (; rows > 0; rows -= 2) {
      block.move(edge_down, colour_down, 2 * kRowWords);
      down = down + L::set(2.0F);
      fill<true>(block, (origin + down * depth_down) + depth_across);
    }
  }

  // The same in rows of 4, one below the other, for lanes that are no wider: no row too many, and half the registers.
  static void fill_narrow_rows(const TileBuffers& buffers, const Group& g, size_t k) {
    using Row = FillSmall<Q>;
    using QF = typename Q::F;
    auto row = Row::template first_block<true>(buffers, g, k);
    const QF origin = Q::spread(&g.depth[k]);
    const QF depth_down = Q::spread(&g.depth_y[k]);
    const QF depth_across =
        (Q::spread(&g.across[k]) + Q::load(BlockShape<true>::kShape.across)) * Q::spread(&g.depth_x[k]);
    QF down = Q::spread(&g.down[k]);
    typename Q::I edge_down[3];
    typename Row::Colours colour_down;
    Row::template steps_down<1>(g, k, edge_down, colour_down);
    for (int32_t rows = g.height[k];;) {
      Row::template fill<false>(row, (origin + down * depth_down) + depth_across);
      if (--rows <= 0) return;
      row.move(edge_down, colour_down, kRowWords);
      down = down + Q::set(1.0F);
    }
  }

  // Wider ones: rows of 8 that stand below each other in columns.
  struct RowDepths {
    alignas(32) float depth[kTileHeight + 8];  ///< of each row, at the anchor's column
    RowDepths(const Group& g, size_t k) {
      static constexpr float kNumbers[8] = {0, 1, 2, 3, 4, 5, 6, 7};
      const F origin = L::spread(&g.depth[k]);
      const F depth_down = L::spread(&g.depth_y[k]);
      F down = L::spread(&g.down[k]) + L::load(kNumbers);
      for (int32_t row = 0; row < g.height[k]; row += 8) {
        L::store(depth + row, origin + down * depth_down);
        down = down + L::set(8.0F);
      }
    }
  };
  static F depth_across(const Group& g, size_t k) {
    return L::spread(&g.across[k]) + L::load(BlockShape<false>::kShape.across);
  }

  struct Steps {
    const I (&edge)[3];
    const Colours& colour;
  };
  // With registers enough, two rows at a time: below the triangle's last one the edges shut everything out.
  static void fill_rows(Block block, const float* depth, int32_t rows, F across, const Steps& step) {
    constexpr ptrdiff_t kAtOnce = L::kRowsAtOnce;
    for (const float* end = depth + rows;;) {
      fill<false>(block, L::spread(depth) + across);
      if constexpr (kAtOnce == 2) {
        block.move(step.edge, step.colour, kRowWords);
        fill<false>(block, L::spread(depth + 1) + across);
      }
      depth += kAtOnce;
      if (depth >= end) return;
      block.move(step.edge, step.colour, kRowWords);
    }
  }

  [[gnu::noinline]] static void fill_medium(const TileBuffers& buffers, const Group& g, size_t k) {
    Block block = first_block<false>(buffers, g, k);
    const RowDepths row(g, k);
    const F across = depth_across(g, k) * L::spread(&g.depth_x[k]);
    I edge_down[3];
    Colours colour_down;
    steps_down<1>(g, k, edge_down, colour_down);
    fill_rows(block, row.depth, g.height[k], across, {edge_down, colour_down});
  }

  // Columns of a wide triangle, as wide as a row's lanes.
  static constexpr int32_t kColumnWidth = static_cast<int32_t>(Q::kLanes);

  // Of as many columns side by side as there are lanes the rows that may hold something. They follow each other, as
  // each edge shuts out what lies above or below a row. Found by division: a row too many on either side costs a little
  // time and no more.
  struct ColumnRows {
    alignas(32) int32_t first[Q::kLanes];
    alignas(32) int32_t count[Q::kLanes];
    using QF = typename Q::F;
    using QI = typename Q::I;
    ColumnRows(const Group& g, size_t k, int32_t first_column) {
      static constexpr uint32_t kNumbers[8] = {0, 1, 2, 3, 4, 5, 6, 7};
      const QI columns = Q::multiply16(Q::load(kNumbers), Q::set(kColumnWidth)) + Q::set(first_column);
      const QF zero = Q::set(0.0F);
      const QF bottom = Q::set(static_cast<float>(g.height[k] - 1));
      QF least = zero;
      QF greatest = bottom;
      for (size_t e = 0; e < 3; ++e) {
        // The edge is highest at the last pixel of a row where a is positive. Between whole numbers above and below
        // zero lies none.
        const QI ab = Q::spread(&g.ab[e][k]);
        const QI highest = Q::spread(&g.start[e][k]) +
                           (Q::dot(ab, columns) + Q::dot(Q::max16(ab, Q::set(0)), Q::set(kColumnWidth - 1)));
        const QF b = Q::to_float(Q::template shift_right<16>(ab));
        const QF crossing = (Q::to_float(highest) + Q::set(0.5F)) / (zero - b);
        const QI rises = Q::greater(b, zero);
        least = Q::max(least, Q::select(rises, crossing, zero));
        greatest = Q::min(greatest, Q::select(rises, bottom, crossing));
      }
      const QF slack = Q::set(1.0F / 64.0F);
      const QI first_row = Q::truncate(Q::min(least, bottom + Q::set(1.0F)) + (Q::set(1.0F) - slack));
      const QI last_row = Q::truncate(Q::max(greatest, Q::set(-2.0F)) + slack);
      Q::store(first, first_row);
      Q::store(count, (last_row - first_row) + Q::set(1));
    }
  };

  [[gnu::noinline]] static void fill_wide(const TileBuffers& buffers, const Group& g, size_t k) {
    using Row = FillSmall<Q>;
    const auto corner = Row::template first_block<false>(buffers, g, k);
    const RowDepths row(g, k);
    const auto depth_x = Q::spread(&g.depth_x[k]);
    auto across = Row::depth_across(g, k);
    typename Q::I edge_down[3];
    typename Row::Colours colour_down;
    Row::template steps_down<1>(g, k, edge_down, colour_down);
    typename Row::Colours colour_across{Q::set(0), Q::set(0)};
    if (is_gouraud(g, k)) colour_across = Row::spread(g.colour_x, k);
    ColumnRows rows(g, k, 0);
    const int32_t columns = (g.width[k] + kColumnWidth - 1) / kColumnWidth;
    for (int32_t c = 0; c < columns; ++c, across = across + Q::set(static_cast<float>(kColumnWidth))) {
      // All columns of a tile fit where lanes are eight.
      constexpr auto kLanes = static_cast<int32_t>(Q::kLanes);
      int32_t lane = c;
      if constexpr (kLanes * kColumnWidth < kTileWidth) {
        lane = c % kLanes;
        if (c != 0 && lane == 0) rows = ColumnRows(g, k, c * kColumnWidth);
      }
      if (rows.count[lane] <= 0) continue;
      const int32_t column = c * kColumnWidth;
      const int32_t first = rows.first[lane];
      auto block = corner;
      const auto from_corner = Q::set(column | first << 16);
      for (size_t e = 0; e < 3; ++e)
        block.edge[e] = block.edge[e] + Q::dot(Q::spread(&g.ab[e][k]), from_corner);
      block.colour =
          (block.colour + colour_across * Q::set(column | column << 16)) + colour_down * Q::set(first | first << 16);
      const size_t place = static_cast<size_t>(first) * kRowWords + static_cast<size_t>(column);
      block.depths += place;
      block.pixels += place;
      const auto depth_here = across * depth_x;
      Row::fill_rows(block, row.depth + first, rows.count[lane], depth_here, {edge_down, colour_down});
    }
  }

  static void run(const TileBuffers& buffers, const Group& g, size_t k) {
    const int32_t width = g.width[k];
    if (width <= 4) {
      if constexpr (Q::kLanes == 4) return fill_narrow_rows(buffers, g, k);
      return fill_narrow(buffers, g, k);
    }
    if (width <= 8) return fill_medium(buffers, g, k);
    fill_wide(buffers, g, k);
  }
};

}  // namespace auslan::raster
