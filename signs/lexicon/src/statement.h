// SPDX-License-Identifier: Apache-2.0
// SQLite behind values that close themselves and calls that cannot throw: the only place that names its functions.
#pragma once

#include "kinematics/result.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <sqlite3.h>
#include <string>
#include <string_view>

namespace auslan {

struct CloseDatabase {
  void operator()(sqlite3* db) const { sqlite3_close_v2(db); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;

/// Opens with `flags` of sqlite3_open_v2; the place of errors is the path.
Result<Database> open_database(const std::filesystem::path& path, int flags);

/// Runs statements that return no rows that matter.
Result<void> execute(sqlite3* db, const std::string& sql);

/// The current error of the connection; `fallback` is its code unless the disk is to blame.
Error database_error(sqlite3* db, ErrorCode fallback);

/// A prepared statement. Parameters are bound in order with bind(); step() says whether there is a row. Columns are
/// read strictly: a value of another type than asked makes the statement `damaged`.
class Statement {
 public:
  static Result<Statement> prepare(sqlite3* db, std::string_view sql);

  void bind(std::string_view text);
  void bind(int value);
  void bind(double value);
  void bind_null();
  void bind(const std::optional<std::string_view>& text) { text ? bind(*text) : bind_null(); }
  /// True = a row; false = no more rows; an Error of code kMalformed when the file is damaged.
  Result<bool> step();
  /// Runs a statement without rows and makes it ready for the next parameters.
  Result<void> run();

  std::string text(int column);
  std::optional<std::string> optional_text(int column);
  int integer(int column, int least, int most);
  double real(int column);
  bool damaged() const { return damaged_; }

 private:
  Statement(sqlite3* db, sqlite3_stmt* statement) : db_(db), statement_(statement) {}

  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  sqlite3* db_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  int next_parameter_ = 1;
  bool damaged_ = false;
};

}  // namespace auslan
