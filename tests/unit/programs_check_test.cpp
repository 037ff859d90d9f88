// SPDX-License-Identifier: Apache-2.0
// `auslanjam check`: its answer for programs, its list of exceptions, and that threads change nothing.
#include "scratch_folder.h"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

namespace auslan {
namespace {

using nlohmann::json;

class CheckCommand : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Its standard output alone; `ok` where it exits with 0.
  Ran check(const std::string& options) const {
    return run(std::string(AUSLANJAM_PROGRAM) + " check --quiet " + options + " 2>/dev/null");
  }
  static std::string text_of(const std::string& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void put(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

  const ScratchFolder folder_;
};

TEST_F(CheckCommand, TellsWhatWasMeasuredWhenAndWhere) {
  put("none.txt", "");
  const json told = json::parse(check("HURT fs:A --json --exceptions " + path("none.txt")).output);
  ASSERT_EQ(told["entries"].size(), 2U);
  EXPECT_EQ(told["entries"][0]["gloss"], "HURT");
  EXPECT_EQ(told["limits"]["contact"], (json{{"unit", "mm"}, {"low", 0.0}, {"high", 3.0}}));
  EXPECT_FALSE(told["limits"]["hold"].contains("high"));
  for (const json& entry : told["entries"])
    for (const auto& [measure, found] : entry["measures"].items()) {
      EXPECT_TRUE(told["limits"].contains(measure));
      EXPECT_EQ(found["frame"].get<int>(), static_cast<int>(found["seconds"].get<double>() * 120.0 + 1e-6)) << measure;
    }
  // Letters hold longer than signs need to.
  EXPECT_TRUE(told["entries"][1]["measures"].contains("letter-hold"));
  EXPECT_TRUE(told["entries"][0]["measures"].contains("hold"));
}

TEST_F(CheckCommand, ThreadsChangeNothing) {
  const std::string what = "fs:A HURT WHERE fs:X --json";
  const std::string alone = check(what).output;
  EXPECT_FALSE(alone.empty());
  EXPECT_EQ(check(what + " --threads 3").output, alone);
}

TEST_F(CheckCommand, TheListThatItWritesExcusesAndNothingElseDoes) {
  const std::string list = path("list.txt");
  ASSERT_TRUE(check("THIRSTY HUNGRY --write-exceptions " + list).ok);
  const std::string text = text_of(list);
  const bool any = text.find("\nTHIRSTY ") != std::string::npos || text.find("\nHUNGRY ") != std::string::npos;
  EXPECT_TRUE(check("THIRSTY HUNGRY --exceptions " + list).ok);
  put("none.txt", "");
  EXPECT_EQ(check("THIRSTY HUNGRY --exceptions " + path("none.txt")).ok, !any);
  put("needless.txt", text + "THIRSTY mirror 1 no reason at all\n");
  const Ran needless = check("THIRSTY HUNGRY --exceptions " + path("needless.txt"));
  EXPECT_FALSE(needless.ok);
  EXPECT_NE(needless.output.find("THIRSTY mirror is within its limit"), std::string::npos) << needless.output;
}

TEST_F(CheckCommand, ABrokenListIsRefusedWithItsLine) {
  put("bad.txt", "# a list\nHURT contact far reason\n");
  const Ran ran = run(std::string(AUSLANJAM_PROGRAM) + " check HURT --exceptions " + path("bad.txt") + " 2>&1");
  EXPECT_FALSE(ran.ok);
  EXPECT_NE(ran.output.find("bad.txt:2: \"far\" is no number"), std::string::npos) << ran.output;
  EXPECT_FALSE(check("HURT --exceptions " + path("missing.txt")).ok);
  EXPECT_FALSE(check("phrase:no-such").ok);
  EXPECT_FALSE(check("NO-SUCH-GLOSS").ok);
}

}  // namespace
}  // namespace auslan
