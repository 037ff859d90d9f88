// SPDX-License-Identifier: Apache-2.0
// What coverage is when other things take part: perspective, other triangles, samples.
#include "raster_conformance.h"

namespace auslan::raster {
namespace {

class ExactPicture : public OnEveryKernel {};
ON_EVERY_KERNEL(ExactPicture);

// Corners at different distances, colours that must follow the perspective: the same pixels as without.
TEST_P(ExactPicture, PerspectiveChangesNoCoverage) {
  constexpr int kCell = 16;
  constexpr int kAcross = 32;
  constexpr int kPerFrame = kAcross * kAcross;
  Screen screen(kCell * kAcross, kCell * kAcross);
  Camera camera;  // w is the mesh's z, and 1/2 / w the depth
  camera.clip_from_view[2] = glm::vec4(0.0F, 0.0F, 0.0F, 1.0F);
  camera.clip_from_view[3] = glm::vec4(0.0F, 0.0F, 0.5F, 0.0F);
  Random random(201);
  const int count = share_of(kTriangleCounts.perspective);
  int64_t covered = 0;
  for (int done = 0; done < count; done += kPerFrame) {
    std::vector<Triangle> triangles;
    std::vector<glm::vec3> positions;
    std::vector<glm::u8vec4> colours;
    std::vector<uint32_t> indices;
    for (int i = 0; i < kPerFrame; ++i) {
      Triangle t = i % 3 == 0   ? lattice_triangle(random, 0, kCell * 256)
                   : i % 3 == 1 ? sub_pixel_triangle(random, 0, kCell * 256)
                                : random_triangle(random, 0, kCell * 256);
      for (Point& p : t) {
        p = {p.x + int64_t{i % kAcross} * kCell * 256, p.y + int64_t{i / kAcross} * kCell * 256};
        // Powers of two, so that projecting is exact.
        const float w = 0.5F * static_cast<float>(1 << random.between(0, 4));
        const glm::vec3 place = screen.place(p);
        indices.push_back(static_cast<uint32_t>(positions.size()));
        positions.emplace_back(place.x * w, place.y * w, w);
        const uint64_t colour = random.next();
        colours.emplace_back(colour & 255U, colour >> 8U & 255U, 255, 255);
      }
      triangles.push_back(t);
    }
    screen.begin();
    screen.renderer.set_camera(camera);
    std::vector<glm::vec3> normals(positions.size(), glm::vec3(0.0F, 0.0F, 1.0F));
    screen.add_mesh(std::move(positions), std::move(normals), std::move(colours), std::move(indices),
                    Shading::kGouraud);
    screen.end();
    for (int row = 0; row < screen.height(); ++row) {
      for (int column = 0; column < screen.width(); ++column) {
        const Triangle& t = triangles[static_cast<size_t>(row / kCell * kAcross + column / kCell)];
        const bool expected = covers(t, centre(column, row));
        covered += expected ? 1 : 0;
        ASSERT_EQ(blue_of(screen.pixel(column, row)), expected ? 255U : 0U) << text(t) << column << ", " << row;
      }
    }
  }
  EXPECT_GT(covered, count);
}

// Every pixel shows the nearest of the triangles that cover it, the first drawn of those that are equally near.
TEST_P(ExactPicture, OverlappingTrianglesShowTheNearest) {
  constexpr int kWidth = 130;
  constexpr int kHeight = 100;
  constexpr int kPerFrame = 40;
  Screen screen(kWidth, kHeight);
  Random random(202);
  const int count = share_of(kTriangleCounts.overlapping);
  for (int done = 0; done < count; done += kPerFrame) {
    std::vector<uint32_t> shown(screen.pixels.size(), 0);
    std::vector<float> nearest(screen.pixels.size(), 0.0F);
    screen.begin();
    for (uint32_t i = 1; i <= kPerFrame; ++i) {
      // As many of a few pixels as of many.
      const int64_t size = int64_t{512} << random.between(0, 8);
      const Point middle = point_in(random, 0, kWidth * 256);
      const Triangle t = {moved(middle, random, size), moved(middle, random, size), moved(middle, random, size)};
      const float depth = 0.0625F * static_cast<float>(random.between(1, 12));
      screen.add(t, glm::u8vec4(3 * i, 255 - i, i, 255), depth);
      for (int row = 0; row < kHeight; ++row) {
        for (int column = 0; column < kWidth; ++column) {
          const auto at = static_cast<size_t>(row * kWidth + column);
          if (!(depth > nearest[at]) || !covers(t, centre(column, row))) continue;
          nearest[at] = depth;
          shown[at] = pack_pixel(3 * i, 255 - i, i);
        }
      }
    }
    screen.end();
    for (size_t at = 0; at < shown.size(); ++at) {
      ASSERT_EQ(screen.pixels[at], shown[at])
          << "frame of triangle " << done << ", pixel " << at % kWidth << ", " << at / kWidth;
    }
  }
}

// Direct3D 11 functional specification, 19.2.4: D3D11_STANDARD_MULTISAMPLE_PATTERN, 1/16 pixel from the centre.
constexpr Point kTwo[] = {{4, 4}, {-4, -4}};
constexpr Point kFour[] = {{-2, -6}, {6, -2}, {-6, 2}, {2, 6}};
constexpr Point kEight[] = {{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}};

// White on black: the level of a pixel tells how many of its samples were covered.
TEST_P(ExactPicture, EverySampleIsCoveredExactly) {
  const int count = share_of(kTriangleCounts.multisampled) / 3;
  const std::span<const Point> patterns[] = {kTwo, kFour, kEight};
  // 255 * sqrt(covered / samples), to nearest; 127.5 upwards.
  const std::vector<uint32_t> levels[] = {
      {0, 180, 255}, {0, 128, 180, 221, 255}, {0, 90, 128, 156, 180, 202, 221, 239, 255}};
  for (size_t p = 0; p < 3; ++p) {
    const std::span<const Point> pattern = patterns[p];
    const auto samples = static_cast<int>(pattern.size());
    constexpr int kCell = 12;
    constexpr int kAcross = 40;
    constexpr int kPerFrame = kAcross * kAcross;
    Screen screen(kCell * kAcross, kCell * kAcross, samples);
    Random random(203 + p);
    int64_t partial = 0;
    for (int done = 0; done < count; done += kPerFrame) {
      std::vector<Triangle> triangles;
      screen.begin();
      std::vector<glm::vec3> positions;
      std::vector<uint32_t> indices;
      for (int i = 0; i < kPerFrame; ++i) {
        Triangle t;
        // Inside the cell, a pixel from its border; the lattice's corners moved to lie on samples.
        switch (i % 4) {
          case 0:
            t = random_triangle(random, 256, 11 * 256);
            break;
          case 1:
            t = sub_pixel_triangle(random, 256, 11 * 256);
            break;
          case 2:
            t = sliver_triangle(random, 256, 11 * 256);
            break;
          default:
            for (Point& c : t) {
              c = point_in(random, 16, 11 * 16);
              c = {c.x * 16, c.y * 16};
            }
        }
        for (Point& c : t) {
          c = {c.x + int64_t{i % kAcross} * kCell * 256, c.y + int64_t{i / kAcross} * kCell * 256};
          indices.push_back(static_cast<uint32_t>(positions.size()));
          positions.push_back(screen.place(c));
        }
        triangles.push_back(t);
      }
      std::vector<glm::u8vec4> colours(positions.size(), glm::u8vec4(255));
      screen.add_mesh(std::move(positions), {}, std::move(colours), std::move(indices), Shading::kFlat);
      screen.end();
      for (int row = 0; row < screen.height(); ++row) {
        for (int column = 0; column < screen.width(); ++column) {
          const Triangle& t = triangles[static_cast<size_t>(row / kCell * kAcross + column / kCell)];
          size_t covered = 0;
          for (const Point& offset : pattern) {
            const Point c = centre(column, row);
            covered += covers(t, Point{c.x + offset.x * 16, c.y + offset.y * 16}) ? 1U : 0U;
          }
          partial += covered > 0 && covered < pattern.size() ? 1 : 0;
          ASSERT_EQ(red_of(screen.pixel(column, row)), levels[p][covered])
              << covered << " of " << samples << " samples of pixel " << column << ", " << row << ", " << text(t);
        }
      }
    }
    EXPECT_GT(partial, count);
  }
}

}  // namespace
}  // namespace auslan::raster
