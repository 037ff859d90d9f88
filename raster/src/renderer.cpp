// SPDX-License-Identifier: Apache-2.0
#include "raster/renderer.h"

#include "fill.h"
#include "frame.h"

#include <algorithm>

namespace auslan::raster {

struct Renderer::State {
  Frame frame;
  Band band;
  std::vector<uint32_t> first_of_band;  ///< position in by_band of the first triangle that starts in each band
  std::vector<uint32_t> by_band;        ///< triangles, by the band they start in, then in drawing order
  std::vector<uint32_t> active;         ///< triangles that reach into the current band, in drawing order
  std::vector<uint32_t> next_active;
};

namespace {

size_t band_of(const TriangleRecord& triangle) {
  return static_cast<size_t>(triangle.first_row / kBandRows);
}

}  // namespace

Renderer::Renderer() : state_(std::make_unique<State>()) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Status Renderer::begin_frame(int width, int height, int samples, uint32_t background) {
  Frame& frame = state_->frame;
  if (width < 1 || width > kMaxImageSize || height < 1 || height > kMaxImageSize) return Status::kBadSize;
  if (samples != 1 && samples != 2 && samples != 4 && samples != 8) return Status::kBadSamples;
  frame.viewport = make_viewport(width, height);
  frame.samples = samples;
  frame.background = background & 0xFFFFFFU;
  frame.open = true;
  frame.stats = DrawStats{};
  frame.vertices.clear();
  frame.triangles.clear();
  return Status::kOk;
}

void Renderer::set_camera(const Camera& camera) noexcept {
  state_->frame.camera = camera;
}

void Renderer::set_lighting(const Lighting& lighting) noexcept {
  state_->frame.lights = prepare(lighting);
}

void Renderer::draw(const MeshView& mesh, const glm::mat4& world_from_mesh, Shading shading, CullMode cull) {
  if (state_->frame.open) draw_mesh(state_->frame, mesh, world_from_mesh, shading, cull);
}

Status Renderer::end_frame(std::span<uint32_t> pixels) {
  State& state = *state_;
  Frame& frame = state.frame;
  if (!frame.open) return Status::kNoFrame;
  const int width = frame.viewport.width;
  const int height = frame.viewport.height;
  if (pixels.size() != pixel_count(width, height)) return Status::kBadSize;
  frame.open = false;

  // Sort the triangles by the band they start in; counting keeps them in drawing order within a band.
  const auto band_count = static_cast<size_t>((height + kBandRows - 1) / kBandRows);
  state.first_of_band.assign(band_count + 1, 0);
  for (const TriangleRecord& triangle : frame.triangles)
    ++state.first_of_band[band_of(triangle) + 1];
  for (size_t band = 0; band < band_count; ++band)
    state.first_of_band[band + 1] += state.first_of_band[band];
  state.by_band.resize(frame.triangles.size());
  for (size_t i = 0; i < frame.triangles.size(); ++i) {
    uint32_t& position = state.first_of_band[band_of(frame.triangles[i])];
    state.by_band[position] = static_cast<uint32_t>(i);
    ++position;
  }
  // Each entry now holds the end of its band, which is where the next one starts.

  Band& band = state.band;
  band.width = width;
  state.active.clear();
  // The two lists take turns, so both need the room that either may come to need.
  state.active.reserve(frame.triangles.size());
  state.next_active.reserve(frame.triangles.size());
  const auto samples = static_cast<size_t>(frame.samples);
  uint32_t begin = 0;
  for (size_t number = 0; number < band_count; ++number) {
    band.first_row = static_cast<int>(number) * kBandRows;
    band.row_count = std::min(kBandRows, height - band.first_row);
    const std::span<uint32_t> out = pixels.subspan(static_cast<size_t>(band.first_row) * static_cast<size_t>(width),
                                                   pixel_count(width, band.row_count));

    // The triangles that still reach down here, merged in drawing order with those that start here.
    const uint32_t end = state.first_of_band[number];
    state.next_active.clear();
    uint32_t entering = begin;
    for (const uint32_t index : state.active) {
      if (frame.triangles[index].last_row < band.first_row) continue;
      while (entering < end && state.by_band[entering] < index)
        state.next_active.push_back(state.by_band[entering++]);
      state.next_active.push_back(index);
    }
    while (entering < end)
      state.next_active.push_back(state.by_band[entering++]);
    std::swap(state.active, state.next_active);
    begin = end;

    if (state.active.empty()) {
      std::fill(out.begin(), out.end(), frame.background);
      continue;
    }
    band.colour.assign(out.size() * samples, frame.background);
    band.depth.assign(out.size() * samples, 0.0F);
    for (const uint32_t index : state.active)
      fill(band, frame.samples, frame.triangles[index], frame.vertices);
    resolve(band.colour, frame.samples, out);
  }
  return Status::kOk;
}

const DrawStats& Renderer::stats() const noexcept {
  return state_->frame.stats;
}

}  // namespace auslan::raster
