// SPDX-License-Identifier: Apache-2.0
#include "raster/srgb.h"

#include <array>
#include <cstddef>

namespace auslan::raster {
namespace {

constexpr double kLinearPartEnd = 0.04045;         // sRGB value up to which the curve is a line
constexpr double kLinearPartEndLight = 0.0031308;  // the same point in linear light

// value^(1/5) for value in 0.09..1, by Newton's method from above.
constexpr double fifth_root(double value) {
  double root = 1.0;
  for (int i = 0; i < 16; ++i) {
    const double square = root * root;
    root = (4.0 * root + value / (square * square)) / 5.0;
  }
  return root;
}

// Linear light of an sRGB level 0..255 (need not be whole): ((s + 0.055) / 1.055)^2.4, and a line near black.
constexpr double decode(double level) {
  const double s = level / 255.0;
  if (s <= kLinearPartEnd) return s / 12.92;
  const double base = (s + 0.055) / 1.055;
  const double fifth = fifth_root(base);
  return base * base * (fifth * fifth);
}

constexpr std::array<float, 256> make_linear() {
  std::array<float, 256> table{};
  for (size_t code = 0; code < table.size(); ++code) {
    table[code] = static_cast<float>(decode(static_cast<double>(code)));
  }
  return table;
}

constexpr uint32_t round_up(double value) {
  const auto whole = static_cast<uint32_t>(value);
  return static_cast<double>(whole) < value ? whole + 1U : whole;
}

constexpr std::array<uint32_t, 256> make_linear16() {
  std::array<uint32_t, 256> table{};
  for (size_t code = 0; code < table.size(); ++code) {
    table[code] = static_cast<uint32_t>(decode(static_cast<double>(code)) * 65535.0 + 0.5);
  }
  return table;
}

// The least light, in 1/65535, that is nearer to `code` than to `code - 1`.
constexpr std::array<uint32_t, 257> make_thresholds() {
  std::array<uint32_t, 257> table{};
  for (size_t code = 1; code < 256; ++code) {
    table[code] = round_up(decode(static_cast<double>(code) - 0.5) * 65535.0);
  }
  table[256] = 65536U;
  return table;
}

constexpr size_t kEncodeSteps = 4096;

// sRGB levels at linear light i / 4096: 1.055 * x^(5/12) - 0.055, x^(1/12) by Newton's method from the root before.
constexpr std::array<float, kEncodeSteps + 1> make_encode() {
  std::array<float, kEncodeSteps + 1> table{};
  double root = 0.61;
  for (size_t i = 0; i <= kEncodeSteps; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(kEncodeSteps);
    double s = 12.92 * x;
    if (x > kLinearPartEndLight) {
      for (int step = 0; step < 5; ++step) {
        const double square = root * root;
        const double fourth = square * square;
        root = (11.0 * root + x / (fourth * fourth * square * root)) / 12.0;
      }
      const double square = root * root;
      s = 1.055 * (square * square * root) - 0.055;
    }
    table[i] = static_cast<float>(255.0 * s);
  }
  table[kEncodeSteps] = 255.0F;
  return table;
}

constexpr auto kLinear = make_linear();
constexpr auto kLinear16 = make_linear16();
constexpr auto kThresholds = make_thresholds();
constexpr auto kEncode = make_encode();

// For each 64th of the 16-bit range, the code of its lowest value: where the search in kThresholds starts.
constexpr std::array<uint8_t, 1024> make_first_code() {
  std::array<uint8_t, 1024> table{};
  size_t code = 0;
  for (size_t bucket = 0; bucket < table.size(); ++bucket) {
    while (kThresholds[code + 1] <= bucket * 64U)
      ++code;
    table[bucket] = static_cast<uint8_t>(code);
  }
  return table;
}
constexpr auto kFirstCode = make_first_code();

}  // namespace

float linear_from_srgb(uint8_t code) noexcept {
  return kLinear[code];
}

uint32_t linear16_from_srgb(uint8_t code) noexcept {
  return kLinear16[code];
}

float srgb_level_from_linear(float linear) noexcept {
  if (!(linear > 0.0F)) return 0.0F;
  if (linear >= 1.0F) return 255.0F;
  const float position = linear * static_cast<float>(kEncodeSteps);
  const auto index = static_cast<size_t>(position);
  const float fraction = position - static_cast<float>(index);
  const float below = kEncode[index];
  return below + fraction * (kEncode[index + 1] - below);
}

uint8_t srgb_from_linear16(uint32_t linear16) noexcept {
  if (linear16 > 65535U) return 255;
  size_t code = kFirstCode[linear16 / 64U];
  while (kThresholds[code + 1] <= linear16)
    ++code;
  return static_cast<uint8_t>(code);
}

}  // namespace auslan::raster
