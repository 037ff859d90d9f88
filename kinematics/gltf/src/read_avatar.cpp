// SPDX-License-Identifier: Apache-2.0
#include "avatar_mesh.h"
#include "container.h"
#include "gltf/avatar_gltf.h"
#include "gltf/figure_gltf.h"
#include "kinematics/avatar_pose.h"
#include "kinematics/whole_file.h"
#include "load_model.h"
#include "vrm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace auslan {
namespace {

using gltf::place_of;
using gltf::Warnings;

/// Extensions that may be required: read, or such that the figure is still itself without them.
constexpr std::array<std::string_view, 24> kKnownExtensions = {"VRM",
                                                               "VRMC_vrm",
                                                               "VRMC_materials_mtoon",
                                                               "VRMC_materials_hdr_emissiveMultiplier",
                                                               "VRMC_springBone",
                                                               "VRMC_node_constraint",
                                                               "KHR_materials_unlit",
                                                               "KHR_materials_emissive_strength",
                                                               "KHR_materials_specular",
                                                               "KHR_materials_ior",
                                                               "KHR_materials_sheen",
                                                               "KHR_materials_clearcoat",
                                                               "KHR_materials_transmission",
                                                               "KHR_materials_volume",
                                                               "KHR_materials_variants",
                                                               "KHR_lights_punctual",
                                                               "KHR_mesh_quantization",
                                                               "KHR_texture_transform",
                                                               "KHR_texture_basisu",
                                                               "KHR_materials_anisotropy",
                                                               "KHR_materials_iridescence",
                                                               "KHR_materials_pbrSpecularGlossiness",
                                                               "KHR_xmp_json_ld",
                                                               "EXT_texture_webp"};
constexpr double kMaxNumber = 1e9;  ///< of a node's translation, scale or matrix; the world is bounded later

tl::unexpected<Error> malformed(std::string message, std::string place) {
  return fail(ErrorCode::kMalformed, std::move(message), std::move(place));
}

bool is_size(const std::vector<double>& values, size_t size) {
  return values.empty() || (values.size() == size &&
                            std::ranges::all_of(values, [](double value) { return std::fabs(value) <= kMaxNumber; }));
}

std::optional<Quat> unit_quaternion(const Quat& q) {
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!(length > 1e-6)) return std::nullopt;
  return Quat(q.w / length, q.x / length, q.y / length, q.z / length);
}

/// A matrix as translation, rotation and scale. Shear is lost, with a warning.
void decompose(const std::vector<double>& matrix, AvatarNode& node, Warnings& warnings) {
  node.translation = Vec3(matrix[12], matrix[13], matrix[14]);
  Mat3 columns;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      columns[c][r] = matrix[static_cast<size_t>(4 * c + r)];
  Vec3& x = columns[0];
  Vec3& y = columns[1];
  Vec3& z = columns[2];
  const auto dot = [](const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  const auto cross = [](const Vec3& a, const Vec3& b) {
    return Vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
  };
  node.scale = Vec3(std::sqrt(dot(x, x)), std::sqrt(dot(y, y)), std::sqrt(dot(z, z)));
  if (!(node.scale.x > 0.0 && node.scale.y > 0.0 && node.scale.z > 0.0)) {
    warnings.add("a node is flattened to nothing; it is not turned");
    return;
  }
  if (dot(cross(x, y), z) < 0.0) node.scale.x = -node.scale.x;
  x /= node.scale.x;
  y /= node.scale.y;
  z /= node.scale.z;
  constexpr double kSheared = 1e-4;
  if (std::fabs(dot(x, y)) > kSheared || std::fabs(dot(y, z)) > kSheared || std::fabs(dot(z, x)) > kSheared)
    warnings.add("a node is sheared; it is turned and scaled only");
  // Gram-Schmidt, so that the quaternion is that of a rotation.
  y -= x * dot(x, y);
  const double length = std::sqrt(dot(y, y));
  if (!(length > 1e-9)) return;
  y /= length;
  z = cross(x, y);
  node.rotation = unit_quaternion(glm::quat_cast(columns)).value_or(kIdentity);
}

Result<AvatarNode> read_node(const tinygltf::Node& source, const std::string& place, Warnings& warnings) {
  if (!is_size(source.matrix, 16) || !is_size(source.rotation, 4) || !is_size(source.scale, 3) ||
      !is_size(source.translation, 3))
    return malformed("the matrix, rotation, scale or translation has the wrong number of elements or a huge one",
                     place);
  AvatarNode node;
  node.name = source.name;
  if (!source.matrix.empty()) {
    decompose(source.matrix, node, warnings);
    return node;
  }
  const auto vector = [](const std::vector<double>& v) { return Vec3(v[0], v[1], v[2]); };
  if (!source.translation.empty()) node.translation = vector(source.translation);
  if (!source.scale.empty()) node.scale = vector(source.scale);
  if (source.rotation.empty()) return node;
  const std::vector<double>& q = source.rotation;
  const auto rotation = unit_quaternion(Quat(q[3], q[0], q[1], q[2]));
  if (!rotation) return malformed("the rotation of the node has no length", place);
  node.rotation = *rotation;
  return node;
}

/// All nodes of the file, depth-first from those without a parent. Gives the avatar's index for each of the file.
Result<std::vector<int>> read_nodes(const tinygltf::Model& model, Avatar& avatar, Warnings& warnings) {
  const size_t count = model.nodes.size();
  if (count > kMaxAvatarNodes) return fail(ErrorCode::kLimit, "the file has more than 4096 nodes", "nodes");
  std::vector<int> parent(count, kNoNode);
  for (size_t i = 0; i < count; ++i)
    for (const int child : model.nodes[i].children) {
      // Made on demand: a name may be as long as the file, and a node may have thousands of children.
      const auto place = [&] { return place_of("nodes", static_cast<int>(i), model.nodes[i].name); };
      if (child < 0 || static_cast<size_t>(child) >= count)
        return malformed("the node names a child that does not exist", place());
      if (parent[static_cast<size_t>(child)] != kNoNode)
        return malformed("a child of the node has two parents", place());
      parent[static_cast<size_t>(child)] = static_cast<int>(i);
    }
  std::vector<int> node_of_source(count, kNoNode);
  std::vector<int> waiting;
  for (size_t i = count; i-- > 0;)
    if (parent[i] == kNoNode) waiting.push_back(static_cast<int>(i));
  while (!waiting.empty()) {
    const auto source = static_cast<size_t>(waiting.back());
    waiting.pop_back();
    auto node =
        read_node(model.nodes[source], place_of("nodes", static_cast<int>(source), model.nodes[source].name), warnings);
    if (!node) return tl::unexpected<Error>(std::move(node.error()));
    if (parent[source] != kNoNode) node->parent = node_of_source[static_cast<size_t>(parent[source])];
    node_of_source[source] = static_cast<int>(avatar.nodes.size());
    avatar.nodes.push_back(*std::move(node));
    const std::vector<int>& children = model.nodes[source].children;
    waiting.insert(waiting.end(), children.rbegin(), children.rend());
  }
  for (size_t i = 0; i < count; ++i)
    if (node_of_source[i] == kNoNode)
      return malformed("the node is its own ancestor", place_of("nodes", static_cast<int>(i), model.nodes[i].name));
  return node_of_source;
}

Result<void> read_skins(const tinygltf::Model& model, std::span<const int> node_of_source, gltf::AccessorReader& reader,
                        Avatar& avatar) {
  for (size_t s = 0; s < model.skins.size(); ++s) {
    const tinygltf::Skin& source = model.skins[s];
    const std::string place = place_of("skins", static_cast<int>(s), source.name);
    AvatarSkin skin;
    if (source.joints.empty()) return malformed("the skin has no joints", place);
    if (source.joints.size() > kMaxAvatarNodes)
      return fail(ErrorCode::kLimit, "the skin has more than 4096 joints", place);
    for (const int joint : source.joints) {
      if (joint < 0 || static_cast<size_t>(joint) >= node_of_source.size())
        return malformed("a joint of the skin is a node that does not exist", place);
      skin.joints.push_back(node_of_source[static_cast<size_t>(joint)]);
    }
    skin.joint_from_mesh.assign(skin.joints.size(), glm::dmat4(1.0));
    if (source.inverseBindMatrices >= 0) {
      const auto numbers = reader.elements(source.inverseBindMatrices, 16);
      if (!numbers) return tl::unexpected<Error>(numbers.error());
      if (numbers->size() < 16 * skin.joints.size())
        return malformed("the skin has fewer inverse bind matrices than joints", place);
      for (size_t j = 0; j < skin.joints.size(); ++j)
        for (int k = 0; k < 16; ++k)
          skin.joint_from_mesh[j][k / 4][k % 4] = (*numbers)[16 * j + static_cast<size_t>(k)];
    }
    avatar.skins.push_back(std::move(skin));
  }
  return {};
}

void read_images(tinygltf::Model& model, Avatar& avatar, Warnings& warnings) {
  for (tinygltf::Image& source : model.images) {
    AvatarImage image;
    image.name = source.name.empty() ? source.uri : source.name;
    image.bytes = std::move(source.image);
    if (gltf::is_png(image.bytes.data(), image.bytes.size())) image.format = AvatarImage::Format::kPng;
    if (gltf::is_jpeg(image.bytes.data(), image.bytes.size())) image.format = AvatarImage::Format::kJpeg;
    if (image.bytes.empty())
      warnings.add("the image " + gltf::shortened(image.name) +
                   " is missing or neither PNG nor JPEG; its surfaces keep the base colour alone");
    avatar.images.push_back(std::move(image));
  }
}

/// Which nodes of the file are shown: those of the default scene; all where there is none.
Result<std::vector<bool>> shown_nodes(const tinygltf::Model& model) {
  if (model.scenes.empty()) return std::vector<bool>(model.nodes.size(), true);
  const auto scene = static_cast<size_t>(std::max(model.defaultScene, 0));
  if (scene >= model.scenes.size()) return malformed("the default scene does not exist", "scene");
  std::vector<bool> is_shown(model.nodes.size(), false);
  std::vector<int> waiting = model.scenes[scene].nodes;
  while (!waiting.empty()) {
    const int node = waiting.back();
    waiting.pop_back();
    if (node < 0 || static_cast<size_t>(node) >= model.nodes.size())
      return malformed("the scene names a node that does not exist", "scenes");
    if (is_shown[static_cast<size_t>(node)]) continue;
    is_shown[static_cast<size_t>(node)] = true;
    const std::vector<int>& children = model.nodes[static_cast<size_t>(node)].children;
    waiting.insert(waiting.end(), children.begin(), children.end());
  }
  return is_shown;
}

/// Gives nodes what they show, and checks that a skin has every joint that the vertices name.
Result<void> show_meshes(const tinygltf::Model& model, std::span<const int> node_of_source, Avatar& avatar,
                         Warnings& warnings) {
  const auto is_shown = shown_nodes(model);
  if (!is_shown) return tl::unexpected<Error>(is_shown.error());
  std::vector<size_t> joints_of_mesh;
  for (const AvatarMesh& mesh : avatar.meshes) {
    size_t joints = 0;
    for (const AvatarVertices& vertices : mesh.vertices)
      for (const glm::u16vec4& joint : vertices.joints)
        for (int k = 0; k < 4; ++k)
          joints = std::max(joints, size_t{joint[k]} + 1);
    joints_of_mesh.push_back(joints);
  }
  size_t vertices = 0;
  size_t triangles = 0;
  for (size_t i = 0; i < model.nodes.size(); ++i) {
    const tinygltf::Node& source = model.nodes[i];
    const std::string place = place_of("nodes", static_cast<int>(i), source.name);
    if (source.mesh < 0 || !(*is_shown)[i]) continue;
    if (static_cast<size_t>(source.mesh) >= avatar.meshes.size())
      return malformed("the mesh of the node does not exist", place);
    AvatarNode& node = avatar.nodes[static_cast<size_t>(node_of_source[i])];
    const AvatarMesh& mesh = avatar.meshes[static_cast<size_t>(source.mesh)];
    node.mesh = source.mesh;
    if (source.skin >= 0) {
      if (static_cast<size_t>(source.skin) >= avatar.skins.size())
        return malformed("the skin of the node does not exist", place);
      if (joints_of_mesh[static_cast<size_t>(source.mesh)] >
          avatar.skins[static_cast<size_t>(source.skin)].joints.size())
        return malformed("the vertices of the mesh name a joint that the skin does not have", place);
      node.skin = source.skin;
      if (joints_of_mesh[static_cast<size_t>(source.mesh)] == 0)
        warnings.add("a mesh with a skin has no joints and weights; it moves with its node");
    }
    if (!source.weights.empty()) {
      node.morph_weights.assign(mesh.morph_names.size(), 0.0F);
      for (size_t m = 0; m < node.morph_weights.size() && m < source.weights.size(); ++m)
        node.morph_weights[m] = static_cast<float>(std::clamp(source.weights[m], -1.0, 1.0));
    }
    for (const AvatarVertices& part : mesh.vertices)
      vertices += part.positions.size();
    for (const AvatarSurface& surface : mesh.surfaces)
      triangles += surface.indices.size() / 3;
    if (vertices > kMaxAvatarVertices || triangles > kMaxAvatarTriangles)
      return fail(ErrorCode::kLimit, "the figure shows more than two million vertices or triangles; simplify it",
                  place);
  }
  if (triangles == 0)
    return fail(ErrorCode::kUnsupported, "the file shows no triangles; export the figure with its meshes", "meshes");
  return {};
}

/// Whether one node stands above another.
bool is_ancestor(const Avatar& avatar, int above, int node) {
  while (node > above)
    node = avatar.nodes[static_cast<size_t>(node)].parent;
  return node == above;
}

/// Roles by the names of nodes: all of them without a VRM map; else those that the map lacks, and only where the node
/// is free and lies in the limb that the map gives.
void guess_roles(Avatar& avatar) {
  std::vector<NodeName> names;
  for (const AvatarNode& node : avatar.nodes)
    names.push_back({.name = node.name, .is_bone = node.mesh < 0 || node.skin < 0});
  const NamedHumanoid named = humanoid_from_names(names);
  if (named.rig.empty()) return;
  const bool has_map = std::ranges::any_of(avatar.human_node, [](int node) { return node != kNoNode; });
  if (!has_map) {
    avatar.human_node = named.node;
    avatar.rig = named.rig;
    return;
  }
  for (size_t r = 0; r < kHumanRoleCount; ++r) {
    const int node = named.node[r];
    if (avatar.human_node[r] != kNoNode || node == kNoNode) continue;
    if (std::ranges::find(avatar.human_node, node) != avatar.human_node.end()) continue;
    const auto role = static_cast<HumanRole>(r);
    HumanRole above = HumanRole::kHips;
    if (role >= HumanRole::kRightThumbMetacarpal)
      above = HumanRole::kRightHand;
    else if (role >= HumanRole::kLeftThumbMetacarpal)
      above = HumanRole::kLeftHand;
    else if (role == HumanRole::kLeftEye || role == HumanRole::kRightEye || role == HumanRole::kJaw)
      above = HumanRole::kHead;
    const int limb = avatar.node_of(above);
    if (limb == kNoNode || limb == node || !is_ancestor(avatar, limb, node)) continue;
    avatar.human_node[r] = node;
    avatar.is_guessed[r] = true;
    avatar.rig = named.rig;
  }
}

/// Fingers whose bones do not hang on each other: turning one leaves the next where it was.
void warn_of_flat_hands(const Avatar& avatar, Warnings& warnings) {
  for (auto r = static_cast<size_t>(HumanRole::kLeftThumbMetacarpal); r < kHumanRoleCount; r += 3)
    for (const size_t joint : {r, r + 1}) {
      const int node = avatar.human_node[joint];
      const int next = avatar.human_node[joint + 1];
      if (node == kNoNode || next == kNoNode || is_ancestor(avatar, node, next)) continue;
      warnings.add("the bones of a hand are flat siblings, not chains; a bent finger has to move each of them");
      return;
    }
}

/// The figure at rest lies within kMaxAvatarExtent: no product of huge numbers goes further than this.
Result<void> check_extent(const Avatar& avatar) {
  AvatarPoser poser(avatar);
  poser.pose(rest_pose(avatar));
  for (size_t i = 0; i < avatar.nodes.size(); ++i)
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 3; ++r)
        if (!(std::fabs(poser.world_from_node()[i][c][r]) <= kMaxAvatarExtent))
          return malformed("the node lies or is scaled beyond a million metres at rest", avatar.nodes[i].name);
  for (const AvatarPoser::Part& part : poser.parts())
    for (const glm::vec3& position : part.positions)
      for (int c = 0; c < 3; ++c)
        if (!(std::fabs(static_cast<double>(position[c])) <= kMaxAvatarExtent))
          return malformed("a vertex of the mesh lies beyond a million metres at rest",
                           place_of("meshes", part.mesh, avatar.meshes[static_cast<size_t>(part.mesh)].name));
  return {};
}

void warn_of_what_is_ignored(const tinygltf::Model& model, const Avatar& avatar, Warnings& warnings) {
  if (!model.animations.empty()) warnings.add("animations in the file are not played");
  if (std::ranges::find(model.extensionsUsed, "VRMC_node_constraint") != model.extensionsUsed.end())
    warnings.add("bones that follow other bones (constraints, for twist) stay where they rest");
  if (model.extensions.contains("VRMC_springBone")) warnings.add("hair and clothes do not swing (spring bones)");
  if (const auto vrm0 = model.extensions.find("VRM"); vrm0 != model.extensions.end() && vrm0->second.IsObject()) {
    const tinygltf::Value& swinging = vrm0->second.Get("secondaryAnimation");
    if (swinging.IsObject() && swinging.Get("boneGroups").ArrayLen() > 0)
      warnings.add("hair and clothes do not swing (spring bones)");
    const tinygltf::Value& materials = vrm0->second.Get("materialProperties");
    for (size_t i = 0; i < materials.ArrayLen(); ++i) {
      const tinygltf::Value& material = materials.Get(static_cast<int>(i));
      if (!material.IsObject()) continue;
      const tinygltf::Value& shader = material.Get("shader");
      if (shader.IsString() && shader.Get<std::string>() == "VRM/MToon")
        warnings.add("surfaces are shaded as toons (MToon); they are drawn plain");
    }
  }
  if (std::ranges::any_of(avatar.expressions, &AvatarExpression::changes_materials))
    warnings.add("expressions that change colours or images only move the face");
}

Result<Avatar> build_avatar(tinygltf::Model& model) {
  Avatar avatar;
  Warnings warnings(avatar.warnings);
  auto node_of_source = read_nodes(model, avatar, warnings);
  if (!node_of_source) return tl::unexpected<Error>(std::move(node_of_source.error()));
  gltf::AccessorReader reader(model);
  size_t triangles_left = kMaxAvatarTriangles;
  for (size_t i = 0; i < model.meshes.size(); ++i) {
    auto mesh = gltf::read_avatar_mesh(model, static_cast<int>(i), reader, triangles_left, warnings);
    if (!mesh) return tl::unexpected<Error>(std::move(mesh.error()));
    avatar.meshes.push_back(*std::move(mesh));
  }
  if (auto read = read_skins(model, *node_of_source, reader, avatar); !read)
    return tl::unexpected<Error>(std::move(read.error()));
  read_images(model, avatar, warnings);
  if (auto shown = show_meshes(model, *node_of_source, avatar, warnings); !shown)
    return tl::unexpected<Error>(std::move(shown.error()));
  if (auto checked = check_extent(avatar); !checked) return tl::unexpected<Error>(std::move(checked.error()));
  if (auto read = gltf::read_vrm(model, *node_of_source, avatar, warnings); !read)
    return tl::unexpected<Error>(std::move(read.error()));
  guess_roles(avatar);
  drive_face(avatar);
  warn_of_flat_hands(avatar, warnings);
  warn_of_what_is_ignored(model, avatar, warnings);
  return avatar;
}

}  // namespace

Result<Avatar> parse_avatar(std::span<const std::byte> bytes, const std::filesystem::path& folder) {
  return gltf::without_exceptions([&]() -> Result<Avatar> {
    auto model = gltf::load_model(bytes, folder, {.known_extensions = kKnownExtensions, .keeps_images = true});
    if (!model) return tl::unexpected<Error>(std::move(model.error()));
    return build_avatar(*model);
  });
}

Result<Avatar> read_avatar(const std::filesystem::path& path) {
  const auto bytes = read_whole_file(path, kMaxGltfBytes);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  auto avatar = parse_avatar(std::as_bytes(std::span(*bytes)), path.parent_path());
  if (!avatar) avatar.error().place = gltf::place_in_file(path, avatar.error().place);
  return avatar;
}

}  // namespace auslan
