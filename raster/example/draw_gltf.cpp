// SPDX-License-Identifier: Apache-2.0
// draw_gltf FILE.glb PICTURE.png: a person from the hips up, in clay. The file is trusted: nodes that are only moved,
// triangles with normals, arrays without gaps, indices of 16 bits.
#include <glm/ext.hpp>
#include <list>
#include <raster/renderer.h>
#include <stb_image_write.h>
#include <tiny_gltf.h>
using namespace auslan::raster;

template <typename T>
std::span<const T> array(const tinygltf::Model& file, int number) {
  const tinygltf::Accessor& accessor = file.accessors.at(number);
  const tinygltf::BufferView& view = file.bufferViews.at(accessor.bufferView);
  const auto& bytes = file.buffers.at(view.buffer).data;
  return {reinterpret_cast<const T*>(&bytes.at(view.byteOffset + accessor.byteOffset)), accessor.count};
}

void draw(Renderer& renderer, const tinygltf::Model& file, const tinygltf::Node& node, glm::dvec3 place) {
  static const tinygltf::Mesh kNothing;
  static const std::vector<glm::u8vec4> kClay(65536, glm::u8vec4(201, 160, 132, 255));
  static std::list<std::vector<uint32_t>> indices;  // what a MeshView shows must stay until end_frame
  if (!node.translation.empty()) place += glm::make_vec3(node.translation.data());
  for (const auto& part : (node.mesh < 0 ? kNothing : file.meshes.at(node.mesh)).primitives) {
    const auto positions = array<glm::vec3>(file, part.attributes.at("POSITION"));
    const auto normals = array<glm::vec3>(file, part.attributes.at("NORMAL"));
    const auto corners = array<uint16_t>(file, part.indices);
    const MeshView mesh{positions, normals, std::span(kClay).first(positions.size()),
                        indices.emplace_back(corners.begin(), corners.end())};
    renderer.draw(mesh, glm::translate(glm::mat4(1.0F), glm::vec3(place)), Shading::kGouraud);
  }
  for (const int child : node.children)
    draw(renderer, file, file.nodes.at(child), place);
}

int main(int argc, char** argv) {
  tinygltf::Model file;
  std::string error, warning;
  if (argc != 3 || !tinygltf::TinyGLTF().LoadBinaryFromFile(&file, &error, &warning, argv[1])) return 2;
  Renderer renderer;
  if (renderer.begin_frame(640, 480, 8, 0xC9D3D9) != Status::kOk) return 1;
  renderer.set_camera(look_at({-0.8F, 1.5F, 2.6F}, {0, 1.3F, 0}, {0, 1, 0}, 3.6F, 640.0F / 480.0F, 0.1F));
  renderer.set_lighting({{0.5F, 0.8F, 0.9F}, glm::vec3(0.7F), {}, {}, glm::vec3(0.35F), glm::vec3(0.2F)});
  draw(renderer, file, file.nodes.at(file.scenes.at(0).nodes.at(0)), glm::dvec3(0.0));
  std::vector<uint32_t> pixels(640 * 480);
  if (renderer.end_frame(pixels) != Status::kOk) return 1;
  for (uint32_t& pixel : pixels)
    pixel = 0xFF000000U | blue_of(pixel) << 16U | green_of(pixel) << 8U | red_of(pixel);
  return stbi_write_png(argv[2], 640, 480, 4, pixels.data(), 640 * 4) != 0 ? 0 : 1;
}
