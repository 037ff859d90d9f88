// SPDX-License-Identifier: Apache-2.0
#include "measurement.h"

#include <algorithm>
#include <cstddef>

namespace auslan::bench {
namespace {

double lower_quartile(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto quarter = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::ranges::nth_element(values, quarter);
  return *quarter;
}

}  // namespace

std::vector<Figures> measure(const std::vector<Engine>& engines, const Patience& patience) {
  struct Times {
    int frames_a_turn = 1;
    std::vector<double> cpu, wall;
  };
  std::vector<Times> times(engines.size());
  for (size_t i = 0; i < engines.size(); ++i) {
    engines[i].time_frames(2);
    const std::vector<FrameTime> trial = engines[i].time_frames(2);
    const double frame_ms = trial.empty() ? 1.0 : std::max(trial.back().wall_ms, 0.01);
    times[i].frames_a_turn = std::clamp(static_cast<int>(patience.turn_ms / frame_ms), 1, patience.most_frames);
  }
  for (int round = 0; round < patience.rounds; ++round) {
    for (size_t i = 0; i < engines.size(); ++i) {
      const std::vector<FrameTime> turn = engines[i].time_frames(times[i].frames_a_turn + 1);
      for (size_t frame = 1; frame < turn.size(); ++frame) {
        times[i].cpu.push_back(turn[frame].cpu_ms);
        times[i].wall.push_back(turn[frame].wall_ms);
      }
    }
  }
  std::vector<Figures> figures;
  for (Times& of : times) {
    Figures result;
    result.frames = static_cast<int>(of.cpu.size());
    if (result.frames > 0) result.least_cpu_ms = *std::ranges::min_element(of.cpu);
    result.cpu_ms = lower_quartile(of.cpu);
    result.wall_ms = lower_quartile(of.wall);
    figures.push_back(result);
  }
  return figures;
}

}  // namespace auslan::bench
