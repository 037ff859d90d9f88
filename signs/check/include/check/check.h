// SPDX-License-Identifier: Apache-2.0
// What makes signing good, measured: a performance sampled 120 times a second on a figure's own meshes, held against
// the limits of the project.
#pragma once

#include "synthesis/performance.h"
#include "synthesis/signer.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

enum class Measure {
  kContact,          ///< mm between what touches and the surface that it is to touch
  kPenetration,      ///< mm that parts which are not to touch are inside each other
  kPressing,         ///< mm that parts which are to touch are inside each other
  kDirection,        ///< degrees between the chosen and the shown finger direction or palm
  kLeaning,          ///< degrees between the stated and the chosen one: what the joints' limits ask for at that place;
                     ///< half the way to the next of the notation's directions still reads as the stated one
  kHandshape,        ///< degrees between a joint of the stated and the shown handshape
  kJointLimits,      ///< degrees beyond a joint's range
  kAngularVelocity,  ///< percent of the local peak by which a joint's velocity jumps at a key
  kStroke,           ///< peak over mean speed of a stroke from point to point
  kHold,             ///< ms for which the last posture of a sign is held
  kWristSpeed,       ///< m/s
  kFaceHidden,       ///< percent of the frames in which a hand hides mouth or eyes
};
inline constexpr size_t kMeasureCount = 12;

/// Its name in reports and JSON, its unit, and the range in which a performance is good.
struct MeasureInfo {
  std::string_view name, unit;
  double low, high;
};
const MeasureInfo& info(Measure measure);

/// The worst that was found of a measure.
struct Measured {
  double value = 0.0;
  Tick time = 0;
  std::string where;  ///< which parts of the body, which target
};

/// Of one performance: the worst of each measure; nothing where the performance has nothing to measure it on.
struct Verdict {
  std::array<std::optional<Measured>, kMeasureCount> worst;

  const std::optional<Measured>& of(Measure measure) const { return worst[static_cast<size_t>(measure)]; }
  bool good(Measure measure) const;
  bool good() const;  ///< all of them
};

/// Built once for a figure; then any number of performances. The signer must outlive it.
class Checker {
 public:
  explicit Checker(const Signer& signer);
  Checker(Checker&&) noexcept;
  Checker& operator=(Checker&&) noexcept;
  ~Checker();

  /// Idle motion is left out.
  Verdict check(const Score& score) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace auslan
