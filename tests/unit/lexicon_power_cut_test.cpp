// SPDX-License-Identifier: Apache-2.0
// A process that edits a lexicon is killed at a random moment, again and again: the database always opens, is whole,
// and holds all of each transaction or nothing of it.
#include "lexicon/lexicon_edit.h"
#include "lexicon_sample.h"

#include <chrono>
#include <csignal>
#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace auslan {
namespace {

constexpr int kCuts = 200;
constexpr int kSigns = 40;  // of each generation

/// All signs of generation `n` say so in their definition.
LexiconText generation(int n) {
  LexiconReading reading = parse_lexicon_text(testing::sample_sources());
  LexiconText text = std::move(reading.text);
  const Sign sign = text.signs[0];
  for (int i = 0; i < kSigns; ++i) {
    Sign copy = sign;
    copy.gloss = "SIGN-" + std::to_string(i);
    text.signs.push_back(copy);
    text.keywords.push_back({"word" + std::to_string(i), "noun", copy.gloss, 0});
  }
  for (Sign& one : text.signs)
    one.definition = "generation " + std::to_string(n);
  return text;
}

/// Edits without an end: whole generations, and reviews between them. A report of each change that is on the disk goes
/// through the pipe.
[[noreturn]] void edit_for_ever(const std::filesystem::path& path, int report) {
  Result<LexiconEditor> editor = LexiconEditor::open(path);
  if (!editor) _exit(1);
  int32_t n = 0;
  if (const auto text = editor->read_all(); text) n = std::stoi(text->signs[0].definition.substr(11));
  while (true) {
    ++n;
    if (!editor->replace(generation(n))) _exit(2);
    if (write(report, &n, sizeof n) != sizeof n) _exit(3);
    for (int i = 0; i < 5; ++i)
      if (!editor->review("SIGN-" + std::to_string(i), {"A. Signer", "2026-01-31", ReviewState::kReviewed, "", ""}))
        _exit(4);
  }
}

TEST(LexiconPowerCut, AKilledEditorLeavesAllOfEachTransactionOrNothing) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder / "lexicon.sqlite";
  ASSERT_TRUE(build_database(generation(0), path));
  uint32_t random = 1;
  int32_t reported = 0;
  int generations = 0, awaited = 0;
  using Clock = std::chrono::steady_clock;
  Clock::duration writing = std::chrono::milliseconds(20);  // of one generation, as last seen on this machine
  for (int cut = 0; cut < kCuts; ++cut) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      close(ends[0]);
      edit_for_ever(path, ends[1]);
    }
    close(ends[1]);
    // Every other cut is after a whole generation, however slow the disk is; each is at a random moment of the next.
    if (cut % 2 == 1) {
      const Clock::time_point begin = Clock::now();
      if (read(ends[0], &reported, sizeof reported) == sizeof reported) {
        writing = Clock::now() - begin;
        ++awaited;
      }
    }
    random = random * 1664525 + 1013904223;  // Numerical Recipes
    std::this_thread::sleep_for(writing * (random >> 16) / (1 << 15));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the editor ended by itself with " << WEXITSTATUS(status);
    for (int32_t n = 0; read(ends[0], &n, sizeof n) == sizeof n;)
      reported = n;
    close(ends[0]);

    // Opened for writing it takes in what the log holds; opened read-only it is then whole.
    Result<LexiconEditor> editor = LexiconEditor::open(path);
    ASSERT_TRUE(editor) << "cut " << cut << ": " << to_string(editor.error());
    ASSERT_TRUE(editor->close());
    const Result<Lexicon> lexicon = Lexicon::open(path);
    ASSERT_TRUE(lexicon) << "cut " << cut << ": " << to_string(lexicon.error());
    const Result<LexiconText> text = lexicon->read_all();
    ASSERT_TRUE(text) << to_string(text.error());
    ASSERT_TRUE(lexicon->check().empty()) << "cut " << cut;
    const std::string& first = text->signs[0].definition;
    const int found = std::stoi(first.substr(11));
    ASSERT_EQ(text->signs.size(), 1U + kSigns);
    for (const Sign& sign : text->signs)
      ASSERT_EQ(sign.definition, first) << "cut " << cut << ": half a transaction";
    ASSERT_GE(found, reported) << "cut " << cut << ": what was reported as written is gone";
    ASSERT_LE(found, reported + 1);
    if (found > reported) reported = found;
    generations = found;
    // Reviews come in order, one transaction each.
    bool ended = false;
    for (int i = 0; i < kSigns; ++i) {
      const Provenance& from = text->signs[1 + static_cast<size_t>(i)].provenance;
      const bool reviewed = from.review == ReviewState::kReviewed;
      ASSERT_EQ(reviewed, from.history.size() == 1U) << "a verdict without its record, or the other way round";
      ASSERT_FALSE(reviewed && ended);
      ended = ended || !reviewed;
    }
  }
  EXPECT_EQ(awaited, kCuts / 2);
  EXPECT_GE(generations, awaited);
  std::printf("%d cuts, %d generations written\n", kCuts, generations);
}

}  // namespace
}  // namespace auslan
