// SPDX-License-Identifier: Apache-2.0
// A foreign figure as a model that signs: its own skin, morph targets, eyes and jaw, moved by the project's skeleton.
#pragma once

#include "kinematics/body_model.h"
#include "kinematics/signing_avatar.h"

#include <memory>

namespace auslan {

/// Every bone follows its node rigidly, upper arms and forearms twist along their length, the skin is blended linearly
/// as glTF has it. A face channel weighs its morph targets; where it has none, eyes turn and the jaw opens by their
/// bones. Colours are those of the material and the vertices; the meshes name the avatar's images. `avatar` outlives
/// the model.
std::unique_ptr<BodyModel> make_avatar_model(const SigningAvatar& avatar);

}  // namespace auslan
