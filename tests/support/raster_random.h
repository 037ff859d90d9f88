// SPDX-License-Identifier: Apache-2.0
// A seeded generator for tests of the rasteriser: SplitMix64, the same numbers on every machine.
#pragma once

#include <cstdint>

namespace auslan::raster {

class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}
  uint64_t next() {
    state_ += 0x9E3779B97F4A7C15ULL;
    uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }
  /// A whole number from `low` to `high`, both included.
  int64_t between(int64_t low, int64_t high) {
    return low + static_cast<int64_t>(next() % static_cast<uint64_t>(high - low + 1));
  }
  /// A number from `low` to `high`.
  float real(float low, float high) { return low + (high - low) * (static_cast<float>(next() >> 40U) / 16777216.0F); }
  /// Once in `times`.
  bool once_in(uint64_t times) { return next() % times == 0; }

 private:
  uint64_t state_;
};

}  // namespace auslan::raster
