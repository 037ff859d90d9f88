// SPDX-License-Identifier: Apache-2.0
// What the fuzzers of glTF readers do with their bytes: they are a file; and, so that the fuzzer need not find the
// lengths of chunks by itself, what stands before and behind the first zero is the JSON and the binary chunk of a .glb.
#pragma once

#include "kinematics/little_endian.h"

#include <cstdint>
#include <string>

namespace auslan {

inline std::string as_glb(std::string json, std::string binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4);
  std::string glb = "glTF";
  append_little_endian(glb, uint32_t{2});
  append_little_endian(glb, static_cast<uint32_t>(28 + json.size() + binary.size()));
  append_little_endian(glb, static_cast<uint32_t>(json.size()));
  glb += "JSON" + json;
  append_little_endian(glb, static_cast<uint32_t>(binary.size()));
  return glb + std::string("BIN\0", 4) + binary;
}

template <typename Read>
void read_both_ways(const uint8_t* data, size_t size, Read read) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  read(bytes);
  if (const size_t end = bytes.find('\0'); end != std::string::npos)
    read(as_glb(bytes.substr(0, end), bytes.substr(end + 1)));
}

}  // namespace auslan
