// SPDX-License-Identifier: Apache-2.0
#include "media/frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>
#include <xxhash.h>

namespace auslan {

namespace {

XXH128_hash_t hash_pixels(std::span<const uint32_t> pixels) {
  if constexpr (std::endian::native == std::endian::little) {
    return XXH3_128bits(pixels.data(), pixels.size_bytes());
  } else {
    XXH3_state_t* state = XXH3_createState();
    XXH3_128bits_reset(state);
    for (const uint32_t pixel : pixels) {
      const std::array<uint8_t, 4> bytes = {static_cast<uint8_t>(pixel), static_cast<uint8_t>(pixel >> 8),
                                            static_cast<uint8_t>(pixel >> 16), static_cast<uint8_t>(pixel >> 24)};
      XXH3_128bits_update(state, bytes.data(), bytes.size());
    }
    const XXH128_hash_t hash = XXH3_128bits_digest(state);
    XXH3_freeState(state);
    return hash;
  }
}

}  // namespace

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  const int64_t x0 = std::max<int64_t>(a.x, b.x);
  const int64_t y0 = std::max<int64_t>(a.y, b.y);
  const int64_t x1 = std::min(int64_t{a.x} + a.width, int64_t{b.x} + b.width);
  const int64_t y1 = std::min(int64_t{a.y} + a.height, int64_t{b.y} + b.height);
  if (x1 <= x0 || y1 <= y0) return {};
  return {static_cast<int>(x0), static_cast<int>(y0), static_cast<int>(x1 - x0), static_cast<int>(y1 - y0)};
}

std::string frame_digest(FrameView frame) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, hash_pixels(frame.pixels));
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  text.reserve(32);
  for (const unsigned char byte : canonical.digest) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

}  // namespace auslan
