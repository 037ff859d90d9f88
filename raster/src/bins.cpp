// SPDX-License-Identifier: Apache-2.0
#include "bins.h"

#include "clip.h"
#include "lights.h"
#include "placement.h"

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
int64_t doubled_area(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
  const auto difference = [](float to, float from) { return static_cast<int64_t>(to - from); };
  return difference(b.x, a.x) * difference(c.y, a.y) - difference(c.x, a.x) * difference(b.y, a.y);
}

}  // namespace

void TileRect::include(int left, int top, int right, int bottom) {
  if (empty()) {
    *this = TileRect{left, top, right + 1, bottom + 1};
    return;
  }
  x0 = std::min(x0, left);
  y0 = std::min(y0, top);
  x1 = std::max(x1, right + 1);
  y1 = std::max(y1, bottom + 1);
}

// What the triangles of one piece have in common.
struct Bins::Sorting {
  const RecordedDraw& draw;
  Piece& piece;
  const Viewport& viewport;
  std::span<const ScreenVertex> vertices;
  const TileLists& lists;
  int32_t reach;
  int tiles_across;
};

void Bins::reset() noexcept {
  general_.clear();
  blocks_ = 0;
}

void Bins::sort(const KernelTable& kernel, const RecordedDraw& draw, Piece& piece, const Viewport& viewport,
                int samples, std::span<const ScreenVertex> vertices, const TileLists& lists) {
  survivors_.resize(kBatch);
  Sorting sorting{
      draw, piece, viewport, vertices, lists, reach_of(samples), (viewport.width + kTileSize - 1) / kTileSize};
  TriangleJob job{};
  job.indices = draw.mesh.indices.data();
  job.first_vertex = draw.first_vertex;
  job.vertex_count = static_cast<uint32_t>(draw.mesh.positions.size());
  job.vertices = vertices.data();
  job.mirrored = draw.placement.mirrored;
  job.two_sided = draw.cull == CullMode::kNone;
  job.width = viewport.width;
  job.height = viewport.height;
  job.reach = sorting.reach;
  job.out = survivors_.data();
  piece.stats = DrawStats{};
  piece.tiles = TileRect{};
  piece.stats.submitted = piece.end - piece.begin;
  for (size_t begin = piece.begin; begin < piece.end; begin += kBatch) {
    job.begin = begin;
    job.end = std::min(begin + kBatch, piece.end);
    const TriangleCounts counts = kernel.triangles(job);
    piece.stats.rejected += counts.rejected;
    for (const Survivor& survivor : std::span(survivors_).first(counts.survivors)) {
      switch (survivor.route) {
        case Route::kSmall:
          small(sorting, survivor);
          break;
        case Route::kLarge: {
          const ScreenVertex& a = vertices[survivor.corner[0]];
          const ScreenVertex& b = vertices[survivor.corner[1]];
          const ScreenVertex& c = vertices[survivor.corner[2]];
          const int64_t area = doubled_area(a, b, c);
          const bool front = (area < 0) != draw.placement.mirrored;
          if (area == 0 || (!front && !job.two_sided)) break;
          const uint32_t* corner = &draw.mesh.indices[3 * size_t{survivor.triangle}];
          const uint32_t colour = draw.shading == Shading::kFlat
                                      ? flat_colour(draw.mesh, corner, draw.placement, draw.lights)
                                      : kGouraudColour;
          if (large(sorting, a, b, c, colour)) ++piece.stats.drawn;
          break;
        }
        case Route::kCut:
          cut(sorting, survivor);
          break;
      }
    }
  }
  piece.stats.culled = piece.stats.submitted - piece.stats.rejected - piece.stats.drawn;
}

void Bins::small(Sorting& sorting, const Survivor& survivor) {
  const RecordedDraw& draw = sorting.draw;
  Entry entry{{survivor.corner[0], survivor.corner[1], survivor.corner[2]}, kGouraudColour};
  if (draw.shading == Shading::kFlat) {
    const uint32_t* corner = &draw.mesh.indices[3 * size_t{survivor.triangle}];
    entry.colour = flat_colour(draw.mesh, corner, draw.placement, draw.lights);
  }
  append(sorting, entry, survivor.first_column, survivor.last_column, survivor.first_row, survivor.last_row);
  ++sorting.piece.stats.drawn;
}

// A triangle with area that takes the long path. False when no sample of the frame can be inside.
bool Bins::large(Sorting& sorting, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                 uint32_t colour) {
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
  const bool in_order = doubled_area(a, b, c) > 0;
  const size_t place = general_.size();
  if (place >= (size_t{1} << kDeferredWorkerShift) - 1U) return false;
  general_.emplace_back();
  GeneralTriangle& t = general_.back();
  set_up_general(a, in_order ? b : c, in_order ? c : b, colour, t);
  t.first_column = std::max(first_column, 0);
  t.last_column = std::min(last_column, sorting.viewport.width - 1);
  t.first_row = std::max(first_row, 0);
  t.last_row = std::min(last_row, sorting.viewport.height - 1);
  append(sorting, Entry{{worker_, static_cast<uint32_t>(place), 0}, kGeneralEntry}, t.first_column, t.last_column,
         t.first_row, t.last_row);
  return true;
}

// A triangle with a corner that has no place on the screen: cut at the near, far and guard planes, drawn as a fan.
void Bins::cut(Sorting& sorting, const Survivor& survivor) {
  const RecordedDraw& draw = sorting.draw;
  DrawStats& stats = sorting.piece.stats;
  const uint32_t* corner = &draw.mesh.indices[3 * size_t{survivor.triangle}];
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
    const ScreenVertex& screen = sorting.vertices[survivor.corner[i]];
    ClipVertex& to = polygon.corner[i];
    to.x = static_cast<double>(clip.x);
    to.y = static_cast<double>(clip.y);
    to.z = static_cast<double>(clip.z);
    to.w = static_cast<double>(clip.w);
    for (int channel = 0; channel < 3; ++channel)
      to.level[channel] = static_cast<double>(screen.level[channel]);
  }
  if ((any & kBroken) != 0U) {
    ++stats.rejected;
    return;
  }
  if (all != 0U) return;

  clip(polygon, sorting.viewport);
  std::array<ScreenVertex, 9> screen{};
  for (int i = 0; i < polygon.count; ++i) {
    const ClipVertex& v = polygon.corner[static_cast<size_t>(i)];
    ScreenVertex& to = screen[static_cast<size_t>(i)];
    const glm::vec4 clipped(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z),
                            static_cast<float>(v.w));
    if (!project(sorting.viewport, clipped, to)) {
      ++stats.rejected;
      return;
    }
    for (int channel = 0; channel < 3; ++channel)
      to.level[channel] = static_cast<float>(v.level[channel]);
  }
  ++stats.clipped;
  bool drawn = false;
  for (size_t i = 2; i < static_cast<size_t>(polygon.count); ++i) {
    const int64_t area = doubled_area(screen[0], screen[i - 1], screen[i]);
    const bool front = (area < 0) != draw.placement.mirrored;
    if (area == 0 || (!front && draw.cull == CullMode::kBack)) continue;
    const uint32_t colour =
        draw.shading == Shading::kFlat ? flat_colour(draw.mesh, corner, draw.placement, draw.lights) : kGouraudColour;
    if (large(sorting, screen[0], screen[i - 1], screen[i], colour)) drawn = true;
  }
  if (drawn) ++stats.drawn;
}

void Bins::append(Sorting& sorting, const Entry& entry, int first_column, int last_column, int first_row,
                  int last_row) {
  const int left = std::max(first_column, 0) / kTileSize;
  const int right = std::min(last_column, sorting.viewport.width - 1) / kTileSize;
  const int top = std::max(first_row, 0) / kTileSize;
  const int bottom = std::min(last_row, sorting.viewport.height - 1) / kTileSize;
  sorting.piece.tiles.include(left, top, right, bottom);
  for (int row = top; row <= bottom; ++row) {
    for (int column = left; column <= right; ++column) {
      const auto tile = static_cast<size_t>(row * sorting.tiles_across + column);
      EntryBlock*& tail = sorting.lists.tail[tile];
      if (tail == nullptr || tail->count == EntryBlock::kCapacity) {
        EntryBlock* block = new_block();
        (tail == nullptr ? sorting.lists.head[tile] : tail->next) = block;
        tail = block;
      }
      tail->entry[tail->count++] = entry;
    }
  }
}

EntryBlock* Bins::new_block() {
  const size_t page = blocks_ / kPage;
  if (page == pages_.size()) pages_.push_back(std::make_unique_for_overwrite<EntryBlock[]>(kPage));
  EntryBlock* block = &pages_[page][blocks_ % kPage];
  ++blocks_;
  block->next = nullptr;
  block->count = 0;
  return block;
}

}  // namespace auslan::raster
