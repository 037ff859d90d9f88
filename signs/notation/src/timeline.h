// SPDX-License-Identifier: Apache-2.0
// Movements in order of time: sequences, splits and repetitions unrolled into strokes, each with all that happens at
// once.
#pragma once

#include "written_sign.h"

namespace auslan::notation {

/// Which hands something is about.
struct Hands {
  bool dominant = true, other = true;
};

struct StrokeItem {
  const WrittenMotion* motion = nullptr;   ///< a simple one; null: only the target
  const WrittenPosture* target = nullptr;  ///< the posture in which the stroke ends
  Hands hands;
};

struct Stroke {
  std::vector<StrokeItem> items;
  int repeats = 1;
  int restart_from = -1;  ///< before this stroke the hands go back to where stroke number `restart_from` began
  bool alternating = false;
  bool halt = false, fast = false, slow = false, tense = false, rest = false;
  Mark mark;
  double scale = 1;               ///< of the lengths of its paths
  std::string shift, shift_size;  ///< where it restarts the hands go farther on by `shifts` of these
  int shifts = 0;
};

/// The motions must outlive the result. More than a bounded number of strokes is cut, with a warning.
std::vector<Stroke> timeline_of(const std::vector<WrittenMotion>& motions, Findings& findings);

}  // namespace auslan::notation
