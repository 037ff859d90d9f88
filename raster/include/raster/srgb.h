// SPDX-License-Identifier: Apache-2.0
// The sRGB transfer curve (IEC 61966-2-1) without pow: tables that the compiler evaluates in IEEE double arithmetic, so
// that every machine holds the same ones.
#pragma once

#include <cstdint>

namespace auslan::raster {

/// Linear light, 0 to 1, of an sRGB code.
float linear_from_srgb(uint8_t code) noexcept;

/// Linear light in units of 1/65535, rounded to nearest, of an sRGB code. Strictly increasing.
uint32_t linear16_from_srgb(uint8_t code) noexcept;

/// The sRGB level of linear light as a real number from 0 to 255, within 0.02 of the curve. Below 0 and NaN give 0,
/// above 1 gives 255. Non-decreasing.
float srgb_level_from_linear(float linear) noexcept;

/// The sRGB code nearest to linear light given in units of 1/65535; the exact inverse of linear16_from_srgb. Values
/// above 65535 give 255.
uint8_t srgb_from_linear16(uint32_t linear16) noexcept;

}  // namespace auslan::raster
