// SPDX-License-Identifier: Apache-2.0
// The shadow that hands and forearms throw on the body, the face and the other arm: it tells how far before the chest
// they are.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/body_model.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace auslan {

/// Arms are capsules; a vertex is darkened by how much of them stands between it and the light, softer the farther away
/// they are. Only + - * / and sqrt of floats. Allocates in the first frame only.
class ArmShadow {
 public:
  /// `towards_light`: world space, any length but 0.
  ArmShadow(const Skeleton& skeleton, const glm::vec3& towards_light);

  /// The meshes of a frame, those that the shadow falls on with colours (and revisions) of their own. The spans are
  /// valid until the next call.
  std::span<const PosedMesh> cast(std::span<const Transform> world_from_node, std::span<const PosedMesh> meshes);

 private:
  /// Metres. Every point less than `radius` away from the line from a to b.
  struct Capsule {
    glm::vec3 a, b;
    float radius;
    bool operator==(const Capsule&) const = default;
  };
  static constexpr size_t kCapsules = 12;  ///< of an arm: forearm, palm, two of each digit
  using Arm = std::array<Capsule, kCapsules>;

  struct Receiver {
    std::array<bool, 2> from{};
    std::array<Arm, 2> applied{};
    uint64_t applied_revision = 0;
    std::vector<uint8_t> shade;  ///< of each vertex, 255 is none
    std::vector<glm::u8vec4> colours;
    uint64_t revision = 0;
  };

  Arm arm_in(const glm::mat4& world_from_mesh, std::span<const Transform> world_from_node, size_t side) const;
  static bool darken(Receiver& receiver, const PosedMesh& mesh, const glm::vec3& light);

  glm::vec3 light_;
  std::array<ArmNodes, 2> nodes_;
  std::array<std::array<float, kCapsules>, 2> radii_{};
  std::vector<std::array<bool, 2>> from_;  ///< one a node: which arms' shadows fall on it
  std::vector<Receiver> receivers_;        ///< one a mesh of a frame
  std::vector<PosedMesh> meshes_;
};

}  // namespace auslan
