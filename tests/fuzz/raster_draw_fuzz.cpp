// SPDX-License-Identifier: Apache-2.0
// Hostile meshes, matrices, cameras, lights and sizes: nothing may crash, and the counts must add up.
#include "raster/renderer.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace {

using namespace auslan::raster;

// Reads values off the front of the input; zeros when it has run out.
class Input {
 public:
  Input(const uint8_t* data, size_t size) : data_(data), size_(size) {}

  template <typename T>
  T take() {
    T value{};
    const size_t count = std::min(sizeof(T), size_);
    if (count > 0) std::memcpy(&value, data_, count);
    data_ += count;
    size_ -= count;
    return value;
  }
  // Either raw bits (NaN, infinities, denormals and all) or a number of the size that a scene has.
  float number() {
    const auto kind = take<uint8_t>();
    if (kind < 40) return take<float>();
    return static_cast<float>(take<int16_t>()) / (kind < 150 ? 8192.0F : 64.0F);
  }
  glm::vec3 vector() {
    glm::vec3 v(0.0F);
    for (int i = 0; i < 3; ++i)
      v[i] = number();
    return v;
  }
  glm::mat4 matrix() {
    glm::mat4 m(1.0F);
    const auto changes = take<uint8_t>() % 17U;
    for (uint32_t i = 0; i < changes; ++i) {
      const auto element = take<uint8_t>() % 16U;
      m[static_cast<int>(element / 4U)][static_cast<int>(element % 4U)] = number();
    }
    return m;
  }
  bool empty() const { return size_ == 0; }

 private:
  const uint8_t* data_;
  size_t size_;
};

Camera make_camera(Input& in) {
  const auto kind = in.take<uint8_t>() % 3U;
  if (kind == 0) return Camera{in.matrix(), in.matrix()};
  const glm::vec3 eye = in.vector();
  const glm::vec3 target = in.vector();
  const glm::vec3 up = in.vector();
  const float size = in.number();
  const float aspect = in.number();
  const float near_plane = in.number();
  if (kind == 1) return look_at(eye, target, up, size, aspect, near_plane);
  return look_at_parallel(eye, target, up, size, aspect, near_plane, in.number());
}

void draw_one(Input& in, Renderer& renderer) {
  const size_t count = in.take<uint8_t>() % 24U;
  std::vector<glm::vec3> positions(count);
  for (glm::vec3& p : positions)
    p = in.vector();
  const auto lengths = in.take<uint8_t>();
  std::vector<glm::vec3> normals(lengths % 8U == 1 ? count / 2 : count);
  for (glm::vec3& n : normals)
    n = in.vector();
  std::vector<glm::u8vec4> colours(lengths % 8U == 2 ? count + 1 : count);
  for (glm::u8vec4& c : colours)
    c = glm::u8vec4(in.take<uint8_t>());
  std::vector<uint32_t> indices(in.take<uint8_t>() % 64U);
  for (uint32_t& i : indices) {
    const auto byte = in.take<uint8_t>();
    i = byte > 250 ? in.take<uint32_t>() : byte % 24U;
  }
  const glm::mat4 world = in.matrix();
  const auto mode = in.take<uint8_t>();
  renderer.draw(MeshView{positions, normals, colours, indices}, world,
                (mode & 1U) != 0U ? Shading::kFlat : Shading::kGouraud,
                (mode & 2U) != 0U ? CullMode::kNone : CullMode::kBack);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input in(data, size);
  static Renderer renderer;
  const auto raw_width = in.take<int32_t>();
  const auto raw_height = in.take<int32_t>();
  const int samples = in.take<uint8_t>() % 10;
  const auto background = in.take<uint32_t>();
  // Any size may be asked for; the frame that is filled in the end is small, so that runs stay short.
  const Status asked = renderer.begin_frame(raw_width, raw_height, samples, background);
  const bool legal = raw_width >= 1 && raw_width <= kMaxImageSize && raw_height >= 1 && raw_height <= kMaxImageSize &&
                     (samples == 1 || samples == 2 || samples == 4 || samples == 8);
  if ((asked == Status::kOk) != legal) std::abort();

  const bool wide = (raw_width & 1) != 0;
  const int width = 1 + static_cast<int>(static_cast<uint32_t>(raw_width) % (wide ? 16384U : 64U));
  const int height = 1 + static_cast<int>(static_cast<uint32_t>(raw_height) % (wide ? 4U : 64U));
  const int counts[] = {1, 2, 4, 8};
  if (renderer.begin_frame(width, height, counts[samples % 4], background) != Status::kOk) std::abort();
  Lighting lighting;
  lighting.key_direction = in.vector();
  lighting.key_colour = in.vector();
  lighting.ambient_sky = in.vector();
  renderer.set_lighting(lighting);
  for (int draw = 0; draw < 8 && !in.empty(); ++draw) {
    renderer.set_camera(make_camera(in));
    draw_one(in, renderer);
  }
  const DrawStats& stats = renderer.stats();
  if (stats.submitted != stats.rejected + stats.culled + stats.drawn) std::abort();
  if (stats.clipped > stats.culled + stats.drawn) std::abort();

  static std::vector<uint32_t> pixels;
  pixels.assign(pixel_count(width, height), 0xFFFFFFFFU);
  if (renderer.end_frame(pixels) != Status::kOk) std::abort();
  for (const uint32_t pixel : pixels) {
    if (pixel > 0xFFFFFFU) std::abort();  // every pixel was written, and none with garbage in its top byte
  }
  return 0;
}
