// SPDX-License-Identifier: Apache-2.0
// The depth buffer: order of drawing does not matter, and 2 mm are told apart at every distance of the program.
#include "raster_screen.h"

#include <algorithm>
#include <cmath>

namespace auslan::raster {
namespace {

class Depth : public OnEveryKernel {};
ON_EVERY_KERNEL(Depth);

// A fine jittered sheet of `cells` x `cells` squares, `size` metres wide, in the plane z = 0, one colour.
struct Sheet {
  std::vector<glm::vec3> positions;
  std::vector<glm::u8vec4> colours;
  std::vector<uint32_t> indices;

  Sheet(Random& random, uint32_t cells, float size, const glm::u8vec4& colour) {
    const float cell = size / static_cast<float>(cells);
    for (uint32_t row = 0; row <= cells; ++row) {
      for (uint32_t column = 0; column <= cells; ++column) {
        const float x = (static_cast<float>(column) + random.real(-0.3F, 0.3F)) * cell - 0.5F * size;
        const float y = (static_cast<float>(row) + random.real(-0.3F, 0.3F)) * cell - 0.5F * size;
        positions.emplace_back(x, y, 0.0F);
        colours.push_back(colour);
      }
    }
    for (uint32_t row = 0; row < cells; ++row) {
      for (uint32_t column = 0; column < cells; ++column) {
        const uint32_t a = row * (cells + 1) + column;
        const uint32_t d = a + cells + 1;
        indices.insert(indices.end(), {a, a + 1, d + 1, a, d + 1, d});
      }
    }
  }

  MeshView view() const { return MeshView{positions, {}, colours, indices}; }
};

// Turned about the y axis by an angle with this sine and cosine, then moved.
glm::mat4 placed(float sine, float cosine, float z) {
  glm::mat4 m(1.0F);
  m[0] = glm::vec4(cosine, 0.0F, -sine, 0.0F);
  m[2] = glm::vec4(sine, 0.0F, cosine, 0.0F);
  m[3] = glm::vec4(0.0F, 0.0F, z, 1.0F);
  return m;
}

TEST_P(Depth, TwoMillimetresAreToldApartFromThirtyCentimetresToThreeMetres) {
  const struct { float sine, cosine; } turns[] = {{0.0F, 1.0F}, {0.6F, 0.8F}, {-0.8F, 0.6F}, {0.96F, 0.28F}};
  Random random(70);
  for (const float distance : {0.3F, 0.6F, 1.0F, 1.7F, 3.0F}) {
    for (const auto& turn : turns) {
      const Sheet palm(random, 20, 0.12F, glm::u8vec4(200, 0, 0, 255));
      const Sheet tip(random, 6, 0.04F, glm::u8vec4(0, 200, 0, 255));
      for (const int samples : {1, 4}) {
        for (const bool tip_first : {false, true}) {
          Screen screen(64, 64, samples);
          // A lens long enough that the tip covers most of the frame at every distance.
          screen.renderer.set_camera(look_at(glm::vec3(0.0F), glm::vec3(0.0F, 0.0F, -1.0F), glm::vec3(0.0F, 1.0F, 0.0F),
                                             distance / 0.03F, 1.0F, 0.02F));
          const glm::mat4 palm_at = placed(turn.sine, turn.cosine, -distance);
          const glm::mat4 tip_at = placed(turn.sine, turn.cosine, -distance + 0.002F);
          if (tip_first) screen.renderer.draw(tip.view(), tip_at, Shading::kFlat);
          screen.renderer.draw(palm.view(), palm_at, Shading::kFlat);
          if (!tip_first) screen.renderer.draw(tip.view(), tip_at, Shading::kFlat);
          screen.end();

          Screen alone(64, 64, samples);
          alone.renderer.set_camera(look_at(glm::vec3(0.0F), glm::vec3(0.0F, 0.0F, -1.0F), glm::vec3(0.0F, 1.0F, 0.0F),
                                            distance / 0.03F, 1.0F, 0.02F));
          alone.renderer.draw(tip.view(), tip_at, Shading::kFlat);
          alone.end();
          int hidden = 0;
          int shown = 0;
          for (size_t i = 0; i < alone.pixels.size(); ++i) {
            if (green_of(alone.pixels[i]) != 200U) continue;  // covered by the tip in all samples
            ++shown;
            hidden += screen.pixels[i] != alone.pixels[i] ? 1 : 0;
          }
          EXPECT_EQ(hidden, 0) << "at " << distance << " m, turn " << turn.sine << ", samples " << samples;
          EXPECT_GT(shown, 200);
        }
      }
    }
  }
}

TEST_P(Depth, NearerWinsAndTheFirstStaysAtEqualDepth) {
  const Triangle whole = {Point{-99, -99}, Point{-99, 99999}, Point{99999, -99}};
  Screen screen(16, 16);
  screen.add(whole, glm::u8vec4(1, 0, 0, 255), 0.5F);
  screen.add(whole, glm::u8vec4(2, 0, 0, 255), 0.5F);
  screen.add(whole, glm::u8vec4(3, 0, 0, 255), std::nextafter(0.5F, 0.0F));
  screen.end();
  for (const uint32_t pixel : screen.pixels)
    ASSERT_EQ(red_of(pixel), 1U);
  screen.begin();
  screen.add(whole, glm::u8vec4(1, 0, 0, 255), 0.5F);
  screen.add(whole, glm::u8vec4(2, 0, 0, 255), std::nextafter(0.5F, 1.0F));
  screen.end();
  for (const uint32_t pixel : screen.pixels)
    ASSERT_EQ(red_of(pixel), 2U);
}

TEST_P(Depth, OrderOfTrianglesDoesNotChangeThePicture) {
  Random random(71);
  for (const int samples : {1, 2, 4, 8}) {
    for (int scene = 0; scene < 40; ++scene) {
      struct Item {
        Triangle triangle;
        glm::u8vec4 colour;
        float depth;
      };
      std::vector<Item> items;
      for (int i = 0; i < 40; ++i) {
        Triangle t;
        for (Point& p : t)
          p = {random.between(-2000, 10000), random.between(-2000, 10000)};
        const auto red = static_cast<uint8_t>(random.between(0, 255));
        const auto green = static_cast<uint8_t>(random.between(0, 255));
        items.push_back({t, glm::u8vec4(red, green, 90, 255), static_cast<float>(i + 1) / 64.0F});
      }
      std::vector<uint32_t> first;
      for (int order = 0; order < 4; ++order) {
        Screen screen(32, 32, samples);
        for (const Item& item : items)
          screen.add(item.triangle, item.colour, item.depth);
        screen.end();
        if (order == 0) first = screen.pixels;
        ASSERT_EQ(screen.pixels, first) << "scene " << scene << ", order " << order;
        for (size_t i = items.size() - 1; i > 0; --i) {
          std::swap(items[i], items[static_cast<size_t>(random.between(0, static_cast<int64_t>(i)))]);
        }
      }
    }
  }
}

// Two walls that pass through each other meet in a straight line where their depths are equal.
TEST_P(Depth, CrossingWallsMeetWhereTheirDepthsAreEqual) {
  Screen screen(64, 64);
  const glm::vec3 positions[8] = {glm::vec3(-1, -1, 0.25F), glm::vec3(1, -1, 0.75F), glm::vec3(1, 1, 0.75F),
                                  glm::vec3(-1, 1, 0.25F),  glm::vec3(-1, -1, 0.6F), glm::vec3(1, -1, 0.6F),
                                  glm::vec3(1, 1, 0.6F),    glm::vec3(-1, 1, 0.6F)};
  std::vector<glm::u8vec4> colours(8, glm::u8vec4(255, 0, 0, 255));
  for (size_t i = 4; i < 8; ++i)
    colours[i] = glm::u8vec4(0, 0, 255, 255);
  const uint32_t indices[12] = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
  screen.renderer.draw(MeshView{positions, {}, colours, indices}, glm::mat4(1.0F), Shading::kFlat);
  screen.end();
  // 0.25 + 0.5 * (column + 0.5) / 64 exceeds 0.6 where column > 44.3.
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 64; ++column) {
      ASSERT_EQ(screen.pixel(column, row), column >= 45 ? 0xFF0000U : 0x0000FFU) << column;
    }
  }
}

}  // namespace
}  // namespace auslan::raster
