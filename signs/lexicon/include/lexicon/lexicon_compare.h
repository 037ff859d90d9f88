// SPDX-License-Identifier: Apache-2.0
// Two lexicons beside each other: what differs, and what of one can be taken over into the other without loss.
#pragma once

#include "lexicon/lexicon_text.h"

#include <string>
#include <string_view>
#include <vector>

namespace auslan {

enum class ChangeKind { kAdded, kRemoved, kChanged, kReviewed };

/// "added", "removed", "changed" (in what the entry says), "reviewed" (only in what reviewers said of it).
std::string_view to_name(ChangeKind kind);

struct EntryChange {
  std::string entry;  ///< "HURT", "handshape flat", "phrase where-pain"
  ChangeKind kind = ChangeKind::kChanged;
  /// Lines of the canonical text: "- " those of the old entry alone, "+ " those of the new one. Empty where an entry
  /// was added or removed.
  std::vector<std::string> lines;
};

/// In the order handshapes, signs, phrases; of each kind first those of the old lexicon in its order, then what is new.
std::vector<EntryChange> compare_lexicons(const LexiconText& before, const LexiconText& after);

/// What a merge does with an entry that both have and that says different things.
enum class OnConflict { kRefuse, kKeepOurs, kTakeTheirs };

struct LexiconMerge {
  LexiconText merged;
  std::vector<std::string> added;      ///< only they had it
  std::vector<std::string> reviewed;   ///< the same content; they know more reviews of it
  std::vector<EntryChange> conflicts;  ///< resolved as asked for; with kRefuse ours stays in `merged`
};

/// Takes what is new in `theirs` into `ours`. Nothing of ours is lost but the entries of `conflicts` with kTakeTheirs.
LexiconMerge merge_lexicons(const LexiconText& ours, const LexiconText& theirs, OnConflict on_conflict);

}  // namespace auslan
