// SPDX-License-Identifier: Apache-2.0
// Smooth joints: near a joint the surface takes part of its rotation, about the joint's centre. A blend of two dual
// quaternions whose bones share a joint is just that rotation (Kavan, Collins, Zara and O'Sullivan 2008), so that
// nothing collapses: every point keeps its distance from the joint.
#include "joint_zone.h"
#include "kinematics/body_model.h"
#include "kinematics/rotation.h"
#include "segment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace auslan {
namespace {

using Turn = glm::quat;

Turn float_turn(const Quat& q) {
  const double sign = q.w < 0.0 ? -1.0 : 1.0;
  return {static_cast<float>(q.w * sign), static_cast<float>(q.x * sign), static_cast<float>(q.y * sign),
          static_cast<float>(q.z * sign)};
}

// Part of a turn, along the shorter way; w >= 0.
Turn part_of(const Turn& q, float share) {
  const float rest = 1.0F - share;
  const float w = rest + share * q.w;
  const float x = share * q.x;
  const float y = share * q.y;
  const float z = share * q.z;
  const float scale = 1.0F / std::sqrt(((w * w + x * x) + y * y) + z * z);
  return {w * scale, x * scale, y * scale, z * scale};
}

Turn product(const Turn& a, const Turn& b) {
  return {((a.w * b.w - a.x * b.x) - a.y * b.y) - a.z * b.z, ((a.w * b.x + a.x * b.w) + a.y * b.z) - a.z * b.y,
          ((a.w * b.y - a.x * b.z) + a.y * b.w) + a.z * b.x, ((a.w * b.z + a.x * b.y) - a.y * b.x) + a.z * b.w};
}

glm::vec3 turned(const Turn& q, const glm::vec3& v) {
  const glm::vec3 u(q.x, q.y, q.z);
  const glm::vec3 t = glm::cross(u, v) * 2.0F;
  return (v + t * q.w) + glm::cross(u, t);
}

// How a joint stands, relative to its parent.
struct Bend {
  Turn swing{1.0F, 0.0F, 0.0F, 0.0F}, twist{1.0F, 0.0F, 0.0F, 0.0F};
  bool operator==(const Bend&) const = default;

  Turn part(float swing_share, float twist_share) const {
    return product(part_of(swing, swing_share), part_of(twist, twist_share));
  }
};

struct Share {
  uint32_t vertex;
  float swing, twist, weight;
};

// A segment whose surface near its own joint and near its children's joints bends.
class BentSegment {
 public:
  BentSegment(int node, const Mesh& mesh) : segment_(node, mesh, Normals::kOfVertices) {
    positions_ = mesh.positions;
    normals_ = mesh.normals;
    is_bent_.assign(mesh.positions.size(), false);
  }

  // The part of the surface that keeps behind its own joint, relative to the segment.
  void add_own(const JointZone& zone, size_t joint) {
    own_joint_ = joint;
    const Mesh& mesh = segment_.rest();
    for (uint32_t i = 0; i < mesh.positions.size(); ++i) {
      const double along = glm::dot(Vec3(mesh.positions[i]), zone.axis);
      const Share share{i, static_cast<float>(zone.bend.at(along)), static_cast<float>(zone.twist.at(along)), 1.0F};
      if (share.swing < 1.0F || share.twist < 1.0F) keep(own_, share);
    }
  }
  // The part that already follows a child.
  void add_child(const JointZone& zone, size_t joint, const Vec3& offset) {
    Child child{joint, glm::vec3(offset), {}, {}};
    const Mesh& mesh = segment_.rest();
    for (uint32_t i = 0; i < mesh.positions.size(); ++i) {
      const Vec3 place = Vec3(mesh.positions[i]) - offset;
      const double along = glm::dot(place, zone.axis);
      const Share share{i, static_cast<float>(zone.bend.at(along)), static_cast<float>(zone.twist.at(along)),
                        static_cast<float>(zone.closeness(place))};
      if ((share.swing > 0.0F || share.twist > 0.0F) && share.weight > 0.0F) keep(child.shares, share);
    }
    if (!child.shares.empty()) children_.push_back(std::move(child));
  }

  PosedMesh view() const {
    PosedMesh mesh = segment_.view();
    if (bent_.empty()) return mesh;
    mesh.positions = positions_;
    mesh.normals = normals_;
    return mesh;
  }
  uint64_t revision() const { return revision_; }

  void apply(const FaceWeights& face, const std::vector<Bend>& bends) {
    segment_.apply(face);
    if (segment_.revision() == applied_face_ && same_bends(bends)) return;
    const PosedMesh unbent = segment_.view();
    if (segment_.revision() != applied_face_ && !bent_.empty()) {
      std::copy(unbent.positions.begin(), unbent.positions.end(), positions_.begin());
      std::copy(unbent.normals.begin(), unbent.normals.end(), normals_.begin());
    }
    for (const uint32_t vertex : bent_) {
      positions_[vertex] = unbent.positions[vertex];
      normals_[vertex] = unbent.normals[vertex];
    }
    for (Child& child : children_)
      follow(child, bends[child.joint], unbent);
    if (!own_.empty()) keep_behind(bends[own_joint_]);
    applied_face_ = segment_.revision();
    ++revision_;
  }

 private:
  struct Child {
    size_t joint;
    glm::vec3 offset;
    std::vector<Share> shares;
    Bend applied;
  };

  void keep(std::vector<Share>& shares, const Share& share) {
    shares.push_back(share);
    if (is_bent_[share.vertex]) return;
    is_bent_[share.vertex] = true;
    bent_.push_back(share.vertex);
  }

  bool same_bends(const std::vector<Bend>& bends) const {
    for (const Child& child : children_) {
      if (!(bends[child.joint] == child.applied)) return false;
    }
    return own_.empty() || bends[own_joint_] == own_applied_;
  }

  void follow(Child& child, const Bend& bend, const PosedMesh& unbent) {
    child.applied = bend;
    for (const Share& share : child.shares) {
      const Turn turn = bend.part(share.swing, share.twist);
      const glm::vec3 arm = unbent.positions[share.vertex] - child.offset;
      const glm::vec3 normal = unbent.normals[share.vertex];
      positions_[share.vertex] += (turned(turn, arm) - arm) * share.weight;
      normals_[share.vertex] += (turned(turn, normal) - normal) * share.weight;
    }
  }

  // In the segment's frame, which turns with all of the joint, what follows only a part of it turns back.
  void keep_behind(const Bend& bend) {
    own_applied_ = bend;
    const Turn all = product(bend.swing, bend.twist);
    const Turn back(all.w, -all.x, -all.y, -all.z);
    for (const Share& share : own_) {
      const Turn turn = product(back, bend.part(share.swing, share.twist));
      positions_[share.vertex] = turned(turn, positions_[share.vertex]);
      normals_[share.vertex] = turned(turn, normals_[share.vertex]);
    }
  }

  Segment segment_;
  std::vector<glm::vec3> positions_, normals_;
  std::vector<bool> is_bent_;
  std::vector<uint32_t> bent_;
  size_t own_joint_ = 0;
  std::vector<Share> own_;
  Bend own_applied_;
  std::vector<Child> children_;
  uint64_t applied_face_ = 0;
  uint64_t revision_ = 1;
};

class SkinnedModel final : public BodyModel {
 public:
  explicit SkinnedModel(const Figure& figure) : zones_(joint_zones(figure.skeleton)) {
    for (size_t node = 0; node < figure.segments.size(); ++node) {
      const Mesh& mesh = figure.segments[node];
      if (mesh.indices.empty()) continue;
      BentSegment& segment =
          segments_.emplace_back(static_cast<int>(node), with_common_normals(figure, static_cast<int>(node)));
      for (size_t joint = 0; joint < zones_.size(); ++joint) {
        const JointZone& zone = zones_[joint];
        const Node& at = figure.skeleton.node(zone.node);
        if (zone.node == static_cast<int>(node)) segment.add_own(zone, joint);
        if (at.parent == static_cast<int>(node) && zone.bends_parent) segment.add_child(zone, joint, at.offset);
      }
    }
    for (const JointZone& zone : zones_)
      parents_.push_back(figure.skeleton.node(zone.node).parent);
    bends_.resize(zones_.size());
    // Only now: a segment's vectors must stay where the views point.
    for (const BentSegment& segment : segments_)
      posed_.push_back(segment.view());
  }

  std::span<const PosedMesh> pose(std::span<const Transform> world_from_node, const FaceWeights& face) override {
    for (size_t joint = 0; joint < zones_.size(); ++joint) {
      const Quat& parent = world_from_node[static_cast<size_t>(parents_[joint])].rotation;
      const Quat& node = world_from_node[static_cast<size_t>(zones_[joint].node)].rotation;
      const SwingTwist turn = swing_twist(glm::conjugate(parent) * node, zones_[joint].axis);
      bends_[joint] = Bend{float_turn(turn.swing), float_turn(turn.twist)};
    }
    for (size_t i = 0; i < segments_.size(); ++i) {
      segments_[i].apply(face, bends_);
      posed_[i].revision = segments_[i].revision();
      posed_[i].world_from_mesh = matrix_of(world_from_node[static_cast<size_t>(posed_[i].node)]);
    }
    return posed_;
  }

 private:
  // Where two segments meet, both are lit as the round limb that they make together: their normals there point away
  // from its axis.
  Mesh with_common_normals(const Figure& figure, int node) const {
    Mesh mesh = figure.segments[static_cast<size_t>(node)];
    for (const JointZone& zone : zones_) {
      const Node& at = figure.skeleton.node(zone.node);
      const bool is_child = at.parent == node;
      // A clavicle has no surface that the trunk's could meet.
      if (figure.segments[static_cast<size_t>(zone.node)].indices.empty()) continue;
      if (!zone.bends_parent || (!is_child && zone.node != node)) continue;
      const Vec3 offset = is_child ? at.offset : Vec3(0.0);
      for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 place = Vec3(mesh.positions[i]) - offset;
        const double along = glm::dot(place, zone.axis);
        const double share = zone.bend.at(along);
        const double common = 4.0 * share * (1.0 - share) * (is_child ? zone.closeness(place) : 1.0);
        const glm::vec3 away(place - zone.axis * along);
        if (common <= 0.0 || !(glm::dot(away, away) > 0.0F)) continue;
        const glm::vec3 radial = unit_or(away, mesh.normals[i]);
        mesh.normals[i] = unit_or(
            mesh.normals[i] * static_cast<float>(1.0 - common) + radial * static_cast<float>(common), mesh.normals[i]);
      }
    }
    return mesh;
  }

  std::vector<JointZone> zones_;
  std::vector<int> parents_;  ///< of the zones' nodes
  std::vector<Bend> bends_;
  std::vector<BentSegment> segments_;
  std::vector<PosedMesh> posed_;
};

}  // namespace

std::unique_ptr<BodyModel> make_skinned(const Figure& figure) {
  return std::make_unique<SkinnedModel>(figure);
}

}  // namespace auslan
