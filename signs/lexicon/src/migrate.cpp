// SPDX-License-Identifier: Apache-2.0
#include "migrate.h"

#include "database_read.h"
#include "database_rows.h"
#include "schema.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {
namespace {

constexpr int kOldestSchema = 2;

/// What a schema has that the one before it had not, and what stands there in an old row.
struct NewColumn {
  int since;
  std::string_view table, column, value;
};
// The digests are put right when all rows are written anew.
constexpr std::string_view kNoDigest = "'00000000000000000000000000000000'";
constexpr NewColumn kNewColumns[] = {{3, "handshape", "core", "0"},          {3, "handshape", "frequency_rank", "0"},
                                     {3, "handshape", "content", kNoDigest}, {3, "sign", "safety_critical", "0"},
                                     {3, "sign", "content", kNoDigest},      {3, "phrase", "content", kNoDigest}};

/// Commas between.
std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += (text.empty() ? "" : ", ") + name;
  return text;
}

Result<void> copy_rows(sqlite3* db, std::string_view table, const std::string& old_table, int from) {
  const Result<std::vector<std::string>> now = read_names(db, "SELECT name FROM pragma_table_info(?1)", table);
  const Result<std::vector<std::string>> then = read_names(db, "SELECT name FROM pragma_table_info(?1)", old_table);
  if (!now) return tl::unexpected(now.error());
  if (!then) return tl::unexpected(then.error());
  std::vector<std::string> columns, values;
  for (const std::string& column : *now) {
    columns.push_back(column);
    const auto added = std::ranges::find_if(kNewColumns, [&](const NewColumn& one) {
      return one.since > from && one.table == table && one.column == column;
    });
    if (added != std::end(kNewColumns)) {
      values.emplace_back(added->value);
    } else if (std::ranges::find(*then, column) != then->end()) {
      values.push_back(column);
    } else {
      return fail(ErrorCode::kMalformed, "the table " + std::string(table) + " of this older lexicon has no column " +
                                             column + "; rebuild it from the text");
    }
  }
  return execute(db, "INSERT INTO " + std::string(table) + " (" + list_of(columns) + ") SELECT " + list_of(values) +
                         " FROM " + old_table);
}

Result<void> rebuild(sqlite3* db, int from) {
  std::vector<std::string_view> there;
  for (const TableSchema& table : lexicon_tables()) {
    const Result<std::vector<std::string>> found =
        read_names(db, "SELECT name FROM sqlite_schema WHERE type = 'table' AND name = ?1", table.name);
    if (!found) return tl::unexpected(found.error());
    if (!found->empty()) there.push_back(table.name);
  }
  const auto old_name = [](std::string_view table) { return "old_" + std::string(table); };
  Result<void> done;
  for (const std::string_view table : there)
    if (done) done = execute(db, "ALTER TABLE " + std::string(table) + " RENAME TO " + old_name(table));
  if (done) done = create_tables(db);
  for (const std::string_view table : there)
    if (done) done = copy_rows(db, table, old_name(table), from);
  for (const std::string_view table : there)
    if (done) done = execute(db, "DROP TABLE " + old_name(table));
  if (!done) return done;
  // Read by the rules of today, and written again with what is derived: digests and the full-text index.
  const Result<LexiconText> text = read_lexicon_rows(db);
  if (!text) return tl::unexpected(text.error());
  if (const std::vector<Finding> findings = check_lexicon(*text); !findings.empty())
    return fail(ErrorCode::kMalformed, findings.front().entry + " " + findings.front().part + ": " +
                                           findings.front().message + "; nothing was changed");
  done = delete_rows(db);
  if (done) done = insert_rows(db, *text);
  if (done) done = execute(db, "PRAGMA user_version = " + std::to_string(kLexiconSchemaVersion));
  return done;
}

}  // namespace

bool is_older_schema(int version) {
  return version >= kOldestSchema && version < kLexiconSchemaVersion;
}

Result<void> migrate(sqlite3* db, int from) {
  Result<void> done = execute(db, "PRAGMA foreign_keys = OFF; PRAGMA legacy_alter_table = ON; BEGIN IMMEDIATE");
  if (!done) return done;
  done = rebuild(db, from);
  if (done) done = execute(db, "COMMIT");
  if (!done) (void)execute(db, "ROLLBACK");
  const Result<void> after =
      execute(db, std::string(done ? "VACUUM; " : "") + "PRAGMA legacy_alter_table = OFF; PRAGMA foreign_keys = ON");
  return done ? after : done;
}

}  // namespace auslan
