// SPDX-License-Identifier: Apache-2.0
// Bytes as a figure of another maker, .gltf or .glb.
#include "avatar_promises.h"
#include "glb_of_bytes.h"
#include "gltf/avatar_gltf.h"

#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

namespace {

void read(const std::string& bytes) {
  const auto avatar = auslan::parse_avatar(std::as_bytes(std::span(bytes)), "/nonexistent");
  if (avatar ? !auslan::test::broken_promise(*avatar).empty() : avatar.error().message.empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  auslan::read_both_ways(data, size, read);
  return 0;
}
