// SPDX-License-Identifier: Apache-2.0
// One performance under measurement: what is looked at when, and what is noted of it.
#pragma once

#include "body_solids.h"
#include "check/check.h"
#include "kinematics/anatomy.h"
#include "synthesis/performance.h"
#include "synthesis/signer.h"

#include <array>
#include <string>
#include <vector>

namespace auslan {

/// How often a performance is looked at.
inline constexpr int kChecksPerSecond = 120;
inline constexpr Tick kCheckStep = kTicksPerSecond / kChecksPerSecond;

/// How far a value lies outside the range of its measure; 0 within it.
double badness(Measure measure, double value);

class Judge {
 public:
  Judge(const Signer& signer, const BodySolids& solids, const Score& score, Verdict& verdict);

  void run();

 private:
  /// Keeps the worst, and among good values the largest; whether this one was kept.
  bool note(Measure measure, double value, Tick time, std::string where);
  /// Of what was just noted.
  void explain(Measure measure, std::string detail);
  const std::string& name(int node) const { return skeleton_.node(node).name; }
  void pose_at(Tick time);
  const Transform& placed(int node) const { return world_[static_cast<size_t>(node)]; }

  bool may_touch(BodyGroup a, BodyGroup b) const;
  bool is_on_face() const;
  bool hides(const Vec3& eye, const Vec3& point) const;
  /// The nearest skin of any of the groups.
  std::optional<NearestSkin> nearest_of(const std::vector<BodyGroup>& groups, const Vec3& point, double within) const;

  // judge.cpp: the body in its places
  void over_time();
  void at_targets();
  void posture(Side side, const HandTarget& target);
  /// What an arm within its limits could do about a direction that is not shown.
  std::string direction_detail(Side side, const HandTarget& target) const;
  /// Which way a joint goes too far.
  std::string limit_detail(int node) const;
  void contact(Side side, const HandTarget& target);
  void approach(Side side, const HandTarget& target);

  // judge_motion.cpp: how it moves
  void at_keys();
  void strokes();
  void holds();
  void rates();
  void mirror_image();

  const Signer& signer_;
  const BodySolids& solids_;
  const Skeleton& skeleton_;
  const Score& score_;
  Performance performance_;
  Verdict& verdict_;
  Pose pose_;
  std::vector<Transform> world_;
  std::array<ArmNodes, 2> arms_;
};

}  // namespace auslan
