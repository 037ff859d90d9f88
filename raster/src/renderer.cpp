// SPDX-License-Identifier: Apache-2.0
#include "raster/renderer.h"

#include "frame.h"
#include "kernel_choice.h"

namespace auslan::raster {

struct Renderer::State : Frame {
  using Frame::Frame;
};

Renderer::Renderer(int threads) {
  const std::optional<Kernel> kernel = chosen_kernel();
  state_ = std::make_unique<State>(threads, kernel ? table_of(*kernel) : nullptr);
}
Renderer::Renderer(int threads, Kernel kernel) : state_(std::make_unique<State>(threads, table_of(kernel))) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Status Renderer::begin_frame(int width, int height, int samples, uint32_t background) {
  if (width < 1 || width > kMaxImageSize || height < 1 || height > kMaxImageSize) return Status::kBadSize;
  if (samples != 1 && samples != 2 && samples != 4 && samples != 8) return Status::kBadSamples;
  if (!state_->has_kernel()) return Status::kBadKernel;
  state_->begin(width, height, samples, background);
  return Status::kOk;
}

void Renderer::set_camera(const Camera& camera) noexcept {
  state_->camera = camera;
}

void Renderer::set_lighting(const Lighting& lighting) noexcept {
  state_->lighting = lighting;
}

void Renderer::draw(const MeshView& mesh, const glm::mat4& world_from_mesh, Shading shading, CullMode cull) {
  if (state_->open()) state_->record(mesh, world_from_mesh, shading, cull);
}

Status Renderer::end_frame(std::span<uint32_t> pixels, Canvas canvas) {
  if (!state_->open()) return Status::kNoFrame;
  if (pixels.size() != state_->pixel_count()) return Status::kBadSize;
  state_->end(pixels, canvas);
  return Status::kOk;
}

std::span<const PixelRect> Renderer::damage() const noexcept {
  return state_->damage();
}

const DrawStats& Renderer::stats() const noexcept {
  return state_->stats();
}

const StageTimes& Renderer::times() const noexcept {
  return state_->times();
}

}  // namespace auslan::raster
