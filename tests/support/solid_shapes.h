// SPDX-License-Identifier: Apache-2.0
// Closed meshes whose signed distance is a formula.
#pragma once

#include "kinematics/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace auslan {

inline void add_box(const Vec3& low, const Vec3& high, Mesh& mesh) {
  const auto base = static_cast<uint32_t>(mesh.positions.size());
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                                (i & 4) != 0 ? high.z : low.z);
  const std::vector<std::array<uint32_t, 4>> faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& f : faces)
    for (const size_t corner : {size_t{0}, size_t{1}, size_t{2}, size_t{0}, size_t{2}, size_t{3}})
      mesh.indices.push_back(base + f[corner]);
}

/// Signed distance of a box from its formula.
inline double box_distance(const Vec3& low, const Vec3& high, const Vec3& p) {
  Vec3 beyond(0.0);
  double within = 1e9;
  for (glm::length_t i = 0; i < 3; ++i) {
    beyond[i] = std::max({low[i] - p[i], p[i] - high[i], 0.0});
    within = std::min({within, p[i] - low[i], high[i] - p[i]});
  }
  return within > 0.0 ? -within : std::sqrt(glm::dot(beyond, beyond));
}

inline Mesh sphere(double radius, int rings, int around) {
  Mesh mesh;
  mesh.positions.emplace_back(0.0, radius, 0.0);
  for (int r = 1; r < rings; ++r)
    for (int a = 0; a < around; ++a) {
      const double polar = M_PI * r / rings;
      const double turn = 2.0 * M_PI * a / around;
      mesh.positions.emplace_back(radius * std::sin(polar) * std::sin(turn), radius * std::cos(polar),
                                  radius * std::sin(polar) * std::cos(turn));
    }
  mesh.positions.emplace_back(0.0, -radius, 0.0);
  const auto at = [&](int r, int a) {
    if (r == 0) return 0U;
    if (r == rings) return static_cast<uint32_t>(mesh.positions.size() - 1);
    return static_cast<uint32_t>(1 + (r - 1) * around + a % around);
  };
  for (int r = 0; r < rings; ++r)
    for (int a = 0; a < around; ++a) {
      if (r > 0) mesh.indices.insert(mesh.indices.end(), {at(r, a), at(r + 1, a), at(r, a + 1)});
      if (r + 1 < rings) mesh.indices.insert(mesh.indices.end(), {at(r, a + 1), at(r + 1, a), at(r + 1, a + 1)});
    }
  return mesh;
}

}  // namespace auslan
