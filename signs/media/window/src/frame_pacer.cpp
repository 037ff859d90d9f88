// SPDX-License-Identifier: Apache-2.0
#include "media/window.h"

#include <cassert>
#include <chrono>
#include <thread>

namespace auslan {

namespace {

constexpr int64_t kNanoseconds = 1'000'000'000;

int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

FramePacer::FramePacer(int fps_numerator, int fps_denominator)
    : start_ns_(now_ns()), numerator_(fps_numerator), denominator_(fps_denominator) {
  assert(fps_numerator > 0 && fps_denominator > 0);
}

void FramePacer::restart() {
  start_ns_ = now_ns();
}

int64_t FramePacer::wait_for(int64_t index) const {
  // Whole cycles of `numerator` frames last `denominator` seconds exactly; only the rest is divided.
  const int64_t cycles = index / numerator_;
  const int64_t rest = index % numerator_;
  const int64_t due =
      start_ns_ + cycles * denominator_ * kNanoseconds + rest * denominator_ * kNanoseconds / numerator_;
  const int64_t early = due - now_ns();
  if (early > 0) {
    std::this_thread::sleep_for(std::chrono::nanoseconds(early));
    return 0;
  }
  return -early * numerator_ / (denominator_ * kNanoseconds);
}

}  // namespace auslan
