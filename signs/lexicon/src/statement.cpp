// SPDX-License-Identifier: Apache-2.0
#include "statement.h"

#include <cmath>

namespace auslan {
namespace {

constexpr int kMaxTextBytes = 1 << 14;  // the checks of a table list whole vocabularies

}  // namespace

Error database_error(sqlite3* db, ErrorCode fallback) {
  const int code = db != nullptr ? sqlite3_errcode(db) : SQLITE_NOMEM;
  const std::string text = db != nullptr ? sqlite3_errmsg(db) : "out of memory";
  switch (code & 0xFF) {
    case SQLITE_FULL:
    case SQLITE_READONLY:
      return {ErrorCode::kUnwritable, "cannot write the database (" + text + "); check permissions and free space", ""};
    case SQLITE_CANTOPEN:
      return {fallback, "cannot open the database (" + text + ")", ""};
    case SQLITE_INTERRUPT:
      return {ErrorCode::kLimit, "reading the database took too long; it is damaged", ""};
    default:
      return {fallback, "the database cannot be used (" + text + ")", ""};
  }
}

Result<Database> open_database(const std::filesystem::path& path, int flags) {
  sqlite3* raw = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &raw, flags, nullptr);
  Database db(raw);
  if (code == SQLITE_OK) return db;
  Error error = database_error(db.get(), ErrorCode::kUnreadable);
  error.place = path.string();
  return tl::unexpected(std::move(error));
}

Result<void> execute(sqlite3* db, const std::string& sql) {
  if (sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK) return {};
  return tl::unexpected(database_error(db, ErrorCode::kMalformed));
}

Result<Statement> Statement::prepare(sqlite3* db, std::string_view sql) {
  sqlite3_stmt* raw = nullptr;
  if (sqlite3_prepare_v2(db, sql.data(), static_cast<int>(sql.size()), &raw, nullptr) != SQLITE_OK)
    return tl::unexpected(database_error(db, ErrorCode::kMalformed));
  return Statement(db, raw);
}

void Statement::bind(std::string_view text) {
  const char* data = text.data() != nullptr ? text.data() : "";
  sqlite3_bind_text64(statement_.get(), next_parameter_++, data, text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
}

void Statement::bind(int value) {
  sqlite3_bind_int(statement_.get(), next_parameter_++, value);
}
void Statement::bind(double value) {
  sqlite3_bind_double(statement_.get(), next_parameter_++, value);
}
void Statement::bind_null() {
  sqlite3_bind_null(statement_.get(), next_parameter_++);
}

Result<bool> Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  return tl::unexpected(database_error(db_, ErrorCode::kMalformed));
}

Result<void> Statement::run() {
  Result<bool> row = step();
  sqlite3_reset(statement_.get());
  next_parameter_ = 1;
  if (!row) return tl::unexpected(row.error());
  return {};
}

std::string Statement::text(int column) {
  if (sqlite3_column_type(statement_.get(), column) != SQLITE_TEXT) {
    damaged_ = true;
    return {};
  }
  const unsigned char* bytes = sqlite3_column_text(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  if (bytes == nullptr || size > kMaxTextBytes) {
    damaged_ = true;
    return {};
  }
  return {reinterpret_cast<const char*>(bytes), static_cast<size_t>(size)};
}

std::optional<std::string> Statement::optional_text(int column) {
  if (sqlite3_column_type(statement_.get(), column) == SQLITE_NULL) return std::nullopt;
  return text(column);
}

int Statement::integer(int column, int least, int most) {
  const sqlite3_int64 value = sqlite3_column_int64(statement_.get(), column);
  if (sqlite3_column_type(statement_.get(), column) != SQLITE_INTEGER || value < least || value > most) {
    damaged_ = true;
    return least;
  }
  return static_cast<int>(value);
}

double Statement::real(int column) {
  const double value = sqlite3_column_double(statement_.get(), column);
  if (sqlite3_column_type(statement_.get(), column) != SQLITE_FLOAT || !std::isfinite(value)) {
    damaged_ = true;
    return 0.0;
  }
  return value;
}

}  // namespace auslan
