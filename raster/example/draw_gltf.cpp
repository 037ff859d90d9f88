// SPDX-License-Identifier: Apache-2.0
// draw_gltf FILE.glb PICTURE.png: a person from the hips up, 640x480, eight samples a pixel. The file is trusted:
// triangles with normals, arrays without gaps, indices and colours (if there are any) of 16 bits.
#include <deque>
#include <glm/ext.hpp>
#include <raster/renderer.h>
#include <raster/srgb.h>
#include <stb_image_write.h>
#include <tiny_gltf.h>

using namespace auslan::raster;

struct Scene {
  tinygltf::Model file;
  Renderer renderer;
  // What a MeshView shows must stay where it is until end_frame; positions and normals do so in `file`.
  std::deque<std::vector<glm::u8vec4>> colours;
  std::deque<std::vector<uint32_t>> indices;
};

template <typename T>
std::span<const T> array(const tinygltf::Model& file, int number) {
  const tinygltf::Accessor& accessor = file.accessors.at(number);
  const tinygltf::BufferView& view = file.bufferViews.at(accessor.bufferView);
  const auto& bytes = file.buffers.at(view.buffer).data;
  return {reinterpret_cast<const T*>(&bytes.at(view.byteOffset + accessor.byteOffset)), accessor.count};
}

uint8_t srgb_code(uint16_t linear) {
  return static_cast<uint8_t>(srgb_level_from_linear(linear / 65535.0F) + 0.5F);
}

void draw(Scene& scene, const tinygltf::Node& node, glm::dmat4 place) {
  if (!node.translation.empty()) place = glm::translate(place, glm::make_vec3(node.translation.data()));
  if (!node.rotation.empty()) place *= glm::mat4_cast(glm::make_quat(node.rotation.data()));
  if (!node.scale.empty()) place = glm::scale(place, glm::make_vec3(node.scale.data()));
  static const std::vector<tinygltf::Primitive> kNothing;
  for (const tinygltf::Primitive& part : node.mesh < 0 ? kNothing : scene.file.meshes.at(node.mesh).primitives) {
    const auto positions = array<glm::vec3>(scene.file, part.attributes.at("POSITION"));
    auto& colours = scene.colours.emplace_back(positions.size(), glm::u8vec4(190));
    if (part.attributes.contains("COLOR_0"))
      for (size_t i = 0; const glm::u16vec4& light : array<glm::u16vec4>(scene.file, part.attributes.at("COLOR_0")))
        colours[i++] = glm::u8vec4(srgb_code(light.r), srgb_code(light.g), srgb_code(light.b), 255);
    const auto indices = array<uint16_t>(scene.file, part.indices);
    scene.indices.emplace_back(indices.begin(), indices.end());
    const auto normals = array<glm::vec3>(scene.file, part.attributes.at("NORMAL"));
    scene.renderer.draw({positions, normals, colours, scene.indices.back()}, glm::mat4(place), Shading::kGouraud);
  }
  for (const int child : node.children)
    draw(scene, scene.file.nodes.at(child), place);
}

int main(int argc, char** argv) {
  Scene scene;
  std::string error, warning;
  if (argc != 3 || !tinygltf::TinyGLTF().LoadBinaryFromFile(&scene.file, &error, &warning, argv[1])) {
    std::fprintf(stderr, "usage: draw_gltf FILE.glb PICTURE.png\n%s", error.c_str());
    return 2;
  }
  if (scene.renderer.begin_frame(640, 480, 8, pack_pixel(0xC9, 0xD3, 0xD9)) != Status::kOk) return 1;
  const glm::vec3 chest(0.0F, 1.3F, 0.0F);
  scene.renderer.set_camera(look_at({-0.8F, 1.5F, 2.6F}, chest, {0.0F, 1.0F, 0.0F}, 3.6F, 640.0F / 480.0F, 0.1F));
  scene.renderer.set_lighting({.key_direction = {0.5F, 0.8F, 0.9F},
                               .key_colour = glm::vec3(0.7F),
                               .ambient_sky = glm::vec3(0.35F),
                               .ambient_ground = glm::vec3(0.2F)});
  for (const int root : scene.file.scenes.at(0).nodes)
    draw(scene, scene.file.nodes.at(root), glm::dmat4(1.0));
  std::vector<uint32_t> pixels(640 * 480);
  if (scene.renderer.end_frame(pixels) != Status::kOk) return 1;
  std::vector<uint8_t> bytes;
  for (const uint32_t pixel : pixels)
    for (const uint32_t channel : {red_of(pixel), green_of(pixel), blue_of(pixel)})
      bytes.push_back(static_cast<uint8_t>(channel));
  return stbi_write_png(argv[2], 640, 480, 3, bytes.data(), 640 * 3) != 0 ? 0 : 1;
}
