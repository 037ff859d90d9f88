// SPDX-License-Identifier: Apache-2.0
// Direction letters (u d l r o i) as vectors in world axes, and the rule that makes a palm letter absolute.
#pragma once

#include "kinematics/vector.h"
#include "phonology/sign.h"

#include <optional>
#include <string_view>

namespace auslan::notation {

/// Sum of the letters, as a unit vector; letters may be repeated as weights ("ddool"). Nothing for other letters, for
/// none, and where they cancel out.
std::optional<Vec3> vector_of_letters(std::string_view letters);

/// Midway; `a` where they are opposite.
Vec3 midway(const Vec3& a, const Vec3& b);

/// Where the palm faces. `letter` is the palm letters' vector, read with the fingers pointing away from the signer;
/// that hand is pitched to the elevation of `fingers` and then turned to its bearing. With inward fingers l and r are
/// exchanged first, so that they stay literal.
Vec3 palm_of(const Vec3& letter, const Vec3& fingers);

/// The nearest of the 26 directions.
Direction nearest_direction(const Vec3& v);
/// The nearest of the 26 that, made perpendicular to `fingers`, is `palm`.
Direction nearest_palm(const Vec3& palm, const Direction& fingers);

/// Angle between two directions, degrees.
double angle_deg(const Vec3& a, const Vec3& b);

}  // namespace auslan::notation
