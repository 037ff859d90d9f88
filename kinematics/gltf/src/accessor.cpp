// SPDX-License-Identifier: Apache-2.0
#include "accessor.h"

#include "gltf_format.h"
#include "kinematics/little_endian.h"
#include "light_encoding.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tiny_gltf.h>
#include <utility>

namespace auslan::gltf {
namespace {

/// Numbers that one file may ask for, as doubles: 128 MiB if all were held at once.
constexpr size_t kMaxNumbers = size_t{16} << 20;

tl::unexpected<Error> malformed(std::string message, std::string place) {
  return fail(ErrorCode::kMalformed, std::move(message), std::move(place));
}

/// Bytes of the component types that figures use; 0 for any other.
size_t component_bytes(int component_type) {
  switch (component_type) {
    case kByte:
    case kUnsignedByte:
      return 1;
    case kShort:
    case kUnsignedShort:
      return 2;
    case kUnsignedInt:
    case kFloat:
      return 4;
    default:
      return 0;
  }
}

size_t component_count(int type) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
      return 4;
    case TINYGLTF_TYPE_MAT4:
      return 16;
    default:
      return 0;
  }
}

double load_component(const unsigned char* at, int component_type) {
  switch (component_type) {
    case kByte:
      return static_cast<int8_t>(*at);
    case kUnsignedByte:
      return *at;
    case kShort:
      return load_little_endian<int16_t>(at);
    case kUnsignedShort:
      return load_little_endian<uint16_t>(at);
    case kUnsignedInt:
      return load_little_endian<uint32_t>(at);
    default:
      return static_cast<double>(load_little_endian<float>(at));
  }
}

/// What a normalised integer of that type is a fraction of; 1 for floats.
double whole_of(int component_type) {
  switch (component_type) {
    case kByte:
      return 127.0;
    case kUnsignedByte:
      return 255.0;
    case kShort:
      return 32767.0;
    case kUnsignedShort:
      return 65535.0;
    default:
      return 1.0;
  }
}

bool is_unsigned_integer(int component_type) {
  return component_type == kUnsignedByte || component_type == kUnsignedShort || component_type == kUnsignedInt;
}

void load_elements(const unsigned char* data, size_t stride, int component_type, size_t components,
                   std::span<double> values) {
  const size_t bytes = component_bytes(component_type);
  for (size_t i = 0; i < values.size(); ++i)
    values[i] = load_component(data + i / components * stride + i % components * bytes, component_type);
}

std::string place_of(int accessor) {
  return "accessors[" + std::to_string(accessor) + "]";
}

/// Exact: the double came from a float.
glm::vec3 vector_at(const std::vector<double>& values, size_t i) {
  return {static_cast<float>(values[3 * i]), static_cast<float>(values[3 * i + 1]),
          static_cast<float>(values[3 * i + 2])};
}

}  // namespace

uint8_t srgb_from_fraction(double linear) {
  if (!(linear > 0.0)) return 0;
  if (linear >= 1.0) return 255;
  return srgb_from_linear(static_cast<uint16_t>(linear * 65535.0 + 0.5));
}

Result<const tinygltf::Accessor*> AccessorReader::find(int accessor) {
  if (accessor < 0 || static_cast<size_t>(accessor) >= model_.accessors.size())
    return malformed("the accessor does not exist", place_of(accessor));
  return &model_.accessors[static_cast<size_t>(accessor)];
}

Result<void> AccessorReader::spend(size_t numbers, const std::string& place) {
  if (numbers > kMaxNumbers - spent_)
    return fail(ErrorCode::kLimit, "the meshes hold more than 16 million numbers; use fewer vertices", place);
  spent_ += numbers;
  return {};
}

Result<AccessorReader::Block> AccessorReader::block(int view, size_t offset, size_t count, size_t element_bytes,
                                                    const std::string& place) const {
  if (view < 0 || static_cast<size_t>(view) >= model_.bufferViews.size())
    return malformed("the bufferView does not exist", place);
  const tinygltf::BufferView& found = model_.bufferViews[static_cast<size_t>(view)];
  if (found.buffer < 0 || static_cast<size_t>(found.buffer) >= model_.buffers.size())
    return malformed("the buffer of the bufferView does not exist", place);
  const std::vector<unsigned char>& buffer = model_.buffers[static_cast<size_t>(found.buffer)].data;
  if (found.byteOffset > buffer.size() || found.byteLength > buffer.size() - found.byteOffset)
    return malformed("the bufferView lies outside its buffer", place);
  const size_t stride = found.byteStride == 0 ? element_bytes : found.byteStride;
  if (stride < element_bytes) return malformed("the stride is shorter than an element", place);
  // `count` was bounded by spend(), and tinygltf refuses strides above 252, so that nothing here overflows.
  if (count > 0 && (offset > found.byteLength || (count - 1) * stride + element_bytes > found.byteLength - offset))
    return malformed("the accessor asks for more than its bufferView holds", place);
  return Block{.data = buffer.data() + (count > 0 ? found.byteOffset + offset : 0), .stride = stride};
}

Result<AccessorReader::Numbers> AccessorReader::base(const tinygltf::Accessor& accessor, const std::string& place) {
  const size_t bytes = component_bytes(accessor.componentType);
  const size_t components = component_count(accessor.type);
  if (bytes == 0 || components == 0)
    return fail(ErrorCode::kUnsupported, "figures use no accessors of this type", place);
  if (accessor.count == 0) return malformed("the accessor is empty", place);
  if (accessor.count > kMaxNumbers)
    return accessor.bufferView < 0 ? fail(ErrorCode::kLimit, "the accessor has too many elements", place)
                                   : malformed("the accessor asks for more than its bufferView holds", place);
  const size_t count = accessor.count * components;
  // Before the room is made: a count that the file cannot back is an error of the file, not a question of size.
  Block from;
  if (accessor.bufferView >= 0) {
    const auto found = block(accessor.bufferView, accessor.byteOffset, accessor.count, bytes * components, place);
    if (!found) return tl::unexpected<Error>(found.error());
    from = *found;
  }
  if (auto spent = spend(count, place); !spent) return tl::unexpected<Error>(std::move(spent.error()));
  Numbers numbers{
      .component_type = accessor.componentType, .components = components, .values = std::vector<double>(count, 0.0)};
  if (from.data != nullptr) load_elements(from.data, from.stride, numbers.component_type, components, numbers.values);
  return numbers;
}

Result<std::vector<uint32_t>> AccessorReader::sparse_indices(const tinygltf::Accessor& accessor,
                                                             const std::string& place) {
  const int type = accessor.sparse.indices.componentType;
  if (!is_unsigned_integer(type)) return malformed("sparse indices must be unsigned integers", place);
  if (accessor.sparse.count < 1 || static_cast<size_t>(accessor.sparse.count) > accessor.count ||
      accessor.sparse.indices.byteOffset < 0)
    return malformed("the sparse part has an impossible count or offset", place);
  const auto count = static_cast<size_t>(accessor.sparse.count);
  if (auto spent = spend(count, place); !spent) return tl::unexpected<Error>(std::move(spent.error()));
  const auto from = block(accessor.sparse.indices.bufferView, static_cast<size_t>(accessor.sparse.indices.byteOffset),
                          count, component_bytes(type), place);
  if (!from) return tl::unexpected<Error>(from.error());
  std::vector<uint32_t> indices(count);
  for (size_t i = 0; i < count; ++i) {
    indices[i] = static_cast<uint32_t>(load_component(from->data + i * from->stride, type));
    if (indices[i] >= accessor.count || (i > 0 && indices[i] <= indices[i - 1]))
      return malformed("sparse indices must ascend and stay below the count", place);
  }
  return indices;
}

Result<AccessorReader::Numbers> AccessorReader::sparse_values(const tinygltf::Accessor& accessor,
                                                              const std::string& place) {
  if (accessor.sparse.values.byteOffset < 0) return malformed("the sparse part has an impossible offset", place);
  tinygltf::Accessor dense;
  dense.bufferView = accessor.sparse.values.bufferView;
  dense.byteOffset = static_cast<size_t>(accessor.sparse.values.byteOffset);
  dense.componentType = accessor.componentType;
  dense.type = accessor.type;
  dense.count = static_cast<size_t>(accessor.sparse.count);
  if (dense.bufferView < 0) return malformed("the sparse part has no bufferView", place);
  return base(dense, place);
}

Result<AccessorReader::Numbers> AccessorReader::numbers(int accessor) {
  const std::string place = place_of(accessor);
  const auto found = find(accessor);
  if (!found) return tl::unexpected<Error>(found.error());
  auto numbers = base(**found, place);
  if (!numbers || !(*found)->sparse.isSparse) return numbers;
  const auto indices = sparse_indices(**found, place);
  if (!indices) return tl::unexpected<Error>(indices.error());
  const auto values = sparse_values(**found, place);
  if (!values) return tl::unexpected<Error>(values.error());
  for (size_t i = 0; i < values->values.size(); ++i)
    numbers->values[(*indices)[i / values->components] * values->components + i % values->components] =
        values->values[i];
  return numbers;
}

Result<std::vector<glm::vec3>> AccessorReader::vectors(int accessor) {
  const auto read = numbers(accessor);
  if (!read) return tl::unexpected<Error>(read.error());
  if (read->component_type != kFloat || read->components != 3)
    return malformed("positions, normals and displacements must be VEC3 of floats", place_of(accessor));
  std::vector<glm::vec3> vectors(read->values.size() / 3);
  for (size_t i = 0; i < vectors.size(); ++i)
    vectors[i] = vector_at(read->values, i);
  return vectors;
}

Result<std::vector<uint32_t>> AccessorReader::indices(int accessor) {
  const auto read = numbers(accessor);
  if (!read) return tl::unexpected<Error>(read.error());
  if (!is_unsigned_integer(read->component_type) || read->components != 1)
    return malformed("indices must be SCALAR unsigned integers", place_of(accessor));
  std::vector<uint32_t> indices(read->values.size());
  for (size_t i = 0; i < indices.size(); ++i)
    indices[i] = static_cast<uint32_t>(read->values[i]);
  return indices;
}

Result<std::vector<glm::u8vec4>> AccessorReader::colours(int accessor, const glm::dvec3& factor) {
  const auto read = numbers(accessor);
  if (!read) return tl::unexpected<Error>(read.error());
  const bool is_float = read->component_type == kFloat;
  const bool is_small = read->component_type == kUnsignedByte || read->component_type == kUnsignedShort;
  if (read->components < 3 || read->components > 4 || (!is_float && !is_small) ||
      (!is_float && !model_.accessors[static_cast<size_t>(accessor)].normalized))
    return malformed("COLOR_0 must be VEC3 or VEC4 of floats or of normalised 8- or 16-bit integers",
                     place_of(accessor));
  const double whole = whole_of(read->component_type);
  std::vector<glm::u8vec4> colours(read->values.size() / read->components);
  for (size_t i = 0; i < colours.size(); ++i) {
    colours[i].w = 255;
    for (int c = 0; c < 3; ++c) {
      const double value = read->values[i * read->components + static_cast<size_t>(c)];
      if (!std::isfinite(value)) return malformed("a colour is not a finite number", place_of(accessor));
      colours[i][c] = srgb_from_fraction(value / whole * factor[c]);
    }
  }
  return colours;
}

Result<std::vector<double>> AccessorReader::elements(int accessor, size_t components) {
  auto read = numbers(accessor);
  if (!read) return tl::unexpected<Error>(std::move(read.error()));
  if (read->components != components || read->component_type == kUnsignedInt)
    return malformed("the accessor has the wrong type for its use", place_of(accessor));
  const bool is_fraction = model_.accessors[static_cast<size_t>(accessor)].normalized;
  const double whole = is_fraction ? whole_of(read->component_type) : 1.0;
  for (double& value : read->values) {
    if (!std::isfinite(value)) return malformed("a number is not finite", place_of(accessor));
    value = whole == 1.0 ? value : std::max(value / whole, -1.0);
  }
  return std::move(read->values);
}

Result<SparseVectors> AccessorReader::displacements(int accessor, size_t vertices) {
  const std::string place = place_of(accessor);
  const auto found = find(accessor);
  if (!found) return tl::unexpected<Error>(found.error());
  if ((*found)->count != vertices) return malformed("a morph target needs one displacement a vertex", place);
  SparseVectors result;
  if ((*found)->bufferView < 0 && (*found)->sparse.isSparse && (*found)->componentType == kFloat) {
    auto indices = sparse_indices(**found, place);
    if (!indices) return tl::unexpected<Error>(std::move(indices.error()));
    const auto values = sparse_values(**found, place);
    if (!values) return tl::unexpected<Error>(values.error());
    if (values->components != 3) return malformed("displacements must be VEC3 of floats", place);
    result.vertices = *std::move(indices);
    for (size_t i = 0; i < result.vertices.size(); ++i)
      result.values.push_back(vector_at(values->values, i));
    return result;
  }
  if ((*found)->bufferView < 0 && !(*found)->sparse.isSparse) return result;  // zeros that take no room
  const auto dense = elements(accessor, 3);
  if (!dense) return tl::unexpected<Error>(dense.error());
  for (size_t i = 0; i < vertices; ++i) {
    const glm::vec3 value = vector_at(*dense, i);
    if (value == glm::vec3(0.0F)) continue;
    result.vertices.push_back(static_cast<uint32_t>(i));
    result.values.push_back(value);
  }
  return result;
}

Result<Morph> AccessorReader::displacement(int accessor, FaceChannel channel, size_t vertices) {
  auto read = displacements(accessor, vertices);
  if (!read) return tl::unexpected<Error>(std::move(read.error()));
  return Morph{.channel = channel, .vertices = std::move(read->vertices), .displacement = std::move(read->values)};
}

}  // namespace auslan::gltf
