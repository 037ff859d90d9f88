// SPDX-License-Identifier: Apache-2.0
#include "stage_series.h"

#include "shipped.h"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <utility>

namespace auslan::bench {
namespace {

Stage build_stage(const StageSeriesOptions& options) {
  StageOptions form;
  form.width = options.width;
  form.height = options.height;
  form.samples = options.samples;
  form.kernel = options.kernel;
  form.threads = options.threads;
  if (options.form == FigureForm::kPlain) {
    form.samples = 1;
    form.rigid = true;
    form.shadow = false;
  }
  auto stage = Stage::build(shipped().figure, form);
  if (!stage) {
    std::fprintf(stderr, "stage: %s\n", stage.error().message.c_str());
    std::exit(1);
  }
  return std::move(*stage);
}

}  // namespace

std::optional<FigureForm> figure_form_of(std::string_view name) {
  for (size_t i = 0; i < std::size(kFigureFormNames); ++i)
    if (kFigureFormNames[i] == name) return static_cast<FigureForm>(i);
  return std::nullopt;
}

StageSeries::StageSeries(const StageSeriesOptions& options)
    : performance_(*shipped().signer, score_of({"HELLO", "WHERE", "HURT"})),
      stage_(build_stage(options)),
      canvas_(options.every_pixel ? raster::Canvas::kUnknown : raster::Canvas::kLastFrame),
      pixels_(static_cast<size_t>(options.width) * static_cast<size_t>(options.height)) {}

FrameTime StageSeries::draw() {
  const FrameTime time = time_frame([this] {
    performance_.sample(now_, pose_);
    stage_.render(pose_, pixels_, canvas_);
  });
  now_ = now_ < performance_.end() ? now_ + ticks(0.04) : 0;
  return time;
}

}  // namespace auslan::bench
