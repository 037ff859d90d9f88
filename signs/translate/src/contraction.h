// SPDX-License-Identifier: Apache-2.0
// English contractions: "don't" is two words, and the second is a negator that must not be lost.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

/// A part of a written word: its first `length` characters read as `norm`.
struct ContractionPart {
  size_t length = 0;  ///< characters (of the case-folded word, apostrophes included)
  std::string norm;
};

/// What the 's at the end of a word can be.
enum class ApostropheS { kNone, kCopula, kUnclear };

struct Contraction {
  std::vector<ContractionPart> parts;             ///< at least one; one part: not a contraction
  ApostropheS apostrophe_s = ApostropheS::kNone;  ///< kUnclear: the word ends in 's, left in place (noun's)
};

/// `word` is case-folded ASCII with plain apostrophes. Also reads the common spellings without an apostrophe ("dont").
Contraction expand_contraction(std::string_view word);

}  // namespace auslan
