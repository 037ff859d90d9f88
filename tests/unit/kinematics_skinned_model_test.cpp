// SPDX-License-Identifier: Apache-2.0
// Smooth joints: what bends, about what, and how two segments stay together.
#include "kinematics/body_model.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
#include "measured_skeleton.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace auslan {
namespace {

// A round sleeve of points along +X, from one place to another (metres from the node).
Mesh sleeve(double from, double to, double radius) {
  Mesh mesh;
  constexpr int kRings = 41;
  for (int ring = 0; ring < kRings; ++ring) {
    const double x = from + (to - from) * ring / (kRings - 1);
    for (const auto& [y, z] : {std::pair(1.0, 0.0), std::pair(0.0, 1.0), std::pair(-1.0, 0.0), std::pair(0.0, -1.0)}) {
      mesh.positions.emplace_back(x, y * radius, z * radius);
      mesh.normals.emplace_back(0.0, y, z);
      mesh.colours.emplace_back(200, 150, 120, 255);
    }
  }
  for (uint32_t i = 0; i + 4 < mesh.positions.size(); ++i)
    mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + 4});
  return mesh;
}

class SmoothJoints : public ::testing::Test {
 protected:
  SmoothJoints() {
    figure_.name = "an arm";
    figure_.skeleton = test::measured_skeleton();
    figure_.segments.resize(static_cast<size_t>(figure_.skeleton.size()));
    upper_ = length_of("elbow_l");
    fore_ = length_of("wrist_l");
    // Both sleeves have rings 6 cm on either side of the elbow, at the same places.
    segment("shoulder_l") = sleeve(upper_ - 0.06, upper_ + 0.06, 0.04);
    segment("elbow_l") = sleeve(-0.06, 0.06, 0.04);
    pose_ = rest_pose(figure_.skeleton);
    world_.resize(figure_.segments.size());
  }

  int node(const std::string& name) const { return figure_.skeleton.find(name); }
  Mesh& segment(const std::string& name) { return figure_.segments[static_cast<size_t>(node(name))]; }
  double length_of(const std::string& name) const {
    const Vec3& offset = figure_.skeleton.node(node(name)).offset;
    return std::sqrt(glm::dot(offset, offset));
  }
  void turn(const std::string& name, const Vec3& axis, double angle) {
    pose_.rotation[static_cast<size_t>(node(name))] = axis_angle(axis, angle);
  }
  /// Places in the world of the vertices of a node's segment.
  std::vector<Vec3> placed(BodyModel& model, const std::string& name) {
    forward(figure_.skeleton, pose_, world_);
    std::vector<Vec3> places;
    for (const PosedMesh& mesh : model.pose(world_, pose_.face)) {
      if (mesh.node != node(name)) continue;
      for (const glm::vec3& p : mesh.positions)
        places.emplace_back(mesh.world_from_mesh * glm::vec4(p, 1.0F));
    }
    return places;
  }
  static double between(const Vec3& a, const Vec3& b) { return std::sqrt(glm::dot(a - b, a - b)); }

  Figure figure_;
  double upper_ = 0.0, fore_ = 0.0;
  Pose pose_;
  std::vector<Transform> world_;
};

const Vec3 kHinge(0.0, -1.0, 0.0);  // at rest the forearm bends forwards
constexpr double kDegree = kPi / 180.0;

TEST_F(SmoothJoints, AtRestIsTheRigidFigure) {
  const auto smooth = make_skinned(figure_);
  const auto rigid = make_rigid_gouraud(figure_);
  for (const char* name : {"shoulder_l", "elbow_l"}) {
    const auto a = placed(*smooth, name);
    const auto b = placed(*rigid, name);
    ASSERT_EQ(a.size(), 164U);
    for (size_t i = 0; i < a.size(); ++i)
      EXPECT_LT(between(a[i], b[i]), 1e-7);
  }
}

TEST_F(SmoothJoints, WhatIsFarFromTheJointMovesAsTheBoneDoes) {
  turn("elbow_l", kHinge, 120.0 * kDegree);
  const auto smooth = make_skinned(figure_);
  const auto rigid = make_rigid_gouraud(figure_);
  for (const char* name : {"shoulder_l", "elbow_l"}) {
    const auto a = placed(*smooth, name);
    const auto b = placed(*rigid, name);
    // The rings at the far ends: more than 15 % of the forearm away.
    const size_t ring = name[0] == 's' ? 0 : a.size() - 4;
    for (size_t i = ring; i < ring + 4; ++i)
      EXPECT_LT(between(a[i], b[i]), 1e-6) << name;
  }
}

TEST_F(SmoothJoints, EveryPointKeepsItsDistanceFromTheJoint) {
  const auto model = make_skinned(figure_);
  const auto before = placed(*model, "elbow_l");
  const Vec3 elbow = world_[static_cast<size_t>(node("elbow_l"))].position;
  for (const double angle : {40.0, 90.0, 145.0}) {
    turn("elbow_l", kHinge, angle * kDegree);
    const auto after = placed(*model, "elbow_l");
    for (size_t i = 0; i < before.size(); ++i)
      EXPECT_NEAR(between(after[i], elbow), between(before[i], elbow), 1e-6) << angle;
  }
}

TEST_F(SmoothJoints, TwoSegmentsStayTogether) {
  turn("elbow_l", kHinge, 130.0 * kDegree);
  const auto model = make_skinned(figure_);
  const auto upper = placed(*model, "shoulder_l");
  const auto fore = placed(*model, "elbow_l");
  const auto rigid_model = make_rigid_gouraud(figure_);
  const auto rigid_upper = placed(*rigid_model, "shoulder_l");
  const auto rigid_fore = placed(*rigid_model, "elbow_l");
  double apart = 0.0;
  double rigid_apart = 0.0;
  for (size_t i = 0; i < upper.size(); ++i) {
    apart = std::max(apart, between(upper[i], fore[i]));
    rigid_apart = std::max(rigid_apart, between(rigid_upper[i], rigid_fore[i]));
  }
  EXPECT_LT(apart, 1e-6);
  EXPECT_GT(rigid_apart, 0.05) << "without smooth joints they part";
}

TEST_F(SmoothJoints, TheMiddleOfABendTakesHalfOfIt) {
  turn("elbow_l", kHinge, 100.0 * kDegree);
  const auto model = make_skinned(figure_);
  const auto fore = placed(*model, "elbow_l");
  const Vec3 elbow = world_[static_cast<size_t>(node("elbow_l"))].position;
  // The ring at the joint, its point behind (-Z at rest): half of 100 degrees about -Y.
  const Vec3 expected = elbow + axis_angle(kHinge, 50.0 * kDegree) * Vec3(0.0, 0.0, -0.04);
  EXPECT_LT(between(fore[4 * 20 + 3], expected), 1e-6);
}

TEST_F(SmoothJoints, AForearmTwistsAlongItsLength) {
  segment("elbow_l") = sleeve(0.0, fore_, 0.03);
  turn("elbow_l", Vec3(1.0, 0.0, 0.0), 80.0 * kDegree);
  const auto model = make_skinned(figure_);
  const auto fore = placed(*model, "elbow_l");
  const Vec3 elbow = world_[static_cast<size_t>(node("elbow_l"))].position;
  double last = -1e-6;
  for (size_t ring = 0; ring < 41; ++ring) {
    const Vec3 top = fore[4 * ring] - elbow;  // +Y at rest; +X turns it towards +Z
    const double angle = arc_tangent(top.z, top.y) / kDegree;
    EXPECT_GE(angle, last - 1e-3) << "ring " << ring;
    last = angle;
    if (ring == 0) {
      EXPECT_NEAR(angle, 0.0, 1e-3);
    } else if (ring == 20) {
      EXPECT_NEAR(angle, 40.0, 6.0);
    }
  }
  EXPECT_NEAR(last, 80.0, 1e-3);
}

TEST_F(SmoothJoints, TheRevisionChangesWithTheJointAlone) {
  const auto model = make_skinned(figure_);
  const auto revisions = [&] {
    forward(figure_.skeleton, pose_, world_);
    std::vector<uint64_t> all;
    for (const PosedMesh& mesh : model->pose(world_, pose_.face))
      all.push_back(mesh.revision);
    return all;
  };
  const auto first = revisions();
  EXPECT_EQ(revisions(), first);
  turn("elbow_l", kHinge, 0.4);
  const auto bent = revisions();
  EXPECT_NE(bent[0], first[0]);
  EXPECT_NE(bent[1], first[1]);
  turn("wrist_l", kHinge, 0.4);
  EXPECT_EQ(revisions(), bent) << "no vertex here is near the wrist";
}

}  // namespace
}  // namespace auslan
