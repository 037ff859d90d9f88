// SPDX-License-Identifier: Apache-2.0
// Textures for tests, and a fixed scene with them: a sphere, a cube with holes that are cut out, a floor that runs
// under the camera, and one thing without a texture. Knows no test library.
#pragma once

#include "raster_scene.h"

#include <deque>

namespace auslan::raster {

/// A picture before it is a texture.
struct TestPicture {
  int width = 0, height = 0;
  std::vector<glm::u8vec4> pixels;

  TestPicture(int w, int h) : width(w), height(h), pixels(pixel_count(w, h)) {}
  glm::u8vec4& at(int x, int y) { return pixels[static_cast<size_t>(y * width + x)]; }
  const glm::u8vec4& at(int x, int y) const { return pixels[static_cast<size_t>(y * width + x)]; }
  Texture texture() const {
    std::optional<Texture> made = Texture::from_srgb(width, height, pixels);
    if (!made) throw std::runtime_error("no texture of this size");
    return std::move(*made);
  }
};

inline TestPicture checkerboard(int width, int height, int cell, const glm::u8vec4& one, const glm::u8vec4& other) {
  TestPicture picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x)
      picture.at(x, y) = (x / cell + y / cell) % 2 == 0 ? one : other;
  }
  return picture;
}

inline TestPicture random_picture(int width, int height, uint64_t seed) {
  Random random(seed);
  TestPicture picture(width, height);
  for (glm::u8vec4& pixel : picture.pixels) {
    for (int c = 0; c < 4; ++c)
      pixel[c] = static_cast<uint8_t>(random.between(0, 255));
  }
  return picture;
}

/// Every face of a box of make_box(cells, ...) wears the whole texture, `times` over.
inline std::vector<glm::vec2> box_coordinates(uint32_t cells, float times) {
  std::vector<glm::vec2> coordinates;
  for (int face = 0; face < 6; ++face) {
    for (uint32_t row = 0; row <= cells; ++row) {
      for (uint32_t column = 0; column <= cells; ++column) {
        coordinates.emplace_back(times * static_cast<float>(column) / static_cast<float>(cells),
                                 times * (1.0F - static_cast<float>(row) / static_cast<float>(cells)));
      }
    }
  }
  return coordinates;
}

/// u and v along x and z, once a metre.
inline std::vector<glm::vec2> floor_coordinates(const SceneMesh& floor) {
  std::vector<glm::vec2> coordinates;
  for (const glm::vec3& p : floor.positions)
    coordinates.emplace_back(p.x, p.z);
  return coordinates;
}

struct TexturedScene {
  Scene bare;
  SceneMesh pale_sphere = make_box(24, true), pale_cube = make_box(4, false), pale_floor = make_floor();
  std::vector<glm::vec2> on_sphere = box_coordinates(24, 2.0F), on_cube = box_coordinates(4, 1.5F),
                         on_floor = floor_coordinates(pale_floor);
  Texture checks = checkerboard(64, 64, 8, glm::u8vec4(230, 225, 210, 255), glm::u8vec4(60, 90, 140, 255)).texture();
  Texture noise = random_picture(37, 21, 5).texture();
  Texture holes = checkerboard(16, 16, 4, glm::u8vec4(220, 60, 50, 255), glm::u8vec4(220, 200, 50, 0)).texture();

  TexturedScene() {
    for (SceneMesh* mesh : {&pale_sphere, &pale_cube, &pale_floor}) {
      for (glm::u8vec4& colour : mesh->colours)
        colour = glm::u8vec4(255);
    }
  }

  /// The scene as a list; this must outlive it.
  std::vector<SceneDraw> draws(int width, int height, Shading shading) const {
    std::vector<SceneDraw> list;
    const auto add = [&](const SceneMesh& mesh, const TextureUse& use, const glm::mat4& place,
                         CullMode cull = CullMode::kBack) {
      list.push_back({mesh.view(), place, shading, cull, scene_camera(width, height), scene_lighting()});
      list.back().mesh.texture = use;
    };
    add(pale_floor, {&checks, on_floor}, glm::mat4(1.0F));
    add(pale_sphere, {&checks, on_sphere}, scene_place(0.5F, 0.5F, 0.5F, 0.0F, 0.0F, 0.0F));
    add(bare.sphere, {}, scene_place(-0.2F, 0.35F, 0.1F, -0.9F, 0.1F, 0.4F));
    add(pale_cube, {&noise, on_cube, Wrap::kMirroredRepeat, Wrap::kClamp},
        scene_place(0.25F, 0.25F, 0.25F, -0.8F, -0.5F, 0.9F));
    add(pale_cube, {&holes, on_cube, Wrap::kRepeat, Wrap::kRepeat, AlphaMode::kMask, 0.5F},
        scene_place(0.25F, 0.25F, 0.25F, 0.85F, -0.2F, 0.3F), CullMode::kNone);
    add(pale_sphere, {&holes, on_sphere, Wrap::kRepeat, Wrap::kMirroredRepeat, AlphaMode::kMask, 0.5F},
        scene_place(0.2F, 0.2F, 0.2F, 0.5F, 0.5F, 0.9F), CullMode::kNone);
    add(bare.cube, {}, scene_place(0.003F, 0.003F, 0.8F, 0.4F, 0.285F, 3.0F));
    return list;
  }
};

}  // namespace auslan::raster
