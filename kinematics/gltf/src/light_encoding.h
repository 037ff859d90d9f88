// SPDX-License-Identifier: Apache-2.0
// sRGB code values to linear light and back by table, so that no machine's pow decides a colour.
#pragma once

#include <cstdint>

namespace auslan {

/// Linear light of an sRGB code value (IEC 61966-2-1), 0 to 65535, rounded to nearest.
uint16_t linear_from_srgb(uint8_t code);

/// The code value whose linear light is nearest; srgb_from_linear(linear_from_srgb(c)) == c for every c.
uint8_t srgb_from_linear(uint16_t linear);

}  // namespace auslan
