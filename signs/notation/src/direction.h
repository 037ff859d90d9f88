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

/// What is written on the face of something that points away from the signer (the bow of a path, the clock of a
/// circle), carried to something that points to `axis` by the shortest turn. What points towards the signer is turned
/// from there, so that letters stay literal.
Vec3 carried(const Vec3& face, const Vec3& axis);

/// The palm as one of the 26 directions where one of them lies, made perpendicular to `fingers`, within a degree of
/// it; else exactly.
Direction palm_direction(const Vec3& palm, const Vec3& fingers);

/// Angle between two directions, degrees.
double angle_deg(const Vec3& a, const Vec3& b);

}  // namespace auslan::notation
