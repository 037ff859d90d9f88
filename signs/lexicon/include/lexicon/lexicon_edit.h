// SPDX-License-Identifier: Apache-2.0
// A lexicon opened for writing. Every change is one transaction, checked before and on the disk after it (write-ahead
// log, fsync): a power cut leaves all of it or nothing.
#pragma once

#include "kinematics/result.h"
#include "lexicon/lexicon.h"

#include <filesystem>
#include <memory>
#include <string>

namespace auslan {

class LexiconEditor {
 public:
  /// Opens a database that is ours and whole, and brings one of an older schema to today's.
  static Result<LexiconEditor> open(const std::filesystem::path& path);
  LexiconEditor(LexiconEditor&&) noexcept;
  LexiconEditor& operator=(LexiconEditor&&) noexcept;
  ~LexiconEditor();

  /// The schema that the file had when it was opened.
  int opened_version() const;

  Result<LexiconText> read_all() const;

  /// Notes what a reviewer says of an entry ("HURT", "handshape flat", "phrase where-pain"), and with it the digest of
  /// what the entry says now; `review.content` is not looked at. The verdict becomes the entry's review state.
  Result<void> review(const std::string& entry, const Review& review);

  /// Puts a lexicon without findings in the place of all that is there.
  Result<void> replace(const LexiconText& text);

  /// Brings everything into the one file, which read-only readers then open without a log beside it. Nothing is lost
  /// where this is left out.
  Result<void> close();

 private:
  struct State;
  explicit LexiconEditor(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace auslan
