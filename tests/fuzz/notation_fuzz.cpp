// SPDX-License-Identifier: Apache-2.0
// Any bytes as a SiGML file and as a HamNoSys string: the readers must return, and what they call signable must be.
#include "notation/notation.h"
#include "notation/writer.h"

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

/// Written and read again it is the same; only the limits of what is read may refuse what escaping made longer.
void check_written(const std::vector<auslan::NotatedSign>& signs) {
  const std::string written = auslan::write_sigml(signs);
  const auto again = auslan::parse_sigml(written, "again");
  if (!again) {
    if (again.error().code != auslan::ErrorCode::kLimit) std::abort();
    return;
  }
  if (again->size() != signs.size()) std::abort();
  for (size_t i = 0; i < signs.size(); ++i)
    if (!((*again)[i].written == signs[i].written && (*again)[i].sign == signs[i].sign &&
          (*again)[i].handshapes == signs[i].handshapes))
      std::abort();
  for (const auslan::NotatedSign& sign : signs)
    for (const auto form : {auslan::NotationForm::kSymbols, auslan::NotationForm::kGestural})
      if (const auto other = auslan::convert(sign, form)) check(other->sign);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto signs = auslan::parse_sigml(text, "fuzz")) {
    for (const auslan::NotatedSign& sign : *signs)
      check(sign);
    check_written(*signs);
  }
  if (const auto sign = auslan::parse_hamnosys(text)) {
    check(*sign);
    const auto string = auslan::write_hamnosys(*sign);
    if (!string) std::abort();
    const auto again = auslan::parse_hamnosys(*string);
    if (!sign->written.children.empty() && again && !(again->sign == sign->sign)) std::abort();
  }
  return 0;
}
