// SPDX-License-Identifier: Apache-2.0
// The lexicon as people change it: reviews, comparing, bringing two lexicons together, and databases of older versions.
#include "lexicon/lexicon_edit.h"

#include "lexicon/lexicon_compare.h"
#include "lexicon_sample.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

namespace auslan {
namespace {

LexiconText sample() {
  LexiconReading reading = parse_lexicon_text(testing::sample_sources());
  EXPECT_TRUE(reading.problems.empty());
  return std::move(reading.text);
}

Review said(ReviewState verdict, const std::string& remark = "") {
  return {"A. Signer", "2026-01-31", verdict, remark, ""};
}

class LexiconEdit : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(build_database(sample(), path_)); }

  void review(const std::string& entry, const Review& review) {
    Result<LexiconEditor> editor = LexiconEditor::open(path_);
    ASSERT_TRUE(editor) << to_string(editor.error());
    const Result<void> done = editor->review(entry, review);
    ASSERT_TRUE(done) << to_string(done.error());
    ASSERT_TRUE(editor->close());
  }
  LexiconText read() const {
    const Result<Lexicon> lexicon = Lexicon::open(path_);
    EXPECT_TRUE(lexicon) << to_string(lexicon.error());
    Result<LexiconText> text = lexicon->read_all();
    EXPECT_TRUE(text) << to_string(text.error());
    EXPECT_TRUE(lexicon->check().empty());
    return std::move(*text);
  }

  ScratchFolder folder_;
  std::filesystem::path path_ = folder_ / "lexicon.sqlite";
};

TEST_F(LexiconEdit, AReviewStaysWithItsEntryAndAddsToItsHistory) {
  review("HURT", said(ReviewState::kRejected, "the hand is too high"));
  review("HURT", {"B. Signer", "2026-02-28", ReviewState::kReviewed, "", ""});
  const LexiconText text = read();
  const Provenance& from = text.signs[0].provenance;
  EXPECT_EQ(from.review, ReviewState::kReviewed);
  EXPECT_EQ(from.reviewed_by, "B. Signer");
  EXPECT_EQ(from.reviewed_on, "2026-02-28");
  ASSERT_EQ(from.history.size(), 2U);
  EXPECT_EQ(from.history[0].remark, "the hand is too high");
  EXPECT_EQ(from.history[0].verdict, ReviewState::kRejected);
  EXPECT_EQ(from.history[1].content, content_digest(text.signs[0], text.keywords));
  // Text -> model -> text keeps all of it.
  const LexiconReading again = parse_lexicon_text(write_lexicon_text(text));
  EXPECT_TRUE(again.problems.empty());
  EXPECT_EQ(testing::as_one_text(again.text), testing::as_one_text(text));
}

TEST_F(LexiconEdit, APhraseAndAHandshapeAreReviewedAsWell) {
  review("phrase i-hurt", said(ReviewState::kReviewed));
  review("handshape flat", said(ReviewState::kReviewed));
  const LexiconText text = read();
  EXPECT_EQ(text.phrases[0].provenance.review, ReviewState::kReviewed);
  EXPECT_EQ(text.handshapes[0].provenance.review, ReviewState::kReviewed);
  EXPECT_EQ(text.signs[0].provenance.review, ReviewState::kUnreviewed);
}

TEST_F(LexiconEdit, AReviewThatIsTakenBackLeavesTheEntryUnreviewed) {
  review("HURT", said(ReviewState::kReviewed));
  review("HURT", said(ReviewState::kUnreviewed, "I looked at another sign"));
  const LexiconText text = read();
  EXPECT_EQ(text.signs[0].provenance.review, ReviewState::kUnreviewed);
  EXPECT_TRUE(text.signs[0].provenance.reviewed_by.empty());
  EXPECT_EQ(text.signs[0].provenance.history.size(), 2U);
}

TEST_F(LexiconEdit, WhatIsChangedAfterItsReviewHasToBeReviewedAgain) {
  review("HURT", said(ReviewState::kReviewed));
  LexiconText text = read();
  text.signs[0].definition = "Another hand.";
  const std::vector<Finding> findings = check_lexicon(text);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].entry, "HURT");
  EXPECT_NE(findings[0].message.find("changed after this review"), std::string::npos);
  // A keyword belongs to what a reviewer has approved.
  text = read();
  text.keywords[0].word = "love";
  EXPECT_EQ(check_lexicon(text).size(), 1U);
}

TEST_F(LexiconEdit, BadReviewsChangeNothing) {
  const std::string before = testing::as_one_text(read());
  Result<LexiconEditor> editor = LexiconEditor::open(path_);
  ASSERT_TRUE(editor);
  const Review good = said(ReviewState::kReviewed);
  Review no_date = good, nobody = good, long_remark = good;
  no_date.on = "yesterday";
  nobody.by = "";
  long_remark.remark = std::string(5000, 'x');
  for (const Review& bad : {no_date, nobody, long_remark})
    EXPECT_FALSE(editor->review("HURT", bad));
  for (const char* entry : {"NO-SUCH-SIGN", "", "phrase ", "phrase nobody", "handshape ' OR 1", "HURT' --"})
    EXPECT_FALSE(editor->review(entry, good)) << entry;
  ASSERT_TRUE(editor->close());
  EXPECT_EQ(testing::as_one_text(read()), before);
}

TEST_F(LexiconEdit, ReplacingRefusesFindingsAndKeepsWhatWasThere) {
  const std::string before = testing::as_one_text(read());
  Result<LexiconEditor> editor = LexiconEditor::open(path_);
  ASSERT_TRUE(editor);
  LexiconText bad = sample();
  bad.signs[0].dominant[0].handshape = "nobody";
  EXPECT_FALSE(editor->replace(bad));
  LexiconText good = sample();
  good.signs[0].definition = "Something else.";
  EXPECT_TRUE(editor->replace(good));
  ASSERT_TRUE(editor->close());
  EXPECT_NE(before, testing::as_one_text(good));
  EXPECT_EQ(testing::as_one_text(read()), testing::as_one_text(good));
}

TEST_F(LexiconEdit, AfterClosingThereIsOneFile) {
  review("HURT", said(ReviewState::kReviewed));
  EXPECT_EQ(folder_.contents(), std::vector<std::string>{"lexicon.sqlite"});
}

TEST_F(LexiconEdit, WhatIsNoLexiconIsNotOpenedForWriting) {
  EXPECT_FALSE(LexiconEditor::open(folder_ / "missing.sqlite"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "missing.sqlite"));
  put_bytes(folder_ / "text.sqlite", "hello");
  EXPECT_FALSE(LexiconEditor::open(folder_ / "text.sqlite"));
  EXPECT_EQ(bytes_of(folder_ / "text.sqlite"), "hello");
}

/// The sample as the program of an older schema wrote it.
void write_old_database(const std::filesystem::path& path) {
  std::filesystem::remove(path);
  sqlite3* db = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &db), SQLITE_OK);
  const std::string sql =
      bytes_of(std::filesystem::path(AUSLANJAM_SOURCE_DIR) / "tests" / "support" / "lexicon_v2.sql");
  EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(db);
  sqlite3_close(db);
}

/// What the schema of a database says, in the order of its names.
std::string schema_of(const std::filesystem::path& path) {
  sqlite3* db = nullptr;
  EXPECT_EQ(sqlite3_open(path.c_str(), &db), SQLITE_OK);
  std::string text;
  sqlite3_exec(
      db, "SELECT type, name, sql FROM sqlite_schema ORDER BY name",
      [](void* out, int count, char** values, char**) {
        for (int i = 0; i < count; ++i)
          *static_cast<std::string*>(out) += std::string(values[i] != nullptr ? values[i] : "-") + "\n";
        return 0;
      },
      &text, nullptr);
  sqlite3_close(db);
  return text;
}

TEST_F(LexiconEdit, AnOlderDatabaseBecomesWhatANewOneIs) {
  const std::string new_schema = schema_of(path_);
  write_old_database(path_);
  const Result<Lexicon> read_only = Lexicon::open(path_);
  ASSERT_FALSE(read_only);
  EXPECT_NE(read_only.error().message.find("db migrate"), std::string::npos) << to_string(read_only.error());
  Result<LexiconEditor> editor = LexiconEditor::open(path_);
  ASSERT_TRUE(editor) << to_string(editor.error());
  EXPECT_EQ(editor->opened_version(), 2);
  ASSERT_TRUE(editor->close());
  EXPECT_EQ(schema_of(path_), new_schema);
  EXPECT_EQ(testing::as_one_text(read()), testing::as_one_text(sample()));
}

TEST_F(LexiconEdit, AnOlderDatabaseThatIsDamagedStaysAsItIs) {
  write_old_database(path_);
  sqlite3* db = nullptr;
  ASSERT_EQ(sqlite3_open(path_.c_str(), &db), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(db, "PRAGMA ignore_check_constraints = ON; UPDATE sign SET handedness = 'three'", nullptr,
                         nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(db);
  const std::string before = schema_of(path_);
  EXPECT_FALSE(LexiconEditor::open(path_));
  EXPECT_EQ(schema_of(path_), before);
}

TEST(LexiconCompare, TellsWhatWasAddedRemovedChangedAndReviewed) {
  const LexiconText before = sample();
  EXPECT_TRUE(compare_lexicons(before, before).empty());
  LexiconText after = before;
  after.handshapes[0].fingers[0].mcp = 12;
  after.phrases.clear();
  Sign more = after.signs[0];
  more.gloss = "SORE";
  after.signs.push_back(more);
  after.signs[0].provenance.history.push_back(said(ReviewState::kUnreviewed, "not yet"));
  const std::vector<EntryChange> changes = compare_lexicons(before, after);
  ASSERT_EQ(changes.size(), 4U);
  EXPECT_EQ(changes[0].entry, "handshape flat");
  EXPECT_EQ(changes[0].kind, ChangeKind::kChanged);
  EXPECT_EQ(changes[0].lines, (std::vector<std::string>{"- index = [0, 0, 0, 2]", "+ index = [12, 0, 0, 2]"}));
  EXPECT_EQ(changes[1].entry, "HURT");
  EXPECT_EQ(changes[1].kind, ChangeKind::kReviewed);
  EXPECT_EQ(changes[2].entry, "phrase i-hurt");
  EXPECT_EQ(changes[2].kind, ChangeKind::kRemoved);
  EXPECT_EQ(changes[3].entry, "SORE");
  EXPECT_EQ(changes[3].kind, ChangeKind::kAdded);
}

TEST(LexiconMerge, TakesWhatIsNewWithItsKeywords) {
  LexiconText theirs = sample();
  Sign more = theirs.signs[0];
  more.gloss = "SORE";
  theirs.signs.push_back(more);
  theirs.keywords.push_back({"sore", "noun", "SORE", 0});
  theirs.signs[0].provenance.history.push_back(said(ReviewState::kUnreviewed, "not yet"));
  const LexiconMerge merge = merge_lexicons(sample(), theirs, OnConflict::kRefuse);
  EXPECT_EQ(merge.added, std::vector<std::string>{"SORE"});
  EXPECT_EQ(merge.reviewed, std::vector<std::string>{"HURT"});
  EXPECT_TRUE(merge.conflicts.empty());
  EXPECT_TRUE(check_lexicon(merge.merged).empty());
  EXPECT_EQ(testing::as_one_text(merge.merged), testing::as_one_text(theirs));
  // The other way round there is nothing to take, and nothing is lost.
  const LexiconMerge back = merge_lexicons(theirs, sample(), OnConflict::kRefuse);
  EXPECT_TRUE(back.added.empty() && back.reviewed.empty() && back.conflicts.empty());
  EXPECT_EQ(testing::as_one_text(back.merged), testing::as_one_text(theirs));
}

TEST(LexiconMerge, NothingIsOverwrittenUnlessToldSo) {
  LexiconText theirs = sample();
  theirs.signs[0].definition = "Another hand.";
  theirs.keywords[0].word = "ache";
  for (const OnConflict keep : {OnConflict::kRefuse, OnConflict::kKeepOurs}) {
    const LexiconMerge merge = merge_lexicons(sample(), theirs, keep);
    ASSERT_EQ(merge.conflicts.size(), 1U);
    EXPECT_EQ(merge.conflicts[0].entry, "HURT");
    EXPECT_EQ(testing::as_one_text(merge.merged), testing::as_one_text(sample()));
  }
  const LexiconMerge taken = merge_lexicons(sample(), theirs, OnConflict::kTakeTheirs);
  EXPECT_EQ(taken.conflicts.size(), 1U);
  EXPECT_EQ(testing::as_one_text(taken.merged), testing::as_one_text(theirs));
}

}  // namespace
}  // namespace auslan
