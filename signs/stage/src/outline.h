// SPDX-License-Identifier: Apache-2.0
// A dark line round every part of the body, so that a finger before a palm and a hand before a face keep their edges
// where colours and light are alike.
#pragma once

#include "kinematics/body_model.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace auslan {

/// Inverted hulls: each mesh once more, a little larger, dark and turned inside out, so that only what lies behind the
/// mesh itself is seen, and of that only the rim. Allocates in the first frame only.
class Outline {
 public:
  /// `width`: metres by which the hull is larger.
  explicit Outline(float width) : width_(width) {}

  /// The hulls of the meshes of a frame. The spans are valid until the next call.
  std::span<const PosedMesh> around(std::span<const PosedMesh> meshes);

 private:
  struct Hull {
    uint64_t revision = 0;  ///< of the mesh that it is the hull of; 0: none yet
    std::vector<glm::vec3> positions;
    std::vector<glm::u8vec4> colours;
    std::vector<uint32_t> indices;
  };

  float width_;
  std::vector<Hull> hulls_;
  std::vector<PosedMesh> meshes_;
};

}  // namespace auslan
