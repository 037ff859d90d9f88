// SPDX-License-Identifier: Apache-2.0
#include "body.h"

namespace auslan {

FigureTraits Body::traits() const {
  // Skirts, bags and wide chests of foreign figures give more than a shirt: an elbow that avoided them would stand out.
  constexpr double kGives = 0.03;
  if (avatar == nullptr) return {};
  return {.face = avatar->face, .trunk_gives = kGives};
}

Result<Stage> Body::stage(const StageOptions& options) const {
  if (avatar == nullptr) return Stage::build(*figure, options);
  return Stage::build(*figure, make_avatar_model(*avatar), textures, options);
}

}  // namespace auslan
