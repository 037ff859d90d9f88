// SPDX-License-Identifier: Apache-2.0
// Mouth pictures are written in SAMPA; the model mouths English spellings.
#pragma once

#include <string>
#include <string_view>

namespace auslan::notation {

/// A spelling whose letters have the written sounds, as far as English letters go: "wa:lf" -> "wahlf". Marks of stress
/// and signs that are no sound give nothing.
std::string spelling_of_sampa(std::string_view sampa);

}  // namespace auslan::notation
