// SPDX-License-Identifier: Apache-2.0
// Triangles sorted into tiles, in drawing order: the work between the triangle stage and the tile stage.
#pragma once

#include "kernels/kernel.h"
#include "raster/renderer.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace auslan::raster {

/// Tiles [x0, x1) by [y0, y1).
struct TileRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1; }
  void include(int left, int top, int right, int bottom);  ///< right and bottom included
};

/// A draw as it was recorded, and what became of it.
struct RecordedDraw {
  MeshView mesh;
  glm::mat4 world_from_mesh{1.0F};
  Camera camera;
  Lighting lighting;
  Shading shading = Shading::kGouraud;
  CullMode cull = CullMode::kBack;

  Placement placement{};
  PreparedLights lights{};
  uint32_t first_vertex = 0;
  bool good = false;       ///< its arrays fit and its matrices are finite
  bool processed = false;  ///< its vertices and triangles have been through their stages in this frame
  bool changed = false;    ///< may look other than in the last frame
  DrawStats stats;
  TileRect tiles;  ///< where its triangles are
};

/// Some triangles of one draw.
struct Piece {
  uint32_t draw = 0;
  size_t begin = 0, end = 0;
  DrawStats stats;
  TileRect tiles;
};

/// One list of entries a tile.
struct TileLists {
  std::span<EntryBlock*> head, tail;
};

/// One worker's triangles and entries. They stay where they are until `reset`.
class Bins {
 public:
  /// `worker`: this object's place in the array that TileJob::general is.
  explicit Bins(uint32_t worker) : worker_(worker) {}

  void reset() noexcept;

  /// Takes a piece through the triangle stage and appends its entries to `lists`.
  void sort(const KernelTable& kernel, const RecordedDraw& draw, Piece& piece, const Viewport& viewport, int samples,
            std::span<const ScreenVertex> vertices, const TileLists& lists);

  const GeneralTriangle* general() const noexcept { return general_.data(); }

 private:
  struct Sorting;
  static constexpr size_t kBatch = 256;
  static constexpr size_t kPage = 256;

  void small(Sorting& sorting, const Survivor& survivor);
  bool large(Sorting& sorting, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, uint32_t colour);
  void cut(Sorting& sorting, const Survivor& survivor);
  void append(Sorting& sorting, const Entry& entry, int first_column, int last_column, int first_row, int last_row);
  EntryBlock* new_block();

  uint32_t worker_;
  std::vector<GeneralTriangle> general_;
  std::vector<std::unique_ptr<EntryBlock[]>> pages_;
  size_t blocks_ = 0;
  std::vector<Survivor> survivors_;
};

}  // namespace auslan::raster
