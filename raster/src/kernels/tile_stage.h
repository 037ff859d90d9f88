// SPDX-License-Identifier: Apache-2.0
// Once a tile: its triangles in drawing order, small ones eight at a time.
#pragma once

#include "fill_general.h"
#include "fill_small.h"
#include "kernel.h"
#include "resolve.h"
#include "set_up.h"

namespace auslan::raster {

template <class L, size_t kSamples>
struct TileStage {
  using I = typename L::I;
  static constexpr size_t kRowWords = size_t{kTileStride} * kSamples;

  static void clear(const TileJob& job) {
    const I background = L::set(static_cast<int32_t>(job.background));
    const auto nothing = L::set(0.0F);
    const size_t words = static_cast<size_t>(job.height) * kRowWords;
    for (size_t i = 0; i < words; i += 8) {
      L::store(job.buffers.colour + i, background);
      L::store(job.buffers.depth + i, nothing);
    }
    for (size_t i = 0; i < kCells; i += 8)
      L::store(job.buffers.cell_depth + i, nothing);
  }

  // Small triangles that wait for a full group.
  struct Waiting {
    uint32_t corner[3][8] = {};
    uint32_t colour[8] = {};
    size_t count = 0;
  };

  static void fill_waiting(const TileJob& job, Waiting& waiting, float& tile_depth) {
    if (waiting.count == 0) return;
    for (size_t i = waiting.count; i < 8; ++i) {
      for (auto& corner : waiting.corner)
        corner[i] = corner[0];
    }
    SmallGroup<kSamples> group;
    const uint32_t perspective = SetUp<L, kSamples>::run(job, waiting.corner, group);
    for (size_t i = 0; i < waiting.count; ++i) {
      if ((perspective >> i & 1U) != 0U && waiting.colour[i] == kGouraudColour) {
        fill_in_perspective(job, waiting, i, group, tile_depth);
      } else {
        FillSmall<L, kSamples>::run(job.buffers, group, i, waiting.colour[i]);
      }
    }
    waiting.count = 0;
  }

  static void fill_in_perspective(const TileJob& job, const Waiting& waiting, size_t i,
                                  const SmallGroup<kSamples>& group, float& tile_depth) {
    GeneralTriangle& t = *job.buffers.scratch;
    set_up_general(job.vertices[waiting.corner[0][i]], job.vertices[waiting.corner[1][i]],
                   job.vertices[waiting.corner[2][i]], kGouraudColour, t);
    t.first_column = job.x + group.column[i];
    t.first_row = job.y + group.row[i];
    t.last_column = t.first_column + 4 * group.across[i] - 1;
    t.last_row = t.first_row + 2 * group.down[i] - 1;
    FillGeneral<L, kSamples>::run(job, t, kDeferredHere, tile_depth);
    Resolve<L, kSamples>::settle(job, t);
  }

  static void run(const TileJob& job) {
    clear(job);
    float tile_depth = 0.0F;
    Waiting waiting;
    for (size_t list = 0; list < job.list_count; ++list) {
      for (const EntryBlock* block = job.lists[list * job.list_stride]; block != nullptr; block = block->next) {
        for (uint32_t i = 0; i < block->count; ++i) {
          const Entry& entry = block->entry[i];
          if (entry.colour == kGeneralEntry) {
            fill_waiting(job, waiting, tile_depth);
            const GeneralTriangle& t = job.general[entry.corner[0]][entry.corner[1]];
            const uint32_t promise = t.colour != kGouraudColour
                                         ? t.colour
                                         : kDeferred | entry.corner[0] << kDeferredWorkerShift | entry.corner[1];
            FillGeneral<L, kSamples>::run(job, t, promise, tile_depth);
            continue;
          }
          for (size_t c = 0; c < 3; ++c)
            waiting.corner[c][waiting.count] = entry.corner[c];
          waiting.colour[waiting.count] = entry.colour;
          if (++waiting.count == 8) fill_waiting(job, waiting, tile_depth);
        }
      }
    }
    fill_waiting(job, waiting, tile_depth);
    Resolve<L, kSamples>::run(job);
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
