// SPDX-License-Identifier: Apache-2.0
// The sRGB transfer curve (IEC 61966-2-1) in add, multiply and square root, so that every lane of every machine
// evaluates it to the same bits. Minimax fits (Remez): decoding is within 0.004, encoding within 0.004 of a level (255
// is met).
#pragma once

namespace auslan::raster {

/// For any number type with +, -, *: sRGB level / 255 above the linear part to linear light.
template <class F, class Set>
F decode_srgb_power(F s, Set set) {
  F r = set(-0.0876803306F) * s + set(0.323436175F);
  r = r * s + set(-0.541177984F);
  r = r * s + set(0.771893389F);
  r = r * s + set(0.498124475F);
  r = r * s + set(0.0345012472F);
  return r * s + set(0.000871613341F);
}
inline constexpr float kSrgbLinearEnd = 0.04045F;         // level / 255 up to which the curve is a line
inline constexpr float kSrgbLinearEndLight = 0.0031308F;  // the same point in linear light
inline constexpr float kSrgbLinearSlope = 12.92F;

/// The fourth root of linear light above the linear part to an sRGB level from 0 to 255.
template <class F, class Set>
F encode_srgb_power(F root, Set set) {
  F r = set(-17.3775739F) * root + set(73.8309454F);
  r = r * root + set(-147.258124F);
  r = r * root + set(320.128136F);
  r = r * root + set(41.3166964F);
  return r * root + set(-15.6400785F);
}

}  // namespace auslan::raster
