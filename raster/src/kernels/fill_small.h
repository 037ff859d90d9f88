// SPDX-License-Identifier: Apache-2.0
// Pixels of a small triangle, eight at a time from the corner of its box on: in blocks of 4 x 2 where it is at most
// four pixels wide, else in rows of 8 that stand below each other in columns.
#pragma once

#include "set_up.h"

namespace auslan::raster {

/// How eight lanes lie on the screen.
template <bool kTall>
struct BlockShape {
  static constexpr int32_t kWidth = kTall ? 4 : 8;
  static constexpr int32_t kHeight = kTall ? 2 : 1;
  uint32_t lanes[8] = {};  ///< i and j of each lane as SmallGroup::ab has a and b
  float across[8] = {}, down[8] = {};
  int16_t colour_across[32] = {}, colour_down[32] = {};  ///< the same, four times

  static constexpr BlockShape make() {
    BlockShape t;
    for (uint32_t lane = 0; lane < 8; ++lane) {
      const uint32_t i = lane % uint32_t{kWidth};
      const uint32_t j = lane / uint32_t{kWidth};
      t.lanes[lane] = i | j << 16U;
      t.across[lane] = static_cast<float>(i);
      t.down[lane] = static_cast<float>(j);
      for (uint32_t c = 0; c < 4; ++c) {
        t.colour_across[4 * lane + c] = static_cast<int16_t>(i);
        t.colour_down[4 * lane + c] = static_cast<int16_t>(j);
      }
    }
    return t;
  }
};

template <class L, size_t kSamples>
struct FillSmall {
  using F = typename L::F;
  using I = typename L::I;
  using Q = typename L::Q;
  using Group = SmallGroup<kSamples>;
  static constexpr size_t kRowWords = size_t{kTileStride} * kSamples;

  // Where a column starts, from the triangle's corner.
  struct Corner {
    static constexpr bool kElsewhere = false;
    static constexpr int32_t column = 0, row = 0;
  };
  struct Place {
    static constexpr bool kElsewhere = true;
    int32_t column, row;
  };

  // A column of blocks of one triangle, and where in it we are.
  template <bool kTall>
  struct Column {
    using Shape = BlockShape<kTall>;
    alignas(32) static constexpr Shape kShape = Shape::make();
    const Group& g;
    const size_t k;
    I edge[3], edge_down[3];
    F origin, depth_down, down, depth_across;
    Q colour, colour_down, colour_least, colour_greatest;
    float* depths;
    uint32_t* pixels;

    // `from`: of its first block from the triangle's corner.
    template <class Start>
    Column(const TileBuffers& buffers, const Group& group, size_t lane, const Start& from)
        : g(group), k(lane) {
      I lanes = L::load(kShape.lanes);
      down = L::spread(&g.down[k]) + L::load(kShape.down);
      F across = L::spread(&g.across[k]) + L::load(kShape.across);
      if constexpr (Start::kElsewhere) {
        lanes = lanes + L::set(from.column | from.row << 16);
        down = down + L::set(static_cast<float>(from.row));
        across = across + L::set(static_cast<float>(from.column));
      }
      for (size_t e = 0; e < 3; ++e) {
        const I ab = L::spread(&g.ab[e][k]);
        edge[e] = L::spread(&g.start[e][k]) + L::dot(ab, lanes);
        edge_down[e] = L::dot(ab, L::set(Shape::kHeight << 16));
      }
      origin = L::spread(&g.depth[k]);
      depth_down = L::spread(&g.depth_y[k]);
      depth_across = across * L::spread(&g.depth_x[k]);
      if ((g.word[k] & kGouraudColour) == 0U) {
        set_flat(g.word[k]);
      } else {
        set_colours(from);
      }
      const ptrdiff_t place =
          ptrdiff_t{g.row[k] + from.row} * static_cast<ptrdiff_t>(kRowWords) + g.column[k] + from.column;
      depths = buffers.depth + place;
      pixels = buffers.colour + place;
    }

    template <class Start>
    void set_colours(const Start& from) {
      colour_down = L::quads(g.colour_y[k]);
      const Q colour_across = L::quads(g.colour_x[k]);
      colour = L::quads(g.colour[k]) + colour_across * L::load_quads(kShape.colour_across);
      if constexpr (kTall) {
        colour = colour + colour_down * L::load_quads(kShape.colour_down);
      }
      if constexpr (Start::kElsewhere) {
        colour = (colour + colour_across * L::repeat(static_cast<int16_t>(from.column))) +
                 colour_down * L::repeat(static_cast<int16_t>(from.row));
      }
      if constexpr (kTall) colour_down = colour_down + colour_down;
      if constexpr (kSamples > 1) {
        colour_least = L::quads(g.colour_least[k]);
        colour_greatest = L::quads(g.colour_greatest[k]);
      }
    }

    void set_flat(uint32_t word) {
      int16_t level[4];
      for (uint32_t c = 0; c < 4; ++c)
        level[c] = static_cast<int16_t>(static_cast<int32_t>((word >> 8 * c & 0xFFU) << kLevelBits) - Group::kLess);
      colour = L::quads(level);
      colour_down = L::repeat(0);
      colour_least = colour;
      colour_greatest = colour;
    }

    void next() {
      for (size_t e = 0; e < 3; ++e)
        edge[e] = edge[e] + edge_down[e];
      down = down + L::set(static_cast<float>(Shape::kHeight));
      colour = colour + colour_down;
      depths += Shape::kHeight * kRowWords;
      pixels += Shape::kHeight * kRowWords;
    }

    template <class T>
    static auto load(const T* p) {
      if constexpr (kTall) {
        return L::load_2x4(p, kRowWords);
      } else {
        return L::load(p);
      }
    }
    template <class T, class V>
    static void store(T* p, const V& v) {
      if constexpr (kTall) {
        L::store_2x4(p, kRowWords, v);
      } else {
        L::store(p, v);
      }
    }

    I shade() const {
      if constexpr (kSamples == 1) return L::template bytes<kLevelBits>(colour);
      return L::template bytes<kLevelBits>(L::min(L::max(colour, colour_least), colour_greatest) +
                                           L::repeat(static_cast<int16_t>(Group::kLess)));
    }

    void fill() const {
      const F z = (origin + down * depth_down) + depth_across;
      if constexpr (kSamples == 1) {
        F stored = load(depths);
        const I visible = L::keep_greater(edge[0] | edge[1] | edge[2], z, stored);
        store(depths, stored);
        store(pixels, L::select(visible, shade(), load(pixels)));
      } else {
        fill_samples(z);
      }
    }

    // The samples of eight pixels of which at least one can have one inside.
    void fill_samples(F centre_depth) const {
      const I colour_here = shade();
      for (size_t s = 0; s < kSamples; ++s) {
        const I outside = (edge[0] + L::spread(&g.below[s][0][k])) | (edge[1] + L::spread(&g.below[s][1][k])) |
                          (edge[2] + L::spread(&g.below[s][2][k]));
        const F z = centre_depth + L::spread(&g.sample_depth[s][k]);
        float* sample_depth = depths + s * kTileStride;
        F stored = load(sample_depth);
        const I visible = L::keep_greater(outside, z, stored);
        store(sample_depth, stored);
        uint32_t* sample_pixels = pixels + s * kTileStride;
        store(sample_pixels, L::select(visible, colour_here, load(sample_pixels)));
      }
    }

    void run(int32_t rows) {
      for (;;) {
        fill();
        rows -= Shape::kHeight;
        if (rows <= 0) return;
        next();
      }
    }
  };

  static void run(const TileBuffers& buffers, const Group& g, size_t k) {
    const int32_t width = g.width[k];
    const int32_t height = g.height[k];
    if (width <= 4) return Column<true>(buffers, g, k, Corner{}).run(height);
    if (width <= 8) return Column<false>(buffers, g, k, Corner{}).run(height);
    fill_wide(buffers, g, k);
  }

  [[gnu::noinline]] static void fill_wide(const TileBuffers& buffers, const Group& g, size_t k) {
    const int32_t width = g.width[k];
    const int32_t height = g.height[k];
    int32_t column = 0;
    for (; column + 4 < width; column += 8)
      fill_column<false>(buffers, g, k, column, height);
    if (column < width) fill_column<true>(buffers, g, k, column, height);
  }

  // Of a column of a wide triangle only the rows that hold something. They follow each other, as each edge shuts out
  // what lies above or below a row.
  template <bool kTall>
  static void fill_column(const TileBuffers& buffers, const Group& g, size_t k, int32_t column,
                          int32_t height) {
    I highest[3], eight_down[3];
    static constexpr uint32_t kRows[8] = {0,         1U << 16U, 2U << 16U, 3U << 16U,
                                          4U << 16U, 5U << 16U, 6U << 16U, 7U << 16U};
    const I place = L::load(kRows) + L::set(column);
    for (size_t e = 0; e < 3; ++e) {
      // The edge is highest at the last pixel of a row where a is positive.
      const I ab = L::spread(&g.ab[e][k]);
      highest[e] = L::spread(&g.start[e][k]) + L::dot(ab, place) +
                   L::dot(L::max16(ab, L::set(0)), L::set(BlockShape<kTall>::kWidth - 1));
      eight_down[e] = L::dot(ab, L::set(8 << 16));
    }
    uint64_t touched = 0;
    for (int32_t row = 0; row < height; row += 8) {
      touched |= uint64_t{~L::signs(highest[0] | highest[1] | highest[2]) & 0xFFU} << static_cast<uint32_t>(row);
      for (size_t e = 0; e < 3; ++e)
        highest[e] = highest[e] + eight_down[e];
    }
    touched &= ~uint64_t{0} >> static_cast<uint32_t>(64 - height);
    if (touched == 0U) return;
    const int32_t first = __builtin_ctzll(touched);
    const int32_t last = 63 - __builtin_clzll(touched);
    Column<kTall>(buffers, g, k, Place{column, first}).run(last - first + 1);
  }
};

}  // namespace auslan::raster
