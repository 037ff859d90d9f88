// SPDX-License-Identifier: Apache-2.0
#include "converter.h"

#include "notation/writer.h"
#include "written_of.h"

namespace auslan {

Result<ConvertedSign> convert(const NotatedSign& sign, NotationForm form) {
  using namespace notation;
  const auto from = form_of(sign.written);
  if (!from)
    return fail(ErrorCode::kUnsupported, "the element " + in_quotes(sign.written.name) +
                                             " is no sign that can be converted (expected hns_sign or "
                                             "hamgestural_sign)");
  ConvertedSign converted;
  if (*from == form) {
    converted.sign = sign;
    converted.same_sign = true;
    return converted;
  }
  Findings quiet, findings;
  const WrittenSign written = written_sign(sign.written, quiet);
  WrittenElement element;
  element.name = form == NotationForm::kGestural ? "hamgestural_sign" : "hns_sign";
  for (const auto& [name, value] : sign.written.attributes)
    element.put(name, value);
  for (const WrittenElement& child : sign.written.children) {
    if (child.name == "hamnosys_nonmanual") write_tiers(child, element, findings);
    if (child.name == "sign_nonmanual") write_hnm(child, element, findings);
  }
  (form == NotationForm::kGestural ? write_gestural : write_symbols)(written, element, findings);
  Findings again;
  const WrittenSign read = written_sign(element, again);
  converted.sign = sign_of(read, again);
  converted.sign.written = std::move(element);
  converted.same_sign = converted.sign.signable == sign.signable && converted.sign.sign == sign.sign &&
                        converted.sign.handshapes == sign.handshapes;
  const Mark start;
  if (!converted.same_sign)
    findings.warning(start, std::string("the sign in the other notation is not quite the same; compare ") +
                                "what is signed, or keep it in the notation it was written in");
  converted.findings = findings.take();
  return converted;
}

Result<ConvertedSign> notate(const Sign& sign, std::span<const Handshape> handshapes, NotationForm form) {
  using namespace notation;
  if (sign.dominant.empty())
    return fail(ErrorCode::kMalformed, "the sign " + sign.gloss + " has no posture, so there is nothing to write");
  Findings findings;
  const WrittenSign written = written_of(sign, handshapes, form, findings);
  WrittenElement element;
  element.name = form == NotationForm::kGestural ? "hamgestural_sign" : "hns_sign";
  element.put("gloss", sign.gloss);
  WrittenElement face;
  write_non_manual(sign.non_manual, face, findings);
  for (const WrittenElement& child : face.children) {
    if (form == NotationForm::kGestural) {
      write_tiers(child, element, findings);
    } else {
      element.children.push_back(child);
    }
  }
  (form == NotationForm::kGestural ? write_gestural : write_symbols)(written, element, findings);
  ConvertedSign converted;
  Findings again;
  converted.sign = sign_of(written_sign(element, again), again);
  converted.sign.written = std::move(element);
  converted.same_sign = converted.sign.sign == sign;
  for (Diagnostic& diagnostic : again.take())
    converted.sign.diagnostics.push_back(std::move(diagnostic));
  converted.findings = findings.take();
  return converted;
}

}  // namespace auslan
