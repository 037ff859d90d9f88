// SPDX-License-Identifier: Apache-2.0
#include "kinematics/figure.h"

#include <algorithm>

namespace auslan {

glm::u8vec4 painted(const Paint& paint, const Appearance& appearance) {
  constexpr uint32_t kWhole = 255;
  constexpr uint32_t kOne = kWhole * Paint::kFullShade;
  const glm::u8vec3& first = appearance.pigments[paint.first];
  const glm::u8vec3& second = appearance.pigments[paint.second];
  glm::u8vec4 colour(255);
  for (int channel = 0; channel < 3; ++channel) {
    const uint32_t mixed = first[channel] * (kWhole - paint.share) + uint32_t{second[channel]} * paint.share;
    colour[channel] = static_cast<uint8_t>(std::min((mixed * paint.shade + kOne / 2) / kOne, kWhole));
  }
  return colour;
}

Result<const Appearance*> put_on(Figure& figure, std::string_view name) {
  const auto found = std::ranges::find(figure.appearances, name, &Appearance::name);
  if (found == figure.appearances.end()) {
    std::string names;
    for (const Appearance& appearance : figure.appearances)
      names += (names.empty() ? "it has " : ", ") + appearance.name;
    return fail(ErrorCode::kUsage, "the figure has no appearance \"" + std::string(name) + "\"; " +
                                       (names.empty() ? "it has only its own colours" : names));
  }
  for (Mesh& mesh : figure.segments)
    for (size_t i = 0; i < mesh.paint.size(); ++i)
      mesh.colours[i] = painted(mesh.paint[i], *found);
  return &*found;
}

}  // namespace auslan
