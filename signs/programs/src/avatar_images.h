// SPDX-License-Identifier: Apache-2.0
// The images of an avatar, decoded and made into textures.
#pragma once

#include "kinematics/avatar.h"
#include "raster/texture.h"

#include <optional>
#include <string>
#include <vector>

namespace auslan {

/// One an image of the avatar; nothing for those that no surface shows and for those that cannot be read, which
/// `warnings` tells. At most 64 million pixels are decoded; of larger images than 2048 pixels a side, a smaller level
/// is kept.
std::vector<std::optional<raster::Texture>> decode_images(const Avatar& avatar, std::vector<std::string>& warnings);

}  // namespace auslan
