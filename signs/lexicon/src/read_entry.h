// SPDX-License-Identifier: Apache-2.0
// From TOML tables to entries of the model, and the lines on which their parts stand.
#pragma once

#include "lexicon/lexicon_text.h"
#include "table_reader.h"

#include <map>
#include <string>

namespace auslan {

/// Where the parts of entries stand: entry -> part ("" for the entry itself) -> file and line. Of two entries with the
/// same name the later one is kept, which is the one a duplicate is reported for.
struct Places {
  struct Place {
    size_t file = 0;
    long line = 0;
  };
  std::map<std::string, std::map<std::string, Place>> of_entry;

  void note(const std::string& entry, const std::string& part, const ProblemList& problems, long line) {
    of_entry[entry][part] = {problems.file(), line};
  }
};

void read_handshape(TableReader& reader, LexiconText& text, Places& places);
/// `kind` is sign, letter or number.
void read_sign(TableReader& reader, std::string_view kind, std::string_view category, LexiconText& text,
               Places& places);
void read_phrase(TableReader& reader, LexiconText& text, Places& places);

}  // namespace auslan
