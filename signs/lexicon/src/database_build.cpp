// SPDX-License-Identifier: Apache-2.0
#include "database_rows.h"
#include "kinematics/whole_file.h"
#include "lexicon/lexicon.h"
#include "statement.h"

#include <memory>
#include <string_view>

namespace auslan {
namespace {

Result<void> fill(sqlite3* db, const LexiconText& text) {
  // The rename makes the file appear whole, so that no journal is needed; page size and encoding are fixed for the sake
  // of equal bytes.
  Result<void> done = execute(
      db,
      "PRAGMA page_size = 16384; PRAGMA encoding = 'UTF-8'; PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; "
      "PRAGMA foreign_keys = ON; PRAGMA application_id = " +
          std::to_string(kLexiconApplicationId) + "; PRAGMA user_version = " + std::to_string(kLexiconSchemaVersion) +
          "; BEGIN");
  if (done) done = create_tables(db);
  if (done) done = insert_rows(db, text);
  if (done) done = execute(db, "COMMIT");
  return done;
}

}  // namespace

Result<void> build_database(const LexiconText& text, const std::filesystem::path& path) {
  if (const std::vector<Finding> findings = check_lexicon(text); !findings.empty()) {
    const Finding& first = findings.front();
    return fail(ErrorCode::kMalformed,
                "the lexicon breaks " + std::to_string(findings.size()) + " rules; the first: " + first.entry + " " +
                    first.part + ": " + first.message,
                path.string());
  }
  // Built in memory and written in one piece, so that a file of that name is always a whole one.
  Result<Database> db = open_database(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  if (!db) return tl::unexpected(db.error());
  if (Result<void> filled = fill(db->get(), text); !filled) {
    filled.error().place = path.string();
    return filled;
  }
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> bytes(sqlite3_serialize(db->get(), "main", &size, 0),
                                                              sqlite3_free);
  if (!bytes) return fail(ErrorCode::kLimit, "there is not enough memory for the database", path.string());
  return write_whole_file(path,
                          std::string_view(reinterpret_cast<const char*>(bytes.get()), static_cast<size_t>(size)));
}

}  // namespace auslan
