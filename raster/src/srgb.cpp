// SPDX-License-Identifier: Apache-2.0
#include "raster/srgb.h"

#include "kernels/srgb_curve.h"

#include <cmath>

namespace auslan::raster {
namespace {

constexpr auto kItself = [](float value) { return value; };

}  // namespace

float linear_from_srgb(uint8_t code) noexcept {
  const float s = static_cast<float>(code) * (1.0F / 255.0F);
  return s > kSrgbLinearEnd ? decode_srgb_power(s, kItself) : s * (1.0F / kSrgbLinearSlope);
}

float srgb_level_from_linear(float linear) noexcept {
  const float above = linear > 0.0F ? linear : 0.0F;  // in this order, so that NaN becomes 0
  const float light = above < 1.0F ? above : 1.0F;
  const float level = light > kSrgbLinearEndLight ? encode_srgb_power(std::sqrt(std::sqrt(light)), kItself)
                                                  : light * (255.0F * kSrgbLinearSlope);
  return level < 255.0F ? level : 255.0F;
}

}  // namespace auslan::raster
