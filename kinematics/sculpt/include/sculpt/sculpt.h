// SPDX-License-Identifier: Apache-2.0
// From a table of measurements to a figure: 41 joints and closed, coloured meshes.
#pragma once

#include "kinematics/figure.h"
#include "sculpt/measurements.h"

#include <string_view>

namespace auslan {

/// The joints alone, T-pose, metres: arms along +-X, palms down, fingers straight, thumbs forward and out.
Result<Skeleton> sculpt_skeleton(const Measurements& table);

/// How many triangles a figure is made of; the form, its joints and its channels are the same.
enum class Detail {
  kLow,     ///< about 5,000
  kNormal,  ///< about 20,000: more than two fifths of them in the hands, a third in the head
  kHigh,    ///< about 80,000: the surfaces as they are sculpted
};
inline constexpr std::string_view kDetailNames[] = {"low", "normal", "high"};

/// The whole figure. Every segment's mesh is one or more closed manifold parts wound outwards; the right side is the
/// exact mirror image of the left; the face channels are morphs of head_base's mesh. The
/// first pigment of every appearance is the skin's. The same table gives the same
/// bytes on every machine: only + - * / and sqrt are used. Fails only as Skeleton::build does.
Result<Figure> sculpt_figure(const Measurements& table, Detail detail = Detail::kNormal);

}  // namespace auslan
