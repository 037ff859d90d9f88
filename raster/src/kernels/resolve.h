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

  // Eight pixels' words for their samples.
  static void expand(I pixels, I (&samples)[kSamples]) {
    if constexpr (kSamples == 1) {
      samples[0] = pixels;
    } else {
      L::template expand<kSamples>(pixels, samples);
    }
  }

  static F held(F value, float least, float greatest) { return L::min(L::max(value, L::set(least)), L::set(greatest)); }
  // The colours of a general triangle along one row of pixels.
  struct Shader {
    F per_x[3], row[3], least[3], greatest[3];
    const GeneralTriangle& t;
    float dy;

    Shader(const GeneralTriangle& triangle, int32_t pixel_row)
        : t(triangle), dy(static_cast<float>(pixel_row * kSubPixels + kSubPixels / 2 - triangle.y[0])) {
      for (size_t c = 0; c < 3; ++c) {
        const Plane& level = t.level[c];
        per_x[c] = L::set(level.per_x);
        row[c] = L::set(level.origin + dy * level.per_y);
        least[c] = L::set(level.least);
        greatest[c] = L::set(level.greatest);
      }
    }
    // Sub-pixels from the triangle's first corner to the centres of eight pixels.
    F across(int32_t column) const {
      static constexpr float kSteps[8] = {0, 256, 512, 768, 1024, 1280, 1536, 1792};
      return L::set(static_cast<float>(column * kSubPixels + kSubPixels / 2 - t.x[0])) + L::load(kSteps);
    }
    template <bool kPerspective>
    I at(F dx) const {
      F value[3];
      for (size_t c = 0; c < 3; ++c)
        value[c] = L::min(L::max(row[c] + dx * per_x[c], least[c]), greatest[c]);
      if constexpr (kPerspective) {
        const Plane& w = t.inverse_w;
        const F divisor = held(L::set(w.origin + dy * w.per_y) + dx * L::set(w.per_x), w.least, w.greatest);
        for (size_t c = 0; c < 3; ++c)
          value[c] = held(value[c] / divisor, t.least[c], t.greatest[c]);
      }
      const F half = L::set(0.5F);
      const I red = L::truncate(value[0] + half);
      const I green = L::truncate(value[1] + half);
      return L::template shift_left<16>(red) | L::template shift_left<8>(green) | L::truncate(value[2] + half);
    }
    I at(int32_t column) const { return t.perspective ? at<true>(across(column)) : at<false>(across(column)); }

    // A run of pixels that promise this triangle, from `column` on; returns where it ends.
    template <bool kPerspective>
    int32_t run(const TileJob& job, const uint32_t* words, uint32_t word, uint32_t* pixels, int32_t column) const {
      F dx = across(job.x + column);
      do {
        L::store(pixels + column, at<kPerspective>(dx));
        dx = dx + L::set(8.0F * kSubPixels);
        column += 8;
      } while (column + 8 <= job.width && all_samples(words + static_cast<size_t>(column) * kSamples, word));
      return column;
    }
  };

  // Whether all samples of eight pixels hold this word.
  static bool all_samples(const uint32_t* words, uint32_t word) {
    const I wanted = L::set(static_cast<int32_t>(word));
    I differ = L::load(words) ^ wanted;
    for (size_t s = 1; s < kSamples; ++s)
      differ = differ | (L::load(words + 8 * s) ^ wanted);
    return L::signs(L::equal(differ, L::set(0))) == 0xFFU;
  }

  static const GeneralTriangle& promised(const TileJob& job, uint32_t word) {
    if (word == kScratchTriangle) return *job.buffers.scratch;
    const uint32_t place = word & ((1U << kBinShift) - 1U);
    return job.general[(word & ~kGeneralTriangle) >> kBinShift][place];
  }

  // Eight words of the colour buffer with every promise kept.
  static I keep_promises(const TileJob& job, I words, int32_t column, int32_t row) {
    uint32_t open = L::signs(words);
    while (open != 0U) {
      uint32_t lanes[8];
      L::store(lanes, words);
      const uint32_t word = lanes[__builtin_ctz(open)];
      const I same = L::equal(words, L::set(static_cast<int32_t>(word)));
      words = L::select(same, Shader(promised(job, word), row).at(column), words);
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
    const I here = L::set(static_cast<int32_t>(kScratchTriangle));
    for (int32_t row = first_row; row <= last_row; ++row) {
      for (int32_t column = first_column; column <= last_column; column += 8) {
        I colours[kSamples]{};
        bool shaded = false;
        uint32_t* words =
            job.buffers.colour + static_cast<size_t>(row) * kRowWords + static_cast<size_t>(column) * kSamples;
        for (size_t v = 0; v < kSamples; ++v, words += 8) {
          const I old = L::load(words);
          const I mine = L::equal(old, here);
          if (L::signs(mine) == 0U) continue;
          if (!shaded) expand(Shader(t, job.y + row).at(job.x + column), colours);
          shaded = true;
          L::store(words, L::select(mine, colours[v], old));
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

  static I eight(const TileJob& job, const uint32_t* words, int32_t column, int32_t row, bool promised_any) {
    I pixels;
    if constexpr (kSamples == 1) {
      pixels = L::load(words);
    } else {
      if (!L::template alike<kSamples>(words, pixels)) return mixed(job, words, column, row, promised_any);
    }
    return promised_any && L::signs(pixels) != 0U ? keep_promises(job, pixels, job.x + column, job.y + row) : pixels;
  }
  // Eight pixels of which some have samples that differ.
  static I mixed(const TileJob& job, const uint32_t* words, int32_t column, int32_t row, bool promised_any) {
    if constexpr (L::kAveragedSamples == kSamples) {
      if (!promised_any) return L::average(words);
    }
    I samples[kSamples];
    L::template split<kSamples>(words, samples);
    I open = samples[0];
    for (size_t s = 1; s < kSamples; ++s)
      open = open | samples[s];
    if (L::signs(open) != 0U) {
      for (I& sample : samples)
        sample = keep_promises(job, sample, job.x + column, job.y + row);
    }
    return average(samples);
  }

  // A tile without promises, with one sample.
  static void copy(const TileJob& job) {
    uint32_t* pixels = job.pixels;
    const uint32_t* words = job.buffers.colour;
    for (int32_t row = 0; row < job.height; ++row, pixels += job.pixel_stride, words += kRowWords) {
      int32_t column = 0;
      for (; column + 8 <= job.width; column += 8)
        L::store(pixels + column, L::load(words + column));
      for (; column < job.width; ++column)
        pixels[column] = words[column];
    }
  }

  // With several.
  static void unpromised(const TileJob& job) {
    uint32_t* pixels = job.pixels;
    const uint32_t* words = job.buffers.colour;
    for (int32_t row = 0; row < job.height; ++row, pixels += job.pixel_stride, words += kRowWords) {
      const auto samples_at = [words](int32_t column) { return words + static_cast<size_t>(column) * kSamples; };
      int32_t column = 0;
      for (; column + 8 <= job.width; column += 8)
        L::store(pixels + column, eight(job, samples_at(column), column, row, false));
      if (column < job.width) store_pixels(job, pixels, column, eight(job, samples_at(column), column, row, false));
    }
  }

  // Pixels of cells side by side that have one owner; returns where they end.
  static int32_t owned(const TileJob& job, const uint32_t* owner, int32_t row, uint32_t* pixels, int32_t column) {
    const uint32_t word = owner[column / kCellSize];
    int32_t end = column;
    do {
      end += kCellSize;
    } while (end < job.width && owner[end / kCellSize] == word);
    const GeneralTriangle& t = promised(job, word);
    if (t.colour != kGouraudColour) {
      const I colour = L::set(static_cast<int32_t>(t.colour));
      for (; column < end; column += 8)
        store_pixels(job, pixels, column, colour);
    } else {
      const Shader shader(t, job.y + row);
      for (; column < end; column += 8)
        store_pixels(job, pixels, column, shader.at(job.x + column));
    }
    return end;
  }

  // Eight pixels, or as many as the frame has there.
  static void store_pixels(const TileJob& job, uint32_t* pixels, int32_t column, I colours) {
    if (column + 8 <= job.width) return L::store(pixels + column, colours);
    uint32_t lanes[8];
    L::store(lanes, colours);
    for (int32_t i = 0; column + i < job.width; ++i)
      pixels[column + i] = lanes[i];
  }

  /// `promised_any`: whether there may be promises or owners.
  static void run(const TileJob& job, bool promised_any) {
    if (!promised_any) return kSamples == 1 ? copy(job) : unpromised(job);
    uint32_t* pixels = job.pixels;
    const uint32_t* words = job.buffers.colour;
    for (int32_t row = 0; row < job.height; ++row, pixels += job.pixel_stride, words += kRowWords) {
      int32_t column = 0;
      const uint32_t* owner = job.buffers.cell_owner + row / kCellSize * kCellsAcross;
      while (column < job.width) {
        if (owner[column / kCellSize] != 0U) {
          column = owned(job, owner, row, pixels, column);
          continue;
        }
        if (column + 8 > job.width) break;
        const uint32_t word = words[static_cast<size_t>(column) * kSamples];
        if ((word & kGeneralTriangle) == 0U || !all_samples(words + static_cast<size_t>(column) * kSamples, word)) {
          L::store(pixels + column,
                   eight(job, words + static_cast<size_t>(column) * kSamples, column, row, promised_any));
          column += 8;
          continue;
        }
        const GeneralTriangle& t = promised(job, word);
        const Shader shader(t, job.y + row);
        column = t.perspective ? shader.template run<true>(job, words, word, pixels, column)
                               : shader.template run<false>(job, words, word, pixels, column);
      }
      if (column >= job.width) continue;
      uint32_t lanes[8];
      L::store(lanes, eight(job, words + static_cast<size_t>(column) * kSamples, column, row, promised_any));
      for (int32_t i = 0; column + i < job.width; ++i)
        pixels[column + i] = lanes[i];
    }
  }
};

}  // namespace auslan::raster
