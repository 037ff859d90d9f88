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

/// "up", "left-away", "up-left-toward": parts in any order, each axis at most once; nullopt for anything else.
std::optional<Direction> direction_from_name(std::string_view name);
/// The canonical spelling: left/right, then up/down, then away/toward.
std::string to_name(const Direction& direction);
/// Unit vector in world axes.
Vec3 to_vector(const Direction& direction);

/// The rule for a location on the other hand (an `nd_…` name or `hands`).
bool is_on_other_hand(Location location);

}  // namespace auslan
