// SPDX-License-Identifier: Apache-2.0
// Joint angles for a handshape as HamNoSys writes it: base form, thumb, bends, digits.
#pragma once

#include "written_sign.h"

namespace auslan::notation {

/// The handshape "ham:…"; with `second`, the mean of both. An unknown base form is told and read as a flat hand.
Handshape handshape_of(const WrittenShape& written, const std::optional<WrittenShape>& second, const Mark& mark,
                       Findings& findings);

}  // namespace auslan::notation
