// SPDX-License-Identifier: Apache-2.0
#include "vrm.h"

#include <algorithm>
#include <optional>
#include <tiny_gltf.h>
#include <utility>

namespace auslan::gltf {
namespace {

using tinygltf::Value;

/// A member, or null. Asked first: tinygltf asserts where it is no object.
const Value& member(const Value& object, const char* key) {
  static const Value kNull;
  return object.IsObject() ? object.Get(key) : kNull;
}

std::string text_of(const Value& value) {
  return value.IsString() ? value.Get<std::string>() : std::string();
}

std::string first_of(std::string a, std::string b) {
  return a.empty() ? b : a;
}

/// A whole number; tinygltf keeps those that a file writes without a point as int.
std::optional<int> whole(const Value& value) {
  if (value.IsInt()) return value.GetNumberAsInt();
  return std::nullopt;
}

double fraction(const Value& value, double whole_weight) {
  return value.IsNumber() ? std::clamp(value.GetNumberAsDouble() / whole_weight, 0.0, 1.0) : 1.0;
}

Result<void> add_bone(const std::string& bone, const Value& node, const std::string& place,
                      std::span<const int> node_of_source, Avatar& avatar, Warnings& warnings) {
  const std::optional<HumanRole> role = human_role(bone);
  if (!role) {
    warnings.add("the humanoid map names a bone that VRM does not have: " + shortened(bone));
    return {};
  }
  const std::optional<int> index = whole(node);
  if (index == -1) return {};  // how some exporters of VRM 0 leave a bone out
  if (!index || *index < 0 || static_cast<size_t>(*index) >= node_of_source.size())
    return fail(ErrorCode::kMalformed, "the humanoid map gives " + bone + " a node that does not exist", place);
  int& found = avatar.human_node[static_cast<size_t>(*role)];
  const int given = node_of_source[static_cast<size_t>(*index)];
  if (found != kNoNode) {
    warnings.add("the humanoid map has " + bone + " twice; the first counts");
    return {};
  }
  if (std::ranges::find(avatar.human_node, given) != avatar.human_node.end()) {
    warnings.add("the humanoid map gives the node of " + bone + " to another bone too; that one keeps it");
    return {};
  }
  found = given;
  return {};
}

/// VRM 0 names the thumb's bones as those of the fingers: its proximal is VRM 1's metacarpal.
std::string vrm1_bone(std::string bone) {
  for (const std::string side : {"left", "right"}) {
    if (bone == side + "ThumbProximal") return side + "ThumbMetacarpal";
    if (bone == side + "ThumbIntermediate") return side + "ThumbProximal";
  }
  return bone;
}

void add_bind(int mesh, const Value& morph, double weight, AvatarExpression& expression, const Avatar& avatar,
              Warnings& warnings) {
  const std::optional<int> index = whole(morph);
  if (mesh < 0 || static_cast<size_t>(mesh) >= avatar.meshes.size() || !index || *index < 0 ||
      static_cast<size_t>(*index) >= avatar.meshes[static_cast<size_t>(mesh)].morph_names.size()) {
    warnings.add("the expression " + shortened(expression.name) +
                 " names a morph target that does not exist; it does without");
    return;
  }
  if (weight > 0.0) expression.binds.push_back({.mesh = mesh, .morph = *index, .weight = weight});
}

/// VRM 1's name of a preset of VRM 0, or nothing.
std::string_view vrm1_expression(std::string_view preset) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 17> kNames = {{{"a", "aa"},
                                                                                     {"i", "ih"},
                                                                                     {"u", "ou"},
                                                                                     {"e", "ee"},
                                                                                     {"o", "oh"},
                                                                                     {"blink", "blink"},
                                                                                     {"blink_l", "blinkLeft"},
                                                                                     {"blink_r", "blinkRight"},
                                                                                     {"joy", "happy"},
                                                                                     {"angry", "angry"},
                                                                                     {"sorrow", "sad"},
                                                                                     {"fun", "relaxed"},
                                                                                     {"lookup", "lookUp"},
                                                                                     {"lookdown", "lookDown"},
                                                                                     {"lookleft", "lookLeft"},
                                                                                     {"lookright", "lookRight"},
                                                                                     {"neutral", "neutral"}}};
  std::string lower(preset);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const auto& [old_name, name] : kNames)
    if (lower == old_name) return name;
  return {};
}

Result<void> read_vrm0(const Value& vrm, std::span<const int> node_of_source, Avatar& avatar, Warnings& warnings) {
  const Value& bones = member(member(vrm, "humanoid"), "humanBones");
  for (size_t i = 0; i < bones.ArrayLen(); ++i) {
    const Value& bone = bones.Get(static_cast<int>(i));
    if (auto added = add_bone(vrm1_bone(text_of(member(bone, "bone"))), member(bone, "node"),
                              "VRM.humanoid.humanBones[" + std::to_string(i) + "]", node_of_source, avatar, warnings);
        !added)
      return added;
  }
  const Value& groups = member(member(vrm, "blendShapeMaster"), "blendShapeGroups");
  for (size_t i = 0; i < groups.ArrayLen(); ++i) {
    const Value& group = groups.Get(static_cast<int>(i));
    AvatarExpression expression;
    expression.name = vrm1_expression(text_of(member(group, "presetName")));
    expression.is_preset = !expression.name.empty();
    if (!expression.is_preset) expression.name = text_of(member(group, "name"));
    expression.changes_materials = member(group, "materialValues").ArrayLen() > 0;
    const Value& binds = member(group, "binds");
    for (size_t b = 0; b < binds.ArrayLen(); ++b) {
      const Value& bind = binds.Get(static_cast<int>(b));
      add_bind(whole(member(bind, "mesh")).value_or(-1), member(bind, "index"), fraction(member(bind, "weight"), 100.0),
               expression, avatar, warnings);
    }
    avatar.expressions.push_back(std::move(expression));
  }
  return {};
}

void read_vrm1_expressions(const Value& expressions, bool are_presets, std::span<const int> node_of_source,
                           Avatar& avatar, Warnings& warnings) {
  for (const std::string& name : expressions.Keys()) {
    const Value& source = member(expressions, name.c_str());
    AvatarExpression expression{.name = name, .is_preset = are_presets, .binds = {}};
    expression.changes_materials =
        member(source, "materialColorBinds").ArrayLen() + member(source, "textureTransformBinds").ArrayLen() > 0;
    const Value& binds = member(source, "morphTargetBinds");
    for (size_t b = 0; b < binds.ArrayLen(); ++b) {
      const Value& bind = binds.Get(static_cast<int>(b));
      const int node = whole(member(bind, "node")).value_or(-1);
      const bool exists = node >= 0 && static_cast<size_t>(node) < node_of_source.size();
      const int mesh = exists ? avatar.nodes[static_cast<size_t>(node_of_source[static_cast<size_t>(node)])].mesh : -1;
      add_bind(mesh, member(bind, "index"), fraction(member(bind, "weight"), 1.0), expression, avatar, warnings);
    }
    avatar.expressions.push_back(std::move(expression));
  }
}

Result<void> read_vrm1(const Value& vrm, std::span<const int> node_of_source, Avatar& avatar, Warnings& warnings) {
  const Value& bones = member(member(vrm, "humanoid"), "humanBones");
  for (const std::string& name : bones.Keys())
    if (auto added = add_bone(name, member(member(bones, name.c_str()), "node"), "VRMC_vrm.humanoid.humanBones." + name,
                              node_of_source, avatar, warnings);
        !added)
      return added;
  const Value& expressions = member(vrm, "expressions");
  read_vrm1_expressions(member(expressions, "preset"), true, node_of_source, avatar, warnings);
  read_vrm1_expressions(member(expressions, "custom"), false, node_of_source, avatar, warnings);
  return {};
}

}  // namespace

Result<void> read_vrm(const tinygltf::Model& model, std::span<const int> node_of_source, Avatar& avatar,
                      Warnings& warnings) {
  avatar.human_node.fill(kNoNode);
  if (const auto vrm1 = model.extensions.find("VRMC_vrm"); vrm1 != model.extensions.end()) {
    avatar.kind = Avatar::Kind::kVrm1;
    const Value& meta = member(vrm1->second, "meta");
    avatar.name = text_of(member(meta, "name"));
    const Value& authors = member(meta, "authors");
    for (size_t i = 0; i < authors.ArrayLen(); ++i)
      avatar.author += (i == 0 ? "" : ", ") + text_of(authors.Get(static_cast<int>(i)));
    avatar.licence = first_of(text_of(member(meta, "otherLicenseUrl")), text_of(member(meta, "licenseUrl")));
    return read_vrm1(vrm1->second, node_of_source, avatar, warnings);
  }
  if (const auto vrm0 = model.extensions.find("VRM"); vrm0 != model.extensions.end()) {
    avatar.kind = Avatar::Kind::kVrm0;
    const Value& meta = member(vrm0->second, "meta");
    avatar.name = text_of(member(meta, "title"));
    avatar.author = text_of(member(meta, "author"));
    avatar.licence = first_of(text_of(member(meta, "otherLicenseUrl")), text_of(member(meta, "licenseName")));
    return read_vrm0(vrm0->second, node_of_source, avatar, warnings);
  }
  avatar.licence = model.asset.copyright;
  return {};
}

}  // namespace auslan::gltf
