// SPDX-License-Identifier: Apache-2.0
// stage_frames figure|figure_plain WIDTH HEIGHT SAMPLES KERNEL THREADS full|clean FRAMES: so many frames of the shipped
// signer, for instructions.sh to count.
#include "frame_series.h"
#include "stage_series.h"

#include <cstdio>
#include <cstdlib>
#include <exception>

int main(int argc, char** argv) {
  using namespace auslan::bench;
  const auto form = argc == 9 ? figure_form_of(argv[1]) : std::nullopt;
  const auto kernel = argc == 9 ? kernel_of(argv[5]) : std::nullopt;
  const auto redraw = argc == 9 ? redraw_of(argv[7]) : std::nullopt;
  if (!form || !kernel || (redraw != Redraw::kFull && redraw != Redraw::kClean)) {
    std::fprintf(stderr,
                 "usage: stage_frames figure|figure_plain WIDTH HEIGHT SAMPLES KERNEL THREADS full|clean FRAMES\n");
    return 2;
  }
  try {
    StageSeries series({.form = *form,
                        .width = std::atoi(argv[2]),
                        .height = std::atoi(argv[3]),
                        .samples = std::atoi(argv[4]),
                        .kernel = *kernel,
                        .threads = std::atoi(argv[6]),
                        .every_pixel = redraw == Redraw::kFull});
    for (int i = std::atoi(argv[8]); i > 0; --i)
      series.draw();
    std::printf("%llu triangles\n", static_cast<unsigned long long>(series.triangle_count()));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stage_frames: %s; build auslan_baked_figure and auslan_built_lexicon\n", error.what());
    return 1;
  }
  return 0;
}
