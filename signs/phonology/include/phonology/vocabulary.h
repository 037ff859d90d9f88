// SPDX-License-Identifier: Apache-2.0
// The closed vocabulary of the sign notation: the spelling of every enumeration, both ways.
#pragma once

#include "phonology/sign.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace auslan {

/// All spellings of an enumeration, in enum order.
template <typename E>
std::span<const std::string_view> names_of();

template <>
std::span<const std::string_view> names_of<Location>();
template <>
std::span<const std::string_view> names_of<HandPart>();
template <>
std::span<const std::string_view> names_of<ContactKind>();
template <>
std::span<const std::string_view> names_of<MoveKind>();
template <>
std::span<const std::string_view> names_of<Size>();
template <>
std::span<const std::string_view> names_of<Manner>();
template <>
std::span<const std::string_view> names_of<Growth>();
template <>
std::span<const std::string_view> names_of<Plane>();
template <>
std::span<const std::string_view> names_of<MovingHands>();
template <>
std::span<const std::string_view> names_of<Handedness>();
template <>
std::span<const std::string_view> names_of<Confidence>();
template <>
std::span<const std::string_view> names_of<ReviewState>();

template <typename E>
std::string_view to_name(E value) {
  return names_of<E>()[static_cast<size_t>(value)];
}

template <typename E>
std::optional<E> from_name(std::string_view name) {
  const auto names = names_of<E>();
  for (size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<E>(i);
  return std::nullopt;
}

/// "up", "left-away", "up-left-toward", and with weights "left:383-up:924": parts in any order, each axis at most once,
/// weights of 1 to kFinestWeight; nullopt for anything else.
std::optional<Direction> direction_from_name(std::string_view name);
/// The canonical spelling: left/right, then up/down, then away/toward; a weight of 1 is not written.
std::string to_name(const Direction& direction);
/// Unit vector in world axes.
Vec3 to_vector(const Direction& direction);
/// One of the 26 where the vector is one, else weights that are off by less than 0.1 degrees.
Direction to_direction(const Vec3& v);

/// A place on a digit as a part of the articulating hand, and as a place on the other one; and back, nothing for the
/// parts and places that are none.
HandPart hand_part(const DigitSite& site);
Location other_location(const DigitSite& site);
std::optional<DigitSite> digit_site(HandPart part);
std::optional<DigitSite> digit_site(Location location);

/// The rule for a location on the other hand (an `nd_…` name or `hands`).
bool is_on_other_hand(Location location);

}  // namespace auslan
