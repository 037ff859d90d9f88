// SPDX-License-Identifier: Apache-2.0
#include "body_solids.h"

#include "kinematics/rotation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace auslan {
namespace {

/// Pairs that can be apart. An arm is joined to the trunk at its shoulder, the hand to its forearm.
constexpr std::pair<BodyGroup, BodyGroup> kPairs[] = {
    {BodyGroup::kLeftHand, BodyGroup::kRightHand},
    {BodyGroup::kLeftHand, BodyGroup::kHead},
    {BodyGroup::kRightHand, BodyGroup::kHead},
    {BodyGroup::kLeftHand, BodyGroup::kTrunk},
    {BodyGroup::kRightHand, BodyGroup::kTrunk},
    {BodyGroup::kLeftHand, BodyGroup::kRightForearm},
    {BodyGroup::kRightHand, BodyGroup::kLeftForearm},
    {BodyGroup::kLeftHand, BodyGroup::kRightUpperArm},
    {BodyGroup::kRightHand, BodyGroup::kLeftUpperArm},
    {BodyGroup::kLeftHand, BodyGroup::kLeftUpperArm},
    {BodyGroup::kRightHand, BodyGroup::kRightUpperArm},
    {BodyGroup::kLeftForearm, BodyGroup::kHead},
    {BodyGroup::kRightForearm, BodyGroup::kHead},
    {BodyGroup::kLeftForearm, BodyGroup::kTrunk},
    {BodyGroup::kRightForearm, BodyGroup::kTrunk},
    {BodyGroup::kLeftForearm, BodyGroup::kRightForearm},
    {BodyGroup::kLeftForearm, BodyGroup::kRightUpperArm},
    {BodyGroup::kRightForearm, BodyGroup::kLeftUpperArm},
};

Transform a_from_b(const Transform& world_from_a, const Transform& world_from_b) {
  const Quat back = glm::conjugate(world_from_a.rotation);
  return {back * world_from_b.rotation, back * (world_from_b.position - world_from_a.position)};
}

}  // namespace

BodySolids::BodySolids(const Figure& figure) {
  for (const Mesh& mesh : figure.segments) {
    if (mesh.indices.empty()) {
      parts_.emplace_back();
      continue;
    }
    Part part{Solid(mesh), {}, Vec3(0.0), 0.0};
    for (const glm::vec3& position : mesh.positions)
      part.vertices.emplace_back(position);
    part.centre = 0.5 * (part.solid.low() + part.solid.high());
    for (const Vec3& vertex : part.vertices)
      part.radius = std::max(part.radius, std::sqrt(glm::dot(vertex - part.centre, vertex - part.centre)));
    parts_.push_back(std::move(part));
  }
  const Skeleton& skeleton = figure.skeleton;
  const auto put = [&](BodyGroup group, int node) {
    if (parts_[static_cast<size_t>(node)]) nodes_[static_cast<size_t>(group)].push_back(node);
  };
  put(BodyGroup::kHead, skeleton.find("head_base"));
  put(BodyGroup::kHead, skeleton.find("neck_base"));
  put(BodyGroup::kTrunk, skeleton.find("spine_base"));
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const bool left = side == Side::kLeft;
    const ArmNodes arm = arm_nodes(skeleton, side);
    put(left ? BodyGroup::kLeftUpperArm : BodyGroup::kRightUpperArm, arm.shoulder);
    put(left ? BodyGroup::kLeftForearm : BodyGroup::kRightForearm, arm.elbow);
    const BodyGroup hand = left ? BodyGroup::kLeftHand : BodyGroup::kRightHand;
    put(hand, arm.wrist);
    for (const auto& digit : arm.digits)
      for (const int node : digit)
        put(hand, node);
  }
}

double BodySolids::depth(const Part& points, const Transform& world_from_points, const Part& solid,
                         const Transform& world_from_solid) const {
  const Transform solid_from_points = a_from_b(world_from_solid, world_from_points);
  const Vec3 low = solid.solid.low();
  const Vec3 high = solid.solid.high();
  double deepest = 0.0;
  for (const Vec3& vertex : points.vertices) {
    const Vec3 p = apply(solid_from_points, vertex);
    if (p.x < low.x || p.y < low.y || p.z < low.z || p.x > high.x || p.y > high.y || p.z > high.z) continue;
    const auto nearest = solid.solid.nearest(p, 2.0 * solid.radius);
    if (nearest) deepest = std::max(deepest, -nearest->distance);
  }
  return deepest;
}

std::vector<Overlap> BodySolids::overlaps(std::span<const Transform> world_from_node) const {
  std::vector<Overlap> found;
  const auto centre = [&](int node) {
    return apply(world_from_node[static_cast<size_t>(node)], parts_[static_cast<size_t>(node)]->centre);
  };
  for (const auto& [group_a, group_b] : kPairs) {
    Overlap worst{group_a, group_b, kNoNode, kNoNode, 0.0};
    for (const int a : nodes_of(group_a)) {
      const Part& part_a = *parts_[static_cast<size_t>(a)];
      for (const int b : nodes_of(group_b)) {
        const Part& part_b = *parts_[static_cast<size_t>(b)];
        const Vec3 apart = centre(a) - centre(b);
        const double reach = part_a.radius + part_b.radius;
        if (glm::dot(apart, apart) > reach * reach) continue;
        const Transform& place_a = world_from_node[static_cast<size_t>(a)];
        const Transform& place_b = world_from_node[static_cast<size_t>(b)];
        const double deep = std::max(depth(part_a, place_a, part_b, place_b), depth(part_b, place_b, part_a, place_a));
        if (deep > worst.depth) worst = {group_a, group_b, a, b, deep};
      }
    }
    if (worst.depth > 0.0) found.push_back(worst);
  }
  return found;
}

std::optional<double> BodySolids::distance(BodyGroup group, const Vec3& point, double within,
                                           std::span<const Transform> world_from_node) const {
  std::optional<double> least;
  for (const int node : nodes_of(group)) {
    const Transform& place = world_from_node[static_cast<size_t>(node)];
    const Vec3 local = glm::conjugate(place.rotation) * (point - place.position);
    const auto nearest = parts_[static_cast<size_t>(node)]->solid.nearest(local, within);
    if (nearest && (!least || nearest->distance < *least)) least = nearest->distance;
  }
  return least;
}

}  // namespace auslan
