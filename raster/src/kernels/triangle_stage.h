// SPDX-License-Identifier: Apache-2.0
// Once a triangle: what cannot be seen goes, before anything is computed for its pixels.
#pragma once

#include "kernel.h"

namespace auslan::raster {

template <class L>
struct TriangleStage {
  using F = typename L::F;
  using I = typename L::I;

  // Eight triangles; the lanes of `wanted` are real ones with good indices.
  static size_t eight(const TriangleJob& job, const uint32_t (&number)[3][8], uint32_t wanted, size_t first,
                      Survivor* out) {
    F x[3], y[3];
    const float* base = &job.vertices->x;
    for (size_t c = 0; c < 3; ++c)
      L::gather_pairs(base, number[c], sizeof(ScreenVertex) / sizeof(float), x[c], y[c]);
    const F left = L::min(L::min(x[0], x[1]), x[2]);
    const F right = L::max(L::max(x[0], x[1]), x[2]);
    const F top = L::min(L::min(y[0], y[1]), y[2]);
    const F bottom = L::max(L::max(y[0], y[1]), y[2]);
    const uint32_t cut = wanted & L::signs(L::greater(right, L::set(0.5F * kOutside)));

    // Differences of a cut or large triangle mean nothing here and are not used.
    const F bound = L::set(16777216.0F);
    const auto whole = [bound](F a) { return L::truncate(L::max(L::min(a, bound), L::set(0.0F) - bound)); };
    const I reach = L::set(job.reach);
    const I before = L::set(kSubPixels / 2 - 1) - reach;
    const I behind = reach - L::set(kSubPixels / 2);
    const I first_column = L::template shift_right<kSubPixelBits>(whole(left) + before);
    const I last_column = L::template shift_right<kSubPixelBits>(whole(right) + behind);
    const I first_row = L::template shift_right<kSubPixelBits>(whole(top) + before);
    const I last_row = L::template shift_right<kSubPixelBits>(whole(bottom) + behind);
    I unseen = L::greater(first_column, last_column) | L::greater(first_row, last_row);
    unseen = unseen | L::greater(first_column, L::set(job.width - 1)) | L::greater(first_row, L::set(job.height - 1));
    unseen = unseen | L::greater(L::set(0), last_column) | L::greater(L::set(0), last_row);

    const F extent = L::set(static_cast<float>(kSmallExtent));
    const uint32_t small = L::signs(L::greater(extent, right - left) & L::greater(extent, bottom - top));
    const I area =
        L::dot(L::pair(whole(x[1] - x[0]), whole(y[0] - y[1])), L::pair(whole(y[2] - y[0]), whole(x[2] - x[0])));
    const uint32_t positive = L::signs(L::greater(area, L::set(0)));
    const uint32_t negative = L::signs(L::greater(L::set(0), area));
    // Counter-clockwise in the world, y up, is a negative area on the screen, y down.
    const uint32_t front = job.mirrored ? positive : negative;
    const uint32_t facing = job.two_sided ? positive | negative : front;
    const uint32_t seen = wanted & ~cut & ~L::signs(unseen);
    uint32_t kept = cut | (seen & ~small) | (seen & facing);
    if (kept == 0U) return 0;

    int32_t box[4][8];
    L::store(box[0], first_column);
    L::store(box[1], last_column);
    L::store(box[2], first_row);
    L::store(box[3], last_row);
    size_t count = 0;
    for (; kept != 0U; kept &= kept - 1U) {
      const auto i = static_cast<size_t>(__builtin_ctz(kept));
      const uint32_t bit = 1U << i;
      const bool swap = (negative & small & bit) != 0U;
      Survivor& s = out[count++];
      s.corner[0] = number[0][i];
      s.corner[1] = number[swap ? 2 : 1][i];
      s.corner[2] = number[swap ? 1 : 2][i];
      s.route = (cut & bit) != 0U ? Route::kCut : (small & bit) != 0U ? Route::kSmall : Route::kLarge;
      s.triangle = static_cast<uint32_t>(first + i);
      s.first_column = box[0][i];
      s.last_column = box[1][i];
      s.first_row = box[2][i];
      s.last_row = box[3][i];
    }
    return count;
  }

  static TriangleCounts run(const TriangleJob& job) {
    TriangleCounts counts{0, 0};
    for (size_t first = job.begin; first < job.end; first += 8) {
      const size_t real = job.end - first < 8 ? job.end - first : 8;
      uint32_t number[3][8] = {};
      uint32_t wanted = 0;
      const uint32_t* index = job.indices + 3 * first;
      for (size_t i = 0; i < real; ++i, index += 3) {
        const bool good = index[0] < job.vertex_count && index[1] < job.vertex_count && index[2] < job.vertex_count;
        wanted |= (good ? 1U : 0U) << i;
        for (size_t c = 0; c < 3; ++c)
          number[c][i] = good ? job.first_vertex + index[c] : job.first_vertex;
      }
      counts.rejected += real - static_cast<size_t>(__builtin_popcount(wanted));
      if (wanted != 0U) counts.survivors += eight(job, number, wanted, first, job.out + counts.survivors);
    }
    return counts;
  }
};

}  // namespace auslan::raster
