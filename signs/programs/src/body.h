// SPDX-License-Identifier: Apache-2.0
// What signs, and how it is drawn.
#pragma once

#include "kinematics/avatar_model.h"
#include "kinematics/figure.h"
#include "kinematics/result.h"
#include "stage/stage.h"
#include "synthesis/signer.h"

namespace auslan {

/// The built-in figure, one that was baked, or a foreign avatar.
struct Body {
  const Figure* figure = nullptr;
  const SigningAvatar* avatar = nullptr;  ///< null: the figure's own segments are drawn
  Textures textures = {};                 ///< the avatar's images

  /// What its signer has to know.
  FigureTraits traits() const;
  /// A stage of this body, which outlives it.
  Result<Stage> stage(const StageOptions& options) const;
};

}  // namespace auslan
