// SPDX-License-Identifier: Apache-2.0
// auslan-lexicon-build SOURCES -o OUT: compiles the lexicon's text into the database the programs open.
// auslan-lexicon-build SOURCES --format: writes the text again in its canonical form.
#include "lexicon/lexicon.h"

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace {

int usage() {
  std::fputs(
      "usage: auslan-lexicon-build SOURCES -o OUT\n"
      "       auslan-lexicon-build SOURCES --format\n"
      "  SOURCES   the folder with handshapes.toml\n"
      "  -o OUT    the database to make\n"
      "  --format  write the text again in its canonical form\n",
      stderr);
  return 2;
}

void report(const auslan::Error& error) {
  std::fprintf(stderr, "%s\n", auslan::to_string(error).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> arguments(argv + 1, argv + argc);
  const bool build = arguments.size() == 3 && arguments[1] == "-o" && !arguments[2].empty();
  const bool format = arguments.size() == 2 && arguments[1] == "--format";
  if ((!build && !format) || arguments[0].empty()) return usage();
  const std::filesystem::path folder(arguments[0]);
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
  const auslan::Result<void> written =
      build ? auslan::build_database(*text, arguments[2]) : auslan::save_lexicon_text(*text, folder);
  if (!written) {
    report(written.error());
    return 1;
  }
  return 0;
}
