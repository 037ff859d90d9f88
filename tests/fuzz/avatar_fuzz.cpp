// SPDX-License-Identifier: Apache-2.0
// Bytes as a figure of another maker: .gltf or .glb; and, so that the fuzzer need not find the lengths of chunks by
// itself, as the JSON and the binary chunk of a .glb.
#include "avatar_promises.h"
#include "gltf/avatar_gltf.h"
#include "kinematics/little_endian.h"

#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

namespace {

void read(const std::string& bytes) {
  const auto avatar = auslan::parse_avatar(std::as_bytes(std::span(bytes)), "/nonexistent");
  if (avatar ? !auslan::test::broken_promise(*avatar).empty() : avatar.error().message.empty()) std::abort();
}

std::string as_glb(std::string json, std::string binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4);
  std::string glb = "glTF";
  auslan::append_little_endian(glb, uint32_t{2});
  auslan::append_little_endian(glb, static_cast<uint32_t>(28 + json.size() + binary.size()));
  auslan::append_little_endian(glb, static_cast<uint32_t>(json.size()));
  glb += "JSON" + json;
  auslan::append_little_endian(glb, static_cast<uint32_t>(binary.size()));
  return glb + std::string("BIN\0", 4) + binary;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  read(bytes);
  if (const size_t end = bytes.find('\0'); end != std::string::npos)
    read(as_glb(bytes.substr(0, end), bytes.substr(end + 1)));
  return 0;
}
