// SPDX-License-Identifier: Apache-2.0
// The images of an avatar, decoded.
#pragma once

#include "kinematics/avatar_model.h"

#include <string>
#include <vector>

namespace auslan {

/// One a picture of the avatar; those that no surface shows stay empty, and so do those that cannot be read, which
/// `warnings` tells. At most 64 million pixels together.
std::vector<AvatarPicture> decode_pictures(const Avatar& avatar, std::vector<std::string>& warnings);

}  // namespace auslan
