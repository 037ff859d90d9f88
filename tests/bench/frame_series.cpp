// SPDX-License-Identifier: Apache-2.0
#include "frame_series.h"

#include "raster/image.h"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <iterator>

namespace auslan::bench {

std::optional<Redraw> redraw_of(std::string_view name) {
  for (size_t i = 0; i < std::size(kRedrawNames); ++i)
    if (kRedrawNames[i] == name) return static_cast<Redraw>(i);
  return std::nullopt;
}

std::optional<raster::Kernel> kernel_of(std::string_view name) {
  for (const raster::Kernel kernel : raster::runnable_kernels())
    if (raster::name_of(kernel) == name) return kernel;
  return std::nullopt;
}

std::vector<Size> sizes_of(const std::string& scene) {
  if (scene.starts_with("signer")) return {{640, 480}, {1280, 720}, {1920, 1080}};
  return {{1920, 1080}};
}

FrameSeries::FrameSeries(const Scene& scene, const SeriesOptions& options)
    : scene_(&scene),
      options_(options),
      renderer_(options.threads, options.kernel),
      pixels_(raster::pixel_count(options.width, options.height)) {}

FrameTime FrameSeries::draw() {
  using enum Redraw;
  const bool says_what_moved = options_.redraw == kArm || options_.redraw == kStill;
  const bool moved = options_.redraw == kArm && frame_ % 2 == 1;
  const raster::Canvas canvas =
      options_.redraw == kFull || frame_ == 0 ? raster::Canvas::kUnknown : raster::Canvas::kLastFrame;
  ++frame_;
  raster::Status status = raster::Status::kOk;
  const FrameTime time = time_frame([&] {
    status = renderer_.begin_frame(options_.width, options_.height, options_.samples, scene_->background);
    if (status != raster::Status::kOk) return;
    draw_scene(renderer_, *scene_, options_.width, options_.height, moved, says_what_moved ? 1 : 0);
    status = renderer_.end_frame(pixels_, canvas);
  });
  if (status != raster::Status::kOk) {
    std::fprintf(stderr, "%s: the rasteriser answers with status %d\n", scene_->name.c_str(), static_cast<int>(status));
    std::exit(1);
  }
  return time;
}

}  // namespace auslan::bench
