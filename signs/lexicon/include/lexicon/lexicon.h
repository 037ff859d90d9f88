// SPDX-License-Identifier: Apache-2.0
// The lexicon as the programs use it: one SQLite file, opened read-only and distrusted. A file that was cut, changed by
// hand or made by another program gives Errors, never a crash.
#pragma once

#include "kinematics/result.h"
#include "lexicon/lexicon_check.h"
#include "lexicon/lexicon_text.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

/// "AJlx": the application id in the database's header.
inline constexpr int kLexiconApplicationId = 0x414A6C78;
/// The version of the schema (user_version).
inline constexpr int kLexiconSchemaVersion = 4;

/// Compiles the lexicon into one database at `path`. The same text gives the same bytes (with the same SQLite). Atomic:
/// a temporary file beside it is filled, synced and renamed; on failure nothing is left and an old file stays.
Result<void> build_database(const LexiconText& text, const std::filesystem::path& path);

/// What a list shows of a sign.
struct SignSummary {
  std::string gloss, kind, category, region, definition;
  Handedness handedness = Handedness::kOne;
  Confidence confidence = Confidence::kLow;
  ReviewState review = ReviewState::kUnreviewed;
  bool safety_critical = false;
};

/// Empty fields do not filter.
struct ListFilter {
  std::string kind = {};  ///< sign, letter, number
  std::string category = {};
  std::string region = {};
  std::optional<ReviewState> review = {};
  // What a learner sees, for the look-up from a sign to its meaning.
  std::string handshape = {};             ///< used by either hand in any phase
  std::optional<Location> location = {};  ///< of either hand in any phase, or touched there
  std::optional<Handedness> handedness = {};
  std::optional<MoveKind> movement = {};
};

/// `rank` 0: gloss or keyword is the text; 1: one begins with it; 2: one contains it, or the same words in another form
/// ("hospitals", "swelling"); 3: the definition does.
struct SearchHit {
  SignSummary sign;
  std::string matched;  ///< the gloss or keyword that matched, or the definition
  int rank = 0;
};

struct LexiconCounts {
  int handshapes = 0, base_handshapes = 0, core_handshapes = 0;
  int signs = 0, letters = 0, numbers = 0, keywords = 0, phrases = 0;
  int reviewed = 0, rejected = 0;  ///< among signs, letters, numbers and phrases
  int safety_critical = 0;
  /// Signs, letters and numbers by region, by confidence, by what their movement rests on (the first word of
  /// `movement_evidence`), by source; each in the order of its names.
  std::map<std::string, int> regions, confidences, movement_evidence, sources;
};

class Lexicon {
 public:
  /// Opens a database read-only, checks that it is ours (application id, schema version) and whole (SQLite's
  /// integrity_check), and reads keywords and phrases. The messages say how to rebuild.
  static Result<Lexicon> open(const std::filesystem::path& path);
  Lexicon(Lexicon&&) noexcept;
  Lexicon& operator=(Lexicon&&) noexcept;
  ~Lexicon();

  /// nullopt = no such entry; an Error = the database cannot be read or the entry is damaged.
  Result<std::optional<Sign>> sign(std::string_view gloss) const;
  /// The fingerspelled letter, either case: sign("fs:A").
  Result<std::optional<Sign>> letter(char letter) const;
  /// The number with a sign of its own: sign("num:7").
  Result<std::optional<Sign>> number(long long value) const;
  Result<std::optional<Handshape>> handshape(std::string_view id) const;

  /// Keywords and phrases that could not be read and were left out; check() repeats them.
  const std::vector<Finding>& damaged() const;
  /// All keywords, by word, then part of speech, then rank.
  const std::vector<Keyword>& keywords() const;
  /// All phrases in the order of the text.
  const std::vector<Phrase>& phrases() const;

  Result<std::vector<Handshape>> handshapes() const;
  Result<std::vector<SignSummary>> list(const ListFilter& filter = {}) const;
  /// Search over glosses, keywords and definitions, without regard to case or to the endings of English (the full-text
  /// index); where that finds nothing, for parts of words, from three letters on. Best first, then by gloss.
  Result<std::vector<SearchHit>> search(std::string_view text) const;
  Result<LexiconCounts> counts() const;
  /// The whole model, for export and comparison.
  Result<LexiconText> read_all() const;
  /// Every broken rule, damaged entries included.
  std::vector<Finding> check() const;

 private:
  struct State;
  explicit Lexicon(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace auslan
