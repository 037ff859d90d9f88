// SPDX-License-Identifier: Apache-2.0
// A foreign figure as a model that signs: its own skin, morph targets, eyes and jaw, moved by the project's skeleton.
#pragma once

#include "kinematics/body_model.h"
#include "kinematics/signing_avatar.h"

#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

namespace auslan {

/// The decoded pixels of an AvatarImage: sRGB-encoded red, green, blue, and alpha; the top row first. Empty where it
/// could not be decoded.
struct AvatarPicture {
  int width = 0, height = 0;
  std::vector<glm::u8vec4> pixels;
};

/// Every bone follows its node rigidly, upper arms and forearms twist along their length, the skin is blended linearly
/// as glTF has it. A face channel weighs its morph targets; where it has none, eyes turn and the jaw opens by their
/// bones. Colours are those of the material, the vertices and, at the vertices, the image. `avatar` outlives the
/// model; `pictures` (one an image, or none at all) are only read here.
std::unique_ptr<BodyModel> make_avatar_model(const SigningAvatar& avatar, std::span<const AvatarPicture> pictures);

}  // namespace auslan
