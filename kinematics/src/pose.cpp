// SPDX-License-Identifier: Apache-2.0
#include "kinematics/pose.h"

#include <cassert>

namespace auslan {

Pose rest_pose(const Skeleton& skeleton) {
  Pose pose;
  pose.rotation.assign(static_cast<size_t>(skeleton.size()), kIdentity);
  return pose;
}

void forward(const Skeleton& skeleton, const Pose& pose, std::span<Transform> world_from_node) {
  const auto nodes = skeleton.nodes();
  assert(pose.rotation.size() == nodes.size() && world_from_node.size() == nodes.size());
  for (size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    if (node.parent == kNoNode) {
      world_from_node[i] = {pose.rotation[i], node.offset + pose.root_translation};
      continue;
    }
    const Transform& parent = world_from_node[static_cast<size_t>(node.parent)];
    world_from_node[i] = {parent.rotation * pose.rotation[i], apply(parent, node.offset)};
  }
}

}  // namespace auslan
