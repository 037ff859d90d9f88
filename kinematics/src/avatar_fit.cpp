// SPDX-License-Identifier: Apache-2.0
#include "avatar_fit.h"

#include "kinematics/rotation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace auslan {
namespace fit {

using enum HumanRole;

namespace {

constexpr size_t kFirstArm = 3;
constexpr size_t kNodesPerArm = 18;

constexpr size_t index(HumanRole role) {
  return static_cast<size_t>(role);
}

Vec3 place_of(std::span<const glm::dmat4> world_from_node, int node) {
  return Vec3(world_from_node[static_cast<size_t>(node)][3]);
}

std::vector<glm::dmat4> nodes_at_rest(const Avatar& avatar) {
  std::vector<glm::dmat4> world(avatar.nodes.size());
  place_nodes(avatar, rest_pose(avatar), world);
  return world;
}

}  // namespace

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

glm::dmat4 matrix(const Transform& transform) {
  const Mat3 turned = glm::mat3_cast(transform.rotation);
  return {glm::dvec4(turned[0], 0.0), glm::dvec4(turned[1], 0.0), glm::dvec4(turned[2], 0.0),
          glm::dvec4(transform.position, 1.0)};
}

ArmNodes named_arm(Side side) {
  const auto first = static_cast<int>(kFirstArm + (side == Side::kLeft ? 0 : kNodesPerArm));
  ArmNodes nodes{.shoulder = first, .elbow = first + 1, .wrist = first + 2, .digits = {}};
  for (size_t digit = 0; digit < 5; ++digit)
    for (size_t joint = 0; joint < 3; ++joint)
      nodes.digits[digit][joint] = first + 3 + static_cast<int>(3 * digit + joint);
  return nodes;
}

HumanRole digit_role(Side side, size_t digit, size_t joint) {
  const HumanRole first = side == Side::kLeft ? kLeftThumbMetacarpal : kRightThumbMetacarpal;
  return static_cast<HumanRole>(index(first) + 3 * digit + joint);
}

int parent_of(int node) {
  if (node == 0) return kNoNode;
  if (node < static_cast<int>(kFirstArm)) return node - 1;
  const int in_arm = (node - static_cast<int>(kFirstArm)) % static_cast<int>(kNodesPerArm);
  if (in_arm == 0) return 0;
  if (in_arm < 3) return node - 1;
  return (in_arm - 3) % 3 == 0 ? node - in_arm + 2 : node - 1;
}

int driver_of(HumanRole role) {
  switch (role) {
    case kNeck:
      return 1;
    case kHead:
      return 2;
    case kLeftEye:
      return AvatarDriver::kLeftEye;
    case kRightEye:
      return AvatarDriver::kRightEye;
    case kJaw:
      return AvatarDriver::kJaw;
    case kLeftUpperArm:
    case kLeftLowerArm:
    case kLeftHand:
      return static_cast<int>(kFirstArm + index(role) - index(kLeftUpperArm));
    case kRightUpperArm:
    case kRightLowerArm:
    case kRightHand:
      return static_cast<int>(kFirstArm + kNodesPerArm + index(role) - index(kRightUpperArm));
    default:
      break;
  }
  if (role >= kLeftUpperLeg && role <= kRightToes) return AvatarDriver::kGround;
  if (role >= kRightThumbMetacarpal)
    return static_cast<int>(kFirstArm + kNodesPerArm + 3 + index(role) - index(kRightThumbMetacarpal));
  if (role >= kLeftThumbMetacarpal) return static_cast<int>(kFirstArm + 3 + index(role) - index(kLeftThumbMetacarpal));
  return 0;  // hips, spine, chest and shoulder blades: the trunk is one
}

std::vector<int> drivers(const Avatar& avatar) {
  std::vector<int> found(avatar.nodes.size(), AvatarDriver::kGround);
  std::vector<int> of_role(avatar.nodes.size(), kNoNode);
  for (size_t r = 0; r < kHumanRoleCount; ++r)
    if (avatar.human_node[r] != kNoNode)
      of_role[static_cast<size_t>(avatar.human_node[r])] = driver_of(static_cast<HumanRole>(r));
  for (size_t i = 0; i < found.size(); ++i) {
    const int parent = avatar.nodes[i].parent;
    if (of_role[i] != kNoNode)
      found[i] = of_role[i];
    else if (parent != kNoNode)
      found[i] = found[static_cast<size_t>(parent)];
  }
  return found;
}

std::vector<Skin> main_drivers(const Avatar& avatar, std::span<const AvatarPoser::Part> parts,
                               std::span<const int> driver) {
  std::vector<Skin> skins;
  for (const AvatarPoser::Part& part : parts) {
    const AvatarNode& node = avatar.nodes[static_cast<size_t>(part.node)];
    const AvatarVertices& vertices =
        avatar.meshes[static_cast<size_t>(part.mesh)].vertices[static_cast<size_t>(part.vertices)];
    Skin skin;
    skin.driver.assign(vertices.positions.size(), driver[static_cast<size_t>(part.node)]);
    if (node.skin >= 0 && !vertices.joints.empty()) {
      const std::vector<int>& joints = avatar.skins[static_cast<size_t>(node.skin)].joints;
      for (size_t i = 0; i < skin.driver.size(); ++i) {
        float most = 0.0F;
        for (int k = 0; k < 4; ++k) {
          const int of_joint = driver[static_cast<size_t>(joints[vertices.joints[i][k]])];
          float sum = 0.0F;
          for (int other = 0; other < 4; ++other)
            if (driver[static_cast<size_t>(joints[vertices.joints[i][other]])] == of_joint)
              sum += vertices.weights[i][other];
          if (sum <= most) continue;
          most = sum;
          skin.driver[i] = of_joint;
        }
      }
    }
    skins.push_back(std::move(skin));
  }
  return skins;
}

Result<double> normalise(Avatar& avatar) {
  const std::vector<glm::dmat4> world = nodes_at_rest(avatar);
  const auto at = [&](HumanRole role) { return place_of(world, avatar.node_of(role)); };
  const Vec3 left = at(kLeftUpperArm);
  const Vec3 right = at(kRightUpperArm);
  const Vec3 middle = 0.5 * (left + right);
  const double arm = 0.5 * (length(at(kLeftLowerArm) - left) + length(at(kLeftHand) - at(kLeftLowerArm)) +
                            length(at(kRightLowerArm) - right) + length(at(kRightHand) - at(kRightLowerArm)));
  const double breadth = length(left - right);
  if (!(arm > 1e-6) || !(breadth > 0.02 * arm))
    return fail(ErrorCode::kUnsupported,
                "the joints of the arms lie on each other, so that the figure has no size; check its skeleton");
  // What is measured on a figure is measured in steps of centimetres: none is a hundred arms wide.
  constexpr double kMostArms = 8.0;
  const int hips = avatar.node_of(kHips);
  const double tall = std::max(length(at(kHead) - middle), hips == kNoNode ? 0.0 : length(at(kHips) - middle));
  if (!(breadth < kMostArms * arm) || !(tall < kMostArms * arm))
    return fail(ErrorCode::kUnsupported,
                "head, hips or shoulders are more than eight arms' lengths apart: this is not the build of a body");
  // Upright as glTF asks, unless the figure plainly lies or hangs: then from hips to head.
  constexpr double kUpright = 0.7;
  Vec3 up(0.0, 1.0, 0.0);
  const Vec3 trunk = unit(at(kHead) - (hips == kNoNode ? middle : at(kHips)), up);
  if (trunk.y < kUpright) up = trunk;
  const Vec3 across = unit(left - right);
  const Vec3 level = across - up * glm::dot(across, up);
  if (!(length(level) > 0.2))
    return fail(ErrorCode::kUnsupported,
                "the shoulders lie above each other, so that nothing tells where the figure looks; check its skeleton");
  const Quat turn = rotation_between_frames(unit(level), up, Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0));
  const double scale = kSigningArmLength / arm;

  AvatarPoser poser(avatar);
  poser.pose(rest_pose(avatar));
  const Vec3 centre = turn * middle * scale;
  double lowest = centre.y;
  for (const AvatarPoser::Part& part : poser.parts())
    for (const glm::vec3& position : part.positions)
      lowest = std::min(lowest, (turn * Vec3(position)).y * scale);
  // The shoulders stand as far behind the middle of the trunk as in the built-in figure.
  constexpr double kShoulderDepth = 0.014;
  const Vec3 shift(-centre.x, -lowest, -kShoulderDepth - centre.z);
  for (AvatarNode& node : avatar.nodes) {
    if (node.parent != kNoNode) continue;
    node.translation = turn * node.translation * scale + shift;
    node.rotation = turn * node.rotation;
    node.scale *= scale;
  }
  return scale;
}

Skeleton skeleton_of(const Joints& joints, std::span<const Transform> rest_from_file) {
  std::vector<Node> nodes;
  std::array<Vec3, kNodes> rest;
  for (size_t n = 0; n < kNodes; ++n) {
    rest[n] = apply(rest_from_file[n], joints.place[n]);
    const int parent = parent_of(static_cast<int>(n));
    nodes.push_back({.name = std::string(kNodeNames[n]),
                     .parent = parent,
                     .offset = parent == kNoNode ? rest[n] : rest[n] - rest[static_cast<size_t>(parent)]});
  }
  // Names and parents are those of the contract, and positions of a figure that was read are finite.
  return *Skeleton::build(std::move(nodes));
}

namespace {

/// A joint of a skin that follows another driver than its own.
struct Retarget {
  int joint, driver, copy;
};

/// The bone of a twisting node: where it begins, its direction, its length.
struct TwistBone {
  int node = kNoNode;
  Vec3 begin, axis;
  double length = 0.0;
  int first_driver = 0;
};

std::vector<TwistBone> twist_bones(const Skeleton& skeleton) {
  std::vector<TwistBone> bones;
  for (size_t i = 0; i < AvatarDriver::kTwistNodes.size(); ++i) {
    TwistBone bone;
    bone.node = skeleton.find(AvatarDriver::kTwistNodes[i]);
    bone.begin = skeleton.rest_position(bone.node);
    const Vec3 offset = skeleton.node(bone.node + 1).offset;  // the next node of the arm
    bone.length = length(offset);
    bone.axis = unit(offset);
    bone.first_driver = AvatarDriver::kFirstTwist + static_cast<int>(i) * (AvatarDriver::kTwistSteps + 1);
    bones.push_back(bone);
  }
  return bones;
}

}  // namespace

void add_twist(SigningAvatar& fitted) {
  Avatar& avatar = fitted.avatar;
  const std::vector<TwistBone> bones = twist_bones(fitted.figure.skeleton);
  // Vertices of a mesh that two nodes show would need two lists of joints.
  std::vector<int> shown(avatar.meshes.size(), 0);
  for (const AvatarNode& node : avatar.nodes)
    if (node.mesh >= 0) ++shown[static_cast<size_t>(node.mesh)];
  std::vector<std::vector<Retarget>> retargets(avatar.skins.size());
  AvatarPoser poser(avatar);
  poser.place(fitted.world_from_node, rest_pose(avatar).morph_weights);
  for (const AvatarPoser::Part& part : poser.parts()) {
    const int skin_index = avatar.nodes[static_cast<size_t>(part.node)].skin;
    AvatarVertices& vertices =
        avatar.meshes[static_cast<size_t>(part.mesh)].vertices[static_cast<size_t>(part.vertices)];
    if (skin_index < 0 || vertices.joints.empty() || shown[static_cast<size_t>(part.mesh)] != 1) continue;
    AvatarSkin& skin = avatar.skins[static_cast<size_t>(skin_index)];
    std::vector<Retarget>& known = retargets[static_cast<size_t>(skin_index)];
    for (size_t i = 0; i < vertices.joints.size(); ++i)
      for (int k = 0; k < 4; ++k) {
        if (!(vertices.weights[i][k] > 0.0F)) continue;
        const int joint = vertices.joints[i][k];
        const int node = skin.joints[static_cast<size_t>(joint)];
        const int driver = fitted.driver[static_cast<size_t>(node)];
        const auto bone = std::ranges::find(bones, driver, &TwistBone::node);
        if (bone == bones.end()) continue;
        const double along = glm::dot(Vec3(part.positions[i]) - bone->begin, bone->axis) / bone->length;
        const auto step = static_cast<int>(std::clamp(along, 0.0, 1.0) * AvatarDriver::kTwistSteps + 0.5);
        const int wanted = bone->first_driver + step;
        auto found = std::ranges::find_if(
            known, [&](const Retarget& each) { return each.joint == joint && each.driver == wanted; });
        if (found == known.end()) {
          if (skin.joints.size() > 0xFFFF) continue;
          known.push_back({.joint = joint, .driver = wanted, .copy = static_cast<int>(skin.joints.size())});
          found = known.end() - 1;
          avatar.nodes.push_back({.name = "", .parent = kNoNode});
          fitted.world_from_node.push_back(fitted.world_from_node[static_cast<size_t>(node)]);
          fitted.driver.push_back(wanted);
          skin.joints.push_back(static_cast<int>(avatar.nodes.size()) - 1);
          skin.joint_from_mesh.push_back(skin.joint_from_mesh[static_cast<size_t>(joint)]);
        }
        vertices.joints[i][k] = static_cast<uint16_t>(found->copy);
      }
  }
}

namespace {

/// Whether a node moves any vertex.
std::vector<bool> moving_nodes(const Avatar& avatar) {
  std::vector<bool> moves(avatar.nodes.size(), false);
  for (const AvatarNode& node : avatar.nodes) {
    if (node.mesh < 0 || node.skin < 0) continue;
    const std::vector<int>& joints = avatar.skins[static_cast<size_t>(node.skin)].joints;
    for (const AvatarVertices& vertices : avatar.meshes[static_cast<size_t>(node.mesh)].vertices)
      for (size_t i = 0; i < vertices.joints.size(); ++i)
        for (int k = 0; k < 4; ++k)
          if (vertices.weights[i][k] > 0.0F) moves[static_cast<size_t>(joints[vertices.joints[i][k]])] = true;
  }
  return moves;
}

/// A finger whose last joints are not named but there: the only moving child plays the part.
void adopt_phalanges(Avatar& avatar) {
  const std::vector<bool> moves = moving_nodes(avatar);
  std::vector<int> only_child(avatar.nodes.size(), kNoNode);
  std::vector<int> children(avatar.nodes.size(), 0);
  for (size_t i = 0; i < avatar.nodes.size(); ++i) {
    const int parent = avatar.nodes[i].parent;
    if (parent == kNoNode || !moves[i]) continue;
    ++children[static_cast<size_t>(parent)];
    only_child[static_cast<size_t>(parent)] = static_cast<int>(i);
  }
  for (size_t s = 0; s < 2; ++s)
    for (size_t digit = 0; digit < 5; ++digit)
      for (size_t joint = 1; joint < 3; ++joint) {
        const int above = avatar.node_of(digit_role(side_of(s), digit, joint - 1));
        int& node = avatar.human_node[index(digit_role(side_of(s), digit, joint))];
        if (node != kNoNode || above == kNoNode || children[static_cast<size_t>(above)] != 1) continue;
        const int child = only_child[static_cast<size_t>(above)];
        if (std::ranges::find(avatar.human_node, child) == avatar.human_node.end()) node = child;
      }
}

Result<void> check_parts(const Avatar& avatar) {
  if (std::ranges::all_of(avatar.human_node, [](int node) { return node == kNoNode; }))
    return fail(ErrorCode::kUnsupported,
                "the figure is no humanoid that is known: it has no VRM map, and no node has the name of a bone; "
                "`auslanjam avatar FILE --help` tells which names are known");
  std::string lacking;
  for (const HumanRole role :
       {kHead, kLeftUpperArm, kLeftLowerArm, kLeftHand, kRightUpperArm, kRightLowerArm, kRightHand})
    if (avatar.node_of(role) == kNoNode) lacking += (lacking.empty() ? "" : ", ") + std::string(name_of(role));
  if (lacking.empty()) return {};
  return fail(ErrorCode::kUnsupported,
              "the figure cannot sign: it lacks " + lacking + "; signs need a head, both arms and both hands");
}

}  // namespace
}  // namespace fit

Result<SigningAvatar> fit_avatar(Avatar avatar) {
  if (auto checked = fit::check_parts(avatar); !checked) return tl::unexpected<Error>(checked.error());
  fit::adopt_phalanges(avatar);
  const auto scale = fit::normalise(avatar);
  if (!scale) return tl::unexpected<Error>(scale.error());
  SigningAvatar fitted;
  fitted.scale = *scale;
  fitted.avatar = std::move(avatar);
  fitted.driver = fit::drivers(fitted.avatar);

  AvatarPoser poser(fitted.avatar);
  const AvatarPose rest = rest_pose(fitted.avatar);
  poser.pose(rest);
  const std::vector<fit::Skin> skins = fit::main_drivers(fitted.avatar, poser.parts(), fitted.driver);
  const fit::Joints joints =
      fit::find_joints(fitted.avatar, poser.world_from_node(), poser.parts(), skins, fitted.warnings);
  const auto rest_from_file = fit::pose_for_rest(joints, poser.parts(), skins);
  fitted.figure.name = fitted.avatar.name;
  fitted.figure.skeleton = fit::skeleton_of(joints, rest_from_file);
  for (size_t i = 0; i < fitted.avatar.nodes.size(); ++i) {
    const auto driver = static_cast<size_t>(fitted.driver[i]);
    const glm::dmat4& world = poser.world_from_node()[i];
    fitted.world_from_node.push_back(driver < fit::kNodes ? fit::matrix(rest_from_file[driver]) * world : world);
  }
  for (size_t i = 0; i < 3; ++i) {
    const int node = fitted.avatar.node_of(static_cast<HumanRole>(static_cast<size_t>(HumanRole::kLeftEye) + i));
    fitted.has_bone[i] = node != kNoNode;
    if (node != kNoNode) fitted.pivot[i] = Vec3(fitted.world_from_node[static_cast<size_t>(node)][3]);
  }
  poser.place(fitted.world_from_node, rest.morph_weights);
  fit::cut_surface(fitted, poser.parts(), skins);
  fit::measure_face(fitted, poser.parts());
  fit::add_twist(fitted);
  return fitted;
}

}  // namespace auslan
