// SPDX-License-Identifier: Apache-2.0
// A score on a signer, sampled at any time: the last step before a body is drawn.
#pragma once

#include "kinematics/pose.h"
#include "synthesis/score.h"
#include "synthesis/signer.h"

#include <array>
#include <cstdint>
#include <vector>

namespace auslan {

struct PerformanceOptions {
  bool left_handed = false;  ///< the exact mirror image of the right-handed signer
  bool idle = true;          ///< breathing, swaying and blinks
  uint64_t seed = 1;         ///< of the blinks and of how the body sways
};

class Performance {
 public:
  /// The signer must outlive it.
  Performance(const Signer& signer, Score score, const PerformanceOptions& options = {});

  const Score& score() const { return score_; }
  Tick end() const { return score_.end; }

  /// The pose at a time; times before 0 and after the end give the first and last one. `pose` is resized once.
  void sample(Tick time, Pose& pose) const;

 private:
  void sample_hand(Side side, Tick time, const Transform& trunk, const Transform& head, Pose& pose) const;
  void sample_face(Tick time, FaceWeights& face) const;

  const Signer* signer_;
  Score score_;
  PerformanceOptions options_;
  std::vector<Tick> blinks_;
  std::array<double, 3> sway_phase_{};  ///< in cycles
  std::vector<int> mirror_;             ///< for each node the node on the other side
};

/// The state of a hand within a segment, trunk and head at rest.
HandState state_at(const HandSegment& segment, Tick time);
/// The same after a share of the segment, 0 to 1, whatever its times are.
HandState state_after(const HandSegment& segment, double share);

}  // namespace auslan
