// SPDX-License-Identifier: Apache-2.0
// Databases of older schemas.
#pragma once

#include "kinematics/result.h"
#include "statement.h"

namespace auslan {

/// True for a schema that migrate() can start from.
bool is_older_schema(int version);

/// Brings a database to today's schema, step by step, in one transaction; on an Error it is as it was. What comes out
/// has the tables of a new database, byte for byte, and keeps every entry.
Result<void> migrate(sqlite3* db, int from);

}  // namespace auslan
