// SPDX-License-Identifier: Apache-2.0
// The sRGB transfer curve (IEC 61966-2-1) without pow, the same bits on every machine.
#pragma once

#include <cstdint>

namespace auslan::raster {

/// Linear light, 0 to 1, of an sRGB code; off by no more than 0.02 of a code's worth of light.
float linear_from_srgb(uint8_t code) noexcept;

/// The sRGB level of linear light as a real number from 0 to 255, within 0.02 of the curve. Below 0 and NaN give 0,
/// above 1 gives 255.
float srgb_level_from_linear(float linear) noexcept;

}  // namespace auslan::raster
