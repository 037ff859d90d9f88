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
  kStandOff,         ///< mm by which what is to be near a surface misses its distance from it
  kApproach,         ///< degrees between the last of the way to a contact and straight into the surface
  kPenetration,      ///< mm that parts which are not to touch are inside each other
  kPressing,         ///< mm that parts which are to touch are inside each other
  kDirection,        ///< degrees between the chosen and the shown finger direction or palm
  kLeaning,          ///< degrees between the stated and the chosen one: what the joints' limits ask for at that place;
                     ///< half the way to the next of the notation's directions still reads as the stated one
  kHandshape,        ///< degrees between a joint of the stated and the shown handshape
  kJointLimits,      ///< degrees beyond a joint's range
  kJointSpeed,       ///< degrees a second
  kAngularVelocity,  ///< percent of the local peak by which a joint's velocity jumps at a key
  kStroke,           ///< peak over mean speed of a stroke from point to point
  kHold,             ///< ms for which a posture of a sign is held
  kLetterHold,       ///< the same of a letter in a spelled word
  kWristSpeed,       ///< m/s
  kSignRate,         ///< signs a second where at least three follow each other without a pause
  kLetterRate,       ///< letters a second where at least three of a word follow each other
  kFaceHidden,       ///< percent of the frames in which a hand hides mouth or eyes
  kMirror,           ///< degrees between a joint of the left-handed signer and its mirror image; of faces: any
};
inline constexpr size_t kMeasureCount = 19;
/// As the upper end of a range: there is none.
inline constexpr double kUnbounded = 1e9;

/// Its name in reports and JSON, its unit, and the range in which a performance is good.
struct MeasureInfo {
  std::string_view name, unit;
  double low, high;
};
const MeasureInfo& info(Measure measure);
std::optional<Measure> measure_of(std::string_view name);

/// The worst that was found of a measure.
struct Measured {
  double value = 0.0;
  Tick time = 0;
  std::string where;   ///< which parts of the body, which target
  std::string detail;  ///< what more is known of it: which way a joint goes too far, what an arm could do; or nothing
};

/// Of one performance: the worst of each measure; nothing where the performance has nothing to measure it on.
struct Verdict {
  std::array<std::optional<Measured>, kMeasureCount> worst;

  const std::optional<Measured>& of(Measure measure) const { return worst[static_cast<size_t>(measure)]; }
  bool good(Measure measure) const;
  bool good() const;  ///< all of them
  /// Of the 120 a second, counted from 0.
  static int frame(const Measured& measured);
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
