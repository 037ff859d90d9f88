// SPDX-License-Identifier: Apache-2.0
#include "kinematics/skeleton.h"

#include <cmath>

namespace auslan {

Result<Skeleton> Skeleton::build(std::vector<Node> nodes) {
  if (nodes.empty()) return fail(ErrorCode::kMalformed, "the skeleton has no nodes");
  Skeleton skeleton;
  skeleton.rest_.reserve(nodes.size());
  for (size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    const std::string place = "node " + std::to_string(i) + " (" + node.name + ")";
    if (!std::isfinite(node.offset.x) || !std::isfinite(node.offset.y) || !std::isfinite(node.offset.z))
      return fail(ErrorCode::kMalformed, "the node's position is not a finite number", place);
    if (i == 0 ? node.parent != kNoNode : (node.parent < 0 || static_cast<size_t>(node.parent) >= i))
      return fail(ErrorCode::kMalformed, "a parent must stand before its children, and only the first node is a root",
                  place);
    for (size_t j = 0; j < i; ++j)
      if (nodes[j].name == node.name) return fail(ErrorCode::kMalformed, "two nodes have this name", place);
    skeleton.rest_.push_back(node.parent == kNoNode ? node.offset
                                                    : skeleton.rest_[static_cast<size_t>(node.parent)] + node.offset);
  }
  skeleton.nodes_ = std::move(nodes);
  for (size_t i = 0; i < kNodeNames.size(); ++i) {
    skeleton.named_[i] = skeleton.find(kNodeNames[i]);
    if (skeleton.named_[i] == kNoNode)
      return fail(ErrorCode::kMalformed, "the figure lacks the node " + std::string(kNodeNames[i]));
  }
  return skeleton;
}

int Skeleton::find(std::string_view name) const {
  for (size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].name == name) return static_cast<int>(i);
  return kNoNode;
}

}  // namespace auslan
