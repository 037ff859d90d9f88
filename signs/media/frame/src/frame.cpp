// SPDX-License-Identifier: Apache-2.0
#include "media/frame.h"

#include "digest/digest.h"

#include <algorithm>
#include <bit>

namespace auslan {

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  const int64_t x0 = std::max<int64_t>(a.x, b.x);
  const int64_t y0 = std::max<int64_t>(a.y, b.y);
  const int64_t x1 = std::min(int64_t{a.x} + a.width, int64_t{b.x} + b.width);
  const int64_t y1 = std::min(int64_t{a.y} + a.height, int64_t{b.y} + b.height);
  if (x1 <= x0 || y1 <= y0) return {};
  return {static_cast<int>(x0), static_cast<int>(y0), static_cast<int>(x1 - x0), static_cast<int>(y1 - y0)};
}

/// Little-endian, whatever the machine.
std::string frame_digest(FrameView frame) {
  if constexpr (std::endian::native == std::endian::little)
    return digest_of({reinterpret_cast<const char*>(frame.pixels.data()), frame.pixels.size_bytes()});
  std::string bytes;
  bytes.reserve(frame.pixels.size_bytes());
  for (const uint32_t pixel : frame.pixels)
    for (int shift = 0; shift < 32; shift += 8)
      bytes += static_cast<char>(pixel >> shift & 0xFF);
  return digest_of(bytes);
}

}  // namespace auslan
