// SPDX-License-Identifier: Apache-2.0
// Once a tile: its triangles in drawing order, small ones eight at a time.
#pragma once

#include "fill_general.h"
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
    const size_t rows = static_cast<size_t>(job.height) * kSamples;
    for (size_t row = 0; row < rows; ++row, colour += kTileStride, depth += kTileStride) {
      for (size_t i = 0; i < kTileWidth; i += 8) {
        L::store(colour + i, background);
        L::store(depth + i, nothing);
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
    bool owned = false;  ///< cells may have owners
  };

  // Eight entries of a block, or as many as it has.
  static void fill_eight(const TileJob& job, const EntryBlock& block, size_t first, State& state) {
    const size_t count = block.count - first < 8 ? block.count - first : 8;
    const uint32_t there = (1U << count) - 1U;
    const uint32_t general = L::signs(L::load(block.colour + first)) & there;
    SmallGroup<kSamples> group;
    uint32_t with_care = 0;
    if (general != there) {
      with_care = SetUp<L, kSamples>::run(job, block, first, group) & there;
      // Small triangles do not keep the upper bounds up, and know nothing of owners.
      set_cells(job.buffers.cell_greatest, 2.0F);
      if (state.owned) FillGeneral<L, kSamples>::release_all(job);
      state.owned = false;
    }
    const uint32_t long_path = general | with_care;
    for (size_t i = 0; i < count; ++i) {
      if ((long_path >> i & 1U) == 0U) {
        FillSmall<L, kSamples>::run(job.buffers, group, i, block.colour[first + i]);
      } else if ((general >> i & 1U) != 0U) {
        fill_large(job, block.colour[first + i], state);
      } else {
        fill_with_care(job, block, first + i, group, i, state);
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
  [[gnu::noinline]] static void fill_with_care(const TileJob& job, const EntryBlock& block, size_t i,
                                               const SmallGroup<kSamples>& group, size_t k, State& state) {
    Corner corner[3];
    for (size_t c = 0; c < 3; ++c)
      corner[c] = corner_of(job.points[block.corner[c][i]], job.values[block.corner[c][i]]);
    GeneralTriangle& t = *job.buffers.scratch;
    set_up_general(corner[0], corner[1], corner[2], block.colour[i], t);
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
      for (const EntryBlock* block = job.lists[list * job.list_stride]; block != nullptr; block = block->next) {
        for (size_t first = 0; first < block->count; first += 8)
          fill_eight(job, *block, first, state);
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
