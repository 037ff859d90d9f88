// SPDX-License-Identifier: Apache-2.0
// A small whole lexicon as text, and a folder that cleans up after itself.
#pragma once

#include "lexicon/lexicon_text.h"
#include "scratch_folder.h"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <vector>

namespace auslan::testing {

inline std::string sample_handshapes() {
  return R"([[handshape]]
id = "flat"
name = "Flat"
selected = "all"
index = [0, 0, 0, 2]
middle = [0, 0, 0, 0]
ring = [0, 0, 0, 2]
little = [0, 0, 0.5, 4]
thumb = { radial = 20, palmar = 10, opposition = 0.25, mp = 5, ip = 0 }
hamnosys = "hamflathand"
description = "Straight fingers side by side."
aliases = ["B", "paper \"hand\""]
sources = ["memory"]
confidence = "high"
)";
}

inline std::string sample_sign() {
  return R"([[sign]]
gloss = "HURT"
english = ["hurt:verb", "sore:adj:1"]
region = "north"
definition = "How it looks."
hands = "dominant+base"
dominant = [
  { shape = "flat", fingers = "left-up", palm = "toward", at = "nd_palm", offset_cm = [-8, 6.5, 0.1], contact = { kind = "touch", part = "index_tip", target = "nd_thumb" } },
  { shape = "flat", fingers = "left", palm = "toward", at = "neutral", offset_cm = [0, 0, 20] },
]
base = [
  { shape = "flat", fingers = "right", palm = "up", at = "neutral", offset_cm = [4, 0, 16] },
]
moves = [
  { kind = "shake", size = "small", repeats = 3, hands = "both", manner = "fast", plane = "up_down", from = 0, to = 1 },
  { kind = "straight", direction = "left-down", from = 1, to = 1 },
]
face = { brows = "furrow", face = "pained" }
mouthing = "hurt"
sources = ["memory", "iconic"]
form_evidence = "one source"
movement_evidence = "memory only"
confidence = "low"
review = "unreviewed"
)";
}

inline std::string sample_phrases() {
  return R"([[phrase]]
id = "i-hurt"
domain = "hospital"
english = "I hurt, {NAME}."
glosses = ["HURT", "{NAME}", "fs:X-RAY", "num:10"]
spans = [
  { kind = "wh", from = 0, to = 1, brows = "furrow", head = "tilt-forward", gaze = "addressee", ending = "hold last sign" },
]
notes = "A note."
sources = ["grammar"]
confidence = "medium"
)";
}

/// A whole lexicon of one handshape, one sign and one phrase that has no problems.
inline std::vector<TextSource> sample_sources() {
  return {{"handshapes.toml", sample_handshapes()},
          {"alphabet.toml", "letter = []\n"},
          {"numbers.toml", "number = []\n"},
          {"signs/health.toml", sample_sign()},
          {"phrases.toml", sample_phrases()}};
}

/// The canonical text of a lexicon as one string: equal strings mean equal models.
inline std::string as_one_text(const LexiconText& text) {
  std::string all;
  for (const TextSource& source : write_lexicon_text(text))
    all += "== " + source.name + "\n" + source.text;
  return all;
}

}  // namespace auslan::testing
