// SPDX-License-Identifier: Apache-2.0
// The two clocks of the benchmark, in milliseconds.
#pragma once

#include <ctime>

namespace auslan::bench {

inline double read_clock(clockid_t id) {
  timespec now{};
  clock_gettime(id, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

struct FrameTime {
  double cpu_ms = 0;  ///< of all threads of the process
  double wall_ms = 0;
};

template <typename Frame>
FrameTime time_frame(Frame&& frame) {
  const double wall = read_clock(CLOCK_MONOTONIC);
  const double cpu = read_clock(CLOCK_PROCESS_CPUTIME_ID);
  frame();
  return {read_clock(CLOCK_PROCESS_CPUTIME_ID) - cpu, read_clock(CLOCK_MONOTONIC) - wall};
}

}  // namespace auslan::bench
