// SPDX-License-Identifier: Apache-2.0
#include "lexicon/lexicon_edit.h"

#include "database_read.h"
#include "database_rows.h"
#include "examine.h"
#include "migrate.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace auslan {
namespace {

/// The table, the column of the name, and the name alone of "HURT", "handshape flat", "phrase where-pain".
struct EntryRow {
  std::string_view table, key;
  std::string name;
};
EntryRow row_of(const std::string& entry) {
  for (const std::string_view kind : {"handshape", "phrase"})
    if (entry.size() > kind.size() && entry.starts_with(kind) && entry[kind.size()] == ' ')
      return {kind, "id", entry.substr(kind.size() + 1)};
  return {"sign", "gloss", entry};
}

/// Changes and then commits, or leaves all as it was.
template <typename Change>
Result<void> in_transaction(sqlite3* db, const Change& change) {
  Result<void> done = execute(db, "BEGIN IMMEDIATE");
  if (!done) return done;
  done = change();
  if (done) done = execute(db, "COMMIT");
  if (!done) (void)execute(db, "ROLLBACK");
  return done;
}

}  // namespace

struct LexiconEditor::State {
  std::string place;
  int opened_version = 0;
  int batches = 0;
  Database db;

  template <typename T>
  Result<T> in_file(Result<T> result) const {
    if (!result && result.error().place.empty()) result.error().place = place;
    return result;
  }
};

LexiconEditor::LexiconEditor(std::unique_ptr<State> state) : state_(std::move(state)) {}
LexiconEditor::LexiconEditor(LexiconEditor&&) noexcept = default;
LexiconEditor& LexiconEditor::operator=(LexiconEditor&&) noexcept = default;
LexiconEditor::~LexiconEditor() = default;

Result<LexiconEditor> LexiconEditor::open(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    return fail(ErrorCode::kNotFound,
                "there is no such lexicon to write; `auslanjam db build FOLDER -o FILE` makes one from text",
                path.string());
  Result<Database> db = open_database(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_FULLMUTEX);
  if (!db) return tl::unexpected(db.error());
  auto state = std::make_unique<State>();
  state->place = path.string();
  state->db = std::move(*db);
  sqlite3* raw = state->db.get();
  distrust(raw, &state->batches);
  const auto ready = [&]() -> Result<void> {
    const Result<int> version = schema_version(raw);
    if (!version) return tl::unexpected(version.error());
    state->opened_version = *version;
    if (sqlite3_db_readonly(raw, "main") != 0)
      return fail(ErrorCode::kUnwritable,
                  "the lexicon may not be written; copy it to a place of your own and edit that");
    Result<void> done = execute(raw, "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
    if (done && is_older_schema(*version)) {
      done = check_integrity(raw);
      if (done) done = migrate(raw, *version);
    }
    return done ? examine(raw) : done;
  };
  if (Result<void> done = ready(); !done) return state->in_file(Result<LexiconEditor>(tl::unexpected(done.error())));
  return LexiconEditor(std::move(state));
}

int LexiconEditor::opened_version() const {
  return state_->opened_version;
}

Result<LexiconText> LexiconEditor::read_all() const {
  state_->batches = 0;
  return state_->in_file(read_lexicon_rows(state_->db.get()));
}

Result<void> LexiconEditor::review(const std::string& entry, const Review& review) {
  state_->batches = 0;
  sqlite3* db = state_->db.get();
  const EntryRow row = row_of(entry);
  const std::string table(row.table), key(row.key);
  const auto note = [&]() -> Result<void> {
    const Result<std::vector<std::string>> content =
        read_names(db, "SELECT content FROM " + table + " WHERE " + key + " = ?1", row.name);
    if (!content) return tl::unexpected(content.error());
    if (content->empty())
      return fail(ErrorCode::kNotFound, "there is no entry " + entry + "; `auslanjam db search WORD` looks for one");
    const Result<std::vector<std::string>> before =
        read_names(db, "SELECT reviewer FROM review WHERE kind = '" + table + "' AND entry = ?1", row.name);
    if (!before) return tl::unexpected(before.error());
    Review noted = review;
    noted.content = content->front();
    if (Result<void> done = insert_review(db, table, row.name, static_cast<int>(before->size()), noted); !done)
      return done;
    const bool decided = review.verdict != ReviewState::kUnreviewed;
    Result<Statement> update = Statement::prepare(
        db, "UPDATE " + table + " SET review = ?1, reviewed_by = ?2, reviewed_on = ?3 WHERE " + key + " = ?4");
    if (!update) return tl::unexpected(update.error());
    update->bind(to_name(review.verdict));
    update->bind(std::string_view(decided ? review.by : std::string()));
    update->bind(std::string_view(decided ? review.on : std::string()));
    update->bind(std::string_view(row.name));
    if (Result<void> done = update->run(); !done) return done;
    // The rules of the text hold for what is written here, too.
    const auto rules = [](const auto& found) -> Result<void> {
      return found ? Result<void>() : Result<void>(tl::unexpected(found.error()));
    };
    if (table == "sign") return rules(read_sign_row(db, row.name));
    if (table == "phrase") return rules(read_phrase_row(db, row.name));
    return rules(read_handshape_row(db, row.name));
  };
  return state_->in_file(in_transaction(db, note));
}

Result<void> LexiconEditor::replace(const LexiconText& text) {
  state_->batches = 0;
  if (const std::vector<Finding> findings = check_lexicon(text); !findings.empty())
    return fail(ErrorCode::kMalformed,
                findings.front().entry + " " + findings.front().part + ": " + findings.front().message +
                    "; nothing was changed",
                state_->place);
  sqlite3* db = state_->db.get();
  return state_->in_file(in_transaction(db, [&] {
    Result<void> done = delete_rows(db);
    return done ? insert_rows(db, text) : done;
  }));
}

Result<void> LexiconEditor::close() {
  Result<void> done = execute(state_->db.get(), "PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode = DELETE");
  return state_->in_file(std::move(done));
}

}  // namespace auslan
