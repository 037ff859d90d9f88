// SPDX-License-Identifier: Apache-2.0
// One frame: what was recorded between begin_frame and end_frame, what is remembered of the last one, and the stages
// that turn the one into pixels and the other into a saving.
#pragma once

#include "bins.h"
#include "workers.h"

#include <array>
#include <memory>
#include <vector>

namespace auslan::raster {

class Frame {
 public:
  Frame(int threads, const KernelTable* kernel);

  bool has_kernel() const { return kernel_ != nullptr; }
  bool open() const { return open_; }
  size_t pixel_count() const;

  void begin(int width, int height, int samples, uint32_t background);
  void record(const MeshView& mesh, const glm::mat4& world_from_mesh, Shading shading, CullMode cull);
  void end(std::span<uint32_t> pixels, Canvas canvas);

  Camera camera;
  Lighting lighting;

  std::span<const PixelRect> damage() const { return damage_; }
  const DrawStats& stats() const { return stats_; }
  const StageTimes& times() const { return times_; }

 private:
  // Consecutive pieces of draws that one worker takes through the triangle stage into lists of their own.
  struct Group {
    size_t first_piece = 0, last_piece = 0;  ///< the latter not included
    bool changed = false;
  };

  void place_draws();
  void find_changes();
  void list_pieces();
  void process(bool changed);
  void transform(bool changed);
  void sort(bool changed);
  void mark_changed_tiles();
  void take_unchanged_draws();
  void fill(std::span<uint32_t> pixels);
  void fill_tile(uint32_t tile, int worker, std::span<uint32_t> pixels);
  bool has_entries(size_t tile) const;
  void list_damage();
  void add_up();

  const KernelTable* kernel_;
  std::unique_ptr<Workers> workers_;
  bool open_ = false;

  Viewport viewport_{};
  int samples_ = 1;
  uint32_t background_ = 0;
  int tiles_across_ = 0, tiles_down_ = 0;
  bool incremental_ = false;

  std::vector<RecordedDraw> draws_, last_draws_;
  size_t draw_count_ = 0, last_draw_count_ = 0;
  struct Kind {
    int width = 0, height = 0, samples = 0;
    uint32_t background = 0;
    bool operator==(const Kind&) const = default;
  };
  Kind last_kind_;  ///< of the frame that the canvas shows; width 0: none

  ScreenVertices vertices_;
  std::vector<Piece> vertex_pieces_, pieces_;
  std::vector<Group> groups_;
  std::vector<uint32_t> work_;      ///< numbers of pieces, groups or tiles that the stage in hand goes through
  std::vector<EntryBlock*> heads_;  ///< one a tile for each group
  std::vector<uint32_t*> tails_;    ///< theirs
  std::vector<Bins> bins_;          ///< one a group
  std::vector<const GeneralTriangle*> general_;
  std::vector<const TexturedTriangle*> textured_;
  std::vector<const SmallTriangle*> small_;
  std::vector<uint8_t> dirty_, shown_;  ///< a tile must be written; a tile showed something in the last frame

  struct Buffers {
    std::vector<uint32_t> colour;
    std::vector<float> depth;
    std::array<float, kCells> cell_least{}, cell_greatest{};
    std::array<uint32_t, kCells> cell_owner{};
    GeneralTriangle scratch{};
    std::vector<uint32_t> kept_colour;
    std::vector<float> kept_depth;
  };
  std::vector<Buffers> buffers_;  ///< one a worker

  std::vector<PixelRect> damage_;
  DrawStats stats_;
  StageTimes times_;
};

}  // namespace auslan::raster
