// SPDX-License-Identifier: Apache-2.0
// A .glb taken apart into its JSON and its binary chunk, so that tests can break one thing in it.
#pragma once

#include "gltf/figure_gltf.h"
#include "kinematics/little_endian.h"
#include "sample_figure.h"

#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>

namespace auslan::test {

struct GlbDocument {
  nlohmann::json json;
  std::string binary;

  /// The accessor of an attribute of a mesh's only primitive.
  nlohmann::json& attribute(size_t mesh, const char* name) {
    return json["accessors"][json["meshes"][mesh]["primitives"][0]["attributes"][name].get<size_t>()];
  }
  nlohmann::json& index_accessor(size_t mesh) {
    return json["accessors"][json["meshes"][mesh]["primitives"][0]["indices"].get<size_t>()];
  }
  nlohmann::json& target(size_t mesh, size_t target) {
    return json["accessors"][json["meshes"][mesh]["primitives"][0]["targets"][target]["POSITION"].get<size_t>()];
  }
  /// Where in `binary` something with a bufferView and a byteOffset begins.
  size_t start(const nlohmann::json& block) const {
    return json["bufferViews"][block["bufferView"].get<size_t>()]["byteOffset"].get<size_t>() +
           block["byteOffset"].get<size_t>();
  }
  template <typename T>
  void store(size_t at, T value) {
    std::string bytes;
    append_little_endian(bytes, value);
    binary.replace(at, bytes.size(), bytes);
  }
  /// Adds bytes to the buffer under a bufferView of their own and gives its index.
  size_t add_view(const std::string& bytes) {
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
    binary += bytes;
    binary.resize((binary.size() + 3) / 4 * 4);
    json["buffers"][0]["byteLength"] = binary.size();
    return json["bufferViews"].size() - 1;
  }

  std::string pack() const { return pack(json.dump()); }
  /// With this text in place of the JSON.
  std::string pack(std::string text) const {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string file = "glTF";
    append_little_endian(file, uint32_t{2});
    append_little_endian(file, static_cast<uint32_t>(12 + 8 + text.size() + 8 + binary.size()));
    append_little_endian(file, static_cast<uint32_t>(text.size()));
    file += "JSON" + text;
    append_little_endian(file, static_cast<uint32_t>(binary.size()));
    file += std::string("BIN\0", 4) + binary;
    return file;
  }
};

inline GlbDocument open_glb(const std::string& glb) {
  const auto length = load_little_endian<uint32_t>(glb.data() + 12);
  return {.json = nlohmann::json::parse(glb.substr(20, length)), .binary = glb.substr(20 + length + 8)};
}

inline std::string glb_bytes(const Figure& figure) {
  const ScratchFolder folder;
  const auto written = write_gltf(figure, folder / "figure.glb");
  if (!written) throw std::runtime_error(to_string(written.error()));
  return bytes_of(folder / "figure.glb");
}

inline Result<Figure> parse_text(const std::string& bytes, const std::filesystem::path& folder = {}) {
  return parse_gltf(std::as_bytes(std::span(bytes)), folder);
}

}  // namespace auslan::test
