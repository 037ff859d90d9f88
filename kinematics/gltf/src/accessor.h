// SPDX-License-Identifier: Apache-2.0
// The numbers behind glTF accessors, every index, range and count checked, sparse parts applied.
#pragma once

#include "kinematics/figure.h"
#include "kinematics/result.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
struct Accessor;
}  // namespace tinygltf

namespace auslan::gltf {

/// The vectors of some vertices, which ascend.
struct SparseVectors {
  std::vector<uint32_t> vertices;
  std::vector<glm::vec3> values;
};

/// Reads the accessors of one model, up to a bound on what they hold together: accessors may be shared and may stand
/// for zeros, so a short file can ask for any amount. Errors: kMalformed, kLimit, kUnsupported; `place` is the
/// accessor.
class AccessorReader {
 public:
  /// `model` outlives the reader.
  explicit AccessorReader(const tinygltf::Model& model) : model_(model) {}

  /// VEC3 of floats.
  Result<std::vector<glm::vec3>> vectors(int accessor);
  /// Unsigned integers.
  Result<std::vector<uint32_t>> indices(int accessor);
  /// Elements of `components` numbers each: floats, or integers of 8 or 16 bits, which are fractions of their largest
  /// value where the accessor is normalised. All finite.
  Result<std::vector<double>> elements(int accessor, size_t components);
  /// VEC3 or VEC4 of normalised integers or floats in linear light, times `factor`, as sRGB; alpha is dropped.
  Result<std::vector<glm::u8vec4>> colours(int accessor, const glm::dvec3& factor);
  /// VEC3 of floats for `vertices` vertices: those that a purely sparse accessor lists, else those that are not zero.
  Result<Morph> displacement(int accessor, FaceChannel channel, size_t vertices);
  /// The same without a channel, and of quantised displacements too.
  Result<SparseVectors> displacements(int accessor, size_t vertices);

 private:
  struct Numbers {
    int component_type = 0;
    size_t components = 0;
    std::vector<double> values;  ///< as stored, not normalised; `components` for each element
  };
  struct Block {
    const unsigned char* data = nullptr;
    size_t stride = 0;
  };

  Result<const tinygltf::Accessor*> find(int accessor);
  Result<Numbers> numbers(int accessor);
  Result<Numbers> base(const tinygltf::Accessor& accessor, const std::string& place);
  Result<std::vector<uint32_t>> sparse_indices(const tinygltf::Accessor& accessor, const std::string& place);
  Result<Numbers> sparse_values(const tinygltf::Accessor& accessor, const std::string& place);
  Result<Block> block(int view, size_t offset, size_t count, size_t element_bytes, const std::string& place) const;
  Result<void> spend(size_t numbers, const std::string& place);

  const tinygltf::Model& model_;
  size_t spent_ = 0;
};

/// One component of linear light, 0 to 1 (clamped), as an sRGB code value.
uint8_t srgb_from_fraction(double linear);

}  // namespace auslan::gltf
