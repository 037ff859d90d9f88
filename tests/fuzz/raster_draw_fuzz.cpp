// SPDX-License-Identifier: Apache-2.0
// Hostile meshes, matrices, cameras, lights and sizes, on every kernel, with threads, and frame after frame on one
// canvas: nothing may crash, the counts must add up, and the pixels must be those of the scalar kernel with one thread.
#include "raster/renderer.h"

#include <algorithm>
#include <array>
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
  // Off the back, so that what is read there does not move what is read in front.
  uint8_t take_last() { return size_ == 0 ? uint8_t{0} : data_[--size_]; }
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

// One call of Renderer::draw with what it reads.
struct Draw {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::u8vec4> colours;
  std::vector<uint32_t> indices;
  glm::mat4 world{1.0F};
  Camera camera;
  uint8_t mode = 0;
  uint64_t revision = 0;
  std::vector<glm::vec2> coordinates;
  uint8_t texture = 0;
  float cutoff = 0.5F;

  bool textured() const { return texture >= 128; }
};

// Sizes that are powers of two and others, with all alphas.
const std::array<Texture, 3>& textures() {
  const auto make = [](int width, int height) {
    std::vector<glm::u8vec4> pixels(pixel_count(width, height));
    for (size_t i = 0; i < pixels.size(); ++i)
      pixels[i] = glm::u8vec4(i * 53U % 256U, i * 91U % 256U, i * 7U % 256U, i * 37U % 256U);
    return std::move(*Texture::from_srgb(width, height, pixels));
  };
  static const std::array<Texture, 3> kTextures{make(1, 1), make(16, 8), make(13, 5)};
  return kTextures;
}

Draw read_draw(Input& in) {
  Draw draw;
  draw.camera = make_camera(in);
  const size_t count = in.take<uint8_t>() % 24U;
  draw.positions.resize(count);
  for (glm::vec3& p : draw.positions)
    p = in.vector();
  const auto lengths = in.take<uint8_t>();
  draw.normals.resize(lengths % 8U == 1 ? count / 2 : count);
  for (glm::vec3& n : draw.normals)
    n = in.vector();
  draw.colours.resize(lengths % 8U == 2 ? count + 1 : count);
  for (glm::u8vec4& c : draw.colours)
    c = glm::u8vec4(in.take<uint8_t>());
  draw.indices.resize(in.take<uint8_t>() % 64U);
  for (uint32_t& i : draw.indices) {
    const auto byte = in.take<uint8_t>();
    i = byte > 250 ? in.take<uint32_t>() : byte % 24U;
  }
  draw.world = in.matrix();
  draw.mode = in.take<uint8_t>();
  draw.texture = in.take_last();
  if (draw.textured()) {
    draw.coordinates.resize(lengths % 8U == 3 ? count + 1 : count);
    for (glm::vec2& c : draw.coordinates) {
      c.x = in.number();
      c.y = in.number();
    }
    draw.cutoff = in.number();
  }
  return draw;
}

void require(bool fact) {
  if (!fact) std::abort();
}

struct Frame {
  int width = 0, height = 0, samples = 1;
  uint32_t background = 0;
  Lighting lighting;
  std::vector<Draw> draws;
};

void draw_frame(Renderer& renderer, const Frame& frame, std::vector<uint32_t>& pixels, Canvas canvas) {
  require(renderer.begin_frame(frame.width, frame.height, frame.samples, frame.background) == Status::kOk);
  renderer.set_lighting(frame.lighting);
  for (const Draw& draw : frame.draws) {
    renderer.set_camera(draw.camera);
    MeshView mesh{draw.positions, draw.normals, draw.colours, draw.indices, draw.revision};
    if (draw.textured()) {
      mesh.texture.texture = &textures()[draw.texture % 3U];
      mesh.texture.coordinates = draw.coordinates;
      mesh.texture.wrap_u = static_cast<Wrap>(draw.mode / 4U % 3U);
      mesh.texture.wrap_v = static_cast<Wrap>(draw.mode / 16U % 3U);
      mesh.texture.alpha = (draw.mode & 128U) != 0U ? AlphaMode::kMask : AlphaMode::kOpaque;
      mesh.texture.alpha_cutoff = draw.cutoff;
    }
    renderer.draw(mesh, draw.world, (draw.mode & 1U) != 0U ? Shading::kFlat : Shading::kGouraud,
                  (draw.mode & 2U) != 0U ? CullMode::kNone : CullMode::kBack);
  }
  require(renderer.end_frame(pixels, canvas) == Status::kOk);
  const DrawStats& stats = renderer.stats();
  require(stats.submitted == stats.rejected + stats.culled + stats.drawn);
  require(stats.clipped <= stats.culled + stats.drawn);
}

void expect_same(const Renderer& a, const Renderer& b, const std::vector<uint32_t>& pixels_a,
                 const std::vector<uint32_t>& pixels_b) {
  require(pixels_a == pixels_b);
  require(a.stats().submitted == b.stats().submitted && a.stats().rejected == b.stats().rejected);
  require(a.stats().culled == b.stats().culled && a.stats().drawn == b.stats().drawn);
  require(a.stats().clipped == b.stats().clipped);
}

// What happens to a frame before it is drawn again.
void change(Frame& frame, uint8_t how, uint64_t& revision) {
  if (frame.draws.empty()) return;
  Draw& draw = frame.draws[how / 8U % frame.draws.size()];
  switch (how % 8U) {
    case 0:
      break;
    case 1:
      draw.world[3][0] = draw.world[3][0] + 0.125F;
      break;
    case 2:
      for (glm::u8vec4& c : draw.colours)
        c.x = static_cast<uint8_t>(~c.x);
      for (glm::vec2& c : draw.coordinates)
        c.y = -c.y;
      draw.revision = draw.revision == 0 ? 0 : ++revision;
      break;
    case 3:
      std::rotate(draw.indices.begin(), draw.indices.begin() + (draw.indices.empty() ? 0 : 1), draw.indices.end());
      draw.revision = ++revision;
      break;
    case 4:
      frame.draws.pop_back();
      break;
    case 5:
      std::swap(frame.draws.front(), draw);
      break;
    case 6:
      frame.background ^= 0x00010203U;
      break;
    default:
      draw.mode = static_cast<uint8_t>(draw.mode ^ 3U);
  }
}

// Any size may be asked for; the frames that are filled in the end are small, so that runs stay short.
void ask_for(Renderer& renderer, int width, int height, int samples) {
  const Status asked = renderer.begin_frame(width, height, samples, 0);
  const bool size = width >= 1 && width <= kMaxImageSize && height >= 1 && height <= kMaxImageSize;
  const bool count = samples == 1 || samples == 2 || samples == 4 || samples == 8;
  require((asked == Status::kOk) == (size && count));
  require(size || asked == Status::kBadSize);
}

struct Renderers {
  Renderer reference{1, Kernel::kScalar};
  std::vector<Renderer> tried;  ///< each kernel with 1, 2 and 3 threads

  Renderers() {
    for (const Kernel kernel : runnable_kernels()) {
      for (const int threads : {1, 2, 3})
        tried.emplace_back(threads, kernel);
    }
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static Renderers renderers;
  static std::vector<uint32_t> wanted;
  static std::vector<uint32_t> canvas;
  Input in(data, size);
  Renderer& reference = renderers.reference;
  Renderer& tried = renderers.tried[in.take_last() % renderers.tried.size()];
  const uint8_t redraws = in.take_last() % 3U;
  std::array<uint8_t, 2> changes{};
  for (uint8_t& how : changes)
    how = in.take_last();
  const uint8_t known = in.take_last();  // which draws have a revision

  const auto raw_width = in.take<int32_t>();
  const auto raw_height = in.take<int32_t>();
  const int samples = in.take<uint8_t>() % 10;
  Frame frame;
  frame.background = in.take<uint32_t>();
  ask_for(tried, raw_width, raw_height, samples);

  // Mostly small, at times over the borders of tiles (64 pixels), at times as wide as a frame can be.
  const bool wide = (raw_width & 63) == 63;
  const bool tiled = (raw_width & 15) == 1;
  frame.width = 1 + static_cast<int>(static_cast<uint32_t>(raw_width) % (wide ? 16384U : tiled ? 80U : 36U));
  frame.height = 1 + static_cast<int>(static_cast<uint32_t>(raw_height) % (wide ? 2U : tiled ? 70U : 20U));
  const int counts[] = {1, 2, 4, 8};
  frame.samples = wide ? 1 : counts[samples % 4];
  frame.lighting.key_direction = in.vector();
  frame.lighting.key_colour = in.vector();
  frame.lighting.ambient_sky = in.vector();
  frame.lighting.rim_direction = frame.lighting.ambient_sky;
  frame.lighting.rim_colour = frame.lighting.key_colour;
  uint64_t revision = 0;
  for (uint32_t d = 0; d < 8 && !in.empty(); ++d) {
    frame.draws.push_back(read_draw(in));
    if ((known >> d & 1U) != 0U) frame.draws.back().revision = ++revision;
  }

  const size_t count = pixel_count(frame.width, frame.height);
  wanted.assign(count, 0xFFFFFFFFU);
  canvas.assign(count, 0xFFFFFFFFU);
  draw_frame(reference, frame, wanted, Canvas::kUnknown);
  draw_frame(tried, frame, canvas, Canvas::kUnknown);
  expect_same(reference, tried, wanted, canvas);
  for (const uint32_t pixel : canvas)
    require(pixel <= 0xFFFFFFU);  // every pixel was written, and none with garbage in its top byte

  for (uint8_t redraw = 0; redraw < redraws; ++redraw) {
    change(frame, changes[redraw], revision);
    draw_frame(reference, frame, wanted, Canvas::kUnknown);
    draw_frame(tried, frame, canvas, Canvas::kLastFrame);
    expect_same(reference, tried, wanted, canvas);
    for (const PixelRect& rect : tried.damage()) {
      require(rect.x >= 0 && rect.y >= 0 && rect.width > 0 && rect.height > 0);
      require(rect.x + rect.width <= frame.width && rect.y + rect.height <= frame.height);
    }
  }
  return 0;
}
