// SPDX-License-Identifier: Apache-2.0
// Any bytes as a file of the lexicon: the reader must return, and what it calls good must survive writing and reading.
#include "lexicon/lexicon_text.h"

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

// The first byte chooses the kind of file, the rest is its text.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const char* const names[] = {"handshapes.toml", "alphabet.toml", "numbers.toml", "signs/health.toml", "phrases.toml"};
  const std::vector<auslan::TextSource> sources = {
      {names[data[0] % 5], std::string(reinterpret_cast<const char*>(data) + 1, size - 1)}};
  const auslan::LexiconReading first = auslan::parse_lexicon_text(sources);
  if (!first.problems.empty()) return 0;
  const std::vector<auslan::TextSource> written = auslan::write_lexicon_text(first.text);
  const auslan::LexiconReading second = auslan::parse_lexicon_text(written);
  if (!second.problems.empty()) std::abort();
  const std::vector<auslan::TextSource> again = auslan::write_lexicon_text(second.text);
  if (again.size() != written.size()) std::abort();
  for (size_t i = 0; i < again.size(); ++i)
    if (again[i].text != written[i].text) std::abort();
  return 0;
}
