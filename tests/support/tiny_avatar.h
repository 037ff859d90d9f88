// SPDX-License-Identifier: Apache-2.0
// The smallest figure with all that the reader of foreign figures looks at: three bones, a skinned square with a morph
// target and an image, and the humanoid map and an expression of VRM.
#pragma once

#include "glb_document.h"
#include "gltf/avatar_gltf.h"

#include <initializer_list>
#include <string>

namespace auslan::test {

inline Result<Avatar> parse_avatar_text(const std::string& bytes, const std::filesystem::path& folder = {}) {
  return parse_avatar(std::as_bytes(std::span(bytes)), folder);
}

/// The head of a PNG of that size; no reader of the project looks further.
inline std::string png_head(uint16_t side) {
  const std::string size = {0, 0, static_cast<char>(side >> 8), static_cast<char>(side & 0xFF)};
  return std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) + size + size + std::string("\x08\x06\0\0\0", 5);
}

/// Adds an accessor over floats or bytes of its own.
inline int add_floats(GlbDocument& document, const char* type, size_t count, const std::vector<float>& values) {
  std::string bytes;
  for (const float value : values)
    append_little_endian(bytes, value);
  const size_t view = document.add_view(bytes);
  document.json["accessors"].push_back(
      {{"bufferView", view}, {"byteOffset", 0}, {"componentType", 5126}, {"count", count}, {"type", type}});
  return static_cast<int>(document.json["accessors"].size()) - 1;
}
inline int add_bytes(GlbDocument& document, const char* type, size_t count, const std::string& bytes) {
  const size_t view = document.add_view(bytes);
  document.json["accessors"].push_back(
      {{"bufferView", view}, {"byteOffset", 0}, {"componentType", 5121}, {"count", count}, {"type", type}});
  return static_cast<int>(document.json["accessors"].size()) - 1;
}

/// Nodes: 0 root, 1 hips at (0, 1, 0), 2 spine at (0, 0.5, 0) above it, 3 head, unmoved, 4 the mesh. The square lies in
/// z = 0 from (0, 1) to (1, 2); its lower corners hang on the hips, its upper ones half on the hips and half on the
/// spine. The morph target lifts the last corner by 0.25 m.
inline GlbDocument tiny_avatar(Avatar::Kind kind = Avatar::Kind::kVrm1) {
  using nlohmann::json;
  GlbDocument document;
  document.json = {{"asset", {{"version", "2.0"}}},   {"scene", 0},
                   {"scenes", {{{"nodes", {0, 4}}}}}, {"buffers", {{{"byteLength", 1}}}},
                   {"bufferViews", json::array()},    {"accessors", json::array()}};
  document.json["nodes"] = {{{"name", "root"}, {"children", {1}}},
                            {{"name", "Hips"}, {"translation", {0, 1, 0}}, {"children", {2}}},
                            {{"name", "Spine"}, {"translation", {0, 0.5, 0}}, {"children", {3}}},
                            {{"name", "Head"}},
                            {{"name", "Body"}, {"mesh", 0}, {"skin", 0}}};
  const int positions = add_floats(document, "VEC3", 4, {0, 1, 0, 1, 1, 0, 1, 2, 0, 0, 2, 0});
  const int normals = add_floats(document, "VEC3", 4, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  const int places = add_floats(document, "VEC2", 4, {0, 1, 1, 1, 1, 0, 0, 0});
  const int weights = add_floats(document, "VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0, 0.5F, 0.5F, 0, 0});
  const int joints = add_bytes(document, "VEC4", 4, std::string("\0\0\0\0\0\0\0\0\0\1\0\0\0\1\0\0", 16));
  const int indices = add_bytes(document, "SCALAR", 6, std::string("\0\1\2\0\2\3", 6));
  const int lifted = add_floats(document, "VEC3", 4, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.25F, 0});
  const int unbound = add_floats(document, "MAT4", 2, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1,    0, 1,
                                                       1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1.5F, 0, 1});
  document.json["images"] = {
      {{"name", "skin"}, {"mimeType", "image/png"}, {"bufferView", document.add_view(png_head(16))}}};
  document.json["textures"] = {{{"source", 0}}};
  document.json["materials"] = {
      {{"name", "skin"},
       {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, 1}}, {"baseColorTexture", {{"index", 0}}}}}}};
  document.json["meshes"] = {{{"name", "square"},
                              {"extras", {{"targetNames", {"jawOpen"}}}},
                              {"primitives",
                               {{{"attributes",
                                  {{"POSITION", positions},
                                   {"NORMAL", normals},
                                   {"TEXCOORD_0", places},
                                   {"WEIGHTS_0", weights},
                                   {"JOINTS_0", joints}}},
                                 {"indices", indices},
                                 {"material", 0},
                                 {"targets", {{{"POSITION", lifted}}}}}}}}};
  document.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", unbound}}};
  if (kind == Avatar::Kind::kVrm1)
    document.json["extensions"]["VRMC_vrm"] = {
        {"specVersion", "1.0"},
        {"meta", {{"name", "tiny"}}},
        {"humanoid", {{"humanBones", {{"hips", {{"node", 1}}}, {"spine", {{"node", 2}}}}}}},
        {"expressions",
         {{"preset", {{"aa", {{"morphTargetBinds", {{{"node", 4}, {"index", 0}, {"weight", 0.75}}}}}}}}}}};
  if (kind == Avatar::Kind::kVrm0)
    document.json["extensions"]["VRM"] = {
        {"meta", {{"title", "tiny"}}},
        {"humanoid",
         {{"humanBones",
           {{{"bone", "hips"}, {"node", 1}},
            {{"bone", "leftThumbProximal"}, {"node", 2}},
            {{"bone", "jaw"}, {"node", -1}}}}}},
        {"blendShapeMaster",
         {{"blendShapeGroups",
           {{{"name", "A"}, {"presetName", "a"}, {"binds", {{{"mesh", 0}, {"index", 0}, {"weight", 75}}}}}}}}}};
  return document;
}

}  // namespace auslan::test
