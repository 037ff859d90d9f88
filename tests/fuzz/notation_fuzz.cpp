// SPDX-License-Identifier: Apache-2.0
// Any bytes as a SiGML file and as a HamNoSys string: the readers must return, and what they call signable must be.
#include "notation/notation.h"

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

void check(const auslan::NotatedSign& notated) {
  const auslan::Sign& sign = notated.sign;
  if (notated.signable == sign.dominant.empty()) std::abort();
  bool refused = false;
  for (const auslan::Diagnostic& diagnostic : notated.diagnostics) {
    if (diagnostic.line < 1 || diagnostic.column < 1) std::abort();
    refused = refused || diagnostic.grade == auslan::Diagnostic::Grade::kError;
  }
  if (refused == notated.signable) std::abort();
  const int phases = static_cast<int>(sign.dominant.size());
  for (const auslan::Movement& movement : sign.movements)
    if (movement.from < 0 || movement.to < movement.from || movement.to >= phases || movement.repeats < 1) std::abort();
  for (const auto* postures : {&sign.dominant, &sign.non_dominant})
    for (const auslan::Posture& posture : *postures) {
      bool known = false;
      for (const auslan::Handshape& shape : notated.handshapes)
        known = known || shape.id == posture.handshape;
      if (!known) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto signs = auslan::parse_sigml(text, "fuzz"))
    for (const auslan::NotatedSign& sign : *signs)
      check(sign);
  if (const auto sign = auslan::parse_hamnosys(text)) check(*sign);
  return 0;
}
