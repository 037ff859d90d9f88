// SPDX-License-Identifier: Apache-2.0
// From the model back to what is written: the reverse of sign_of.h's way. For each part of a sign that writing is taken
// which the readers understand as most nearly the same, so that nothing has to be known twice.
#pragma once

#include "notation/writer.h"
#include "written_sign.h"

#include <optional>
#include <span>
#include <string_view>

namespace auslan::notation {

/// The manual part in what `form` can say; what it cannot is told to `findings`. Handshapes that are missing are told
/// and written as flat hands.
WrittenSign written_of(const Sign& sign, std::span<const Handshape> handshapes, NotationForm form, Findings& findings);

/// The element and the tag of hamnosys_nonmanual that are read as this word of the tier; nothing where none is.
struct WrittenFeature {
  std::string_view element, tag;
};
std::optional<WrittenFeature> feature_of(std::string_view tier, std::string_view word);

/// hamnosys_nonmanual of a sign's non-manual features, into `sign`; nothing where it has none.
void write_non_manual(const NonManual& face, WrittenElement& sign, Findings& findings);

}  // namespace auslan::notation
