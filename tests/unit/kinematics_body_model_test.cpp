// SPDX-License-Identifier: Apache-2.0
#include "box_figure.h"
#include "kinematics/body_model.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace {

size_t allocations = 0;

}  // namespace

// Counts, so that a test can say that a frame allocates nothing. Not inlined: g++ would see free() meet operator new.
[[gnu::noinline]] void* operator new(size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, size_t) noexcept {
  std::free(memory);
}

namespace auslan {
namespace {

double length(const glm::vec3& v) {
  return std::sqrt(static_cast<double>(glm::dot(v, v)));
}

class BodyModels : public ::testing::Test {
 protected:
  BodyModels() : world_(static_cast<size_t>(figure_.skeleton.size())) {
    forward(figure_.skeleton, rest_pose(figure_.skeleton), world_);
  }
  Figure figure_ = test::box_figure();
  std::vector<Transform> world_;
  FaceWeights still_{};
};

TEST_F(BodyModels, OneMeshForEachSegmentInNodeOrder) {
  for (const auto& model : {make_rigid_flat(figure_), make_rigid_gouraud(figure_)}) {
    const auto meshes = model->pose(world_, still_);
    ASSERT_EQ(meshes.size(), 2U);
    EXPECT_EQ(meshes[0].node, figure_.skeleton.find("head_base"));
    EXPECT_EQ(meshes[1].node, figure_.skeleton.find("wrist_l"));
    for (const PosedMesh& mesh : meshes) {
      EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
      EXPECT_EQ(mesh.colours.size(), mesh.positions.size());
      EXPECT_EQ(mesh.indices.size(), 36U);
      for (const uint32_t index : mesh.indices)
        EXPECT_LT(index, mesh.positions.size());
    }
  }
}

TEST_F(BodyModels, FlatTrianglesHaveTheirOwnNormalsGouraudTheFigures) {
  const auto flat = make_rigid_flat(figure_);
  const PosedMesh facets = flat->pose(world_, still_)[1];
  ASSERT_EQ(facets.positions.size(), 36U);
  for (size_t first = 0; first < 36; first += 3)
    for (size_t i = 0; i < 3; ++i) {
      const glm::vec3 normal = facets.normals[facets.indices[first + i]];
      EXPECT_NEAR(length(normal), 1.0, 1e-6);
      EXPECT_EQ(normal, facets.normals[facets.indices[first]]);
      // A face of a cube is 20 mm from its centre.
      EXPECT_NEAR(glm::dot(normal, facets.positions[facets.indices[first + i]]), 0.02F, 1e-7F);
    }
  const auto smooth = make_rigid_gouraud(figure_);
  const PosedMesh corners = smooth->pose(world_, still_)[1];
  ASSERT_EQ(corners.positions.size(), 8U);
  for (size_t i = 0; i < 8; ++i)
    EXPECT_LT(length(corners.normals[i] * 0.034641016F - corners.positions[i]), 1e-8);
}

TEST_F(BodyModels, TheMatrixPlacesTheSegment) {
  Pose pose = rest_pose(figure_.skeleton);
  const auto wrist = static_cast<size_t>(figure_.skeleton.find("wrist_l"));
  pose.rotation[wrist] = axis_angle(Vec3(0.0, 0.0, 1.0), kPi / 2.0);
  forward(figure_.skeleton, pose, world_);
  const auto model = make_rigid_gouraud(figure_);
  const PosedMesh mesh = model->pose(world_, still_)[1];
  const glm::vec4 placed = mesh.world_from_mesh * glm::vec4(0.02F, 0.0F, 0.0F, 1.0F);
  const Vec3 expected = world_[wrist].position + Vec3(0.0, 0.02, 0.0);
  EXPECT_LT(length(glm::vec3(placed) - glm::vec3(expected)), 1e-6);
}

TEST_F(BodyModels, MorphsMoveVerticesByTheirWeightsAndBack) {
  for (const auto& model : {make_rigid_flat(figure_), make_rigid_gouraud(figure_)}) {
    const auto height = [&](const FaceWeights& face) {
      float top = 0.0F;
      for (const glm::vec3& p : model->pose(world_, face)[0].positions)
        top = p.y > top ? p.y : top;
      return top;
    };
    FaceWeights half{};
    half[static_cast<size_t>(FaceChannel::kJawOpen)] = 0.5F;
    EXPECT_NEAR(height(half), 0.04F, 1e-7F);
    EXPECT_EQ(height(still_), 0.02F);
    FaceWeights other_channel{};
    other_channel[static_cast<size_t>(FaceChannel::kCheekPuff)] = 1.0F;
    EXPECT_EQ(height(other_channel), 0.02F);
  }
}

TEST_F(BodyModels, NormalsFollowAMorph) {
  FaceWeights pulled{};
  pulled[static_cast<size_t>(FaceChannel::kMouthPucker)] = 1.0F;
  const auto flat = make_rigid_flat(figure_);
  const PosedMesh facets = flat->pose(world_, pulled)[0];
  for (size_t first = 0; first < 36; first += 3) {
    const auto corner = [&](size_t i) { return facets.positions[facets.indices[first + i]]; };
    const glm::vec3 expected = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    for (size_t i = 0; i < 3; ++i)
      EXPECT_LT(length(facets.normals[facets.indices[first + i]] - expected), 1e-5);
  }
  const auto smooth = make_rigid_gouraud(figure_);
  const std::vector<glm::vec3> before = [&] {
    const auto normals = smooth->pose(world_, still_)[0].normals;
    return std::vector<glm::vec3>(normals.begin(), normals.end());
  }();
  const auto after = smooth->pose(world_, pulled)[0].normals;
  // Pulled out along z, the corner's neighbours on the +z face lean away from it; the far corner's triangles are whole.
  EXPECT_LT(after[6].x, before[6].x);
  EXPECT_LT(after[5].y, before[5].y);
  EXPECT_EQ(after[0], before[0]);
  for (const glm::vec3& normal : after)
    EXPECT_NEAR(length(normal), 1.0, 1e-6);
  const auto again = smooth->pose(world_, still_)[0].normals;
  for (size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(again[i], before[i]) << "rest again, to the bit";
}

TEST_F(BodyModels, TheRevisionChangesWithTheContentsAlone) {
  for (const auto& model : {make_rigid_flat(figure_), make_rigid_gouraud(figure_)}) {
    const auto revisions = [&](const FaceWeights& face) {
      const auto meshes = model->pose(world_, face);
      return std::pair(meshes[0].revision, meshes[1].revision);
    };
    const auto [head, hand] = revisions(still_);
    EXPECT_NE(head, 0U);
    EXPECT_NE(hand, 0U);
    world_[1].position.x += 0.25;  // where a segment lies is no part of its contents
    FaceWeights face{};
    face[static_cast<size_t>(FaceChannel::kCheekPuff)] = 1.0F;  // this figure has no such morph
    EXPECT_EQ(revisions(face), std::pair(head, hand));
    face[static_cast<size_t>(FaceChannel::kJawOpen)] = 0.5F;
    const auto [opened, hand_again] = revisions(face);
    EXPECT_NE(opened, head);
    EXPECT_EQ(hand_again, hand);
    EXPECT_EQ(revisions(face).first, opened);
    EXPECT_NE(revisions(still_).first, opened);
  }
}

TEST_F(BodyModels, AFrameAllocatesNothing) {
  for (const auto& model : {make_rigid_flat(figure_), make_rigid_gouraud(figure_)}) {
    FaceWeights face{};
    model->pose(world_, face);
    const size_t before = allocations;
    for (int i = 0; i < 10; ++i) {
      face[static_cast<size_t>(FaceChannel::kJawOpen)] = 0.1F * static_cast<float>(i);
      model->pose(world_, face);
    }
    EXPECT_EQ(allocations, before);
  }
}

}  // namespace
}  // namespace auslan
