// SPDX-License-Identifier: Apache-2.0
#include "fill.h"
#include "raster/srgb.h"

namespace auslan::raster {
namespace {

uint32_t channel_average(std::span<const uint32_t> colours, uint32_t shift) {
  const auto count = static_cast<uint32_t>(colours.size());
  uint32_t sum = 0;
  for (const uint32_t colour : colours)
    sum += linear16_from_srgb(static_cast<uint8_t>((colour >> shift) & 255U));
  return uint32_t{srgb_from_linear16((sum + count / 2U) / count)} << shift;
}

}  // namespace

void resolve(std::span<const uint32_t> colours, int samples, std::span<uint32_t> pixels) noexcept {
  const auto per_pixel = static_cast<size_t>(samples);
  for (size_t i = 0; i < pixels.size(); ++i) {
    const std::span<const uint32_t> group = colours.subspan(i * per_pixel, per_pixel);
    bool same = true;
    for (const uint32_t colour : group)
      same = same && colour == group[0];
    // Decoding and encoding one colour gives it back, so the short cut changes no pixel.
    pixels[i] = same ? group[0] : channel_average(group, 16) | channel_average(group, 8) | channel_average(group, 0);
  }
}

}  // namespace auslan::raster
