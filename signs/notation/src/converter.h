// SPDX-License-Identifier: Apache-2.0
// From the written form of a sign to the elements of either kind of SiGML, and the way back.
#pragma once

#include "notation/written_element.h"
#include "written_sign.h"

namespace auslan::notation {

/// The element as XML, without a declaration.
std::string text_of(const WrittenElement& element);
/// The written form of an hns_sign or a hamgestural_sign; what is not understood is told.
WrittenSign written_sign(const WrittenElement& element, Findings& findings);

/// sign_manual elements of gestural SiGML, into `sign`.
void write_gestural(const WrittenSign& written, WrittenElement& sign, Findings& findings);
/// hamnosys_manual with its symbols, into `sign`.
void write_symbols(const WrittenSign& written, WrittenElement& sign, Findings& findings);
/// The non-manual part of `from` in the other kind, into `to`.
void write_tiers(const WrittenElement& from, WrittenElement& to, Findings& findings);
void write_hnm(const WrittenElement& from, WrittenElement& to, Findings& findings);

}  // namespace auslan::notation
