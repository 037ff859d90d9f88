// SPDX-License-Identifier: Apache-2.0
// Bytes as a baked figure; and as the payload of one whose header is right, or the checksum would stop every change.
#include "kinematics/figure_file.h"
#include "kinematics/little_endian.h"

#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

namespace {

void read(const std::string& bytes) {
  const auto figure = auslan::parse_figure(std::as_bytes(std::span(bytes)));
  if (!figure) {
    if (figure.error().message.empty()) std::abort();
    return;
  }
  if (!auslan::check_figure(*figure) || auslan::serialise_figure(*figure) != bytes) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  read(bytes);
  const std::string payload = bytes.size() > 32 ? bytes.substr(32) : bytes;
  std::string file = "AJFIGURE";
  auslan::append_little_endian(file, auslan::kFigureFileVersion);
  auslan::append_little_endian(file, uint32_t{0});
  auslan::append_little_endian(file, uint64_t{payload.size()});
  auslan::append_little_endian(file, auslan::figure_checksum(std::as_bytes(std::span(payload))));
  read(file + payload);
  return 0;
}
