// SPDX-License-Identifier: Apache-2.0
#include "phonology/vocabulary.h"

#include <array>
#include <cmath>

namespace auslan {
namespace {

using Names = std::string_view;

constexpr std::array<Names, 44> kLocations = {"top_head",
                                              "forehead",
                                              "temple",
                                              "side_head",
                                              "eye",
                                              "cheekbone",
                                              "nose",
                                              "face",
                                              "cheek",
                                              "ear",
                                              "mouth",
                                              "chin",
                                              "neck",
                                              "shoulder",
                                              "contra_shoulder",
                                              "chest",
                                              "contra_chest",
                                              "stomach",
                                              "waist",
                                              "thigh",
                                              "upper_arm",
                                              "elbow",
                                              "high_neutral",
                                              "neutral",
                                              "low_neutral",
                                              "ipsi_space",
                                              "contra_space",
                                              "nd_palm",
                                              "nd_back",
                                              "nd_wrist_back",
                                              "nd_wrist_inner",
                                              "nd_forearm_back",
                                              "nd_forearm_inner",
                                              "nd_fingertips",
                                              "nd_thumb",
                                              "nd_index",
                                              "nd_middle",
                                              "nd_ring",
                                              "nd_little",
                                              "nd_ulnar",
                                              "nd_radial",
                                              "nd_fist_top",
                                              "nd_elbow",
                                              "hands"};
constexpr std::array<Names, 25> kHandParts = {"palm",       "back",         "radial",           "ulnar",
                                              "fingertips", "index_tip",    "middle_tip",       "ring_tip",
                                              "little_tip", "thumb_tip",    "thumb_index_tips", "index_middle_tips",
                                              "index_side", "index_middle", "fingers",          "index_knuckle",
                                              "knuckles",   "wrist",        "fist_thumb_side",  "fist_ulnar",
                                              "thumb_web",  "index_base",   "index_mid_joint",  "thumb_side",
                                              "index_pad"};
constexpr std::array<Names, 4> kContacts = {"touch", "hold", "brush", "near"};
constexpr std::array<Names, 26> kMoves = {"hold",      "straight", "arc",      "circle",   "spiral",  "zigzag", "wavy",
                                          "tap",       "brush",    "rub",      "twist",    "nod",     "shake",  "sway",
                                          "bounce",    "open",     "close",    "flick",    "squeeze", "wiggle", "bend",
                                          "alternate", "cross",    "separate", "approach", "strike"};
constexpr std::array<Names, 4> kSizes = {"tiny", "small", "medium", "large"};
constexpr std::array<Names, 4> kManners = {"plain", "slow", "fast", "sharp"};
constexpr std::array<Names, 13> kPlanes = {"none",     "horizontal", "vertical",     "frontal", "sagittal",
                                           "supinate", "pronate",    "side_to_side", "up_down", "to_fro",
                                           "fingers",  "cw",         "ccw"};
constexpr std::array<Names, 4> kMovingHands = {"dom", "nd", "both", "alt"};
constexpr std::array<Names, 4> kHandedness = {"one", "two-symmetric", "two-alternating", "dominant+base"};
constexpr std::array<Names, 3> kConfidence = {"low", "medium", "high"};
constexpr std::array<Names, 3> kReview = {"unreviewed", "reviewed", "rejected"};

}  // namespace

template <>
std::span<const Names> names_of<Location>() {
  return kLocations;
}
template <>
std::span<const Names> names_of<HandPart>() {
  return kHandParts;
}
template <>
std::span<const Names> names_of<ContactKind>() {
  return kContacts;
}
template <>
std::span<const Names> names_of<MoveKind>() {
  return kMoves;
}
template <>
std::span<const Names> names_of<Size>() {
  return kSizes;
}
template <>
std::span<const Names> names_of<Manner>() {
  return kManners;
}
template <>
std::span<const Names> names_of<Plane>() {
  return kPlanes;
}
template <>
std::span<const Names> names_of<MovingHands>() {
  return kMovingHands;
}
template <>
std::span<const Names> names_of<Handedness>() {
  return kHandedness;
}
template <>
std::span<const Names> names_of<Confidence>() {
  return kConfidence;
}
template <>
std::span<const Names> names_of<ReviewState>() {
  return kReview;
}

std::optional<Direction> direction_from_name(std::string_view name) {
  Direction direction;
  if (name.empty()) return std::nullopt;
  while (true) {
    const size_t dash = name.find('-');
    const std::string_view part = name.substr(0, dash);
    int* axis = nullptr;
    int sign = 1;
    if (part == "left" || part == "right") {
      axis = &direction.left;
      sign = part == "left" ? 1 : -1;
    } else if (part == "up" || part == "down") {
      axis = &direction.up;
      sign = part == "up" ? 1 : -1;
    } else if (part == "away" || part == "toward") {
      axis = &direction.away;
      sign = part == "away" ? 1 : -1;
    }
    if (axis == nullptr || *axis != 0) return std::nullopt;
    *axis = sign;
    if (dash == std::string_view::npos) return direction;
    name.remove_prefix(dash + 1);
  }
}

std::string to_name(const Direction& direction) {
  std::string name;
  const auto add = [&name](std::string_view part) {
    if (!name.empty()) name += '-';
    name += part;
  };
  if (direction.left != 0) add(direction.left > 0 ? "left" : "right");
  if (direction.up != 0) add(direction.up > 0 ? "up" : "down");
  if (direction.away != 0) add(direction.away > 0 ? "away" : "toward");
  return name;
}

Vec3 to_vector(const Direction& direction) {
  const Vec3 v(direction.left, direction.up, direction.away);
  const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return length > 0 ? v / length : Vec3(0, 0, 1);
}

bool is_on_other_hand(Location location) {
  return location >= Location::kOtherPalm;
}

}  // namespace auslan
