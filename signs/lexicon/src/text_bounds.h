// SPDX-License-Identifier: Apache-2.0
// What is looked at before the TOML parser sees a file: size, line length, nesting and dotted keys, so that no input
// can exhaust memory or the stack.
#pragma once

#include "lexicon/lexicon_text.h"

#include <optional>

namespace auslan {

/// The first broken bound (place name:line), or nothing.
std::optional<Error> find_broken_bound(const TextSource& source);

}  // namespace auslan
