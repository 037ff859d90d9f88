// SPDX-License-Identifier: Apache-2.0
// The tables of the database. Vocabulary is stored by name and held by CHECKs; references are foreign keys.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace auslan {

struct TableSchema {
  std::string_view name;
  std::string sql;  ///< the CREATE TABLE statement, byte for byte as SQLite keeps it
};

/// The full-text index over words and definitions, with the stems of English (Porter).
inline constexpr std::string_view kWordIndex = "word_index";

/// The words by every three letters in a row, for parts of words.
inline constexpr std::string_view kPartIndex = "part_index";

/// All tables, in the order in which they are made.
std::vector<TableSchema> lexicon_tables();

}  // namespace auslan
