// SPDX-License-Identifier: Apache-2.0
// A picture becomes a texture: linear light, and each level the mean of the one before.
#include "raster/texture.h"

#include "raster/srgb.h"
#include "texture_data.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>

namespace auslan::raster {
namespace {

using Texel = std::array<uint16_t, 4>;  // linear red, green, blue, alpha, each 0 to kTexelScale

std::array<uint16_t, 256> make_light_table() {
  std::array<uint16_t, 256> table{};
  for (size_t code = 0; code < table.size(); ++code) {
    const float light = linear_from_srgb(static_cast<uint8_t>(code)) * static_cast<float>(kTexelScale);
    table[code] = static_cast<uint16_t>(std::min(light + 0.5F, static_cast<float>(kTexelScale)));
  }
  table[255] = kTexelScale;
  return table;
}

uint16_t alpha_texel(uint8_t alpha) {
  return static_cast<uint16_t>((uint32_t{alpha} * uint32_t{kTexelScale} + 127U) / 255U);
}

int half_of(int size) {
  return std::max(size / 2, 1);
}

// What a texel of the next level takes of three of this one from `first` on: an odd size of 2 m + 1 becomes m, so each
// stands for 2 + 1 / m.
struct Taps {
  int first, count;
  int64_t weight[3];
};
Taps taps_of(int size, int place) {
  if (size == 1) return {0, 1, {1, 0, 0}};
  const int half = size / 2;
  if (size % 2 == 0) return {2 * place, 2, {1, 1, 0}};
  return {2 * place, 3, {half - place, half, place + 1}};
}

template <class Read>
std::vector<Texel> next_level(int width, int height, const Read& read) {
  const int across = half_of(width);
  const int down = half_of(height);
  std::vector<Texel> texels(static_cast<size_t>(across) * static_cast<size_t>(down));
  auto* out = texels.data();
  for (int y = 0; y < down; ++y) {
    const Taps rows = taps_of(height, y);
    for (int x = 0; x < across; ++x, ++out) {
      const Taps columns = taps_of(width, x);
      std::array<int64_t, 4> sum{};
      int64_t share = 0;
      for (int j = 0; j < rows.count; ++j) {
        for (int i = 0; i < columns.count; ++i) {
          const int64_t weight = rows.weight[j] * columns.weight[i];
          const Texel texel = read(columns.first + i, rows.first + j);
          for (size_t c = 0; c < 4; ++c)
            sum[c] += weight * texel[c];
          share += weight;
        }
      }
      for (size_t c = 0; c < 4; ++c)
        (*out)[c] = static_cast<uint16_t>((sum[c] + share / 2) / share);
    }
  }
  return texels;
}

template <class Read>
void append(int width, int height, const Read& read, Texture::Data& data) {
  data.levels.push_back({static_cast<float>(width), static_cast<float>(height),
                         static_cast<int32_t>(data.texels.size() / kTexelWords), 0});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Texel texel = read(x, y);
      data.texels.push_back(std::bit_cast<float>(uint32_t{texel[0]} | uint32_t{texel[1]} << 16U));
      data.texels.push_back(std::bit_cast<float>(uint32_t{texel[2]} | uint32_t{texel[3]} << 16U));
    }
  }
}

std::atomic<uint64_t> last_serial{0};

}  // namespace

Texture::Texture(std::unique_ptr<Data> data) noexcept : data_(std::move(data)) {}
Texture::~Texture() = default;
Texture::Texture(Texture&&) noexcept = default;
Texture& Texture::operator=(Texture&&) noexcept = default;

std::optional<Texture> Texture::from_srgb(int width, int height, std::span<const glm::u8vec4> pixels,
                                          int largest_side) {
  if (width < 1 || width > kMaxTextureSize || height < 1 || height > kMaxTextureSize) return std::nullopt;
  if (pixels.size() != static_cast<size_t>(width) * static_cast<size_t>(height)) return std::nullopt;
  const auto is_kept = [largest_side](int w, int h) { return std::max(w, h) <= std::max(largest_side, 1); };
  size_t texels = 0;
  for (int w = width, h = height;; w = half_of(w), h = half_of(h)) {
    if (is_kept(w, h)) texels += static_cast<size_t>(w) * static_cast<size_t>(h);
    if (w == 1 && h == 1) break;
  }
  auto data = std::make_unique<Data>();
  data->texels.reserve(kTexelWords * texels);

  const std::array<uint16_t, 256> light = make_light_table();
  const auto of_picture = [pixels, width, &light](int x, int y) {
    const glm::u8vec4& pixel = pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    return Texel{light[pixel.x], light[pixel.y], light[pixel.z], alpha_texel(pixel.w)};
  };
  if (is_kept(width, height)) append(width, height, of_picture, *data);
  std::vector<Texel> level;
  int w = width;
  int h = height;
  const auto of_level = [&level, &w](int x, int y) {
    return level[static_cast<size_t>(y) * static_cast<size_t>(w) + static_cast<size_t>(x)];
  };
  while (w > 1 || h > 1) {
    level = level.empty() ? next_level(w, h, of_picture) : next_level(w, h, of_level);
    w = half_of(w);
    h = half_of(h);
    if (is_kept(w, h)) append(w, h, of_level, *data);
  }
  data->serial = ++last_serial;
  return Texture(std::move(data));
}

int Texture::width() const noexcept {
  return static_cast<int>(data_->levels.front().width);
}

int Texture::height() const noexcept {
  return static_cast<int>(data_->levels.front().height);
}

int Texture::level_count() const noexcept {
  return static_cast<int>(data_->levels.size());
}

}  // namespace auslan::raster
