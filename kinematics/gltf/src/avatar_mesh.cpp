// SPDX-License-Identifier: Apache-2.0
#include "avatar_mesh.h"

#include "gltf_format.h"
#include "kinematics/elementary.h"
#include "load_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace auslan::gltf {
namespace {

constexpr size_t kMaxWarnings = 64;
constexpr size_t kMaxPrimitives = 1024;  // of one mesh

tl::unexpected<Error> malformed(std::string message, std::string place) {
  return fail(ErrorCode::kMalformed, std::move(message), std::move(place));
}

std::optional<int> attribute(const std::map<std::string, int>& attributes, const std::string& name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::optional<int>() : std::optional<int>(found->second);
}

glm::vec3 unit_or_up(const glm::dvec3& v) {
  const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return length > 0.0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0.0F, 1.0F, 0.0F);
}

std::vector<glm::vec3> vectors_of(const std::vector<double>& numbers) {
  std::vector<glm::vec3> vectors(numbers.size() / 3);
  for (size_t i = 0; i < vectors.size(); ++i)
    vectors[i] = glm::vec3(glm::dvec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]));
  return vectors;
}

/// Adds the normals of the triangles, each as heavy as its area.
void add_normals(std::span<const uint32_t> indices, AvatarVertices& vertices, std::vector<glm::dvec3>& sums) {
  for (size_t i = 0; i + 2 < indices.size(); i += 3) {
    const glm::dvec3 a(vertices.positions[indices[i]]);
    const glm::dvec3 u = glm::dvec3(vertices.positions[indices[i + 1]]) - a;
    const glm::dvec3 v = glm::dvec3(vertices.positions[indices[i + 2]]) - a;
    const glm::dvec3 normal(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
    for (int k = 0; k < 3; ++k)
      sums[indices[i + static_cast<size_t>(k)]] += normal;
  }
}

struct Influence {
  double weight = 0.0;
  uint16_t joint = 0;
};

/// Joints and weights of all sets the file has, the four heaviest kept.
Result<void> read_influences(const tinygltf::Primitive& primitive, AccessorReader& reader, const std::string& place,
                             AvatarVertices& vertices, Warnings& warnings) {
  const size_t count = vertices.positions.size();
  std::vector<double> joints[2];
  std::vector<double> weights[2];
  size_t sets = 0;
  for (; sets < 2; ++sets) {
    const auto joint = attribute(primitive.attributes, "JOINTS_" + std::to_string(sets));
    const auto weight = attribute(primitive.attributes, "WEIGHTS_" + std::to_string(sets));
    if (!joint || !weight) break;
    auto read_joints = reader.elements(*joint, 4);
    if (!read_joints) return tl::unexpected<Error>(std::move(read_joints.error()));
    auto read_weights = reader.elements(*weight, 4);
    if (!read_weights) return tl::unexpected<Error>(std::move(read_weights.error()));
    if (read_joints->size() != 4 * count || read_weights->size() != 4 * count)
      return malformed("the mesh needs four joints and four weights a vertex", place);
    joints[sets] = *std::move(read_joints);
    weights[sets] = *std::move(read_weights);
  }
  if (sets == 0) return {};
  if (sets == 2 || attribute(primitive.attributes, "JOINTS_2"))
    warnings.add("some vertices hang on more than four bones; the four heaviest are kept");
  vertices.joints.resize(count);
  vertices.weights.resize(count);
  bool has_unbound = false;
  for (size_t i = 0; i < count; ++i) {
    std::array<Influence, 8> influences;
    for (size_t s = 0; s < sets; ++s)
      for (size_t k = 0; k < 4; ++k) {
        const double joint = joints[s][4 * i + k];
        if (!(joint >= 0.0 && joint <= 65535.0 && joint == static_cast<double>(static_cast<uint16_t>(joint))))
          return malformed("a joint of a vertex is not a whole number", place);
        influences[4 * s + k] = {.weight = std::max(weights[s][4 * i + k], 0.0), .joint = static_cast<uint16_t>(joint)};
      }
    // By insertion: eight, nearly in order, and equal ones stay as they are.
    for (size_t k = 1; k < 4 * sets; ++k)
      for (size_t m = k; m > 0 && influences[m].weight > influences[m - 1].weight; --m)
        std::swap(influences[m], influences[m - 1]);
    double sum = 0.0;
    for (size_t k = 0; k < 4; ++k)
      sum += influences[k].weight;
    has_unbound = has_unbound || !(sum > 0.0);
    if (!(sum > 0.0)) influences[0].weight = sum = 1.0;
    for (int k = 0; k < 4; ++k) {
      const Influence& influence = influences[static_cast<size_t>(k)];
      const auto weight = static_cast<float>(influence.weight / sum);
      vertices.weights[i][k] = weight;
      vertices.joints[i][k] = weight > 0.0F ? influence.joint : uint16_t{0};
    }
  }
  if (has_unbound) warnings.add("some vertices hang on no bone; they follow one of them");
  return {};
}

Result<void> read_targets(const tinygltf::Primitive& primitive, AccessorReader& reader, AvatarVertices& vertices) {
  for (const std::map<std::string, int>& target : primitive.targets) {
    AvatarMorph morph;
    if (const auto position = attribute(target, "POSITION")) {
      auto read = reader.displacements(*position, vertices.positions.size());
      if (!read) return tl::unexpected<Error>(std::move(read.error()));
      morph.vertices = std::move(read->vertices);
      morph.positions = std::move(read->values);
    }
    if (const auto normal = attribute(target, "NORMAL")) {
      auto read = reader.displacements(*normal, vertices.positions.size());
      if (!read) return tl::unexpected<Error>(std::move(read.error()));
      morph.normal_vertices = std::move(read->vertices);
      morph.normals = std::move(read->values);
    }
    for (const auto* values : {&morph.positions, &morph.normals})
      for (const glm::vec3& value : *values)
        if (!std::isfinite(value.x) || !std::isfinite(value.y) || !std::isfinite(value.z))
          return malformed("a displacement is not finite", "targets");
    vertices.morphs.push_back(std::move(morph));
  }
  return {};
}

/// All but normals that the file does not have: they need the triangles of every surface.
Result<AvatarVertices> read_vertices(const tinygltf::Primitive& primitive, int texture_set, AccessorReader& reader,
                                     const std::string& place, Warnings& warnings) {
  AvatarVertices vertices;
  const auto positions = reader.elements(*attribute(primitive.attributes, "POSITION"), 3);
  if (!positions) return tl::unexpected<Error>(positions.error());
  if (positions->size() / 3 > kMaxAvatarVertices)
    return fail(ErrorCode::kLimit, "the mesh has more than two million vertices; simplify it", place);
  vertices.positions = vectors_of(*positions);
  const size_t count = vertices.positions.size();
  const auto differs = [&] {
    return malformed("the attributes of the mesh differ in their number of vertices", place);
  };
  if (const auto normal = attribute(primitive.attributes, "NORMAL")) {
    const auto normals = reader.elements(*normal, 3);
    if (!normals) return tl::unexpected<Error>(normals.error());
    vertices.normals = vectors_of(*normals);
    if (vertices.normals.size() != count) return differs();
    for (glm::vec3& each : vertices.normals)
      each = unit_or_up(glm::dvec3(each));
  }
  if (const auto set = attribute(primitive.attributes, "TEXCOORD_" + std::to_string(texture_set))) {
    const auto numbers = reader.elements(*set, 2);
    if (!numbers) return tl::unexpected<Error>(numbers.error());
    if (numbers->size() != 2 * count) return differs();
    vertices.texture_coordinates.resize(count);
    for (size_t i = 0; i < count; ++i)
      vertices.texture_coordinates[i] = glm::vec2(glm::dvec2((*numbers)[2 * i], (*numbers)[2 * i + 1]));
  }
  if (const auto colour = attribute(primitive.attributes, "COLOR_0")) {
    auto colours = reader.colours(*colour, glm::dvec3(1.0));
    if (!colours) return tl::unexpected<Error>(std::move(colours.error()));
    vertices.colours = *std::move(colours);
    if (vertices.colours.size() != count) return differs();
  }
  if (auto read = read_influences(primitive, reader, place, vertices, warnings); !read)
    return tl::unexpected<Error>(std::move(read.error()));
  if (auto read = read_targets(primitive, reader, vertices); !read)
    return tl::unexpected<Error>(std::move(read.error()));
  return vertices;
}

Result<std::vector<uint32_t>> read_triangles(const tinygltf::Primitive& primitive, size_t vertices,
                                             AccessorReader& reader, const std::string& place, size_t& triangles_left) {
  const auto too_many = [&] {
    return fail(ErrorCode::kLimit, "the meshes have more than two million triangles together; simplify them", place);
  };
  std::vector<uint32_t> indices;
  if (primitive.indices >= 0) {
    auto read = reader.indices(primitive.indices);
    if (!read) return tl::unexpected<Error>(std::move(read.error()));
    indices = *std::move(read);
    for (const uint32_t index : indices)
      if (index >= vertices) return malformed("an index of the mesh has no vertex", place);
  } else {
    if (vertices / 3 > triangles_left) return too_many();
    indices.resize(vertices);
    std::iota(indices.begin(), indices.end(), 0U);
  }
  const size_t count = primitive.mode == kTriangles ? indices.size() / 3 : std::max<size_t>(indices.size(), 2) - 2;
  if (count > triangles_left) return too_many();
  triangles_left -= count;
  if (primitive.mode == kTriangles) {
    if (indices.size() % 3 != 0) return malformed("the mesh has a piece of a triangle", place);
    return indices;
  }
  std::vector<uint32_t> triangles;
  triangles.reserve(3 * count);
  for (size_t i = 0; i + 2 < indices.size(); ++i) {
    const bool is_odd = i % 2 == 1;
    if (primitive.mode == kTriangleFan)
      triangles.insert(triangles.end(), {indices[0], indices[i + 1], indices[i + 2]});
    else
      triangles.insert(triangles.end(), {indices[is_odd ? i + 1 : i], indices[is_odd ? i : i + 1], indices[i + 2]});
  }
  return triangles;
}

/// False where glTF (2.0, 5.26) has no such number.
bool read_wrap(int number, ImageWrap& wrap) {
  switch (number) {
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
      wrap = ImageWrap::kRepeat;
      return true;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      wrap = ImageWrap::kClamp;
      return true;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      wrap = ImageWrap::kMirroredRepeat;
      return true;
    default:
      return false;
  }
}

/// How the image of a texture lies by KHR_texture_transform, which may choose other coordinates.
void place_image(const tinygltf::TextureInfo& info, ImagePlacement& placement, int& set) {
  const auto transform = info.extensions.find("KHR_texture_transform");
  if (transform == info.extensions.end() || !transform->second.IsObject()) return;
  const auto number = [](const tinygltf::Value& value, double usual) {
    constexpr double kMost = 1e4;
    return value.IsNumber() ? std::clamp(value.GetNumberAsDouble(), -kMost, kMost) : usual;
  };
  const auto pair = [&](const char* key, double usual) {
    const tinygltf::Value& value = transform->second.Get(key);
    if (value.ArrayLen() != 2) return glm::dvec2(usual);
    return glm::dvec2(number(value.Get(0), usual), number(value.Get(1), usual));
  };
  const glm::dvec2 scale = pair("scale", 1.0);
  double s = 0.0;
  double c = 0.0;
  sine_cosine(number(transform->second.Get("rotation"), 0.0), s, c);
  placement.origin = glm::vec2(pair("offset", 0.0));
  // Counter-clockwise on the image, whose v runs down.
  placement.x_axis = glm::vec2(glm::dvec2(c, -s) * scale.x);
  placement.y_axis = glm::vec2(glm::dvec2(s, c) * scale.y);
  if (const tinygltf::Value& other = transform->second.Get("texCoord"); other.IsInt()) set = other.GetNumberAsInt();
}

/// What of a material is kept. `set` receives which texture coordinates the image takes.
Result<void> read_material(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& place,
                           AvatarSurface& surface, int& set, Warnings& warnings) {
  if (primitive.material < 0) return {};
  if (static_cast<size_t>(primitive.material) >= model.materials.size())
    return malformed("the material of the mesh does not exist", place);
  const tinygltf::Material& material = model.materials[static_cast<size_t>(primitive.material)];
  surface.material = material.name;
  surface.is_double_sided = material.doubleSided;
  surface.is_transparent = material.alphaMode == "BLEND";
  if (material.alphaMode == "MASK")
    surface.alpha_cutoff = static_cast<float>(std::clamp(material.alphaCutoff, 0.0, 2.0));
  if (material.extensions.contains("VRMC_materials_mtoon"))
    warnings.add("surfaces are shaded as toons (MToon); they are drawn plain");
  if (material.normalTexture.index >= 0) warnings.add("images that shape surfaces (normal maps) are not used");
  const auto& base = material.pbrMetallicRoughness;
  if (base.baseColorFactor.size() == 4)
    for (int c = 0; c < 4; ++c)
      surface.base_colour[c] = static_cast<float>(std::clamp(base.baseColorFactor[static_cast<size_t>(c)], 0.0, 1.0));
  if (base.baseColorTexture.index < 0) return {};
  if (static_cast<size_t>(base.baseColorTexture.index) >= model.textures.size())
    return malformed("the texture of the material does not exist", place);
  const tinygltf::Texture& texture = model.textures[static_cast<size_t>(base.baseColorTexture.index)];
  const int image = texture.source;
  if (image < 0) {
    warnings.add("some images are neither PNG nor JPEG; their surfaces keep the base colour alone");
    return {};
  }
  if (static_cast<size_t>(image) >= model.images.size())
    return malformed("the image of the texture does not exist", place);
  set = base.baseColorTexture.texCoord;
  surface.image = image;
  if (texture.sampler >= 0) {
    if (static_cast<size_t>(texture.sampler) >= model.samplers.size())
      return malformed("the sampler of the texture does not exist", place);
    const tinygltf::Sampler& sampler = model.samplers[static_cast<size_t>(texture.sampler)];
    if (!read_wrap(sampler.wrapS, surface.wrap_u) || !read_wrap(sampler.wrapT, surface.wrap_v))
      return malformed("the sampler of the texture wraps in a way that glTF does not have", place);
  }
  if (surface.is_transparent)
    warnings.add("some surfaces let light through; they are drawn where they are more than half there");
  place_image(base.baseColorTexture, surface.placement, set);
  if (set < 0 || set > 15) return malformed("the texture takes coordinates that cannot exist", place);
  return {};
}

/// The names of morph targets stand in the extras of the mesh or, by older exporters, of its first primitive.
std::vector<std::string> morph_names(const tinygltf::Mesh& mesh, size_t count) {
  std::vector<std::string> names(count);
  const auto read = [&](const tinygltf::Value& extras) {
    // Asked first: tinygltf asserts where it is no object.
    const tinygltf::Value list = extras.IsObject() ? extras.Get("targetNames") : tinygltf::Value();
    for (size_t i = 0; i < count && i < list.ArrayLen(); ++i)
      if (const tinygltf::Value& name = list.Get(static_cast<int>(i)); name.IsString() && names[i].empty())
        names[i] = name.Get<std::string>();
  };
  read(mesh.extras);
  for (const tinygltf::Primitive& primitive : mesh.primitives)
    read(primitive.extras);
  return names;
}

/// What primitives must have in common to share their vertices.
struct VertexKey {
  std::map<std::string, int> attributes;
  std::vector<std::map<std::string, int>> targets;
  int texture_set = 0;
  bool operator==(const VertexKey&) const = default;
};

}  // namespace

void Warnings::add(std::string text) {
  if (texts_.size() < kMaxWarnings && std::ranges::find(texts_, text) == texts_.end())
    texts_.push_back(std::move(text));
}

std::string shortened(const std::string& name) {
  constexpr size_t kMostBytes = 60;
  if (name.size() <= kMostBytes) return name;
  size_t end = kMostBytes;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U)  // not within a UTF-8 sequence
    --end;
  return name.substr(0, end) + "...";
}

Result<AvatarMesh> read_avatar_mesh(const tinygltf::Model& model, int index, AccessorReader& reader,
                                    size_t& triangles_left, Warnings& warnings) {
  const tinygltf::Mesh& source = model.meshes[static_cast<size_t>(index)];
  const std::string place = place_of("meshes", index, source.name);
  AvatarMesh mesh;
  mesh.name = source.name;
  if (source.primitives.size() > kMaxPrimitives)
    return fail(ErrorCode::kLimit, "the mesh has more than 1024 parts; join those of one material", place);
  std::map<int, std::vector<std::pair<VertexKey, int>>> read_already;  // by the accessor of the positions
  size_t morphs = 0;
  for (const tinygltf::Primitive& primitive : source.primitives) {
    const auto position = attribute(primitive.attributes, "POSITION");
    if (primitive.mode != kTriangles && primitive.mode != kTriangleStrip && primitive.mode != kTriangleFan) {
      warnings.add("points and lines are left out");
      continue;
    }
    if (!position) {
      warnings.add("a mesh without positions is left out");
      continue;
    }
    AvatarSurface surface;
    int texture_set = 0;
    if (auto read = read_material(model, primitive, place, surface, texture_set, warnings); !read)
      return tl::unexpected<Error>(std::move(read.error()));
    VertexKey key{.attributes = primitive.attributes, .targets = primitive.targets, .texture_set = texture_set};
    auto& candidates = read_already[*position];
    const auto same = std::ranges::find(candidates, key, &std::pair<VertexKey, int>::first);
    if (same != candidates.end()) {
      surface.vertices = same->second;
    } else {
      auto vertices = read_vertices(primitive, texture_set, reader, place, warnings);
      if (!vertices) return tl::unexpected<Error>(std::move(vertices.error()));
      surface.vertices = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back(*std::move(vertices));
      candidates.emplace_back(std::move(key), surface.vertices);
    }
    const size_t count = mesh.vertices[static_cast<size_t>(surface.vertices)].positions.size();
    auto triangles = read_triangles(primitive, count, reader, place, triangles_left);
    if (!triangles) return tl::unexpected<Error>(std::move(triangles.error()));
    surface.indices = *std::move(triangles);
    morphs = std::max(morphs, primitive.targets.size());
    mesh.surfaces.push_back(std::move(surface));
  }
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    AvatarVertices& vertices = mesh.vertices[v];
    if (!vertices.normals.empty()) continue;
    std::vector<glm::dvec3> sums(vertices.positions.size(), glm::dvec3(0.0));
    for (const AvatarSurface& surface : mesh.surfaces)
      if (surface.vertices == static_cast<int>(v)) add_normals(surface.indices, vertices, sums);
    vertices.normals.resize(sums.size());
    std::ranges::transform(sums, vertices.normals.begin(), unit_or_up);
  }
  mesh.morph_names = morph_names(source, morphs);
  mesh.morph_weights.resize(morphs, 0.0F);
  for (size_t i = 0; i < morphs && i < source.weights.size(); ++i)
    mesh.morph_weights[i] = static_cast<float>(std::clamp(source.weights[i], -1.0, 1.0));
  return mesh;
}

}  // namespace auslan::gltf
