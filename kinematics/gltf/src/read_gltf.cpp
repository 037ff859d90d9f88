// SPDX-License-Identifier: Apache-2.0
#include "accessor.h"
#include "gltf/figure_gltf.h"
#include "gltf_format.h"
#include "kinematics/figure_file.h"
#include "kinematics/whole_file.h"
#include "load_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace auslan {
namespace {

using gltf::place_of;

/// How far from the identity a rest rotation may lie: the rounding of exporters that compose matrices in float.
constexpr double kIdentityTolerance = 1e-6;

tl::unexpected<Error> malformed(std::string message, std::string place) {
  return fail(ErrorCode::kMalformed, std::move(message), std::move(place));
}

tl::unexpected<Error> unsupported(std::string message, std::string place) {
  return fail(ErrorCode::kUnsupported, std::move(message), std::move(place));
}

bool is_near(const std::vector<double>& values, std::span<const double> expected) {
  return std::ranges::equal(values, expected,
                            [](double a, double b) { return std::fabs(a - b) <= kIdentityTolerance; });
}

/// The translation of a node that neither rotates nor scales.
Result<Vec3> rest_offset(const tinygltf::Node& node, const std::string& place) {
  constexpr std::array<double, 4> kNoRotation = {0, 0, 0, 1};
  constexpr std::array<double, 3> kNoScale = {1, 1, 1};
  const auto is_size = [](const std::vector<double>& values, size_t size) {
    return values.empty() || values.size() == size;
  };
  if (!is_size(node.matrix, 16) || !is_size(node.rotation, 4) || !is_size(node.scale, 3) ||
      !is_size(node.translation, 3))
    return malformed("the matrix, rotation, scale or translation has the wrong number of elements", place);
  Vec3 offset(0.0);
  if (!node.translation.empty()) offset = Vec3(node.translation[0], node.translation[1], node.translation[2]);
  std::vector<double> rotation = node.rotation;
  if (!rotation.empty() && rotation[3] < 0.0)
    for (double& component : rotation)
      component = -component;
  bool is_upright =
      (rotation.empty() || is_near(rotation, kNoRotation)) && (node.scale.empty() || is_near(node.scale, kNoScale));
  if (!node.matrix.empty()) {
    offset = Vec3(node.matrix[12], node.matrix[13], node.matrix[14]);
    const std::array<double, 16> translation = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, offset.x, offset.y, offset.z, 1};
    is_upright = is_near(node.matrix, translation);
  }
  if (!is_upright)
    return unsupported(
        "the node is rotated or scaled at rest; apply rotations and scales in a T-pose before you export", place);
  return offset;
}

/// A node of the file and where its parent went.
struct Visit {
  int index = 0;
  int parent = kNoNode;
};

/// The nodes of the scene, depth-first, children in file order; `sources` receives their indices in the file.
Result<Skeleton> read_skeleton(const tinygltf::Model& model, const tinygltf::Scene& scene, std::vector<int>& sources) {
  if (scene.nodes.size() != 1)
    return unsupported("the scene must have one root node (spine_base), with all others below it", "scenes");
  std::vector<bool> is_visited(model.nodes.size(), false);
  std::vector<Node> nodes;
  std::vector<Visit> waiting = {{.index = scene.nodes.front(), .parent = kNoNode}};
  while (!waiting.empty()) {
    const Visit visit = waiting.back();
    waiting.pop_back();
    if (visit.index < 0 || static_cast<size_t>(visit.index) >= model.nodes.size())
      return malformed("a node names a child that does not exist", place_of("nodes", visit.index, ""));
    const tinygltf::Node& source = model.nodes[static_cast<size_t>(visit.index)];
    const std::string place = place_of("nodes", visit.index, source.name);
    if (is_visited[static_cast<size_t>(visit.index)])
      return malformed("the node has two parents or is its own ancestor", place);
    is_visited[static_cast<size_t>(visit.index)] = true;
    if (nodes.size() >= kMaxFigureNodes) return fail(ErrorCode::kLimit, "the figure has more than 4096 nodes", place);
    if (source.skin >= 0)
      return unsupported("the mesh is skinned; figures are made of rigid segments, one mesh a node", place);
    const auto offset = rest_offset(source, place);
    if (!offset) return tl::unexpected<Error>(offset.error());
    const auto self = static_cast<int>(nodes.size());
    nodes.push_back({.name = source.name, .parent = visit.parent, .offset = *offset});
    sources.push_back(visit.index);
    for (auto child = source.children.rbegin(); child != source.children.rend(); ++child)
      waiting.push_back({.index = *child, .parent = self});
  }
  return Skeleton::build(std::move(nodes));
}

/// The base colour of a primitive's material in linear light; white without one.
Result<glm::dvec3> base_colour(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                               const std::string& place) {
  if (primitive.material < 0) return glm::dvec3(1.0);
  if (static_cast<size_t>(primitive.material) >= model.materials.size())
    return malformed("the material of the mesh does not exist", place);
  const std::vector<double>& factor =
      model.materials[static_cast<size_t>(primitive.material)].pbrMetallicRoughness.baseColorFactor;
  if (factor.size() != 4) return glm::dvec3(1.0);
  return glm::dvec3(factor[0], factor[1], factor[2]);
}

std::optional<FaceChannel> face_channel(const tinygltf::Value& name) {
  if (!name.IsString()) return std::nullopt;
  const auto found = std::ranges::find(kFaceChannelNames, name.Get<std::string>());
  if (found == kFaceChannelNames.end()) return std::nullopt;
  return static_cast<FaceChannel>(found - kFaceChannelNames.begin());
}

Result<void> read_morphs(const tinygltf::Mesh& source, gltf::AccessorReader& reader, const std::string& place,
                         Mesh& mesh) {
  const std::vector<std::map<std::string, int>>& targets = source.primitives.front().targets;
  if (targets.empty()) return {};
  // Asked first: tinygltf asserts where it is no object.
  const tinygltf::Value names = source.extras.IsObject() ? source.extras.Get("targetNames") : tinygltf::Value();
  if (!names.IsArray() || names.ArrayLen() != targets.size())
    return unsupported("the morph targets have no names; export them with extras.targetNames", place);
  for (size_t i = 0; i < targets.size(); ++i) {
    const std::optional<FaceChannel> channel = face_channel(names.Get(static_cast<int>(i)));
    const auto position = targets[i].find("POSITION");
    if (!channel || position == targets[i].end()) continue;
    auto morph = reader.displacement(position->second, *channel, mesh.positions.size());
    if (!morph) return tl::unexpected<Error>(std::move(morph.error()));
    mesh.morphs.push_back(*std::move(morph));
  }
  return {};
}

/// A whole number from 0 to 255, or nothing.
std::optional<uint8_t> byte_of(const tinygltf::Value& value) {
  if (!value.IsInt()) return std::nullopt;
  const int number = value.Get<int>();
  if (number < 0 || number > 255) return std::nullopt;
  return static_cast<uint8_t>(number);
}

std::optional<glm::u8vec3> colour_of(const tinygltf::Value& value) {
  if (!value.IsArray() || value.ArrayLen() != 3) return std::nullopt;
  glm::u8vec3 colour(0);
  for (int channel = 0; channel < 3; ++channel) {
    const std::optional<uint8_t> level = byte_of(value.Get(channel));
    if (!level) return std::nullopt;
    colour[channel] = *level;
  }
  return colour;
}

/// What write_gltf put into the scene's extras; none in files of other makers.
Result<std::vector<Appearance>> read_appearances(const tinygltf::Scene& scene) {
  constexpr const char* kPlace = "scenes[0].extras.appearances";
  std::vector<Appearance> appearances;
  const tinygltf::Value list = scene.extras.IsObject() ? scene.extras.Get("appearances") : tinygltf::Value();
  if (!list.IsArray()) return appearances;
  if (list.ArrayLen() > kMaxFigureAppearances) return fail(ErrorCode::kLimit, "there are too many appearances", kPlace);
  for (size_t i = 0; i < list.ArrayLen(); ++i) {
    const tinygltf::Value& described = list.Get(static_cast<int>(i));
    // Asked first: tinygltf asserts where it is no object.
    const bool is_object = described.IsObject();
    const tinygltf::Value name = is_object ? described.Get("name") : tinygltf::Value();
    const std::optional<glm::u8vec3> background =
        is_object ? colour_of(described.Get("background")) : std::optional<glm::u8vec3>();
    const tinygltf::Value pigments = is_object ? described.Get("pigments") : tinygltf::Value();
    if (!name.IsString() || !background || !pigments.IsArray() || pigments.ArrayLen() > kMaxFigurePigments)
      return malformed("an appearance needs a name, a background and at most 256 pigments", kPlace);
    Appearance& appearance = appearances.emplace_back();
    appearance.name = name.Get<std::string>();
    appearance.background = *background;
    for (size_t k = 0; k < pigments.ArrayLen(); ++k) {
      const std::optional<glm::u8vec3> pigment = colour_of(pigments.Get(static_cast<int>(k)));
      if (!pigment) return malformed("a pigment is three whole numbers from 0 to 255", kPlace);
      appearance.pigments.push_back(*pigment);
    }
  }
  return appearances;
}

Result<std::vector<Paint>> read_paint(int accessor, gltf::AccessorReader& reader, const std::string& place) {
  const auto numbers = reader.elements(accessor, 4);
  if (!numbers) return tl::unexpected<Error>(numbers.error());
  std::vector<Paint> paint(numbers->size() / 4);
  for (size_t i = 0; i < numbers->size(); ++i) {
    const double number = (*numbers)[i];
    if (number < 0.0 || number > 255.0 || number != std::floor(number))
      return malformed("_PAINT must hold whole numbers from 0 to 255", place);
    Paint& one = paint[i / 4];
    uint8_t* const fields[] = {&one.first, &one.second, &one.share, &one.shade};
    *fields[i % 4] = static_cast<uint8_t>(number);
  }
  return paint;
}

Result<Mesh> read_mesh(const tinygltf::Model& model, int index, bool is_painted, gltf::AccessorReader& reader) {
  if (static_cast<size_t>(index) >= model.meshes.size())
    return malformed("the mesh of a node does not exist", place_of("meshes", index, ""));
  const tinygltf::Mesh& source = model.meshes[static_cast<size_t>(index)];
  const std::string place = place_of("meshes", index, source.name);
  if (source.primitives.size() != 1) return unsupported("a mesh needs exactly one primitive; join its parts", place);
  const tinygltf::Primitive& primitive = source.primitives.front();
  if (primitive.mode != gltf::kTriangles) return unsupported("the mesh is not a list of triangles", place);
  const auto attribute = [&](const char* name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? std::optional<int>() : std::optional<int>(found->second);
  };
  const std::optional<int> position = attribute("POSITION");
  const std::optional<int> normal = attribute("NORMAL");
  const std::optional<int> colour = attribute("COLOR_0");
  if (!position || !normal) return unsupported("the mesh lacks positions or normals; export both", place);

  Mesh mesh;
  auto positions = reader.vectors(*position);
  if (!positions) return tl::unexpected<Error>(std::move(positions.error()));
  mesh.positions = *std::move(positions);
  auto normals = reader.vectors(*normal);
  if (!normals) return tl::unexpected<Error>(std::move(normals.error()));
  mesh.normals = *std::move(normals);
  const auto factor = base_colour(model, primitive, place);
  if (!factor) return tl::unexpected<Error>(factor.error());
  if (colour) {
    auto colours = reader.colours(*colour, *factor);
    if (!colours) return tl::unexpected<Error>(std::move(colours.error()));
    mesh.colours = *std::move(colours);
  } else {
    mesh.colours.assign(mesh.positions.size(),
                        glm::u8vec4(gltf::srgb_from_fraction(factor->x), gltf::srgb_from_fraction(factor->y),
                                    gltf::srgb_from_fraction(factor->z), 255));
  }
  // Only beside appearances does the paint mean something: another maker's _PAINT is none of ours.
  if (const std::optional<int> paint = attribute("_PAINT"); paint && is_painted) {
    auto paints = read_paint(*paint, reader, place);
    if (!paints) return tl::unexpected<Error>(std::move(paints.error()));
    mesh.paint = *std::move(paints);
  }
  if (primitive.indices >= 0) {
    auto indices = reader.indices(primitive.indices);
    if (!indices) return tl::unexpected<Error>(std::move(indices.error()));
    mesh.indices = *std::move(indices);
  } else {
    mesh.indices.resize(mesh.positions.size());
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0U);
  }
  if (auto read = read_morphs(source, reader, place, mesh); !read)
    return tl::unexpected<Error>(std::move(read.error()));
  return mesh;
}

Result<Figure> build_figure(const tinygltf::Model& model) {
  const int scene = std::max(model.defaultScene, 0);
  if (static_cast<size_t>(scene) >= model.scenes.size()) return malformed("the file has no scene", "scenes");
  Figure figure;
  figure.name = model.scenes[static_cast<size_t>(scene)].name;
  std::vector<int> sources;
  auto skeleton = read_skeleton(model, model.scenes[static_cast<size_t>(scene)], sources);
  if (!skeleton) return tl::unexpected<Error>(std::move(skeleton.error()));
  figure.skeleton = *std::move(skeleton);
  auto appearances = read_appearances(model.scenes[static_cast<size_t>(scene)]);
  if (!appearances) return tl::unexpected<Error>(std::move(appearances.error()));
  figure.appearances = *std::move(appearances);
  figure.segments.resize(sources.size());
  gltf::AccessorReader reader(model);
  for (size_t i = 0; i < sources.size(); ++i) {
    const int mesh = model.nodes[static_cast<size_t>(sources[i])].mesh;
    if (mesh < 0) continue;
    auto read = read_mesh(model, mesh, !figure.appearances.empty(), reader);
    if (!read) return tl::unexpected<Error>(std::move(read.error()));
    figure.segments[i] = *std::move(read);
  }
  if (auto checked = check_figure(figure); !checked) return tl::unexpected<Error>(std::move(checked.error()));
  return figure;
}

}  // namespace

Result<Figure> parse_gltf(std::span<const std::byte> bytes, const std::filesystem::path& folder) {
  return gltf::without_exceptions([&]() -> Result<Figure> {
    const auto model = gltf::load_model(bytes, folder, {});
    if (!model) return tl::unexpected<Error>(model.error());
    return build_figure(*model);
  });
}

Result<Figure> read_gltf(const std::filesystem::path& path) {
  const auto bytes = read_whole_file(path, kMaxGltfBytes);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  auto figure = parse_gltf(std::as_bytes(std::span(*bytes)), path.parent_path());
  if (!figure) figure.error().place = gltf::place_in_file(path, figure.error().place);
  return figure;
}

}  // namespace auslan
