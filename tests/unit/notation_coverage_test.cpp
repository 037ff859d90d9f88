// SPDX-License-Identifier: Apache-2.0
// Every tag, element and attribute value of 3,059 real files, as a table beside the checkout ranks them, is known to
// the readers: alone in an otherwise plain sign it is not left out.
#include "corpora.h"
#include "notation/notation.h"
#include "notation/symbols.h"

#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <sstream>

namespace auslan {
namespace {

/// The second column of the table under a heading.
std::vector<std::string> column(const std::string& heading) {
  std::ifstream file(testing::corpora() / "coverage.md");
  std::vector<std::string> rows;
  std::string line;
  bool inside = false;
  while (std::getline(file, line)) {
    if (line.starts_with("## ")) inside = line.starts_with("## " + heading);
    if (!inside || !line.starts_with("| ") || line.starts_with("| #")) continue;
    std::istringstream cells(line);
    std::string cell;
    std::getline(cells, cell, '|');
    std::getline(cells, cell, '|');
    std::getline(cells, cell, '|');
    std::string value;
    for (const char c : cell)
      if (c != ' ' && c != '`') value += c;
    rows.push_back(value);
  }
  return rows;
}

/// What of it is left out, or why it cannot be read; empty when nothing is.
std::string complaint(const std::string& sigml) {
  const auto signs = parse_sigml(sigml, "coverage");
  if (!signs) return to_string(signs.error());
  for (const NotatedSign& sign : *signs)
    for (const Diagnostic& diagnostic : sign.diagnostics)
      if (diagnostic.left_out || diagnostic.grade == Diagnostic::Grade::kError) return to_string(diagnostic);
  return {};
}

std::string wrapped(const std::string& manual, const std::string& faces = "") {
  return "<sigml><hamgestural_sign gloss=\"X\">" +
         (faces.empty() ? "" : "<sign_nonmanual>" + faces + "</sign_nonmanual>") +
         "<sign_manual><handconfig handshape=\"flat\" extfidir=\"u\" palmor=\"d\"/>" + manual +
         "</sign_manual></hamgestural_sign></sigml>";
}

/// A plain sign with this element in its place; empty where it has no place of its own.
std::string sign_with(const std::string& element, const std::string& attributes) {
  const std::string one = "<" + element + " " + attributes + "/>";
  const std::string path = attributes.find(" direction=") == std::string::npos && attributes.find("direction=") != 0
                               ? "direction=\"o\" " + attributes
                               : attributes;
  if (element == "directedmotion") return wrapped("<directedmotion " + path + "/>");
  if (element == "circularmotion")
    return wrapped("<circularmotion " + (attributes.starts_with("axis=") ? "" : std::string("axis=\"o\" ")) +
                   attributes + "/>");
  if (element == "wristmotion")
    return wrapped("<wristmotion " + (attributes.starts_with("motion=") ? "" : std::string("motion=\"nodding\" ")) +
                   attributes + "/>");
  if (element == "rpt_motion")
    return wrapped("<rpt_motion " +
                   (attributes.starts_with("repetition=") ? "" : std::string("repetition=\"fromstart\" ")) +
                   attributes + "><directedmotion direction=\"o\"/></rpt_motion>");
  if (element == "tgt_motion") return wrapped("<tgt_motion " + attributes + "><changeposture/></tgt_motion>");
  if (element == "par_motion" || element == "seq_motion" || element == "split_motion")
    return wrapped("<" + element + " " + attributes + "><directedmotion direction=\"o\"/><nomotion/></" + element +
                   ">");
  if (element == "location_hand") {
    const bool place = attributes.starts_with("location=") || attributes.starts_with("digits=");
    return wrapped("<location_bodyarm location=\"chin\" contact=\"touch\"><location_hand " +
                   (place ? "" : std::string("location=\"tip\" digits=\"2\" ")) + attributes + "/></location_bodyarm>");
  }
  if (element == "location_bodyarm") {
    const bool place = attributes.starts_with("location=");
    return wrapped("<location_bodyarm " + (place ? "" : std::string("location=\"chest\" ")) + attributes + "/>");
  }
  if (element == "split_location")
    return wrapped(
        "<split_location><location_bodyarm location=\"chest\"/><location_bodyarm location=\"chin\"/>"
        "</split_location>");
  if (element == "split_handconfig")
    return wrapped(
        "<split_handconfig><handconfig handshape=\"fist\"/><handconfig handshape=\"flat\"/></split_handconfig>");
  if (element == "handconfig") {
    // The second half of a pair needs its first.
    std::string first;
    if (attributes.starts_with("second_extfidir")) first = "extfidir=\"u\" ";
    if (attributes.starts_with("second_palmor")) first = "palmor=\"d\" ";
    return wrapped("<handconfig " + first + attributes + "/>");
  }
  for (const char* motion : {"changeposture", "nomotion", "no_motion", "fingerplay", "handconstellation"})
    if (element == motion) return wrapped(one);
  if (element == "sign_manual")
    return "<sigml><hamgestural_sign gloss=\"X\"><sign_manual " + attributes +
           "><handconfig handshape=\"flat\" extfidir=\"u\" palmor=\"d\"/></sign_manual></hamgestural_sign></sigml>";
  const auto movement = [&](const std::string& usual) {
    const bool says = attributes.starts_with("movement=") || attributes.starts_with("direction=");
    return "<" + element + " " + (says ? "" : "movement=\"" + usual + "\" ") + attributes + "/>";
  };
  if (element == "head_movement") return wrapped("", "<head_tier>" + movement("NO") + "</head_tier>");
  if (element == "body_movement") return wrapped("", "<body_tier>" + movement("TF") + "</body_tier>");
  if (element == "shoulder_movement") return wrapped("", "<shoulder_tier>" + movement("UB") + "</shoulder_tier>");
  if (element == "eye_gaze") return wrapped("", "<eyegaze_tier>" + movement("DN") + "</eyegaze_tier>");
  if (element == "eye_brows") return wrapped("", "<facialexpr_tier>" + movement("RB") + "</facialexpr_tier>");
  if (element == "eye_lids") return wrapped("", "<facialexpr_tier>" + movement("WB") + "</facialexpr_tier>");
  if (element == "mouth_gesture") return wrapped("", "<mouthing_tier>" + movement("L04") + "</mouthing_tier>");
  if (element == "mouth_picture") return wrapped("", "<mouthing_tier><mouth_picture picture=\"a\"/></mouthing_tier>");
  if (element.ends_with("_tier")) return wrapped("", one);
  if (element.ends_with("_par")) return wrapped("", "<head_tier>" + one + "</head_tier>");
  if (element == "sign_nonmanual" || element == "hamgestural_sign" || element == "sigml")
    return wrapped("", "<head_tier/>");
  return {};
}

class NotationCoverage : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(testing::corpora() / "coverage.md"))
      GTEST_SKIP() << "the statistics of real files are not beside this checkout (../shared/corpora/coverage.md)";
  }
};

TEST_F(NotationCoverage, EveryTagOfHamNoSysSigmlIsKnown) {
  int symbols = 0;
  for (const std::string& tag : column("H-SiGML tags")) {
    if (tag.starts_with("ham") && !tag.starts_with("hamnosys") && tag != "hamgestural_sign") {
      EXPECT_NE(find_ham_symbol(tag), nullptr) << tag;
      ++symbols;
    } else if (tag.starts_with("hnm_")) {
      const std::string value = tag == "hnm_mouthpicture" ? "picture=\"a\""
                                : tag == "hnm_eyebrows"   ? "tag=\"RB\""
                                : tag == "hnm_eyelids"    ? "tag=\"WB\""
                                : tag == "hnm_nose"       ? "tag=\"WR\""
                                : tag == "hnm_body"       ? "tag=\"TF\""
                                : tag == "hnm_shoulder"   ? "tag=\"UB\""
                                : tag == "hnm_eyegaze"    ? "tag=\"DN\""
                                                          : "tag=\"NO\"";
      EXPECT_EQ(complaint("<sigml><hns_sign gloss=\"X\"><hamnosys_nonmanual><" + tag + " " + value +
                          "/></hamnosys_nonmanual><hamnosys_manual><hamflathand/><hamextfingeru/><hampalml/>"
                          "</hamnosys_manual></hns_sign></sigml>"),
                "")
          << tag;
    }
  }
  EXPECT_GE(symbols, 150) << "the table was not found in the statistics";
  for (const char* misspelt : {"hamfingerhookmod", "hampinchopen", "hamceeopen", "hamcee12open", "hamfingerhookedmod"})
    EXPECT_NE(find_ham_symbol(misspelt), nullptr) << misspelt;
}

TEST_F(NotationCoverage, EveryElementAndAttributeValueIsSigned) {
  int values = 0;
  for (const char* heading : {"G-SiGML elements", "G-SiGML attribute=value", "Unified view"}) {
    for (const std::string& row : column(heading)) {
      const size_t at = row.find('@'), equals = row.find('=');
      const std::string element = row.substr(0, at);
      std::string attributes;
      if (at != std::string::npos && equals != std::string::npos) {
        std::string value = row.substr(equals + 1);
        if (value == "*") value = "0.7";  // a number, in the statistics whichever
        attributes = row.substr(at + 1, equals - at - 1) + "=\"" + value + "\"";
      }
      // Symbols and extensions of one player are dealt with above.
      if (element.starts_with("ham") && element != "hamgestural_sign") continue;
      if (element.starts_with("extra_") || element == "hns_sign") continue;
      const std::string sigml = sign_with(element, attributes);
      ASSERT_FALSE(sigml.empty()) << row << ": the test knows no sign for it";
      EXPECT_EQ(complaint(sigml), "") << row;
      ++values;
    }
  }
  std::cout << values << " elements and values\n";
  EXPECT_GE(values, 400) << "the tables were not found in the statistics";
}

}  // namespace
}  // namespace auslan
