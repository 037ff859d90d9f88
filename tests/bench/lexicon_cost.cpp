// SPDX-License-Identifier: Apache-2.0
// lexicon_cost [ENTRIES]: what opening a lexicon and looking words up in it costs, in processor time; 10,000 entries,
// each a shipped sign under another name with keywords of its own, where nothing else is said.
#include "scratch_folder.h"
#include "shipped.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace auslan {
namespace {

constexpr int kTimes = 41;

/// Of this process, milliseconds.
double processor_time() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// A pronounceable word for each number, no two alike.
std::string word_of(size_t number) {
  static constexpr std::string_view kConsonants = "bdfgklmnprstvwz", kVowels = "aeiou";
  std::string word;
  for (int syllable = 0; syllable < 4; ++syllable) {
    word += kConsonants[number % kConsonants.size()];
    number /= kConsonants.size();
    word += kVowels[number % kVowels.size()];
    number /= kVowels.size();
  }
  return word;
}

LexiconText synthetic(size_t entries) {
  LexiconText text = shipped().lexicon->read_all().value();
  const std::vector<Sign> signs = text.signs;
  const std::vector<Keyword> keywords = text.keywords;
  for (size_t i = 0; text.signs.size() < entries; ++i) {
    Sign sign = signs[i % signs.size()];
    if (sign.kind != "sign") continue;
    const std::string word = word_of(i * 7919 + 11);
    sign.gloss = word;
    std::ranges::transform(sign.gloss, sign.gloss.begin(), [](char c) { return static_cast<char>(c - 'a' + 'A'); });
    text.keywords.push_back({word, "noun", sign.gloss, 0});
    text.keywords.push_back({word + " again", "verb", sign.gloss, 0});
    text.signs.push_back(std::move(sign));
  }
  return text;
}

template <class Work>
void measure(const char* what, Work work) {
  std::vector<double> times;
  for (int i = 0; i < kTimes; ++i) {
    const double begin = processor_time();
    work(i);
    times.push_back(processor_time() - begin);
  }
  std::ranges::sort(times);
  std::printf("%-44s %8.3f ms, at most %8.3f\n", what, times[kTimes / 2], times.back());
}

int report(size_t entries) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder / "lexicon.sqlite";
  const LexiconText text = synthetic(entries);
  if (const Result<void> built = build_database(text, path); !built) throw std::runtime_error(to_string(built.error()));
  if (text.signs.size() > entries) throw std::runtime_error("more entries than that are shipped");
  std::printf("%zu entries, %zu keywords, %.1f MB\n", text.signs.size(), text.keywords.size(),
              static_cast<double>(std::filesystem::file_size(path)) * 1e-6);
  measure("opening", [&](int) { Lexicon::open(path).value(); });
  const Lexicon lexicon = Lexicon::open(path).value();
  const size_t made = text.keywords.size() - shipped().lexicon->keywords().size();
  const auto some = [&](int i) -> const Keyword& {
    return text.keywords[text.keywords.size() - 1 - static_cast<size_t>(i) * 7919 % made];
  };
  measure("an entry by its gloss", [&](int i) { (void)lexicon.sign(some(i).gloss).value().value(); });
  measure("searching a word", [&](int i) {
    if (lexicon.search(some(i).word).value().empty()) throw std::runtime_error("not found: " + std::to_string(i));
  });
  measure("searching a word in another form", [&](int i) {
    if (lexicon.search(some(i).word + "s").value().empty()) throw std::runtime_error("not found: " + std::to_string(i));
  });
  measure("searching what no entry has", [&](int) { (void)lexicon.search("qqqq").value(); });
  return 0;
}

}  // namespace
}  // namespace auslan

int main(int count, char** words) try {
  const int entries = count > 1 ? std::atoi(words[1]) : 10000;
  if (count > 2 || entries < 1) {
    std::fputs("usage: lexicon_cost [ENTRIES]\n", stderr);
    return 2;
  }
  return auslan::report(static_cast<size_t>(entries));
} catch (const std::exception& error) {
  std::fprintf(stderr, "lexicon_cost: %s\n", error.what());
  return 1;
}
