// SPDX-License-Identifier: Apache-2.0
// The kinematic tree: an immutable depth-first array in which every parent stands before its children.
//
// Rest pose: a T-pose (arms along +-X, palms down, fingers straight) in which every node's frame is parallel to the
// world frame. A joint rotation is therefore always "how far from rest, in world axes at rest", for any figure that was
// loaded.
#pragma once

#include "kinematics/result.h"
#include "kinematics/vector.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

inline constexpr int kNoNode = -1;

/// The 39 nodes that every figure has, depth-first (design contract). A figure may hold more.
inline constexpr std::array<std::string_view, 39> kNodeNames = {"spine_base",  "neck_base",    "head_base",     //
                                                                "shoulder_l",  "elbow_l",      "wrist_l",       //
                                                                "thumb_cmc_l", "thumb_mp_l",   "thumb_ip_l",    //
                                                                "index_mp_l",  "index_pip_l",  "index_dip_l",   //
                                                                "middle_mp_l", "middle_pip_l", "middle_dip_l",  //
                                                                "ring_mp_l",   "ring_pip_l",   "ring_dip_l",    //
                                                                "little_mp_l", "little_pip_l", "little_dip_l",  //
                                                                "shoulder_r",  "elbow_r",      "wrist_r",       //
                                                                "thumb_cmc_r", "thumb_mp_r",   "thumb_ip_r",    //
                                                                "index_mp_r",  "index_pip_r",  "index_dip_r",   //
                                                                "middle_mp_r", "middle_pip_r", "middle_dip_r",  //
                                                                "ring_mp_r",   "ring_pip_r",   "ring_dip_r",    //
                                                                "little_mp_r", "little_pip_r", "little_dip_r"};

/// Nodes that a figure may have between its trunk and its shoulders: left, right.
inline constexpr std::array<std::string_view, 2> kClavicleNames = {"clavicle_l", "clavicle_r"};

struct Node {
  std::string name;
  int parent = kNoNode;  ///< index of the parent, smaller than the node's own; kNoNode for the root only
  Vec3 offset{0.0};      ///< rest position relative to the parent's (the root: to the world origin), metres, world axes
};

/// Nodes, parents first. Built once, then const.
class Skeleton {
 public:
  /// Refuses (kMalformed) an empty list, a parent that does not stand before its child, a second root, a duplicate
  /// name, a non-finite offset, and a list that lacks one of kNodeNames.
  static Result<Skeleton> build(std::vector<Node> nodes);

  std::span<const Node> nodes() const { return nodes_; }
  int size() const { return static_cast<int>(nodes_.size()); }
  const Node& node(int index) const { return nodes_[static_cast<size_t>(index)]; }

  /// Index of the node of that name, or kNoNode.
  int find(std::string_view name) const;
  /// Index of the node that is called kNodeNames[name].
  int named(size_t name) const { return named_[name]; }
  /// Rest position of a node in world space.
  const Vec3& rest_position(int index) const { return rest_[static_cast<size_t>(index)]; }

 private:
  std::vector<Node> nodes_;
  std::vector<Vec3> rest_;
  std::array<int, kNodeNames.size()> named_{};
};

}  // namespace auslan
