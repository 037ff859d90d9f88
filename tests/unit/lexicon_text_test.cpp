// SPDX-License-Identifier: Apache-2.0
// The text of the lexicon: what is read, what each kind of mistake is told as, and that writing loses nothing.
#include "lexicon/lexicon_text.h"

#include "lexicon/lexicon_check.h"
#include "lexicon_sample.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace auslan {
namespace {

using testing::as_one_text;
using testing::sample_sources;

std::string all_problems(const LexiconReading& reading) {
  std::string all;
  for (const Error& problem : reading.problems)
    all += to_string(problem) + "\n";
  return all;
}

/// The line of the first occurrence of `text` in a source.
long line_of(const std::string& source, const std::string& text) {
  const size_t at = source.find(text);
  return 1 + static_cast<long>(std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

TEST(LexiconText, EveryFieldIsRead) {
  const LexiconReading reading = parse_lexicon_text(sample_sources());
  ASSERT_EQ(all_problems(reading), "");
  const LexiconText& text = reading.text;
  ASSERT_EQ(text.handshapes.size(), 1u);
  const Handshape& shape = text.handshapes[0];
  EXPECT_EQ(shape.base, "flat") << "a base that is not given is the shape itself";
  EXPECT_EQ(shape.fingers[3].dip, 0.5);
  EXPECT_EQ(shape.fingers[3].abduction, 4.0);
  EXPECT_EQ(shape.thumb.radial_abduction, 20.0);
  EXPECT_EQ(shape.thumb.palmar_abduction, 10.0);
  EXPECT_EQ(shape.thumb.opposition, 0.25);
  EXPECT_EQ(shape.thumb.mp, 5.0);
  EXPECT_EQ(shape.aliases[1], "paper \"hand\"");
  ASSERT_EQ(text.signs.size(), 1u);
  const Sign& sign = text.signs[0];
  EXPECT_EQ(sign.kind, "sign");
  EXPECT_EQ(sign.category, "health") << "the category is the file's name";
  EXPECT_EQ(sign.region, "north");
  EXPECT_EQ(sign.handedness, Handedness::kDominantBase);
  ASSERT_EQ(sign.dominant.size(), 2u);
  const Posture& posture = sign.dominant[0];
  EXPECT_EQ(posture.fingers, (Direction{1, 1, 0}));
  EXPECT_EQ(posture.palm, (Direction{0, 0, -1}));
  EXPECT_EQ(posture.location, Location::kOtherPalm);
  EXPECT_DOUBLE_EQ(posture.offset.x, -0.08) << "centimetres become metres, left stays left";
  EXPECT_DOUBLE_EQ(posture.offset.y, 0.065);
  EXPECT_DOUBLE_EQ(posture.offset.z, 0.001);
  ASSERT_TRUE(posture.contact);
  EXPECT_EQ(posture.contact->kind, ContactKind::kTouch);
  EXPECT_EQ(posture.contact->part, HandPart::kIndexTip);
  EXPECT_EQ(posture.contact->target, Location::kOtherThumb);
  ASSERT_EQ(sign.movements.size(), 2u);
  EXPECT_EQ(sign.movements[0].kind, MoveKind::kShake);
  EXPECT_EQ(sign.movements[0].repeats, 3);
  EXPECT_EQ(sign.movements[0].hands, MovingHands::kBoth);
  EXPECT_EQ(sign.movements[0].plane, Plane::kUpDown);
  EXPECT_EQ(sign.movements[1].hands, MovingHands::kDominant) << "the base rests unless the text says otherwise";
  EXPECT_EQ(sign.movements[1].size, Size::kMedium);
  EXPECT_EQ(sign.movements[1].direction, (Direction{1, -1, 0}));
  EXPECT_EQ(sign.non_manual.brows, "furrow");
  EXPECT_EQ(sign.non_manual.mouthing, "hurt");
  EXPECT_EQ(sign.provenance.sources, (std::vector<std::string>{"memory", "iconic"}));
  EXPECT_EQ(sign.provenance.review, ReviewState::kUnreviewed);
  ASSERT_EQ(text.keywords.size(), 2u);
  EXPECT_EQ(text.keywords[1].word, "sore");
  EXPECT_EQ(text.keywords[1].part_of_speech, "adj");
  EXPECT_EQ(text.keywords[1].rank, 1);
  ASSERT_EQ(text.phrases.size(), 1u);
  EXPECT_EQ(text.phrases[0].glosses[3], "num:10");
  EXPECT_EQ(text.phrases[0].non_manual[0].ending, "hold last sign");
}

TEST(LexiconText, UsualHandsFollowTheHandedness) {
  std::vector<TextSource> sources = sample_sources();
  std::string& text = sources[3].text;
  text.replace(text.find("base = ["), text.find("moves") - text.find("base = ["), "");
  text.replace(text.find("dominant+base"), 13, "two-alternating");
  text.replace(text.find("nd_palm"), 7, "neutral");
  text.replace(text.find("hands = \"both\", "), 16, "");
  const LexiconReading reading = parse_lexicon_text(sources);
  ASSERT_EQ(all_problems(reading), "");
  EXPECT_EQ(reading.text.signs[0].movements[0].hands, MovingHands::kAlternating);
}

TEST(LexiconText, WritingAndReadingGivesTheSameModelAndTheSameBytes) {
  const LexiconReading first = parse_lexicon_text(sample_sources());
  const std::vector<TextSource> written = write_lexicon_text(first.text);
  const LexiconReading second = parse_lexicon_text(written);
  ASSERT_EQ(all_problems(second), "");
  EXPECT_EQ(as_one_text(second.text), as_one_text(first.text));
  EXPECT_EQ(second.text.signs[0].dominant[0].offset, first.text.signs[0].dominant[0].offset);
  EXPECT_EQ(second.text.handshapes[0].aliases, first.text.handshapes[0].aliases);
  EXPECT_EQ(second.text.keywords[1].rank, 1);
}

struct Mistake {
  const char* name;
  const char* file;
  const char* was;  ///< the text to replace, on whose line the problem stands
  const char* becomes;
  const char* expected;  ///< part of the message
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

class LexiconMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(LexiconMistake, IsToldWithItsLineAndWhatWasExpected) {
  const Mistake& mistake = GetParam();
  std::vector<TextSource> sources = sample_sources();
  std::string place;
  for (TextSource& source : sources) {
    if (source.name != mistake.file) continue;
    const size_t at = source.text.find(mistake.was);
    ASSERT_NE(at, std::string::npos);
    place = source.name + ":" + std::to_string(line_of(source.text, mistake.was));
    source.text.replace(at, std::string(mistake.was).size(), mistake.becomes);
  }
  const LexiconReading reading = parse_lexicon_text(sources);
  bool found = false;
  for (const Error& problem : reading.problems)
    found = found || (problem.place == place && problem.message.find(mistake.expected) != std::string::npos);
  EXPECT_TRUE(found) << "expected at " << place << ": … " << mistake.expected << "\ngot:\n" << all_problems(reading);
}

constexpr const char* kSigns = "signs/health.toml";
constexpr const char* kShapes = "handshapes.toml";
constexpr const char* kPhrases = "phrases.toml";

INSTANTIATE_TEST_SUITE_P(
    All, LexiconMistake,
    ::testing::Values(
        Mistake{"Syntax", kSigns, "region = \"north\"", "region = north", "not TOML"},
        Mistake{"UnclosedString", kSigns, "region = \"north\"", "region = \"north", "not TOML"},
        Mistake{"TwiceTheSameKey", kSigns, "region = \"north\"", "gloss = \"HURT\"", "not TOML"},
        Mistake{"MultiLineString", kSigns, "region = \"north\"", "region = \"\"\"north\"\"\"", "a string on one line"},
        Mistake{"ControlCharacter", kSigns, "definition = \"How it looks.\"", "definition = \"How\\bit looks.\"",
                "definition holds a control character"},
        Mistake{"ControlCharacterInAList", kShapes, "aliases = [\"B\"", "aliases = [\"\\u001B\"",
                "aliases holds a control character"},
        Mistake{"UnknownKey", kSigns, "mouthing = \"hurt\"", "mouthings = \"hurt\"",
                "unknown key \"mouthings\"; expected one of"},
        Mistake{"UnknownPostureKey", kSigns, "at = \"nd_palm\"", "at = \"nd_palm\", colour = 1",
                "unknown key \"colour\""},
        Mistake{"UnknownTable", kSigns, "[[sign]]", "[[sing]]", "unknown key \"sing\""},
        Mistake{"MissingGloss", kSigns, "[[sign]]\ngloss = \"HURT\"", "[[sign]]", "gloss is missing"},
        Mistake{"WrongTypeString", kSigns, "definition = \"How it looks.\"", "definition = 3",
                "is an integer; expected a string"},
        Mistake{"WrongTypeArray", kSigns, "english = [\"hurt:verb\", \"sore:adj:1\"]", "english = \"hurt\"",
                "expected an array of strings"},
        Mistake{"WrongTypeTable", kSigns, "face = { brows = \"furrow\", face = \"pained\" }", "face = true",
                "expected a table"},
        Mistake{"WrongTypeNumber", kSigns, "offset_cm = [-8, 6.5, 0.1]", "offset_cm = [-8, \"6\", 0.1]",
                "an array of 3 numbers"},
        Mistake{"TwoNumbers", kSigns, "offset_cm = [-8, 6.5, 0.1]", "offset_cm = [-8, 6.5]",
                "has 2 elements; expected an array of 3"},
        Mistake{"NotFinite", kSigns, "offset_cm = [-8, 6.5, 0.1]", "offset_cm = [-8, nan, 0.1]", "all finite"},
        Mistake{"FarOffset", kSigns, "offset_cm = [-8, 6.5, 0.1]", "offset_cm = [-800, 6.5, 0.1]", "more than 60 cm"},
        Mistake{"UnknownLocation", kSigns, "at = \"nd_palm\"", "at = \"palm_of_nd\"",
                "\"palm_of_nd\"; expected top_head, forehead"},
        Mistake{"UnknownPart", kSigns, "part = \"index_tip\"", "part = \"index\"", "thumb_web"},
        Mistake{"UnknownDirection", kSigns, "palm = \"toward\", at = \"nd_palm\"",
                "palm = \"towards\", at = \"nd_palm\"", "away or toward"},
        Mistake{"AxisTwice", kSigns, "fingers = \"left-up\"", "fingers = \"left-right\"", "joined by hyphens"},
        Mistake{"PalmAlongFingers", kSigns, "palm = \"toward\", at = \"nd_palm\"",
                "palm = \"right-down\", at = \"nd_palm\"", "faces along fingers"},
        Mistake{"PalmNearlyAlongFingers", kSigns, "palm = \"toward\", at = \"nd_palm\"",
                "palm = \"left\", at = \"nd_palm\"", "faces along fingers"},
        Mistake{"UnknownMove", kSigns, "kind = \"shake\"", "kind = \"shiver\"", "expected hold, straight, arc"},
        Mistake{"PhaseOutOfRange", kSigns, "plane = \"up_down\", from = 0, to = 1",
                "plane = \"up_down\", from = 0, to = 2", "the number of phases"},
        Mistake{"PhasesReversed", kSigns, "plane = \"up_down\", from = 0, to = 1",
                "plane = \"up_down\", from = 1, to = 0", "out of range"},
        Mistake{"NegativePhase", kSigns, "plane = \"up_down\", from = 0, to = 1",
                "plane = \"up_down\", from = -1, to = 1", "expected an integer from 0"},
        Mistake{"NoRepeats", kSigns, "repeats = 3", "repeats = 0", "expected an integer from 1 to 24"},
        Mistake{"PathWithoutDirection", kSigns, "kind = \"straight\", direction = \"left-down\"", "kind = \"straight\"",
                "needs a direction"},
        Mistake{"UnknownFaceWord", kSigns, "brows = \"furrow\"", "brows = \"frown\"",
                "expected raise, raise-slight, furrow"},
        Mistake{"MissingHandshape", kSigns, "shape = \"flat\", fingers = \"left\"",
                "shape = \"flatt\", fingers = \"left\"", "\"flatt\" does not exist"},
        Mistake{"BadKeywordRank", kSigns, "\"sore:adj:1\"", "\"sore:adj:x\"", "expected word:pos:rank"},
        Mistake{"UnknownPartOfSpeech", kSigns, "\"sore:adj:1\"", "\"sore:adjective\"", "unknown part of speech"},
        Mistake{"CapitalKeyword", kSigns, "\"sore:adj:1\"", "\"Sore:adj\"", "expected a lower-case word"},
        Mistake{"UnknownRegion", kSigns, "region = \"north\"", "region = \"utopia\"", "expected all, north"},
        Mistake{"UnknownConfidence", kSigns, "confidence = \"low\"", "confidence = \"sure\"",
                "expected low, medium or high"},
        Mistake{"AngleOutOfRange", kShapes, "middle = [0, 0, 0, 0]", "middle = [0, 0, 200, 0]",
                "an angle is out of range"},
        Mistake{"UnknownBase", kShapes, "hamnosys = \"hamflathand\"", "base = \"round\"", "\"round\" does not exist"},
        Mistake{"UnknownDigit", kShapes, "selected = \"all\"", "selected = \"toe\"", "expected digits joined by +"},
        Mistake{"SpanOutOfRange", kPhrases, "from = 0, to = 1", "from = 0, to = 4", "indexes of glosses"},
        Mistake{"UnknownSpan", kPhrases, "kind = \"wh\"", "kind = \"what\"", "expected topic, yn, wh"},
        Mistake{"UnknownGloss", kPhrases, "glosses = [\"HURT\"", "glosses = [\"HURTS\"", "\"HURTS\" does not exist"},
        Mistake{"UnknownItem", kPhrases, "\"num:10\"", "\"num:ten\"", "expected a GLOSS, fs:TEXT"},
        Mistake{"SlotOnOneSide", kPhrases, "\"{NAME}\", ", "", "must be in both english and glosses"}),
    [](const ::testing::TestParamInfo<Mistake>& mistake) { return std::string(mistake.param.name); });

TEST(LexiconText, AllProblemsAreCollectedInTheOrderOfTheFiles) {
  std::vector<TextSource> sources = sample_sources();
  sources[3].text.replace(sources[3].text.find("north"), 5, "utopia");
  sources[3].text.replace(sources[3].text.find("shake"), 5, "shiver");
  sources[0].text += "colour = 1\n";
  const LexiconReading reading = parse_lexicon_text(sources);
  ASSERT_EQ(reading.problems.size(), 3u) << all_problems(reading);
  EXPECT_EQ(reading.problems[0].place.rfind("handshapes.toml:", 0), 0u);
  EXPECT_NE(reading.problems[1].message.find("region"), std::string::npos);
  EXPECT_NE(reading.problems[2].message.find("shiver"), std::string::npos);
}

TEST(LexiconText, DuplicatesAreToldAtTheSecondOne) {
  std::vector<TextSource> sources = sample_sources();
  const std::string again = sources[3].text;
  const long second = static_cast<long>(std::count(again.begin(), again.end(), '\n')) + 1;
  sources[3].text += again;
  const LexiconReading reading = parse_lexicon_text(sources);
  const std::string all = all_problems(reading);
  EXPECT_NE(all.find("signs/health.toml:" + std::to_string(second + 1) + ": HURT gloss: the gloss is used twice"),
            std::string::npos)
      << all;
  EXPECT_NE(all.find("\"hurt\" is choice 0 of HURT already"), std::string::npos) << all;
}

TEST(LexiconText, HandsMustFitTheHandedness) {
  const auto finding_for = [](const std::string& hands) {
    std::vector<TextSource> sources = sample_sources();
    sources[3].text.replace(sources[3].text.find("dominant+base"), 13, hands);
    return all_problems(parse_lexicon_text(sources));
  };
  EXPECT_NE(finding_for("one").find("a one-handed sign has no base hand"), std::string::npos);
  EXPECT_NE(finding_for("one").find("cannot be placed on the other hand"), std::string::npos);
  EXPECT_NE(finding_for("one").find("moves only the dominant hand"), std::string::npos);
  EXPECT_NE(finding_for("two-symmetric").find("mirror image"), std::string::npos);
  std::vector<TextSource> sources = sample_sources();
  const size_t base = sources[3].text.find("base = [");
  sources[3].text.replace(base, sources[3].text.find("moves") - base, "");
  EXPECT_NE(all_problems(parse_lexicon_text(sources)).find("a base that stays"), std::string::npos);
}

TEST(LexiconText, ReviewNeedsANameAndADate) {
  std::vector<TextSource> sources = sample_sources();
  std::string& text = sources[3].text;
  text.replace(text.find("review = \"unreviewed\""), 21,
               "review = \"reviewed\"\nreviewed_by = \"a reviewer\"\nreviewed_on = \"2026-02-03\"");
  EXPECT_EQ(all_problems(parse_lexicon_text(sources)), "");
  text.replace(text.find("2026-02-03"), 10, "3 February");
  EXPECT_NE(all_problems(parse_lexicon_text(sources)).find("reviewed_on (YYYY-MM-DD)"), std::string::npos);
}

TEST(LexiconText, HostileFilesAreRefusedBeforeTheyAreParsed) {
  const auto problem_of = [](std::string text) {
    const TextSource source{"signs/x.toml", std::move(text)};
    const LexiconReading reading = parse_lexicon_text({&source, 1});
    return reading.problems.empty() ? std::string() : to_string(reading.problems.front());
  };
  std::string dotted = "a";
  for (int i = 0; i < 100; ++i)
    dotted += ".a";
  std::string nested = "a = ";
  for (int i = 0; i < 20; ++i)
    nested += "[\n";
  EXPECT_NE(problem_of(dotted + " = 1").find("dots in a line"), std::string::npos);
  EXPECT_NE(problem_of(nested).find("signs/x.toml:9: brackets nested deeper"), std::string::npos) << problem_of(nested);
  EXPECT_NE(problem_of("a = \"" + std::string(5000, 'x') + "\"").find("a line longer"), std::string::npos);
  EXPECT_NE(problem_of(std::string(kMaxSourceBytes + 1, '\n')).find("larger than"), std::string::npos);
  EXPECT_NE(problem_of(std::string("a = 1\n\0", 7)).find("signs/x.toml:2: a zero byte"), std::string::npos);
  EXPECT_NE(problem_of("a = \"\xff\xfe\"\n").find("not TOML"), std::string::npos);
  EXPECT_NE(problem_of("sign = [1]\n").find("expected an array of tables"), std::string::npos);
}

TEST(LexiconText, AFileThatIsNotOfTheLexiconIsToldSo) {
  const TextSource source{"notes.toml", "a = 1\n"};
  const LexiconReading reading = parse_lexicon_text({&source, 1});
  ASSERT_FALSE(reading.problems.empty());
  EXPECT_NE(reading.problems[0].message.find("signs/CATEGORY.toml"), std::string::npos);
}

TEST(LexiconText, FoldersAreReadAndWrittenWhole) {
  const ScratchFolder folder;
  const LexiconReading reading = parse_lexicon_text(sample_sources());
  ASSERT_TRUE(save_lexicon_text(reading.text, folder.path()));
  const Result<LexiconText> again = read_lexicon_text(folder.path());
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_EQ(as_one_text(*again), as_one_text(reading.text));
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder.path()))
    EXPECT_EQ(file.path().string().find(".tmp"), std::string::npos) << "a temporary file is left over";
}

TEST(LexiconText, AFolderThatIsNotThereOrLacksAFileIsAnError) {
  const ScratchFolder folder;
  const Result<LexiconText> missing = read_lexicon_text(folder / "nowhere");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kNotFound);
  std::filesystem::create_directories(folder / "signs");
  const Result<LexiconText> empty = read_lexicon_text(folder.path());
  ASSERT_FALSE(empty);
  EXPECT_NE(empty.error().place.find("handshapes.toml"), std::string::npos);
}

TEST(LexiconText, TheFirstProblemOfAFolderSaysHowManyMoreThereAre) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder / "signs");
  std::vector<TextSource> sources = sample_sources();
  sources[3].text.replace(sources[3].text.find("north"), 5, "utopia");
  sources[3].text.replace(sources[3].text.find("shake"), 5, "shiver");
  for (const TextSource& source : sources)
    put_bytes(folder / source.name, source.text);
  const Result<LexiconText> text = read_lexicon_text(folder.path());
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().place, (folder / "signs/health.toml:4").string());
  EXPECT_NE(text.error().message.find("and 1 more"), std::string::npos) << text.error().message;
  EXPECT_EQ(check_lexicon_text(folder.path()).size(), 2u);
}

TEST(LexiconText, GlossesAndPhraseItemsHaveOneSpelling) {
  for (const char* good : {"HURT", "THANK-YOU", "A1", "fs:A", "num:0", "num:10"})
    EXPECT_TRUE(is_gloss(good)) << good;
  for (const char* bad :
       {"", "hurt", "-A", "A-", "A--B", "fs:a", "fs:AB", "fs:", "num:", "num:01", "num:x", "{NAME}", "Ä"})
    EXPECT_FALSE(is_gloss(bad)) << bad;
  for (const char* good : {"HURT", "fs:X-RAY", "num:10", "{NAME}", "{TIME}"})
    EXPECT_TRUE(is_phrase_item(good)) << good;
  for (const char* bad : {"", "{name}", "{}", "fs:", "fs:x", "HURT(arm)"})
    EXPECT_FALSE(is_phrase_item(bad)) << bad;
}

}  // namespace
}  // namespace auslan
