// SPDX-License-Identifier: Apache-2.0
// The scenes of the benchmark: what is drawn, without a word on who draws it.
//
//   signer_5k signer_22k signer_90k   the shipped figure while it signs, at three levels of detail, one draw a segment;
//                                     a file that make_scenes wrote
//   fill                              50 large overlapping triangles in random depth order
//   back_to_front                     the same, the farthest first: each covers what was drawn before
//   tiny                              an indexed grid of 500 thousand triangles of 2 to 4 pixels at 1920x1080
#pragma once

#include "raster/renderer.h"

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace auslan::bench {

/// One draw. Arrays as raster::MeshView has them.
struct SceneMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::u8vec4> colours;
  std::vector<uint32_t> indices;
  glm::mat4 world_from_mesh{1.0F};
  glm::mat4 moved_world_from_mesh{1.0F};  ///< one frame of signing later: another one for the segments of one arm only
};

struct Scene {
  std::string name;
  std::vector<SceneMesh> meshes;
  bool perspective = true;  ///< false: the camera holds for any shape of picture
  raster::Camera camera;    ///< for a square picture
  raster::Lighting lighting;
  uint32_t background = 0;

  raster::Camera camera_for(int width, int height) const;
  uint64_t triangle_count() const;
};

/// Makes or, for a signer, reads the scene of that name. Ends the program with a message when it cannot.
Scene load_scene(const std::string& name);

/// Where the file of a signer's scene stands: AUSLANJAM_BENCH_SCENES, else the build folder.
std::string scene_path(const std::string& name);
void write_scene(const Scene& scene, const std::string& path);

/// Adds all draws of the scene to the open frame. `moved`: one arm is where it is a frame later. `revision` as
/// MeshView has it, for every mesh.
void draw_scene(raster::Renderer& renderer, const Scene& scene, int width, int height, bool moved, uint64_t revision);

}  // namespace auslan::bench
