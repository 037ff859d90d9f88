// SPDX-License-Identifier: Apache-2.0
#include "body_solids.h"

#include "kinematics/rotation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
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

constexpr uint32_t kLeaf = 4;  // vertices of a ball that is not divided
constexpr size_t kDeepest = 64;
constexpr double kRounding = 1e-9;  // metres; far more than sums of doubles are off, far less than is measured

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

double squared_distance(const Vec3& low, const Vec3& high, const Vec3& point) {
  double sum = 0.0;
  for (glm::length_t i = 0; i < 3; ++i) {
    const double beyond = std::max({low[i] - point[i], point[i] - high[i], 0.0});
    sum += beyond * beyond;
  }
  return sum;
}

Transform a_from_b(const Transform& world_from_a, const Transform& world_from_b) {
  const Quat back = glm::conjugate(world_from_a.rotation);
  return {back * world_from_b.rotation, back * (world_from_b.position - world_from_a.position)};
}

}  // namespace

std::span<const std::pair<BodyGroup, BodyGroup>> BodySolids::pairs() {
  return kPairs;
}

BodySolids::BodySolids(const Figure& figure) {
  for (const Mesh& mesh : figure.segments) {
    if (mesh.indices.empty()) {
      parts_.emplace_back();
      continue;
    }
    Part part{Solid(mesh), {}, {}, 0.0};
    for (const glm::vec3& position : mesh.positions)
      part.vertices.emplace_back(position);
    // A place where texture seams meet counts once.
    const auto before = [](const Vec3& p, const Vec3& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); };
    std::stable_sort(part.vertices.begin(), part.vertices.end(), before);
    part.vertices.erase(std::unique(part.vertices.begin(), part.vertices.end()), part.vertices.end());
    const Vec3 extent = part.solid.high() - part.solid.low();
    part.thickness = 0.5 * std::min({extent.x, extent.y, extent.z});
    part.balls.push_back({Vec3(0.0), 0.0, 0, static_cast<uint32_t>(part.vertices.size()), 0});
    divide(part, 0);
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

void BodySolids::divide(Part& part, uint32_t index) {
  Ball ball = part.balls[index];
  const auto begin = part.vertices.begin() + ball.first;
  Vec3 low = *begin;
  Vec3 high = *begin;
  for (auto vertex = begin; vertex != begin + ball.count; ++vertex) {
    low = glm::min(low, *vertex);
    high = glm::max(high, *vertex);
  }
  ball.centre = 0.5 * (low + high);
  for (auto vertex = begin; vertex != begin + ball.count; ++vertex)
    ball.radius = std::max(ball.radius, length(*vertex - ball.centre));
  if (ball.count <= kLeaf) {
    part.balls[index] = ball;
    return;
  }
  const Vec3 extent = high - low;
  const glm::length_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  std::stable_sort(begin, begin + ball.count, [axis](const Vec3& p, const Vec3& q) { return p[axis] < q[axis]; });
  const uint32_t half = ball.count / 2;
  ball.below = static_cast<uint32_t>(part.balls.size());
  part.balls[index] = ball;
  part.balls.push_back({Vec3(0.0), 0.0, ball.first, half, 0});
  part.balls.push_back({Vec3(0.0), 0.0, ball.first + half, ball.count - half, 0});
  divide(part, ball.below);
  divide(part, ball.below + 1);
}

template <typename Found>
void BodySolids::each_inside(const Part& points, const Transform& solid_from_points, const Part& solid,
                             const Found& found) {
  const Vec3 low = solid.solid.low();
  const Vec3 high = solid.solid.high();
  double deepest = found(Vec3(0.0), 0.0);
  // A distance to a surface changes by no more than the way that a point goes: a ball whose centre lies d outside holds
  // nothing deeper than its radius less d.
  std::array<uint32_t, kDeepest> stack{};
  size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const Ball& ball = points.balls[stack[--waiting]];
    const Vec3 centre = apply(solid_from_points, ball.centre);
    if (squared_distance(low, high, centre) > ball.radius * ball.radius) continue;
    if (ball.below > 0) {
      const auto nearest = solid.solid.nearest(centre, std::max(ball.radius, solid.thickness));
      if (!nearest || ball.radius - nearest->distance + kRounding <= deepest) continue;
      stack[waiting++] = ball.below;
      stack[waiting++] = ball.below + 1;
      continue;
    }
    for (uint32_t i = ball.first; i < ball.first + ball.count; ++i) {
      const Vec3 p = apply(solid_from_points, points.vertices[i]);
      if (p.x < low.x || p.y < low.y || p.z < low.z || p.x > high.x || p.y > high.y || p.z > high.z) continue;
      const auto nearest = solid.solid.nearest(p, solid.thickness + kRounding);
      if (nearest && -nearest->distance > deepest) deepest = found(p, -nearest->distance);
    }
  }
}

double BodySolids::depth(const Part& points, const Transform& world_from_points, const Part& solid,
                         const Transform& world_from_solid, double floor) {
  struct Candidate {
    Vec3 point{0.0};
    double depth = 0.0;
  };
  const Transform solid_from_points = a_from_b(world_from_solid, world_from_points);
  Candidate deepest{Vec3(0.0), floor};
  each_inside(points, solid_from_points, solid, [&](const Vec3& point, double depth) {
    if (depth > deepest.depth) deepest = {point, depth};
    return deepest.depth;
  });
  if (deepest.depth <= floor || solid.solid.contains(deepest.point)) return deepest.depth;
  // It was told on the wrong side: the deepest of those that truly are inside.
  std::vector<Candidate> all;
  each_inside(points, solid_from_points, solid, [&](const Vec3& point, double depth) {
    if (depth > floor) all.push_back({point, depth});
    return floor;
  });
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.depth > b.depth; });
  for (const Candidate& candidate : all)
    if (solid.solid.contains(candidate.point)) return candidate.depth;
  return floor;
}

std::optional<Overlap> BodySolids::overlap(BodyGroup group_a, BodyGroup group_b, double floor,
                                           std::span<const Transform> world_from_node,
                                           std::span<const Transform> before) const {
  const auto stays = [&](int node) {
    if (before.empty()) return false;
    const Transform& now = world_from_node[static_cast<size_t>(node)];
    const Transform& was = before[static_cast<size_t>(node)];
    return now.position == was.position && now.rotation == was.rotation;
  };
  Overlap worst{group_a, group_b, kNoNode, kNoNode, floor};
  for (const int a : nodes_of(group_a)) {
    const Part& part_a = *parts_[static_cast<size_t>(a)];
    const Transform& place_a = world_from_node[static_cast<size_t>(a)];
    const Vec3 centre_a = apply(place_a, part_a.balls.front().centre);
    const bool a_stays = stays(a);
    for (const int b : nodes_of(group_b)) {
      if (a_stays && stays(b)) continue;
      const Part& part_b = *parts_[static_cast<size_t>(b)];
      const Transform& place_b = world_from_node[static_cast<size_t>(b)];
      const Vec3 apart = centre_a - apply(place_b, part_b.balls.front().centre);
      const double reach = part_a.balls.front().radius + part_b.balls.front().radius;
      if (glm::dot(apart, apart) > reach * reach) continue;
      const double deep = depth(part_b, place_b, part_a, place_a, depth(part_a, place_a, part_b, place_b, worst.depth));
      if (deep > worst.depth) worst = {group_a, group_b, a, b, deep};
    }
  }
  if (worst.node_a == kNoNode) return std::nullopt;
  return worst;
}

std::vector<Overlap> BodySolids::overlaps(std::span<const Transform> world_from_node) const {
  std::vector<Overlap> found;
  for (const auto& [a, b] : kPairs)
    if (const auto worst = overlap(a, b, 0.0, world_from_node)) found.push_back(*worst);
  return found;
}

bool BodySolids::may_cross(BodyGroup group, const Vec3& from, const Vec3& to,
                           std::span<const Transform> world_from_node) const {
  const Vec3 way = to - from;
  for (const int node : nodes_of(group)) {
    const Ball& ball = parts_[static_cast<size_t>(node)]->balls.front();
    const Vec3 centre = apply(world_from_node[static_cast<size_t>(node)], ball.centre) - from;
    const double along = std::clamp(glm::dot(centre, way) / glm::dot(way, way), 0.0, 1.0);
    if (length(centre - way * along) <= ball.radius + kRounding) return true;
  }
  return false;
}

std::optional<NearestSkin> BodySolids::nearest(BodyGroup group, const Vec3& point, double within,
                                               std::span<const Transform> world_from_node) const {
  std::optional<NearestSkin> least;
  for (const int node : nodes_of(group)) {
    const Transform& place = world_from_node[static_cast<size_t>(node)];
    const Vec3 local = glm::conjugate(place.rotation) * (point - place.position);
    const auto nearest = parts_[static_cast<size_t>(node)]->solid.nearest(local, within);
    if (nearest && (!least || nearest->distance < least->surface.distance)) least = NearestSkin{node, *nearest};
  }
  if (!least) return std::nullopt;
  const Transform& place = world_from_node[static_cast<size_t>(least->node)];
  least->surface.position = apply(place, least->surface.position);
  least->surface.normal = place.rotation * least->surface.normal;
  return least;
}

std::optional<double> BodySolids::distance(BodyGroup group, const Vec3& point, double within,
                                           std::span<const Transform> world_from_node) const {
  const auto found = nearest(group, point, within, world_from_node);
  return found ? std::optional(found->surface.distance) : std::nullopt;
}

}  // namespace auslan
