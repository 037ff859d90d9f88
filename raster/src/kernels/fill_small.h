// SPDX-License-Identifier: Apache-2.0
// Pixels of a small triangle, in blocks of 4 x 2 that start at the corner of its box: a triangle of up to four by two
// pixels is one block wherever it lies.
#pragma once

#include "set_up.h"

namespace auslan::raster {

template <class L, size_t kSamples>
struct FillSmall {
  using F = typename L::F;
  using I = typename L::I;
  using H = typename L::H;
  using Group = SmallGroup<kSamples>;
  static constexpr size_t kRowWords = size_t{kTileStride} * kSamples;

  // Pixel offsets within a block, for each lane: i in the low half, j in the high half.
  static I block_offsets() {
    static constexpr uint32_t kOffsets[8] = {0, 1, 2, 3, 0x10000, 0x10001, 0x10002, 0x10003};
    return L::load(kOffsets);
  }
  static H halves_across() {
    static constexpr int16_t kAcross[8] = {0, 1, 2, 3, 0, 1, 2, 3};
    return L::load_halves(kAcross);
  }
  static H halves_down() {
    static constexpr int16_t kDown[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    return L::load_halves(kDown);
  }
  static F float_across() {
    static constexpr float kAcross[8] = {0, 256, 512, 768, 0, 256, 512, 768};
    return L::load(kAcross);
  }
  static F float_down() {
    static constexpr float kDown[8] = {0, 0, 0, 0, 256, 256, 256, 256};
    return L::load(kDown);
  }

  // One channel in fixed point, at the block in hand.
  struct Channel {
    H value, least, greatest;
    H at() const { return L::template shift_right<kColourBits>(L::min(L::max(value, least), greatest)); }
  };

  // A triangle's colour, one for all or three channels; `move` goes to another block.
  struct Colour {
    Channel channel[3];
    H across[3], down[3];
    I flat;
    bool gouraud;

    Colour(const Group& g, size_t k, uint32_t colour) : gouraud(colour == kGouraudColour) {
      flat = L::set(static_cast<int32_t>(colour));
      if (!gouraud) return;
      for (size_t c = 0; c < 3; ++c) {
        const H per_x = L::halves(g.colour_x[c][k]);
        const H per_y = L::halves(g.colour_y[c][k]);
        channel[c].value = (L::halves(g.colour[c][k]) + per_x * halves_across()) + per_y * halves_down();
        channel[c].least = L::halves(g.colour_least[c][k]);
        channel[c].greatest = L::halves(g.colour_greatest[c][k]);
        across[c] = L::template shift_left<2>(per_x);
        down[c] = L::template shift_left<1>(per_y);
      }
    }
    I at(uint32_t block_column) const {
      if (!gouraud) return flat;
      H value[3];
      const H step = L::halves(block_column * 0x10001U);
      for (size_t c = 0; c < 3; ++c) {
        const Channel moved{channel[c].value + across[c] * step, channel[c].least, channel[c].greatest};
        value[c] = moved.at();
      }
      return L::pixels(value[0], value[1], value[2]);
    }
    void next_row() {
      if (!gouraud) return;
      for (size_t c = 0; c < 3; ++c)
        channel[c].value = channel[c].value + down[c];
    }
  };

  static void run(const TileBuffers& buffers, const Group& g, size_t k, uint32_t flat) {
    I row_edge[3], step_x[3], step_y[3];
    for (size_t e = 0; e < 3; ++e) {
      const I ab = L::set(g.ab[e][k]);
      row_edge[e] = L::set(kSamples > 1 ? g.highest[e][k] : g.start[0][e][k]) + L::dot(ab, block_offsets());
      step_x[e] = L::dot(ab, L::set(4));
      step_y[e] = L::dot(ab, L::set(2 << 16));
    }
    const F origin = L::set(g.depth[k]);
    const F per_x = L::set(g.depth_x[k]);
    const F per_y = L::set(g.depth_y[k]);
    const F least = L::set(g.depth_least[k]);
    const F greatest = L::set(g.depth_greatest[k]);
    const F left = L::set(g.dx[k]) + float_across();
    F dy = L::set(g.dy[k]) + float_down();
    Colour colour(g, k, flat);
    const auto across = static_cast<uint32_t>(g.across[k]);
    const size_t corner = static_cast<size_t>(g.row[k]) * kRowWords + static_cast<size_t>(g.column[k]);
    float* depth_row = buffers.depth + corner;
    uint32_t* colour_row = buffers.colour + corner;

    for (int32_t block_row = g.down[k]; block_row > 0; --block_row) {
      I edge[3] = {row_edge[0], row_edge[1], row_edge[2]};
      const F row_depth = origin + dy * per_y;
      F dx = left;
      for (uint32_t block = 0; block < across; ++block) {
        const I outside = edge[0] | edge[1] | edge[2];
        if (L::signs(outside) != 0xFFU) {
          const F centre_depth = row_depth + dx * per_x;
          float* depth = depth_row + 4 * block;
          uint32_t* pixels = colour_row + 4 * block;
          if constexpr (kSamples == 1) {
            const F z = L::min(L::max(centre_depth, least), greatest);
            const F stored = L::load_2x4(depth, kRowWords);
            const I visible = L::and_not(L::sign_mask(outside), L::greater(z, stored));
            if (L::signs(visible) != 0U) {
              L::store_2x4(depth, kRowWords, L::select(visible, z, stored));
              const I old = L::load_2x4(pixels, kRowWords);
              L::store_2x4(pixels, kRowWords, L::select(visible, colour.at(block), old));
            }
          } else {
            block_samples(g, k, edge, centre_depth, least, greatest, colour, block, depth, pixels);
          }
        }
        for (size_t e = 0; e < 3; ++e)
          edge[e] = edge[e] + step_x[e];
        dx = dx + L::set(4.0F * kSubPixels);
      }
      for (size_t e = 0; e < 3; ++e)
        row_edge[e] = row_edge[e] + step_y[e];
      dy = dy + L::set(2.0F * kSubPixels);
      colour.next_row();
      depth_row += 2 * kRowWords;
      colour_row += 2 * kRowWords;
    }
  }

  // The samples of a block of pixels of which at least one lane can have one inside.
  static void block_samples(const Group& g, size_t k, const I (&edge)[3], F centre_depth, F least, F greatest,
                            const Colour& colour, uint32_t block, float* depth, uint32_t* pixels) {
    I shade{};
    bool shaded = false;
    for (size_t s = 0; s < kSamples; ++s) {
      I outside = edge[0] + L::set(g.start[s][0][k] - g.highest[0][k]);
      outside = outside | (edge[1] + L::set(g.start[s][1][k] - g.highest[1][k]));
      outside = outside | (edge[2] + L::set(g.start[s][2][k] - g.highest[2][k]));
      const F z = L::min(L::max(centre_depth + L::set(g.sample_depth[s][k]), least), greatest);
      float* sample_depth = depth + s * kTileStride;
      const F stored = L::load_2x4(sample_depth, kRowWords);
      const I visible = L::and_not(L::sign_mask(outside), L::greater(z, stored));
      if (L::signs(visible) == 0U) continue;
      if (!shaded) shade = colour.at(block);
      shaded = true;
      L::store_2x4(sample_depth, kRowWords, L::select(visible, z, stored));
      uint32_t* sample_pixels = pixels + s * kTileStride;
      const I old = L::load_2x4(sample_pixels, kRowWords);
      L::store_2x4(sample_pixels, kRowWords, L::select(visible, shade, old));
    }
  }
};

}  // namespace auslan::raster
