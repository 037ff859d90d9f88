// SPDX-License-Identifier: Apache-2.0
// Textures: which texel a pixel shows, against ray and plane in double precision, the sRGB standard's formula and
// means; and that a texture changes nothing of what is covered and how deep it lies.
#include "raster_screen.h"
#include "raster_textured.h"

#include <cmath>
#include <limits>

namespace auslan::raster {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class TextureOn : public OnEveryKernel {};
ON_EVERY_KERNEL(TextureOn);

// The sRGB standard's formulas (IEC 61966-2-1).
double light_of(double level) {
  const double s = level / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}
double level_of(double light) {
  return 255.0 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055);
}

uint32_t pixel_of(const glm::u8vec4& c) {
  return pack_pixel(c.x, c.y, c.z);
}

// White rectangles on a Screen's sub-pixel grid that wear textures, lit so that nothing changes their colour.
struct Board {
  Screen screen;
  struct Part {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> coordinates;
    std::vector<glm::vec3> normals = std::vector<glm::vec3>(4, glm::vec3(0.0F, 0.0F, 1.0F));
    std::vector<glm::u8vec4> colours = std::vector<glm::u8vec4>(4, glm::u8vec4(255));
    std::vector<uint32_t> indices = {0, 1, 2, 0, 2, 3};
  };
  std::deque<Part> parts;

  Board(int width, int height, int samples = 1) : screen(width, height, samples) {}

  // From pixel (x0, y0) to (x1, y1), where the coordinates are `from` and `to`.
  Part& add(const glm::vec4& pixels, const glm::vec2& from, const glm::vec2& to, TextureUse use, float depth = 0.5F,
            Shading shading = Shading::kGouraud) {
    Part& part = make(pixels, from, to, depth);
    use.coordinates = part.coordinates;
    draw(part, use, shading);
    return part;
  }
  Part& make(const glm::vec4& pixels, const glm::vec2& from, const glm::vec2& to, float depth = 0.5F) {
    const auto point = [&](float x, float y) {
      return screen.place({static_cast<int64_t>(x * 256.0F), static_cast<int64_t>(y * 256.0F)}, depth);
    };
    Part& part = parts.emplace_back();
    part.positions = {point(pixels.x, pixels.w), point(pixels.z, pixels.w), point(pixels.z, pixels.y),
                      point(pixels.x, pixels.y)};
    part.coordinates = {glm::vec2(from.x, to.y), to, glm::vec2(to.x, from.y), from};
    return part;
  }
  void draw(const Part& part, const TextureUse& use, Shading shading = Shading::kGouraud) {
    MeshView mesh{part.positions, part.normals, part.colours, part.indices};
    mesh.texture = use;
    screen.renderer.draw(mesh, glm::mat4(1.0F), shading, CullMode::kBack);
  }
};

glm::vec4 whole(const Board& board) {
  return glm::vec4(0.0F, 0.0F, static_cast<float>(board.screen.width()), static_cast<float>(board.screen.height()));
}

TEST_P(TextureOn, APixelForEachTexelShowsTheTexels) {
  const int sizes[][2] = {{1, 1}, {64, 32}, {33, 17}, {256, 128}, {200, 77}};
  for (const auto& size : sizes) {
    const TestPicture picture = random_picture(size[0], size[1], 700);
    const Texture texture = picture.texture();
    for (const int samples : {1, 2, 4, 8}) {
      for (const Shading shading : {Shading::kGouraud, Shading::kFlat}) {
        Board board(256, 128, samples);
        const glm::vec4 place(0.0F, 0.0F, static_cast<float>(size[0]), static_cast<float>(size[1]));
        board.add(place, glm::vec2(0.0F), glm::vec2(1.0F), {&texture}, 0.5F, shading);
        board.screen.end();
        for (int y = 0; y < 128; ++y) {
          for (int x = 0; x < 256; ++x) {
            const bool inside = x < size[0] && y < size[1];
            ASSERT_EQ(board.screen.pixel(x, y), inside ? pixel_of(picture.at(x, y)) : 0U)
                << x << ", " << y << " of " << size[0] << " x " << size[1] << ", " << samples << " samples";
          }
        }
      }
    }
  }
}

TEST_P(TextureOn, HalfwayBetweenTwoTexelsIsTheMeanOfTheirLight) {
  TestPicture picture(2, 1);
  for (const auto& [one, other] : {std::pair(0, 255), std::pair(12, 200), std::pair(90, 91)}) {
    picture.at(0, 0) = glm::u8vec4(one, other, one, 255);
    picture.at(1, 0) = glm::u8vec4(other, one, one, 255);
    const Texture texture = picture.texture();
    Board board(8, 8);
    board.add(whole(board), glm::vec2(0.5F), glm::vec2(0.5F), {&texture});
    board.screen.end();
    const double mean = level_of(0.5 * (light_of(one) + light_of(other)));
    EXPECT_NEAR(red_of(board.screen.pixel(4, 4)), mean, 0.6);
    EXPECT_NEAR(green_of(board.screen.pixel(4, 4)), mean, 0.6);
    EXPECT_EQ(blue_of(board.screen.pixel(4, 4)), static_cast<uint32_t>(one));
  }
}

// Which texel of `size` is shown at a whole number of texels from the first one.
int wrapped(int place, int size, Wrap wrap) {
  switch (wrap) {
    case Wrap::kClamp:
      return place < 0 ? 0 : place < size ? place : size - 1;
    case Wrap::kRepeat:
      return (place % size + size) % size;
    default: {
      const int turn = (place % (2 * size) + 2 * size) % (2 * size);
      return turn < size ? turn : 2 * size - 1 - turn;
    }
  }
}

TEST_P(TextureOn, BeyondTheEdgesItRepeatsMirrorsOrStays) {
  const TestPicture picture = random_picture(8, 4, 710);
  const Texture texture = picture.texture();
  const Wrap wraps[] = {Wrap::kRepeat, Wrap::kMirroredRepeat, Wrap::kClamp};
  for (const Wrap wrap_u : wraps) {
    for (const Wrap wrap_v : wraps) {
      for (const int start : {0, -24, 1000}) {
        Board board(64, 32);
        const auto first = static_cast<float>(start);
        board.add(whole(board), glm::vec2(first / 8.0F, first / 4.0F),
                  glm::vec2((first + 64.0F) / 8.0F, (first + 32.0F) / 4.0F), {&texture, {}, wrap_u, wrap_v});
        board.screen.end();
        for (int y = 0; y < 32; ++y) {
          for (int x = 0; x < 64; ++x) {
            const glm::u8vec4& texel = picture.at(wrapped(start + x, 8, wrap_u), wrapped(start + y, 4, wrap_v));
            ASSERT_EQ(board.screen.pixel(x, y), pixel_of(texel))
                << x << ", " << y << ": wraps " << static_cast<int>(wrap_u) << static_cast<int>(wrap_v);
          }
        }
      }
    }
  }
}

// Between the last texel and the first one of the next period.
TEST_P(TextureOn, TheFilterReachesOverTheEdges) {
  TestPicture picture(4, 1);
  for (int x = 0; x < 4; ++x)
    picture.at(x, 0) = glm::u8vec4(x == 0 ? 255 : x == 3 ? 90 : 0);
  const Texture texture = picture.texture();
  const auto shown = [&](Wrap wrap, float u) {
    Board board(8, 8);
    board.add(whole(board), glm::vec2(u, 0.5F), glm::vec2(u, 0.5F), {&texture, {}, wrap, Wrap::kClamp});
    board.screen.end();
    return red_of(board.screen.pixel(3, 3));
  };
  const double mean = level_of(0.5 * (light_of(255) + light_of(90)));
  for (const float u : {0.0F, 1.0F, -1.0F, 7.0F}) {
    EXPECT_NEAR(shown(Wrap::kRepeat, u), mean, 0.6) << u;
    EXPECT_EQ(shown(Wrap::kMirroredRepeat, u), u == 0.0F ? 255U : 90U) << u;
    EXPECT_EQ(shown(Wrap::kClamp, u), u > 0.0F ? 90U : 255U) << u;
  }
}

// A pixel over 2^n x 2^n texels shows their mean, level n.
TEST_P(TextureOn, AShrunkenPictureShowsMeans) {
  const TestPicture picture = random_picture(256, 128, 720);
  const Texture texture = picture.texture();
  EXPECT_EQ(texture.level_count(), 9);
  for (const int shrink : {2, 4, 16, 64}) {
    Board board(256, 128);
    const glm::vec4 place(0.0F, 0.0F, static_cast<float>(256 / shrink), static_cast<float>(128 / shrink));
    board.add(place, glm::vec2(0.0F), glm::vec2(1.0F), {&texture});
    board.screen.end();
    for (int y = 0; y < 128 / shrink; ++y) {
      for (int x = 0; x < 256 / shrink; ++x) {
        double sum[3] = {};
        for (int j = 0; j < shrink; ++j) {
          for (int i = 0; i < shrink; ++i) {
            for (int c = 0; c < 3; ++c)
              sum[c] += light_of(picture.at(x * shrink + i, y * shrink + j)[c]) / (shrink * shrink);
          }
        }
        const uint32_t pixel = board.screen.pixel(x, y);
        ASSERT_NEAR(red_of(pixel), level_of(sum[0]), 1.0) << x << ", " << y << " / " << shrink;
        ASSERT_NEAR(green_of(pixel), level_of(sum[1]), 1.0) << x << ", " << y << " / " << shrink;
        ASSERT_NEAR(blue_of(pixel), level_of(sum[2]), 1.0) << x << ", " << y << " / " << shrink;
      }
    }
  }
}

TEST_P(TextureOn, TheLastLevelOfAnyPictureIsItsMean) {
  const int sizes[][2] = {{3, 5}, {37, 21}, {1, 9}, {100, 1}, {127, 63}};
  for (const auto& size : sizes) {
    const TestPicture picture = random_picture(size[0], size[1], 730);
    const Texture texture = picture.texture();
    double sum = 0.0;
    for (const glm::u8vec4& pixel : picture.pixels)
      sum += light_of(pixel.x) / (size[0] * size[1]);
    Board board(8, 8);
    board.add(glm::vec4(2.0F, 2.0F, 3.0F, 3.0F), glm::vec2(0.0F), glm::vec2(1.0F), {&texture});
    board.screen.end();
    // A pixel that holds all of it asks for a level up to half a size short of the last one when that is odd.
    EXPECT_NEAR(red_of(board.screen.pixel(2, 2)), level_of(sum), size[0] == 127 || size[0] == 37 ? 3.0 : 1.0)
        << size[0] << " x " << size[1];
    board.screen.begin();
    board.add(glm::vec4(2.0F, 2.0F, 3.0F, 3.0F), glm::vec2(0.0F), glm::vec2(64.0F), {&texture});
    board.screen.end();
    EXPECT_NEAR(red_of(board.screen.pixel(2, 2)), level_of(sum), 1.0) << size[0] << " x " << size[1];
  }
}

// The picture of a plane y = height that wears a texture, u and v along x and z, by ray and plane in double precision.
// Its texels, levels and weights follow the definition in raster/texture.h without any rounding.
struct PlaneReference {
  struct Level {
    int width, height;
    std::vector<double> light;
  };
  std::vector<Level> levels;

  // Powers of two, so that each level is a mean of fours.
  explicit PlaneReference(const TestPicture& picture) {
    Level level{picture.width, picture.height, {}};
    for (const glm::u8vec4& pixel : picture.pixels)
      level.light.push_back(light_of(pixel.x));
    levels.push_back(level);
    while (levels.back().width > 1) {
      const Level& last = levels.back();
      Level next{last.width / 2, last.height / 2, {}};
      for (int y = 0; y < next.height; ++y) {
        for (int x = 0; x < next.width; ++x) {
          const auto at = [&last, x, y](int i, int j) {
            return last.light[static_cast<size_t>((2 * y + j) * last.width + 2 * x + i)];
          };
          next.light.push_back(0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)));
        }
      }
      levels.push_back(next);
    }
  }
  double bilinear(size_t number, double u, double v) const {
    const Level& level = levels[number];
    const double x = u * level.width - 0.5;
    const double y = v * level.height - 0.5;
    const auto at = [&level](double i, double j) {
      const auto wrap = [](double k, int size) { return static_cast<int>(k - size * std::floor(k / size)); };
      return level.light[static_cast<size_t>(wrap(j, level.height) * level.width + wrap(i, level.width))];
    };
    const double i = std::floor(x);
    const double j = std::floor(y);
    const double fx = x - i;
    const double fy = y - j;
    return (1 - fy) * ((1 - fx) * at(i, j) + fx * at(i + 1, j)) +
           fy * ((1 - fx) * at(i, j + 1) + fx * at(i + 1, j + 1));
  }
  double at(double u, double v, double footprint) const {
    int exponent = 0;
    const double mantissa = std::frexp(footprint, &exponent);  // 0.5 to 1
    const double wanted = 0.5 * (exponent - 1 + 2.0 * mantissa - 1.0);
    const double level = std::min(std::max(wanted, 0.0), static_cast<double>(levels.size() - 1));
    const auto fine = static_cast<size_t>(level);
    const size_t coarse = std::min(fine + 1, levels.size() - 1);
    const double fraction = level - static_cast<double>(fine);
    return (1.0 - fraction) * bilinear(fine, u, v) + fraction * bilinear(coarse, u, v);
  }
};

TEST_P(TextureOn, AFloorInPerspectiveIsWhereRaysMeetIt) {
  // The floor runs under the camera, so it is cut at the near plane, and far to both sides.
  const TestPicture picture = checkerboard(64, 64, 32, glm::u8vec4(180), glm::u8vec4(90));
  const Texture texture = picture.texture();
  const PlaneReference reference(picture);
  constexpr int kWidth = 256;
  constexpr int kHeight = 192;
  constexpr double kCot = 1.75;
  constexpr double kFloor = -1.0;
  SceneMesh floor;
  for (const auto& [x, z] : {std::pair(-30, 10), std::pair(30, 10), std::pair(30, -30), std::pair(-30, -30)})
    floor.add(glm::vec3(x, kFloor, z), glm::vec3(0.0F, 1.0F, 0.0F), glm::u8vec4(255));
  floor.indices = {0, 1, 2, 0, 2, 3};
  const std::vector<glm::vec2> coordinates = floor_coordinates(floor);
  MeshView mesh = floor.view();
  mesh.texture = {&texture, coordinates};
  Renderer renderer(1, GetParam());
  std::vector<uint32_t> pixels(pixel_count(kWidth, kHeight));
  ASSERT_EQ(renderer.begin_frame(kWidth, kHeight, 1, 0), Status::kOk);
  renderer.set_lighting(Lighting{});
  // Eye at the origin; down and to the right by the triples 3-4-5 and 7-24-25.
  const double forward[3] = {0.28 * 0.8, -0.6, -0.96 * 0.8};
  const double right[3] = {0.96, 0.0, 0.28};
  const double up[3] = {0.28 * 0.6, 0.8, -0.96 * 0.6};
  renderer.set_camera(look_at(glm::vec3(0.0F), glm::vec3(forward[0], forward[1], forward[2]),
                              glm::vec3(0.0F, 1.0F, 0.0F), kCot, static_cast<float>(kWidth) / kHeight, 0.05F));
  renderer.draw(mesh, glm::mat4(1.0F), Shading::kGouraud);
  ASSERT_EQ(renderer.end_frame(pixels), Status::kOk);
  EXPECT_EQ(renderer.stats().clipped, 2U);

  const auto hit = [&](double column, double row, double& u, double& v) {
    const double x = (column / kWidth * 2.0 - 1.0) * (static_cast<double>(kWidth) / kHeight) / kCot;
    const double y = (1.0 - row / kHeight * 2.0) / kCot;
    double direction[3];
    for (int axis = 0; axis < 3; ++axis)
      direction[axis] = forward[axis] + x * right[axis] + y * up[axis];
    const double t = kFloor / direction[1];
    u = t * direction[0];
    v = t * direction[2];
    return t > 0.0 && std::abs(u) < 29.5 && v > -29.5;
  };
  int compared = 0;
  int dark = 0;
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      double u[5];
      double v[5];
      constexpr double kStep = 1e-4;
      const double x = column + 0.5;
      const double y = row + 0.5;
      if (!hit(x, y, u[0], v[0])) continue;
      (void)hit(x - kStep, y, u[1], v[1]);
      (void)hit(x + kStep, y, u[2], v[2]);
      (void)hit(x, y - kStep, u[3], v[3]);
      (void)hit(x, y + kStep, u[4], v[4]);
      const auto square = [&](int a, int b) {
        const double du = (u[b] - u[a]) / (2.0 * kStep) * 64.0;
        const double dv = (v[b] - v[a]) / (2.0 * kStep) * 64.0;
        return du * du + dv * dv;
      };
      const double light = reference.at(u[0], v[0], std::max(square(1, 2), square(3, 4)));
      const uint32_t pixel = pixels[static_cast<size_t>(row * kWidth + column)];
      ASSERT_NEAR(red_of(pixel), level_of(light), 1.0) << column << ", " << row << " at " << u[0] << ", " << v[0];
      ++compared;
      dark += red_of(pixel) < 135 ? 1 : 0;
    }
  }
  EXPECT_GT(compared, kWidth * kHeight / 2);
  EXPECT_GT(dark, compared / 4);
  EXPECT_LT(dark, compared * 3 / 4);
}

TEST_P(TextureOn, AFineCheckerboardFarAwayIsItsMean) {
  const Texture texture = checkerboard(256, 256, 1, glm::u8vec4(255), glm::u8vec4(0, 0, 0, 255)).texture();
  const double mean = level_of(0.5);
  Board board(64, 64);
  board.add(whole(board), glm::vec2(0.3F), glm::vec2(7.7F), {&texture});
  board.screen.end();
  for (const uint32_t pixel : board.screen.pixels)
    ASSERT_NEAR(green_of(pixel), mean, 1.0);
}

// The scene's colours of corners, light and perspective: with a white texture it shows what it shows without.
TEST_P(TextureOn, AWhiteTextureChangesNothing) {
  const Scene scene;
  const Texture white = TestPicture(checkerboard(4, 4, 1, glm::u8vec4(255), glm::u8vec4(255))).texture();
  for (const Shading shading : {Shading::kGouraud, Shading::kFlat}) {
    for (const int samples : {1, 4}) {
      const FrameSize size{320, 180, samples};
      std::vector<SceneDraw> draws = scene_draws(scene, size.width, size.height, shading);
      std::vector<uint32_t> bare;
      std::vector<uint32_t> dressed;
      Renderer renderer(1, GetParam());
      draw_list(renderer, draws, size, bare);
      const DrawStats stats = renderer.stats();
      std::deque<std::vector<glm::vec2>> coordinates;
      for (SceneDraw& draw : draws) {
        coordinates.emplace_back(draw.mesh.positions.size(), glm::vec2(0.3F, 0.7F));
        draw.mesh.texture = {&white, coordinates.back()};
      }
      draw_list(renderer, draws, size, dressed);
      EXPECT_EQ(renderer.stats().drawn, stats.drawn);
      EXPECT_EQ(renderer.stats().culled, stats.culled);
      EXPECT_EQ(renderer.stats().clipped, stats.clipped);
      for (size_t i = 0; i < bare.size(); ++i) {
        for (const int shift : {0, 8, 16}) {
          const auto a = static_cast<int>(bare[i] >> shift & 255U);
          const auto b = static_cast<int>(dressed[i] >> shift & 255U);
          // Affine short cuts and fixed-point gradients may add up to 3/4 of a level.
          ASSERT_NEAR(a, b, 2) << i % 320 << ", " << i / 320 << ", " << samples << " samples";
        }
      }
    }
  }
}

// Triangles of every kind that pierce each other, each of one colour, which half of them get from a texture: not one
// sample may change hands.
TEST_P(TextureOn, CoverageAndDepthAreThoseWithoutATexture) {
  TestPicture palette = random_picture(16, 16, 740);
  const Texture texture = palette.texture();
  for (const int samples : {1, 2, 4, 8}) {
    for (uint64_t seed = 0; seed < static_cast<uint64_t>(cases(10)); ++seed) {
      Random random(750 + seed);
      SceneMesh plain;
      SceneMesh white;
      std::vector<glm::vec2> coordinates;
      std::vector<uint8_t> dressed;
      for (uint32_t i = 0; i < 120; ++i) {
        const int column = static_cast<int>(random.between(0, 15));
        const int row = static_cast<int>(random.between(0, 15));
        dressed.push_back(random.once_in(2) ? 1 : 0);
        const float reach = random.once_in(2) ? 0.2F : random.once_in(5) ? 9.0F : 1.2F;
        const glm::vec3 middle{random.real(-1.2F, 1.2F), random.real(-1.0F, 1.0F), random.real(-1.0F, 1.5F)};
        for (int corner = 0; corner < 3; ++corner) {
          const glm::vec3 step{random.real(-reach, reach), random.real(-reach, reach), random.real(-reach, reach)};
          const glm::vec3 p(middle.x + step.x, middle.y + step.y, middle.z + step.z);
          plain.add(p, glm::vec3(0.0F, 0.0F, 1.0F), palette.at(column, row));
          white.add(p, glm::vec3(0.0F, 0.0F, 1.0F), glm::u8vec4(255));
          coordinates.emplace_back((static_cast<float>(column) + 0.5F) / 16.0F,
                                   (static_cast<float>(row) + 0.5F) / 16.0F);
        }
      }
      std::deque<std::vector<uint32_t>> indices;
      std::vector<SceneDraw> bare;
      std::vector<SceneDraw> mixed;
      for (uint32_t i = 0; i < 120; ++i) {
        indices.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        SceneDraw draw{plain.view(), glm::mat4(1.0F), Shading::kGouraud, CullMode::kNone, scene_camera(200, 150), {}};
        draw.mesh.indices = indices.back();
        bare.push_back(draw);
        if (dressed[i] != 0) {
          draw.mesh = white.view();
          draw.mesh.indices = indices.back();
          draw.mesh.texture = {&texture, coordinates};
        }
        mixed.push_back(draw);
      }
      const FrameSize size{200, 150, samples};
      Renderer renderer(1, GetParam());
      std::vector<uint32_t> wanted;
      std::vector<uint32_t> pixels;
      draw_list(renderer, bare, size, wanted);
      const DrawStats stats = renderer.stats();
      draw_list(renderer, mixed, size, pixels);
      EXPECT_EQ(renderer.stats().drawn, stats.drawn);
      size_t differing = 0;
      for (size_t i = 0; i < wanted.size(); ++i)
        differing += wanted[i] != pixels[i] ? 1U : 0U;
      ASSERT_EQ(differing, 0U) << "seed " << seed << ", " << samples << " samples";
    }
  }
}

TEST_P(TextureOn, EveryKernelAndNumberOfThreadsGivesTheSameBytes) {
  const TexturedScene scene;
  Renderer reference(1, Kernel::kScalar);
  for (const int samples : {1, 2, 4, 8}) {
    for (const Shading shading : {Shading::kGouraud, Shading::kFlat}) {
      const FrameSize size{333, 181, samples};
      const std::vector<SceneDraw> draws = scene.draws(size.width, size.height, shading);
      std::vector<uint32_t> wanted;
      draw_list(reference, draws, size, wanted);
      for (const int threads : {1, 2, 5}) {
        Renderer renderer(threads, GetParam());
        std::vector<uint32_t> pixels;
        draw_list(renderer, draws, size, pixels);
        ASSERT_TRUE(pixels == wanted) << samples << " samples, " << threads << " threads";
      }
    }
  }
}

TEST_P(TextureOn, TheLightOfTheCornersIsMultipliedWithTheTexels) {
  TestPicture picture(1, 1);
  picture.at(0, 0) = glm::u8vec4(200, 100, 30, 0);
  const Texture texture = picture.texture();
  for (const Shading shading : {Shading::kGouraud, Shading::kFlat}) {
    Board board(16, 16);
    Board::Part& part = board.make(whole(board), glm::vec2(0.0F), glm::vec2(1.0F));
    part.colours.assign(4, glm::u8vec4(128, 255, 64, 255));
    Lighting lighting;
    lighting.ambient_sky = lighting.ambient_ground = glm::vec3(0.5F, 0.25F, 1.0F);
    board.screen.renderer.set_lighting(lighting);
    board.draw(part, {&texture, part.coordinates}, shading);
    board.screen.end();
    const uint32_t pixel = board.screen.pixel(5, 9);
    const double tolerance = shading == Shading::kFlat ? 1.0 : 0.6;  // a flat colour is a whole number of levels
    EXPECT_NEAR(red_of(pixel), level_of(0.5 * light_of(128) * light_of(200)), tolerance);
    EXPECT_NEAR(green_of(pixel), level_of(0.25 * light_of(100)), tolerance);
    EXPECT_NEAR(blue_of(pixel), level_of(light_of(64) * light_of(30)), tolerance);
  }
}

// Left half cut out, right half there; alphas next to the cut-off.
TEST_P(TextureOn, AMaskCutsOutWhatLiesBelowItsCutOff) {
  const glm::u8vec4 behind(20, 200, 90, 255);
  for (const int samples : {1, 2, 4, 8}) {
    for (const int cutoff : {1, 128, 254}) {
      for (const bool large : {false, true}) {
        TestPicture picture(large ? 256 : 64, 64);
        for (int y = 0; y < picture.height; ++y) {
          for (int x = 0; x < picture.width; ++x) {
            const int alpha = x < picture.width / 2 ? cutoff - 1 : cutoff;
            picture.at(x, y) = glm::u8vec4(250, 10 + x % 200, 30, alpha);
          }
        }
        const Texture texture = picture.texture();
        Board board(256, 64, samples);
        const glm::vec4 place(0.0F, 0.0F, static_cast<float>(picture.width), 64.0F);
        TextureUse use{&texture};
        use.alpha = AlphaMode::kMask;
        use.alpha_cutoff = static_cast<float>(cutoff) / 255.0F;
        board.add(place, glm::vec2(0.0F), glm::vec2(1.0F), use, 0.6F);
        // Farther away and drawn later, so that it shows only where no depth is left either.
        Board::Part& part = board.make(whole(board), glm::vec2(0.0F), glm::vec2(1.0F), 0.3F);
        part.colours.assign(4, behind);
        board.draw(part, {});
        board.screen.end();
        for (int y = 0; y < 64; ++y) {
          for (int x = 0; x < 256; ++x) {
            const bool there = x >= picture.width / 2 && x < picture.width;
            ASSERT_EQ(board.screen.pixel(x, y), pixel_of(there ? picture.at(x, y) : behind))
                << x << ", " << y << ", cut-off " << cutoff << ", " << samples << " samples";
          }
        }
      }
    }
  }
}

TEST_P(TextureOn, AMaskOverOtherThingsShowsThem) {
  TestPicture holes = checkerboard(64, 64, 4, glm::u8vec4(250, 10, 30, 255), glm::u8vec4(9, 9, 9, 0));
  const TestPicture below = random_picture(64, 64, 760);
  const Texture mask = holes.texture();
  const Texture ground = below.texture();
  for (const float cutoff : {-1.0F, 0.0F, 0.5F, 1.0F, 1.01F, 1e30F}) {
    for (const int samples : {1, 4}) {
      Board board(64, 64, samples);
      board.add(whole(board), glm::vec2(0.0F), glm::vec2(1.0F), {&ground}, 0.3F);
      TextureUse use{&mask};
      use.alpha = AlphaMode::kMask;
      use.alpha_cutoff = cutoff;
      board.add(whole(board), glm::vec2(0.0F), glm::vec2(1.0F), use, 0.6F);
      board.screen.end();
      for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
          const glm::u8vec4& texel = holes.at(x, y);
          const bool there = static_cast<float>(texel.w) / 255.0F >= cutoff;
          ASSERT_EQ(board.screen.pixel(x, y), pixel_of(there ? texel : below.at(x, y)))
              << x << ", " << y << ", cut-off " << cutoff;
        }
      }
    }
  }
}

// A mirrored placement and both sides of a sheet show the same picture, the back mirrored by nature.
TEST_P(TextureOn, BothSidesOfASheetWearIt) {
  const TestPicture picture = random_picture(32, 32, 770);
  const Texture texture = picture.texture();
  Board board(32, 32);
  Board::Part& part = board.make(whole(board), glm::vec2(0.0F), glm::vec2(1.0F));
  MeshView mesh{part.positions, part.normals, part.colours, part.indices};
  mesh.texture = {&texture, part.coordinates};
  glm::mat4 half_turn(1.0F);  // about y, in clip space with depth kept
  half_turn[0][0] = -1.0F;
  half_turn[2][2] = -1.0F;
  half_turn[3][2] = 1.0F;
  board.screen.renderer.draw(mesh, half_turn, Shading::kFlat, CullMode::kBack);
  board.screen.end();
  EXPECT_EQ(board.screen.renderer.stats().culled, 2U);
  board.screen.begin();
  Lighting everywhere;
  board.screen.renderer.set_lighting(everywhere);
  board.screen.renderer.draw(mesh, half_turn, Shading::kFlat, CullMode::kNone);
  board.screen.end();
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x)
      ASSERT_EQ(board.screen.pixel(x, y), pixel_of(picture.at(31 - x, y)));
  }
}

TEST_P(TextureOn, PicturesOfNoSizeOrOfTheWrongSizeAreRefused) {
  const std::vector<glm::u8vec4> pixels(6);
  EXPECT_TRUE(Texture::from_srgb(2, 3, pixels).has_value());
  for (const auto& [width, height] : {std::pair(0, 0), std::pair(-2, -3), std::pair(2, 4), std::pair(3, 3),
                                      std::pair(1, 5), std::pair(kMaxTextureSize + 1, 1), std::pair(INT32_MAX, 2)}) {
    EXPECT_FALSE(Texture::from_srgb(width, height, pixels).has_value()) << width << " x " << height;
  }
  EXPECT_FALSE(Texture::from_srgb(2, 3, {}).has_value());
  const std::vector<glm::u8vec4> row(kMaxTextureSize, glm::u8vec4(7));
  const std::optional<Texture> widest = Texture::from_srgb(kMaxTextureSize, 1, row);
  ASSERT_TRUE(widest.has_value());
  EXPECT_EQ(widest->width(), kMaxTextureSize);
  EXPECT_EQ(widest->height(), 1);
  EXPECT_EQ(widest->level_count(), 14);
}

TEST_P(TextureOn, LevelsWithLongerSidesAreNotKept) {
  const TestPicture picture = random_picture(40, 24, 780);
  const int limits[][4] = {{40, 40, 24, 6}, {39, 20, 12, 5}, {12, 10, 6, 4}, {1, 1, 1, 1}, {0, 1, 1, 1}, {-5, 1, 1, 1}};
  for (const auto& limit : limits) {
    const std::optional<Texture> texture = Texture::from_srgb(40, 24, picture.pixels, limit[0]);
    ASSERT_TRUE(texture.has_value());
    EXPECT_EQ(texture->width(), limit[1]);
    EXPECT_EQ(texture->height(), limit[2]);
    EXPECT_EQ(texture->level_count(), limit[3]);
  }
  // Shown so small, it makes no difference.
  const Texture all = picture.texture();
  const std::optional<Texture> few = Texture::from_srgb(40, 24, picture.pixels, 10);
  std::vector<uint32_t> pictures[2];
  for (size_t i = 0; i < 2; ++i) {
    Board board(16, 8);
    board.add(glm::vec4(0.0F, 0.0F, 10.0F, 6.0F), glm::vec2(0.0F), glm::vec2(1.0F), {i == 0 ? &all : &*few});
    board.screen.end();
    pictures[i] = board.screen.pixels;
  }
  EXPECT_EQ(pictures[0], pictures[1]);
}

TEST_P(TextureOn, CoordinatesThatAreNotFiniteRejectTheirTriangles) {
  const Texture texture = random_picture(8, 8, 790).texture();
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (int axis = 0; axis < 2; ++axis) {
      for (const Shading shading : {Shading::kGouraud, Shading::kFlat}) {
        for (const float size : {16.0F, 256.0F}) {
          Board board(256, 256);
          Board::Part& part = board.make(glm::vec4(0.0F, 0.0F, size, size), glm::vec2(0.0F), glm::vec2(1.0F));
          part.coordinates[1][axis] = bad;  // of the first triangle alone
          board.draw(part, {&texture, part.coordinates}, shading);
          board.screen.end();
          const DrawStats& stats = board.screen.renderer.stats();
          EXPECT_EQ(stats.rejected, 1U);
          EXPECT_EQ(stats.drawn, 1U);
        }
      }
    }
  }
}

TEST_P(TextureOn, DrawsThatDoNotFitTheirTextureAreRejected) {
  Texture texture = random_picture(8, 8, 791).texture();
  Board board(16, 16);
  const Board::Part& part = board.make(whole(board), glm::vec2(0.0F), glm::vec2(1.0F));
  const std::vector<glm::vec2> longer(5);
  const std::span<const glm::vec2> good(part.coordinates);
  std::vector<TextureUse> bad(4, TextureUse{&texture, good});
  bad[0].coordinates = good.first(3);
  bad[1].coordinates = longer;
  bad[2].coordinates = {};
  bad[3].alpha_cutoff = kNan;
  for (const TextureUse& use : bad) {
    board.screen.begin();
    board.draw(part, use);
    board.screen.end();
    EXPECT_EQ(board.screen.renderer.stats().rejected, 2U);
    EXPECT_EQ(board.screen.pixel(3, 3), 0U);
  }
  // Without a texture nothing is asked of the rest.
  board.screen.begin();
  board.draw(part, {nullptr, longer, Wrap::kClamp, Wrap::kClamp, AlphaMode::kMask, kNan});
  board.screen.end();
  EXPECT_EQ(board.screen.renderer.stats().drawn, 2U);
  EXPECT_EQ(board.screen.pixel(3, 3), 0xFFFFFFU);
}

TEST_P(TextureOn, HugeCoordinatesAreDrawn) {
  const Texture texture = checkerboard(8, 8, 1, glm::u8vec4(255), glm::u8vec4(0, 0, 0, 255)).texture();
  const double mean = level_of(0.5);
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kMirroredRepeat, Wrap::kClamp}) {
    for (const float huge : {1e9F, 1e30F, std::numeric_limits<float>::max()}) {
      for (const float size : {16.0F, 256.0F}) {
        Board board(256, 256);
        const glm::vec4 place(0.0F, 0.0F, size, size);
        board.add(place, glm::vec2(-huge), glm::vec2(huge), {&texture, {}, wrap, wrap});
        board.screen.end();
        EXPECT_EQ(board.screen.renderer.stats().drawn, 2U);
        if (wrap == Wrap::kClamp) continue;
        for (int i = 0; i < static_cast<int>(size); ++i)
          ASSERT_NEAR(red_of(board.screen.pixel(i, i)), mean, 1.0) << huge;
      }
    }
  }
}

}  // namespace
}  // namespace auslan::raster
