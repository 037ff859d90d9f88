// SPDX-License-Identifier: Apache-2.0
#include "media/picture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdio>
#include <cstdlib>

namespace auslan {

namespace {

int channel(uint32_t pixel, int shift) {
  return static_cast<int>((pixel >> shift) & 255);
}

int largest_difference(uint32_t a, uint32_t b) {
  int largest = 0;
  for (const int shift : {16, 8, 0})
    largest = std::max(largest, std::abs(channel(a, shift) - channel(b, shift)));
  return largest;
}

std::string colour_name(uint32_t pixel) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "#%06x", pixel & 0xFFFFFFU);
  return text.data();
}

}  // namespace

Picture make_picture(int width, int height, uint32_t colour) {
  assert(width > 0 && height > 0);
  return {std::vector<uint32_t>(static_cast<size_t>(width) * static_cast<size_t>(height), colour), width, height};
}

Comparison compare(FrameView expected, FrameView actual) {
  Comparison result;
  if (!is_well_formed(expected) || !is_well_formed(actual) || expected.width != actual.width ||
      expected.height != actual.height)
    return result;
  result.same_size = true;
  for (size_t i = 0; i < expected.pixels.size(); ++i) {
    const int difference = largest_difference(expected.pixels[i], actual.pixels[i]);
    if (difference == 0) continue;
    ++result.differing;
    if (difference <= result.worst_difference) continue;
    result.worst_difference = difference;
    result.worst_x = static_cast<int>(i % static_cast<size_t>(expected.width));
    result.worst_y = static_cast<int>(i / static_cast<size_t>(expected.width));
    result.expected = expected.pixels[i];
    result.actual = actual.pixels[i];
  }
  return result;
}

std::string to_string(const Comparison& comparison) {
  if (!comparison.same_size) return "the pictures have different sizes";
  if (comparison.differing == 0) return "the pictures are the same";
  return std::to_string(comparison.differing) + (comparison.differing == 1 ? " pixel differs" : " pixels differ") +
         "; worst at (x " + std::to_string(comparison.worst_x) + ", y " + std::to_string(comparison.worst_y) +
         "): expected " + colour_name(comparison.expected) + ", actual " + colour_name(comparison.actual);
}

Picture difference_image(FrameView expected, FrameView actual) {
  assert(is_well_formed(expected) && is_well_formed(actual) && expected.width == actual.width &&
         expected.height == actual.height);
  Picture picture = make_picture(expected.width, expected.height);
  for (size_t i = 0; i < picture.pixels.size(); ++i) {
    const uint32_t pixel = expected.pixels[i];
    const int difference = largest_difference(pixel, actual.pixels[i]);
    if (difference > 0) {
      // A difference of one step must be seen too.
      picture.pixels[i] = static_cast<uint32_t>(128 + difference / 2) << 16;
      continue;
    }
    uint32_t dark = 0;
    for (const int shift : {16, 8, 0})
      dark |= static_cast<uint32_t>(channel(pixel, shift) / 3) << shift;
    picture.pixels[i] = dark;
  }
  return picture;
}

}  // namespace auslan
