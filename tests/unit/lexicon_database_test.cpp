// SPDX-License-Identifier: Apache-2.0
// The lexicon as a database: nothing is lost on the way, the bytes repeat, and lists and searches say what is there.
#include "lexicon/lexicon.h"
#include "lexicon_sample.h"
#include "phonology/vocabulary.h"

#include <gtest/gtest.h>

namespace auslan {
namespace {

using testing::as_one_text;

const std::filesystem::path kFolder = std::filesystem::path(AUSLANJAM_SOURCE_DIR) / "assets" / "lexicon";

/// The shipped lexicon in a database of its own.
class LexiconDatabase : public ::testing::Test {
 protected:
  void SetUp() override {
    Result<LexiconText> text = read_lexicon_text(kFolder);
    ASSERT_TRUE(text) << to_string(text.error());
    text_ = std::move(*text);
    const Result<void> built = build_database(text_, folder_ / "lexicon.sqlite");
    ASSERT_TRUE(built) << to_string(built.error());
    Result<Lexicon> lexicon = Lexicon::open(folder_ / "lexicon.sqlite");
    ASSERT_TRUE(lexicon) << to_string(lexicon.error());
    lexicon_ = std::make_unique<Lexicon>(std::move(*lexicon));
  }

  ScratchFolder folder_;
  LexiconText text_;
  std::unique_ptr<Lexicon> lexicon_;
};

TEST_F(LexiconDatabase, TheModelThatComesOutIsTheModelThatWentIn) {
  const Result<LexiconText> all = lexicon_->read_all();
  ASSERT_TRUE(all) << to_string(all.error());
  EXPECT_EQ(as_one_text(*all), as_one_text(text_));
  ASSERT_EQ(all->signs.size(), text_.signs.size());
  // Doubles are the same bits, not merely the same text.
  for (size_t i = 0; i < text_.signs.size(); ++i)
    for (size_t p = 0; p < text_.signs[i].dominant.size(); ++p)
      EXPECT_EQ(all->signs[i].dominant[p].offset, text_.signs[i].dominant[p].offset) << text_.signs[i].gloss;
  EXPECT_TRUE(lexicon_->check().empty());
  EXPECT_TRUE(lexicon_->damaged().empty());
}

TEST_F(LexiconDatabase, BuildingTwiceGivesTheSameBytes) {
  ASSERT_TRUE(build_database(text_, folder_ / "again.sqlite"));
  const std::string first = bytes_of(folder_ / "lexicon.sqlite");
  EXPECT_GT(first.size(), 10000u);
  EXPECT_TRUE(first == bytes_of(folder_ / "again.sqlite"));
}

TEST_F(LexiconDatabase, EntriesAreFoundByName) {
  const auto hurt = lexicon_->sign("HURT");
  ASSERT_TRUE(hurt && *hurt);
  EXPECT_EQ((*hurt)->dominant[0].handshape, "spread");
  EXPECT_EQ((*hurt)->non_manual.mouthing, "hurt");
  const auto pronoun = lexicon_->sign("I");
  const auto letter = lexicon_->letter('i');
  ASSERT_TRUE(pronoun && *pronoun && letter && *letter);
  EXPECT_EQ((*pronoun)->kind, "sign");
  EXPECT_EQ((*letter)->kind, "letter");
  const auto seven = lexicon_->number(7);
  ASSERT_TRUE(seven && *seven);
  EXPECT_EQ((*seven)->dominant[0].handshape, "gun");
  const auto flat = lexicon_->handshape("flat");
  ASSERT_TRUE(flat && *flat);
  for (const char* nobody : {"", "hurt", "NO-SUCH-SIGN", "HURT' OR '1'='1", "fs:1"}) {
    const auto none = lexicon_->sign(nobody);
    ASSERT_TRUE(none);
    EXPECT_FALSE(*none) << nobody;
  }
  EXPECT_FALSE(*lexicon_->number(21));
  EXPECT_FALSE(*lexicon_->number(-1));
  EXPECT_FALSE(*lexicon_->letter('?'));
}

TEST_F(LexiconDatabase, KeywordsAreSortedAndPhrasesKeepTheirOrder) {
  const std::vector<Keyword>& keywords = lexicon_->keywords();
  ASSERT_EQ(keywords.size(), text_.keywords.size());
  for (size_t i = 1; i < keywords.size(); ++i)
    EXPECT_LE(std::tie(keywords[i - 1].word, keywords[i - 1].part_of_speech, keywords[i - 1].rank),
              std::tie(keywords[i].word, keywords[i].part_of_speech, keywords[i].rank));
  ASSERT_EQ(lexicon_->phrases().size(), text_.phrases.size());
  for (size_t i = 0; i < text_.phrases.size(); ++i)
    EXPECT_EQ(lexicon_->phrases()[i].id, text_.phrases[i].id);
}

TEST_F(LexiconDatabase, ListsFilter) {
  const auto count = [this](const ListFilter& filter) {
    const auto list = lexicon_->list(filter);
    EXPECT_TRUE(list);
    return list ? list->size() : 0;
  };
  EXPECT_EQ(count({}), text_.signs.size());
  EXPECT_EQ(count({.kind = "letter"}), 26u);
  size_t health = 0, meshed = 0, at_ear = 0;
  for (const Sign& sign : text_.signs) {
    health += sign.category == "health";
    bool wish = false, ear = false;
    for (const auto* hand : {&sign.dominant, &sign.non_dominant})
      for (const Posture& posture : *hand) {
        wish = wish || posture.handshape == "spoon";
        ear = ear || posture.location == Location::kEar;
      }
    meshed += wish;
    at_ear += ear;
  }
  EXPECT_GT(health, 20u);
  EXPECT_EQ(count({.category = "health"}), health);
  EXPECT_EQ(count({.handshape = "spoon"}), meshed);
  ListFilter ear;
  ear.location = Location::kEar;
  EXPECT_EQ(count(ear), at_ear);
  ear.kind = "letter";
  EXPECT_EQ(count(ear), 0u);
  ListFilter reviewed;
  reviewed.review = ReviewState::kReviewed;
  EXPECT_EQ(count(reviewed), 0u);
}

TEST_F(LexiconDatabase, SearchLooksAtGlossesKeywordsAndDefinitions) {
  const auto hurt = lexicon_->search("HuRt");
  ASSERT_TRUE(hurt && !hurt->empty());
  EXPECT_EQ(hurt->front().sign.gloss, "HURT");
  EXPECT_EQ(hurt->front().rank, 0);
  const auto ill = lexicon_->search("ill");
  ASSERT_TRUE(ill && !ill->empty());
  EXPECT_EQ(ill->front().sign.gloss, "SICK") << "a whole keyword comes before a part of one";
  EXPECT_EQ(ill->front().matched, "ill");
  const auto syringe = lexicon_->search("syringe");
  ASSERT_TRUE(syringe && syringe->size() == 1u);
  EXPECT_EQ(syringe->front().rank, 3);
  EXPECT_EQ(syringe->front().sign.gloss, "INJECTION");
  const auto part = lexicon_->search("mBULANc");
  ASSERT_TRUE(part && part->size() == 1u) << "where no word begins so, parts of words are looked for";
  EXPECT_EQ(part->front().sign.gloss, "AMBULANCE");
  EXPECT_EQ(part->front().rank, 2);
  for (const char* nothing : {"", "\"", "\"\"\"", "%", "_%_", "qqqq", "'; DROP TABLE sign; --"}) {
    const auto none = lexicon_->search(nothing);
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->empty()) << nothing;
  }
}

TEST_F(LexiconDatabase, CountsAddUp) {
  const auto counts = lexicon_->counts();
  ASSERT_TRUE(counts);
  EXPECT_EQ(counts->handshapes, 84);
  EXPECT_EQ(counts->letters, 26);
  EXPECT_EQ(static_cast<size_t>(counts->signs + counts->letters + counts->numbers), text_.signs.size());
  EXPECT_EQ(counts->reviewed, 0);
}

TEST_F(LexiconDatabase, ALexiconThatBreaksARuleIsNotBuiltAndTheOldFileStays) {
  const std::string before = bytes_of(folder_ / "lexicon.sqlite");
  text_.signs[0].dominant[0].handshape = "no_such_shape";
  const Result<void> built = build_database(text_, folder_ / "lexicon.sqlite");
  ASSERT_FALSE(built);
  EXPECT_NE(built.error().message.find("no_such_shape"), std::string::npos);
  EXPECT_TRUE(before == bytes_of(folder_ / "lexicon.sqlite"));
}

TEST_F(LexiconDatabase, AnUnwritablePlaceIsAnErrorAndLeavesNothing) {
  const Result<void> built = build_database(text_, folder_ / "no_such_folder/lexicon.sqlite");
  ASSERT_FALSE(built);
  EXPECT_EQ(built.error().code, ErrorCode::kUnwritable);
  std::filesystem::create_directories(folder_ / "taken");
  EXPECT_FALSE(build_database(text_, folder_ / "taken"));
  size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path()))
    ++files;
  EXPECT_EQ(files, 2u) << "only lexicon.sqlite and the folder 'taken' may be there";
}

}  // namespace
}  // namespace auslan
