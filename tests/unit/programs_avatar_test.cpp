// SPDX-License-Identifier: Apache-2.0
// `auslanjam avatar`: its answer about a small figure, for people and for programs.
#include "tiny_avatar.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

namespace auslan {
namespace {

using nlohmann::json;
using test::GlbDocument;
using test::tiny_avatar;

class AvatarCommand : public testing::Test {
 protected:
  Ran answer(const GlbDocument& document, const std::string& options = "") const {
    put_bytes(folder_ / "tiny.vrm", document.pack());
    return run(std::string(AUSLANJAM_PROGRAM) + " avatar '" + (folder_ / "tiny.vrm").string() + "' " + options);
  }

  const ScratchFolder folder_;
};

TEST_F(AvatarCommand, TellsWhatIsThereAndWhatIsMissing) {
  const Ran ran = answer(tiny_avatar());
  ASSERT_TRUE(ran.ok) << ran.output;
  for (const char* part :
       {"VRM 1, \"tiny\"", "2 triangles", "5 nodes", "1 morph target", "hips = Hips", "skin (PNG", "jawOpen",
        "missing: chest", "leftIndexProximal", "For signing: 37 joints are missing: head"})
    EXPECT_NE(ran.output.find(part), std::string::npos) << part << " in\n" << ran.output;
}

TEST_F(AvatarCommand, TellsTheSameAsJson) {
  const Ran ran = answer(tiny_avatar(), "--json");
  ASSERT_TRUE(ran.ok) << ran.output;
  const json told = json::parse(ran.output);
  EXPECT_EQ(told["kind"], "VRM 1");
  EXPECT_EQ(told["triangles"], 2);
  EXPECT_EQ(told["height_m"], 1.0);
  EXPECT_EQ(told["bones"]["spine"], (json{{"node", "Spine"}, {"by_name", false}}));
  EXPECT_EQ(told["bones"].size() + told["missing_bones"].size(), static_cast<size_t>(kHumanRoleCount));
  EXPECT_EQ(told["missing_for_signing"].size(), 37U);
  EXPECT_EQ(told["signs"], false);
  EXPECT_EQ(told["face"]["jawOpen"], (json{{"by", "morph"}, {"source", "jawOpen"}}));
  EXPECT_EQ(told["face"]["tongueOut"]["by"], "none");
  EXPECT_EQ(told["expressions"][0]["morphs"][0]["weight"], 0.75);
  EXPECT_EQ(told["images"][0]["format"], "PNG");
}

TEST_F(AvatarCommand, NamesCannotCommandTheTerminal) {
  GlbDocument document = tiny_avatar();
  document.json["extensions"]["VRMC_vrm"]["meta"]["name"] = "a\x1b[2Jb\nc\x7f";
  document.json["nodes"][1]["name"] = "\x1b]0;title\x07" + std::string(100'000, 'x');
  const Ran ran = answer(document);
  ASSERT_TRUE(ran.ok);
  EXPECT_TRUE(std::ranges::all_of(ran.output, [](char c) { return c == '\n' || (c >= ' ' && c != 0x7F); }));
  EXPECT_NE(ran.output.find("a?[2Jb?c?"), std::string::npos) << ran.output;
  EXPECT_LT(ran.output.size(), 10'000U);
}

}  // namespace
}  // namespace auslan
