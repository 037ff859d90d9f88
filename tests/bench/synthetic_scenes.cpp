// SPDX-License-Identifier: Apache-2.0
#include "synthetic_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace auslan::bench {
namespace {

/// A 64-bit linear congruential generator (Knuth's MMIX constants): the same numbers everywhere.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}
  /// From least (included) to most.
  float between(float least, float most) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return least + (most - least) * (static_cast<float>(state_ >> 40U) / 16777216.0F);
  }
  uint8_t level() { return static_cast<uint8_t>(between(30.0F, 250.0F)); }

 private:
  uint64_t state_;
};

glm::vec3 unit(const glm::vec3& v) {
  const float length = std::sqrt((v.x * v.x + v.y * v.y) + v.z * v.z);
  return glm::vec3(v.x / length, v.y / length, v.z / length);
}

void add_vertex(SceneMesh& mesh, Random& random, const glm::vec3& position) {
  // Braces, not parentheses: they fix the order in which the numbers are drawn.
  const glm::vec3 tilt{random.between(-0.7F, 0.7F), random.between(-0.7F, 0.7F), 1.0F};
  const glm::u8vec4 colour{random.level(), random.level(), random.level(), uint8_t{255}};
  mesh.positions.push_back(position);
  mesh.normals.push_back(unit(tilt));
  mesh.colours.push_back(colour);
}

Scene in_clip_space(const char* name, SceneMesh mesh) {
  Scene scene;
  scene.name = name;
  scene.perspective = false;
  scene.lighting.key_direction = glm::vec3(0.55F, 0.75F, 0.85F);
  scene.lighting.key_colour = glm::vec3(0.66F, 0.64F, 0.60F);
  scene.lighting.fill_direction = glm::vec3(-0.8F, 0.15F, 0.6F);
  scene.lighting.fill_colour = glm::vec3(0.17F, 0.18F, 0.20F);
  scene.lighting.ambient_sky = glm::vec3(0.34F, 0.35F, 0.37F);
  scene.lighting.ambient_ground = glm::vec3(0.20F, 0.19F, 0.18F);
  scene.background = 0xC9D3D9;
  scene.meshes.push_back(std::move(mesh));
  return scene;
}

float twice_area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

Scene make_fill(DepthOrder order) {
  constexpr int kTriangles = 50;
  Random random(20230);
  int layers[kTriangles];
  for (int i = 0; i < kTriangles; ++i)
    layers[i] = i;
  for (int i = kTriangles - 1; i > 0; --i)
    std::swap(layers[i], layers[static_cast<int>(random.between(0.0F, static_cast<float>(i) + 0.999F))]);
  struct Triangle {
    int layer;  // 0 is the farthest
    glm::vec3 corners[3];
  };
  std::vector<Triangle> triangles;
  while (triangles.size() < kTriangles) {
    Triangle triangle{layers[triangles.size()], {}};
    for (glm::vec3& corner : triangle.corners) {
      // Depth is reversed: 1 is near. A layer is a fiftieth thick, and a triangle leans within its own.
      const float depth = (static_cast<float>(triangle.layer) + random.between(0.55F, 1.45F)) / 51.0F;
      corner = glm::vec3{random.between(-1.25F, 1.25F), random.between(-1.25F, 1.25F), depth};
    }
    const float area = twice_area(triangle.corners[0], triangle.corners[1], triangle.corners[2]);
    // The picture has an area of 4, so that a triangle has at least three tenths of it; what hangs over the edge is
    // cut.
    if (std::abs(area) < 2.4F) continue;
    if (area < 0.0F) std::swap(triangle.corners[1], triangle.corners[2]);
    triangles.push_back(triangle);
  }
  if (order == DepthOrder::kBackToFront)
    std::ranges::sort(triangles, [](const Triangle& a, const Triangle& b) { return a.layer < b.layer; });
  SceneMesh mesh;
  for (const Triangle& triangle : triangles) {
    // Its own colours go with the layer, so that both orders make the same picture.
    Random own(static_cast<uint64_t>(triangle.layer) * 977 + 5);
    own.between(0.0F, 1.0F);
    for (const glm::vec3& corner : triangle.corners) {
      mesh.indices.push_back(static_cast<uint32_t>(mesh.positions.size()));
      add_vertex(mesh, own, corner);
    }
  }
  return in_clip_space(order == DepthOrder::kRandom ? "fill" : "back_to_front", std::move(mesh));
}

Scene make_tiny() {
  // 2 * 578 * 433 = 500,548 triangles. A cell is 2.82 by 2.12 pixels at 1920x1080, a triangle 3 pixels on average.
  constexpr uint32_t kColumns = 578;
  constexpr uint32_t kRows = 433;
  constexpr float kHalf = 0.85F;
  Random random(555);
  SceneMesh mesh;
  for (uint32_t row = 0; row <= kRows; ++row) {
    for (uint32_t column = 0; column <= kColumns; ++column) {
      const float u = (static_cast<float>(column) + random.between(-0.07F, 0.07F)) / static_cast<float>(kColumns);
      const float v = (static_cast<float>(row) + random.between(-0.07F, 0.07F)) / static_cast<float>(kRows);
      const float depth = random.between(0.4F, 0.6F);
      add_vertex(mesh, random, glm::vec3(kHalf * (2.0F * u - 1.0F), kHalf * (2.0F * v - 1.0F), depth));
    }
  }
  for (uint32_t row = 0; row < kRows; ++row) {
    for (uint32_t column = 0; column < kColumns; ++column) {
      const uint32_t a = row * (kColumns + 1) + column;
      const uint32_t d = a + kColumns + 1;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, d + 1, a, d + 1, d});
    }
  }
  return in_clip_space("tiny", std::move(mesh));
}

}  // namespace auslan::bench
