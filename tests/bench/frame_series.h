// SPDX-License-Identifier: Apache-2.0
// Frames of a scene through the rasteriser, one after the other, as a program that shows them would ask for them.
#pragma once

#include "frame_clock.h"
#include "scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace auslan::bench {

/// What a frame has to draw anew.
enum class Redraw {
  kFull,   ///< everything, every pixel written: nothing is known of what the canvas holds
  kClean,  ///< everything, but tiles of bare background that were so before are left alone
  kArm,    ///< one arm moved, and the program says that nothing else did
  kStill,  ///< nothing moved, and the program says so
};
inline constexpr std::string_view kRedrawNames[] = {"full", "clean", "arm", "still"};
std::optional<Redraw> redraw_of(std::string_view name);

struct SeriesOptions {
  int width = 1280;
  int height = 720;
  int samples = 1;
  raster::Kernel kernel = raster::Kernel::kScalar;
  int threads = 1;
  Redraw redraw = Redraw::kClean;
};

/// Signers are drawn at three sizes, everything else was made for one.
struct Size {
  int width;
  int height;
};
std::vector<Size> sizes_of(const std::string& scene);

class FrameSeries {
 public:
  /// The scene must outlive it.
  FrameSeries(const Scene& scene, const SeriesOptions& options);

  /// Draws the next frame. Ends the program with a message when the rasteriser refuses it.
  FrameTime draw();

  const raster::Renderer& renderer() const { return renderer_; }
  const std::vector<uint32_t>& pixels() const { return pixels_; }

 private:
  const Scene* scene_;
  SeriesOptions options_;
  raster::Renderer renderer_;
  std::vector<uint32_t> pixels_;
  int frame_ = 0;
};

std::optional<raster::Kernel> kernel_of(std::string_view name);

}  // namespace auslan::bench
