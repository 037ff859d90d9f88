// SPDX-License-Identifier: Apache-2.0
// What is told, where, and with which grade; and texts that are made to break a reader.
#include "notation/notation.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace auslan {
namespace {

using Grade = Diagnostic::Grade;

std::string hns(const std::string& symbols, const std::string& gloss = "X") {
  return "<sigml>\n<hns_sign gloss=\"" + gloss + "\">\n<hamnosys_manual>\n" + symbols +
         "\n</hamnosys_manual>\n</hns_sign>\n</sigml>\n";
}
const std::string kFlat = "<hamflathand/><hamextfingeru/><hampalml/>";

const Diagnostic* find(const NotatedSign& sign, const std::string& part) {
  const auto found = std::find_if(sign.diagnostics.begin(), sign.diagnostics.end(),
                                  [&part](const Diagnostic& d) { return d.message.find(part) != std::string::npos; });
  return found == sign.diagnostics.end() ? nullptr : &*found;
}

ErrorCode code_of(const std::string& text) {
  const auto signs = parse_sigml(text, "hostile");
  EXPECT_FALSE(signs);
  return signs ? ErrorCode::kUsage : signs.error().code;
}

TEST(NotationDiagnostics, UnknownSymbolIsAWarningWithItsPlace) {
  const auto signs = parse_sigml(hns(kFlat + "\n  <hamsurprise/>"), "f");
  ASSERT_TRUE(signs);
  ASSERT_EQ(signs->size(), 1u);
  EXPECT_TRUE(signs->front().signable);
  const Diagnostic* told = find(signs->front(), "hamsurprise");
  ASSERT_NE(told, nullptr);
  EXPECT_EQ(told->grade, Grade::kWarning);
  EXPECT_EQ(told->line, 5);
  EXPECT_EQ(told->column, 3);
  EXPECT_EQ(to_string(*told).substr(0, 13), "5:3: warning:");
}

TEST(NotationDiagnostics, UnknownElementsAttributesAndValuesAreTold) {
  const auto signs = parse_sigml(
      "<sigml>\n<hamgestural_sign gloss=\"X\">\n<sign_manual>\n<handconfig handshape=\"flat\" extfidir=\"u\" "
      "palmor=\"l\" "
      "glitter=\"9\"/>\n<handconfig thumbpos=\"sideways\" mainbend=\"wobbly\"/>\n<levitation/>\n<directedmotion "
      "direction=\"q\"/>\n<location_bodyarm location=\"chin\"/>\n</sign_manual></hamgestural_sign>\n</sigml>",
      "f");
  ASSERT_TRUE(signs);
  const NotatedSign& sign = signs->front();
  EXPECT_TRUE(sign.signable);
  const std::pair<const char*, int> told[] = {{"glitter", 4},    {"sideways", 5}, {"wobbly", 5},
                                              {"levitation", 6}, {"\"q\"", 7},    {"after the first", 8}};
  for (const auto& [what, line] : told) {
    const Diagnostic* diagnostic = find(sign, what);
    ASSERT_NE(diagnostic, nullptr) << what;
    EXPECT_EQ(diagnostic->line, line) << what;
    EXPECT_EQ(diagnostic->grade, Grade::kWarning) << what;
  }
}

TEST(NotationDiagnostics, NothingToSignIsAnError) {
  const std::string none[] = {hns(""),
                              "<sigml><hns_sign gloss='X'/></sigml>",
                              "<sigml><hamgestural_sign gloss='X'><sign_manual/></hamgestural_sign></sigml>",
                              hns("<hamextfingeru/><hampalml/>"),
                              hns("<hammoveu/>"),
                              "<sigml><animdata_sign/></sigml>"};
  for (const std::string& text : none) {
    const auto signs = parse_sigml(text, "f");
    ASSERT_TRUE(signs) << text;
    ASSERT_EQ(signs->size(), 1u) << text;
    const NotatedSign& sign = signs->front();
    EXPECT_FALSE(sign.signable) << text;
    EXPECT_TRUE(sign.sign.dominant.empty()) << text;
    EXPECT_TRUE(std::any_of(sign.diagnostics.begin(), sign.diagnostics.end(), [](const Diagnostic& d) {
      return d.grade == Grade::kError;
    })) << text;
  }
  EXPECT_EQ(code_of("<sigml/>"), ErrorCode::kMalformed);
  EXPECT_EQ(code_of(""), ErrorCode::kMalformed);
  EXPECT_EQ(code_of("hello"), ErrorCode::kMalformed);
}

TEST(NotationDiagnostics, OneBadSignLeavesTheOthersAlone) {
  const auto signs = parse_sigml("<sigml><hns_sign gloss='A'><hamnosys_manual>" + kFlat +
                                     "</hamnosys_manual></hns_sign><hns_sign gloss='B'/><hns_sign gloss='C'>"
                                     "<hamnosys_manual>" +
                                     kFlat + "</hamnosys_manual></hns_sign></sigml>",
                                 "f");
  ASSERT_TRUE(signs);
  ASSERT_EQ(signs->size(), 3u);
  EXPECT_TRUE((*signs)[0].signable);
  EXPECT_FALSE((*signs)[1].signable);
  EXPECT_TRUE((*signs)[2].signable);
  EXPECT_EQ((*signs)[2].sign.gloss, "C");
}

TEST(NotationHostile, EntitiesAreRefused) {
  EXPECT_EQ(code_of("<!DOCTYPE sigml [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]><sigml>&b;</sigml>"),
            ErrorCode::kMalformed);
  EXPECT_EQ(code_of("<sigml>&lol;</sigml>"), ErrorCode::kMalformed);
  EXPECT_EQ(code_of("<sigml><hns_sign gloss='&x;'/></sigml>"), ErrorCode::kMalformed);
  EXPECT_EQ(code_of("<!DOCTYPE x SYSTEM 'file:///etc/hostname' [ ]><sigml/>"), ErrorCode::kMalformed);
  const auto plain = parse_sigml("<!DOCTYPE sigml SYSTEM 'x.dtd'>\n" + hns(kFlat, "A&amp;B"), "f");
  ASSERT_TRUE(plain) << "a plain document type is what older tools write";
  EXPECT_EQ(plain->front().sign.gloss, "A&B");
}

TEST(NotationHostile, LimitsAreKept) {
  std::string deep;
  for (int i = 0; i < 100000; ++i)
    deep += "<a>";
  EXPECT_EQ(code_of("<sigml>" + deep), ErrorCode::kLimit);
  std::string nested = "<sigml><hamgestural_sign><sign_manual>", closing;
  for (int i = 0; i < kMaxSigmlDepth; ++i) {
    nested += "<seq_motion>";
    closing += "</seq_motion>";
  }
  EXPECT_EQ(code_of(nested + closing + "</sign_manual></hamgestural_sign></sigml>"), ErrorCode::kLimit);
  EXPECT_EQ(code_of(hns(kFlat, std::string(2 << 20, 'x'))), ErrorCode::kLimit);
  EXPECT_EQ(code_of("<sigml>" + std::string(kMaxSigmlBytes, ' ') + "</sigml>"), ErrorCode::kLimit);
  std::string attributes;
  for (int i = 0; i < 1000; ++i)
    attributes += " a" + std::to_string(i) + "='1'";
  EXPECT_EQ(code_of("<sigml" + attributes + "/>"), ErrorCode::kLimit);
}

TEST(NotationHostile, ThePlaceIsNamed) {
  const std::pair<std::string, std::string> broken[] = {{"<sigml>\n  \xC3\x28</sigml>", "f:2:3"},
                                                        {"<sigml>\n\n<hns_sign></sigml>", "f:3:"},
                                                        {std::string("<sigml>\n\0</sigml>", 18), "f:2:1"},
                                                        {"<sigml>\n<hns_sign gloss='a", "f:2:17"},
                                                        {"\xFF\xFE<", "f:1:1"}};
  for (const auto& [text, at] : broken) {
    const auto signs = parse_sigml(text, "f");
    ASSERT_FALSE(signs) << at;
    EXPECT_EQ(signs.error().code, ErrorCode::kMalformed) << at;
    EXPECT_EQ(signs.error().place.substr(0, at.size()), at) << to_string(signs.error());
  }
}

TEST(NotationHostile, EveryTruncationIsRefused) {
  const std::string whole = hns(kFlat + "<!-- note --><hamchest/><hammoveu/>");
  const size_t end = whole.rfind('>');
  ASSERT_TRUE(parse_sigml(whole.substr(0, end + 1), "f"));
  for (size_t length = 0; length <= end; ++length)
    EXPECT_FALSE(parse_sigml(whole.substr(0, length), "f")) << length;
}

TEST(NotationHostile, RepetitionsOfRepetitionsStayBounded) {
  std::string open, close;
  for (int i = 0; i < 40; ++i) {
    open += "<rpt_motion repetition='continue_several'>";
    close += "</rpt_motion>";
  }
  const auto signs =
      parse_sigml("<sigml><hamgestural_sign><sign_manual><handconfig handshape='flat' extfidir='u' palmor='l'/>" +
                      open + "<directedmotion direction='u'/>" + close + "</sign_manual></hamgestural_sign></sigml>",
                  "f");
  ASSERT_TRUE(signs);
  EXPECT_TRUE(signs->front().signable);
  EXPECT_LE(signs->front().sign.dominant.size(), 100u);
  EXPECT_NE(find(signs->front(), "left out"), nullptr);
  std::string symbols = "hamflathand,hamextfingeru,hampalml,hammoveu";
  for (int i = 0; i < 500; ++i)
    symbols += ",hamrepeatcontinueseveral";
  const auto string = parse_hamnosys(symbols);
  ASSERT_TRUE(string);
  EXPECT_LE(string->sign.dominant.size(), 100u);
  std::string brackets = "hamflathand,hamextfingeru,hampalml";
  for (int i = 0; i < 900; ++i)
    brackets += ",hamparbegin";
  const auto open_brackets = parse_hamnosys(brackets + ",hammoveu");
  ASSERT_TRUE(open_brackets);
  EXPECT_LE(open_brackets->diagnostics.size(), 410u);
}

TEST(NotationHostile, Strings) {
  EXPECT_EQ(parse_hamnosys("").error().code, ErrorCode::kMalformed);
  EXPECT_EQ(parse_hamnosys(" , ").error().code, ErrorCode::kMalformed);
  EXPECT_EQ(parse_hamnosys("\xEE\x80").error().code, ErrorCode::kMalformed);
  EXPECT_EQ(parse_hamnosys("\xED\xA0\x80").error().code, ErrorCode::kMalformed) << "a surrogate is not UTF-8";
  EXPECT_EQ(parse_hamnosys("nonsense").error().code, ErrorCode::kMalformed);
  EXPECT_EQ(parse_hamnosys(std::string(kMaxHamnosysBytes + 1, ',')).error().code, ErrorCode::kLimit);
  const auto odd = parse_hamnosys("hamflathand,hamextfingeru,hampalml,hamsurprise");
  ASSERT_TRUE(odd);
  ASSERT_NE(find(*odd, "hamsurprise"), nullptr);
  EXPECT_EQ(find(*odd, "hamsurprise")->column, 36);
}

TEST(NotationFiles, MissingAndOddFiles) {
  const std::filesystem::path folder = ::testing::TempDir();
  EXPECT_EQ(read_sigml(folder / "there-is-no-such.sigml").error().code, ErrorCode::kNotFound);
  EXPECT_EQ(read_sigml(folder).error().code, ErrorCode::kUnreadable);
  const std::filesystem::path path = folder / "notation_diagnostics.sigml";
  std::ofstream(path) << "\xEF\xBB\xBF<?xml version=\"1.0\"?>\r\n" << hns(kFlat);
  const auto signs = read_sigml(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(signs) << to_string(signs.error());
  EXPECT_TRUE(signs->front().signable);
}

}  // namespace
}  // namespace auslan
