// SPDX-License-Identifier: Apache-2.0
// Measuring several ways to draw one scene so that they can be compared on a machine that is never quite idle.
#pragma once

#include "frame_clock.h"

#include <functional>
#include <string>
#include <vector>

namespace auslan::bench {

/// One way to draw a scene.
struct Engine {
  std::string name;                                        ///< "avx2", "llvmpipe"
  std::function<std::vector<FrameTime>(int)> time_frames;  ///< draws so many frames; empty when it cannot
};

/// Lower quartiles over all frames that counted, milliseconds a frame: what other programs do to a shared core only
/// ever adds, so that medians say more of them than of an engine.
struct Figures {
  double cpu_ms = 0;
  double least_cpu_ms = 0;
  double wall_ms = 0;
  int frames = 0;  ///< 0: it could not draw
};

struct Patience {
  int rounds = 9;
  double turn_ms = 30;  ///< about how long one engine draws before the next has its turn
  int most_frames = 40;
};

/// The engines take turns, A B C A B C ..., so that a slow spell of the machine meets all of them. The first frame of a
/// turn warms the caches that the others used and does not count.
std::vector<Figures> measure(const std::vector<Engine>& engines, const Patience& patience);

}  // namespace auslan::bench
