// SPDX-License-Identifier: Apache-2.0
#include "frame.h"

#include "lights.h"
#include "placement.h"
#include "texture_data.h"
#include "textured.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

namespace auslan::raster {
namespace {

// Work is handed out in pieces of about this many vertices or triangles.
constexpr size_t kPieceSize = 2048;
// Fewer triangles than this are not worth a thread's waking.
constexpr size_t kLeastGroup = 16;
// Of a frame. Each group of triangles has a bin of its own, and there are no more bins than a deferred colour can name.
constexpr uint64_t kMostTriangles = uint64_t{1} << 27U;
constexpr uint64_t kMostVertices = uint64_t{1} << 30U;
static_assert(std::max(kMostTriangles / (Bins::kMostTriangles - kPieceSize) + 1U, uint64_t{kMaxThreads}) +
                  Bins::kMost / 2 <
              Bins::kMost);
static_assert(kMostVertices / kPieceSize <= Workers::kMostItems);

template <class Value>
bool same_bytes(const Value& a, const Value& b) {
  return std::memcmp(&a, &b, sizeof(Value)) == 0;
}

template <class Element>
bool same_span(std::span<const Element> a, std::span<const Element> b) {
  return a.data() == b.data() && a.size() == b.size();
}

bool same_texture(const RecordedDraw& a, const RecordedDraw& b) {
  const TextureUse& use = a.mesh.texture;
  const TextureUse& other = b.mesh.texture;
  return a.texture_serial == b.texture_serial && same_span(use.coordinates, other.coordinates) &&
         use.wrap_u == other.wrap_u && use.wrap_v == other.wrap_v && use.alpha == other.alpha &&
         use.alpha_cutoff == other.alpha_cutoff;
}

bool looks_alike(const RecordedDraw& a, const RecordedDraw& b) {
  return a.mesh.revision != 0 && a.mesh.revision == b.mesh.revision && a.shading == b.shading && a.cull == b.cull &&
         same_span(a.mesh.positions, b.mesh.positions) && same_span(a.mesh.normals, b.mesh.normals) &&
         same_span(a.mesh.colours, b.mesh.colours) && same_span(a.mesh.indices, b.mesh.indices) &&
         same_bytes(a.world_from_mesh, b.world_from_mesh) && same_bytes(a.camera, b.camera) &&
         same_bytes(a.lighting, b.lighting) && same_texture(a, b);
}

// A vector that only grows: what is in it is written before it is read, and shrinking would clear it on the way back.
template <class Element>
void grow(std::vector<Element>& vector, size_t size) {
  if (vector.size() < size) vector.resize(size);
}

class Clock {
 public:
  int64_t lap() {
    const auto now = std::chrono::steady_clock::now();
    const int64_t passed = std::chrono::duration_cast<std::chrono::nanoseconds>(now - begun_).count();
    begun_ = now;
    return passed;
  }

 private:
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

}  // namespace

Frame::Frame(int threads, const KernelTable* kernel)
    : kernel_(kernel), workers_(std::make_unique<Workers>(std::clamp(threads, 1, kMaxThreads))) {
  const auto count = static_cast<size_t>(workers_->count());
  buffers_.resize(count);
}

size_t Frame::pixel_count() const {
  return raster::pixel_count(viewport_.width, viewport_.height);
}

void Frame::begin(int width, int height, int samples, uint32_t background) {
  viewport_ = make_viewport(width, height);
  samples_ = samples;
  background_ = background & 0xFFFFFFU;
  tiles_across_ = (width + kTileWidth - 1) / kTileWidth;
  tiles_down_ = (height + kTileHeight - 1) / kTileHeight;
  draw_count_ = 0;
  open_ = true;
}

void Frame::record(const MeshView& mesh, const glm::mat4& world_from_mesh, Shading shading, CullMode cull) {
  grow(draws_, draw_count_ + 1);
  RecordedDraw& draw = draws_[draw_count_++];
  draw = RecordedDraw{};
  draw.mesh = mesh;
  if (mesh.texture.texture != nullptr && mesh.texture.texture->data() != nullptr)
    draw.texture_serial = mesh.texture.texture->data()->serial;
  draw.world_from_mesh = world_from_mesh;
  draw.camera = camera;
  draw.lighting = lighting;
  draw.shading = shading;
  draw.cull = cull;
}

void Frame::end(std::span<uint32_t> pixels, Canvas canvas) {
  const Kind kind{viewport_.width, viewport_.height, samples_, background_};
  const auto tiles = static_cast<size_t>(tiles_across_) * static_cast<size_t>(tiles_down_);
  incremental_ = canvas == Canvas::kLastFrame && kind == last_kind_;
  times_ = StageTimes{};
  if (!incremental_) {
    last_draw_count_ = 0;
    shown_.assign(tiles, 0);
  }
  dirty_.assign(tiles, incremental_ ? uint8_t{0} : uint8_t{1});

  place_draws();
  find_changes();
  list_pieces();
  process(true);
  if (incremental_) {
    mark_changed_tiles();
    take_unchanged_draws();
    process(false);
  }
  fill(pixels);
  list_damage();
  add_up();

  grow(last_draws_, draws_.size());  // the two take turns, so both need the room
  std::swap(draws_, last_draws_);
  last_draw_count_ = draw_count_;
  last_kind_ = kind;
  open_ = false;
}

// Refuses draws as wholes and gives each a place for its vertices.
void Frame::place_draws() {
  uint64_t vertices = 0;
  uint64_t triangles = 0;
  for (RecordedDraw& draw : std::span(draws_).first(draw_count_)) {
    const MeshView& mesh = draw.mesh;
    const size_t count = mesh.positions.size();
    const bool normals_fit = mesh.normals.size() == count || (draw.shading == Shading::kFlat && mesh.normals.empty());
    const TextureUse& use = mesh.texture;
    const bool texture_fits = use.texture == nullptr || (draw.texture_serial != 0 && use.coordinates.size() == count &&
                                                         std::isfinite(use.alpha_cutoff));
    draw.good = normals_fit && texture_fits && mesh.colours.size() == count && mesh.indices.size() >= 3 &&
                finite(draw.world_from_mesh) && finite(draw.camera.clip_from_view) &&
                finite(draw.camera.view_from_world) && count > 0 && vertices + count <= kMostVertices &&
                triangles + mesh.indices.size() / 3 <= kMostTriangles;
    if (!draw.good) continue;
    triangles += mesh.indices.size() / 3;
    draw.first_vertex = static_cast<uint32_t>(vertices);
    vertices += count;
  }
  grow(vertices_.points, vertices);
  grow(vertices_.values, vertices);
}

void Frame::find_changes() {
  size_t runs = 0;
  for (size_t i = 0; i < draw_count_; ++i) {
    RecordedDraw& draw = draws_[i];
    draw.changed = !incremental_ || i >= last_draw_count_ || !looks_alike(draw, last_draws_[i]);
    if (i == 0 || draw.changed != draws_[i - 1].changed) ++runs;
    if (!draw.changed) {
      draw.stats = last_draws_[i].stats;
      draw.tiles = last_draws_[i].tiles;
    }
  }
  // Each run of draws that have or have not changed needs a bin of its own (list_pieces); beyond that there is no
  // saving.
  for (RecordedDraw& draw : std::span(draws_).first(draw_count_)) {
    if (runs > Bins::kMost / 2) draw.changed = true;
    draw.processed = draw.changed;
  }
}

// Cuts the draws into pieces and gathers these into groups: one for each run of draws that have or have not changed,
// and as many as there are threads to share them.
void Frame::list_pieces() {
  vertex_pieces_.clear();
  pieces_.clear();
  groups_.clear();
  size_t all = 0;
  for (const RecordedDraw& draw : std::span(draws_).first(draw_count_))
    all += draw.good ? draw.mesh.indices.size() / 3 : 0;
  const auto workers = static_cast<size_t>(workers_->count());
  // Each group has a list a tile: more of them than threads cost the tiles more than a better balance spares.
  const size_t shared = workers == 1 ? all : std::max((all + workers - 1) / workers, kLeastGroup);
  const size_t group_size = std::clamp(shared, size_t{1}, Bins::kMostTriangles - kPieceSize);
  const size_t piece_size = std::min(kPieceSize, group_size);
  size_t in_group = 0;
  for (size_t i = 0; i < draw_count_; ++i) {
    const RecordedDraw& draw = draws_[i];
    if (!draw.good) continue;
    const auto number = static_cast<uint32_t>(i);
    const size_t vertices = draw.mesh.positions.size();
    for (size_t begin = 0; begin < vertices; begin += kPieceSize)
      vertex_pieces_.push_back(Piece{number, begin, std::min(begin + kPieceSize, vertices), {}, {}});
    const size_t triangles = draw.mesh.indices.size() / 3;
    for (size_t begin = 0; begin < triangles; begin += piece_size) {
      const size_t end = std::min(begin + piece_size, triangles);
      if (groups_.empty() || groups_.back().changed != draw.changed || in_group >= group_size) {
        groups_.push_back(Group{pieces_.size(), pieces_.size(), draw.changed});
        in_group = 0;
      }
      pieces_.push_back(Piece{number, begin, end, {}, {}});
      groups_.back().last_piece = pieces_.size();
      in_group += end - begin;
    }
  }
  while (bins_.size() < groups_.size())
    bins_.emplace_back(static_cast<uint32_t>(bins_.size()));
  heads_.assign(groups_.size() * dirty_.size(), nullptr);
  tails_.assign(groups_.size() * dirty_.size(), nullptr);
}

// Takes the changed draws, or those of the others that were asked for, through the first two stages.
void Frame::process(bool changed) {
  Clock clock;
  for (RecordedDraw& draw : std::span(draws_).first(draw_count_)) {
    if (!draw.good || draw.changed != changed || !draw.processed) continue;
    draw.placement = place(draw.camera, draw.world_from_mesh);
    draw.lights = prepare(draw.lighting);
    draw.stats = DrawStats{};
    draw.tiles = TileRect{};
  }
  transform(changed);
  times_.vertices += clock.lap();
  sort(changed);
  times_.triangles += clock.lap();
}

void Frame::transform(bool changed) {
  work_.clear();
  for (size_t i = 0; i < vertex_pieces_.size(); ++i) {
    const RecordedDraw& draw = draws_[vertex_pieces_[i].draw];
    if (draw.changed == changed && draw.processed) work_.push_back(static_cast<uint32_t>(i));
  }
  auto work = [this](uint32_t item, int) {
    const Piece& piece = vertex_pieces_[work_[item]];
    const RecordedDraw& draw = draws_[piece.draw];
    VertexJob job{};
    job.positions = &draw.mesh.positions[0].x;
    job.normals = draw.shading == Shading::kFlat ? nullptr : &draw.mesh.normals[0].x;
    job.colours = &draw.mesh.colours[0].x;
    job.begin = piece.begin;
    job.end = piece.end;
    job.placement = &draw.placement;
    job.lights = &draw.lights;
    job.viewport = &viewport_;
    job.points = &vertices_.points[draw.first_vertex];
    job.values = &vertices_.values[draw.first_vertex];
    kernel_->vertices(job);
    if (draw.texture_serial == 0) return;
    for (size_t i = piece.begin; i < piece.end; ++i) {
      if (!finite(draw.mesh.texture.coordinates[i])) job.points[i].x = kOutside;
    }
  };
  workers_->share(static_cast<uint32_t>(work_.size()), work);
}

void Frame::sort(bool changed) {
  work_.clear();
  for (size_t i = 0; i < groups_.size(); ++i) {
    if (groups_[i].changed == changed) work_.push_back(static_cast<uint32_t>(i));
  }
  const size_t tiles = dirty_.size();
  auto work = [this, tiles](uint32_t item, int) {
    const Group& group = groups_[work_[item]];
    Bins& bins = bins_[work_[item]];
    size_t triangles = 0;
    for (size_t i = group.first_piece; i < group.last_piece; ++i)
      triangles += pieces_[i].end - pieces_[i].begin;
    bins.reset(triangles);
    const size_t first = work_[item] * tiles;
    const TileLists lists{std::span(heads_).subspan(first, tiles), std::span(tails_).subspan(first, tiles)};
    for (size_t i = group.first_piece; i < group.last_piece; ++i) {
      const RecordedDraw& draw = draws_[pieces_[i].draw];
      if (!draw.processed) continue;
      bins.sort(*kernel_, draw, pieces_[i], viewport_, samples_, vertices_, lists);
    }
  };
  workers_->share(static_cast<uint32_t>(work_.size()), work);
  for (const Piece& piece : pieces_) {
    RecordedDraw& draw = draws_[piece.draw];
    if (draw.changed != changed || !draw.processed) continue;
    draw.stats.submitted += piece.stats.submitted;
    draw.stats.rejected += piece.stats.rejected;
    draw.stats.culled += piece.stats.culled;
    draw.stats.drawn += piece.stats.drawn;
    draw.stats.clipped += piece.stats.clipped;
    if (!piece.tiles.empty()) draw.tiles.include(piece.tiles.x0, piece.tiles.y0, piece.tiles.x1, piece.tiles.y1);
  }
}

// Tiles that a changed draw has left or has come to.
void Frame::mark_changed_tiles() {
  for (size_t i = 0; i < last_draw_count_; ++i) {
    if (i < draw_count_ && !draws_[i].changed) continue;
    const TileRect& tiles = last_draws_[i].tiles;
    for (int row = tiles.y0; row <= tiles.y1; ++row) {
      for (int column = tiles.x0; column <= tiles.x1; ++column) {
        const auto tile = static_cast<size_t>(row * tiles_across_ + column);
        if (shown_[tile] != 0) dirty_[tile] = 1;
      }
    }
  }
  for (size_t tile = 0; tile < dirty_.size(); ++tile) {
    if (dirty_[tile] == 0 && has_entries(tile)) dirty_[tile] = 1;
  }
}

// The unchanged draws that show in a tile that must be written.
void Frame::take_unchanged_draws() {
  for (RecordedDraw& draw : std::span(draws_).first(draw_count_)) {
    if (!draw.good || draw.changed) continue;
    const TileRect& tiles = draw.tiles;
    for (int row = tiles.y0; row <= tiles.y1 && !draw.processed; ++row) {
      const auto across = std::span(dirty_).subspan(static_cast<size_t>(row * tiles_across_ + tiles.x0),
                                                    static_cast<size_t>(tiles.x1 - tiles.x0 + 1));
      draw.processed = std::find(across.begin(), across.end(), uint8_t{1}) != across.end();
    }
  }
}

bool Frame::has_entries(size_t tile) const {
  for (size_t list = tile; list < heads_.size(); list += dirty_.size()) {
    if (heads_[list] != nullptr) return true;
  }
  return false;
}

void Frame::fill(std::span<uint32_t> pixels) {
  Clock clock;
  work_.clear();
  for (size_t tile = 0; tile < dirty_.size(); ++tile) {
    if (dirty_[tile] != 0) work_.push_back(static_cast<uint32_t>(tile));
  }
  general_.clear();
  small_.clear();
  for (const Bins& bins : bins_) {
    general_.push_back(bins.general());
    small_.push_back(bins.small());
  }
  textured_.clear();
  for (const Bins& bins : bins_)
    textured_.push_back(bins.textured());
  const auto drawn = std::span(draws_).first(draw_count_);
  const bool masked = std::any_of(drawn.begin(), drawn.end(), [](const RecordedDraw& draw) {
    return draw.texture_serial != 0 && draw.mesh.texture.alpha == AlphaMode::kMask;
  });
  for (Buffers& buffers : buffers_) {
    const auto words = static_cast<size_t>(kTileStride) * kTileRows * static_cast<size_t>(samples_);
    grow(buffers.colour, words);
    grow(buffers.depth, words);
    if (!masked) continue;
    grow(buffers.kept_colour, words);
    grow(buffers.kept_depth, words);
  }
  auto work = [this, pixels](uint32_t item, int worker) { fill_tile(work_[item], worker, pixels); };
  workers_->share(static_cast<uint32_t>(work_.size()), work);
  times_.tiles = clock.lap();
}

void Frame::fill_tile(uint32_t tile, int worker, std::span<uint32_t> pixels) {
  TileJob job{};
  job.x = static_cast<int>(tile) % tiles_across_ * kTileWidth;
  job.y = static_cast<int>(tile) / tiles_across_ * kTileHeight;
  job.width = std::min(kTileWidth, viewport_.width - job.x);
  job.height = std::min(kTileHeight, viewport_.height - job.y);
  job.background = background_;
  job.pixel_stride = static_cast<size_t>(viewport_.width);
  job.pixels = &pixels[static_cast<size_t>(job.y) * job.pixel_stride + static_cast<size_t>(job.x)];
  const bool any = has_entries(tile);
  shown_[tile] = any ? 1 : 0;
  if (!any) {
    for (int row = 0; row < job.height; ++row)
      std::fill_n(job.pixels + static_cast<size_t>(row) * job.pixel_stride, job.width, background_);
    return;
  }
  Buffers& buffers = buffers_[static_cast<size_t>(worker)];
  job.lists = &heads_[tile];
  job.tails = &tails_[tile];
  job.small = small_.data();
  job.list_stride = dirty_.size();
  job.list_count = groups_.size();
  job.points = vertices_.points.data();
  job.values = vertices_.values.data();
  job.general = general_.data();
  job.textured = textured_.data();
  const size_t margin = (size_t{kTileStride} + kTileMargin) * static_cast<size_t>(samples_);
  const bool keeps = !buffers.kept_colour.empty();
  job.buffers = TileBuffers{&buffers.colour[margin],
                            &buffers.depth[margin],
                            buffers.cell_least.data(),
                            buffers.cell_greatest.data(),
                            buffers.cell_owner.data(),
                            &buffers.scratch,
                            keeps ? buffers.kept_colour.data() + margin : nullptr,
                            keeps ? buffers.kept_depth.data() + margin : nullptr};
  job.pixel_stride = static_cast<size_t>(viewport_.width);
  kernel_->tile[samples_ == 1 ? 0 : samples_ == 2 ? 1 : samples_ == 4 ? 2 : 3](job);
}

// Dirty tiles side by side become one rectangle, and equal ones below each other too.
void Frame::list_damage() {
  damage_.clear();
  for (int row = 0; row < tiles_down_; ++row) {
    for (int column = 0; column < tiles_across_; ++column) {
      const auto is_dirty = [&](int c) { return dirty_[static_cast<size_t>(row * tiles_across_ + c)] != 0; };
      if (!is_dirty(column)) continue;
      const int first = column;
      while (column < tiles_across_ && is_dirty(column))
        ++column;
      PixelRect rect;
      rect.x = first * kTileWidth;
      rect.y = row * kTileHeight;
      rect.width = std::min(column * kTileWidth, viewport_.width) - rect.x;
      rect.height = std::min(rect.y + kTileHeight, viewport_.height) - rect.y;
      const auto above = std::find_if(damage_.begin(), damage_.end(), [&rect](const PixelRect& other) {
        return other.x == rect.x && other.width == rect.width && other.y + other.height == rect.y;
      });
      if (above != damage_.end()) {
        above->height += rect.height;
      } else {
        damage_.push_back(rect);
      }
    }
  }
}

void Frame::add_up() {
  stats_ = DrawStats{};
  for (RecordedDraw& draw : std::span(draws_).first(draw_count_)) {
    const size_t whole = draw.mesh.indices.size() / 3;
    const size_t left_over = draw.mesh.indices.size() % 3 != 0 ? 1 : 0;
    if (!draw.good) draw.stats = DrawStats{whole, whole, 0, 0, 0};
    stats_.submitted += draw.stats.submitted + left_over;
    stats_.rejected += draw.stats.rejected + left_over;
    stats_.culled += draw.stats.culled;
    stats_.drawn += draw.stats.drawn;
    stats_.clipped += draw.stats.clipped;
  }
}

}  // namespace auslan::raster
