// SPDX-License-Identifier: Apache-2.0
// Triangles sorted into tiles, in drawing order: the work between the triangle stage and the tile stage.
#pragma once

#include "kernels/kernel.h"
#include "kernels/texture.h"
#include "raster/renderer.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace auslan::raster {

/// Tiles from (x0, y0) to (x1, y1), both included; x0 > x1: none.
struct TileRect {
  int x0 = kMaxImageSize, y0 = kMaxImageSize, x1 = -1, y1 = -1;
  bool empty() const { return x0 > x1; }
  void include(int left, int top, int right, int bottom) {
    x0 = left < x0 ? left : x0;
    y0 = top < y0 ? top : y0;
    x1 = right > x1 ? right : x1;
    y1 = bottom > y1 ? bottom : y1;
  }
};

/// A draw as it was recorded, and what became of it.
struct RecordedDraw {
  MeshView mesh;
  glm::mat4 world_from_mesh{1.0F};
  Camera camera;
  Lighting lighting;
  Shading shading = Shading::kGouraud;
  CullMode cull = CullMode::kBack;
  uint64_t texture_serial = 0;  ///< 0: none

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

/// Vertices of the frame that have been through the vertex stage.
struct ScreenVertices {
  std::vector<ScreenPoint> points;
  std::vector<ScreenValues> values;
};

/// One list of entries a tile.
struct TileLists {
  std::span<EntryBlock*> head;
  std::span<uint32_t*> tail;
};

/// The triangles and entries of one group. They stay where they are until `reset`. What a group needs does not depend
/// on which worker takes it, so a warm frame needs nothing new.
class Bins {
 public:
  /// Bins and triangles of one bin at most, as many as a deferred colour can name.
  static constexpr size_t kMost = (size_t{1} << (31U - kBinShift)) - 1U;
  static constexpr size_t kMostTriangles = (size_t{1} << kBinShift) / 7U;  // cutting can make seven of one

  /// `number`: this object's place in the array that TileJob::general is.
  explicit Bins(uint32_t number) : number_(number) {}

  /// `triangles`: how many may come at most.
  void reset(size_t triangles);

  /// Takes a piece through the triangle stage and appends its entries to `lists`.
  void sort(const KernelTable& kernel, const RecordedDraw& draw, Piece& piece, const Viewport& viewport, int samples,
            const ScreenVertices& vertices, const TileLists& lists);

  const GeneralTriangle* general() const noexcept { return general_.data(); }
  const TexturedTriangle* textured() const noexcept { return textured_.data(); }
  const SmallTriangle* small() const noexcept { return small_.data(); }

 private:
  struct Sorting;
  static constexpr size_t kPage = 64;

  void take(Sorting& sorting, const Survivor& survivor);
  void large(Sorting& sorting, const Survivor& survivor);
  void cut(Sorting& sorting, const Survivor& survivor);
  void small_textured(Sorting& sorting, const Survivor& survivor);
  static void set_coordinates(const Sorting& sorting, const Survivor& survivor, Corner (&corner)[3]);
  bool add_general(Sorting& sorting, const Corner& a, const Corner& b, const Corner& c, uint32_t colour,
                   const Survivor* small = nullptr);
  void add_textured(const RecordedDraw& draw, const Corner (&corners)[3], uint32_t colour, const Survivor* small,
                    GeneralTriangle& shape);
  void append(Sorting& sorting, uint32_t entry, const TileRect& tiles);
  uint32_t* extend(const TileLists& lists, size_t tile);

  uint32_t number_;
  std::vector<GeneralTriangle> general_;
  std::vector<TexturedTriangle> textured_;
  std::vector<SmallTriangle> small_;  ///< its size is the room
  uint32_t small_count_ = 0;
  std::vector<std::unique_ptr<EntryBlock[]>> pages_;
  size_t blocks_ = 0;
};

}  // namespace auslan::raster
