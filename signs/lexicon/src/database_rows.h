// SPDX-License-Identifier: Apache-2.0
// Entries to rows: what fills a new database and what an edit writes.
#pragma once

#include "lexicon/lexicon.h"
#include "statement.h"

#include <string>
#include <string_view>

namespace auslan {

Result<void> create_tables(sqlite3* db);
/// Every row of every table.
Result<void> delete_rows(sqlite3* db);
/// Into empty tables; the caller has a transaction open and the text has no findings.
Result<void> insert_rows(sqlite3* db, const LexiconText& text);
/// `kind`: handshape, sign or phrase; `position`: how many reviews the entry had before.
Result<void> insert_review(sqlite3* db, std::string_view kind, const std::string& entry, int position,
                           const Review& review);

}  // namespace auslan
