// SPDX-License-Identifier: Apache-2.0
// Whether a database may be used: ours, of a version that is known, whole, and with the tables exactly as this program
// makes them. What is read afterwards can then be no view, and obeys the CHECKs unless bytes were changed behind
// SQLite's back.
#pragma once

#include "kinematics/result.h"
#include "statement.h"

#include <string>

namespace auslan {

/// Adds how to get a sound database.
std::string advice(const std::string& what);
/// Of a lexicon; an Error where the file is none.
Result<int> schema_version(sqlite3* db);
Result<void> examine(sqlite3* db);
/// SQLite's integrity_check.
Result<void> check_integrity(sqlite3* db);
/// Switches off what a hostile file could use, and ends reads that never end: `batches` counts their work, is set to 0
/// before each, and outlives the connection.
void distrust(sqlite3* db, int* batches);

}  // namespace auslan
