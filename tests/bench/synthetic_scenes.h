// SPDX-License-Identifier: Apache-2.0
// The scenes that no figure is needed for, made in clip space from a fixed seed.
#pragma once

#include "scene.h"

namespace auslan::bench {

enum class DepthOrder { kRandom, kBackToFront };

/// 50 triangles, each of at least three tenths of the picture's area, in layers that do not cut each other.
Scene make_fill(DepthOrder order);

/// A bumpy grid of 500 thousand triangles, between 2 and 4 pixels each at 1920x1080, as one indexed mesh.
Scene make_tiny();

}  // namespace auslan::bench
