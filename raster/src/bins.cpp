// SPDX-License-Identifier: Apache-2.0
#include "bins.h"

#include "clip.h"
#include "lights.h"
#include "placement.h"
#include "textured.h"

#include <algorithm>

namespace auslan::raster {
namespace {

int32_t reach_of(int samples) {
  switch (samples) {
    case 2:
      return SamplePattern<2>::kReach;
    case 4:
      return SamplePattern<4>::kReach;
    case 8:
      return SamplePattern<8>::kReach;
    default:
      return SamplePattern<1>::kReach;
  }
}

// Twice the area on the screen in square sub-pixels; positive when clockwise with y down.
int64_t doubled_area(const Corner& a, const Corner& b, const Corner& c) {
  const auto difference = [](float to, float from) { return static_cast<int64_t>(to - from); };
  return difference(b.x, a.x) * difference(c.y, a.y) - difference(c.x, a.x) * difference(b.y, a.y);
}

TileRect tiles_of(uint32_t word, uint32_t tiles_across) {
  const auto x = static_cast<int>((word & kTileMask) % tiles_across);
  const auto y = static_cast<int>((word & kTileMask) / tiles_across);
  const uint32_t more = word >> kTileBits;
  return TileRect{x, y, x + static_cast<int>(more & kTileColumnMask), y + static_cast<int>(more >> kTileColumnBits)};
}

uint32_t colour_of(const RecordedDraw& draw, const uint32_t* corner) {
  if (draw.shading == Shading::kGouraud) return kGouraudColour;
  return flat_colour(draw.mesh, corner, draw.placement, draw.lights);
}

}  // namespace

// What the triangles of one piece have in common.
struct Bins::Sorting {
  Bins& bins;
  const RecordedDraw& draw;
  Piece& piece;
  const Viewport& viewport;
  const ScreenVertices& vertices;
  const TileLists& lists;
  int32_t reach;
  uint32_t tiles_across;

  bool textured() const { return draw.texture_serial != 0; }
  bool two_sided() const { return draw.cull == CullMode::kNone; }
  // Counter-clockwise in the world, y up, is a negative area on the screen, y down.
  bool shows(int64_t area) const { return area != 0 && (two_sided() || (area < 0) != draw.placement.mirrored); }
  const uint32_t* corners(const Survivor& survivor) const { return &draw.mesh.indices[3 * size_t{survivor.triangle}]; }
  Corner screen_corner(uint32_t vertex) const { return corner_of(vertices.points[vertex], vertices.values[vertex]); }
};

void Bins::reset(size_t triangles) {
  general_.clear();
  textured_.clear();
  blocks_ = 0;
  small_count_ = 0;
  if (small_.size() < triangles + 8) small_.resize(triangles + 8);
}

void Bins::sort(const KernelTable& kernel, const RecordedDraw& draw, Piece& piece, const Viewport& viewport,
                int samples, const ScreenVertices& vertices, const TileLists& lists) {
  const int tiles_across = (viewport.width + kTileWidth - 1) / kTileWidth;
  Sorting sorting{
      *this, draw, piece, viewport, vertices, lists, reach_of(samples), static_cast<uint32_t>(tiles_across)};
  TriangleJob job{};
  job.indices = draw.mesh.indices.data();
  job.begin = piece.begin;
  job.end = piece.end;
  job.first_vertex = draw.first_vertex;
  job.vertex_count = static_cast<uint32_t>(draw.mesh.positions.size());
  job.points = vertices.points.data();
  job.mirrored = draw.placement.mirrored;
  job.two_sided = sorting.two_sided();
  job.width = viewport.width;
  job.height = viewport.height;
  job.reach = sorting.reach;
  job.tiles_across = tiles_across;
  job.small = draw.shading == Shading::kGouraud && !sorting.textured() ? small_.data() : nullptr;
  job.first_small = small_count_;
  job.tails = lists.tail.data();
  job.sink.take = [](void* context, const Survivor& survivor) {
    auto& own = *static_cast<Sorting*>(context);
    own.bins.take(own, survivor);
  };
  job.sink.extend = [](void* context, size_t tile) {
    const auto& own = *static_cast<Sorting*>(context);
    return own.bins.extend(own.lists, tile);
  };
  job.sink.context = &sorting;
  piece.stats = DrawStats{};
  piece.tiles = TileRect{};
  piece.stats.submitted = piece.end - piece.begin;
  const TriangleCounts counts = kernel.triangles(job);
  small_count_ += counts.appended;
  piece.stats.rejected += counts.rejected;
  piece.stats.drawn += counts.appended;
  piece.stats.culled = piece.stats.submitted - piece.stats.rejected - piece.stats.drawn;
  if (counts.first_tile_column <= counts.last_tile_column && counts.first_tile_row <= counts.last_tile_row) {
    piece.tiles.include(static_cast<int>(counts.first_tile_column), static_cast<int>(counts.first_tile_row),
                        static_cast<int>(counts.last_tile_column), static_cast<int>(counts.last_tile_row));
  }
}

void Bins::take(Sorting& sorting, const Survivor& survivor) {
  switch (survivor.route) {
    case Route::kSmall:
      if (sorting.textured()) return small_textured(sorting, survivor);
      ++sorting.piece.stats.drawn;
      small_[small_count_] = SmallTriangle{{survivor.corner[0], survivor.corner[1], survivor.corner[2]},
                                           colour_of(sorting.draw, sorting.corners(survivor))};
      return append(sorting, small_count_++, tiles_of(survivor.tiles, sorting.tiles_across));
    case Route::kLarge:
      return large(sorting, survivor);
    case Route::kCut:
      return cut(sorting, survivor);
  }
}

void Bins::large(Sorting& sorting, const Survivor& survivor) {
  Corner corner[3];
  for (size_t i = 0; i < 3; ++i)
    corner[i] = sorting.screen_corner(survivor.corner[i]);
  if (!sorting.shows(doubled_area(corner[0], corner[1], corner[2]))) return;
  if (sorting.textured()) set_coordinates(sorting, survivor, corner);
  const uint32_t colour = colour_of(sorting.draw, sorting.corners(survivor));
  if (add_general(sorting, corner[0], corner[1], corner[2], colour)) ++sorting.piece.stats.drawn;
}

void Bins::small_textured(Sorting& sorting, const Survivor& survivor) {
  Corner corner[3];
  for (size_t i = 0; i < 3; ++i)
    corner[i] = sorting.screen_corner(survivor.corner[i]);
  set_coordinates(sorting, survivor, corner);
  const uint32_t colour = colour_of(sorting.draw, sorting.corners(survivor));
  if (add_general(sorting, corner[0], corner[1], corner[2], colour, &survivor)) ++sorting.piece.stats.drawn;
}

void Bins::set_coordinates(const Sorting& sorting, const Survivor& survivor, Corner (&corner)[3]) {
  uint32_t number[3];
  for (size_t i = 0; i < 3; ++i)
    number[i] = survivor.corner[i] - sorting.draw.first_vertex;
  double coordinates[3][2];
  // Vertices whose coordinates are not finite have no place on the screen.
  if (!coordinates_of(sorting.draw.mesh.texture, number, coordinates)) return;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t axis = 0; axis < 2; ++axis)
      corner[i].coordinate[axis] = static_cast<float>(coordinates[i][axis]);
  }
}

// A triangle with area that takes the long path, or has a texture: `small` if it may take the short one, with its
// corners in order. False when no sample of the frame can be inside.
bool Bins::add_general(Sorting& sorting, const Corner& a, const Corner& b, const Corner& c, uint32_t colour,
                       const Survivor* small) {
  const auto floor_pixel = [](float sub_pixels) { return static_cast<int32_t>(sub_pixels) >> kSubPixelBits; };
  const auto before = static_cast<float>(kSubPixels / 2 - 1 - sorting.reach);
  const auto behind = static_cast<float>(sorting.reach - kSubPixels / 2);
  const int32_t first_column = floor_pixel(std::min({a.x, b.x, c.x}) + before);
  const int32_t last_column = floor_pixel(std::max({a.x, b.x, c.x}) + behind);
  const int32_t first_row = floor_pixel(std::min({a.y, b.y, c.y}) + before);
  const int32_t last_row = floor_pixel(std::max({a.y, b.y, c.y}) + behind);
  if (first_column > last_column || first_row > last_row || first_column >= sorting.viewport.width ||
      first_row >= sorting.viewport.height || last_column < 0 || last_row < 0) {
    return false;
  }
  const size_t place = general_.size();
  if (place >= (size_t{1} << kBinShift) - 1U) return false;  // Frame makes no group as large
  const bool in_order = doubled_area(a, b, c) > 0;
  const Corner corners[3] = {a, in_order ? b : c, in_order ? c : b};
  general_.emplace_back();
  GeneralTriangle& t = general_.back();
  if (sorting.textured()) {
    add_textured(sorting.draw, corners, colour, small, t);
  } else {
    set_up_general(corners[0], corners[1], corners[2], colour, t);
  }
  t.first_column = std::max(first_column, 0);
  t.last_column = std::min(last_column, sorting.viewport.width - 1);
  t.first_row = std::max(first_row, 0);
  t.last_row = std::min(last_row, sorting.viewport.height - 1);
  append(sorting, kGeneralTriangle | number_ << kBinShift | static_cast<uint32_t>(place),
         TileRect{t.first_column / kTileWidth, t.first_row / kTileHeight, t.last_column / kTileWidth,
                  t.last_row / kTileHeight});
  return true;
}

void Bins::add_textured(const RecordedDraw& draw, const Corner (&corners)[3], uint32_t colour, const Survivor* small,
                        GeneralTriangle& shape) {
  Corner lit[3] = {corners[0], corners[1], corners[2]};
  if (colour != kGouraudColour) {
    for (Corner& corner : lit) {
      corner.level[0] = static_cast<float>(red_of(colour));
      corner.level[1] = static_cast<float>(green_of(colour));
      corner.level[2] = static_cast<float>(blue_of(colour));
    }
  }
  const size_t place = textured_.size();
  textured_.emplace_back();
  TexturedTriangle& t = textured_.back();
  set_up_textured(lit[0], lit[1], lit[2], shape, t);
  shape.texture = static_cast<uint32_t>(place);
  dress(draw.mesh.texture, t);
  t.small = small != nullptr;
  for (size_t i = 0; i < 3 && small != nullptr; ++i)
    t.corner[i] = small->corner[i];
}

// A triangle with a corner that has no place on the screen: cut at the near, far and guard planes, drawn as a fan.
void Bins::cut(Sorting& sorting, const Survivor& survivor) {
  const RecordedDraw& draw = sorting.draw;
  DrawStats& stats = sorting.piece.stats;
  const uint32_t* corner = sorting.corners(survivor);
  ClipPolygon polygon;
  polygon.count = 3;
  uint32_t any = 0;
  uint32_t all = kInvisibleBits;
  for (size_t i = 0; i < 3; ++i) {
    const glm::vec3& position = draw.mesh.positions[corner[i]];
    const glm::vec4 clip = clip_position(draw.placement, position);
    uint32_t planes = planes_outside(sorting.viewport, clip);
    if (!finite(position)) planes |= kBroken;
    if (draw.shading == Shading::kGouraud && !finite(draw.mesh.normals[corner[i]])) planes |= kBroken;
    any |= planes;
    all &= planes;
    const ScreenValues& values = sorting.vertices.values[survivor.corner[i]];
    ClipVertex& to = polygon.corner[i];
    to.x = static_cast<double>(clip.x);
    to.y = static_cast<double>(clip.y);
    to.z = static_cast<double>(clip.z);
    to.w = static_cast<double>(clip.w);
    for (int channel = 0; channel < 3; ++channel)
      to.level[channel] = static_cast<double>(values.level[2 - channel]) / static_cast<double>(kLevelScale);
  }
  if (sorting.textured()) {
    double coordinates[3][2];
    if (!coordinates_of(draw.mesh.texture, corner, coordinates)) any |= kBroken;
    for (size_t i = 0; i < 3; ++i) {
      for (size_t axis = 0; axis < 2; ++axis)
        polygon.corner[i].coordinate[axis] = coordinates[i][axis];
    }
  }
  if ((any & kBroken) != 0U) {
    ++stats.rejected;
    return;
  }
  if (all != 0U) return;

  clip(polygon, sorting.viewport);
  std::array<Corner, 9> screen{};
  for (int i = 0; i < polygon.count; ++i) {
    const ClipVertex& v = polygon.corner[static_cast<size_t>(i)];
    Corner& to = screen[static_cast<size_t>(i)];
    const glm::vec4 clipped(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z),
                            static_cast<float>(v.w));
    if (!project(sorting.viewport, clipped, to)) {
      ++stats.rejected;
      return;
    }
    for (int channel = 0; channel < 3; ++channel)
      to.level[channel] = static_cast<float>(v.level[channel]);
    for (size_t axis = 0; axis < 2; ++axis)
      to.coordinate[axis] = static_cast<float>(v.coordinate[axis]);
  }
  ++stats.clipped;
  bool drawn = false;
  for (size_t i = 2; i < static_cast<size_t>(polygon.count); ++i) {
    if (!sorting.shows(doubled_area(screen[0], screen[i - 1], screen[i]))) continue;
    if (add_general(sorting, screen[0], screen[i - 1], screen[i], colour_of(draw, corner))) drawn = true;
  }
  if (drawn) ++stats.drawn;
}

void Bins::append(Sorting& sorting, uint32_t entry, const TileRect& tiles) {
  sorting.piece.tiles.include(tiles.x0, tiles.y0, tiles.x1, tiles.y1);
  for (int row = tiles.y0; row <= tiles.y1; ++row) {
    for (int column = tiles.x0; column <= tiles.x1; ++column) {
      const size_t tile = static_cast<size_t>(row) * sorting.tiles_across + static_cast<size_t>(column);
      uint32_t*& tail = sorting.lists.tail[tile];
      if (reinterpret_cast<uintptr_t>(tail) % sizeof(EntryBlock) == 0) extend(sorting.lists, tile);
      *tail++ = entry;
    }
  }
}

// Gives a tile's list a block more.
uint32_t* Bins::extend(const TileLists& lists, size_t tile) {
  const size_t page = blocks_ / kPage;
  if (page == pages_.size()) pages_.push_back(std::make_unique_for_overwrite<EntryBlock[]>(kPage));
  EntryBlock* block = &pages_[page][blocks_ % kPage];
  ++blocks_;
  block->next = nullptr;
  uint32_t*& tail = lists.tail[tile];
  // A tail that is not null stands behind the last entry of a full block.
  (tail == nullptr ? lists.head[tile] : reinterpret_cast<EntryBlock*>(tail)[-1].next) = block;
  tail = block->entry;
  return tail;
}

}  // namespace auslan::raster
