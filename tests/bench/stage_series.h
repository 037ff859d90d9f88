// SPDX-License-Identifier: Apache-2.0
// The program's own frames: the shipped signer while it signs a sentence, through the stage.
#pragma once

#include "frame_clock.h"
#include "stage/stage.h"
#include "synthesis/performance.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace auslan::bench {

/// What the figure is drawn with.
enum class FigureForm {
  kDefault,  ///< as the programs draw it: joints that bend the skin, and a shadow
  kPlain,    ///< rigid segments and no shadow, one sample a pixel whatever was asked for
};
inline constexpr std::string_view kFigureFormNames[] = {"figure", "figure_plain"};
std::optional<FigureForm> figure_form_of(std::string_view name);

struct StageSeriesOptions {
  FigureForm form = FigureForm::kDefault;
  int width = 1280;
  int height = 720;
  int samples = 4;
  raster::Kernel kernel = raster::Kernel::kScalar;
  int threads = 1;
  bool every_pixel = false;  ///< nothing is known of what the canvas holds; else only what changed is drawn
};

/// 25 frames a second of HELLO WHERE HURT, again from the start after its end. A frame is all from the score to the
/// pixels: the pose is sampled, the figure posed, the shadow thrown, the picture drawn.
class StageSeries {
 public:
  /// Ends the program with a message when the stage refuses the options.
  explicit StageSeries(const StageSeriesOptions& options);

  FrameTime draw();

  uint64_t triangle_count() const { return stage_.stats().submitted; }
  const std::vector<uint32_t>& pixels() const { return pixels_; }

 private:
  Performance performance_;
  Stage stage_;
  raster::Canvas canvas_;
  Pose pose_;
  std::vector<uint32_t> pixels_;
  Tick now_ = 0;
};

}  // namespace auslan::bench
