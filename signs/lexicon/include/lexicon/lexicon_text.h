// SPDX-License-Identifier: Apache-2.0
// The lexicon as people write it: TOML files that are read, checked and written again in one canonical form.
// assets/lexicon/ holds them; README.md of this folder shows the form. Directions are the signer's own; offsets are
// centimetres [left, up, away] in the text and metres in the model.
#pragma once

#include "kinematics/result.h"
#include "phonology/phrase.h"
#include "phonology/sign.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace auslan {

/// Everything the lexicon says, in the order of its files. Letters have the gloss "fs:A" and numbers "num:7", as
/// phrases name them, so that a gloss is one entry and the pronoun I is not the letter.
struct LexiconText {
  std::vector<Handshape> handshapes;
  std::vector<Sign> signs;        ///< kind "letter", "number" or "sign"; gloss unique
  std::vector<Keyword> keywords;  ///< every gloss of a "sign" has at least one
  std::vector<Phrase> phrases;
};

/// One file of the lexicon: its name inside the folder ("signs/health.toml") and its bytes.
struct TextSource {
  std::string name;
  std::string text;
};

/// Bounds against hostile files; a break is an Error of code kLimit.
inline constexpr size_t kMaxSourceBytes = 4u << 20;
inline constexpr size_t kMaxSourceFiles = 256;
inline constexpr size_t kMaxLineBytes = 4096;
inline constexpr int kMaxNesting = 8;

/// What reading found: the model, and every problem with its file:line and what was expected there. The text may be
/// used only when there are no problems.
struct LexiconReading {
  LexiconText text;
  std::vector<Error> problems;
};

/// Reads sources that are in memory and checks them against each other: vocabulary, types, unknown keys, phases,
/// orientation, references, duplicates. Total: any bytes give problems, never a crash. The folder names say what a file
/// may hold: handshapes.toml, alphabet.toml, numbers.toml, phrases.toml, signs/CATEGORY.toml.
LexiconReading parse_lexicon_text(std::span<const TextSource> sources);

/// The sources of a folder in the fixed order handshapes, alphabet, numbers, signs/* by name, phrases.
Result<std::vector<TextSource>> load_lexicon_sources(const std::filesystem::path& folder);

/// Every problem of a folder; empty when it compiles.
std::vector<Error> check_lexicon_text(const std::filesystem::path& folder);

/// The lexicon of a folder, or its first problem and how many more there are.
Result<LexiconText> read_lexicon_text(const std::filesystem::path& folder);

/// The canonical text, one source a file; parse_lexicon_text gives back the same model, and writing that again the same
/// bytes. Signs go to signs/CATEGORY.toml.
std::vector<TextSource> write_lexicon_text(const LexiconText& text);

/// A digest of what an entry says, in its canonical form; what reviewers said of it is no part of that. Of a sign with
/// those of the keywords that are its own.
std::string content_digest(const Sign& sign, std::span<const Keyword> keywords);
std::string content_digest(const Handshape& shape);
std::string content_digest(const Phrase& phrase);

/// Writes the canonical text into a folder, each file complete or not at all.
Result<void> save_lexicon_text(const LexiconText& text, const std::filesystem::path& folder);

}  // namespace auslan
