// SPDX-License-Identifier: Apache-2.0
#include "picture_difference.h"

#include "raster/image.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>

namespace auslan::bench {

PictureDifference difference_of(std::span<const uint32_t> a, std::span<const uint32_t> b) {
  if (a.size() != b.size() || a.empty()) return {};
  const auto apart = [](uint32_t x, uint32_t y) { return x > y ? x - y : y - x; };
  uint64_t sum = 0;
  uint64_t far_off = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const uint32_t red = apart(raster::red_of(a[i]), raster::red_of(b[i]));
    const uint32_t green = apart(raster::green_of(a[i]), raster::green_of(b[i]));
    const uint32_t blue = apart(raster::blue_of(a[i]), raster::blue_of(b[i]));
    sum += red + green + blue;
    if (std::max({red, green, blue}) > 16) ++far_off;
  }
  const auto pixels = static_cast<double>(a.size());
  return {static_cast<double>(sum) / (3.0 * pixels), static_cast<double>(far_off) / pixels};
}

bool write_ppm(const std::string& path, std::span<const uint32_t> pixels, int width) {
  std::ofstream out(path, std::ios::binary);
  out << "P6\n" << width << ' ' << pixels.size() / static_cast<size_t>(width) << "\n255\n";
  for (const uint32_t pixel : pixels)
    out << static_cast<char>(raster::red_of(pixel)) << static_cast<char>(raster::green_of(pixel))
        << static_cast<char>(raster::blue_of(pixel));
  out.close();
  return static_cast<bool>(out);
}

}  // namespace auslan::bench
