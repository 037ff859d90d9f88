// SPDX-License-Identifier: Apache-2.0
// Bytes as .gltf or .glb.
#include "glb_of_bytes.h"
#include "gltf/figure_gltf.h"
#include "kinematics/figure_file.h"

#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

namespace {

void read(const std::string& bytes) {
  const auto figure = auslan::parse_gltf(std::as_bytes(std::span(bytes)), "/nonexistent");
  if (figure ? !auslan::check_figure(*figure) : figure.error().message.empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  auslan::read_both_ways(data, size, read);
  return 0;
}
