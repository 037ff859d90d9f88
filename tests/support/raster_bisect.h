// SPDX-License-Identifier: Apache-2.0
// Two pictures of one list of triangles that ought to be equal. Where they are not: the triangle with which the
// difference begins, found by bisection, and both pictures up to it in files.
#pragma once

#include "raster_scene.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace auslan::raster {

/// Draws the first `triangles` triangles of a list.
using PictureSource = std::function<void(size_t triangles, std::vector<uint32_t>& pixels)>;

inline PictureSource source_of(Renderer& renderer, std::span<const SceneDraw> draws, const FrameSize& size) {
  return [&renderer, draws, size](size_t triangles, std::vector<uint32_t>& pixels) {
    draw_list(renderer, draws, size, pixels, triangles);
  };
}

/// A triangle of `count` such that the pictures differ once it is drawn and do not before; nothing when all of them
/// together make no difference, `count` when the pictures differ without any. A later triangle may hide what an earlier
/// one did, so there may be others.
inline std::optional<size_t> first_differing(size_t count, const PictureSource& one, const PictureSource& other) {
  std::vector<uint32_t> pixels[2];
  const auto differ = [&](size_t triangles) {
    one(triangles, pixels[0]);
    other(triangles, pixels[1]);
    return pixels[0] != pixels[1];
  };
  if (!differ(count)) return std::nullopt;
  if (differ(0)) return count;
  size_t equal = 0;  // as many triangles make no difference, and `different` do
  size_t different = count;
  while (different - equal > 1) {
    const size_t middle = equal + (different - equal) / 2;
    (differ(middle) ? different : equal) = middle;
  }
  return equal;
}

/// A portable pixmap (binary PPM).
inline void write_picture(const std::filesystem::path& path, const std::vector<uint32_t>& pixels,
                          const FrameSize& size) {
  std::string bytes = "P6\n" + std::to_string(size.width) + " " + std::to_string(size.height) + "\n255\n";
  for (const uint32_t pixel : pixels) {
    for (const uint32_t channel : {red_of(pixel), green_of(pixel), blue_of(pixel)})
      bytes.push_back(static_cast<char>(static_cast<unsigned char>(channel)));
  }
  std::ofstream(path, std::ios::binary) << bytes;
}

/// What there is to know about one triangle of a list.
inline std::string describe(std::span<const SceneDraw> draws, size_t triangle) {
  std::ostringstream out;
  out.precision(9);
  out << "triangle " << triangle << " of the list";
  for (size_t d = 0; d < draws.size(); ++d) {
    const MeshView& mesh = draws[d].mesh;
    if (triangle >= mesh.indices.size() / 3) {
      triangle -= mesh.indices.size() / 3;
      continue;
    }
    out << ", number " << triangle << " of draw " << d << (draws[d].shading == Shading::kFlat ? ", flat" : ", gouraud");
    for (const uint32_t index : mesh.indices.subspan(3 * triangle, 3)) {
      out << "\n  vertex " << index;
      if (index >= mesh.positions.size()) continue;
      const glm::vec3& p = mesh.positions[index];
      out << " at (" << p.x << ", " << p.y << ", " << p.z << ")";
    }
    break;
  }
  return out.str();
}

/// Success when both sources give the same picture of all triangles of `draws`. Otherwise the failure names the
/// triangle, the first pixel that differs and the files `folder`/`name`.{expected,actual}.ppm, which show the list up
/// to it.
inline testing::AssertionResult same_pictures(const std::filesystem::path& folder, const std::string& name,
                                              std::span<const SceneDraw> draws, const FrameSize& size,
                                              const PictureSource& expected, const PictureSource& actual) {
  const size_t count = triangle_count(draws);
  const std::optional<size_t> triangle = first_differing(count, expected, actual);
  if (!triangle) return testing::AssertionSuccess();
  std::vector<uint32_t> pixels[2];
  const size_t shown = *triangle == count ? 0 : *triangle + 1;
  expected(shown, pixels[0]);
  actual(shown, pixels[1]);
  std::filesystem::create_directories(folder);
  std::ofstream(folder / (name + ".txt")) << (shown == 0 ? "no triangle" : describe(draws, *triangle)) << '\n';
  write_picture(folder / (name + ".expected.ppm"), pixels[0], size);
  write_picture(folder / (name + ".actual.ppm"), pixels[1], size);
  const auto differing = std::mismatch(pixels[0].begin(), pixels[0].end(), pixels[1].begin(), pixels[1].end());
  const auto place = static_cast<size_t>(differing.first - pixels[0].begin());
  const auto width = static_cast<size_t>(size.width);
  testing::AssertionResult failure = testing::AssertionFailure();
  failure << name << ": the pictures differ from ";
  if (shown == 0) {
    failure << "the empty frame on";
  } else {
    failure << describe(draws, *triangle);
  }
  failure << "\n";
  if (differing.first != pixels[0].end()) {
    failure << "  pixel " << place % width << ", " << place / width << std::hex << ": 0x" << *differing.first
            << " expected, 0x" << *differing.second << " drawn\n"
            << std::dec;
  }
  return failure << "  pictures up to it: " << (folder / (name + ".{expected,actual}.ppm")).string();
}

/// Where tests keep the pictures of their failures.
inline std::filesystem::path kept_pictures() {
  return std::filesystem::path(AUSLANJAM_BINARY_DIR) / "raster_differences";
}

}  // namespace auslan::raster
