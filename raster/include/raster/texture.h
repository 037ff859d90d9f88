// SPDX-License-Identifier: Apache-2.0
// Pictures on meshes: what a texture is, how a mesh wears it, and which colour a pixel gets.
//
// Coordinates are glTF's: u runs right and v down, (0, 0) is the top-left corner of the first pixel of a picture and
// (1, 1) the bottom-right corner of its last one; texel centres lie at half-integers of u * width and v * height. They
// are interpolated in perspective at the pixel's centre and held within the range of the triangle's corners there.
//
// Levels: level 0 is the picture, each further one half its size in both directions, rounded down, to a single texel;
// a texel is the mean of the area that it stands for. With U = u * width, V = v * height of level 0 and derivatives by
// a pixel, r = max(Ux^2 + Vx^2, Uy^2 + Vy^2); level = log(r) / 2, held within the levels that there are, where log is
// the logarithm to base 2 with a straight line between whole numbers: e + m - 1 for r = m * 2^e, 1 <= m < 2. It is
// rounded down to 1/256; the two levels next to it are mixed, each filtered bilinearly, with texel distances rounded to
// 1/256.
//
// Colour: texels are kept and filtered as linear light in 15 bits. A pixel is the filtered texel times the linear light
// of what it would show without the texture (lit vertex colours, interpolated as renderer.h says but always in
// perspective, or the flat colour), so a white texture changes nothing; encoded to sRGB levels, rounded to nearest.
// Colours are filtered without a look at alpha.
#pragma once

#include "raster/image.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>

namespace auslan::raster {

inline constexpr int kMaxTextureSize = 8192;  ///< largest width and height, texels

/// A picture with its levels: built once, then only read, by any number of renderers and threads. Holds 8 bytes a
/// texel, 10.7 bytes a pixel of the picture with all levels. One that was moved from can only be assigned to or
/// destroyed.
class Texture {
 public:
  /// From sRGB-encoded red, green, blue and linear alpha, row-major, top-left first, as pictures of glTF are. Any sizes
  /// up to kMaxTextureSize, powers of two or not. `largest_side`: levels with a longer side are not kept; where that is
  /// below 1, one texel is. Nothing when a size is outside 1..kMaxTextureSize or `pixels` not width * height long;
  /// memory that the system refuses is std::bad_alloc.
  static std::optional<Texture> from_srgb(int width, int height, std::span<const glm::u8vec4> pixels,
                                          int largest_side = kMaxTextureSize);
  ~Texture();
  Texture(Texture&&) noexcept;
  Texture& operator=(Texture&&) noexcept;

  /// Of the largest level that is kept, and how many there are.
  int width() const noexcept;
  int height() const noexcept;
  int level_count() const noexcept;

  struct Data;  ///< the renderer's
  const Data* data() const noexcept { return data_.get(); }

 private:
  explicit Texture(std::unique_ptr<Data> data) noexcept;
  std::unique_ptr<Data> data_;
};

/// What is shown beyond 0..1 (glTF's samplers; Vulkan 1.3, 16.8).
enum class Wrap : uint8_t {
  kRepeat,
  kMirroredRepeat,
  kClamp,  ///< to the edge
};

enum class AlphaMode : uint8_t {
  kOpaque,  ///< alpha is ignored
  kMask,    ///< a pixel whose filtered alpha is below the cut-off is not drawn, in all its samples
};

/// How a mesh wears a texture. Glass and veils (glTF's BLEND) there are not: kMask with a cut-off of 0.5 comes nearest.
struct TextureUse {
  const Texture* texture = nullptr;          ///< null: none, all else is ignored; must live until the end of end_frame
  std::span<const glm::vec2> coordinates{};  ///< u, v, one pair per position
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat;
  AlphaMode alpha = AlphaMode::kOpaque;
  float alpha_cutoff = 0.5F;  ///< of the texture's alpha; above 1: nothing is drawn
};

}  // namespace auslan::raster
