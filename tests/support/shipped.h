// SPDX-License-Identifier: Apache-2.0
// Figure, signer and lexicon as the build ships them, for tests of what they make together.
#pragma once

#include "kinematics/figure_file.h"
#include "lexicon/lexicon.h"
#include "synthesis/choreography.h"
#include "synthesis/performance.h"
#include "synthesis/signer.h"
#include "synthesis/utterance.h"

#include <optional>
#include <string>
#include <vector>

namespace auslan {

/// Opened once; a test program without them ends with an exception that says why.
struct Shipped {
  Figure figure;
  std::optional<Signer> signer;
  std::optional<Lexicon> lexicon;
};

inline Shipped& shipped() {
  static Shipped* loaded = [] {
    auto* made = new Shipped;
    const std::string folder = std::string(AUSLANJAM_BINARY_DIR) + "/share/auslanjam/";
    made->figure = read_figure(folder + "signer.figure").value();
    made->signer.emplace(Signer::build(made->figure).value());
    made->lexicon.emplace(Lexicon::open(folder + "lexicon.sqlite").value());
    return made;
  }();
  return *loaded;
}

inline Utterance utterance_of(const std::vector<std::string>& glosses) {
  Shipped& s = shipped();
  return compose(
             translation_of_glosses(glosses), [&s](std::string_view gloss) { return s.lexicon->sign(gloss); },
             [&s](std::string_view id) { return s.lexicon->handshape(id); })
      .value();
}

inline Score score_of(const std::vector<std::string>& glosses) {
  return choreograph(*shipped().signer, utterance_of(glosses)).value();
}

}  // namespace auslan
