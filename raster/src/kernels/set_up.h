// SPDX-License-Identifier: Apache-2.0
// Set-up of eight small triangles of a tile at once: edge functions (Pineda 1988), depth plane, colours. What is
// rounded is counted from the anchor, the first pixel of a triangle's box, wherever that lies: no tile's edge can
// change a bit.
#pragma once

#include "kernel.h"

namespace auslan::raster {

/// Colours of eight triangles: fixed-point numbers with kLevelBits fraction bits, plus half a level, that wrap at 16
/// bits. With one sample what is seen lies between 0 and 255 levels and is off by less than half a level, so it fits.
template <size_t kSamples>
struct GroupColours {
  // With several samples a pixel's centre may lie beside the triangle; less 128 levels there is as much room below as
  // above. Blue, green, red and a fourth channel, for which only kStandInColour has a use.
  static constexpr int32_t kLess = 128 << kLevelBits;
  using Colours = int32_t[8][2];
  alignas(32) Colours colour, colour_x, colour_y, colour_least, colour_greatest;
};
template <>
struct GroupColours<1> {
  static constexpr int32_t kLess = 0;
  struct Colours {
    int32_t blue_red[8];  ///< blue in the low halves
    int32_t green[8];     ///< in the low halves, twice the number, so that its byte needs no shift
  };
  Colours colour, colour_x, colour_y;
};

template <size_t kSamples>
struct SmallGroup : GroupColours<kSamples> {
  // The part of the box that lies in the tile. Its first pixel is the corner: edges and colours, which are whole
  // numbers, start there without a change; depth is counted from the anchor, the first pixel of the whole box.
  int32_t place[8];           ///< of the corner in the tile's buffers, from the tile's first pixel
  int32_t column[8], row[8];  ///< of the corner from the tile's first pixel
  int32_t width[8], height[8];
  float across[8], down[8];  ///< pixels from the anchor to the corner
  uint32_t word[8];          ///< as SmallTriangle has it
  // Edge functions in whole pixels: the value at pixel (i, j) from the corner is start + i * a + j * b, inside where it
  // is not negative. `start` is the exact value in square sub-pixels, with the top-left rule, divided by 256 and
  // rounded down: as a step of one pixel is a multiple of 256, no sign is lost.
  int32_t ab[3][8];     ///< a in the low half, b in the high half
  int32_t start[3][8];  ///< the greatest of the samples' starts
  /// Depth at pixel (i, j) from the anchor is (depth + j * depth_y) + i * depth_x.
  float depth[8], depth_x[8], depth_y[8];
  // Used with several samples only, where a pixel's centre may lie beside the triangle. A triangle's samples stand
  // together.
  alignas(32) int32_t sample_start[3][8][kSamples];
  alignas(32) float sample_depth[8][kSamples];  ///< a sample's depth less its pixel centre's
  // Where the edges cross a row of pixels, in pixels from the corner, with room for all rounding. Of a triangle: two
  // edges that shut out what lies left of them, first and third (both the same one if there is one), and two that shut
  // out what lies right, the distance negative.
  alignas(32) float crossing[8][4];
  alignas(32) float crossing_down[8][4];  ///< what is added from row to row
};

template <class L, size_t kSamples>
struct SetUp {
  using F = typename L::F;
  using I = typename L::I;
  using Pattern = SamplePattern<kSamples>;

  static constexpr int32_t packed(int32_t low, int32_t high) {
    return static_cast<int32_t>((static_cast<uint32_t>(low) & 0xFFFFU) | (static_cast<uint32_t>(high) << 16U));
  }
  static F magnitude(F a) { return L::max(a, L::set(0.0F) - a); }
  // Of a pixel with a sample inside, the centre lies within half a pixel of the triangle in either direction: there a
  // colour is at most half of this beyond its corners', and 128 levels are left for that, less what rounding takes.
  static F steepest() { return L::set(static_cast<float>(250 << kLevelBits)); }
  static F gradient(F d1, F d2, F k1, F k2) { return d1 * k2 - d2 * k1; }
  static I low_half(I words) { return words & L::set(int32_t{0xFFFF}); }
  static I high_half(I words) { return L::template shift_right<16>(words); }
  // Half a level for rounding, and what colours are less by.
  static constexpr int32_t kColourBias = (1 << (kLevelBits - 1)) - SmallGroup<kSamples>::kLess;

  /// Returns the lanes that must take the long path: slivers, whose gradients need more than single precision,
  /// triangles whose colours must follow the perspective, and those whose colours would not fit in 16 bits beside them.
  static uint32_t run(const TileJob& job, const SmallTriangle* small, const uint32_t* number,
                      SmallGroup<kSamples>& out) {
    F x[3], y[3], depth[3], w[3];
    I blue_green[3], red[3];
    alignas(32) uint32_t corners[3][8];
    {
      I words[4];
      L::gather_quads(reinterpret_cast<const uint32_t*>(small), number, words[0], words[1], words[2], words[3]);
      for (size_t c = 0; c < 3; ++c)
        L::store(corners[c], words[c]);
      L::store(out.word, words[3]);
    }
    for (size_t c = 0; c < 3; ++c) {
      const uint32_t* corner = corners[c];
      F levels[2];
      L::gather_pairs(&job.points->x, corner, sizeof(ScreenPoint) / sizeof(float), x[c], y[c]);
      L::gather_quads(&job.values->depth, corner, sizeof(ScreenValues) / sizeof(float), depth[c], w[c], levels[0],
                      levels[1]);
      blue_green[c] = L::bits(levels[0]);
      red[c] = L::bits(levels[1]);
    }

    // The box, as the triangle stage has it.
    const F left = L::min(L::min(x[0], x[1]), x[2]);
    const F right = L::max(L::max(x[0], x[1]), x[2]);
    const F top = L::min(L::min(y[0], y[1]), y[2]);
    const F bottom = L::max(L::max(y[0], y[1]), y[2]);
    const I before = L::set(kSubPixels / 2 - 1 - Pattern::kReach);
    const I behind = L::set(Pattern::kReach - kSubPixels / 2);
    const I column = L::template shift_right<kSubPixelBits>(L::truncate(left) + before);
    const I row = L::template shift_right<kSubPixelBits>(L::truncate(top) + before);
    const I last_column = L::template shift_right<kSubPixelBits>(L::truncate(right) + behind);
    const I last_row = L::template shift_right<kSubPixelBits>(L::truncate(bottom) + behind);
    const I zero = L::set(0);
    const I left_out = L::max(L::set(job.x) - column, zero);
    const I above = L::max(L::set(job.y) - row, zero);
    const I corner_column = column + left_out;
    const I corner_row = row + above;
    const I tile_column = corner_column - L::set(job.x);
    const I tile_row = corner_row - L::set(job.y);
    L::store(out.column, tile_column);
    L::store(out.row, tile_row);
    L::store(out.place, L::dot(L::pair(tile_column, tile_row), L::set(packed(1, kTileStride * int32_t{kSamples}))));
    L::store(out.width, L::min(last_column, L::set(job.x + job.width - 1)) - corner_column + L::set(1));
    L::store(out.height, L::min(last_row, L::set(job.y + job.height - 1)) - corner_row + L::set(1));
    L::store(out.across, L::to_float(left_out));
    L::store(out.down, L::to_float(above));
    const I half = L::set(kSubPixels / 2);
    const I anchor_x = L::template shift_left<kSubPixelBits>(column) + half;
    const I anchor_y = L::template shift_left<kSubPixelBits>(row) + half;
    const I corner_x = L::template shift_left<kSubPixelBits>(corner_column) + half;
    const I corner_y = L::template shift_left<kSubPixelBits>(corner_row) + half;

    // Edges from each corner to the next. Clockwise with y down: a left edge runs up, a top edge is level, to the
    // right.
    I ab[3];
    [[maybe_unused]] Crossings crossings;
    I whole_x[3], whole_y[3];
    for (size_t c = 0; c < 3; ++c) {
      whole_x[c] = L::truncate(x[c]);
      whole_y[c] = L::truncate(y[c]);
    }
    for (size_t e = 0; e < 3; ++e) {
      const size_t to = e == 2 ? 0 : e + 1;
      const I dx = whole_x[to] - whole_x[e];
      const I rise = whole_y[e] - whole_y[to];
      ab[e] = L::pair(rise, dx);
      L::store(out.ab[e], ab[e]);
      // Top or left where rise > 0, or rise == 0 and dx > 0: |dx| is below 2^15. Else one less.
      const I bias = L::greater(L::set(1), L::template shift_left<15>(rise) + dx);
      const I value = L::dot(ab[e], L::pair(corner_x - whole_x[e], corner_y - whole_y[e])) + bias;
      if constexpr (kSamples == 1) {
        L::store(out.start[e], L::template shift_right<kSubPixelBits>(value));
      } else {
        I start[kSamples];
        for (size_t s = 0; s < kSamples; ++s) {
          const I offset = L::dot(ab[e], L::set(packed(Pattern::kX[s], Pattern::kY[s])));
          start[s] = L::template shift_right<kSubPixelBits>(value + offset);
        }
        I highest = start[0];
        for (size_t s = 1; s < kSamples; ++s)
          highest = L::max(highest, start[s]);
        L::store(out.start[e], highest);
        F words[kSamples];
        for (size_t s = 0; s < kSamples; ++s)
          words[s] = L::from_bits(start[s]);
        store_together(words, reinterpret_cast<float*>(out.sample_start[e]));
        crossings.set(e, rise, dx, highest);
      }
    }

    // Planes: with d1, d2 the differences to the first corner, (d1 * y2 - d2 * y1) / area and (d2 * x1 - d1 * x2) /
    // area; here a pixel's worth, 256 times as much.
    const F area = L::to_float(L::dot(ab[0], L::pair(whole_x[2] - whole_x[0], whole_y[2] - whole_y[0])));
    const F scale = L::set(static_cast<float>(kSubPixels)) / area;
    const F x1 = (x[1] - x[0]) * scale;
    const F y1 = (y[1] - y[0]) * scale;
    const F x2 = (x[2] - x[0]) * scale;
    const F y2 = (y[2] - y[0]) * scale;
    const F pixel = L::set(1.0F / static_cast<float>(kSubPixels));
    const F dx = (L::to_float(anchor_x) - x[0]) * pixel;
    const F dy = (L::to_float(anchor_y) - y[0]) * pixel;
    const F depth_1 = depth[1] - depth[0];
    const F depth_2 = depth[2] - depth[0];
    const F depth_x = gradient(depth_1, depth_2, y1, y2);
    const F depth_y = gradient(depth_2, depth_1, x2, x1);
    L::store(out.depth, (depth[0] + dy * depth_y) + dx * depth_x);
    L::store(out.depth_x, depth_x);
    L::store(out.depth_y, depth_y);
    // Colours are rounded in the middle of the box, so that what the rounded gradients are off adds up over half of it.
    const I middle_x = L::template shift_right<1>(last_column - column);
    const I middle_y = L::template shift_right<1>(last_row - row);
    const F middle_dx = dx + L::to_float(middle_x);
    const F middle_dy = dy + L::to_float(middle_y);
    const I from_middle = L::pair(left_out - middle_x, above - middle_y);
    I start[3], per_x[3], per_y[3];
    I steep = L::set(0);
    for (size_t c = 0; c < 3; ++c) {
      const auto channel = [&](size_t corner) {
        return c == 0 ? low_half(blue_green[corner]) : c == 1 ? high_half(blue_green[corner]) : red[corner];
      };
      const I level = channel(0);
      const F d1 = L::to_float(channel(1) - level);
      const F d2 = L::to_float(channel(2) - level);
      const F gradient_x = gradient(d1, d2, y1, y2);
      const F gradient_y = gradient(d2, d1, x2, x1);
      if constexpr (kSamples > 1) steep = steep | L::greater(magnitude(gradient_x) + magnitude(gradient_y), steepest());
      const F middle = (L::to_float(level) + middle_dy * gradient_y) + middle_dx * gradient_x;
      per_x[c] = L::round(gradient_x);
      per_y[c] = L::round(gradient_y);
      start[c] = (L::round(middle) + L::set(kColourBias)) + L::dot(L::pair(per_x[c], per_y[c]), from_middle);
    }
    store_colours(start, out.colour);
    store_colours(per_x, out.colour_x);
    store_colours(per_y, out.colour_y);

    const I least[2] = {L::min16(L::min16(blue_green[0], blue_green[1]), blue_green[2]),
                        L::min16(L::min16(red[0], red[1]), red[2])};
    const I greatest[2] = {L::max16(L::max16(blue_green[0], blue_green[1]), blue_green[2]),
                           L::max16(L::max16(red[0], red[1]), red[2])};
    if constexpr (kSamples > 1) {
      crossings.store(out);
      store_ranges(depth_x, depth_y, least, greatest, out);
    }

    // Taking a colour that spreads over D levels as affine, with 1/w between q and Q, is off by at most
    // D * (sqrt(Q/q) - 1) / (sqrt(Q/q) + 1) < D * (Q - q) / (4 q) levels.
    const I blue_green_spread = L::subtract16(greatest[0], least[0]);
    const I both = L::max16(blue_green_spread, greatest[1] - least[1]);  // blue or red in the low half
    const F widest = L::to_float(L::max16(low_half(both), high_half(both)));
    const F near_w = L::max(L::max(w[0], w[1]), w[2]);
    const F far_w = L::min(L::min(w[0], w[1]), w[2]);
    const I perspective = L::greater(widest * (near_w - far_w), L::set(4.0F * kAffineError * kLevelScale) * far_w);
    // With a height of 1/128 pixel and more, rounding is off by no more than 2^-10 of what depth spreads over.
    const F span = L::max(right - left, bottom - top);
    const I sliver = L::greater(span + span, area);
    return L::signs(perspective | sliver | steep);
  }

  // A lane's samples side by side.
  static void store_together(const F (&samples)[kSamples], float* out) {
    if constexpr (kSamples == 2) {
      L::scatter_pairs(out, samples[0], samples[1]);
    } else if constexpr (kSamples == 4) {
      L::scatter_quads(out, samples[0], samples[1], samples[2], samples[3]);
    } else {
      for (size_t s = 0; s < kSamples; ++s) {
        float lanes[8];
        L::store(lanes, samples[s]);
        for (size_t i = 0; i < 8; ++i)
          out[i * kSamples + s] = lanes[i];
      }
    }
  }
  // Where edges cross the rows. An edge value at pixel i of row j is v + j * b + i * a, whole numbers, so that it is
  // not negative just where v + j * b + 1/2 + i * a is positive; with 2^-6 more for a, which is never 0 then, it can
  // only be where it was before, as i is not negative. Each row's number is the last one's plus a step. |v| <= 122 (|a|
  // + |b|) + 1, so that rounding in all of this adds up to less than 2^-10 (1 + |step|), which is allowed for.
  struct Crossings {
    F at[3], step[3];
    I rises[3];

    void set(size_t e, I a, I b, I v) {
      rises[e] = L::greater(a, L::set(-1));
      const F inverse = L::set(-1.0F) / magnitude(L::to_float(a) + L::set(1.0F / 64.0F));
      step[e] = L::to_float(b) * inverse;
      at[e] = (L::to_float(v) + L::set(0.5F)) * inverse - (magnitude(step[e]) + L::set(1.0F)) * L::set(1.0F / 1024.0F);
    }
    void store(SmallGroup<kSamples>& out) const {
      store(at, out.crossing);
      store(step, out.crossing_down);
    }
    // One or two of the three rise.
    void store(const F (&of)[3], float (&out)[8][4]) const {
      const F left_0 = L::select(rises[0], of[0], L::select(rises[2], of[2], of[1]));
      const F left_1 = L::select(rises[1], of[1], L::select(rises[2], of[2], of[0]));
      const F right_0 = L::select(rises[0], L::select(rises[2], of[1], of[2]), of[0]);
      const F right_1 = L::select(rises[1], L::select(rises[2], of[0], of[2]), of[1]);
      L::scatter_quads(out[0], left_0, right_0, left_1, right_1);
    }
  };

  static void store_colours(const I (&blue_green_red)[3], typename SmallGroup<kSamples>::Colours& out) {
    if constexpr (kSamples == 1) {
      L::store(out.blue_red, L::pair(blue_green_red[0], blue_green_red[2]));
      L::store(out.green, L::template shift_left<1>(blue_green_red[1]));
    } else {
      store_channels(L::pair(blue_green_red[0], blue_green_red[1]), low_half(blue_green_red[2]), out);
    }
  }
  static void store_channels(I blue_green, I red, int32_t (&out)[8][2]) {
    L::scatter_pairs(reinterpret_cast<float*>(out[0]), L::from_bits(blue_green), L::from_bits(red));
  }
  static void store_ranges(F depth_x, F depth_y, const I (&least)[2], const I (&greatest)[2],
                           SmallGroup<kSamples>& out) {
    F depth[kSamples];
    for (size_t s = 0; s < kSamples; ++s) {
      constexpr float kPixel = 1.0F / static_cast<float>(kSubPixels);
      depth[s] = L::set(static_cast<float>(Pattern::kX[s]) * kPixel) * depth_x +
                 L::set(static_cast<float>(Pattern::kY[s]) * kPixel) * depth_y;
    }
    store_together(depth, out.sample_depth[0]);
    // What holds the fourth channel at 0, whatever it is before.
    const I nothing = L::set(packed(0, -SmallGroup<kSamples>::kLess));
    const I bias = L::set(packed(kColourBias, kColourBias));
    const auto store = [=](const I(&levels)[2], int32_t(&colours)[8][2]) {
      store_channels(L::add16(levels[0], bias), low_half(L::add16(levels[1], bias)) | nothing, colours);
    };
    store(least, out.colour_least);
    store(greatest, out.colour_greatest);
  }
};

}  // namespace auslan::raster
