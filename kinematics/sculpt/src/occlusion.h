// SPDX-License-Identifier: Apache-2.0
// How much of the light from all around the body keeps from each vertex, baked into the paint.
#pragma once

#include "reduce.h"

#include <span>

namespace auslan::sculpt {

/// A sculpture where it stands at rest. Its parts that take no occlusion, because the face moves them, give none
/// either.
struct Occluder {
  const Sculpture* sculpture = nullptr;
  Vec3 place{0.0};  ///< of its node in the world, metres
};

/// Darkens the paint of `sculpture`, whose node stands at `place`, where the occluders stand near and before it: rays
/// over the half space round each normal (cosine-weighted) count what they hit within `reach` millimetres, near things
/// more. `strength` is how much darker a vertex gets that sees nothing but near things, times its own share
/// (Sculpture::occlusion). Only what moves with the body or hardly against it should be an occluder.
void bake_occlusion(Sculpture& sculpture, const Vec3& place, std::span<const Occluder> occluders, double reach,
                    double strength);

}  // namespace auslan::sculpt
