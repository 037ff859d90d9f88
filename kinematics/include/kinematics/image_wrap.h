// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace auslan {

/// What of an image is shown beyond its edges (the samplers of glTF).
enum class ImageWrap : uint8_t { kRepeat, kMirroredRepeat, kClamp };

}  // namespace auslan
