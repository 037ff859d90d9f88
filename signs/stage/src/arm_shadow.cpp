// SPDX-License-Identifier: Apache-2.0
#include "arm_shadow.h"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

namespace auslan {
namespace {

// What the middle of a shadow takes of a colour's sRGB levels where the surface faces the light: without the key light
// 0.4 of the light is left, which is 0.66 of the level.
constexpr float kDarkest = 0.34F;
// Half the width of the soft edge: at the arm itself, and what it grows by with the distance from it.
constexpr float kSoftness = 0.007F;
constexpr float kSoftening = 0.10F;
// What is nearer than this is the surface that the arm lies on.
constexpr float kNearest = 0.006F;

glm::vec3 into(const glm::mat4& world_from_mesh, const Vec3& place) {
  const glm::vec3 d = glm::vec3(place) - glm::vec3(world_from_mesh[3]);
  return {glm::dot(d, glm::vec3(world_from_mesh[0])), glm::dot(d, glm::vec3(world_from_mesh[1])),
          glm::dot(d, glm::vec3(world_from_mesh[2]))};
}

float clamp01(float x) {
  return x < 0.0F ? 0.0F : x > 1.0F ? 1.0F : x;
}

/// How much of the light that comes from `light` (unit) to a point a capsule takes, 0 to 1.
float taken(const glm::vec3& point, const glm::vec3& light, const glm::vec3& a, const glm::vec3& b, float radius) {
  // The places of the ray and of the capsule's axis that are nearest to each other.
  const glm::vec3 axis = b - a;
  const glm::vec3 from = a - point;
  const float along = glm::dot(axis, light);
  const float length2 = glm::dot(axis, axis);
  const float across2 = length2 - along * along;
  const float up = glm::dot(from, light);
  const float u = across2 > 1e-9F ? clamp01((along * up - glm::dot(axis, from)) / across2) : 0.0F;
  const glm::vec3 nearest = from + axis * u;
  const float t = glm::dot(nearest, light);
  if (t < kNearest) return 0.0F;
  const glm::vec3 beside = nearest - light * t;
  const float distance = std::sqrt(glm::dot(beside, beside)) - radius;
  const float soft = kSoftness + kSoftening * t;
  const float x = clamp01(0.5F - distance / (2.0F * soft));
  return x * x * (3.0F - 2.0F * x) * clamp01((t - kNearest) / 0.02F);
}

uint8_t scaled(uint8_t level, uint32_t shade) {
  return static_cast<uint8_t>((level * shade + 127U) / 255U);
}

}  // namespace

ArmShadow::ArmShadow(const Skeleton& skeleton, const glm::vec3& towards_light)
    : light_(glm::normalize(towards_light)),
      nodes_{arm_nodes(skeleton, Side::kLeft), arm_nodes(skeleton, Side::kRight)},
      from_(static_cast<size_t>(skeleton.size())) {
  const auto receive = [&](int node, bool left, bool right) { from_[static_cast<size_t>(node)] = {left, right}; };
  for (const char* name : {"spine_base", "neck_base", "head_base"})
    receive(skeleton.find(name), true, true);
  receive(nodes_[0].shoulder, false, true);
  receive(nodes_[0].elbow, false, true);
  receive(nodes_[1].shoulder, true, false);
  receive(nodes_[1].elbow, true, false);
  for (size_t side = 0; side < 2; ++side) {
    const auto bone = [&](int node) {
      const Vec3& offset = skeleton.node(node).offset;
      return static_cast<float>(std::sqrt(glm::dot(offset, offset)));
    };
    // Shares of the bones of a person of average build.
    const float forearm = bone(nodes_[side].wrist);
    radii_[side] = {0.13F * forearm, 0.13F * forearm};
    for (size_t digit = 0; digit < 5; ++digit) {
      const float radius = (digit == 0 ? 0.24F : 0.20F) * bone(nodes_[side].digits[digit][1]);
      radii_[side][2 + 2 * digit] = radii_[side][3 + 2 * digit] = radius;
    }
  }
}

ArmShadow::Arm ArmShadow::arm_in(const glm::mat4& world_from_mesh, std::span<const Transform> world_from_node,
                                 size_t side) const {
  const ArmNodes& nodes = nodes_[side];
  const auto at = [&](int node) { return into(world_from_mesh, world_from_node[static_cast<size_t>(node)].position); };
  const glm::vec3 wrist = at(nodes.wrist);
  Arm arm{};
  arm[0] = {at(nodes.elbow), wrist, radii_[side][0]};
  arm[1] = {wrist, at(nodes.digits[2][0]), radii_[side][1]};
  for (size_t digit = 0; digit < 5; ++digit) {
    const glm::vec3 middle = at(nodes.digits[digit][1]);
    const glm::vec3 last = at(nodes.digits[digit][2]);
    const float radius = radii_[side][2 + 2 * digit];
    arm[2 + 2 * digit] = {at(nodes.digits[digit][0]), middle, radius};
    // The tip is about as far behind the last joint as that behind the one before.
    arm[3 + 2 * digit] = {middle, last + (last - middle) * 0.8F, radius};
  }
  return arm;
}

// Sets the shade of every vertex; whether any is another than before.
bool ArmShadow::darken(Receiver& receiver, const PosedMesh& mesh, const glm::vec3& light) {
  // The hand and the forearm within balls, for most vertices are far from both lines to the light.
  struct Ball {
    glm::vec3 centre;
    float radius;
    size_t first, last;
  };
  std::array<std::array<Ball, 2>, 2> balls{};
  for (size_t side = 0; side < 2; ++side) {
    const Arm& arm = receiver.applied[side];
    const glm::vec3 middle = (arm[0].a + arm[0].b) * 0.5F;
    const glm::vec3 half = arm[0].b - middle;
    balls[side][0] = {middle, std::sqrt(glm::dot(half, half)) + arm[0].radius, 0, 1};
    const glm::vec3 palm = arm[1].b;
    float reach = 0.0F;
    for (size_t i = 1; i < kCapsules; ++i) {
      for (const glm::vec3& end : {arm[i].a, arm[i].b})
        reach = std::max(reach, glm::dot(end - palm, end - palm));
    }
    balls[side][1] = {palm, std::sqrt(reach) + arm[1].radius, 1, kCapsules};
  }
  bool changed = false;
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3 point = mesh.positions[i];
    const float facing = glm::dot(mesh.normals[i], light);
    float dark = 0.0F;
    for (size_t side = 0; side < 2 && facing > 0.0F; ++side) {
      if (!receiver.from[side]) continue;
      for (const Ball& ball : balls[side]) {
        const glm::vec3 to = ball.centre - point;
        const float t = glm::dot(to, light);
        const float room = ball.radius + kSoftness + kSoftening * (t + ball.radius);
        if (t < -ball.radius || glm::dot(to, to) - t * t > room * room) continue;
        for (size_t c = ball.first; c < ball.last; ++c) {
          const Capsule& capsule = receiver.applied[side][c];
          dark = std::max(dark, taken(point, light, capsule.a, capsule.b, capsule.radius));
        }
      }
    }
    const float shade = 255.0F * (1.0F - kDarkest * dark * clamp01(facing * 1.5F)) + 0.5F;
    const auto level = static_cast<uint8_t>(shade);
    changed = changed || level != receiver.shade[i];
    receiver.shade[i] = level;
  }
  return changed;
}

std::span<const PosedMesh> ArmShadow::cast(std::span<const Transform> world_from_node,
                                           std::span<const PosedMesh> meshes) {
  meshes_.assign(meshes.begin(), meshes.end());
  receivers_.resize(meshes_.size());
  for (size_t m = 0; m < meshes_.size(); ++m) {
    PosedMesh& mesh = meshes_[m];
    Receiver& receiver = receivers_[m];
    receiver.from = from_[static_cast<size_t>(mesh.node)];
    if (!receiver.from[0] && !receiver.from[1]) continue;
    if (receiver.revision == 0) {
      receiver.shade.assign(mesh.positions.size(), 255);
      receiver.colours.assign(mesh.colours.begin(), mesh.colours.end());
    }
    const std::array<Arm, 2> arms = {arm_in(mesh.world_from_mesh, world_from_node, 0),
                                     arm_in(mesh.world_from_mesh, world_from_node, 1)};
    const bool same_surface = receiver.applied_revision == mesh.revision;
    if (!same_surface || arms != receiver.applied) {
      receiver.applied = arms;
      receiver.applied_revision = mesh.revision;
      const glm::mat3 turn(mesh.world_from_mesh);
      const glm::vec3 light(glm::dot(light_, turn[0]), glm::dot(light_, turn[1]), glm::dot(light_, turn[2]));
      const bool changed = darken(receiver, mesh, light);
      if (changed) {
        for (size_t i = 0; i < receiver.colours.size(); ++i) {
          const glm::u8vec4& colour = mesh.colours[i];
          const uint32_t shade = receiver.shade[i];
          receiver.colours[i] = {scaled(colour.x, shade), scaled(colour.y, shade), scaled(colour.z, shade), colour.w};
        }
      }
      if (changed || !same_surface) ++receiver.revision;
    }
    mesh.colours = receiver.colours;
    mesh.revision = receiver.revision;
  }
  return meshes_;
}

}  // namespace auslan
