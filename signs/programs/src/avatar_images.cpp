// SPDX-License-Identifier: Apache-2.0
#include "avatar_images.h"

#include "media/picture_module.h"

#include <algorithm>

namespace auslan {
namespace {

constexpr size_t kMaxPixels = size_t{4096} * 4096;  ///< of one image
constexpr size_t kMaxPixelsTogether = 4 * kMaxPixels;

constexpr int kLargestSide = 2048;

std::optional<raster::Texture> as_texture(const Picture& picture) {
  std::vector<glm::u8vec4> pixels;
  pixels.reserve(picture.pixels.size());
  for (const uint32_t pixel : picture.pixels)
    pixels.emplace_back(static_cast<uint8_t>(pixel >> 16U), static_cast<uint8_t>(pixel >> 8U),
                        static_cast<uint8_t>(pixel), static_cast<uint8_t>(pixel >> 24U));
  return raster::Texture::from_srgb(picture.width, picture.height, pixels, kLargestSide);
}

}  // namespace

std::vector<std::optional<raster::Texture>> decode_images(const Avatar& avatar, std::vector<std::string>& warnings) {
  std::vector<bool> is_wanted(avatar.images.size(), false);
  for (const AvatarNode& node : avatar.nodes)
    if (node.mesh >= 0)
      for (const AvatarSurface& surface : avatar.meshes[static_cast<size_t>(node.mesh)].surfaces)
        if (surface.image >= 0) is_wanted[static_cast<size_t>(surface.image)] = true;
  std::vector<std::optional<raster::Texture>> textures(avatar.images.size());
  size_t left = kMaxPixelsTogether;
  size_t unread = 0;
  std::string reason;
  for (size_t i = 0; i < textures.size(); ++i) {
    const AvatarImage& image = avatar.images[i];
    if (!is_wanted[i] || image.bytes.empty() || image.format == AvatarImage::Format::kOther) continue;
    const ImageFormat format = image.format == AvatarImage::Format::kPng ? ImageFormat::kPng : ImageFormat::kJpeg;
    const auto picture = decode_image(image.bytes, format, std::min(kMaxPixels, left), "");
    if (!picture) {
      ++unread;
      if (reason.empty()) reason = picture.error().message;
      continue;
    }
    left -= picture->pixels.size();
    textures[i] = as_texture(*picture);
  }
  if (unread > 0)
    warnings.push_back(std::to_string(unread) + (unread == 1 ? " image is" : " images are") +
                       " not shown, their surfaces keep the base colour alone: " + reason);
  return textures;
}

}  // namespace auslan
