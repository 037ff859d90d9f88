// SPDX-License-Identifier: Apache-2.0
// A translation for people and for programs.
#pragma once

#include "translate/translation.h"

#include <string>
#include <string_view>

namespace auslan {

/// "sign", "spelled", "number", "pause", "dropped".
std::string_view to_name(ItemKind kind);

/// The items as a table in signing order (number, English, gloss, rules, confidence, review state, alternatives), then
/// the non-manual spans and the warnings. Ends with a newline; holds no control characters of the input.
std::string interlinear(const Translation& translation);

/// One JSON object: "english", "items", "non_manual", "warnings", keys in a fixed order, indented by two spaces.
/// Every item has index, kind, text, begin, end (bytes), glosses, rules, alternatives, ambiguous, confidence, review,
/// pause_seconds and non_manual (indexes of the spans that cover it).
std::string to_json(const Translation& translation);

}  // namespace auslan
