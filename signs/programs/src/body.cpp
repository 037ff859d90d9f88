// SPDX-License-Identifier: Apache-2.0
#include "body.h"

namespace auslan {

FigureTraits Body::traits() const {
  if (avatar == nullptr) return {};
  return {.face = avatar->face, .is_foreign = true};
}

Result<Stage> Body::stage(const StageOptions& options) const {
  if (avatar == nullptr) return Stage::build(*figure, options);
  return Stage::build(*figure, make_avatar_model(*avatar), textures, options);
}

}  // namespace auslan
