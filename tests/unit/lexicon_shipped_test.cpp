// SPDX-License-Identifier: Apache-2.0
// The lexicon that is shipped: it compiles, it is canonical, and it holds what the sources of facts say it must.
#include "lexicon/lexicon.h"
#include "lexicon_sample.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace auslan {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(AUSLANJAM_SOURCE_DIR) / "assets" / "lexicon";
const std::filesystem::path kFacts =
    std::filesystem::path(AUSLANJAM_SOURCE_DIR) / ".." / "shared" / "reference" / "lexicon";

/// The lexicon, read once; a test that needs it fails by its assertion when it does not read.
const LexiconText& shipped() {
  static const LexiconText text = [] {
    Result<LexiconText> read = read_lexicon_text(kFolder);
    EXPECT_TRUE(read) << to_string(read.error());
    return read ? std::move(*read) : LexiconText{};
  }();
  return text;
}

const Sign* find_sign(std::string_view gloss) {
  const auto found = std::ranges::find(shipped().signs, gloss, &Sign::gloss);
  return found == shipped().signs.end() ? nullptr : &*found;
}

size_t count_of_kind(std::string_view kind) {
  return static_cast<size_t>(std::ranges::count(shipped().signs, kind, &Sign::kind));
}

/// The values of "key": "…" in a file of one JSON object a line.
std::vector<std::string> json_values(const std::string& text, const std::string& key) {
  std::vector<std::string> values;
  const std::string wanted = "{\"" + key + "\": \"";
  for (size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at + 1)) {
    const size_t start = at + wanted.size();
    values.push_back(text.substr(start, text.find('"', start) - start));
  }
  return values;
}

TEST(ShippedLexicon, HasNoProblems) {
  for (const Error& problem : check_lexicon_text(kFolder))
    ADD_FAILURE() << to_string(problem);
}

TEST(ShippedLexicon, IsInItsCanonicalForm) {
  const Result<std::vector<TextSource>> sources = load_lexicon_sources(kFolder);
  ASSERT_TRUE(sources);
  const std::vector<TextSource> written = write_lexicon_text(shipped());
  ASSERT_EQ(sources->size(), written.size());
  for (size_t i = 0; i < written.size(); ++i) {
    EXPECT_EQ((*sources)[i].name, written[i].name);
    EXPECT_TRUE((*sources)[i].text == written[i].text)
        << written[i].name << " is not canonical; run auslan-lexicon-build assets/lexicon --format";
  }
}

TEST(ShippedLexicon, HoldsTheBaseHandshapesOfTheSignbankList) {
  const std::set<std::string> base = {"relaxed", "round",      "okay",     "point",  "hook",      "two",    "kneel",
                                      "perth",   "spoon",      "letter_n", "wish",   "three",     "mother", "letter_m",
                                      "four",    "spread",     "ball",     "flat",   "thick",     "cup",    "good",
                                      "bad",     "gun",        "letter_c", "small",  "seven_old", "eight",  "nine",
                                      "fist",    "soon",       "ten",      "write",  "salt",      "duck",   "middle",
                                      "rude",    "ambivalent", "love",     "animal", "queer",     "buckle"};
  ASSERT_EQ(base.size(), 41u);
  std::set<std::string> own_base;
  for (const Handshape& shape : shipped().handshapes)
    if (shape.base == shape.id) own_base.insert(shape.id);
  EXPECT_EQ(own_base, base);
  EXPECT_EQ(shipped().handshapes.size(), 84u);
}

TEST(ShippedLexicon, HoldsEveryHandshapeOfTheFacts) {
  const std::filesystem::path file = kFacts / "handshapes.jsonl";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the folder with the facts is not here";
  std::vector<std::string> ids;
  for (const Handshape& shape : shipped().handshapes)
    ids.push_back(shape.id);
  EXPECT_EQ(ids, json_values(bytes_of(file), "id"));
}

TEST(ShippedLexicon, ShapesThatDifferInTheirNameDifferInTheirAngles) {
  // Open against closed: what makes point, two, three, four a row of digits.
  const auto flexed = [](std::string_view id) {
    const auto shape = std::ranges::find(shipped().handshapes, id, &Handshape::id);
    std::string states;
    for (const FingerAngles& finger : shape->fingers)
      states += finger.mcp + finger.pip + finger.dip > 150 ? 'c' : 'o';
    return states;
  };
  EXPECT_EQ(flexed("point"), "occc");
  EXPECT_EQ(flexed("two"), "oocc");
  EXPECT_EQ(flexed("three"), "oooc");
  EXPECT_EQ(flexed("four"), "oooo");
  EXPECT_EQ(flexed("bad"), "ccco");
  EXPECT_EQ(flexed("love"), "occo");
  EXPECT_EQ(flexed("fist"), "cccc");
}

TEST(ShippedLexicon, HasTheTwoHandedAlphabet) {
  EXPECT_EQ(count_of_kind("letter"), 26u);
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const Sign* sign = find_sign(std::string("fs:") + letter);
    ASSERT_NE(sign, nullptr) << letter;
    EXPECT_EQ(sign->handedness, letter == 'C' ? Handedness::kOne : Handedness::kDominantBase)
        << letter << ": all letters but C take two hands";
  }
  // The vowels are the five digits of one and the same base hand.
  const std::map<char, Location> vowels = {{'A', Location::kOtherThumb},
                                           {'E', Location::kOtherIndex},
                                           {'I', Location::kOtherMiddle},
                                           {'O', Location::kOtherRing},
                                           {'U', Location::kOtherLittle}};
  for (const auto& [letter, digit] : vowels) {
    const Sign* sign = find_sign(std::string("fs:") + letter);
    EXPECT_EQ(sign->dominant[0].location, digit) << letter;
    EXPECT_EQ(sign->dominant[0].contact->part, HandPart::kIndexTip) << letter;
    EXPECT_EQ(sign->non_dominant[0].palm, find_sign("fs:E")->non_dominant[0].palm) << letter;
    EXPECT_EQ(sign->non_dominant[0].handshape, "spread") << letter;
  }
}

TEST(ShippedLexicon, LettersTouchAndAreHeld) {
  for (const Sign& sign : shipped().signs) {
    if (sign.kind != "letter" || sign.gloss == "fs:C") continue;
    EXPECT_TRUE(sign.dominant[0].contact) << sign.gloss;
    const bool moves = sign.gloss == "fs:H" || sign.gloss == "fs:J";
    EXPECT_EQ(sign.movements.size() == 1 && sign.movements[0].kind == MoveKind::kHold, !moves) << sign.gloss;
  }
}

TEST(ShippedLexicon, HasTheNumbers) {
  for (int value = 0; value <= 20; ++value)
    EXPECT_NE(find_sign("num:" + std::to_string(value)), nullptr) << value;
  for (const char* value : {"30", "90", "100", "1000", "1000000"})
    EXPECT_NE(find_sign(std::string("num:") + value), nullptr) << value;
  const std::map<int, std::string> digits = {{0, "round"},  {1, "point"}, {2, "two"}, {3, "three"}, {4, "four"},
                                             {5, "spread"}, {6, "good"},  {7, "gun"}, {8, "eight"}, {9, "nine"}};
  for (const auto& [value, shape] : digits)
    EXPECT_EQ(find_sign("num:" + std::to_string(value))->dominant[0].handshape, shape) << value;
}

TEST(ShippedLexicon, HasTheSignsOfAHospital) {
  EXPECT_GE(count_of_kind("sign"), 110u);
  for (const char* gloss :
       {"PAIN",   "HURT",      "DOCTOR",      "NURSE",       "HOSPITAL", "MEDICINE", "TABLET",        "INJECTION",
        "BLOOD",  "SICK",      "HELP",        "EMERGENCY",   "POLICE",   "FIRE",     "TOILET",        "WATER",
        "WAIT",   "WHERE",     "WHAT",        "WHO",         "WHEN",     "HOW",      "WHY",           "YES",
        "NO",     "PLEASE",    "THANK-YOU",   "SORRY",       "NAME",     "MY",       "YOUR",          "I",
        "YOU",    "HE-SHE-IT", "UNDERSTAND",  "NOT",         "NEED",     "WANT",     "HAVE",          "CAN",
        "CANT",   "MUST",      "WILL",        "FINISH",      "TODAY",    "TOMORROW", "NOW",           "TIME",
        "DAY",    "WEEK",      "APPOINTMENT", "INTERPRETER", "DEAF",     "HEARING",  "SIGN-LANGUAGE", "AUSLAN",
        "MOTHER", "FATHER",    "EAT",         "DRINK",       "HELLO"})
    EXPECT_NE(find_sign(gloss), nullptr) << gloss;
}

TEST(ShippedLexicon, CarriesTheCorrectionsFromTheSisterLanguage) {
  // Facts of the comparison with British Sign Language, each with the evidence that decided.
  const auto evidence = [](const char* gloss) { return find_sign(gloss)->provenance.movement_evidence; };
  EXPECT_EQ(find_sign("DIE")->dominant[0].fingers, (Direction{0, 1, 0})) << "the fingers stand";
  EXPECT_EQ(find_sign("DIE")->dominant[1].fingers, (Direction{0, 0, 1})) << "and fall forward";
  EXPECT_EQ(find_sign("STEAL")->dominant[0].location, Location::kOtherPalm);
  EXPECT_EQ(find_sign("BREAD")->dominant[0].location, Location::kOtherPalm);
  EXPECT_EQ(find_sign("EASY")->movements[0].kind, MoveKind::kTap);
  EXPECT_EQ(find_sign("COMPLAIN")->movements[0].kind, MoveKind::kCircle);
  EXPECT_EQ(find_sign("FIRST")->dominant[1].palm, (Direction{0, 0, -1})) << "turns towards the signer";
  EXPECT_EQ(find_sign("MONTH")->movements[0].kind, MoveKind::kTap);
  EXPECT_EQ(find_sign("SICK")->movements[0].repeats, 1);
  EXPECT_EQ(find_sign("DOCTOR")->dominant.back().handshape, "salt") << "two fingers and the thumb grip the wrist";
  for (const char* gloss :
       {"DIE",        "STEAL", "BREAD",  "EASY",  "COMPLAIN", "FIRST", "MONTH", "SICK", "DOCTOR", "POLICE",
        "UNDERSTAND", "BLOOD", "TICKET", "GREEN", "WHITE",    "NEAR",  "HOUR",  "WORK", "PAIN",   "HELP"})
    EXPECT_NE(evidence(gloss).find("BSL (Dicta-Sign)"), std::string::npos) << gloss;
}

TEST(ShippedLexicon, IsNotCalledReviewed) {
  for (const Sign& sign : shipped().signs)
    EXPECT_EQ(sign.provenance.review, ReviewState::kUnreviewed) << sign.gloss << ": no Deaf signer has seen it";
  for (const Phrase& phrase : shipped().phrases)
    EXPECT_EQ(phrase.provenance.review, ReviewState::kUnreviewed) << phrase.id;
}

TEST(ShippedLexicon, EverySourceIsExplained) {
  const std::string page = bytes_of(kFolder / "SOURCES.md");
  std::set<std::string> tags;
  const auto collect = [&tags](const Provenance& provenance) {
    tags.insert(provenance.sources.begin(), provenance.sources.end());
  };
  for (const Handshape& shape : shipped().handshapes)
    collect(shape.provenance);
  for (const Sign& sign : shipped().signs)
    collect(sign.provenance);
  for (const Phrase& phrase : shipped().phrases)
    collect(phrase.provenance);
  EXPECT_GT(tags.size(), 5u);
  for (const std::string& tag : tags) {
    const bool alone = page.find("| " + tag + " |") != std::string::npos;
    const bool in_row = page.find(tag + ",") != std::string::npos || page.find(", " + tag + " |") != std::string::npos;
    EXPECT_TRUE(alone || in_row) << tag;
  }
}

TEST(ShippedLexicon, PhrasesAskWithTheQuestionSignLast) {
  EXPECT_GE(shipped().phrases.size(), 67u);
  const auto hurt = std::ranges::find(shipped().phrases, std::string("Where does it hurt?"), &Phrase::english);
  ASSERT_NE(hurt, shipped().phrases.end());
  EXPECT_EQ(hurt->glosses, (std::vector<std::string>{"HURT", "WHERE"}));
  const std::set<std::string> questions = {"WHAT",  "WHERE",    "WHO",      "WHEN",   "WHY",
                                           "WHICH", "HOW-MANY", "HOW-MUCH", "HOW-OLD"};
  for (const Phrase& phrase : shipped().phrases) {
    for (const NonManualSpan& span : phrase.non_manual) {
      if (span.kind != "wh") continue;
      EXPECT_EQ(span.brows, "furrow") << phrase.id;
      EXPECT_TRUE(questions.contains(phrase.glosses[static_cast<size_t>(span.to)])) << phrase.id;
    }
  }
}

TEST(ShippedLexicon, EveryPhraseOfTheFactsIsThere) {
  const std::filesystem::path file = kFacts / "phrases.jsonl";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the folder with the facts is not here";
  std::set<std::string> sentences;
  for (const Phrase& phrase : shipped().phrases)
    sentences.insert(phrase.english);
  const std::string text = bytes_of(file);
  int missing = 0;
  const std::string key = "\"english\": \"";
  for (size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    const size_t start = at + key.size();
    std::string english = text.substr(start, text.find('"', start) - start);
    if (const size_t dots = english.find("..."); dots != std::string::npos) english.replace(dots, 3, "{NAME}.");
    const size_t slash = english.find(" / ");  // two sentences in one row are two phrases here
    if (!sentences.contains(english.substr(0, slash))) ++missing, ADD_FAILURE() << english;
    if (slash != std::string::npos && !sentences.contains(english.substr(slash + 3)))
      ++missing, ADD_FAILURE() << english;
  }
  EXPECT_EQ(missing, 0);
}

TEST(ShippedLexicon, HandsInSpaceAreInFrontOfTheBody) {
  // A place in space is measured from the sternum; less than 5 cm would put the hand into the chest.
  const std::set<Location> space = {Location::kHighNeutral, Location::kNeutral, Location::kLowNeutral,
                                    Location::kIpsiSpace, Location::kContraSpace};
  for (const Sign& sign : shipped().signs) {
    for (const auto* hand : {&sign.dominant, &sign.non_dominant}) {
      for (const Posture& posture : *hand) {
        if (!space.contains(posture.location)) continue;
        EXPECT_GE(posture.offset.z, 0.05) << sign.gloss;
      }
    }
  }
}

}  // namespace
}  // namespace auslan
