// SPDX-License-Identifier: Apache-2.0
// A foreign figure turns into the rest pose of the project's skeleton, and its skin follows that skeleton.
#include "kinematics/signing_avatar.h"

#include "box_avatar.h"
#include "kinematics/avatar_model.h"
#include "kinematics/surface.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace auslan {
namespace {

using test::box_avatar;
using test::BoxAvatar;
using test::measured_skeleton;

constexpr double kRight = kPi / 2.0;

SigningAvatar fitted(Avatar avatar) {
  auto result = fit_avatar(std::move(avatar));
  EXPECT_TRUE(result) << to_string(result.error());
  return result ? *std::move(result) : SigningAvatar{};
}

/// The largest distance of a joint from where another skeleton has it, both seen from the middle of the shoulders.
double worst_joint(const Skeleton& skeleton, const Skeleton& wanted) {
  const auto middle = [](const Skeleton& s) {
    return 0.5 * (s.rest_position(s.find("shoulder_l")) + s.rest_position(s.find("shoulder_r")));
  };
  double worst = 0.0;
  for (const std::string_view name : kNodeNames) {
    const Vec3 off = (skeleton.rest_position(skeleton.find(name)) - middle(skeleton)) -
                     (wanted.rest_position(wanted.find(name)) - middle(wanted));
    worst = std::max(worst, std::sqrt(glm::dot(off, off)));
  }
  return worst;
}

double distance(const Skeleton& skeleton, std::string_view a, std::string_view b) {
  const Vec3 off = skeleton.rest_position(skeleton.find(a)) - skeleton.rest_position(skeleton.find(b));
  return std::sqrt(glm::dot(off, off));
}

// The measured arms are as long as those that figures are scaled to, so that lengths come back as they are.
TEST(SigningAvatar, TheTPoseKeepsEveryBone) {
  const SigningAvatar avatar = fitted(box_avatar());
  const Skeleton wanted = measured_skeleton();
  const Skeleton& skeleton = avatar.figure.skeleton;
  for (size_t n = 2; n < kNodeNames.size(); ++n) {
    const std::string& parent = wanted.node(wanted.node(static_cast<int>(n)).parent).name;
    EXPECT_NEAR(distance(skeleton, kNodeNames[n], parent), distance(wanted, kNodeNames[n], parent), 1e-9);
  }
  for (const char* side : {"_l", "_r"}) {
    const double outward = side == std::string("_l") ? 1.0 : -1.0;
    const auto at = [&](const std::string& name) { return skeleton.rest_position(skeleton.find(name + side)); };
    // Arm and middle metacarpal in one line, fingers straight in the plane of the palm.
    for (const char* name : {"elbow", "wrist", "middle_mp"}) {
      EXPECT_NEAR(at(name).y, at("shoulder").y, 1e-9);
      EXPECT_NEAR(at(name).z, at("shoulder").z, 1e-9);
      EXPECT_GT(outward * (at(name) - at("shoulder")).x, 0.2);
    }
    for (const std::string finger : {"index", "middle", "ring", "little"}) {
      const Vec3 first = at(finger + "_pip") - at(finger + "_mp");
      const Vec3 second = at(finger + "_dip") - at(finger + "_pip");
      EXPECT_NEAR(first.y, 0.0, 1e-9);
      EXPECT_NEAR(glm::dot(first, second), std::sqrt(glm::dot(first, first) * glm::dot(second, second)), 1e-12);
    }
    EXPECT_NEAR(at("index_mp").y, at("little_mp").y, 1e-9);
    // The thumb's tip is before the palm, outwards of its root.
    EXPECT_GT(at("thumb_ip").z, at("index_mp").z);
    EXPECT_GT(outward * at("thumb_ip").x, outward * at("thumb_cmc").x);
  }
}

TEST(SigningAvatar, AnyRestPoseSizeAndFacingBecomesTheSameTPose) {
  const SigningAvatar plain = fitted(box_avatar());
  for (const BoxAvatar& wanted : {BoxAvatar{.arms_below = 0.8}, BoxAvatar{.arms_below = kRight - 0.1},
                                  BoxAvatar{.arms_below = -0.5}, BoxAvatar{.arms_below = 0.8, .fingers_bent = 0.35},
                                  BoxAvatar{.yaw = kPi}, BoxAvatar{.arms_below = 0.6, .yaw = 2.1},
                                  BoxAvatar{.arms_below = 0.8, .scale = 0.01, .place = Vec3(3.0, -5.0, 7.0)},
                                  BoxAvatar{.yaw = kPi, .scale = 18.0}}) {
    const SigningAvatar avatar = fitted(box_avatar(wanted));
    // Fingers are bent about the world's axis, of which the hand's is 3 degrees off: they straighten a little aside.
    EXPECT_LT(worst_joint(avatar.figure.skeleton, plain.figure.skeleton), wanted.fingers_bent > 0.0 ? 2e-3 : 1e-6)
        << wanted.arms_below << ' ' << wanted.fingers_bent << ' ' << wanted.yaw << ' ' << wanted.scale;
    EXPECT_NEAR(avatar.scale * wanted.scale, 1.0, 1e-9);
    EXPECT_TRUE(avatar.warnings.empty());
  }
}

// Upright is then from hips to head, which lies 28 mm of 560 farther back than the hips.
TEST(SigningAvatar, AFigureThatLiesStandsUp) {
  const SigningAvatar plain = fitted(box_avatar());
  for (const double pitch : {-kRight, kRight}) {
    const SigningAvatar avatar = fitted(box_avatar({.yaw = 0.3, .pitch = pitch}));
    EXPECT_LT(worst_joint(avatar.figure.skeleton, plain.figure.skeleton), 0.03) << pitch;
  }
}

TEST(SigningAvatar, StandsOnTheGroundBetweenItsShoulders) {
  const SigningAvatar avatar = fitted(box_avatar({.scale = 0.2, .place = Vec3(9.0, 9.0, 9.0)}));
  const Skeleton& skeleton = avatar.figure.skeleton;
  EXPECT_NEAR(skeleton.rest_position(skeleton.find("shoulder_l")).x,
              -skeleton.rest_position(skeleton.find("shoulder_r")).x, 1e-9);
  // The lowest box is the trunk's, which begins at the hips; the trunk bends above them.
  const double shoulders = skeleton.rest_position(skeleton.find("shoulder_l")).y;
  EXPECT_NEAR(shoulders, 0.47 - 0.088, 1e-5);
  EXPECT_NEAR(skeleton.rest_position(0).y, 0.15 * shoulders, 1e-5);
}

TEST(SigningAvatar, TheSurfaceIsCutByWhatMovesIt) {
  const SigningAvatar avatar = fitted(box_avatar({.arms_below = 0.7, .yaw = kPi}));
  for (const Mesh& segment : avatar.figure.segments)
    EXPECT_EQ(segment.indices.size(), 36U);
  // The forearm is a square bar of half 40 mm about its bone, wherever the figure rested; it rolls with the palm, whose
  // knuckles are not quite level in the measured hand.
  const int elbow = avatar.figure.skeleton.find("elbow_l");
  EXPECT_NEAR(extreme_point(avatar.figure, elbow, Vec3(0.0, 1.0, 0.0)).position.y, 0.04, 3e-3);
  EXPECT_NEAR(extreme_point(avatar.figure, elbow, Vec3(0.0, -1.0, 0.0)).position.y, -0.04, 3e-3);
}

TEST(SigningAvatar, MissingFingersAreReportedAndStandBetweenTheirNeighbours) {
  Avatar source = box_avatar();
  for (size_t joint = 0; joint < 3; ++joint)
    source.human_node[static_cast<size_t>(HumanRole::kLeftRingProximal) + joint] = kNoNode;
  const SigningAvatar avatar = fitted(std::move(source));
  ASSERT_EQ(avatar.warnings.size(), 1U);
  EXPECT_NE(avatar.warnings[0].find("left hand the ring finger is missing"), std::string::npos) << avatar.warnings[0];
  const Skeleton& skeleton = avatar.figure.skeleton;
  const auto z = [&](const char* name) { return skeleton.rest_position(skeleton.find(name)).z; };
  EXPECT_LT(z("ring_mp_l"), z("middle_mp_l"));
  EXPECT_GT(z("ring_mp_l"), z("little_mp_l"));
  for (const char* name : {"ring_mp_l", "ring_pip_l", "ring_dip_l"})
    EXPECT_FALSE(avatar.figure.segments[static_cast<size_t>(skeleton.find(name))].indices.empty());
}

TEST(SigningAvatar, AHandWithoutFingersAndATrunkWithoutNamesAreFilledIn) {
  Avatar source = box_avatar();
  for (auto r = static_cast<size_t>(HumanRole::kLeftThumbMetacarpal); r < kHumanRoleCount; ++r)
    source.human_node[r] = kNoNode;
  source.human_node[static_cast<size_t>(HumanRole::kHips)] = kNoNode;
  source.human_node[static_cast<size_t>(HumanRole::kNeck)] = kNoNode;
  const SigningAvatar avatar = fitted(std::move(source));
  EXPECT_EQ(avatar.warnings.size(), 3U);
  const Skeleton& skeleton = avatar.figure.skeleton;
  for (const char* side : {"_l", "_r"}) {
    const Vec3 wrist = skeleton.rest_position(skeleton.find(std::string("wrist") + side));
    const Vec3 middle = skeleton.rest_position(skeleton.find(std::string("middle_mp") + side));
    // The mean palm is 95 mm long; the fingers go on outwards, palms down.
    EXPECT_NEAR(std::fabs(middle.x - wrist.x), 0.095, 0.01);
    EXPECT_GT(skeleton.rest_position(skeleton.find(std::string("index_mp") + side)).z,
              skeleton.rest_position(skeleton.find(std::string("little_mp") + side)).z);
  }
}

TEST(SigningAvatar, WhatCannotSignIsRefused) {
  using enum HumanRole;
  const auto refused = [](Avatar avatar, std::string_view why) {
    const auto result = fit_avatar(std::move(avatar));
    ASSERT_FALSE(result) << why;
    EXPECT_EQ(result.error().code, ErrorCode::kUnsupported);
    EXPECT_NE(result.error().message.find(why), std::string::npos) << result.error().message;
  };
  for (const HumanRole role : {kHead, kLeftUpperArm, kRightLowerArm, kLeftHand}) {
    Avatar avatar = box_avatar();
    avatar.human_node[static_cast<size_t>(role)] = kNoNode;
    refused(std::move(avatar), "lacks " + std::string(name_of(role)));
  }
  Avatar nobody = box_avatar();
  nobody.human_node.fill(kNoNode);
  refused(std::move(nobody), "no humanoid");
  Avatar armless = box_avatar();
  for (AvatarNode& node : armless.nodes)
    node.translation = Vec3(0.0);
  refused(std::move(armless), "no size");
  Avatar giant = box_avatar();
  giant.nodes[static_cast<size_t>(giant.node_of(kLeftUpperArm))].translation.x = 1e5;
  refused(std::move(giant), "build of a body");
  Avatar ladder = box_avatar();
  ladder.nodes[static_cast<size_t>(ladder.node_of(kLeftUpperArm))].translation = Vec3(0.0, 0.3, 0.0);
  ladder.nodes[static_cast<size_t>(ladder.node_of(kRightUpperArm))].translation = Vec3(0.0, -0.3, 0.0);
  refused(std::move(ladder), "above each other");
}

TEST(SigningAvatar, TheChinIsFoundUnderHairThatHangsLower) {
  // The face's box ends 60 mm below the joint of the head; a lock of hair beside it reaches 300 mm down.
  Avatar source = box_avatar();
  const Vec3 head = measured_skeleton().rest_position(2);
  AvatarMesh& mesh = source.meshes[0];
  test::add_box(mesh.vertices[0], mesh.surfaces[0], head + Vec3(0.05, -0.3, 0.08), head + Vec3(0.07, 0.1, 0.12), 2);
  const SigningAvatar avatar = fitted(std::move(source));
  const Vec3 joint = avatar.figure.skeleton.rest_position(2);
  EXPECT_NEAR(avatar.face.chin_y, joint.y - 0.06, 0.002);
  EXPECT_NEAR(avatar.face.top_y, joint.y + 0.26, 0.002);
}

/// The model of a figure in a pose of its skeleton.
class Posed {
 public:
  explicit Posed(Avatar source) : avatar_(fitted(std::move(source))), model_(make_avatar_model(avatar_)) {
    pose_ = rest_pose(avatar_.figure.skeleton);
    world_.resize(kNodeNames.size());
  }

  const Skeleton& skeleton() const { return avatar_.figure.skeleton; }
  Quat& rotation(std::string_view name) { return pose_.rotation[static_cast<size_t>(skeleton().find(name))]; }
  float& channel(FaceChannel channel) { return pose_.face[static_cast<size_t>(channel)]; }
  const Transform& placed(std::string_view name) const { return world_[static_cast<size_t>(skeleton().find(name))]; }
  Vec3 rest(std::string_view name) const { return skeleton().rest_position(skeleton().find(name)); }

  void pose() {
    forward(skeleton(), pose_, world_);
    meshes_ = model_->pose(world_, pose_.face);
  }
  /// The vertices of a node's mesh, world space.
  std::vector<Vec3> vertices(std::string_view name) const {
    std::vector<Vec3> found;
    for (const PosedMesh& mesh : meshes_)
      if (mesh.node == skeleton().find(name))
        for (const glm::vec3& position : mesh.positions)
          found.emplace_back(position);
    return found;
  }
  std::span<const PosedMesh> meshes() const { return meshes_; }

 private:
  SigningAvatar avatar_;
  std::unique_ptr<BodyModel> model_;
  Pose pose_;
  std::vector<Transform> world_;
  std::span<const PosedMesh> meshes_;
};

TEST(AvatarModel, EveryBoneFollowsItsNode) {
  Posed posed(box_avatar({.arms_below = 0.7, .yaw = kPi, .scale = 3.0}));
  posed.pose();
  const std::vector<Vec3> at_rest = posed.vertices("wrist_l");
  const std::vector<Vec3> finger_at_rest = posed.vertices("index_dip_r");
  ASSERT_EQ(at_rest.size(), 8U);
  posed.rotation("spine_base") = axis_angle(Vec3(0.0, 1.0, 0.0), 0.2);
  posed.rotation("shoulder_l") = axis_angle(Vec3(0.0, 0.0, 1.0), -1.1);
  posed.rotation("elbow_l") = axis_angle(Vec3(0.0, -1.0, 0.0), 1.5);
  posed.rotation("index_pip_r") = axis_angle(Vec3(0.0, 0.0, 1.0), 0.9);
  posed.pose();
  for (const auto& [name, rest] : {std::pair("wrist_l", at_rest), std::pair("index_dip_r", finger_at_rest)}) {
    const std::vector<Vec3> now = posed.vertices(name);
    for (size_t i = 0; i < rest.size(); ++i) {
      const Vec3 off = now[i] - apply(posed.placed(name), rest[i] - posed.rest(name));
      EXPECT_LT(std::sqrt(glm::dot(off, off)), 1e-6) << name;
    }
  }
}

TEST(AvatarModel, AForearmTwistsAlongItsLength) {
  Posed posed(box_avatar());
  posed.pose();
  const std::vector<Vec3> rest = posed.vertices("elbow_l");
  constexpr double kTurned = 1.2;
  posed.rotation("elbow_l") = axis_angle(Vec3(1.0, 0.0, 0.0), kTurned);
  posed.pose();
  const std::vector<Vec3> now = posed.vertices("elbow_l");
  const Vec3 elbow = posed.rest("elbow_l");
  const double length = posed.rest("wrist_l").x - elbow.x;
  size_t near_elbow = 0;
  for (size_t i = 0; i < rest.size(); ++i) {
    const Vec3 from = rest[i] - elbow;
    const bool at_wrist = from.x > 0.5 * length;
    near_elbow += at_wrist ? 0 : 1;
    const Vec3 wanted = elbow + axis_angle(Vec3(1.0, 0.0, 0.0), at_wrist ? kTurned : 0.0) * from;
    EXPECT_LT(std::sqrt(glm::dot(now[i] - wanted, now[i] - wanted)), 1e-6);
  }
  EXPECT_EQ(near_elbow, 4U);
}

TEST(AvatarModel, AFaceChannelMovesWhatItsTargetSays) {
  Posed posed(box_avatar({.scale = 0.1}));
  posed.pose();
  const std::vector<Vec3> rest = posed.vertices("head_base");
  posed.channel(FaceChannel::kJawOpen) = 0.5F;
  posed.pose();
  const std::vector<Vec3> now = posed.vertices("head_base");
  size_t moved = 0;
  for (size_t i = 0; i < rest.size(); ++i) {
    const Vec3 by = now[i] - rest[i];
    if (glm::dot(by, by) == 0.0) continue;
    ++moved;
    EXPECT_NEAR(by.y, -0.015, 1e-6);
  }
  EXPECT_EQ(moved, 2U);
}

TEST(AvatarModel, EyesAndJawTurnByTheirBonesWhereNoTargetMovesThem) {
  using enum HumanRole;
  Avatar source = box_avatar();
  source.face = {};
  const Vec3 head = measured_skeleton().rest_position(2);
  for (const auto& [role, x] : {std::pair(kLeftEye, 0.03), std::pair(kRightEye, -0.03)}) {
    source.human_node[static_cast<size_t>(role)] = static_cast<int>(source.nodes.size());
    source.nodes.push_back({.name = "eye", .parent = 2, .translation = Vec3(x, 0.1, 0.09)});
    source.skins[0].joints.push_back(source.node_of(role));
    source.skins[0].joint_from_mesh.push_back(glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0),
                                                         glm::dvec4(0, 0, 1, 0),
                                                         glm::dvec4(-(head + Vec3(x, 0.1, 0.09)), 1)));
    // A pupil a centimetre before the eye's middle.
    const Vec3 pupil = head + Vec3(x, 0.1, 0.1);
    test::add_box(source.meshes[0].vertices[0], source.meshes[0].surfaces[0], pupil - Vec3(1e-4), pupil + Vec3(1e-4),
                  static_cast<int>(source.skins[0].joints.size()) - 1);
  }
  Posed posed(std::move(source));
  posed.channel(FaceChannel::kEyeLookUpLeft) = posed.channel(FaceChannel::kEyeLookUpRight) = 1.0F;
  posed.channel(FaceChannel::kEyeLookOutLeft) = posed.channel(FaceChannel::kEyeLookInRight) = 1.0F;
  posed.pose();
  size_t pupils = 0;
  for (const Vec3& vertex : posed.vertices("head_base")) {
    const Vec3 from = vertex - posed.rest("head_base");
    for (const double x : {0.03, -0.03}) {
      const Vec3 gaze = from - Vec3(x, 0.1, 0.09);
      const double reach = std::sqrt(glm::dot(gaze, gaze));
      if (reach > 0.0105) continue;
      ++pupils;
      // Up and to the signer's left, and as far from the middle as before.
      EXPECT_NEAR(reach, 0.01, 3e-4);
      EXPECT_GT(gaze.y, 0.003);
      EXPECT_GT(gaze.x, 0.003);
      EXPECT_GT(gaze.z, 0.005);
    }
  }
  EXPECT_EQ(pupils, 16U);
}

TEST(AvatarModel, ARevisionTellsWhatChanged) {
  Posed posed(box_avatar());
  posed.pose();
  std::vector<uint64_t> before;
  for (const PosedMesh& mesh : posed.meshes())
    before.push_back(mesh.revision);
  posed.pose();
  for (size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(posed.meshes()[i].revision, before[i]);
  posed.rotation("wrist_r") = axis_angle(Vec3(0.0, 0.0, 1.0), 0.4);
  posed.pose();
  for (size_t i = 0; i < before.size(); ++i) {
    const std::string& name = posed.skeleton().node(posed.meshes()[i].node).name;
    const bool is_hand = name.ends_with("_r") && name != "shoulder_r" && name != "elbow_r";
    EXPECT_EQ(posed.meshes()[i].revision != before[i], is_hand) << name;
  }
}

TEST(AvatarModel, BothSidesOfADoubleSidedSurfaceFaceOutwards) {
  Avatar source = box_avatar();
  const size_t one_sided = source.meshes[0].surfaces[0].indices.size();
  source.meshes[0].surfaces[0].is_double_sided = true;
  Posed posed(std::move(source));
  posed.pose();
  size_t corners = 0;
  for (const PosedMesh& mesh : posed.meshes()) {
    corners += mesh.indices.size();
    // Winding and normals agree in each copy.
    const auto at = [&](size_t i) { return Vec3(mesh.positions[mesh.indices[i]]); };
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const Vec3 facing = glm::cross(at(i + 1) - at(i), at(i + 2) - at(i));
      EXPECT_GT(glm::dot(facing, Vec3(mesh.normals[mesh.indices[i]])), 0.0);
    }
  }
  EXPECT_EQ(corners, 2 * one_sided);
}

// KHR_texture_transform places coordinates before they are looked up; a colour's own alpha is taken off the cut-off.
TEST(AvatarModel, AnImageLiesWhereItsMaterialPutsIt) {
  Avatar source = box_avatar();
  AvatarVertices& vertices = source.meshes[0].vertices[0];
  AvatarSurface& surface = source.meshes[0].surfaces[0];
  vertices.texture_coordinates.assign(vertices.positions.size(), glm::vec2(0.5F, 0.25F));
  surface.image = 0;
  surface.wrap_u = ImageWrap::kClamp;
  surface.wrap_v = ImageWrap::kMirroredRepeat;
  surface.placement = {
      .origin = glm::vec2(0.125F, 1.0F), .x_axis = glm::vec2(0.0F, -2.0F), .y_axis = glm::vec2(4.0F, 0.0F)};
  surface.base_colour = glm::vec4(1.0F, 0.5F, 0.0F, 0.8F);
  surface.alpha_cutoff = 0.4F;
  source.images.emplace_back();
  Posed posed(std::move(source));
  posed.pose();
  for (const PosedMesh& mesh : posed.meshes()) {
    EXPECT_EQ(mesh.image, 0);
    EXPECT_EQ(mesh.wrap_u, ImageWrap::kClamp);
    EXPECT_EQ(mesh.wrap_v, ImageWrap::kMirroredRepeat);
    EXPECT_FLOAT_EQ(mesh.alpha_cutoff, 0.5F);
    ASSERT_EQ(mesh.texture_coordinates.size(), mesh.positions.size());
    EXPECT_EQ(mesh.texture_coordinates[0], glm::vec2(1.125F, 0.0F));
    // 188 is the sRGB level of half the light.
    EXPECT_EQ(mesh.colours[0], glm::u8vec4(255, 188, 0, 255));
  }
}

}  // namespace
}  // namespace auslan
