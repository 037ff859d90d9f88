// SPDX-License-Identifier: Apache-2.0
// The container is written here rather than by tinygltf: its writer prints numbers through the locale, knows no order
// of keys that stays, and embeds no sparse accessors of our choosing.
#include "gltf/figure_gltf.h"
#include "gltf_format.h"
#include "kinematics/figure_file.h"
#include "kinematics/little_endian.h"
#include "kinematics/whole_file.h"
#include "light_encoding.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace auslan {
namespace {

using Json = nlohmann::ordered_json;

/// The binary chunk, gathered as one bufferView for each kind of data, and the accessors into it.
class Binary {
 public:
  /// A bufferView in the making. Vertex data of several accessors need a stated stride, other data must not have one.
  struct View {
    std::string bytes;
    int stride = 0;
    int target = 0;
    int index = -1;  ///< in document order of first use
  };

  int add_vectors(const std::vector<glm::vec3>& values, bool with_bounds) {
    Json accessor = described(vertices_, gltf::kFloat, values.size(), "VEC3");
    append_little_endian(vertices_.bytes, values.data(), values.size(), sizeof(float));
    if (with_bounds) add_bounds(accessor, values, false);
    return add(std::move(accessor));
  }

  int add_colours(const std::vector<glm::u8vec4>& srgb) {
    Json accessor = described(colours_, gltf::kUnsignedShort, srgb.size(), "VEC4");
    accessor["normalized"] = true;
    for (const glm::u8vec4& colour : srgb) {
      const std::array<uint16_t, 4> linear = {linear_from_srgb(colour.x), linear_from_srgb(colour.y),
                                              linear_from_srgb(colour.z), 65535};
      append_little_endian(colours_.bytes, linear.data(), linear.size());
    }
    return add(std::move(accessor));
  }

  int add_paint(const std::vector<Paint>& paint) {
    Json accessor = described(paint_, gltf::kUnsignedByte, paint.size(), "VEC4");
    append_little_endian(paint_.bytes, paint.data(), paint.size(), 1);
    return add(std::move(accessor));
  }

  int add_indices(const std::vector<uint32_t>& values, size_t vertices) {
    Json accessor = described(indices_, index_type(vertices), values.size(), "SCALAR");
    append_indices(indices_.bytes, values, vertices);
    return add(std::move(accessor));
  }

  /// A displacement of every vertex, zero but for those of the morph.
  int add_displacement(const Morph& morph, size_t vertices) {
    Json accessor = {{"componentType", gltf::kFloat}, {"count", vertices}, {"type", "VEC3"}};
    add_bounds(accessor, morph.displacement, morph.vertices.size() < vertices);
    if (!morph.vertices.empty()) {
      const Json at = described(sparse_indices_, index_type(vertices), 0, "");
      const Json values = described(sparse_values_, gltf::kFloat, 0, "");
      append_indices(sparse_indices_.bytes, morph.vertices, vertices);
      append_little_endian(sparse_values_.bytes, morph.displacement.data(), morph.displacement.size(), sizeof(float));
      accessor["sparse"] = {{"count", morph.vertices.size()},
                            {"indices",
                             {{"bufferView", at["bufferView"]},
                              {"byteOffset", at["byteOffset"]},
                              {"componentType", at["componentType"]}}},
                            {"values", {{"bufferView", values["bufferView"]}, {"byteOffset", values["byteOffset"]}}}};
    }
    return add(std::move(accessor));
  }

  /// Adds accessors, bufferViews and buffers to the document and gives the bytes of the chunk.
  std::string finish(Json& document) {
    std::string chunk;
    std::vector<const View*> used;
    for (const View* view : {&vertices_, &colours_, &paint_, &indices_, &sparse_indices_, &sparse_values_})
      if (view->index >= 0) used.push_back(view);
    std::ranges::sort(used, {}, &View::index);
    Json views = Json::array();
    for (const View* view : used) {
      Json described_view = {{"buffer", 0}, {"byteOffset", chunk.size()}, {"byteLength", view->bytes.size()}};
      if (view->stride != 0) described_view["byteStride"] = view->stride;
      if (view->target != 0) described_view["target"] = view->target;
      views.push_back(std::move(described_view));
      chunk += view->bytes;
    }
    if (chunk.empty()) return chunk;
    document["accessors"] = std::move(accessors_);
    document["bufferViews"] = std::move(views);
    document["buffers"][0]["byteLength"] = chunk.size();
    return chunk;
  }

 private:
  static bool is_short(size_t vertices) { return vertices <= std::numeric_limits<uint16_t>::max(); }
  static int index_type(size_t vertices) { return is_short(vertices) ? gltf::kUnsignedShort : gltf::kUnsignedInt; }

  /// Two bytes each where they do; padded so that whatever follows is aligned.
  static void append_indices(std::string& bytes, const std::vector<uint32_t>& values, size_t vertices) {
    if (!is_short(vertices)) return append_little_endian(bytes, values.data(), values.size());
    for (const uint32_t value : values)
      append_little_endian(bytes, static_cast<uint16_t>(value));
    if (values.size() % 2 != 0) append_little_endian(bytes, uint16_t{0});
  }

  /// glTF asks for the least and greatest of each component; the zeros that a sparse accessor leaves count as well.
  static void add_bounds(Json& accessor, const std::vector<glm::vec3>& values, bool zeros) {
    glm::vec3 low = zeros || values.empty() ? glm::vec3(0.0F) : values.front();
    glm::vec3 high = low;
    for (const glm::vec3& value : values)
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], value[axis]);
        high[axis] = std::max(high[axis], value[axis]);
      }
    accessor["min"] = {low.x, low.y, low.z};
    accessor["max"] = {high.x, high.y, high.z};
  }

  Json described(View& view, int component_type, size_t count, const char* type) {
    if (view.index < 0) view.index = next_view_++;
    return {{"bufferView", view.index},
            {"byteOffset", view.bytes.size()},
            {"componentType", component_type},
            {"count", count},
            {"type", type}};
  }

  int add(Json accessor) {
    accessors_.push_back(std::move(accessor));
    return static_cast<int>(accessors_.size()) - 1;
  }

  View vertices_{.bytes = {}, .stride = 12, .target = gltf::kArrayBuffer};
  View colours_{.bytes = {}, .stride = 8, .target = gltf::kArrayBuffer};
  View paint_{.bytes = {}, .stride = 4, .target = gltf::kArrayBuffer};
  View indices_{.bytes = {}, .target = gltf::kElementArrayBuffer};
  View sparse_indices_;
  View sparse_values_;
  int next_view_ = 0;
  Json accessors_ = Json::array();
};

Json describe_mesh(const Mesh& mesh, const std::string& name, Binary& binary) {
  Json attributes;
  attributes["POSITION"] = binary.add_vectors(mesh.positions, true);
  attributes["NORMAL"] = binary.add_vectors(mesh.normals, false);
  attributes["COLOR_0"] = binary.add_colours(mesh.colours);
  // A name of our own, which the standard has begin with an underscore.
  if (!mesh.paint.empty()) attributes["_PAINT"] = binary.add_paint(mesh.paint);
  Json primitive;
  primitive["attributes"] = std::move(attributes);
  primitive["indices"] = binary.add_indices(mesh.indices, mesh.positions.size());
  primitive["material"] = 0;
  Json names = Json::array();
  for (const Morph& morph : mesh.morphs) {
    const int accessor = binary.add_displacement(morph, mesh.positions.size());
    primitive["targets"].push_back(Json::object({{"POSITION", accessor}}));
    names.push_back(kFaceChannelNames[static_cast<size_t>(morph.channel)]);
  }
  Json described;
  described["name"] = name;
  described["primitives"].push_back(std::move(primitive));
  if (!names.empty()) described["extras"]["targetNames"] = std::move(names);
  return described;
}

Json describe_colour(const glm::u8vec3& colour) {
  return {colour.x, colour.y, colour.z};
}

Json describe_appearances(const std::vector<Appearance>& appearances) {
  Json described = Json::array();
  for (const Appearance& appearance : appearances) {
    Json pigments = Json::array();
    for (const glm::u8vec3& pigment : appearance.pigments)
      pigments.push_back(describe_colour(pigment));
    described.push_back({{"name", appearance.name},
                         {"background", describe_colour(appearance.background)},
                         {"pigments", std::move(pigments)}});
  }
  return described;
}

Json describe_nodes(const Skeleton& skeleton) {
  Json nodes = Json::array();
  for (const Node& node : skeleton.nodes()) {
    nodes.push_back({{"name", node.name}, {"translation", {node.offset.x, node.offset.y, node.offset.z}}});
    if (node.parent != kNoNode) nodes[static_cast<size_t>(node.parent)]["children"].push_back(nodes.size() - 1);
  }
  return nodes;
}

/// Whether a walk from the root that visits children in order meets the nodes in the order in which they stand: else
/// the file would come back in another order.
bool is_depth_first(const Skeleton& skeleton) {
  for (int i = 1; i < skeleton.size(); ++i) {
    int ancestor = i - 1;
    while (ancestor != kNoNode && ancestor != skeleton.node(i).parent)
      ancestor = skeleton.node(ancestor).parent;
    if (ancestor == kNoNode) return false;
  }
  return true;
}

void append_chunk(std::string& file, uint32_t type, std::string bytes, char padding) {
  bytes.resize((bytes.size() + 3) / 4 * 4, padding);
  append_little_endian(file, static_cast<uint32_t>(bytes.size()));
  append_little_endian(file, type);
  file += bytes;
}

}  // namespace

Result<void> write_gltf(const Figure& figure, const std::filesystem::path& path) {
  if (auto checked = check_figure(figure); !checked) return checked;
  if (!is_depth_first(figure.skeleton))
    return fail(ErrorCode::kMalformed, "the nodes of the skeleton must stand in depth-first order", figure.name);
  Binary binary;
  Json document;
  document["asset"] = {{"version", "2.0"}, {"generator", "Auslan Jam"}};
  document["scene"] = 0;
  document["scenes"][0]["nodes"] = Json::array({0});
  if (!figure.name.empty()) document["scenes"][0]["name"] = figure.name;
  if (!figure.appearances.empty())
    document["scenes"][0]["extras"]["appearances"] = describe_appearances(figure.appearances);
  Json nodes = describe_nodes(figure.skeleton);
  Json meshes = Json::array();
  for (size_t i = 0; i < figure.segments.size(); ++i) {
    if (figure.segments[i].positions.empty()) continue;
    nodes[i]["mesh"] = meshes.size();
    meshes.push_back(describe_mesh(figure.segments[i], figure.skeleton.nodes()[i].name, binary));
  }
  document["nodes"] = std::move(nodes);
  if (!meshes.empty()) {
    // glTF's default is bare metal; the factors leave COLOR_0 as it is.
    document["materials"].push_back(
        {{"name", "surface"}, {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.75}}}});
    document["meshes"] = std::move(meshes);
  }
  std::string chunk = binary.finish(document);
  std::string text;
  try {
    text = document.dump();
  } catch (const Json::exception&) {
    return fail(ErrorCode::kMalformed, "the name of the figure, of an appearance or of a node is not valid UTF-8",
                path.string());
  }

  std::string chunks;
  append_chunk(chunks, gltf::kJsonChunk, std::move(text), ' ');
  if (!chunk.empty()) append_chunk(chunks, gltf::kBinaryChunk, std::move(chunk), '\0');
  if (chunks.size() + gltf::kGlbHeaderBytes > kMaxGltfBytes)
    return fail(ErrorCode::kLimit, "the figure is larger than 64 MiB; use meshes with fewer triangles", path.string());
  std::string file(gltf::kGlbMagic);
  append_little_endian(file, gltf::kGlbVersion);
  append_little_endian(file, static_cast<uint32_t>(gltf::kGlbHeaderBytes + chunks.size()));
  file += chunks;
  return write_whole_file(path, file);
}

}  // namespace auslan
