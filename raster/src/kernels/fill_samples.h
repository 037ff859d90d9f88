// SPDX-License-Identifier: Apache-2.0
// Samples of a small triangle, where a pixel has several: a vector holds all of those of as many pixels as it has room
// for. Of each row of the triangle's box the pixels are found that may hold a sample, and only these are taken, one
// vector after the other from the left.
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
  static_assert(kPixels >= 1);

  // Numbers that eight rows or pixels are counted with.
  struct alignas(32) Counts {
    uint32_t row[8] = {};  ///< in both halves
    uint32_t row_high[8] = {};
    float number[8] = {};
    uint32_t pixel[8] = {};  ///< of a lane in a vector of samples, in both halves
    static constexpr Counts make() {
      Counts t;
      for (uint32_t i = 0; i < 8; ++i) {
        t.row[i] = i | i << 16U;
        t.row_high[i] = i << 16U;
        t.number[i] = static_cast<float>(i);
        t.pixel[i] = i / uint32_t{kSamples} | (i / uint32_t{kSamples}) << 16U;
      }
      return t;
    }
    static const Counts kCounts;
  };

  // Fixed-point colours, as SmallGroup has them; each lane its pixel's.
  struct Colours {
    WI blue_red, green;
    friend Colours operator+(const Colours& a, const Colours& b) {
      return {W::add16(a.blue_red, b.blue_red), W::add16(a.green, b.green)};
    }
    friend Colours operator*(const Colours& a, WI halves) {
      return {W::multiply16(a.blue_red, halves), W::multiply16(a.green, halves)};
    }
    static Colours spread(const typename Group::Colours& colours, size_t k) {
      return {W::spread(&colours.blue_red[k]), W::spread(&colours.green[k])};
    }
  };

  // Of each row of the box that lies in the tile the first pixel that may have a sample inside, and how many follow up
  // to the last one. They follow each other, as each edge shuts out what lies left or right of a pixel. Found by
  // division: a pixel too many on either side costs a little time and no more.
  struct Rows {
    alignas(32) int32_t first[kTileHeight + 8], count[kTileHeight + 8];
    alignas(32) int32_t place[kTileHeight + 8];  ///< the first pixel in the low half, the row in the high one
    alignas(32) float depth[kTileHeight + 8];    ///< at the anchor's column

    Rows(const Group& g, size_t k) {
      const F zero = L::set(0.0F);
      const F right = L::set(static_cast<float>(g.width[k] - 1));
      const F beyond = right + L::set(1.0F);
      const F slack = L::set(1.0F / 64.0F);
      const F nearly_one = L::set(1.0F) - slack;
      const F depth_down = L::spread(&g.depth_y[k]);
      const F origin = L::spread(&g.depth[k]);
      F down = L::spread(&g.down[k]) + L::load(Counts::kCounts.number);
      I row = L::load(Counts::kCounts.row_high);
      for (int32_t j = 0; j < g.height[k]; j += 8) {
        F least = zero;
        F greatest = right;
        for (size_t e = 0; e < 3; ++e) {
          // Between whole numbers above and below zero lies none.
          const I ab = L::spread(&g.ab[e][k]);
          const F value = L::to_float(L::spread(&g.start[e][k]) + L::dot(ab, row)) + L::set(0.5F);
          const F a = L::to_float(L::template shift_right<16>(L::template shift_left<16>(ab)));
          const F crossing = value / (zero - a);
          const I rises = L::greater(a, zero);
          least = L::max(least, L::select(rises, crossing, zero));
          greatest = L::min(greatest, L::select(rises, right, crossing));
        }
        const I first_pixel = L::truncate(L::min(least, beyond) + nearly_one);
        const I last_pixel = L::truncate(L::max(greatest, L::set(-2.0F)) + slack);
        L::store(first + j, first_pixel);
        L::store(count + j, (last_pixel - first_pixel) + L::set(1));
        L::store(place + j, first_pixel | row);
        L::store(depth + j, origin + down * depth_down);
        down = down + L::set(8.0F);
        row = row + L::set(8 << 16);
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

  // The colour of a flat triangle; red has the bit above it too: kStandInColour is to come out as it is.
  static Colours flat_colours(uint32_t word) {
    const auto fixed = [](uint32_t level) {
      return static_cast<uint32_t>(static_cast<int32_t>(level << kLevelBits) - Group::kLess) & 0xFFFFU;
    };
    return {W::set(static_cast<int32_t>(fixed(word & 0xFFU) | fixed(word >> 16U & 0x1FFU) << 16U)),
            W::set(static_cast<int32_t>(fixed(word >> 8U & 0xFFU)))};
  }

  static WI shade(const Colours& colour, const Colours& least, const Colours& greatest) {
    const WI less = W::set(Group::kLess | Group::kLess << 16);
    const auto held = [less](WI value, WI low, WI high) {
      return W::add16(W::min16(W::max16(value, low), high), less);
    };
    const WI green = held(colour.green, least.green, greatest.green);
    return W::template shift_right16<kLevelBits>(held(colour.blue_red, least.blue_red, greatest.blue_red)) |
           (W::template shift_left<8 - kLevelBits>(green) & W::set(0xFF00));
  }

  [[gnu::noinline]] static void run(const TileBuffers& buffers, const Group& g, size_t k) {
    const Rows rows(g, k);
    const Across across(g, k);
    const WI pixel = W::load(Counts::kCounts.pixel);
    WI ab[3], start[3], step[3];
    for (size_t e = 0; e < 3; ++e) {
      ab[e] = W::spread(&g.ab[e][k]);
      start[e] = W::template repeat<kSamples>(g.sample_start[e][k]);
      if constexpr (kPixels > 1) start[e] = start[e] + W::dot(ab[e], pixel & W::set(0xFFFF));
      step[e] = W::dot(ab[e], W::set(kPixels));
    }
    const WF sample_depth = W::template repeat<kSamples>(g.sample_depth[k]);
    Colours corner, right, down, least, greatest;
    if ((g.word[k] & kGouraudColour) != 0U) {
      right = Colours::spread(g.colour_x, k);
      corner = Colours::spread(g.colour, k);
      if constexpr (kPixels > 1) corner = corner + right * pixel;
      down = Colours::spread(g.colour_y, k);
      least = Colours::spread(g.colour_least, k);
      greatest = Colours::spread(g.colour_greatest, k);
    } else {
      corner = least = greatest = flat_colours(g.word[k]);
      right = down = Colours{W::set(0), W::set(0)};
    }
    const Colours colour_step = right * W::set(kPixels | kPixels << 16);

    const size_t place = static_cast<size_t>(g.row[k]) * kRowWords + static_cast<size_t>(g.column[k]) * kSamples;
    float* row_depths = buffers.depth + place;
    uint32_t* row_words = buffers.colour + place;
    for (int32_t j = 0; j < g.height[k]; ++j, row_depths += kRowWords, row_words += kRowWords, corner = corner + down) {
      int32_t left = rows.count[j];
      if (left <= 0) continue;
      const WI from_corner = W::spread(&rows.place[j]);
      WI edge[3];
      for (size_t e = 0; e < 3; ++e)
        edge[e] = start[e] + W::dot(ab[e], from_corner);
      const WF row_depth = W::spread(&rows.depth[j]);
      const int32_t first = rows.first[j];
      Colours colour = corner + right * W::set(first | first << 16);
      size_t i = static_cast<size_t>(first) * kSamples;
      for (;;) {
        const WF depth = (row_depth + W::load(across.depth + i)) + sample_depth;
        WF stored = W::load(row_depths + i);
        const WI visible = W::keep_greater(edge[0] | edge[1] | edge[2], depth, stored);
        W::store(row_depths + i, stored);
        W::store(row_words + i, W::select(visible, shade(colour, least, greatest), W::load(row_words + i)));
        left -= kPixels;
        if (left <= 0) break;
        for (size_t e = 0; e < 3; ++e)
          edge[e] = edge[e] + step[e];
        colour = colour + colour_step;
        i += W::kLanes;
      }
    }
  }
};

template <class L, size_t kSamples>
inline constexpr typename FillSamples<L, kSamples>::Counts FillSamples<L, kSamples>::Counts::kCounts = make();

}  // namespace auslan::raster
