// SPDX-License-Identifier: Apache-2.0
// What is to be performed: entries in signing order with their handshapes, and the non-manual spans over them.
#pragma once

#include "kinematics/result.h"
#include "phonology/phrase.h"
#include "phonology/sign.h"
#include "translate/translation.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

/// One entry to perform, or a pause.
struct Unit {
  std::optional<Sign> sign;    ///< none: a pause
  std::string label;           ///< what captions and motion files call it: the gloss, or the word being spelled
  std::string mouthing;        ///< English to mouth over this unit; empty: the mouth rests
  bool spelled = false;        ///< a letter inside a fingerspelled word
  bool first_of_word = false;  ///< the first letter of a spelled word
  int word_letters = 0;        ///< on the first letter: how many letters the word has
  double pause_seconds = 0;    ///< for pauses
  double extra_hold_seconds = 0;
  bool reviewed = false;
  int sentence = 0;  ///< index into Utterance::sentences
};

struct Utterance {
  std::vector<Unit> units;
  std::vector<NonManualSpan> non_manual;        ///< from/to are indexes into units
  std::map<std::string, Handshape> handshapes;  ///< every handshape that the units use, by id
  std::vector<std::string> sentences;           ///< the English, sentence by sentence, for captions
  bool all_reviewed = true;                     ///< no unit rests on an unreviewed entry
};

using SignSource = std::function<Result<std::optional<Sign>>(std::string_view gloss)>;
using HandshapeSource = std::function<Result<std::optional<Handshape>>(std::string_view id)>;

/// Looks every item up. A gloss that the source does not know is an error (kNotFound) that names it: the translator
/// promised an entry. Dropped items give no unit.
Result<Utterance> compose(const Translation& translation, const SignSource& signs, const HandshapeSource& handshapes);

/// A translation that performs the given glosses in order, for callers that have no English (`--gloss`).
Translation translation_of_glosses(const std::vector<std::string>& glosses);

}  // namespace auslan
