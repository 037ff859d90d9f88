// SPDX-License-Identifier: Apache-2.0
// The library alone: raster_frames SCENE WIDTH HEIGHT SAMPLES KERNEL THREADS REDRAW FRAMES draws that many frames and
// says on one line when the first was done (CLOCK_MONOTONIC, milliseconds) and how much memory the process ever held
// (kilobytes). What instructions.sh counts, and what the report starts as "first frame".
#include "frame_series.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

/// The high-water mark of the process's memory in kilobytes; 0 where there is no /proc. (What wait4 reports would hold
/// the memory of the process that started this one.)
long peak_memory_kb() {
  std::FILE* status = std::fopen("/proc/self/status", "r");
  if (status == nullptr) return 0;
  char line[200];
  long peak = 0;
  while (std::fgets(line, sizeof line, status) != nullptr)
    if (std::strncmp(line, "VmHWM:", 6) == 0) peak = std::strtol(line + 6, nullptr, 10);
  std::fclose(status);
  return peak;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace auslan;
  using namespace auslan::bench;
  const auto kernel = argc == 9 ? kernel_of(argv[5]) : std::nullopt;
  const auto redraw = argc == 9 ? redraw_of(argv[7]) : std::nullopt;
  if (!kernel || !redraw) {
    std::fprintf(stderr,
                 "usage: raster_frames SCENE WIDTH HEIGHT SAMPLES KERNEL THREADS full|clean|arm|still FRAMES\n"
                 "KERNEL is one that runs here; scenes are listed in tests/bench/scene.h\n");
    return 2;
  }
  const SeriesOptions options{.width = std::atoi(argv[2]),
                              .height = std::atoi(argv[3]),
                              .samples = std::atoi(argv[4]),
                              .kernel = *kernel,
                              .threads = std::atoi(argv[6]),
                              .redraw = *redraw};
  const Scene scene = load_scene(argv[1]);
  FrameSeries series(scene, options);
  const int frames = std::atoi(argv[8]);
  double first = 0;
  for (int i = 0; i < frames; ++i) {
    series.draw();
    if (i == 0) first = read_clock(CLOCK_MONOTONIC);
  }
  std::printf("%.3f %ld\n", first, peak_memory_kb());
  return 0;
}
