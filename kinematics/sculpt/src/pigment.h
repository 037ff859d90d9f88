// SPDX-License-Identifier: Apache-2.0
// What the figure is painted with: shares of pigments, which an appearance gives their colours.
#pragma once

#include "kinematics/figure.h"
#include "sculpt/measurements.h"

#include <array>
#include <cstdint>

namespace auslan::sculpt {

enum class Pigment : uint8_t {
  kSkin,
  kPalm,   ///< lighter than the back of the hand
  kFlush,  ///< knuckles and fingertips
  kLips,
  kNail,
  kNailTip,
  kHair,
  kShirt,
  kTrousers,
  kIris,
  kEyeWhite,
  kPupil,
  kGlint,
  kMouth,  ///< its inside
  kTooth,
  kGum,
  kTongue
};
inline constexpr size_t kPigmentCount = static_cast<size_t>(Pigment::kTongue) + 1;

/// A sum of pigments; the sum of the parts is how light it is, 1 as the pigments are.
struct Colour {
  std::array<double, kPigmentCount> part{};
  Colour() = default;
  Colour(Pigment pigment) { part[static_cast<size_t>(pigment)] = 1.0; }  // a pigment is a colour
};
Colour operator*(const Colour& colour, double shade);
Colour mix(const Colour& a, const Colour& b, double t);

/// The two largest parts; the shade is that of all.
Paint paint_of(const Colour& colour);

/// The pigments' colours in one look.
Appearance appearance_of(const TableAppearance& look);

}  // namespace auslan::sculpt
