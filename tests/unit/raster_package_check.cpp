// SPDX-License-Identifier: Apache-2.0
// raster_package_check FIGURE.glb PICTURE.png: whether the picture is the one that raster/example states, drawn here
// through this project's own reader of glTF and of pictures. 0: it is. 77: there is no picture module.
#include "gltf/figure_gltf.h"
#include "kinematics/pose.h"
#include "media/picture.h"
#include "media/picture_module.h"
#include "raster/renderer.h"

#include <iostream>

namespace {

int refuse(const auslan::Error& error) {
  std::cerr << auslan::to_string(error) << "\n";
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace auslan;
  if (argc != 3) return 2;
  if (!load_picture_module()) {
    std::cerr << "skipped: the picture module is missing\n";
    return 77;
  }
  const auto figure = read_gltf(argv[1]);
  if (!figure) return refuse(figure.error());
  const auto actual = read_png(argv[2]);
  if (!actual) return refuse(actual.error());

  Picture expected = make_picture(640, 480);
  raster::Renderer renderer;
  if (renderer.begin_frame(expected.width, expected.height, 8, 0xC9D3D9) != raster::Status::kOk) return 1;
  renderer.set_camera(raster::look_at(glm::vec3(-0.8F, 1.5F, 2.6F), glm::vec3(0.0F, 1.3F, 0.0F),
                                      glm::vec3(0.0F, 1.0F, 0.0F), 3.6F, 4.0F / 3.0F, 0.1F));
  renderer.set_lighting({{0.5F, 0.8F, 0.9F}, glm::vec3(0.7F), {}, {}, glm::vec3(0.35F), glm::vec3(0.2F)});
  std::vector<std::vector<glm::u8vec4>> clay;
  for (int node = 0; node < figure->skeleton.size(); ++node) {
    // At rest nothing is rotated.
    glm::mat4 world_from_node(1.0F);
    world_from_node[3] = glm::vec4(glm::vec3(figure->skeleton.rest_position(node)), 1.0F);
    const Mesh& mesh = figure->segments[static_cast<size_t>(node)];
    clay.emplace_back(mesh.positions.size(), glm::u8vec4(201, 160, 132, 255));
    renderer.draw({mesh.positions, mesh.normals, clay.back(), mesh.indices}, world_from_node,
                  raster::Shading::kGouraud);
  }
  if (renderer.end_frame(expected.pixels) != raster::Status::kOk) return 1;
  const raster::DrawStats& stats = renderer.stats();
  // The picture holds a figure: a good part of a closed body's triangles faces the camera, and none is broken.
  if (stats.rejected != 0 || stats.drawn < stats.submitted / 8) {
    std::cerr << "the figure is not in the picture\n";
    return 1;
  }
  const Comparison comparison = compare(expected.view(), actual->view());
  if (comparison.equal()) return 0;
  std::cerr << to_string(comparison) << "\n";
  return 1;
}
