// SPDX-License-Identifier: Apache-2.0
// Colour: the sRGB curve, Lambert's law in linear light, and interpolation between vertices.
#include "raster/srgb.h"
#include "raster_screen.h"

#include <cmath>
#include <limits>

namespace auslan::raster {
namespace {

// IEC 61966-2-1 as it is written, for comparison.
double decode(double level) {
  const double s = level / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

double encode(double light) {
  if (light <= 0.0) return 0.0;
  if (light >= 1.0) return 255.0;
  return 255.0 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055);
}

TEST(Srgb, FollowsTheStandardCurve) {
  for (int code = 0; code < 256; ++code) {
    const auto byte = static_cast<uint8_t>(code);
    EXPECT_NEAR(encode(static_cast<double>(linear_from_srgb(byte))), code, 0.02);
  }
  for (int i = 0; i <= 100000; ++i) {
    const double light = i / 100000.0;
    ASSERT_NEAR(srgb_level_from_linear(static_cast<float>(light)), encode(light), 0.02) << light;
  }
}

TEST(Srgb, EncodingUndoesDecoding) {
  for (int code = 0; code < 256; ++code) {
    const auto byte = static_cast<uint8_t>(code);
    EXPECT_NEAR(srgb_level_from_linear(linear_from_srgb(byte)), code, 0.04);
  }
}

TEST(Srgb, IsTotal) {
  EXPECT_EQ(srgb_level_from_linear(std::numeric_limits<float>::quiet_NaN()), 0.0F);
  EXPECT_EQ(srgb_level_from_linear(-1.0F), 0.0F);
  EXPECT_EQ(srgb_level_from_linear(-std::numeric_limits<float>::infinity()), 0.0F);
  EXPECT_EQ(srgb_level_from_linear(1.0F), 255.0F);
  EXPECT_EQ(srgb_level_from_linear(std::numeric_limits<float>::infinity()), 255.0F);
}

class Lambert : public OnEveryKernel {};
ON_EVERY_KERNEL(Lambert);
class Gouraud : public OnEveryKernel {};
ON_EVERY_KERNEL(Gouraud);
class Flat : public OnEveryKernel {};
ON_EVERY_KERNEL(Flat);

const glm::vec3 kTowardsViewer(0.0F, 0.0F, 1.0F);

// One square that fills the frame, facing the viewer, with a normal, a colour and a placement of our choice.
uint32_t lit_pixel(const Lighting& lighting, const glm::vec3& normal, const glm::u8vec4& colour,
                   Shading shading = Shading::kGouraud, const glm::mat4& world = glm::mat4(1.0F)) {
  Screen screen(8, 8);
  const glm::vec3 positions[4] = {glm::vec3(-1, -1, 0.5F), glm::vec3(1, -1, 0.5F), glm::vec3(1, 1, 0.5F),
                                  glm::vec3(-1, 1, 0.5F)};
  const glm::vec3 normals[4] = {normal, normal, normal, normal};
  const glm::u8vec4 colours[4] = {colour, colour, colour, colour};
  const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
  screen.renderer.set_lighting(lighting);
  screen.renderer.draw(MeshView{positions, normals, colours, indices}, world, shading);
  screen.end();
  for (const uint32_t pixel : screen.pixels)
    EXPECT_EQ(pixel, screen.pixels[0]);
  return screen.pixels[0];
}

uint32_t expected(double red_light, double green_light, double blue_light, const glm::u8vec4& colour) {
  const auto code = [](double light, uint8_t c) {
    return static_cast<uint32_t>(std::lround(encode(light * decode(c))));
  };
  return pack_pixel(code(red_light, colour.x), code(green_light, colour.y), code(blue_light, colour.z));
}

Lighting key_only(const glm::vec3& direction, const glm::vec3& colour) {
  Lighting lighting;
  lighting.key_direction = direction;
  lighting.key_colour = colour;
  lighting.ambient_sky = glm::vec3(0.0F);
  lighting.ambient_ground = glm::vec3(0.0F);
  return lighting;
}

constexpr glm::u8vec4 kSkin(224, 172, 140, 255);

TEST_P(Lambert, LightFallsWithTheCosineOfTheAngle) {
  // Directions of Pythagorean triples: the cosines are exact.
  const struct {
    glm::vec3 direction;
    double cosine;
  } cases[] = {{glm::vec3(0, 0, 1), 1.0}, {glm::vec3(3, 0, 4), 0.8},         {glm::vec3(0, -4, 3), 0.6},
               {glm::vec3(4, 0, 3), 0.6}, {glm::vec3(12, 0, 5), 5.0 / 13.0}, {glm::vec3(2, 3, 6), 6.0 / 7.0},
               {glm::vec3(1, 0, 0), 0.0}, {glm::vec3(3, 0, -4), 0.0},        {glm::vec3(0, 0, -1), 0.0}};
  for (const auto& c : cases) {
    const Lighting lighting = key_only(c.direction, glm::vec3(0.9F, 0.7F, 0.5F));
    const uint32_t wanted = expected(0.9 * c.cosine, 0.7 * c.cosine, 0.5 * c.cosine, kSkin);
    EXPECT_EQ(lit_pixel(lighting, kTowardsViewer, kSkin, Shading::kGouraud), wanted) << c.cosine;
    EXPECT_EQ(lit_pixel(lighting, kTowardsViewer, kSkin, Shading::kFlat), wanted) << c.cosine;
  }
}

TEST_P(Lambert, LengthOfNormalAndDirectionDoesNotMatter) {
  const uint32_t wanted = expected(0.8, 0.8, 0.8, kSkin);
  for (const float length : {1e-30F, 1e-18F, 1e-3F, 1.0F, 1e5F, 1e18F, 1e30F, 3e38F}) {
    const Lighting lighting = key_only(glm::vec3(0.6F * length, 0.0F, 0.8F * length), glm::vec3(1.0F));
    EXPECT_EQ(lit_pixel(lighting, glm::vec3(0.0F, 0.0F, length), kSkin), wanted) << length;
  }
}

TEST_P(Lambert, LightsAdd) {
  Lighting lighting = key_only(glm::vec3(3, 0, 4), glm::vec3(0.5F));
  lighting.fill_direction = glm::vec3(-4, 0, 3);
  lighting.fill_colour = glm::vec3(0.25F, 0.0F, 0.5F);
  lighting.ambient_sky = glm::vec3(0.125F);
  lighting.ambient_ground = glm::vec3(0.125F);
  const double base = 0.125 + 0.5 * 0.8;
  EXPECT_EQ(lit_pixel(lighting, kTowardsViewer, kSkin), expected(base + 0.25 * 0.6, base, base + 0.5 * 0.6, kSkin));
}

TEST_P(Lambert, TheRimFollowsTheSameLawAndAddsToTheOthers) {
  Lighting lighting = key_only(glm::vec3(3, 0, 4), glm::vec3(0.5F));
  lighting.rim_direction = glm::vec3(0, 12, -5);
  lighting.rim_colour = glm::vec3(0.5F, 0.25F, 0.0F);
  // Facing the viewer the rim gives nothing; facing up it comes at 12/13 and the key at 0; at 45 degrees between up and
  // back as the cosine says.
  const double slanted = (12.0 + 5.0) / 13.0 * std::sqrt(0.5);
  const struct {
    glm::vec3 normal;
    double key, rim;
  } cases[] = {{glm::vec3(0, 0, 1), 0.8, 0.0},
               {glm::vec3(0, 1, 0), 0.0, 12.0 / 13.0},
               {glm::vec3(0, 1, -1), 0.0, slanted},
               {glm::vec3(0.6F, 0.8F, 0), 0.36, 0.8 * 12.0 / 13.0}};
  for (const auto& c : cases) {
    const double base = 0.5 * c.key;
    EXPECT_EQ(lit_pixel(lighting, c.normal, kSkin), expected(base + 0.5 * c.rim, base + 0.25 * c.rim, base, kSkin));
  }
  lighting.rim_direction = glm::vec3(0, -4, 3);
  EXPECT_EQ(lit_pixel(lighting, kTowardsViewer, kSkin, Shading::kFlat),
            expected(0.4 + 0.5 * 0.6, 0.4 + 0.25 * 0.6, 0.4, kSkin));
  lighting.rim_colour = glm::vec3(0.0F);
  EXPECT_EQ(lit_pixel(lighting, kTowardsViewer, kSkin), expected(0.4, 0.4, 0.4, kSkin));
}

TEST_P(Lambert, AmbientIsAHemisphere) {
  Lighting lighting = key_only(glm::vec3(0, 0, 1), glm::vec3(0.0F));
  lighting.ambient_sky = glm::vec3(0.8F, 0.6F, 0.4F);
  lighting.ambient_ground = glm::vec3(0.2F, 0.1F, 0.0F);
  EXPECT_EQ(lit_pixel(lighting, glm::vec3(0, 1, 0), kSkin), expected(0.8, 0.6, 0.4, kSkin));
  EXPECT_EQ(lit_pixel(lighting, glm::vec3(0, -1, 0), kSkin), expected(0.2, 0.1, 0.0, kSkin));
  EXPECT_EQ(lit_pixel(lighting, glm::vec3(0, 0, 1), kSkin), expected(0.5, 0.35, 0.2, kSkin));
  EXPECT_EQ(lit_pixel(lighting, glm::vec3(0.8F, 0.6F, 0), kSkin), expected(0.68, 0.5, 0.32, kSkin));
}

TEST_P(Lambert, TooMuchLightIsWhiteNotWrapped) {
  const Lighting lighting = key_only(glm::vec3(0, 0, 1), glm::vec3(1e30F));
  EXPECT_EQ(lit_pixel(lighting, kTowardsViewer, glm::u8vec4(255, 128, 1, 255)), 0xFFFFFFU);
  EXPECT_EQ(lit_pixel(lighting, kTowardsViewer, glm::u8vec4(255, 0, 0, 255)), 0xFF0000U);
}

// A surface squashed in z turns its normals towards z, not away from it: normals are no directions of travel.
TEST_P(Lambert, NormalsFollowScaledPlacements) {
  glm::mat4 squashed(1.0F);
  squashed[0][0] = 4.0F;  // of a normal (3, 0, 1) remains (3/4, 0, 1), cosine 4/5 to z
  EXPECT_EQ(
      lit_pixel(key_only(glm::vec3(0, 0, 1), glm::vec3(1.0F)), glm::vec3(3, 0, 1), kSkin, Shading::kGouraud, squashed),
      expected(0.8, 0.8, 0.8, kSkin));
}

TEST_P(Lambert, MirroredPlacementsKeepTheOutsideOutside) {
  glm::mat4 mirror(1.0F);
  mirror[0][0] = -1.0F;
  const Lighting lighting = key_only(glm::vec3(3, 0, 4), glm::vec3(1.0F));
  for (const Shading shading : {Shading::kGouraud, Shading::kFlat}) {
    EXPECT_EQ(lit_pixel(lighting, kTowardsViewer, kSkin, shading, mirror), expected(0.8, 0.8, 0.8, kSkin));
  }
}

// A corner exactly on a pixel centre (and inside by the top-left rule) shows its own colour.
TEST_P(Gouraud, AVertexShowsItsOwnColour) {
  Random random(80);
  for (int i = 0; i < 500; ++i) {
    Screen screen(32, 32);
    // The top-left corner of a triangle with a level top edge and a left edge down from it is covered.
    const auto column = static_cast<int>(random.between(0, 20));
    const auto row = static_cast<int>(random.between(0, 20));
    const Point top_left = centre(column, row);
    const glm::vec3 positions[3] = {
        screen.place(top_left),
        screen.place({top_left.x + random.between(0, 900), top_left.y + random.between(300, 2500)}),
        screen.place({top_left.x + random.between(1000, 2500), top_left.y})};
    const glm::vec3 normals[3] = {kTowardsViewer, kTowardsViewer, kTowardsViewer};
    glm::u8vec4 colours[3];
    for (glm::u8vec4& c : colours) {
      for (int channel = 0; channel < 3; ++channel)
        c[channel] = static_cast<uint8_t>(random.between(0, 255));
    }
    const uint32_t indices[3] = {static_cast<uint32_t>(i % 3), static_cast<uint32_t>((i + 1) % 3),
                                 static_cast<uint32_t>((i + 2) % 3)};
    screen.renderer.draw(MeshView{positions, normals, colours, indices}, glm::mat4(1.0F), Shading::kGouraud);
    screen.end();
    ASSERT_EQ(screen.pixel(column, row), pack_pixel(colours[0].x, colours[0].y, colours[0].z)) << i;
  }
}

TEST_P(Gouraud, IsLinearInTheEncodedSpaceBetweenVertices) {
  Screen screen(256, 8);
  const glm::vec3 positions[4] = {glm::vec3(-1, -1, 0.5F), glm::vec3(1, -1, 0.5F), glm::vec3(1, 1, 0.5F),
                                  glm::vec3(-1, 1, 0.5F)};
  const std::vector<glm::vec3> normals(4, kTowardsViewer);
  const glm::u8vec4 colours[4] = {glm::u8vec4(0, 200, 10, 255), glm::u8vec4(255, 60, 30, 255),
                                  glm::u8vec4(255, 60, 30, 255), glm::u8vec4(0, 200, 10, 255)};
  const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
  screen.renderer.draw(MeshView{positions, normals, colours, indices}, glm::mat4(1.0F), Shading::kGouraud);
  screen.end();
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 256; ++column) {
      const double t = (column + 0.5) / 256.0;
      const uint32_t pixel = screen.pixel(column, row);
      ASSERT_NEAR(red_of(pixel), 255.0 * t, 0.53) << column;
      ASSERT_NEAR(green_of(pixel), 200.0 - 140.0 * t, 0.53) << column;
      ASSERT_NEAR(blue_of(pixel), 10.0 + 20.0 * t, 0.53) << column;
    }
  }
}

// A floor that recedes from 1 m to 9 m: half-way up the screen is not half-way along the floor.
TEST_P(Gouraud, IsPerspectiveCorrect) {
  Screen screen(64, 64);
  screen.renderer.set_camera(
      look_at(glm::vec3(0.0F), glm::vec3(0.0F, 0.0F, -1.0F), glm::vec3(0.0F, 1.0F, 0.0F), 1.0F, 1.0F, 0.1F));
  const glm::vec3 positions[4] = {glm::vec3(-20, -1, -1), glm::vec3(20, -1, -1), glm::vec3(20, -1, -9),
                                  glm::vec3(-20, -1, -9)};
  const std::vector<glm::vec3> normals(4, glm::vec3(0, 1, 0));
  const glm::u8vec4 colours[4] = {glm::u8vec4(0, 0, 0, 255), glm::u8vec4(0, 0, 0, 255), glm::u8vec4(240, 240, 240, 255),
                                  glm::u8vec4(240, 240, 240, 255)};
  const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
  screen.renderer.draw(MeshView{positions, normals, colours, indices}, glm::mat4(1.0F), Shading::kGouraud);
  screen.end();
  double worst_affine = 0.0;
  for (int row = 36; row < 64; ++row) {
    const double slope = (row + 0.5 - 32.0) / 32.0;  // the ray falls this much a metre: it meets y = -1 at 1 / slope
    const double correct = 240.0 * (1.0 / slope - 1.0) / 8.0;
    const double affine = 240.0 * (1.0 - slope) / (1.0 - 1.0 / 9.0);
    worst_affine = std::max(worst_affine, std::abs(affine - correct));
    for (int column = 0; column < 64; ++column) {
      // Corners snap to 1/256 pixel; the steepest row changes by 240 / 8 / slope^2 / 32 levels a pixel.
      ASSERT_NEAR(red_of(screen.pixel(column, row)), correct, 0.65 + 0.15 / (slope * slope) / 8.0) << row;
    }
  }
  EXPECT_GT(worst_affine, 50.0) << "the scene should tell affine from correct";
}

// The affine short cut: over random triangles at an arm's length, never more than 1/4 level from the exact colour.
TEST_P(Gouraud, ShortCutStaysWithinItsBound) {
  Random random(81);
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    Screen screen(64, 64);
    screen.renderer.set_camera(
        look_at(glm::vec3(0.0F), glm::vec3(0.0F, 0.0F, -1.0F), glm::vec3(0.0F, 1.0F, 0.0F), 1.0F, 1.0F, 0.1F));
    const float depth = random.real(0.0F, 0.02F) * static_cast<float>(i % 4);
    const float w[2] = {1.0F, 1.0F + depth};
    // A strip across the frame, nearer on the left; colours by position, so that exactness can be told along x.
    const glm::vec3 positions[4] = {glm::vec3(-w[0], -w[0], -w[0]), glm::vec3(w[1], -w[1], -w[1]),
                                    glm::vec3(w[1], w[1], -w[1]), glm::vec3(-w[0], w[0], -w[0])};
    const std::vector<glm::vec3> normals(4, kTowardsViewer);
    const auto low = static_cast<uint8_t>(random.between(0, 100));
    const auto high = static_cast<uint8_t>(random.between(101, 255));
    const glm::u8vec4 near_colour(low, low, low, 255);
    const glm::u8vec4 far_colour(high, high, high, 255);
    const glm::u8vec4 colours[4] = {near_colour, far_colour, far_colour, near_colour};
    const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    screen.renderer.draw(MeshView{positions, normals, colours, indices}, glm::mat4(1.0F), Shading::kGouraud);
    screen.end();
    for (int column = 0; column < 64; ++column) {
      const double t = (column + 0.5) / 64.0;
      const double along =
          (t / static_cast<double>(w[1])) / ((1.0 - t) / static_cast<double>(w[0]) + t / static_cast<double>(w[1]));
      const double correct = low + (high - low) * along;
      // 1/2 for rounding, 1/4 for the short cut, 1/4 for gradients in fixed point, 0.02 for the curve.
      ASSERT_NEAR(red_of(screen.pixel(column, 32)), correct, 1.02) << "case " << i << ", column " << column;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 400 * 64);
}

// Triangles of up to 119 pixels, which have a path of their own: every pixel within a level of the plane through its
// corners' colours, and none brighter or darker than they are. Not slivers, whose planes are steeper than levels can
// tell.
TEST_P(Gouraud, SmallTrianglesFollowThePlaneThroughTheirCorners) {
  Random random(82);
  constexpr int kCell = 128;
  constexpr int kAcross = 8;
  constexpr int64_t kReaches[] = {6, 30, 119, 119};
  double sum = 0.0;
  int64_t compared = 0;
  for (int frame = 0; frame < 8; ++frame) {
    Screen screen(kCell * kAcross, kCell * kAcross);
    std::vector<Triangle> triangles;
    std::vector<glm::vec3> positions;
    std::vector<glm::u8vec4> colours;
    std::vector<uint32_t> indices;
    while (triangles.size() < kAcross * kAcross) {
      const auto cell = static_cast<int64_t>(triangles.size());
      const int64_t reach = kReaches[random.between(0, 3)] * 256;
      Triangle t;
      for (Point& p : t) {
        p.x = random.between(0, reach) + cell % kAcross * kCell * 256;
        p.y = random.between(0, reach) + cell / kAcross * kCell * 256;
      }
      double longest = 0.0;
      for (size_t i = 0; i < 3; ++i) {
        const auto dx = static_cast<double>(t[i].x - t[(i + 1) % 3].x);
        const auto dy = static_cast<double>(t[i].y - t[(i + 1) % 3].y);
        longest = std::max(longest, std::sqrt(dx * dx + dy * dy));
      }
      // At least two pixels across everywhere.
      if (std::abs(static_cast<double>(doubled_area(t[0], t[1], t[2]))) < longest * 512.0) continue;
      triangles.push_back(t);
      for (const Point& p : t) {
        indices.push_back(static_cast<uint32_t>(positions.size()));
        positions.push_back(screen.place(p));
        const uint64_t colour = random.next();
        colours.emplace_back(colour & 255U, colour >> 8U & 255U, colour >> 16U & 255U, 255);
      }
    }
    screen.add_mesh(positions, std::vector<glm::vec3>(positions.size(), kTowardsViewer), colours, indices,
                    Shading::kGouraud);
    screen.end();
    for (int row = 0; row < screen.height(); ++row) {
      for (int column = 0; column < screen.width(); ++column) {
        const auto cell = static_cast<size_t>(row / kCell * kAcross + column / kCell);
        const Triangle& t = triangles[cell];
        const Point here = centre(column, row);
        if (!covers(t, here)) continue;
        const auto area = static_cast<double>(doubled_area(t[0], t[1], t[2]));
        const uint32_t pixel = screen.pixel(column, row);
        const uint32_t drawn[3] = {red_of(pixel), green_of(pixel), blue_of(pixel)};
        for (int channel = 0; channel < 3; ++channel) {
          double exact = 0.0;
          for (size_t i = 0; i < 3; ++i) {
            exact += colours[3 * cell + i][channel] *
                     static_cast<double>(doubled_area(t[(i + 1) % 3], t[(i + 2) % 3], here)) / area;
          }
          ASSERT_NEAR(drawn[channel], exact, 1.0) << column << ", " << row;
          const auto [least, greatest] =
              std::minmax({colours[3 * cell][channel], colours[3 * cell + 1][channel], colours[3 * cell + 2][channel]});
          ASSERT_TRUE(drawn[channel] >= least && drawn[channel] <= greatest) << column << ", " << row;
          sum += drawn[channel] - exact;
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 100000);
  EXPECT_NEAR(sum / static_cast<double>(compared), 0.0, 0.02) << "rounding should favour neither side";
}

TEST_P(Flat, AFaceHasOneColour) {
  Screen screen(16, 16);
  const glm::vec3 positions[3] = {glm::vec3(-1, -1, 0.5F), glm::vec3(3, -1, 0.5F), glm::vec3(-1, 3, 0.5F)};
  const glm::u8vec4 colours[3] = {glm::u8vec4(255, 0, 0, 255), glm::u8vec4(0, 255, 0, 255),
                                  glm::u8vec4(0, 0, 255, 255)};
  const uint32_t indices[3] = {0, 1, 2};
  screen.renderer.draw(MeshView{positions, {}, colours, indices}, glm::mat4(1.0F), Shading::kFlat);
  screen.end();
  const auto third = static_cast<uint32_t>(std::lround(encode(1.0 / 3.0)));  // the mean in linear light
  for (const uint32_t pixel : screen.pixels)
    ASSERT_EQ(pixel, pack_pixel(third, third, third));
}

}  // namespace
}  // namespace auslan::raster
