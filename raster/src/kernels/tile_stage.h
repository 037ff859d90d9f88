// SPDX-License-Identifier: Apache-2.0
// Once a tile: its triangles in drawing order, small ones eight at a time.
#pragma once

#include "fill_general.h"
#include "fill_samples.h"
#include "fill_small.h"
#include "fill_textured.h"
#include "kernel.h"
#include "resolve.h"
#include "set_up.h"

namespace auslan::raster {

template <class L, size_t kSamples>
struct TileStage {
  using I = typename L::I;
  static constexpr size_t kRowWords = size_t{kTileStride} * kSamples;

  static void set_cells(float* cells, float depth) {
    for (size_t i = 0; i < kCells; i += 8)
      L::store(cells + i, L::set(depth));
  }

  static void clear(const TileJob& job) {
    const I background = L::set(static_cast<int32_t>(job.background));
    const auto nothing = L::set(0.0F);
    uint32_t* colour = job.buffers.colour;
    float* depth = job.buffers.depth;
    for (int32_t row = 0; row < job.height; ++row, colour += kRowWords, depth += kRowWords) {
      for (size_t i = 0; i < kTileWidth * kSamples; i += 32) {
        for (size_t k = i; k < i + 32; k += 8) {
          L::store(colour + k, background);
          L::store(depth + k, nothing);
        }
      }
    }
    set_cells(job.buffers.cell_least, 0.0F);
    set_cells(job.buffers.cell_greatest, 0.0F);
    for (size_t i = 0; i < kCells; i += 8)
      L::store(job.buffers.cell_owner + i, L::set(0));
  }

  struct State {
    float depth = 0.0F;  ///< a lower bound of the tile's depth
    bool promised = false;
    bool owned = false;      ///< cells may have owners
    bool unbounded = false;  ///< the upper bounds of depth say nothing
  };

  static void fill_small(const TileBuffers& buffers, const SmallGroup<kSamples>& group, size_t i) {
    if constexpr (kSamples == 1) {
      FillSmall<L>::run(buffers, group, i);
    } else {
      FillSamples<L, kSamples>::run(buffers, group, i);
    }
  }

  // Up to eight entries; there is room for eight.
  static void fill_eight(const TileJob& job, const SmallTriangle* small, const uint32_t* entry, size_t count,
                         State& state) {
    static constexpr uint32_t kNumbers[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    const I is_there = L::greater(L::set(static_cast<int32_t>(count)), L::load(kNumbers));
    const I entries = L::load(entry);
    const uint32_t there = (1U << count) - 1U;
    const uint32_t general = L::signs(entries) & there;
    SmallGroup<kSamples> group;
    uint32_t with_care = 0;
    if (general != there) {
      // In places of others stands some small triangle that there is.
      alignas(32) uint32_t number[8];
      L::store(number, L::select(L::and_not(L::sign_mask(entries), is_there), entries, L::set(0)));
      with_care = SetUp<L, kSamples>::run(job, small, number, group) & there;
      // Small triangles do not keep the upper bounds up, and know nothing of owners. Nothing lowers a bound of 2 again.
      if (!state.unbounded) set_cells(job.buffers.cell_greatest, 2.0F);
      state.unbounded = true;
      if (state.owned) FillGeneral<L, kSamples>::release_all(job);
      state.owned = false;
    }
    const uint32_t long_path = general | with_care;
    for (size_t i = 0; i < count; ++i) {
      if ((long_path >> i & 1U) == 0U) {
        fill_small(job.buffers, group, i);
      } else if ((general >> i & 1U) != 0U) {
        fill_large(job, entry[i], state);
      } else {
        fill_with_care(job, small[entry[i]], group, i, state);
      }
    }
  }

  [[gnu::noinline]] static void fill_large(const TileJob& job, uint32_t word, State& state) {
    const GeneralTriangle& t = Resolve<L, kSamples>::promised(job, word);
    if (t.colour == kStandInColour) {
      FillTextured<L, kSamples>::run(job, t, job.textured[(word & ~kGeneralTriangle) >> kBinShift][t.texture],
                                     state.depth, state.owned);
      return;
    }
    FillGeneral<L, kSamples>::run(job, t, word, state.depth);
    state.promised = true;
    state.owned = true;
  }

  // A small triangle by the long path.
  [[gnu::noinline]] static void fill_with_care(const TileJob& job, const SmallTriangle& small,
                                               const SmallGroup<kSamples>& group, size_t k, State& state) {
    Corner corner[3];
    for (size_t c = 0; c < 3; ++c)
      corner[c] = corner_of(job.points[small.corner[c]], job.values[small.corner[c]]);
    GeneralTriangle& t = *job.buffers.scratch;
    const bool gouraud = (small.word & kGouraudColour) != 0U;
    set_up_general(corner[0], corner[1], corner[2], gouraud ? kGouraudColour : small.word, t);
    t.first_column = job.x + group.column[k];
    t.first_row = job.y + group.row[k];
    t.last_column = t.first_column + group.width[k] - 1;
    t.last_row = t.first_row + group.height[k] - 1;
    FillGeneral<L, kSamples>::run(job, t, kScratchTriangle, state.depth);
    if (t.colour == kGouraudColour) Resolve<L, kSamples>::settle(job, t);
  }

  static void run(const TileJob& job) {
    clear(job);
    State state;
    for (size_t list = 0; list < job.list_count; ++list) {
      const SmallTriangle* small = job.small[list];
      const uint32_t* tail = job.tails[list * job.list_stride];
      for (const EntryBlock* block = job.lists[list * job.list_stride]; block != nullptr; block = block->next) {
        const uint32_t* end = block->next != nullptr ? block->entry + EntryBlock::kCapacity : tail;
        for (const uint32_t* entry = block->entry; entry < end; entry += 8)
          fill_eight(job, small, entry, end - entry < 8 ? static_cast<size_t>(end - entry) : 8, state);
      }
    }
    Resolve<L, kSamples>::run(job, state.promised);
  }
};

/// A kernel's table: the three stages of one lane type.
template <class L, class Vertices, class Triangles>
constexpr KernelTable kernel_table() {
  return KernelTable{Vertices::run,
                     Triangles::run,
                     {TileStage<L, 1>::run, TileStage<L, 2>::run, TileStage<L, 4>::run, TileStage<L, 8>::run}};
}

}  // namespace auslan::raster
