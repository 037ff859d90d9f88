// SPDX-License-Identifier: Apache-2.0
// Sentences through the rules alone (no phrases). Each expectation rests on a fact of Auslan grammar, named in the row.
#include "translate_vocabulary.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <ostream>
#include <string>

namespace auslan {
namespace {

const Translator& rules() {
  static const Translator kTranslator = *Translator::build(test::vocabulary());
  return kTranslator;
}

struct Case {
  const char* english;
  const char* expected;
  const char* fact;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.english;
}

class Sentence : public ::testing::TestWithParam<Case> {};

TEST_P(Sentence, FollowsTheFact) {
  const auto result = rules().translate(GetParam().english);
  ASSERT_TRUE(result) << to_string(result.error());
  EXPECT_EQ(test::signed_line(*result), GetParam().expected) << GetParam().fact;
}

const char* const kNoCopula = "no copula (Kadous); articles are not signed";
const char* const kWhLast = "the wh-sign is safe at the end of its clause";
const char* const kNegator = "negation has a manual sign, lexicalised forms first (Johnston 2018)";
const char* const kModal = "modals are kept: must and can are the message";
const char* const kEnglishOrder = "the most frequent order parallels English (Johnston 2019)";
const char* const kTimeFirst = "time adverbials open the clause";
const char* const kSpell = "names and words without a sign are fingerspelled";
const char* const kNumbers = "numbers are never lost; without a sign of their own digit by digit";
const char* const kForms = "inflected forms are signed by their base form";

INSTANTIATE_TEST_SUITE_P(
    Grammar, Sentence,
    ::testing::Values(
        Case{"What is your name?", "YOUR NAME WHAT", kWhLast}, Case{"Where does it hurt?", "HURT WHERE", kWhLast},
        Case{"WHERE DOES IT HURT", "HURT WHERE", kWhLast}, Case{"where\u2019s the toilet", "TOILET WHERE", kWhLast},
        Case{"Why can't you walk?", "CANT YOU WALK WHY", kWhLast},
        Case{"How much water do you drink?", "WATER YOU DRINK HOW-MUCH", kWhLast},
        Case{"What time is it?", "TIME WHAT", "what time keeps its wh-sign; dummy it is not signed"},
        Case{"Hello, my name is Kim.", "HELLO | MY NAME K-I-M", kSpell},
        Case{"My name is Brown.", "MY NAME B-R-O-W-N", "a name is spelled even where the word has a sign"},
        Case{"My name is not Kim.", "MY NAME NOT K-I-M", kNegator},
        Case{"my name is kim where does it hurt", "MY NAME K-I-M HURT WHERE", kWhLast},
        Case{"I see Kim Brown.", "I SEE K-I-M B-R-O-W-N", kSpell},
        Case{"See Dr. Brown.", "SEE DOCTOR B-R-O-W-N", kSpell}, Case{"The toilet is here.", "TOILET HERE", kNoCopula},
        Case{"You're deaf.", "YOU DEAF", kNoCopula}, Case{"I must not eat.", "I MUST NOT EAT", kModal},
        Case{"I can walk.", "I CAN WALK", kModal}, Case{"You mustn't drink", "YOU MUST NOT DRINK", kModal},
        Case{"I can't walk", "I CANT WALK", kNegator}, Case{"I can\u2019t walk", "I CANT WALK", kNegator},
        Case{"I cant walk", "I CANT WALK", kNegator}, Case{"I cannot walk", "I CANT WALK", kNegator},
        Case{"I don't know.", "I DONT-KNOW", kNegator},
        Case{"She doesn't want water.", "HE-SHE-IT NOT-WANT WATER", kNegator},
        Case{"I do not have pain", "I NOT-HAVE PAIN", kNegator}, Case{"Do not eat.", "NOT EAT", kNegator},
        Case{"It doesn't hurt.", "NOT HURT", kNegator},
        Case{"You do not have to wait.", "YOU NOT NEED WAIT", "not having to is no prohibition: never NOT MUST"},
        Case{"You have to wait.", "YOU MUST WAIT", kModal}, Case{"I want water.", "I WANT WATER", kEnglishOrder},
        Case{"Do you want water?", "YOU WANT WATER", kEnglishOrder},
        Case{"I want to eat.", "I WANT EAT", "infinitive to is not signed"},
        Case{"There is a fire.", "FIRE", "existential there is not signed"},
        Case{"The water is there.", "WATER THERE", "there that points is signed"},
        Case{"I see the doctor tomorrow.", "TOMORROW I SEE DOCTOR", kTimeFirst},
        Case{"Not now.", "NOT NOW", "a time word that is negated stays with its negator"},
        Case{"Wait until tomorrow", "WAIT U-N-T-I-L TOMORROW", "a time word after a preposition stays"},
        Case{"I take two tablets.", "I TAKE #2 TABLET", kNumbers},
        Case{"I take 25 tablets.", "I TAKE #2-5 TABLET", kNumbers},
        Case{"two hundred and fifty tablets", "#2-5-0 TABLET", kNumbers}, Case{"call 000", "C-A-L-L #0-0-0", kNumbers},
        Case{"2.5 tablets", "#2-P-O-I-N-T-5 TABLET", "2.5 must never read 25"},
        Case{"1,000 tablets", "#1-0-0-0 TABLET", kNumbers},
        Case{"\u00BD tablet", "#1-S-L-A-S-H-2 TABLET", "a half must never read 12"},
        Case{"\u0663 tablets", "#3 TABLET", "digits of other scripts are digits"},
        Case{"My teeth hurt.", "MY TOOTH HURT", kForms}, Case{"Babies walked", "BABY WALK", kForms},
        Case{"stopping", "STOP", kForms}, Case{"bigger", "MORE BIG", "the degree of an adjective is not lost"},
        Case{"Sitting down", "SIT-DOWN", kForms},
        Case{"Your blood pressure", "YOUR BLOOD-PRESSURE", "multi-word entries come before words"},
        Case{"I left yesterday", "YESTERDAY I GO", "after a pronoun left is the verb"},
        Case{"turn left", "T-U-R-N LEFT", "left as a direction"},
        Case{"I have a cold", "I HAVE COLD-ILLNESS", "after an article cold is the noun"},
        Case{"The water is cold", "WATER COLD-TEMPERATURE", "after a copula cold is the adjective"},
        Case{"B12", "B-1-2", kSpell}, Case{"Zo\u00EB", "Z-O-E", "diacritics are folded"},
        Case{"stra\u00DFe", "S-T-R-A-S-S-E", "diacritics are folded"},
        Case{"K-I-M", "K I M", "letters spelled out stay letters"},
        Case{"ghost", "G-H-O-S-T", "a sign that was rejected is never used"},
        Case{"The", "T-H-E", "a sentence of function words alone is spelled: something was said"},
        Case{"Yes. No, wait!", "YES | NO | WAIT", "pauses at commas and sentence ends"}));

const NonManualSpan* span_of(const Translation& translation, std::string_view kind) {
  const auto found = std::find_if(translation.non_manual.begin(), translation.non_manual.end(),
                                  [&](const NonManualSpan& span) { return span.kind == kind; });
  return found == translation.non_manual.end() ? nullptr : &*found;
}

TEST(NonManuals, WhQuestionFurrowsAndHoldsTheWhSign) {
  const auto result = *rules().translate("What is your name?");
  const NonManualSpan* span = span_of(result, "wh");
  ASSERT_NE(span, nullptr);
  EXPECT_EQ(span->brows, "furrow");
  EXPECT_EQ(span->head, "tilt-forward");
  EXPECT_EQ(span->ending, "hold last sign");
  EXPECT_EQ(result.items[static_cast<size_t>(span->to)].glosses, std::vector<std::string>{"WHAT"});
  EXPECT_EQ(span_of(result, "yn"), nullptr);
}

TEST(NonManuals, YesNoQuestionRaisesTheBrowsWithOrWithoutInversion) {
  for (const char* english : {"Do you need water?", "You need water?", "do you need water"}) {
    const auto result = *rules().translate(english);
    const NonManualSpan* span = span_of(result, "yn");
    ASSERT_NE(span, nullptr) << english;
    EXPECT_EQ(span->brows, "raise");
    EXPECT_EQ(span->ending, "hold last sign");
    EXPECT_EQ(result.items[static_cast<size_t>(span->from)].glosses.front(), "YOU");
    EXPECT_EQ(result.items[static_cast<size_t>(span->to)].glosses.front(), "WATER");
  }
}

TEST(NonManuals, StatementsAndOrdersAreNoQuestions) {
  for (const char* english :
       {"I need water.", "Do not eat.", "Have a drink.", "I know where it hurts.", "When I walk, it hurts."}) {
    const auto result = *rules().translate(english);
    for (const NonManualSpan& span : result.non_manual)
      EXPECT_EQ(span.kind, "neg") << english;
  }
}

TEST(NonManuals, EmbeddedWhStaysInAYesNoQuestion) {
  const auto result = *rules().translate("Do you know where it hurts?");
  EXPECT_NE(span_of(result, "yn"), nullptr);
  EXPECT_EQ(span_of(result, "wh"), nullptr);
  EXPECT_EQ(test::signed_line(result), "YOU KNOW WHERE HURT");
}

TEST(NonManuals, HeadShakesFromTheNegatorToTheEndOfItsClause) {
  const auto result = *rules().translate("I must not eat, but I can drink.");
  const NonManualSpan* span = span_of(result, "neg");
  ASSERT_NE(span, nullptr);
  EXPECT_EQ(span->head, "shake");
  EXPECT_EQ(result.items[static_cast<size_t>(span->from)].glosses.front(), "NOT");
  EXPECT_EQ(result.items[static_cast<size_t>(span->to)].glosses.front(), "EAT");
}

TEST(NonManuals, ConditionRaisesTheBrowsBeforeItsComma) {
  const auto result = *rules().translate("If it hurts, stop.");
  const NonManualSpan* span = span_of(result, "cond");
  ASSERT_NE(span, nullptr);
  EXPECT_EQ(span->brows, "raise");
  EXPECT_EQ(result.items[static_cast<size_t>(span->to)].glosses.front(), "HURT");
}

TEST(Pauses, LastAQuarterSecondAtCommasAndHalfASecondAtSentenceEnds) {
  const auto result = *rules().translate("Yes, wait. Stop.");
  std::vector<double> pauses;
  for (const Item& item : result.items)
    if (item.kind == ItemKind::kPause) pauses.push_back(item.pause_seconds);
  EXPECT_EQ(pauses, (std::vector<double>{0.25, 0.5}));
}

TEST(Senses, TwoKnownSensesAreMarkedAndTheFirstRankIsChosen) {
  const auto result = *rules().translate("right leg");
  EXPECT_EQ(result.items[0].glosses.front(), "RIGHT-CORRECT");
  EXPECT_TRUE(result.items[0].ambiguous);
  EXPECT_EQ(result.items[0].alternatives, std::vector<std::string>{"RIGHT"});
  EXPECT_EQ(result.items[0].confidence, Confidence::kLow);
  EXPECT_FALSE(result.warnings.empty());
}

TEST(Senses, RegionalFormsOfOneSignAreNoAmbiguity) {
  const auto result = *rules().translate("water");
  EXPECT_EQ(result.items[0].glosses.front(), "WATER");
  EXPECT_FALSE(result.items[0].ambiguous);
}

TEST(Negators, AreSpelledWhereTheLexiconHasNoSign) {
  TranslatorData data = test::vocabulary();
  std::erase_if(data.entries, [](const EntryFacts& entry) { return entry.gloss == "NOT" || entry.gloss == "CANT"; });
  const auto translator = Translator::build(std::move(data));
  ASSERT_TRUE(translator);
  EXPECT_EQ(test::signed_line(*translator->translate("I can't walk")), "I CAN N-O-T WALK");
}

TEST(Dropped, WordsStayInTheResultWithTheirRule) {
  const auto result = *rules().translate("Where does the leg hurt?");
  std::vector<std::string> dropped;
  for (const Item& item : result.items)
    if (item.kind == ItemKind::kDropped) dropped.push_back(item.text + " " + item.rules.back());
  EXPECT_EQ(dropped, (std::vector<std::string>{"does drop:do-support", "the drop:article"}));
}

}  // namespace
}  // namespace auslan
