// SPDX-License-Identifier: Apache-2.0
// Set-up of eight small triangles of a tile at once: edge functions (Pineda 1988), depth plane, colours.
#pragma once

#include "kernel.h"

namespace auslan::raster {

// Colours of small triangles are fixed-point with this many fraction bits and wrap at 16 bits. What is seen lies within
// its corners' range, so wrapping loses nothing; the headroom of +-256 levels is for pixel centres beside a triangle.
inline constexpr int kColourBits = 6;

template <size_t kSamples>
struct SmallGroup {
  // Everything starts at the anchor: the first pixel of the triangle's box in this tile.
  int32_t column[8], row[8];   ///< of the anchor, from the tile's corner
  int32_t across[8], down[8];  ///< blocks of 4 x 2 pixels
  // Edge functions in whole pixels: value at pixel (i, j) from the anchor is start + i * a + j * b, inside where it is
  // not negative. `start` is the exact value in square sub-pixels, with the top-left rule, divided by 256 and rounded
  // down: as a step of one pixel is a multiple of 256, no sign is lost.
  int32_t ab[3][8];  ///< a in the low half, b in the high half
  int32_t start[kSamples][3][8];
  int32_t highest[3][8];  ///< the greatest of the samples' starts
  float dx[8], dy[8];     ///< anchor's centre from the triangle's first corner, sub-pixels
  float depth[8], depth_x[8], depth_y[8], depth_least[8], depth_greatest[8];
  float sample_depth[kSamples][8];  ///< a sample's depth less its pixel centre's
  // Each number twice, in the low and the high half. `colour` has the rounding added.
  uint32_t colour[3][8], colour_x[3][8], colour_y[3][8], colour_least[3][8], colour_greatest[3][8];
};

template <class L, size_t kSamples>
struct SetUp {
  using F = typename L::F;
  using I = typename L::I;
  using Pattern = SamplePattern<kSamples>;

  static F gradient(F d1, F d2, F k1, F k2) { return d1 * k2 - d2 * k1; }
  static I doubled(I a) { return L::pair(a, a); }

  // Fixed point; what is too large to be one wraps, and is then held within the corners' range like all colours.
  static I fixed(F value, float bias) {
    const F scaled = value * L::set(static_cast<float>(1 << kColourBits)) + L::set(bias);
    const F bound = L::set(4194304.0F);
    return L::round(L::min(L::max(scaled, L::set(-4194304.0F)), bound));
  }

  /// Returns the lanes whose colours must follow the perspective.
  static uint32_t run(const TileJob& job, const uint32_t (&corner)[3][8], SmallGroup<kSamples>& out) {
    const float* base = &job.vertices->x;
    constexpr size_t kStride = sizeof(ScreenVertex) / sizeof(float);
    F x[3], y[3], z[3], w[3], level[3][3], unused;
    for (size_t c = 0; c < 3; ++c) {
      L::gather_quads(base, corner[c], kStride, x[c], y[c], z[c], w[c]);
      L::gather_quads(base + 4, corner[c], kStride, level[0][c], level[1][c], level[2][c], unused);
    }

    // The box, as the triangle stage has it, and the part in this tile.
    const I before = L::set(kSubPixels / 2 - 1 - Pattern::kReach);
    const I behind = L::set(Pattern::kReach - kSubPixels / 2);
    const I left = L::truncate(L::min(L::min(x[0], x[1]), x[2]));
    const I right = L::truncate(L::max(L::max(x[0], x[1]), x[2]));
    const I top = L::truncate(L::min(L::min(y[0], y[1]), y[2]));
    const I bottom = L::truncate(L::max(L::max(y[0], y[1]), y[2]));
    const I box_column = L::template shift_right<kSubPixelBits>(left + before);
    const I box_row = L::template shift_right<kSubPixelBits>(top + before);
    const I column = L::max(box_column, L::set(job.x));
    const I row = L::max(box_row, L::set(job.y));
    const I last_column = L::min(L::template shift_right<kSubPixelBits>(right + behind), L::set(job.x + job.width - 1));
    const I last_row = L::min(L::template shift_right<kSubPixelBits>(bottom + behind), L::set(job.y + job.height - 1));
    L::store(out.column, column - L::set(job.x));
    L::store(out.row, row - L::set(job.y));
    L::store(out.across, L::template shift_right<2>(last_column - column) + L::set(1));
    L::store(out.down, L::template shift_right<1>(last_row - row) + L::set(1));
    const I half = L::set(kSubPixels / 2);
    const I centre_x = L::template shift_left<kSubPixelBits>(column) + half;
    const I centre_y = L::template shift_left<kSubPixelBits>(row) + half;

    // Edges from each corner to the next. Clockwise with y down: a left edge runs up, a top edge is level, to the
    // right.
    const I zero = L::set(0);
    I ab[3], dx[3], dy[3];
    for (size_t e = 0; e < 3; ++e) {
      const size_t to = e == 2 ? 0 : e + 1;
      dx[e] = L::truncate(x[to] - x[e]);
      dy[e] = L::truncate(y[to] - y[e]);
      ab[e] = L::pair(zero - dy[e], dx[e]);
      L::store(out.ab[e], ab[e]);
      const I top_left =
          L::greater(zero, dy[e]) | L::and_not(L::greater(zero, dx[e]) | L::equal(dx[e], zero), L::equal(dy[e], zero));
      const I bias = L::select(top_left, zero, L::set(-1));
      const I place = L::pair(centre_x - L::truncate(x[e]), centre_y - L::truncate(y[e]));
      const I value = L::dot(ab[e], place) + bias;
      I highest = zero;
      for (size_t s = 0; s < kSamples; ++s) {
        constexpr auto packed = [](int32_t px, int32_t py) {
          return static_cast<int32_t>((static_cast<uint32_t>(px) & 0xFFFFU) | (static_cast<uint32_t>(py) << 16U));
        };
        const I offset = L::dot(ab[e], L::set(packed(Pattern::kX[s], Pattern::kY[s])));
        const I start = L::template shift_right<kSubPixelBits>(value + offset);
        L::store(out.start[s][e], start);
        highest = s == 0 ? start : L::max(highest, start);
      }
      L::store(out.highest[e], highest);
    }

    // Planes: with d1, d2 the differences to the first corner, (d1 * y2 - d2 * y1) / area and (d2 * x1 - d1 * x2) /
    // area.
    const I area = L::dot(ab[0], L::pair(zero - dx[2], zero - dy[2]));
    const F scale = L::set(1.0F) / L::to_float(area);
    const F x1 = (x[1] - x[0]) * scale;
    const F y1 = (y[1] - y[0]) * scale;
    const F x2 = (x[2] - x[0]) * scale;
    const F y2 = (y[2] - y[0]) * scale;
    L::store(out.dx, L::to_float(centre_x) - x[0]);
    L::store(out.dy, L::to_float(centre_y) - y[0]);
    const F depth_x = gradient(z[1] - z[0], z[2] - z[0], y1, y2);
    const F depth_y = gradient(z[2] - z[0], z[1] - z[0], x2, x1);
    L::store(out.depth, z[0]);
    L::store(out.depth_x, depth_x);
    L::store(out.depth_y, depth_y);
    L::store(out.depth_least, L::min(L::min(z[0], z[1]), z[2]));
    L::store(out.depth_greatest, L::max(L::max(z[0], z[1]), z[2]));
    if constexpr (kSamples > 1) {
      for (size_t s = 0; s < kSamples; ++s) {
        const F offset =
            L::set(static_cast<float>(Pattern::kX[s])) * depth_x + L::set(static_cast<float>(Pattern::kY[s])) * depth_y;
        L::store(out.sample_depth[s], offset);
      }
    }

    // Colours start at the corner of the whole box, wherever this tile cuts it.
    const F box_dx = L::to_float(L::template shift_left<kSubPixelBits>(box_column) + half) - x[0];
    const F box_dy = L::to_float(L::template shift_left<kSubPixelBits>(box_row) + half) - y[0];
    const I steps = L::pair(column - box_column, row - box_row);
    F widest = L::set(0.0F);
    for (size_t c = 0; c < 3; ++c) {
      const F d1 = level[c][1] - level[c][0];
      const F d2 = level[c][2] - level[c][0];
      const F per_x = gradient(d1, d2, y1, y2);
      const F per_y = gradient(d2, d1, x2, x1);
      const F least = L::min(L::min(level[c][0], level[c][1]), level[c][2]);
      const F greatest = L::max(L::max(level[c][0], level[c][1]), level[c][2]);
      const float rounding = static_cast<float>(1 << (kColourBits - 1));
      const I across = fixed(per_x * L::set(static_cast<float>(kSubPixels)), 0.0F);
      const I down = fixed(per_y * L::set(static_cast<float>(kSubPixels)), 0.0F);
      const I start = fixed((level[c][0] + box_dy * per_y) + box_dx * per_x, rounding);
      L::store(out.colour[c], doubled(start + L::dot(L::pair(across, down), steps)));
      L::store(out.colour_x[c], doubled(across));
      L::store(out.colour_y[c], doubled(down));
      L::store(out.colour_least[c], doubled(fixed(least, rounding)));
      L::store(out.colour_greatest[c], doubled(fixed(greatest, rounding)));
      widest = L::max(widest, greatest - least);
    }

    // Taking a colour that spreads over D levels as affine, with 1/w between q and Q, is off by at most
    // D * (sqrt(Q/q) - 1) / (sqrt(Q/q) + 1) < D * (Q - q) / (4 q) levels. Below 1/8 of a level that is not worth a
    // division.
    const F near_w = L::max(L::max(w[0], w[1]), w[2]);
    const F far_w = L::min(L::min(w[0], w[1]), w[2]);
    return L::signs(L::greater(widest * (near_w - far_w), L::set(0.5F) * far_w));
  }
};

}  // namespace auslan::raster
