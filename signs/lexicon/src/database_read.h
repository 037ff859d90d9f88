// SPDX-License-Identifier: Apache-2.0
// Rows to entries. Every value is checked for type, range and vocabulary, and every entry against the rules of
// lexicon_check.h, so that what comes out is as safe as what the text reader gives.
#pragma once

#include "lexicon/lexicon.h"
#include "statement.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

Result<std::optional<Sign>> read_sign_row(sqlite3* db, std::string_view gloss);
Result<std::optional<Handshape>> read_handshape_row(sqlite3* db, std::string_view id);
Result<std::optional<Phrase>> read_phrase_row(sqlite3* db, std::string_view id);
enum class KeywordOrder { kText, kWord };
/// kWord: by word, then part of speech, then rank. Damaged rows are left out and told in `findings`.
Result<std::vector<Keyword>> read_keyword_rows(sqlite3* db, KeywordOrder order, std::vector<Finding>& findings);
Result<std::vector<SignSummary>> read_summaries(sqlite3* db);
Result<std::optional<SignSummary>> read_summary(sqlite3* db, std::string_view gloss);
/// All that is there; an Error names the first damaged entry.
Result<LexiconText> read_lexicon_rows(sqlite3* db);
/// The first column of a query with at most one parameter, as texts.
Result<std::vector<std::string>> read_names(sqlite3* db, std::string_view sql,
                                            std::optional<std::string_view> parameter = {});

}  // namespace auslan
