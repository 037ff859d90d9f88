// SPDX-License-Identifier: Apache-2.0
// `avatar`: what a figure of another maker has, and what it lacks for signing.
#include "commands.h"
#include "gltf/avatar_gltf.h"
#include "kinematics/avatar_pose.h"
#include "kinematics/elementary.h"
#include "kinematics/signing_avatar.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace auslan {
namespace {

using Json = nlohmann::ordered_json;
using enum HumanRole;

/// Text of a file, fit for a terminal: no control characters, not endless.
std::string shown(std::string_view text, size_t most_bytes = 80) {
  std::string out;
  for (const char c : text) {
    // Whole UTF-8 sequences only.
    if (out.size() >= most_bytes && (static_cast<unsigned char>(c) & 0xC0U) != 0x80U) return out + "...";
    out += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  }
  return out;
}

std::string_view name_of(Avatar::Kind kind) {
  switch (kind) {
    case Avatar::Kind::kVrm0:
      return "VRM 0";
    case Avatar::Kind::kVrm1:
      return "VRM 1";
    default:
      return "glTF";
  }
}

std::string_view name_of(FaceDrive::Means means) {
  switch (means) {
    case FaceDrive::Means::kMorph:
      return "morph";
    case FaceDrive::Means::kExpression:
      return "expression";
    case FaceDrive::Means::kBone:
      return "bone";
    default:
      return "none";
  }
}

std::string_view name_of(AvatarImage::Format format) {
  switch (format) {
    case AvatarImage::Format::kPng:
      return "PNG";
    case AvatarImage::Format::kJpeg:
      return "JPEG";
    default:
      return "not read";
  }
}

/// Roles that stand in one line of the answer.
struct Group {
  std::string_view name;
  HumanRole first, last;
};
constexpr std::array<Group, 16> kGroups = {{{"trunk", kHips, kUpperChest},
                                            {"neck and head", kNeck, kHead},
                                            {"eyes and jaw", kLeftEye, kJaw},
                                            {"legs", kLeftUpperLeg, kRightToes},
                                            {"left arm", kLeftShoulder, kLeftHand},
                                            {"left thumb", kLeftThumbMetacarpal, kLeftThumbDistal},
                                            {"left index", kLeftIndexProximal, kLeftIndexDistal},
                                            {"left middle", kLeftMiddleProximal, kLeftMiddleDistal},
                                            {"left ring", kLeftRingProximal, kLeftRingDistal},
                                            {"left little", kLeftLittleProximal, kLeftLittleDistal},
                                            {"right arm", kRightShoulder, kRightHand},
                                            {"right thumb", kRightThumbMetacarpal, kRightThumbDistal},
                                            {"right index", kRightIndexProximal, kRightIndexDistal},
                                            {"right middle", kRightMiddleProximal, kRightMiddleDistal},
                                            {"right ring", kRightRingProximal, kRightRingDistal},
                                            {"right little", kRightLittleProximal, kRightLittleDistal}}};

/// Measured at rest.
struct Build {
  double height = 0;                 ///< of what is drawn, metres
  std::optional<double> arms_below;  ///< the horizontal, degrees; nothing without both arms
  bool looks_back = false;           ///< along -Z: its left arm is on the side of -X
};

Build measure(const Avatar& avatar) {
  AvatarPoser poser(avatar);
  poser.pose(rest_pose(avatar));
  Build build;
  std::optional<float> least, most;
  for (const AvatarPoser::Part& part : poser.parts())
    for (const glm::vec3& position : part.positions) {
      least = std::min(least.value_or(position.y), position.y);
      most = std::max(most.value_or(position.y), position.y);
    }
  if (least) build.height = static_cast<double>(*most) - static_cast<double>(*least);
  double below = 0;
  double left_of_right = 0;
  for (const auto& [upper, lower] :
       {std::pair(kLeftUpperArm, kLeftLowerArm), std::pair(kRightUpperArm, kRightLowerArm)}) {
    if (avatar.node_of(upper) == kNoNode || avatar.node_of(lower) == kNoNode) return build;
    const auto place = [&](HumanRole role) {
      return Vec3(poser.world_from_node()[static_cast<size_t>(avatar.node_of(role))][3]);
    };
    const Vec3 bone = place(lower) - place(upper);
    const double length = std::sqrt(bone.x * bone.x + bone.y * bone.y + bone.z * bone.z);
    if (!(length > 0.0)) return build;
    left_of_right += upper == kLeftUpperArm ? place(upper).x : -place(upper).x;
    below += arc_sine(-bone.y / length) / kDegree / 2.0;
  }
  build.arms_below = below;
  build.looks_back = left_of_right < 0.0;
  return build;
}

const char* looks_along(const Build& build) {
  return build.looks_back ? "-Z" : "+Z";
}

bool has(const Avatar& avatar, HumanRole role) {
  return avatar.node_of(role) != kNoNode;
}

/// What of the joints that signing moves is not there.
std::vector<std::string> lacking_for_signs(const Avatar& avatar) {
  std::vector<std::string> lacking;
  for (const HumanRole role :
       {kHead, kLeftUpperArm, kLeftLowerArm, kLeftHand, kRightUpperArm, kRightLowerArm, kRightHand})
    if (!has(avatar, role)) lacking.emplace_back(auslan::name_of(role));
  for (auto r = static_cast<size_t>(kLeftThumbMetacarpal); r < kHumanRoleCount; ++r)
    if (avatar.human_node[r] == kNoNode) lacking.emplace_back(kHumanRoleNames[r]);
  return lacking;
}

size_t count_of(const Avatar& avatar, FaceDrive::Means means) {
  return static_cast<size_t>(std::ranges::count(avatar.face, means, &FaceDrive::means));
}

std::string counted(size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string with_one_decimal(double value) {
  const auto tenths = static_cast<long>(value * 10.0 + (value < 0 ? -0.5 : 0.5));
  return (tenths < 0 ? "-" : "") + std::to_string(std::labs(tenths) / 10) + "." +
         std::to_string(std::labs(tenths) % 10);
}

struct Sizes {
  size_t vertices = 0, morphs = 0, joints = 0;
};

Sizes sizes_of(const Avatar& avatar) {
  Sizes sizes;
  for (const AvatarMesh& mesh : avatar.meshes) {
    sizes.morphs += mesh.morph_names.size();
    for (const AvatarVertices& vertices : mesh.vertices)
      sizes.vertices += vertices.positions.size();
  }
  for (const AvatarSkin& skin : avatar.skins)
    sizes.joints += skin.joints.size();
  return sizes;
}

std::string line(std::string_view label, const std::string& text) {
  constexpr size_t kWidth = 17;
  std::string out = "  " + std::string(label);
  out.resize(std::max(out.size() + 1, kWidth), ' ');
  return out + text + "\n";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string bones_text(const Avatar& avatar) {
  std::string text;
  for (const Group& group : kGroups) {
    std::vector<std::string> found, missing;
    for (auto r = static_cast<size_t>(group.first); r <= static_cast<size_t>(group.last); ++r) {
      const int node = avatar.human_node[r];
      const std::string name(kHumanRoleNames[r]);
      if (node == kNoNode)
        missing.push_back(name);
      else
        found.push_back(name + " = " + shown(avatar.nodes[static_cast<size_t>(node)].name) +
                        (avatar.is_guessed[r] ? " (by its name)" : ""));
    }
    if (!found.empty()) text += line(group.name, joined(found));
    if (!missing.empty()) text += line(found.empty() ? group.name : "", "missing: " + joined(missing));
  }
  return text;
}

std::string face_text(const Avatar& avatar) {
  std::string text;
  for (const FaceDrive::Means means :
       {FaceDrive::Means::kMorph, FaceDrive::Means::kExpression, FaceDrive::Means::kBone, FaceDrive::Means::kNone}) {
    std::vector<std::string> channels;
    for (size_t c = 0; c < kFaceChannelCount; ++c) {
      if (avatar.face[c].means != means) continue;
      const std::string channel(kFaceChannelNames[c]);
      const std::string source = shown(avatar.face[c].source);
      channels.push_back(source.empty() || source == channel ? channel : channel + " = " + source);
    }
    if (channels.empty()) continue;
    text += line(means == FaceDrive::Means::kMorph        ? "by morph"
                 : means == FaceDrive::Means::kExpression ? "by expression"
                 : means == FaceDrive::Means::kBone       ? "by bone"
                                                          : "missing",
                 joined(channels));
  }
  std::vector<std::string> expressions;
  for (const AvatarExpression& expression : avatar.expressions)
    expressions.push_back(shown(expression.name) + (expression.binds.empty() ? " (moves nothing)" : ""));
  if (!expressions.empty()) text += line("expressions", joined(expressions));
  return text;
}

/// What comes of `--avatar FILE`.
std::string signing_text(const Avatar& avatar) {
  const auto fitted = fit_avatar(avatar);
  if (!fitted) return "  no: " + shown(fitted.error().message, 200) + "\n";
  std::string text = "  it signs: auslanjam render TEXT --avatar FILE -o OUT\n";
  for (const std::string& warning : fitted->warnings)
    text += "  but " + shown(warning, 200) + "\n";
  text += "  how well, and what is out of its reach: auslanjam check --avatar FILE\n";
  return text;
}

std::string avatar_text(const std::string& file, const Avatar& avatar) {
  const Build build = measure(avatar);
  const Sizes sizes = sizes_of(avatar);
  std::string text = shown(file) + ": " + std::string(name_of(avatar.kind)) +
                     (avatar.name.empty() ? "" : ", \"" + shown(avatar.name) + "\"") + "\n";
  if (!avatar.author.empty() || !avatar.licence.empty())
    text += line("made by", (avatar.author.empty() ? "unknown" : shown(avatar.author)) +
                                "; licence: " + (avatar.licence.empty() ? "not stated" : shown(avatar.licence, 200)));
  text +=
      line("size", counted(triangle_count(avatar), "triangle", "triangles") + ", " +
                       counted(sizes.vertices, "vertex", "vertices") + ", " +
                       counted(avatar.nodes.size(), "node", "nodes") + ", " + counted(sizes.joints, "joint", "joints") +
                       ", " + counted(sizes.morphs, "morph target", "morph targets"));
  text += line("at rest", with_one_decimal(build.height) + " m high" +
                              (build.arms_below ? ", arms " + with_one_decimal(std::fabs(*build.arms_below)) +
                                                      " degrees " + (*build.arms_below < 0.0 ? "above" : "below") +
                                                      " the horizontal, looks along " + looks_along(build)
                                                : ""));
  std::vector<std::string> images;
  for (const AvatarImage& image : avatar.images)
    images.push_back((image.name.empty() ? "unnamed" : shown(image.name)) + " (" + std::string(name_of(image.format)) +
                     (image.bytes.empty() ? "" : ", " + std::to_string((image.bytes.size() + 1023) / 1024) + " kB") +
                     ")");
  text += line("images", images.empty() ? "none" : joined(images));
  const auto found = std::ranges::count_if(avatar.human_node, [](int node) { return node != kNoNode; });
  text += "Bones: " + std::to_string(found) + " of " + std::to_string(kHumanRoleCount) +
          (avatar.rig.empty()                   ? ""
           : avatar.kind == Avatar::Kind::kGltf ? ", told from names as in " + avatar.rig
                                                : ", gaps filled from names as in " + avatar.rig) +
          "\n" + bones_text(avatar);
  const size_t rough = count_of(avatar, FaceDrive::Means::kExpression);
  text += "Face: " + std::to_string(kFaceChannelCount - count_of(avatar, FaceDrive::Means::kNone)) + " of " +
          counted(kFaceChannelCount, "channel", "channels") +
          (rough == 0 ? "" : ", " + std::to_string(rough) + " of them by expressions that move more than the channel") +
          "\n" + face_text(avatar);
  const std::vector<std::string> lacking = lacking_for_signs(avatar);
  text += "For signing: ";
  text += lacking.empty() ? "head, arms and all fingers are there\n"
                          : counted(lacking.size(), "joint is", "joints are") + " missing: " + joined(lacking) + "\n";
  text += signing_text(avatar);
  for (const std::string& warning : avatar.warnings)
    text += "Note: " + shown(warning, 200) + "\n";
  return text;
}

Json avatar_json(const std::string& file, const Avatar& avatar) {
  const Build build = measure(avatar);
  const Sizes sizes = sizes_of(avatar);
  Json json = {{"file", file},
               {"kind", name_of(avatar.kind)},
               {"name", avatar.name},
               {"author", avatar.author},
               {"licence", avatar.licence},
               {"rig", avatar.rig},
               {"triangles", triangle_count(avatar)},
               {"vertices", sizes.vertices},
               {"nodes", avatar.nodes.size()},
               {"joints", sizes.joints},
               {"morph_targets", sizes.morphs},
               {"height_m", build.height}};
  if (build.arms_below) {
    json["arms_below_horizontal_deg"] = *build.arms_below;
    json["looks_along"] = looks_along(build);
  }
  json["bones"] = Json::object();
  json["missing_bones"] = Json::array();
  for (size_t r = 0; r < kHumanRoleCount; ++r) {
    const int node = avatar.human_node[r];
    if (node == kNoNode)
      json["missing_bones"].push_back(kHumanRoleNames[r]);
    else
      json["bones"][std::string(kHumanRoleNames[r])] = {
          {"node", avatar.nodes[static_cast<size_t>(node)].name},
          {"by_name", avatar.kind == Avatar::Kind::kGltf || avatar.is_guessed[r]}};
  }
  json["missing_for_signing"] = lacking_for_signs(avatar);
  const auto fitted = fit_avatar(avatar);
  json["signs"] = fitted.has_value();
  json["signing_notes"] = fitted ? fitted->warnings : std::vector<std::string>{fitted.error().message};
  json["face"] = Json::object();
  for (size_t c = 0; c < kFaceChannelCount; ++c)
    json["face"][std::string(kFaceChannelNames[c])] = {{"by", name_of(avatar.face[c].means)},
                                                       {"source", avatar.face[c].source}};
  json["expressions"] = Json::array();
  for (const AvatarExpression& expression : avatar.expressions) {
    Json binds = Json::array();
    for (const MorphBind& bind : expression.binds)
      binds.push_back(
          {{"morph", avatar.meshes[static_cast<size_t>(bind.mesh)].morph_names[static_cast<size_t>(bind.morph)]},
           {"weight", bind.weight}});
    json["expressions"].push_back({{"name", expression.name}, {"preset", expression.is_preset}, {"morphs", binds}});
  }
  json["images"] = Json::array();
  for (const AvatarImage& image : avatar.images)
    json["images"].push_back({{"name", image.name}, {"format", name_of(image.format)}, {"bytes", image.bytes.size()}});
  json["warnings"] = avatar.warnings;
  return json;
}

}  // namespace

Result<void> run_avatar(const Options& options) {
  const auto avatar = read_avatar(options.avatar);
  if (!avatar) return tl::unexpected(avatar.error());
  if (options.json)
    return print(avatar_json(options.avatar, *avatar).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  return print(avatar_text(options.avatar, *avatar));
}

}  // namespace auslan
