// SPDX-License-Identifier: Apache-2.0
#include "phonology/vocabulary.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace auslan {
namespace {

using Names = std::string_view;

constexpr Names kLocations[] = {"top_head",        "forehead",
                                "eyebrow",         "temple",
                                "side_head",       "eye",
                                "cheekbone",       "nose",
                                "nostrils",        "face",
                                "cheek",           "ear",
                                "earlobe",         "contra_ear",
                                "upper_lip",       "mouth",
                                "teeth",           "tongue",
                                "lower_lip",       "chin",
                                "under_chin",      "neck",
                                "shoulder",        "contra_shoulder",
                                "upper_chest",     "chest",
                                "contra_chest",    "stomach",
                                "lower_stomach",   "waist",
                                "thigh",           "upper_arm",
                                "elbow",           "high_neutral",
                                "neutral",         "low_neutral",
                                "ipsi_space",      "contra_space",
                                "nd_palm",         "nd_back",
                                "nd_wrist_back",   "nd_wrist_inner",
                                "nd_forearm_back", "nd_forearm_inner",
                                "nd_fingertips",   "nd_thumb",
                                "nd_index",        "nd_middle",
                                "nd_ring",         "nd_little",
                                "nd_ulnar",        "nd_radial",
                                "nd_fist_top",     "nd_elbow",
                                "hands",           "nd_thumb_ball",
                                "nd_wrist_radial", "nd_wrist_ulnar",
                                "nd_elbow_inside"};
constexpr Names kHandParts[] = {"palm",        "back",         "radial",           "ulnar",
                                "fingertips",  "index_tip",    "middle_tip",       "ring_tip",
                                "little_tip",  "thumb_tip",    "thumb_index_tips", "index_middle_tips",
                                "index_side",  "index_middle", "fingers",          "index_knuckle",
                                "knuckles",    "wrist",        "fist_thumb_side",  "fist_ulnar",
                                "thumb_web",   "index_base",   "index_mid_joint",  "thumb_side",
                                "index_pad",   "thumb_ball",   "wrist_back",       "wrist_radial",
                                "wrist_ulnar", "forearm"};
static_assert(std::size(kLocations) == static_cast<size_t>(Location::kOtherDigitSites));
static_assert(std::size(kHandParts) == static_cast<size_t>(HandPart::kDigitSites));
constexpr std::array<Names, kDigits> kDigitNames = {"thumb", "index", "middle", "ring", "little"};
// A tip is also written "fingertip", to tell it from the older names, by which a pointing hand's tip is meant.
constexpr std::array<Names, kDigitFeatures> kFeatureNames = {
    "fingertip",  "nail",          "tip_pad",       "tip_radial",    "tip_ulnar",   "mid_palmar",
    "mid_dorsal", "mid_radial",    "mid_ulnar",     "base_palmar",   "base_dorsal", "base_radial",
    "base_ulnar", "length_palmar", "length_dorsal", "length_radial", "length_ulnar"};

/// The names of an enumeration that ends with all places on digits.
class NamesWithDigits {
 public:
  NamesWithDigits(std::span<const Names> first, std::string_view before) : names_(first.begin(), first.end()) {
    for (const Names digit : kDigitNames)
      for (const Names feature : kFeatureNames) {
        std::string name(before);
        name += digit;
        name += '_';
        name += feature;
        made_.push_back(std::move(name));
      }
    names_.insert(names_.end(), made_.begin(), made_.end());
  }
  std::span<const Names> names() const { return names_; }

 private:
  std::vector<std::string> made_;
  std::vector<Names> names_;
};

constexpr std::array<Names, 6> kContacts = {"touch", "hold", "brush", "near", "interlock", "cross"};
constexpr std::array<Names, 28> kMoves = {
    "hold",    "straight", "arc",   "circle",    "spiral", "zigzag",   "wavy",     "tap",   "brush", "rub",
    "twist",   "nod",      "swing", "stir",      "shake",  "sway",     "bounce",   "open",  "close", "flick",
    "squeeze", "wiggle",   "bend",  "alternate", "cross",  "separate", "approach", "strike"};
constexpr std::array<Names, 4> kSizes = {"tiny", "small", "medium", "large"};
constexpr std::array<Names, 6> kManners = {"plain", "slow", "fast", "sharp", "tense", "rest"};
constexpr std::array<Names, 3> kGrowth = {"none", "increasing", "decreasing"};
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
  static const NamesWithDigits all(kLocations, "nd_");
  return all.names();
}
template <>
std::span<const Names> names_of<HandPart>() {
  static const NamesWithDigits all(kHandParts, "");
  return all.names();
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
std::span<const Names> names_of<Growth>() {
  return kGrowth;
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
    std::string_view part = name.substr(0, dash);
    int weight = 1;
    if (const size_t colon = part.find(':'); colon != std::string_view::npos) {
      const std::string_view digits = part.substr(colon + 1);
      const auto [rest, error] = std::from_chars(digits.data(), digits.data() + digits.size(), weight);
      if (error != std::errc() || rest != digits.data() + digits.size() || weight < 1 || weight > kFinestWeight)
        return std::nullopt;
      part = part.substr(0, colon);
    }
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
    *axis = sign * weight;
    if (dash == std::string_view::npos) return direction;
    name.remove_prefix(dash + 1);
  }
}

std::string to_name(const Direction& direction) {
  std::string name;
  const auto add = [&name](int weight, std::string_view positive, std::string_view negative) {
    if (weight == 0) return;
    if (!name.empty()) name += '-';
    name += weight > 0 ? positive : negative;
    if (std::abs(weight) != 1) (name += ':') += std::to_string(std::abs(weight));
  };
  add(direction.left, "left", "right");
  add(direction.up, "up", "down");
  add(direction.away, "away", "toward");
  return name;
}

Direction to_direction(const Vec3& v) {
  const double size = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  if (!(size > 0)) return {0, 0, 1};
  const Vec3 n = v / size;
  const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
  const auto part = [&n, largest](glm::length_t i) {
    const double share = n[i] / largest;
    return std::abs(share) < 0.5 ? 0 : share > 0 ? 1 : -1;
  };
  const Direction plain{part(0), part(1), part(2)};
  const Vec3 off = to_vector(plain) - n;
  if (glm::dot(off, off) < 1e-6) return plain;
  const auto weight = [&n](glm::length_t i) { return static_cast<int>(std::lround(n[i] * kFinestWeight)); };
  return {weight(0), weight(1), weight(2)};
}

HandPart hand_part(const DigitSite& site) {
  return static_cast<HandPart>(static_cast<int>(HandPart::kDigitSites) + site.digit * kDigitFeatures +
                               static_cast<int>(site.feature));
}
Location other_location(const DigitSite& site) {
  return static_cast<Location>(static_cast<int>(Location::kOtherDigitSites) + site.digit * kDigitFeatures +
                               static_cast<int>(site.feature));
}
std::optional<DigitSite> digit_site(HandPart part) {
  const int index = static_cast<int>(part) - static_cast<int>(HandPart::kDigitSites);
  if (index < 0 || index >= kDigits * kDigitFeatures) return std::nullopt;
  return DigitSite{index / kDigitFeatures, static_cast<DigitFeature>(index % kDigitFeatures)};
}
std::optional<DigitSite> digit_site(Location location) {
  const int index = static_cast<int>(location) - static_cast<int>(Location::kOtherDigitSites);
  if (index < 0 || index >= kDigits * kDigitFeatures) return std::nullopt;
  return DigitSite{index / kDigitFeatures, static_cast<DigitFeature>(index % kDigitFeatures)};
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
