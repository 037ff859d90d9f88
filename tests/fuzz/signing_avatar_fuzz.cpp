// SPDX-License-Identifier: Apache-2.0
// Bytes as changes to a humanoid that signs: bones moved, turned, scaled, without a part or with another's.
#include "box_avatar.h"
#include "kinematics/avatar_model.h"
#include "kinematics/avatar_pose.h"
#include "kinematics/signing_avatar.h"
#include "synthesis/signer.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace auslan {
namespace {

/// Whether the reader would have let it pass: nothing at rest beyond its bounds.
bool is_within_bounds(const Avatar& avatar) {
  AvatarPoser poser(avatar);
  poser.pose(rest_pose(avatar));
  for (const glm::dmat4& world : poser.world_from_node())
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r)
        if (!(std::fabs(world[c][r]) <= kMaxAvatarExtent)) return false;
  return true;
}

void change(Avatar& avatar, const uint8_t* bytes) {
  AvatarNode& node = avatar.nodes[bytes[1] % avatar.nodes.size()];
  const auto number = [&](size_t i) { return (static_cast<double>(bytes[i]) - 128.0) / 64.0; };
  switch (bytes[0] % 6) {
    case 0:
      node.translation = Vec3(number(2), number(3), number(4));
      break;
    case 1:
      node.rotation = renormalised(Quat(number(2), number(3), number(4), number(5)));
      break;
    case 2:
      node.scale = Vec3(number(2), number(3), number(4));
      break;
    case 3:
      node.translation *= std::ldexp(1.0, bytes[2] % 40 - 20);
      break;
    case 4:
      avatar.human_node[bytes[2] % kHumanRoleCount] = kNoNode;
      break;
    default:
      avatar.human_node[bytes[2] % kHumanRoleCount] = static_cast<int>(bytes[1] % avatar.nodes.size());
      break;
  }
}

void sign(const Avatar& avatar) {
  const auto fitted = fit_avatar(avatar);
  if (!fitted) {
    if (fitted.error().message.empty()) std::abort();
    return;
  }
  const Skeleton& skeleton = fitted->figure.skeleton;
  if (const auto signer = Signer::build(fitted->figure, {.face = fitted->face})) {
    const HandState touching =
        signer->place({.handshape = "", .location = Location::kChin, .contact = Contact{}}, {}, Side::kRight, {}).state;
    if (!std::isfinite(touching.wrist.position.y)) std::abort();
  }
  std::vector<Transform> world(static_cast<size_t>(skeleton.size()));
  Pose pose = rest_pose(skeleton);
  for (Quat& rotation : pose.rotation)
    rotation = Quat(0.8, 0.0, 0.6, 0.0);
  pose.face.fill(1.0F);
  forward(skeleton, pose, world);
  for (const Transform& node : world)
    if (!std::isfinite(node.position.x) || !std::isfinite(node.position.y) || !std::isfinite(node.position.z))
      std::abort();
  const auto model = make_avatar_model(*fitted);
  for (const PosedMesh& mesh : model->pose(world, pose.face)) {
    if (mesh.node < 0 || mesh.node >= skeleton.size() || mesh.colours.size() != mesh.positions.size()) std::abort();
    for (const uint32_t index : mesh.indices)
      if (index >= mesh.positions.size()) std::abort();
  }
}

}  // namespace
}  // namespace auslan

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  auslan::Avatar avatar = auslan::test::box_avatar();
  constexpr size_t kStep = 6, kMostSteps = 50;
  for (size_t step = 0; step < kMostSteps && (step + 1) * kStep <= size; ++step)
    auslan::change(avatar, data + step * kStep);
  if (auslan::is_within_bounds(avatar)) auslan::sign(avatar);
  return 0;
}
