// SPDX-License-Identifier: Apache-2.0
// The vector types of the animation side: double precision, right-handed, Y up, metres, radians.
// +X is the signer's left, +Z points out of the chest towards the viewer. Quaternions are unit, written (w, x, y, z).
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace auslan {

using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;
using Quat = glm::dquat;

inline constexpr Quat kIdentity{1.0, 0.0, 0.0, 0.0};

/// A rigid placement: point_in_a = rotation * point_in_b + position, written a_from_b.
struct Transform {
  Quat rotation = kIdentity;
  Vec3 position{0.0};

  friend bool operator==(const Transform&, const Transform&) = default;
};

inline Vec3 apply(const Transform& a_from_b, const Vec3& point_b) {
  return a_from_b.rotation * point_b + a_from_b.position;
}

}  // namespace auslan
