// SPDX-License-Identifier: Apache-2.0
#include "workload.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace auslan::bench {
namespace {

/// On the screen, in 1/256 pixel, y down.
struct Point {
  int64_t x, y;
};

Point place_of(const glm::dmat4& clip_from_mesh, const glm::vec3& position, int width, int height) {
  const glm::dvec4 clip = clip_from_mesh * glm::dvec4(position, 1.0);
  return {std::llround((clip.x / clip.w + 1.0) * 128.0 * width),
          std::llround((1.0 - clip.y / clip.w) * 128.0 * height)};
}

/// Not negative where (x, y) lies inside or on an edge whose points belong to the triangle: the top-left rule.
int64_t edge(const Point& from, const Point& to, int64_t x, int64_t y) {
  const int64_t dx = to.x - from.x;
  const int64_t dy = to.y - from.y;
  const bool top_left = dy < 0 || (dy == 0 && dx > 0);
  return dx * (y - from.y) - dy * (x - from.x) - (top_left ? 0 : 1);
}

void count_triangle(const Point& a, const Point& b, const Point& c, int width, int height, Workload& work,
                    std::vector<bool>& shown) {
  // The number of the first pixel whose centre lies at or behind a place.
  const auto first_centre = [](int64_t place) { return (place + 127) >> 8; };
  const int64_t left = std::max<int64_t>(first_centre(std::min({a.x, b.x, c.x})), 0);
  const int64_t top = std::max<int64_t>(first_centre(std::min({a.y, b.y, c.y})), 0);
  const int64_t right = std::min<int64_t>(first_centre(std::max({a.x, b.x, c.x}) + 1), width);
  const int64_t bottom = std::min<int64_t>(first_centre(std::max({a.y, b.y, c.y}) + 1), height);
  const uint64_t before = work.fragments;
  for (int64_t row = top; row < bottom; ++row)
    for (int64_t column = left; column < right; ++column) {
      const int64_t x = 256 * column + 128;
      const int64_t y = 256 * row + 128;
      if (edge(a, b, x, y) < 0 || edge(b, c, x, y) < 0 || edge(c, a, x, y) < 0) continue;
      ++work.fragments;
      shown[static_cast<size_t>(row * width + column)] = true;
    }
  work.covering += work.fragments != before ? 1 : 0;
}

}  // namespace

Workload workload_of(const Scene& scene, int width, int height) {
  const raster::Camera camera = scene.camera_for(width, height);
  Workload work;
  std::vector<bool> shown(static_cast<size_t>(width) * static_cast<size_t>(height));
  for (const SceneMesh& mesh : scene.meshes) {
    const glm::dmat4 clip_from_mesh =
        glm::dmat4(camera.clip_from_view) * glm::dmat4(camera.view_from_world) * glm::dmat4(mesh.world_from_mesh);
    std::vector<Point> points;
    for (const glm::vec3& position : mesh.positions)
      points.push_back(place_of(clip_from_mesh, position, width, height));
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const Point& a = points[mesh.indices[i]];
      const Point& b = points[mesh.indices[i + 1]];
      const Point& c = points[mesh.indices[i + 2]];
      // Counter-clockwise with y up is a negative area with y down.
      if ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) >= 0) continue;
      ++work.front_facing;
      count_triangle(a, c, b, width, height, work, shown);
    }
  }
  work.pixels = static_cast<uint64_t>(std::count(shown.begin(), shown.end(), true));
  return work;
}

}  // namespace auslan::bench
