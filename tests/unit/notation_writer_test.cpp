// SPDX-License-Identifier: Apache-2.0
// What is read is written again without loss: as it was written, in the other kind of notation where that can say the
// same, and in the lexicon's own text and database.
#include "corpora.h"
#include "lexicon/lexicon.h"
#include "lexicon/lexicon_text.h"
#include "notation/symbols.h"
#include "notation/writer.h"
#include "scratch_folder.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>

namespace auslan {
namespace {

using testing::corpora;
using testing::sigml_files;

/// Equal in everything but the places of diagnostics.
void expect_same(const NotatedSign& a, const NotatedSign& b, const std::string& where) {
  EXPECT_TRUE(a.written == b.written) << where << ": the written form";
  EXPECT_TRUE(a.sign == b.sign) << where << ": the sign";
  EXPECT_TRUE(a.handshapes == b.handshapes) << where << ": the handshapes";
  EXPECT_EQ(a.signable, b.signable) << where;
  ASSERT_EQ(a.diagnostics.size(), b.diagnostics.size()) << where;
  for (size_t i = 0; i < a.diagnostics.size(); ++i)
    EXPECT_EQ(a.diagnostics[i].message, b.diagnostics[i].message) << where;
}

std::vector<NotatedSign> parsed(const std::string& text) {
  auto signs = parse_sigml(text, "test");
  EXPECT_TRUE(signs) << (signs ? "" : to_string(signs.error()));
  return signs ? std::move(*signs) : std::vector<NotatedSign>{};
}

void expect_round_trip(const std::vector<NotatedSign>& signs, const std::string& where) {
  const std::string written = write_sigml(signs);
  const std::vector<NotatedSign> again = parsed(written);
  ASSERT_EQ(again.size(), signs.size()) << where;
  for (size_t i = 0; i < signs.size(); ++i)
    expect_same(signs[i], again[i], where + " " + signs[i].sign.gloss);
  EXPECT_EQ(write_sigml(again), written) << where;
}

class NotationWriterCorpus : public ::testing::TestWithParam<const char*> {};

TEST_P(NotationWriterCorpus, EveryFileIsWrittenWithoutLoss) {
  const auto files = sigml_files(GetParam());
  if (files.empty()) GTEST_SKIP() << "the sample " << GetParam() << " is not beside this checkout (../shared/corpora)";
  for (const auto& file : files) {
    const auto signs = read_sigml(file);
    ASSERT_TRUE(signs) << to_string(signs.error());
    expect_round_trip(*signs, file.filename().string());
  }
}

TEST_P(NotationWriterCorpus, AlmostAllAreTheSameSignInTheOtherNotation) {
  const auto files = sigml_files(GetParam());
  if (files.empty()) GTEST_SKIP() << "the sample " << GetParam() << " is not beside this checkout (../shared/corpora)";
  int signs = 0, same = 0, strings = 0;
  for (const auto& file : files) {
    const auto read = read_sigml(file);
    ASSERT_TRUE(read);
    for (const NotatedSign& sign : *read) {
      const std::string where = file.filename().string() + " " + sign.sign.gloss;
      ++signs;
      const bool symbols = form_of(sign.written) == NotationForm::kSymbols;
      const auto other = convert(sign, symbols ? NotationForm::kGestural : NotationForm::kSymbols);
      ASSERT_TRUE(other) << where;
      same += other->same_sign;
      EXPECT_TRUE(other->same_sign || !other->findings.empty()) << where << ": a difference that is not told";
      // What was written is what is read again, and there is a way back.
      expect_round_trip({other->sign}, where + " converted");
      if (other->same_sign) {
        const auto back = convert(other->sign, symbols ? NotationForm::kSymbols : NotationForm::kGestural);
        ASSERT_TRUE(back) << where;
        EXPECT_TRUE(back->same_sign) << where;
      }
      // The symbols as a string sign the same manual part.
      const NotatedSign& in_symbols = symbols ? sign : other->sign;
      const auto string = write_hamnosys(in_symbols);
      if (!string || string->empty()) continue;
      ++strings;
      const auto from_string = parse_hamnosys(*string);
      ASSERT_TRUE(from_string) << where << " " << to_string(from_string.error());
      EXPECT_TRUE(from_string->sign.dominant == in_symbols.sign.dominant) << where;
      EXPECT_TRUE(from_string->sign.movements == in_symbols.sign.movements) << where;
      const auto string_again = write_hamnosys(*from_string);
      ASSERT_TRUE(string_again) << where;
      EXPECT_EQ(*string_again, *string) << where;
    }
  }
  std::cout << GetParam() << ": " << same << " of " << signs << " signs are the same in the other notation; " << strings
            << " strings\n";
  EXPECT_GE(same * 10, signs * 9);
}

TEST_P(NotationWriterCorpus, TheLexiconHoldsWhatWasRead) {
  const auto files = sigml_files(GetParam());
  if (files.empty()) GTEST_SKIP() << "the sample " << GetParam() << " is not beside this checkout (../shared/corpora)";
  LexiconText text;
  std::map<std::string, std::string> ids;
  for (const auto& file : files) {
    const auto read = read_sigml(file);
    ASSERT_TRUE(read);
    for (const NotatedSign& notated : *read) {
      if (!notated.signable) continue;
      // Names as the lexicon wants them; everything else stays.
      for (Handshape shape : notated.handshapes) {
        const auto [known, fresh] = ids.emplace(shape.id, "shape-" + std::to_string(ids.size()));
        if (!fresh) continue;
        shape.id = shape.base = known->second;
        shape.provenance.sources = {"memory"};
        text.handshapes.push_back(shape);
      }
      Sign sign = notated.sign;
      sign.gloss = "N-" + std::to_string(text.signs.size());
      sign.definition = "As read.";
      sign.provenance.sources = {"memory"};
      for (auto* postures : {&sign.dominant, &sign.non_dominant})
        for (Posture& posture : *postures)
          posture.handshape = ids[posture.handshape];
      text.keywords.push_back({"word" + std::to_string(text.signs.size()), "noun", sign.gloss, 0});
      text.signs.push_back(std::move(sign));
    }
  }
  const LexiconReading reading = parse_lexicon_text(write_lexicon_text(text));
  for (size_t i = 0; i < reading.problems.size() && i < 5; ++i)
    ADD_FAILURE() << to_string(reading.problems[i]);
  ASSERT_TRUE(reading.problems.empty()) << reading.problems.size() << " problems";
  ASSERT_EQ(reading.text.signs.size(), text.signs.size());
  EXPECT_TRUE(reading.text.handshapes == text.handshapes);
  for (size_t i = 0; i < text.signs.size(); ++i)
    EXPECT_TRUE(reading.text.signs[i] == text.signs[i]) << text.signs[i].gloss << " as text";
  ScratchFolder folder;
  const auto built = build_database(text, folder / "lexicon.sqlite");
  ASSERT_TRUE(built) << to_string(built.error());
  auto lexicon = Lexicon::open(folder / "lexicon.sqlite");
  ASSERT_TRUE(lexicon) << to_string(lexicon.error());
  const auto all = lexicon->read_all();
  ASSERT_TRUE(all) << to_string(all.error());
  for (size_t i = 0; i < text.signs.size(); ++i)
    EXPECT_TRUE(all->signs[i] == text.signs[i]) << text.signs[i].gloss << " in the database";
}

INSTANTIATE_TEST_SUITE_P(Samples, NotationWriterCorpus, ::testing::Values("ngt", "isl", "bsl"),
                         [](const auto& sample) { return std::string(sample.param); });

TEST(NotationWriter, WhatNobodyUnderstandsIsKept) {
  expect_round_trip(parsed("<sigml><hns_sign gloss=\"A &amp; B &lt;'x'&gt; \xC3\xA4\" made-up=\"1&#10;2\">"
                           "<wish kind='\"quoted\"'>text <!-- gone --> goes <b/>on &lt;here&gt;</wish>"
                           "<hamnosys_manual><hamflathand colour=\"red\"/><hamnever/><hamextfingeru/><hampalml/>"
                           "</hamnosys_manual></hns_sign><signing_ref uri=\"x\"/></sigml>"),
                    "unknown parts");
  const auto signs = parsed("<hns_sign gloss=\"x\" a=\"1 &amp; 2\"><hamnosys_manual/></hns_sign>");
  ASSERT_EQ(signs.size(), 1u);
  EXPECT_EQ(signs[0].written.attribute("a"), "1 & 2");
}

TEST(NotationWriter, EverySymbolIsWrittenAsItsCodePointAndAsItsElement) {
  for (const HamSymbol& symbol : ham_symbols()) {
    const auto read = parse_hamnosys(symbol.name);
    ASSERT_TRUE(read) << symbol.name;
    const auto string = write_hamnosys(*read);
    ASSERT_TRUE(string) << symbol.name;
    const auto again = parse_hamnosys(*string);
    ASSERT_TRUE(again) << symbol.name;
    expect_same(*read, *again, std::string(symbol.name));
    expect_round_trip({*read}, std::string(symbol.name));
  }
}

TEST(NotationWriter, SymbolsAndAttributesSayTheSame) {
  const auto sign = parse_hamnosys(
      "hamsymmlr,hamfinger2,hamthumbacrossmod,hamextfingerul,hambetween,hamextfingeru,hampalmdl,hamlrat,hamchest,"
      "hamtouch,hamparbegin,hammoved,hamsmallmod,hamarcr,hamreplace,hamflathand,hamparend,hamrepeatfromstartseveral");
  ASSERT_TRUE(sign);
  const auto gestural = convert(*sign, NotationForm::kGestural);
  ASSERT_TRUE(gestural);
  EXPECT_TRUE(gestural->same_sign);
  const std::string text = write_sigml(std::span(&gestural->sign, 1));
  for (const char* part :
       {"both_hands=\"true\" lr_symm=\"true\"", "handshape=\"finger2\" thumbpos=\"across\"",
        "extfidir=\"ul\" second_extfidir=\"u\"", "palmor=\"dl\"",
        "location=\"chest\" side=\"left_at\" contact=\"touch\"", "<rpt_motion repetition=\"fromstart_several\">",
        "<directedmotion direction=\"d\" curve=\"r\" size=\"small\"/>", "<changeposture/>"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(NotationWriter, WhatTheOtherNotationCannotSayIsTold) {
  const auto signs = parsed(
      "<sigml><hamgestural_sign gloss=\"X\"><sign_manual><handconfig handshape=\"flat\" extfidir=\"uol\" palmor=\"d\"/>"
      "<directedmotion direction=\"o\" speed=\"0.5\"/></sign_manual></hamgestural_sign></sigml>");
  ASSERT_EQ(signs.size(), 1u);
  const auto symbols = convert(signs[0], NotationForm::kSymbols);
  ASSERT_TRUE(symbols);
  EXPECT_FALSE(symbols->same_sign);
  const auto tells = [&](const std::string& what) {
    return std::any_of(symbols->findings.begin(), symbols->findings.end(),
                       [&](const Diagnostic& d) { return d.left_out && d.message.find(what) != std::string::npos; });
  };
  EXPECT_TRUE(tells("\"uol\"")) << "a corner has no symbol";
  EXPECT_TRUE(tells("a speed in numbers"));
  const auto reference = parsed("<sigml><signing_ref uri=\"x\"/></sigml>");
  ASSERT_EQ(reference.size(), 1u);
  const auto refused = convert(reference[0], NotationForm::kSymbols);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kUnsupported);
}

}  // namespace
}  // namespace auslan
