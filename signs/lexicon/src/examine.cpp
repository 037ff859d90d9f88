// SPDX-License-Identifier: Apache-2.0
#include "examine.h"

#include "database_read.h"
#include "lexicon/lexicon.h"
#include "migrate.h"
#include "schema.h"

#include <cstdint>
#include <vector>

namespace auslan {
namespace {

// Far more than any read of a sound lexicon takes; a damaged or hostile file ends here.
constexpr int kMaxBatches = 2000;
constexpr int kOpsPerBatch = 100000;

constexpr std::string_view kRebuild = "rebuild it: auslan-lexicon-build assets/lexicon -o lexicon.sqlite";

Result<int> read_pragma(sqlite3* db, std::string_view sql) {
  Result<Statement> statement = Statement::prepare(db, sql);
  if (!statement) return tl::unexpected(statement.error());
  const Result<bool> row = statement->step();
  if (!row) return tl::unexpected(row.error());
  const int value = *row ? statement->integer(0, INT32_MIN, INT32_MAX) : 0;
  return value;
}

Result<std::string> read_one_text(sqlite3* db, std::string_view sql, std::string_view parameter) {
  Result<std::vector<std::string>> rows = read_names(db, sql, parameter);
  if (!rows) return tl::unexpected(rows.error());
  return rows->empty() ? std::string() : rows->front();
}

}  // namespace

std::string advice(const std::string& what) {
  return what + "; " + std::string(kRebuild);
}

Result<int> schema_version(sqlite3* db) {
  const Result<int> id = read_pragma(db, "PRAGMA application_id");
  if (!id) return fail(ErrorCode::kMalformed, advice("not a database, or a damaged one"));
  if (*id != kLexiconApplicationId) return fail(ErrorCode::kMalformed, advice("not a lexicon of this program"));
  return read_pragma(db, "PRAGMA user_version");
}

Result<void> examine(sqlite3* db) {
  const Result<int> version = schema_version(db);
  if (!version) return tl::unexpected(version.error());
  if (*version != kLexiconSchemaVersion) {
    const std::string told = "a lexicon of another version (" + std::to_string(*version) + ", this program reads " +
                             std::to_string(kLexiconSchemaVersion) + ")";
    return fail(ErrorCode::kUnsupported,
                is_older_schema(*version) ? told + "; `auslanjam db migrate FILE` brings it up to date" : advice(told));
  }
  if (Result<void> whole = check_integrity(db); !whole) return whole;
  for (const TableSchema& table : lexicon_tables()) {
    const Result<std::string> sql =
        read_one_text(db, "SELECT sql FROM sqlite_schema WHERE type = 'table' AND name = ?1", table.name);
    if (!sql || *sql != table.sql)
      return fail(ErrorCode::kMalformed,
                  advice("the table " + std::string(table.name) + " is missing or not as this program makes it"));
  }
  return {};
}

Result<void> check_integrity(sqlite3* db) {
  const Result<std::vector<std::string>> check =
      read_names(db, "SELECT integrity_check FROM pragma_integrity_check(1)");
  if (!check || *check != std::vector<std::string>{"ok"})
    return fail(ErrorCode::kMalformed, advice("the lexicon is damaged"));
  return {};
}

void distrust(sqlite3* db, int* batches) {
  sqlite3_db_config(db, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(db, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_limit(db, SQLITE_LIMIT_LENGTH, 1 << 20);
  sqlite3_busy_timeout(db, 2000);
  sqlite3_progress_handler(
      db, kOpsPerBatch, [](void* count) { return ++*static_cast<int*>(count) > kMaxBatches ? 1 : 0; }, batches);
}

}  // namespace auslan
