// SPDX-License-Identifier: Apache-2.0
#include "hand_starts.h"

#include "kinematics/elementary.h"
#include "kinematics/rotation.h"

#include <cmath>

namespace auslan {

std::vector<HandStart> hand_starts(const Vec3& way) {
  constexpr double kTurn = 12.5 * kDegree, kSlide = 0.015, kFarSlide = 0.03;  // metres
  const Vec3 across = unit(glm::cross(way, std::abs(way.y) < 0.7 ? Vec3(0.0, 1.0, 0.0) : Vec3(0.0, 0.0, 1.0)));
  const Vec3 along = glm::cross(way, across);
  std::vector<Quat> turns = {kIdentity};
  for (const Vec3& axis : {across, along, way})
    for (const double turn : {kTurn, -kTurn})
      turns.push_back(axis_angle(axis, turn));
  std::vector<Vec3> slides;
  for (const double slide : {kSlide, kFarSlide})
    for (const Vec3& axis : {across, -across, along, -along})
      slides.push_back(slide * axis);
  std::vector<HandStart> starts;
  for (const Quat& turn : turns)
    for (const double swivel : {25.0, 55.0, -5.0, 85.0, -35.0, 115.0})
      starts.push_back({turn, Vec3(0.0), swivel * kDegree});
  for (const Vec3& slide : slides)
    for (const Quat& turn : turns)
      for (const double swivel : {25.0, 70.0})
        starts.push_back({turn, slide, swivel * kDegree});
  return starts;
}

}  // namespace auslan
