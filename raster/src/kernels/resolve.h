// SPDX-License-Identifier: Apache-2.0
// From a tile's samples to pixels: keeps the promises of the long path, then averages.
#pragma once

#include "kernel.h"

namespace auslan::raster {

template <class L, size_t kSamples>
struct Resolve {
  using F = typename L::F;
  using I = typename L::I;
  static constexpr size_t kRowWords = size_t{kTileStride} * kSamples;

  static F held(F value, float least, float greatest) { return L::min(L::max(value, L::set(least)), L::set(greatest)); }
  static F at(const Plane& p, F dx, float dy) {
    return held(L::set(p.origin + dy * p.per_y) + dx * L::set(p.per_x), p.least, p.greatest);
  }

  // The colours of a general triangle at the centres of eight pixels side by side.
  static I shade(const GeneralTriangle& t, int32_t column, int32_t row) {
    if (t.colour != kGouraudColour) return L::set(static_cast<int32_t>(t.colour));
    static constexpr float kSteps[8] = {0, 256, 512, 768, 1024, 1280, 1536, 1792};
    const F dx = L::set(static_cast<float>(column * kSubPixels + kSubPixels / 2 - t.x[0])) + L::load(kSteps);
    const float dy = static_cast<float>(row * kSubPixels + kSubPixels / 2 - t.y[0]);
    const F divisor = t.perspective ? at(t.inverse_w, dx, dy) : L::set(1.0F);
    I channel[3];
    for (size_t c = 0; c < 3; ++c) {
      F value = at(t.level[c], dx, dy);
      if (t.perspective) value = held(value / divisor, t.least[c], t.greatest[c]);
      channel[c] = L::truncate(value + L::set(0.5F));
    }
    return L::template shift_left<16>(channel[0]) | L::template shift_left<8>(channel[1]) | channel[2];
  }

  static const GeneralTriangle& promised(const TileJob& job, uint32_t word) {
    if (word == kDeferredHere) return *job.buffers.scratch;
    const uint32_t number = word & ((1U << kDeferredWorkerShift) - 1U);
    return job.general[(word & ~kDeferred) >> kDeferredWorkerShift][number];
  }

  // Eight words of the colour buffer with every promise kept.
  static I keep_promises(const TileJob& job, I words, int32_t column, int32_t row) {
    uint32_t open = L::signs(words);
    while (open != 0U) {
      uint32_t lanes[8];
      L::store(lanes, words);
      const uint32_t word = lanes[__builtin_ctz(open)];
      const I same = L::equal(words, L::set(static_cast<int32_t>(word)));
      words = L::select(same, shade(promised(job, word), column, row), words);
      open &= ~L::signs(same);
    }
    return words;
  }

  // The promises that the scratch triangle made, before the next one takes its place.
  static void settle(const TileJob& job, const GeneralTriangle& t) {
    const int32_t first_column = (t.first_column > job.x ? t.first_column - job.x : 0) & ~7;
    const int32_t first_row = t.first_row > job.y ? t.first_row - job.y : 0;
    const int32_t last_column = t.last_column - job.x < job.width - 1 ? t.last_column - job.x : job.width - 1;
    const int32_t last_row = t.last_row - job.y < job.height - 1 ? t.last_row - job.y : job.height - 1;
    const I here = L::set(static_cast<int32_t>(kDeferredHere));
    for (int32_t row = first_row; row <= last_row; ++row) {
      for (int32_t column = first_column; column <= last_column; column += 8) {
        I colour{};
        bool shaded = false;
        for (size_t s = 0; s < kSamples; ++s) {
          uint32_t* words = job.buffers.colour + static_cast<size_t>(row) * kRowWords + s * kTileStride + column;
          const I old = L::load(words);
          const I mine = L::equal(old, here);
          if (L::signs(mine) == 0U) continue;
          if (!shaded) colour = shade(t, job.x + column, job.y + row);
          shaded = true;
          L::store(words, L::select(mine, colour, old));
        }
      }
    }
  }

  // Root mean square of the samples' levels: sums of squares are whole numbers below 2^24, exact in a float.
  static I average(const I (&samples)[kSamples]) {
    const I low_byte = L::set(int32_t{255});
    F red = L::set(0.0F);
    F green = red;
    F blue = red;
    for (const I& sample : samples) {
      const F r = L::to_float(L::template shift_right<16>(sample));
      const F g = L::to_float(L::template shift_right<8>(sample) & low_byte);
      const F b = L::to_float(sample & low_byte);
      red = red + r * r;
      green = green + g * g;
      blue = blue + b * b;
    }
    const F share = L::set(1.0F / static_cast<float>(kSamples));
    const auto level = [share](F sum) { return L::truncate(L::sqrt(sum * share) + L::set(0.5F)); };
    return L::template shift_left<16>(level(red)) | L::template shift_left<8>(level(green)) | level(blue);
  }

  static I eight(const TileJob& job, int32_t column, int32_t row) {
    const uint32_t* words = job.buffers.colour + static_cast<size_t>(row) * kRowWords + static_cast<size_t>(column);
    I samples[kSamples];
    I open{};
    I differ{};
    for (size_t s = 0; s < kSamples; ++s) {
      samples[s] = L::load(words + s * kTileStride);
      open = s == 0 ? samples[0] : open | samples[s];
      if (s > 0) differ = s == 1 ? samples[1] ^ samples[0] : differ | (samples[s] ^ samples[0]);
    }
    const bool alike = kSamples == 1 || L::signs(L::equal(differ, L::set(0))) == 0xFFU;
    const bool promises = L::signs(open) != 0U;
    if (alike) return promises ? keep_promises(job, samples[0], job.x + column, job.y + row) : samples[0];
    if (promises) {
      for (I& sample : samples)
        sample = keep_promises(job, sample, job.x + column, job.y + row);
    }
    return average(samples);
  }

  static void run(const TileJob& job) {
    for (int32_t row = 0; row < job.height; ++row) {
      uint32_t* pixels = job.pixels + static_cast<size_t>(row) * job.pixel_stride;
      int32_t column = 0;
      for (; column + 8 <= job.width; column += 8)
        L::store(pixels + column, eight(job, column, row));
      if (column == job.width) continue;
      uint32_t lanes[8];
      L::store(lanes, eight(job, column, row));
      for (int32_t i = 0; column + i < job.width; ++i)
        pixels[column + i] = lanes[i];
    }
  }
};

}  // namespace auslan::raster
