// SPDX-License-Identifier: Apache-2.0
// The signer's surfaces: what a hand and its arm may come near to, the points that are tried, and how deep they lie.
#include "hand_fit.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
#include "synthesis/signer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace auslan {
namespace {

Transform composed(const Transform& a_from_b, const Transform& b_from_c) {
  return {a_from_b.rotation * b_from_c.rotation, apply(a_from_b, b_from_c.position)};
}

}  // namespace

std::vector<Obstacle> Signer::body_obstacles(bool touches) const {
  std::vector<Obstacle> obstacles;
  const Skeleton& skeleton = figure_->skeleton;
  for (const char* name : {"spine_base", "neck_base", "head_base"}) {
    const int node = skeleton.find(name);
    if (const DistanceField* field = surface_.field(node))
      obstacles.push_back(make_obstacle(*field, {kIdentity, skeleton.rest_position(node)},
                                        -(touches ? kTouchesWithin : kKeepsOff), touches));
  }
  return obstacles;
}

void Signer::add_other_arm(Side other_side, const HandState& other, bool touches,
                           std::vector<Obstacle>& obstacles) const {
  const ArmNodes& nodes = nodes_[static_cast<size_t>(other_side)];
  const ArmPlacement arm = place_arm(other_side, other);
  const double allowed = -(touches ? kTouchesWithin : kKeepsOff);
  const auto add = [&](int node, const Transform& place) {
    if (const DistanceField* field = surface_.field(node))
      obstacles.push_back(make_obstacle(*field, place, allowed, touches));
  };
  add(nodes.shoulder, arm.shoulder);
  add(nodes.elbow, arm.elbow);
  std::ranges::move(hand_obstacles(other_side, other.wrist, other.angles, allowed, touches),
                    std::back_inserter(obstacles));
}

std::vector<Obstacle> Signer::hand_obstacles(Side side, const Transform& wrist, const HandAngles& angles,
                                             double allowed, bool touches) const {
  const ArmNodes& nodes = nodes_[static_cast<size_t>(side)];
  std::vector<Obstacle> obstacles;
  const auto add = [&](int node, const Transform& place) {
    if (const DistanceField* field = surface_.field(node))
      obstacles.push_back(make_obstacle(*field, place, allowed, touches));
  };
  add(nodes.wrist, wrist);
  const auto digits = hand(side).digits(angles);
  for (size_t d = 0; d < 5; ++d)
    for (size_t j = 0; j < 3; ++j)
      add(nodes.digits[d][j], composed(wrist, digits[d][j]));
  return obstacles;
}

void Signer::add_forearm(Side side, const HandState& state, std::vector<Obstacle>& obstacles) const {
  if (const DistanceField* field = surface_.field(nodes_[static_cast<size_t>(side)].elbow))
    obstacles.push_back(make_obstacle(*field, place_arm(side, state).elbow, -kKeepsOff, false));
}

std::vector<SurfacePatch> Signer::hand_patches(Side side, const HandAngles& angles) const {
  const ArmNodes& nodes = nodes_[static_cast<size_t>(side)];
  std::vector<SurfacePatch> patches = {surface_.patch(nodes.wrist)};
  const auto digits = hand(side).digits(angles);
  for (size_t d = 0; d < 5; ++d)
    for (size_t j = 0; j < 3; ++j)
      patches.push_back(placed(surface_.patch(nodes.digits[d][j]), digits[d][j]));
  return patches;
}

std::array<PlacedPatch, 2> Signer::arm_patches(Side side, const HandState& state) const {
  const ArmPlacement arm = place_arm(side, state);
  return {PlacedPatch{&surface_.patch(nodes_[static_cast<size_t>(side)].elbow), arm.elbow},
          PlacedPatch{&lower_upper_arm_[static_cast<size_t>(side)], arm.shoulder}};
}

std::array<PlacedPatch, 16> Signer::hand_points(Side side, const HandState& state) const {
  const ArmNodes& nodes = nodes_[static_cast<size_t>(side)];
  std::array<PlacedPatch, 16> patches;
  patches[0] = {&surface_.coarse_patch(nodes.wrist), state.wrist};
  const auto digits = hand(side).digits(state.angles);
  for (size_t d = 0; d < 5; ++d)
    for (size_t j = 0; j < 3; ++j)
      patches[1 + 3 * d + j] = {&surface_.coarse_patch(nodes.digits[d][j]), composed(state.wrist, digits[d][j])};
  return patches;
}

Depth Signer::coarse_depth(Side side, const HandState& state, std::span<const Obstacle> obstacles,
                           double at_least) const {
  std::array<PlacedPatch, 17> patches;
  patches[0] = arm_patches(side, state)[0];
  std::ranges::copy(hand_points(side, state), patches.begin() + 1);
  return depth_in(patches, obstacles, {at_least});
}

Depth Signer::depth_in_body(Side side, const HandState& state, double at_least) const {
  return coarse_depth(side, state, body_obstacles(false), at_least);
}

Depth Signer::depth_in_arm(Side side, const HandState& state, const HandState& other_arm, double at_least) const {
  // Hands that are an arm's length apart do not meet.
  constexpr double kApart = 0.5;
  const Vec3 apart = state.wrist.position - other_arm.wrist.position;
  if (glm::dot(apart, apart) > kApart * kApart) return {};
  std::vector<Obstacle> obstacles;
  add_other_arm(other(side), other_arm, false, obstacles);
  const Depth in_other = coarse_depth(side, state, obstacles, at_least);
  // Fingers are too small to be met by the few points of a forearm or a palm: theirs are looked for in these.
  std::vector<Obstacle> own = hand_obstacles(side, state.wrist, state.angles, -kKeepsOff, false);
  add_forearm(side, state, own);
  Depth of_other = depth_in(hand_points(other(side), other_arm), own, {std::max(at_least, in_other.metres)});
  if (of_other.metres <= in_other.metres) return in_other;
  of_other.out = -of_other.out;
  return of_other;
}

double Signer::trouble(Side side, const Wish& wish, bool touches, std::span<const Obstacle> of_arm,
                       const HandState& state, const HandFit& fit) const {
  // Millimetres and degrees within what `auslanjam check` allows.
  constexpr double kUnseenLength = 0.0025, kUnseenLean = 21.0 * kDegree, kUnseenTurn = 4.0 * kDegree;
  HandState trial = state;
  trial.wrist = fit.wrist;
  trial.swivel = fit.swivel;
  // Near a joint's limit the arm is eased into it. A hand in the air stays where that leaves it.
  const ArmPlacement eased = place_arm(side, trial, true);
  const PlacedPatch forearm{&surface_.patch(nodes_[static_cast<size_t>(side)].elbow), eased.elbow};
  double off = 0.0, turned = 0.0;
  Quat shown = eased.wrist.rotation;
  if (touches) {
    const Vec3 slip = apply(eased.wrist, fit.touching) - apply(fit.wrist, fit.touching);
    off = std::abs(fit.gap) + std::sqrt(glm::dot(slip, slip));
    turned = angle_between(eased.wrist.rotation, fit.wrist.rotation);
    shown = fit.wrist.rotation;
  }
  double lean = 0.0;
  for (const Vec3& axis : {hand_frame(side).fingers, hand_frame(side).palm})
    lean = std::max(lean, arc_cosine(glm::dot(shown * axis, wish.rotation * axis)));
  // Two hands that meet in the middle are apart, or in each other, by twice as much.
  const double times = wish.mirrored_at != 0.0 ? 2.0 : 1.0;
  const double deepest = std::max(times * fit.deepest, depth_in({&forearm, 1}, of_arm).metres);
  return std::max({deepest / kUnseenLength, times * off / kUnseenLength, lean / kUnseenLean, turned / kUnseenTurn});
}

Depth Signer::forearm_depth(Side side, const HandState& state, double at_least, double enough) const {
  return depth_in(arm_patches(side, state), body_obstacles(false), {at_least, enough});
}

}  // namespace auslan
