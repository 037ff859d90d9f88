// SPDX-License-Identifier: Apache-2.0
#include "check/check.h"

#include "body_solids.h"
#include "judge.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace auslan {
namespace {

// The project's limits of quality. What is measured in floats and by vertices of a mesh has a little room.
// An approach is within 60 degrees of the surface's normal: from without, not along the skin. No joint turns faster
// than the hand of a native Auslan signer did in 144 recorded signs (Kadous, Auslan2 data set: at most 1655 degrees a
// second about its axis). Spelling at 3 letters a second may vary by a tenth.
constexpr std::array<MeasureInfo, kMeasureCount> kInfos = {{
    {"contact", "mm", 0.0, 3.0},
    {"stand-off", "mm", 0.0, 10.0},
    {"approach", "degrees", 0.0, 60.0},
    {"penetration", "mm", 0.0, 0.05},
    {"pressing", "mm", 0.0, 3.0},
    {"direction", "degrees", 0.0, 5.0},
    {"leaning", "degrees", 0.0, 22.5},
    {"handshape", "degrees", 0.0, 2.0},
    {"joint-limits", "degrees", 0.0, 0.05},
    {"joint-speed", "degrees/s", 0.0, 1655.0},
    {"angular-velocity", "%", 0.0, 1.0},
    {"stroke", "peak/mean", 1.7, 2.1},
    {"hold", "ms", 80.0, kUnbounded},
    {"letter-hold", "ms", 120.0, kUnbounded},
    {"wrist-speed", "m/s", 0.0, 4.0},
    {"sign-rate", "signs/s", 1.5, 3.0},
    {"letter-rate", "letters/s", 2.7, 3.3},
    {"face-hidden", "%", 0.0, 5.0},
    {"mirror", "degrees", 0.0, 0.0},
}};

}  // namespace

double badness(Measure measure, double value) {
  const MeasureInfo& range = info(measure);
  return value > range.high ? value - range.high : value < range.low ? range.low - value : 0.0;
}

std::optional<Measure> measure_of(std::string_view name) {
  for (size_t i = 0; i < kMeasureCount; ++i)
    if (kInfos[i].name == name) return static_cast<Measure>(i);
  return std::nullopt;
}

const MeasureInfo& info(Measure measure) {
  return kInfos[static_cast<size_t>(measure)];
}

bool Verdict::good(Measure measure) const {
  const std::optional<Measured>& found = of(measure);
  return !found || badness(measure, found->value) == 0.0;
}

bool Verdict::good() const {
  for (size_t i = 0; i < kMeasureCount; ++i)
    if (!good(static_cast<Measure>(i))) return false;
  return true;
}

int Verdict::frame(const Measured& measured) {
  return static_cast<int>(measured.time / kCheckStep);
}

struct Checker::State {
  const Signer& signer;
  BodySolids solids;
};

Checker::Checker(const Signer& signer) : state_(new State{signer, BodySolids(signer.figure())}) {}
Checker::Checker(Checker&&) noexcept = default;
Checker& Checker::operator=(Checker&&) noexcept = default;
Checker::~Checker() = default;

Verdict Checker::check(const Score& score) const {
  Verdict verdict;
  Judge(state_->signer, state_->solids, score, verdict).run();
  return verdict;
}

}  // namespace auslan
