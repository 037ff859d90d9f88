// SPDX-License-Identifier: Apache-2.0
// The symbols of HamNoSys 4: names and code points both ways, after the table of its TeX package.
#include "notation/notation.h"
#include "notation/symbols.h"

#include <gtest/gtest.h>
#include <set>
#include <string>

namespace auslan {
namespace {

std::string utf8(char32_t code) {
  const auto byte = [](char32_t value) { return static_cast<char>(static_cast<unsigned char>(value)); };
  if (code < 0x80) return {byte(code)};
  return {byte(0xE0 | (code >> 12)), byte(0x80 | ((code >> 6) & 0x3F)), byte(0x80 | (code & 0x3F))};
}

TEST(NotationSymbols, EachIsFoundByNameAndByCodePoint) {
  EXPECT_GE(ham_symbols().size(), 205u);
  EXPECT_LE(ham_symbols().size(), 215u);
  std::set<std::string_view> names;
  std::set<char32_t> codes;
  for (const HamSymbol& symbol : ham_symbols()) {
    EXPECT_TRUE(names.insert(symbol.name).second) << symbol.name;
    EXPECT_TRUE(codes.insert(symbol.code).second) << symbol.name;
    EXPECT_TRUE(symbol.name.starts_with("ham")) << symbol.name;
    EXPECT_EQ(find_ham_symbol(symbol.name), &symbol);
    EXPECT_EQ(find_ham_symbol(symbol.code), &symbol) << symbol.name;
  }
}

TEST(NotationSymbols, CodePointsAreTheStandardOnes) {
  const std::pair<char32_t, std::string_view> known[] = {{0xE000, "hamfist"},
                                                         {0xE00B, "hamceeopen"},
                                                         {0xE00E, "hamthumbopenmod"},
                                                         {0xE010, "hamfingerstraightmod"},
                                                         {0xE014, "hamdoublehooked"},
                                                         {0xE020, "hamextfingeru"},
                                                         {0xE02B, "hamextfingeril"},
                                                         {0xE031, "hamextfingeruo"},
                                                         {0xE038, "hampalmu"},
                                                         {0xE03C, "hampalmd"},
                                                         {0xE03F, "hampalmul"},
                                                         {0xE040, "hamhead"},
                                                         {0xE04D, "hamchin"},
                                                         {0xE054, "hambelowstomach"},
                                                         {0xE058, "hamlrbeside"},
                                                         {0xE05F, "hamneutralspace"},
                                                         {0xE060, "hamupperarm"},
                                                         {0xE06A, "hampinkyside"},
                                                         {0xE070, "hamthumb"},
                                                         {0xE07A, "hamfingerside"},
                                                         {0xE080, "hammoveu"},
                                                         {0xE091, "hammoveuo"},
                                                         {0xE092, "hamcircleo"},
                                                         {0xE0A3, "hamcircledi"},
                                                         {0xE0A4, "hamfingerplay"},
                                                         {0xE0AA, "hamreplace"},
                                                         {0xE0AF, "hamnomotion"},
                                                         {0xE0B0, "hamclocku"},
                                                         {0xE0B8, "hamclockfull"},
                                                         {0xE0BC, "hamarcd"},
                                                         {0xE0BE, "hamzigzag"},
                                                         {0xE0C6, "hamsmallmod"},
                                                         {0xE0CC, "hamhalt"},
                                                         {0xE0D0, "hamclose"},
                                                         {0xE0D6, "hambrushing"},
                                                         {0xE0DC, "hamrepeatreverse"},
                                                         {0xE0DD, "hamalternatingmotion"},
                                                         {0xE0E0, "hamseqbegin"},
                                                         {0xE0E7, "hamplus"},
                                                         {0xE0E8, "hamsymmpar"},
                                                         {0xE0E9, "hamsymmlr"},
                                                         {0xE0ED, "hamorirelative"},
                                                         {0xE0F1, "hamversion40"}};
  for (const auto& [code, name] : known) {
    ASSERT_NE(find_ham_symbol(code), nullptr) << name;
    EXPECT_EQ(find_ham_symbol(code)->name, name);
  }
}

TEST(NotationSymbols, SpellingsOfRealFilesAreKnown) {
  const std::pair<std::string_view, std::string_view> spellings[] = {
      {"hampinchopen", "hampinch12open"}, {"hamcee12open", "hamceeopen"}, {"hamfingerhookedmod", "hamfingerhookmod"},
      {"hamclockplus", "hamclockfull"},   {"hamsympar", "hamsymmpar"},    {"hamsymlr", "hamsymmlr"}};
  for (const auto& [spelling, meant] : spellings) {
    ASSERT_NE(find_ham_symbol(spelling), nullptr) << spelling;
    EXPECT_EQ(find_ham_symbol(spelling), find_ham_symbol(meant));
  }
  EXPECT_EQ(find_ham_symbol("hamnosuchthing"), nullptr);
  EXPECT_EQ(find_ham_symbol(""), nullptr);
  EXPECT_EQ(find_ham_symbol(char32_t{0xE0FF}), nullptr);
}

// Names and code points of one sign must mean the same sign.
TEST(NotationSymbols, CodePointsAndNamesReadAlike) {
  const std::string_view names[] = {"hamsymmlr",   "hamflathand",       "hamthumboutmod", "hamextfingerul",
                                    "hampalmdl",   "hamshoulders",      "hamclose",       "hammovedo",
                                    "hamsmallmod", "hamrepeatfromstart"};
  std::string by_name, by_code;
  for (const std::string_view name : names) {
    by_name += std::string(by_name.empty() ? "" : ",") + std::string(name);
    by_code += utf8(find_ham_symbol(name)->code);
  }
  const auto a = parse_hamnosys(by_name), b = parse_hamnosys(by_code);
  ASSERT_TRUE(a);
  ASSERT_TRUE(b);
  ASSERT_TRUE(a->signable);
  ASSERT_EQ(a->sign.dominant.size(), 2u);
  ASSERT_EQ(b->sign.dominant.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(a->sign.dominant[i].handshape, b->sign.dominant[i].handshape);
    EXPECT_EQ(a->sign.dominant[i].fingers, b->sign.dominant[i].fingers);
    EXPECT_EQ(a->sign.dominant[i].palm, b->sign.dominant[i].palm);
    EXPECT_EQ(a->sign.dominant[i].offset, b->sign.dominant[i].offset);
  }
}

// No symbol is unknown to the parser: each, alone in the middle of a sign, is carried or told.
TEST(NotationSymbols, NoSymbolBreaksASign) {
  for (const HamSymbol& symbol : ham_symbols()) {
    if (symbol.code < 0x80) continue;
    const std::string text = "hamflathand,hamextfingeru,hampalml,hamchest," + std::string(symbol.name) + ",hammoveo";
    const auto sign = parse_hamnosys(text);
    ASSERT_TRUE(sign) << symbol.name;
    EXPECT_TRUE(sign->signable) << symbol.name;
    for (const Diagnostic& diagnostic : sign->diagnostics)
      EXPECT_EQ(diagnostic.message.find("not known and is left out"), std::string::npos) << diagnostic.message;
  }
}

}  // namespace
}  // namespace auslan
