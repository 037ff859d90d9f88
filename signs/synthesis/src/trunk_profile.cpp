// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trunk_profile.h"

#include "kinematics/surface.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace auslan {

TrunkProfile TrunkProfile::measure(const Figure& figure) {
  TrunkProfile profile;
  const Skeleton& skeleton = figure.skeleton;
  const int trunk = skeleton.find("spine_base");
  const Vec3 base = skeleton.rest_position(trunk);
  const double breadth = std::abs(skeleton.rest_position(skeleton.find("shoulder_l")).x) + 0.06;
  const double top = skeleton.rest_position(skeleton.find("neck_base")).y;
  profile.left_ = -breadth;
  profile.bottom_ = base.y - 0.12;
  profile.columns_ = static_cast<int>(2.0 * breadth / profile.step_) + 1;
  profile.rows_ = static_cast<int>((top - profile.bottom_) / profile.step_) + 1;
  const std::array<int, 1> only = {trunk};
  for (int row = 0; row < profile.rows_; ++row) {
    for (int column = 0; column < profile.columns_; ++column) {
      const Vec3 place(profile.left_ + column * profile.step_, profile.bottom_ + row * profile.step_, base.z);
      Cell cell;
      const auto front = cast_ray(figure, only, place + Vec3(0, 0, 1), Vec3(0, 0, -1));
      if (front) {
        const auto back = cast_ray(figure, only, place - Vec3(0, 0, 1), Vec3(0, 0, 1));
        cell.front = base.z + front->position.z;
        cell.back = back ? base.z + back->position.z : cell.front;
      }
      profile.cells_.push_back(cell);
    }
  }
  return profile;
}

double TrunkProfile::depth(const Vec3& point, double radius) const {
  const auto column = static_cast<int>(std::lround((point.x - left_) / step_));
  const auto row = static_cast<int>(std::lround((point.y - bottom_) / step_));
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return 0;
  const Cell& cell = cells_[static_cast<size_t>(row * columns_ + column)];
  if (cell.front < cell.back) return 0;
  return std::max(0.0, std::min(cell.front + radius - point.z, point.z - (cell.back - radius)));
}

}  // namespace auslan
