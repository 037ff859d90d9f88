// SPDX-License-Identifier: Apache-2.0
// Bytes as a figure of another maker, .gltf or .glb.
#include "avatar_promises.h"
#include "glb_of_bytes.h"
#include "gltf/avatar_gltf.h"
#include "kinematics/avatar_model.h"
#include "kinematics/signing_avatar.h"

#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

namespace {

/// What can be fitted can be posed.
void sign(const auslan::Avatar& avatar) {
  const auto fitted = auslan::fit_avatar(avatar);
  if (!fitted) {
    if (fitted.error().message.empty()) std::abort();
    return;
  }
  const auslan::Skeleton& skeleton = fitted->figure.skeleton;
  std::vector<auslan::Transform> world(static_cast<size_t>(skeleton.size()));
  auslan::Pose pose = auslan::rest_pose(skeleton);
  for (auslan::Quat& rotation : pose.rotation)
    rotation = auslan::Quat(0.8, 0.0, 0.6, 0.0);
  pose.face.fill(1.0F);
  auslan::forward(skeleton, pose, world);
  const auto model = auslan::make_avatar_model(*fitted);
  for (const auslan::PosedMesh& mesh : model->pose(world, pose.face))
    for (const uint32_t index : mesh.indices)
      if (index >= mesh.positions.size() || mesh.colours.size() != mesh.positions.size()) std::abort();
}

void read_and_sign(const std::string& bytes) {
  const auto avatar = auslan::parse_avatar(std::as_bytes(std::span(bytes)), "/nonexistent");
  if (avatar ? !auslan::test::broken_promise(*avatar).empty() : avatar.error().message.empty()) std::abort();
  if (avatar) sign(*avatar);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  auslan::read_both_ways(data, size, read_and_sign);
  return 0;
}
