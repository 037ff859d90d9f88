// SPDX-License-Identifier: Apache-2.0
// Pixels of a small triangle, in blocks of 4 x 2 that start at the corner of its box: a triangle of up to four by two
// pixels is one block wherever it lies. Of a wider one the blocks that hold something are found eight at a time.
#pragma once

#include "set_up.h"

namespace auslan::raster {

/// What depends on a block's place in its row of blocks alone, and on a lane's in its block.
struct BlockTables {
  static constexpr size_t kBlocks = 20;     ///< more than fit across a box of kSmallExtent with a pixel to spare
  int32_t pixel[kBlocks][8] = {};           ///< 4 * block
  float across[kBlocks][8] = {};            ///< pixels from the anchor
  int16_t colour_across[kBlocks][32] = {};  ///< the same, four times
  int16_t colour_down[32] = {};
  uint32_t lane_pairs[8] = {};   ///< i and j of a block's lanes as SmallGroup::ab has a and b
  uint32_t block_pairs[8] = {};  ///< of the first lanes of eight blocks
  float down[8] = {};

  static constexpr BlockTables make() {
    BlockTables t;
    for (uint32_t lane = 0; lane < 8; ++lane) {
      t.lane_pairs[lane] = lane % 4 | (lane / 4) << 16U;
      t.block_pairs[lane] = 4 * lane;
      t.down[lane] = static_cast<float>(lane / 4);
      for (uint32_t c = 0; c < 4; ++c)
        t.colour_down[4 * lane + c] = static_cast<int16_t>(lane / 4);
      for (uint32_t block = 0; block < kBlocks; ++block) {
        t.pixel[block][lane] = static_cast<int32_t>(4 * block);
        t.across[block][lane] = static_cast<float>(4 * block + lane % 4);
        for (uint32_t c = 0; c < 4; ++c)
          t.colour_across[block][4 * lane + c] = static_cast<int16_t>(4 * block + lane % 4);
      }
    }
    return t;
  }
};
static_assert(kSmallExtent / kSubPixels / 4 + 2 <= static_cast<int>(BlockTables::kBlocks));

template <class L, size_t kSamples>
struct FillSmall {
  using F = typename L::F;
  using I = typename L::I;
  using Q = typename L::Q;
  using Group = SmallGroup<kSamples>;
  static constexpr size_t kRowWords = size_t{kTileStride} * kSamples;
  alignas(32) static constexpr BlockTables kTables = BlockTables::make();

  // A triangle and a pair of rows of it, the latter from the first of its blocks on.
  struct Walk {
    const Group& g;
    const size_t k;
    const uint32_t flat;
    I ab[3], edge[3];
    F origin, depth_x, depth_y, down, depth;
    Q colour, colour_x, colour_y;
    float* depths;
    uint32_t* pixels;

    Walk(const TileBuffers& buffers, const Group& group, size_t lane, uint32_t flat_colour)
        : g(group), k(lane), flat(flat_colour) {
      const int32_t first_pair = g.first_pair[k];
      const I from = L::load(kTables.lane_pairs) + L::set(2 * first_pair << 16);
      for (size_t e = 0; e < 3; ++e) {
        ab[e] = L::spread(&g.ab[e][k]);
        edge[e] = L::spread(&g.start[e][k]) + L::dot(ab[e], from);
      }
      origin = L::spread(&g.depth[k]);
      depth_x = L::spread(&g.depth_x[k]);
      depth_y = L::spread(&g.depth_y[k]);
      down = L::load(kTables.down) + L::set(static_cast<float>(2 * first_pair));
      depth = origin + down * depth_y;
      colour_x = L::quads(g.colour_x[k]);
      colour_y = L::quads(g.colour_y[k]);
      colour = L::quads(g.colour[k]) + colour_y * L::load_quads(kTables.colour_down);
      for (int32_t pair = 0; pair < first_pair; ++pair)
        colour = (colour + colour_y) + colour_y;
      const ptrdiff_t corner = (ptrdiff_t{g.row[k]} + 2 * first_pair) * static_cast<ptrdiff_t>(kRowWords) + g.column[k];
      depths = buffers.depth + corner;
      pixels = buffers.colour + corner;
    }

    void next_pair() {
      for (size_t e = 0; e < 3; ++e)
        edge[e] = edge[e] + L::dot(ab[e], L::set(2 << 16));
      down = down + L::set(2.0F);
      depth = origin + down * depth_y;
      colour = (colour + colour_y) + colour_y;
      depths += 2 * kRowWords;
      pixels += 2 * kRowWords;
    }

    I colour_at(size_t block) const {
      if (flat != kGouraudColour) return L::set(static_cast<int32_t>(flat));
      Q value = colour + colour_x * L::load_quads(kTables.colour_across[block]);
      if constexpr (kSamples > 1) {
        value = L::min(L::max(value, L::quads(g.colour_least[k])), L::quads(g.colour_greatest[k]));
      }
      return L::template bytes<kLevelBits>(value);
    }

    void fill(size_t block) const {
      const I step = L::load(kTables.pixel[block]);
      const I at[3] = {edge[0] + L::dot(ab[0], step), edge[1] + L::dot(ab[1], step), edge[2] + L::dot(ab[2], step)};
      const I outside = at[0] | at[1] | at[2];
      const F centre_depth = depth + L::load(kTables.across[block]) * depth_x;
      float* stored_depth = depths + 4 * block;
      uint32_t* stored_pixels = pixels + 4 * block;
      if constexpr (kSamples == 1) {
        const F stored = L::load_2x4(stored_depth, kRowWords);
        const I visible = L::and_not(L::sign_mask(outside), L::greater(centre_depth, stored));
        L::store_2x4(stored_depth, kRowWords, L::select(visible, centre_depth, stored));
        const I old = L::load_2x4(stored_pixels, kRowWords);
        L::store_2x4(stored_pixels, kRowWords, L::select(visible, colour_at(block), old));
      } else if (L::signs(outside) != 0xFFU) {
        fill_samples(at, centre_depth, block, stored_depth, stored_pixels);
      }
    }

    // The samples of a block of pixels of which at least one can have one inside.
    void fill_samples(const I (&at)[3], F centre_depth, size_t block, float* depth_of_0, uint32_t* pixels_of_0) const {
      const F least = L::spread(&g.depth_least[k]);
      const F greatest = L::spread(&g.depth_greatest[k]);
      const I shade = colour_at(block);
      for (size_t s = 0; s < kSamples; ++s) {
        const I outside = (at[0] + L::spread(&g.below[s][0][k])) | (at[1] + L::spread(&g.below[s][1][k])) |
                          (at[2] + L::spread(&g.below[s][2][k]));
        const F z = L::min(L::max(centre_depth + L::spread(&g.sample_depth[s][k]), least), greatest);
        float* sample_depth = depth_of_0 + s * kTileStride;
        const F stored = L::load_2x4(sample_depth, kRowWords);
        const I visible = L::and_not(L::sign_mask(outside), L::greater(z, stored));
        L::store_2x4(sample_depth, kRowWords, L::select(visible, z, stored));
        uint32_t* sample_pixels = pixels_of_0 + s * kTileStride;
        L::store_2x4(sample_pixels, kRowWords, L::select(visible, shade, L::load_2x4(sample_pixels, kRowWords)));
      }
    }
  };

  // A triangle of one block, all of it from its anchor on: nothing to walk, and no branch to guess wrong.
  static void fill_one(const TileBuffers& buffers, const Group& g, size_t k, uint32_t flat) {
    const I lanes = L::load(kTables.lane_pairs);
    I outside = L::spread(&g.start[0][k]) + L::dot(L::spread(&g.ab[0][k]), lanes);
    for (size_t e = 1; e < 3; ++e)
      outside = outside | (L::spread(&g.start[e][k]) + L::dot(L::spread(&g.ab[e][k]), lanes));
    const ptrdiff_t corner = ptrdiff_t{g.row[k]} * static_cast<ptrdiff_t>(kRowWords) + g.column[k];
    float* depths = buffers.depth + corner;
    uint32_t* pixels = buffers.colour + corner;
    const F z = (L::spread(&g.depth[k]) + L::load(kTables.down) * L::spread(&g.depth_y[k])) +
                L::load(kTables.across[0]) * L::spread(&g.depth_x[k]);
    const F stored = L::load_2x4(depths, kRowWords);
    const I visible = L::and_not(L::sign_mask(outside), L::greater(z, stored));
    L::store_2x4(depths, kRowWords, L::select(visible, z, stored));
    I shade = L::set(static_cast<int32_t>(flat));
    if (flat == kGouraudColour) {
      shade = L::template bytes<kLevelBits>(
          (L::quads(g.colour[k]) + L::quads(g.colour_y[k]) * L::load_quads(kTables.colour_down)) +
          L::quads(g.colour_x[k]) * L::load_quads(kTables.colour_across[0]));
    }
    L::store_2x4(pixels, kRowWords, L::select(visible, shade, L::load_2x4(pixels, kRowWords)));
  }

  static void run(const TileBuffers& buffers, const Group& g, size_t k, uint32_t flat) {
    if constexpr (kSamples == 1) {
      if ((g.first_block[k] | g.first_pair[k]) == 0 && (g.end_block[k] | g.end_pair[k]) == 1)
        return fill_one(buffers, g, k, flat);
    }
    const auto first_block = static_cast<size_t>(g.first_block[k]);
    const auto end_block = static_cast<size_t>(g.end_block[k]);
    const int32_t pairs = g.end_pair[k] - g.first_pair[k];
    Walk walk(buffers, g, k, flat);
    if (end_block == first_block + 1) {
      walk.fill(first_block);
      for (int32_t pair = 1; pair < pairs; ++pair) {
        walk.next_pair();
        walk.fill(first_block);
      }
      return;
    }
    if (end_block == first_block + 2) {
      for (int32_t pair = 0; pair < pairs; ++pair, walk.next_pair()) {
        walk.fill(first_block);
        walk.fill(first_block + 1);
      }
      return;
    }
    fill_wide(walk, first_block, end_block, pairs);
  }

  static void fill_wide(Walk& walk, size_t first_block, size_t end_block, int32_t pairs) {
    const Group& g = walk.g;
    const size_t k = walk.k;
    // Edge functions of eight blocks at the lane of each where the edge is highest.
    const I from =
        L::load(kTables.block_pairs) + L::set(static_cast<int32_t>(4 * first_block) + (2 * g.first_pair[k] << 16));
    I first_eight[3];
    for (size_t e = 0; e < 3; ++e) {
      // 3 * a where a is positive, and b where b is.
      const I rising = L::max16(walk.ab[e], L::set(0));
      first_eight[e] = L::spread(&g.start[e][k]) + L::dot(rising, L::set(3 | 1 << 16)) + L::dot(walk.ab[e], from);
    }
    for (int32_t pair = 0; pair < pairs; ++pair, walk.next_pair()) {
      I edge[3] = {first_eight[0], first_eight[1], first_eight[2]};
      for (size_t eight = first_block; eight < end_block; eight += 8) {
        const uint32_t real = end_block - eight < 8 ? (1U << (end_block - eight)) - 1U : 0xFFU;
        uint32_t touched = ~L::signs(edge[0] | edge[1] | edge[2]) & real;
        for (; touched != 0U; touched &= touched - 1U)
          walk.fill(eight + static_cast<size_t>(__builtin_ctz(touched)));
        for (size_t e = 0; e < 3; ++e)
          edge[e] = edge[e] + L::dot(walk.ab[e], L::set(32));
      }
      for (size_t e = 0; e < 3; ++e)
        first_eight[e] = first_eight[e] + L::dot(walk.ab[e], L::set(2 << 16));
    }
  }
};

}  // namespace auslan::raster
