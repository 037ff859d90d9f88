// SPDX-License-Identifier: Apache-2.0
// Face, head and mouth in the other kind of SiGML. The elements of hamnosys_nonmanual are all at the same time; a tier
// of gestural SiGML puts its elements one after another, unless they are in its group for what is simultaneous.
#include "converter.h"

#include <algorithm>
#include <array>

namespace auslan::notation {
namespace {

struct Pair {
  std::string_view hns, gestural, tier, together;
};
constexpr std::array<Pair, 10> kPairs = {{
    {"hnm_shoulder", "shoulder_movement", "shoulder_tier", "shoulder_par"},
    {"hnm_body", "body_movement", "body_tier", "body_par"},
    {"hnm_head", "head_movement", "head_tier", "head_par"},
    {"hnm_eyegaze", "eye_gaze", "eyegaze_tier", "eyegaze_par"},
    {"hnm_eyebrows", "eye_brows", "facialexpr_tier", "facial_expr_par"},
    {"hnm_eyelids", "eye_lids", "facialexpr_tier", "facial_expr_par"},
    {"hnm_nose", "nose", "facialexpr_tier", "facial_expr_par"},
    {"hnm_mouthgesture", "mouth_gesture", "mouthing_tier", "mouthing_par"},
    {"hnm_mouthpicture", "mouth_picture", "mouthing_tier", "mouthing_par"},
    {"hnm_extra", "extra_movement", "extra_tier", "extra_par"},
}};

void flatten(const WrittenElement& group, size_t depth, WrittenElement& to, Findings& findings) {
  for (const WrittenElement& child : group.children) {
    const auto pair = std::ranges::find(kPairs, std::string_view(child.name), &Pair::gestural);
    if (pair == kPairs.end()) {
      if (group.name.ends_with("_tier") && group.children.size() > 1 && child.name.ends_with("_par"))
        findings.left_out({}, "the order in time of non-manual features cannot be written in HamNoSys SiGML");
      if (depth < 8 && !child.children.empty()) flatten(child, depth + 1, to, findings);
      continue;
    }
    if (!group.name.ends_with("_par") && group.children.size() > 1)
      findings.left_out({}, "the order in time of non-manual features cannot be written in HamNoSys SiGML");
    WrittenElement& element = to.add(pair->hns);
    for (const auto& [name, value] : child.attributes) {
      const bool tag = name == "movement" || name == "direction";
      element.put(tag ? "tag" : name, value);
    }
  }
}

}  // namespace

void write_tiers(const WrittenElement& from, WrittenElement& to, Findings& findings) {
  WrittenElement tiers;
  tiers.name = "sign_nonmanual";
  for (const WrittenElement& child : from.children) {
    const auto pair = std::ranges::find(kPairs, std::string_view(child.name), &Pair::hns);
    if (pair == kPairs.end()) {
      findings.left_out({}, "the element " + in_quotes(child.name) + " has no counterpart in gestural SiGML");
      continue;
    }
    auto tier = std::ranges::find(tiers.children, pair->tier, &WrittenElement::name);
    if (tier == tiers.children.end()) {
      tiers.add(pair->tier).add(pair->together);
      tier = tiers.children.end() - 1;
    }
    WrittenElement& element = tier->children.front().add(pair->gestural);
    for (const auto& [name, value] : child.attributes)
      element.put(name == "tag" ? (pair->gestural == "eye_gaze" ? "direction" : "movement") : name, value);
  }
  // A group of one is none.
  for (WrittenElement& tier : tiers.children)
    if (tier.children.front().children.size() == 1) {
      WrittenElement only = std::move(tier.children.front().children.front());
      tier.children = {std::move(only)};
    }
  if (!tiers.children.empty()) to.children.push_back(std::move(tiers));
}

void write_hnm(const WrittenElement& from, WrittenElement& to, Findings& findings) {
  WrittenElement elements;
  elements.name = "hamnosys_nonmanual";
  flatten(from, 0, elements, findings);
  if (!elements.children.empty()) to.children.push_back(std::move(elements));
}

}  // namespace auslan::notation
