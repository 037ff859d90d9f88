// SPDX-License-Identifier: Apache-2.0
// Lists of random draws: triangles of all sizes, in perspective and without, good ones and garbage.
#pragma once

#include "raster_scene.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

namespace auslan::raster {

struct Soup {
  std::deque<SceneMesh> meshes;  ///< stay where they are
  std::vector<SceneDraw> draws;
};

/// One number in `sane` is anything a float can be.
inline float soup_number(Random& random, float low, float high, uint64_t sane) {
  if (!random.once_in(sane)) return random.real(low, high);
  constexpr float kOdd[] = {0.0F,
                            -0.0F,
                            1e-40F,
                            -1e-40F,
                            1e-30F,
                            1e30F,
                            -1e30F,
                            std::numeric_limits<float>::max(),
                            std::numeric_limits<float>::lowest(),
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()};
  return kOdd[random.next() % std::size(kOdd)];
}

/// Triangles round random places; their size goes from far below a pixel to several times the view.
inline SceneMesh soup_mesh(Random& random, size_t triangles, uint64_t sane) {
  SceneMesh mesh;
  const auto vector = [&](float reach) {
    const float x = soup_number(random, -reach, reach, sane);
    const float y = soup_number(random, -reach, reach, sane);
    const float z = soup_number(random, -reach, reach, sane);
    return glm::vec3(x, y, z);
  };
  for (size_t i = 0; i < triangles; ++i) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    const glm::vec3 middle = vector(1.2F);
    // Halved again and again: as many of 0.001 as of 1.
    float size = 4.0F;
    for (int64_t halvings = random.between(0, 12); halvings > 0; --halvings)
      size *= 0.5F;
    for (uint32_t corner = 0; corner < 3; ++corner) {
      const glm::vec3 offset = vector(size);
      const uint64_t colour = random.next();
      mesh.add(glm::vec3(middle.x + offset.x, middle.y + offset.y, middle.z + offset.z), vector(1.0F),
               glm::u8vec4(colour & 255U, colour >> 8U & 255U, colour >> 16U & 255U, colour >> 24U & 255U));
      // Mostly its own vertices, at times one of the others, or none at all.
      uint32_t index = first + corner;
      if (random.once_in(16)) index = static_cast<uint32_t>(random.next() % (first + corner + 1));
      if (random.once_in(10 * sane)) index = static_cast<uint32_t>(random.next());
      mesh.indices.push_back(index);
    }
  }
  return mesh;
}

/// `draws` draws of up to `triangles` triangles each, about half of them garbage-free.
inline Soup make_soup(uint64_t seed, int width, int height, int draws, int64_t triangles) {
  Random random(seed);
  Soup soup;
  for (int d = 0; d < draws; ++d) {
    const bool parallel = random.once_in(3);
    const auto wanted = static_cast<size_t>(random.between(1, triangles));
    soup.meshes.push_back(soup_mesh(random, wanted, random.once_in(2) ? 200 : uint64_t{1} << 40U));
    SceneDraw draw;
    draw.mesh = soup.meshes.back().view();
    if (random.once_in(4)) draw.mesh.indices = draw.mesh.indices.first(draw.mesh.indices.size() - 3);
    draw.shading = random.once_in(2) ? Shading::kFlat : Shading::kGouraud;
    draw.cull = random.once_in(3) ? CullMode::kBack : CullMode::kNone;
    const float side = random.once_in(3) ? -1.0F : 1.0F;  // mirrored
    const float scale = random.real(0.3F, 1.5F);
    const float up = random.real(0.2F, 1.0F);
    draw.world_from_mesh = scene_place(side * scale, up, scale, random.real(-0.5F, 0.5F), 0.0F, 0.0F);
    draw.lighting = scene_lighting();
    draw.camera = scene_camera(width, height);
    if (parallel) {
      draw.camera = look_at_parallel(glm::vec3(0.0F, 0.0F, 3.0F), glm::vec3(0.0F), glm::vec3(0.0F, 1.0F, 0.0F), 1.0F,
                                     static_cast<float>(width) / static_cast<float>(height), 0.5F, 5.0F);
    }
    soup.draws.push_back(draw);
  }
  return soup;
}

}  // namespace auslan::raster
