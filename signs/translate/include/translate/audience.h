// SPDX-License-Identifier: Apache-2.0
// Whom a translation is for: the dialect of Auslan, and whether doubtful signs that could do harm may be used.
#pragma once

#include "translate/translator.h"

#include <optional>
#include <string_view>

namespace auslan {

/// The two dialects of Auslan: north (New South Wales, Queensland), south (Victoria, Tasmania, South and Western
/// Australia); Johnston & Schembri 2007.
enum class Dialect { kNorth, kSouth };
std::optional<Dialect> dialect_from_name(std::string_view name);

struct Audience {
  std::optional<Dialect> dialect;  ///< of signs that differ; none: the first choice of the lexicon
  bool strict = false;             ///< what is_doubtful() is spelled
};

/// A safety-critical sign of low confidence that no Deaf signer has approved.
bool is_doubtful(const EntryFacts& entry);

/// Makes a dialect's signs the first choice for their words and in phrases (WATER-NORTH in the place of WATER), and
/// leaves out what is doubtful where that is asked for: the translator spells what it does not have.
void suit(TranslatorData& data, const Audience& audience);

}  // namespace auslan
