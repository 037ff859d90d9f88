// SPDX-License-Identifier: Apache-2.0
// auslan-lexicon-build SOURCES -o OUT: compiles the lexicon's text into the database the programs open.
#include "lexicon/lexicon.h"

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace {

int usage() {
  std::fputs(
      "usage: auslan-lexicon-build SOURCES -o OUT\n  SOURCES  the folder with handshapes.toml\n  OUT      the "
      "database\n",
      stderr);
  return 2;
}

void report(const auslan::Error& error) {
  std::fprintf(stderr, "%s\n", auslan::to_string(error).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> arguments(argv + 1, argv + argc);
  if (arguments.size() != 3 || arguments[1] != "-o" || arguments[0].empty() || arguments[2].empty()) return usage();
  const std::filesystem::path folder(arguments[0]);
  const std::filesystem::path out(arguments[2]);
  // Every problem is told, one a line, so that an editor can jump to each.
  if (const std::vector<auslan::Error> problems = auslan::check_lexicon_text(folder); !problems.empty()) {
    for (const auslan::Error& problem : problems)
      report(problem);
    std::fprintf(stderr, "auslan-lexicon-build: %zu problems; nothing was written\n", problems.size());
    return 1;
  }
  const auslan::Result<auslan::LexiconText> text = auslan::read_lexicon_text(folder);
  if (!text) {
    report(text.error());
    return 1;
  }
  if (const auslan::Result<void> built = auslan::build_database(*text, out); !built) {
    report(built.error());
    return 1;
  }
  return 0;
}
