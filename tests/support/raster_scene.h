// SPDX-License-Identifier: Apache-2.0
// A fixed scene for the rasteriser, made with nothing but IEEE arithmetic: a lit sphere, cubes, crossing needles, a
// mirrored and squashed copy, a rod that comes out of the camera, and a floor that runs under it. Knows no test
// library, so that it compiles where there is none.
#pragma once

#include "raster/renderer.h"
#include "raster_random.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace auslan::raster {

struct SceneMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::u8vec4> colours;
  std::vector<uint32_t> indices;

  MeshView view() const { return MeshView{positions, normals, colours, indices}; }

  void add(const glm::vec3& position, const glm::vec3& normal, const glm::u8vec4& colour) {
    positions.push_back(position);
    normals.push_back(normal);
    colours.push_back(colour);
  }
};

inline glm::vec3 scene_unit(const glm::vec3& v) {
  const float length = std::sqrt((v.x * v.x + v.y * v.y) + v.z * v.z);
  return glm::vec3(v.x / length, v.y / length, v.z / length);
}

/// The face of a cube of half-width 1, `cells` x `cells` squares; rounded to the unit sphere when `round`.
inline void add_face(SceneMesh& mesh, const glm::vec3& right, const glm::vec3& up, const glm::vec3& out, uint32_t cells,
                     bool round) {
  const auto base = static_cast<uint32_t>(mesh.positions.size());
  for (uint32_t row = 0; row <= cells; ++row) {
    for (uint32_t column = 0; column <= cells; ++column) {
      const float u = 2.0F * static_cast<float>(column) / static_cast<float>(cells) - 1.0F;
      const float v = 2.0F * static_cast<float>(row) / static_cast<float>(cells) - 1.0F;
      const glm::vec3 p((out.x + u * right.x) + v * up.x, (out.y + u * right.y) + v * up.y,
                        (out.z + u * right.z) + v * up.z);
      const glm::vec3 on_sphere = scene_unit(p);
      const bool stripe = (column / 3 + row / 3) % 2 == 0;
      mesh.add(round ? on_sphere : p, round ? on_sphere : out,
               stripe ? glm::u8vec4(224, 172, 140, 255) : glm::u8vec4(40, 70, 150, 255));
    }
  }
  for (uint32_t row = 0; row < cells; ++row) {
    for (uint32_t column = 0; column < cells; ++column) {
      const uint32_t a = base + row * (cells + 1) + column;
      const uint32_t d = a + cells + 1;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, d + 1, a, d + 1, d});
    }
  }
}

inline SceneMesh make_box(uint32_t cells, bool round) {
  SceneMesh mesh;
  const glm::vec3 x(1, 0, 0);
  const glm::vec3 y(0, 1, 0);
  const glm::vec3 z(0, 0, 1);
  const glm::vec3 nx(-1, 0, 0);
  const glm::vec3 ny(0, -1, 0);
  const glm::vec3 nz(0, 0, -1);
  add_face(mesh, x, y, z, cells, round);
  add_face(mesh, nx, y, nz, cells, round);
  add_face(mesh, nz, y, x, cells, round);
  add_face(mesh, z, y, nx, cells, round);
  add_face(mesh, x, nz, y, cells, round);
  add_face(mesh, x, z, ny, cells, round);
  return mesh;
}

inline SceneMesh make_needles() {
  SceneMesh mesh;
  Random random(90);
  for (uint32_t i = 0; i < 200; ++i) {
    // Braces, not parentheses: they fix the order in which the numbers are drawn.
    const glm::vec3 from{random.real(-1.5F, 1.5F), random.real(-1.0F, 1.0F), random.real(-1.0F, 1.5F)};
    const glm::vec3 to{random.real(-1.5F, 1.5F), random.real(-1.0F, 1.0F), random.real(-1.0F, 1.5F)};
    const auto green = static_cast<uint8_t>(random.between(0, 255));
    mesh.add(from, glm::vec3(0, 1, 0), glm::u8vec4(230, green, 30, 255));
    mesh.add(to, glm::vec3(0, 0, 1), glm::u8vec4(30, green, 230, 255));
    mesh.add(glm::vec3(to.x, to.y + 0.004F, to.z), glm::vec3(1, 0, 0), glm::u8vec4(255, 255, green, 255));
    mesh.indices.insert(mesh.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

inline SceneMesh make_floor() {
  SceneMesh mesh;
  const glm::vec3 up(0, 1, 0);
  mesh.add(glm::vec3(-40, -0.9F, 40), up, glm::u8vec4(120, 130, 120, 255));
  mesh.add(glm::vec3(40, -0.9F, 40), up, glm::u8vec4(200, 120, 60, 255));
  mesh.add(glm::vec3(40, -0.9F, -40), up, glm::u8vec4(60, 160, 90, 255));
  mesh.add(glm::vec3(-40, -0.9F, -40), up, glm::u8vec4(90, 90, 190, 255));
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

inline glm::mat4 scene_place(float scale_x, float scale_y, float scale_z, float x, float y, float z) {
  // Turned about y by the angle of the triple 7-24-25, then scaled and moved.
  glm::mat4 m(1.0F);
  m[0] = glm::vec4(0.96F * scale_x, 0.0F, -0.28F * scale_x, 0.0F);
  m[1] = glm::vec4(0.0F, scale_y, 0.0F, 0.0F);
  m[2] = glm::vec4(0.28F * scale_z, 0.0F, 0.96F * scale_z, 0.0F);
  m[3] = glm::vec4(x, y, z, 1.0F);
  return m;
}

/// The meshes, built once.
struct Scene {
  SceneMesh sphere = make_box(24, true);
  SceneMesh cube = make_box(4, false);
  SceneMesh needles = make_needles();
  SceneMesh ground = make_floor();
};

/// One call of Renderer::draw and the light and camera under which it is made.
struct SceneDraw {
  MeshView mesh;
  glm::mat4 world_from_mesh{1.0F};
  Shading shading = Shading::kFlat;
  CullMode cull = CullMode::kBack;
  Camera camera;
  Lighting lighting;
};

struct FrameSize {
  int width = 0, height = 0, samples = 1;
  uint32_t background = 0x203448U;
};

inline size_t triangle_count(std::span<const SceneDraw> draws) {
  size_t count = 0;
  for (const SceneDraw& draw : draws)
    count += draw.mesh.indices.size() / 3;
  return count;
}

/// Draws the first `triangles` triangles of a list; `pixels` gets width * height pixels. Throws what a renderer says.
inline void draw_list(Renderer& renderer, std::span<const SceneDraw> draws, const FrameSize& size,
                      std::vector<uint32_t>& pixels, size_t triangles = SIZE_MAX, Canvas canvas = Canvas::kUnknown) {
  pixels.resize(pixel_count(size.width, size.height));
  if (renderer.begin_frame(size.width, size.height, size.samples, size.background) != Status::kOk) {
    throw std::runtime_error("begin_frame refuses the frame");
  }
  for (const SceneDraw& draw : draws) {
    MeshView mesh = draw.mesh;
    const size_t wanted = std::min(triangles, mesh.indices.size() / 3);
    if (wanted < mesh.indices.size() / 3) mesh.indices = mesh.indices.first(3 * wanted);
    if (triangles != SIZE_MAX) triangles -= wanted;
    renderer.set_camera(draw.camera);
    renderer.set_lighting(draw.lighting);
    renderer.draw(mesh, draw.world_from_mesh, draw.shading, draw.cull);
  }
  if (renderer.end_frame(pixels, canvas) != Status::kOk) throw std::runtime_error("end_frame refuses the pixels");
}

inline Lighting scene_lighting() {
  Lighting lighting;
  lighting.key_direction = glm::vec3(1.0F, 1.5F, 1.0F);
  lighting.key_colour = glm::vec3(0.75F, 0.72F, 0.68F);
  lighting.fill_direction = glm::vec3(-1.0F, 0.2F, 0.8F);
  lighting.fill_colour = glm::vec3(0.12F, 0.14F, 0.2F);
  lighting.ambient_sky = glm::vec3(0.2F, 0.22F, 0.25F);
  lighting.ambient_ground = glm::vec3(0.1F, 0.08F, 0.06F);
  return lighting;
}

inline Camera scene_camera(int width, int height) {
  return look_at(glm::vec3(0.4F, 0.3F, 3.0F), glm::vec3(0.0F), glm::vec3(0.0F, 1.0F, 0.0F), 2.2F,
                 static_cast<float>(width) / static_cast<float>(height), 0.05F);
}

/// The scene as a list; `scene` must outlive it.
inline std::vector<SceneDraw> scene_draws(const Scene& scene, int width, int height, Shading shading) {
  std::vector<SceneDraw> draws;
  const auto add = [&](const SceneMesh& mesh, const glm::mat4& place, Shading how, CullMode cull = CullMode::kBack) {
    draws.push_back({mesh.view(), place, how, cull, scene_camera(width, height), scene_lighting()});
  };
  add(scene.ground, glm::mat4(1.0F), Shading::kGouraud);
  add(scene.sphere, scene_place(0.5F, 0.5F, 0.5F, 0.0F, 0.0F, 0.0F), shading);
  add(scene.sphere, scene_place(-0.2F, 0.35F, 0.1F, -0.9F, 0.1F, 0.4F), shading);
  add(scene.cube, scene_place(0.25F, 0.25F, 0.25F, 0.85F, -0.2F, 0.3F), shading);
  add(scene.cube, scene_place(0.003F, 0.003F, 0.8F, 0.4F, 0.285F, 3.0F), shading);
  add(scene.needles, glm::mat4(1.0F), shading, CullMode::kNone);
  return draws;
}

/// Draws the scene; `pixels` gets width * height pixels.
inline void draw_scene(Renderer& renderer, const Scene& scene, int width, int height, int samples, Shading shading,
                       std::vector<uint32_t>& pixels) {
  draw_list(renderer, scene_draws(scene, width, height, shading), {width, height, samples}, pixels);
}

}  // namespace auslan::raster
