// SPDX-License-Identifier: Apache-2.0
// Databases that were cut, changed or forged: every read ends in a value or an Error, and the Error says how to
// rebuild.
#include "lexicon/lexicon.h"
#include "lexicon_sample.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

namespace auslan {
namespace {

class LexiconDamage : public ::testing::Test {
 protected:
  void SetUp() override {
    const LexiconReading reading = parse_lexicon_text(testing::sample_sources());
    ASSERT_TRUE(reading.problems.empty());
    ASSERT_TRUE(build_database(reading.text, path_));
    bytes_ = bytes_of(path_);
  }

  /// Changes the database with its own CHECKs and foreign keys switched off.
  void forge(const std::string& sql) {
    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(path_.c_str(), &db), SQLITE_OK);
    sqlite3_db_config(db, SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
    const std::string whole = "PRAGMA foreign_keys = OFF; PRAGMA ignore_check_constraints = ON; " + sql;
    char* message = nullptr;
    const int code = sqlite3_exec(db, whole.c_str(), nullptr, nullptr, &message);
    EXPECT_EQ(code, SQLITE_OK) << (message != nullptr ? message : "") << " in " << sql;
    sqlite3_free(message);
    sqlite3_close(db);
  }

  /// Opens and uses everything; what it returns does not matter, only that it returns.
  void use_everything() const {
    const Result<Lexicon> lexicon = Lexicon::open(path_);
    if (!lexicon) {
      EXPECT_FALSE(lexicon.error().message.empty());
      return;
    }
    (void)lexicon->sign("HURT");
    (void)lexicon->handshape("flat");
    (void)lexicon->handshapes();
    (void)lexicon->list();
    (void)lexicon->search("hurt");
    (void)lexicon->counts();
    (void)lexicon->read_all();
    (void)lexicon->check();
  }

  std::string open_error() const {
    const Result<Lexicon> lexicon = Lexicon::open(path_);
    return lexicon ? "" : to_string(lexicon.error());
  }

  ScratchFolder folder_;
  std::filesystem::path path_ = folder_ / "lexicon.sqlite";
  std::string bytes_;
};

TEST_F(LexiconDamage, AMissingFileSaysHowToBuildOne) {
  std::filesystem::remove(path_);
  EXPECT_NE(open_error().find("not there; rebuild it: auslan-lexicon-build"), std::string::npos) << open_error();
  EXPECT_FALSE(std::filesystem::exists(path_)) << "opening must not create it";
}

TEST_F(LexiconDamage, FoldersTextsAndEmptyFilesAreRefused) {
  std::filesystem::remove(path_);
  std::filesystem::create_directories(path_);
  EXPECT_NE(open_error().find("not a file"), std::string::npos);
  std::filesystem::remove(path_);
  for (const std::string& content :
       {std::string(), std::string("hello"), std::string(10000, 'x'), std::string(5000, '\0')}) {
    put_bytes(path_, content);
    EXPECT_NE(open_error().find("rebuild it"), std::string::npos) << open_error();
  }
}

TEST_F(LexiconDamage, AForeignDatabaseIsToldFromOurs) {
  forge("PRAGMA application_id = 1");
  EXPECT_NE(open_error().find("not a lexicon of this program; rebuild it"), std::string::npos) << open_error();
}

TEST_F(LexiconDamage, AnotherVersionIsToldByItsNumber) {
  forge("PRAGMA user_version = 99");
  EXPECT_NE(open_error().find("another version (99"), std::string::npos) << open_error();
}

TEST_F(LexiconDamage, AMissingOrOtherTableIsNamed) {
  forge("DROP TABLE movement");
  EXPECT_NE(open_error().find("the table movement is missing"), std::string::npos) << open_error();
}

TEST_F(LexiconDamage, AViewInPlaceOfATableIsRefused) {
  forge(
      "ALTER TABLE keyword RENAME TO old_words; CREATE VIEW keyword AS WITH RECURSIVE c(position, word, "
      "part_of_speech, "
      "gloss, rank) AS (SELECT 1, 'w', '', 'HURT', 0 UNION ALL SELECT position + 1, 'w', '', 'HURT', 0 FROM c) SELECT "
      "* FROM c");
  EXPECT_NE(open_error().find("the table keyword"), std::string::npos) << open_error();
}

TEST_F(LexiconDamage, TruncatedAtAnyPageItIsAnError) {
  for (size_t size = 0; size < bytes_.size(); size += 512) {
    put_bytes(path_, bytes_.substr(0, size));
    EXPECT_NE(open_error(), "") << "cut at " << size;
    use_everything();
  }
}

TEST_F(LexiconDamage, FlippedBytesNeverCrash) {
  // A linear congruential generator makes the same damage on every machine.
  unsigned state = 12345;
  const auto next = [&state] { return state = state * 1664525u + 1013904223u, state >> 8; };
  for (int round = 0; round < 300; ++round) {
    std::string broken = bytes_;
    const int flips = 1 + static_cast<int>(next() % 8);
    for (int i = 0; i < flips; ++i) {
      const size_t at = next() % broken.size();
      const unsigned bit = next() % 8;
      broken[at] = static_cast<char>(static_cast<unsigned char>(broken[at]) ^ (1u << bit));
    }
    put_bytes(path_, broken);
    use_everything();
  }
}

struct Forgery {
  const char* name;
  const char* sql;
};

void PrintTo(const Forgery& forgery, std::ostream* out) {
  *out << forgery.name;
}

class LexiconForgery : public LexiconDamage, public ::testing::WithParamInterface<Forgery> {};

TEST_P(LexiconForgery, IsAnErrorOfTheEntryAndAFindingOfTheCheck) {
  forge(GetParam().sql);
  use_everything();
  const Result<Lexicon> lexicon = Lexicon::open(path_);
  if (!lexicon) {
    EXPECT_NE(lexicon.error().message.find("rebuild"), std::string::npos) << lexicon.error().message;
    return;
  }
  EXPECT_FALSE(lexicon->check().empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, LexiconForgery,
    ::testing::Values(
        Forgery{"UnknownLocation", "UPDATE posture SET location = 'the_moon'"},
        Forgery{"UnknownHandshape", "UPDATE posture SET handshape = 'tentacle'"},
        Forgery{"UnknownDirection", "UPDATE posture SET palm = 'sideways'"},
        Forgery{"PalmAlongFingers", "UPDATE posture SET palm = fingers"},
        Forgery{"UnknownContact", "UPDATE posture SET contact = 'kiss' WHERE contact IS NOT NULL"},
        Forgery{"HugeOffset", "UPDATE posture SET offset_left = 1e300"},
        Forgery{"InfiniteOffset", "UPDATE posture SET offset_left = 9e999"},
        Forgery{"PhaseGap", "UPDATE posture SET phase = 9 WHERE phase = 1"}, Forgery{"NoPhases", "DELETE FROM posture"},
        Forgery{"PhaseOutOfRange", "UPDATE movement SET to_phase = 50"},
        Forgery{"HugePhase", "UPDATE movement SET to_phase = 4000000000"},
        Forgery{"ManyRepeats", "UPDATE movement SET repeats = 1000000"},
        Forgery{"UnknownMove", "UPDATE movement SET kind = 'teleport'"},
        Forgery{
            "ManyMoves",
            "WITH RECURSIVE c(i) AS (SELECT 100 UNION ALL SELECT i + 1 FROM c WHERE i < 500) INSERT INTO movement "
            "SELECT "
            "gloss, i, kind, direction, size, repeats, hands, manner, plane, bow, start, eighths, ellipse, flattening, "
            "growth, digits, pace, from_phase, to_phase FROM movement, c "
            "WHERE position = 0"},
        Forgery{"UnknownBow", "UPDATE movement SET bow = 'sideways'"},
        Forgery{"TooManyEighths", "UPDATE movement SET eighths = 1000"},
        Forgery{"NoPace", "UPDATE movement SET pace = 0.0"},
        Forgery{"UnknownTier",
                "INSERT INTO feature SELECT gloss, 0, 'ears', 'wide', 0.0, 1.0, 1.0 FROM sign WHERE position = 0"},
        Forgery{"FeatureBackwards",
                "INSERT INTO feature SELECT gloss, 0, 'brows', 'raise', 0.9, 0.1, 1.0 FROM sign WHERE position = 0"},
        Forgery{"UnknownHandedness", "UPDATE sign SET handedness = 'three'"},
        Forgery{"UnknownKind", "UPDATE sign SET kind = 'dance'"},
        Forgery{"LongText", "UPDATE sign SET definition = hex(zeroblob(100000))"},
        Forgery{"UnknownFace", "UPDATE sign SET brows = 'gone'"},
        Forgery{"UnknownConfidence", "UPDATE sign SET confidence = 'total'"},
        Forgery{"ReviewedByNobody", "UPDATE sign SET review = 'reviewed'"},
        Forgery{"OddGloss",
                "UPDATE sign SET gloss = 'a b'; UPDATE posture SET gloss = 'a b'; UPDATE movement SET gloss = 'a b'"},
        Forgery{"LostFinger", "DELETE FROM finger WHERE digit = 2"},
        Forgery{"WildAngle", "UPDATE finger SET pip = 5000.0"},
        Forgery{"LostBase", "UPDATE handshape SET base = 'nothing'"},
        Forgery{"OddKeyword", "UPDATE keyword SET gloss = 'x y' WHERE rank = 0"},
        Forgery{"DanglingKeyword", "UPDATE keyword SET gloss = 'NOBODY'"},
        Forgery{"HugeRank", "UPDATE keyword SET rank = 5000"}, Forgery{"NoKeywords", "DELETE FROM keyword"},
        Forgery{"SpanOutOfRange", "UPDATE phrase_span SET to_item = 40"}, Forgery{"NoItems", "DELETE FROM phrase_item"},
        Forgery{"OddItem", "UPDATE phrase_item SET item = '{ROOT}' WHERE position = 0"}),
    [](const ::testing::TestParamInfo<Forgery>& forgery) { return std::string(forgery.param.name); });

TEST_F(LexiconDamage, ADamagedPhraseIsLeftOutAndTold) {
  forge("DELETE FROM phrase_item");
  const Result<Lexicon> lexicon = Lexicon::open(path_);
  ASSERT_TRUE(lexicon);
  EXPECT_TRUE(lexicon->phrases().empty());
  ASSERT_EQ(lexicon->damaged().size(), 1u);
  EXPECT_EQ(lexicon->damaged()[0].entry, "phrase i-hurt");
  EXPECT_FALSE(lexicon->read_all()) << "an export must not lose it silently";
}

}  // namespace
}  // namespace auslan
