// SPDX-License-Identifier: Apache-2.0
#include "pigment.h"

#include "field.h"

namespace auslan::sculpt {

namespace {

uint8_t byte_of(double value) {
  return static_cast<uint8_t>(value < 0.0 ? 0.0 : (value > 255.0 ? 255.0 : value + 0.5));
}

}  // namespace

Colour operator*(const Colour& colour, double shade) {
  Colour out = colour;
  for (double& part : out.part)
    part *= shade;
  return out;
}

Colour mix(const Colour& a, const Colour& b, double t) {
  Colour out;
  for (size_t i = 0; i < kPigmentCount; ++i)
    out.part[i] = mix(a.part[i], b.part[i], t);
  return out;
}

Paint paint_of(const Colour& colour) {
  size_t first = 0;
  double sum = 0.0;
  for (size_t i = 0; i < kPigmentCount; ++i) {
    sum += colour.part[i];
    if (colour.part[i] > colour.part[first]) first = i;
  }
  size_t second = first;
  for (size_t i = 0; i < kPigmentCount; ++i)
    if (i != first && colour.part[i] > 0.0 && (second == first || colour.part[i] > colour.part[second])) second = i;
  Paint paint;
  paint.first = static_cast<uint8_t>(first);
  paint.second = static_cast<uint8_t>(second);
  if (second != first) paint.share = byte_of(255.0 * colour.part[second] / (colour.part[first] + colour.part[second]));
  paint.shade = byte_of(Paint::kFullShade * sum);
  return paint;
}

Appearance appearance_of(const TableAppearance& look) {
  const auto vector_of = [](const TableColour& c) { return Vec3(c.red, c.green, c.blue); };
  const Vec3 skin = vector_of(look.skin);
  // Nails are lighter than the palm, their edge whiter still, but not on dark skin.
  const Vec3 palm = vector_of(look.palm);
  const double white = 0.55 * smooth_step(90.0, 200.0, palm.y);
  const Vec3 nail = mix(palm * Vec3(1.02, 0.975, 0.99), Vec3(252.0, 226.0, 218.0), 0.8 * white);
  std::array<Vec3, kPigmentCount> colours{};
  const auto set = [&colours](Pigment pigment, const Vec3& colour) { colours[static_cast<size_t>(pigment)] = colour; };
  set(Pigment::kSkin, skin);
  set(Pigment::kPalm, palm);
  set(Pigment::kFlush, skin * Vec3(0.985, 0.90, 0.885));
  set(Pigment::kLips, vector_of(look.lips));
  set(Pigment::kNail, nail);
  set(Pigment::kNailTip, mix(nail, Vec3(250.0, 240.0, 232.0), white));
  set(Pigment::kHair, vector_of(look.hair));
  set(Pigment::kShirt, vector_of(look.shirt));
  set(Pigment::kTrousers, vector_of(look.trousers));
  set(Pigment::kIris, vector_of(look.iris));
  set(Pigment::kEyeWhite, {240.0, 236.0, 230.0});
  set(Pigment::kPupil, {14.0, 12.0, 12.0});
  set(Pigment::kGlint, {255.0, 255.0, 255.0});
  set(Pigment::kMouth, {52.0, 20.0, 22.0});
  set(Pigment::kTooth, {238.0, 232.0, 216.0});
  set(Pigment::kGum, {176.0, 92.0, 92.0});
  set(Pigment::kTongue, {206.0, 104.0, 106.0});
  Appearance out;
  out.name = look.name;
  out.background = {byte_of(look.background.red), byte_of(look.background.green), byte_of(look.background.blue)};
  for (const Vec3& colour : colours)
    out.pigments.emplace_back(byte_of(colour.x), byte_of(colour.y), byte_of(colour.z));
  return out;
}

}  // namespace auslan::sculpt
