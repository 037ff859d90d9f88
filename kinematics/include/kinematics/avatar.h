// SPDX-License-Identifier: Apache-2.0
// A foreign figure as its file describes it: nodes that may be rotated and scaled at rest, skinned meshes with morph
// targets, and what the nodes and morphs stand for. Metres, right-handed, Y up, as glTF has it; a figure of VRM 0 looks
// along -Z, all others should look along +Z. Nothing here is fitted to the project's own skeleton.
#pragma once

#include "kinematics/humanoid.h"
#include "kinematics/image_wrap.h"
#include "kinematics/pose.h"
#include "kinematics/vector.h"

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

namespace auslan {

struct AvatarNode {
  std::string name;
  int parent = kNoNode;  ///< smaller than the node's own index, or kNoNode; there may be several roots
  Vec3 translation{0.0};
  Quat rotation = kIdentity;  ///< parent_from_node at rest, unit
  Vec3 scale{1.0};
  int mesh = -1;                          ///< what is drawn here, or -1
  int skin = -1;                          ///< how it is bound, or -1: it moves with the node
  std::vector<float> morph_weights = {};  ///< at rest, in place of the mesh's; empty: the mesh's
};

/// A displacement of some vertices, full at weight 1.
struct AvatarMorph {
  std::vector<uint32_t> vertices;  ///< ascending
  std::vector<glm::vec3> positions;
  std::vector<uint32_t> normal_vertices;  ///< ascending
  std::vector<glm::vec3> normals;
};

/// Vertices that one or more surfaces share. `joints` and `weights` are empty where the mesh is not skinned.
struct AvatarVertices {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  ///< unit; from the triangles where the file has none
  std::vector<glm::vec2> texture_coordinates;
  std::vector<glm::u8vec4> colours;      ///< sRGB-encoded; empty: white
  std::vector<glm::u16vec4> joints;      ///< into AvatarSkin::joints
  std::vector<glm::vec4> weights;        ///< not negative, of sum 1
  std::vector<AvatarMorph> morphs = {};  ///< in the order of the mesh's morph names; there may be fewer
};

/// How an image lies on a surface.
struct ImagePlacement {
  /// Of coordinates before they are looked up (KHR_texture_transform): origin + x_axis * u + y_axis * v.
  glm::vec2 origin{0.0F}, x_axis{1.0F, 0.0F}, y_axis{0.0F, 1.0F};
};

/// Triangles of one material.
struct AvatarSurface {
  std::string material;
  int vertices = 0;               ///< into AvatarMesh::vertices
  std::vector<uint32_t> indices;  ///< three a triangle, counter-clockwise from outside
  glm::vec4 base_colour{1.0F};    ///< linear light, times the image and the vertex colours
  int image = -1;                 ///< of the base colour, or -1
  ImageWrap wrap_u = ImageWrap::kRepeat, wrap_v = ImageWrap::kRepeat;  ///< of the image
  ImagePlacement placement;
  bool is_double_sided = false;
  bool is_transparent = false;
  /// Not negative: the surface is cut out where alpha, of base colour and image, is below it. Above 1: everywhere.
  std::optional<float> alpha_cutoff = {};
};

struct AvatarMesh {
  std::string name;
  std::vector<AvatarVertices> vertices;
  std::vector<AvatarSurface> surfaces;
  std::vector<std::string> morph_names;  ///< "" for a target that the file does not name
  std::vector<float> morph_weights;      ///< at rest, one a morph
};

struct AvatarSkin {
  std::vector<int> joints;                  ///< nodes
  std::vector<glm::dmat4> joint_from_mesh;  ///< at rest; one a joint
};

/// Pixels that are still encoded.
struct AvatarImage {
  enum class Format : uint8_t { kPng, kJpeg, kOther };
  std::string name;
  Format format = Format::kOther;
  std::vector<unsigned char> bytes;  ///< empty for kOther and for files that were not found
};

/// A share of a morph target.
struct MorphBind {
  int mesh = 0;
  int morph = 0;
  double weight = 1.0;
};

/// An expression of a VRM, named as VRM 1.0 names it.
struct AvatarExpression {
  std::string name;
  bool is_preset = false;
  std::vector<MorphBind> binds;
  bool changes_materials = false;  ///< also colours or texture coordinates, which are not kept
};

/// How a channel of the face can be moved.
struct FaceDrive {
  enum class Means : uint8_t { kNone, kMorph, kExpression, kBone };
  Means means = Means::kNone;
  std::string source;            ///< the name of the morph target, of the expression or of the bone
  std::vector<MorphBind> binds;  ///< at weight 1 of the channel; none for a bone
};

struct Avatar {
  enum class Kind : uint8_t { kGltf, kVrm0, kVrm1 };
  Kind kind = Kind::kGltf;
  std::string name;
  std::string author;             ///< as the file tells; empty where it does not
  std::string licence;            ///< a name, an address or a notice
  std::vector<AvatarNode> nodes;  ///< parents first
  std::vector<AvatarMesh> meshes;
  std::vector<AvatarSkin> skins;
  std::vector<AvatarImage> images;

  HumanNodes human_node{};                         ///< by HumanRole; kNoNode where nothing plays the role
  std::array<bool, kHumanRoleCount> is_guessed{};  ///< by its name, although the file has a map that lacks the role
  std::string rig;  ///< whose names were recognised; empty where the file's own map was enough or none were

  std::vector<AvatarExpression> expressions;
  std::array<FaceDrive, kFaceChannelCount> face{};  ///< by FaceChannel
  std::vector<std::string> warnings;                ///< what will look or move otherwise than its maker meant

  int node_of(HumanRole role) const { return human_node[static_cast<size_t>(role)]; }
};

/// Bounds of what is drawn: vertices counted once for each node that shows them, and triangles likewise.
inline constexpr size_t kMaxAvatarNodes = 4096;
inline constexpr size_t kMaxAvatarVertices = 2'000'000;
inline constexpr size_t kMaxAvatarTriangles = 2'000'000;
/// No position of the figure at rest lies farther from the origin, metres.
inline constexpr double kMaxAvatarExtent = 1e6;

/// Triangles of all nodes that show a mesh.
size_t triangle_count(const Avatar& avatar);

/// Fills `face` from morph targets that bear ARKit's names, else those of MakeHuman, VRoid or Oculus' visemes, and for
/// channels that have none from the expressions, of which some are rough (the jaw opens with "aa"); gaze and jaw, where
/// even those are missing, from the bones of eyes and jaw.
void drive_face(Avatar& avatar);

}  // namespace auslan
