// SPDX-License-Identifier: Apache-2.0
// Samples of a small triangle, where a pixel has several: a vector holds all of those of as many pixels as it has room
// for. Of each row of the triangle's box only those pixels are taken that may have a sample inside: as each edge shuts
// out what lies left or right of a pixel, they follow each other. Where they begin and end is found by additions of
// rounded numbers with some room, which costs a pixel too many now and then and changes nothing else.
#pragma once

#include "set_up.h"

namespace auslan::raster {

template <class L, size_t kSamples>
struct FillSamples {
  using F = typename L::F;
  using I = typename L::I;
  using W = decltype(L::template sample_lanes<kSamples>());
  using WF = typename W::F;
  using WI = typename W::I;
  using Group = SmallGroup<kSamples>;
  static constexpr size_t kRowWords = size_t{kTileStride} * kSamples;
  static constexpr int32_t kPixels = static_cast<int32_t>(W::kLanes / kSamples);  ///< in a vector
  // Vectors that are filled with one vector of colours, which has room for kLanes / 2 pixels. Wider lanes lose more by
  // branches in several places, where a row may end, than they win by computing fewer colours.
  static constexpr size_t kVectors = W::kLanes == 4 ? kSamples / 2 : 1;
  static constexpr int32_t kColours = kPixels * static_cast<int32_t>(kVectors);
  static_assert(kPixels >= 1 && kVectors <= 2);

  // Numbers that eight rows or pixels are counted with.
  struct alignas(32) Counts {
    float number[8] = {};
    uint32_t pixel[8] = {};            ///< of a lane in a vector of samples
    uint32_t pixel_of_colour[8] = {};  ///< of a lane in a vector of colours, in both halves
    static constexpr Counts make() {
      Counts t;
      for (uint32_t i = 0; i < 8; ++i) {
        t.number[i] = static_cast<float>(i);
        t.pixel[i] = i / uint32_t{kSamples};
        t.pixel_of_colour[i] = i / 2U * 0x10001U;
      }
      return t;
    }
    static const Counts kCounts;
  };

  // The rows that may have samples inside, found ahead of all pixels, so that no branch waits for it.
  struct Rows {
    int32_t place[kTileHeight + 1];            ///< the first pixel in the low half, the row in the high one
    int32_t pixels[kTileHeight + 1];           ///< from the first to the last, negative
    alignas(32) float depth[kTileHeight + 8];  ///< of each row of the box, at the anchor's column
    size_t count = 0;

    Rows(const Group& g, size_t k) {
      const int32_t width = g.width[k];
      const int32_t height = g.height[k];
      const F origin = L::spread(&g.depth[k]);
      const F depth_y = L::spread(&g.depth_y[k]);
      F down = L::spread(&g.down[k]) + L::load(Counts::kCounts.number);
      for (int32_t j = 0; j < height; j += 8) {
        L::store(depth + j, origin + down * depth_y);
        down = down + L::set(8.0F);
      }
      auto crossing = L::load_crossings(g.crossing[k]);
      const auto crossing_down = L::load_crossings(g.crossing_down[k]);
      const auto least = L::least_crossings(width);
      for (int32_t row = 0; row < height << 16; row += 1 << 16) {
        int32_t first, minus_last;
        L::pixels_between(crossing, least, first, minus_last);
        const int32_t minus_count = first + minus_last - 1;
        place[count] = first + row;
        pixels[count] = minus_count;
        count += static_cast<uint32_t>(minus_count) >> 31U;
        crossing = L::sum(crossing, crossing_down);
      }
    }
  };

  // Depth of each pixel's column, for each of its samples.
  struct Across {
    alignas(32) float depth[(kTileWidth + 8) * kSamples];

    Across(const Group& g, size_t k) {
      const F depth_x = L::spread(&g.depth_x[k]);
      F across = L::spread(&g.across[k]) + L::load(Counts::kCounts.number);
      for (int32_t i = 0; i < g.width[k]; i += 8) {
        I samples[kSamples];
        L::template expand<kSamples>(L::bits(across * depth_x), samples);
        for (size_t v = 0; v < kSamples; ++v)
          L::store(depth + static_cast<size_t>(i) * kSamples + 8 * v, L::from_bits(samples[v]));
        across = across + L::set(8.0F);
      }
    }
  };

  // What a triangle's colours are held within, and what is added from pixel to pixel, and from row to row; as
  // SmallGroup has them, a pixel after the other.
  struct Colours {
    WI corner, right, down, least, greatest;

    Colours(const Group& g, size_t k) {
      if ((g.word[k] & kGouraudColour) != 0U) {
        right = W::template repeat<2>(g.colour_x[k]);
        corner = W::template repeat<2>(g.colour[k]);
        corner = W::add16(corner, W::multiply16(right, W::load(Counts::kCounts.pixel_of_colour)));
        down = W::template repeat<2>(g.colour_y[k]);
        least = W::template repeat<2>(g.colour_least[k]);
        greatest = W::template repeat<2>(g.colour_greatest[k]);
      } else {
        const auto fixed = [](uint32_t level) {
          return static_cast<uint32_t>(static_cast<int32_t>((level & 0xFFU) << kLevelBits) - Group::kLess) & 0xFFFFU;
        };
        const uint32_t word = g.word[k];
        const uint32_t channels[2] = {fixed(word) | fixed(word >> 8U) << 16U, fixed(word >> 16U) | fixed(word >> 24U)
                                                                                                       << 16U};
        int32_t flat[2];
        __builtin_memcpy(flat, channels, sizeof flat);
        corner = least = greatest = W::template repeat<2>(flat);
        right = down = W::set(0);
      }
    }
    WI packed(WI colour) const {
      const WI held = W::min16(W::max16(colour, least), greatest);
      const WI levels =
          W::template shift_right16<kLevelBits>(W::add16(held, W::set(Group::kLess | Group::kLess << 16)));
      return W::pack_colours(levels);
    }
  };

  [[gnu::noinline]] static void run(const TileBuffers& buffers, const Group& g, size_t k) {
    const Rows rows(g, k);
    const Across across(g, k);
    WI ab[3], start[3], step[3];
    for (size_t e = 0; e < 3; ++e) {
      ab[e] = W::spread(&g.ab[e][k]);
      start[e] = W::template repeat<kSamples>(g.sample_start[e][k]);
      if constexpr (kPixels > 1) start[e] = start[e] + W::dot(ab[e], W::load(Counts::kCounts.pixel));
      step[e] = W::dot(ab[e], W::set(kPixels));
    }
    const WF sample_depth = W::template repeat<kSamples>(g.sample_depth[k]);
    const Colours colours(g, k);
    const WI colour_step = W::multiply16(colours.right, W::set(kColours | kColours << 16));

    const size_t place = static_cast<size_t>(g.row[k]) * kRowWords + static_cast<size_t>(g.column[k]) * kSamples;
    float* const corner_depths = buffers.depth + place;
    uint32_t* const corner_words = buffers.colour + place;
    for (size_t n = 0; n < rows.count; ++n) {
      const size_t j = static_cast<uint32_t>(rows.place[n]) >> 16U;
      const size_t first = static_cast<uint32_t>(rows.place[n]) & 0xFFFFU;
      const WI from_corner = W::spread(&rows.place[n]);
      WI edge[3];
      for (size_t e = 0; e < 3; ++e)
        edge[e] = start[e] + W::dot(ab[e], from_corner);
      const WF row_depth = W::spread(&rows.depth[j]);
      WI colour = W::add16(W::add16(colours.corner, W::multiply16(colours.down, W::high_halves(from_corner))),
                           W::multiply16(colours.right, W::low_halves(from_corner)));
      const float* pixel_depths = across.depth + first * kSamples;
      const size_t here = j * kRowWords + first * kSamples;
      float* depths = corner_depths + here;
      uint32_t* words = corner_words + here;
      int32_t left = rows.pixels[n];
      const auto fill = [&](size_t i, WI pixels) {
        const WF depth = (row_depth + W::load(pixel_depths + i)) + sample_depth;
        WF stored = W::load(depths + i);
        const WI visible = W::keep_greater(edge[0] | edge[1] | edge[2], depth, stored);
        W::store(depths + i, stored);
        W::store(words + i, W::select(visible, pixels, W::load(words + i)));
      };
      const auto move = [&] {
        for (size_t e = 0; e < 3; ++e)
          edge[e] = edge[e] + step[e];
      };
      for (size_t i = 0;; i += W::kLanes) {
        const WI packed = colours.packed(colour);
        fill(i, W::template words_of_samples<kSamples, 0>(packed));
        left += kPixels;
        if (left >= 0) break;
        move();
        if constexpr (kVectors == 2) {
          i += W::kLanes;
          fill(i, W::template words_of_samples<kSamples, 1>(packed));
          left += kPixels;
          if (left >= 0) break;
          move();
        }
        colour = W::add16(colour, colour_step);
      }
    }
  }
};

template <class L, size_t kSamples>
inline constexpr typename FillSamples<L, kSamples>::Counts FillSamples<L, kSamples>::Counts::kCounts = make();

}  // namespace auslan::raster
