// SPDX-License-Identifier: Apache-2.0
// Places and rotations that are the same on every machine and in every run. Tests only.
#pragma once

#include "kinematics/rotation.h"

#include <random>

namespace auslan::test {

class Random {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  Vec3 vector() {
    const double x = between(-1.0, 1.0);
    const double y = between(-1.0, 1.0);
    const double z = between(-1.0, 1.0);
    return {x, y, z};
  }
  Quat rotation() { return from_rotation_vector(vector() * 2.0); }

 private:
  std::mt19937 engine_{21};
};

}  // namespace auslan::test
