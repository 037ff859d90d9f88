// SPDX-License-Identifier: Apache-2.0
// Broken tables are refused with their line.
#include "kinematics/file_tool.h"
#include "sculpt/measurements.h"
#include "sculpt/sculpt.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <optional>
#include <string>
#include <unistd.h>
#include <vector>

namespace auslan {
namespace {

std::string shipped_table() {
  std::ifstream file(std::string(AUSLANJAM_SOURCE_DIR) + "/assets/figure/measurements.toml");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Result<Measurements> read(const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / ("sculpt_table_" + std::to_string(::getpid()) + ".toml");
  std::ofstream(path) << text;
  auto result = read_measurements(path);
  std::filesystem::remove(path);
  return result;
}

std::string with(std::string text, const std::string& what, const std::string& by) {
  const size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(SculptTable, TheShippedTableIsRead) {
  EXPECT_TRUE(read(shipped_table()));
}

TEST(SculptTable, AMissingFileIsNamed) {
  const auto result = read_measurements("no-such-table.toml");
  ASSERT_FALSE(result);
  EXPECT_NE(to_string(result.error()).find("no-such-table.toml"), std::string::npos);
}

TEST(SculptTable, BrokenTomlIsRefusedWithItsLine) {
  const auto result = read("name = \"x\"\nforearm = = 3\n");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kMalformed);
  EXPECT_NE(result.error().place.find(":2"), std::string::npos) << result.error().place;
}

TEST(SculptTable, AMissingKeyIsNamed) {
  const auto result = read(with(shipped_table(), "\nforearm ", "\n# forearm "));
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().message.find("forearm"), std::string::npos);
}

TEST(SculptTable, AnUnknownKeyIsRefused) {
  const auto result = read(with(shipped_table(), "\nforearm ", "\nforarm = 1\nforearm "));
  ASSERT_FALSE(result);
  EXPECT_NE(to_string(result.error()).find("forarm"), std::string::npos);
}

TEST(SculptTable, AppearancesAreRefusedWithTheirLine) {
  const std::string text = shipped_table();
  const std::string none = text.substr(0, text.find("[[appearance]]"));
  for (const std::string& broken :
       {none, none + "appearance = 3\n", none + "appearance = []\n", none + "appearance = [1, 2]\n",
        with(text, "\nskin = ", "\n# skin = "), with(text, "\nskin = [", "\nskin = [1, "),
        with(text, "\nskin = [", "\nskin = [256, 0, 0] #"), with(text, "\nskin = ", "\nskim = [1, 2, 3]\nskin = "),
        text + text.substr(text.find("[[appearance]]"))}) {
    const auto result = read(broken);
    ASSERT_FALSE(result) << broken.substr(broken.size() - 60);
    EXPECT_EQ(result.error().code, ErrorCode::kMalformed);
    EXPECT_NE(result.error().message.find("appearance"), std::string::npos) << to_string(result.error());
    EXPECT_NE(result.error().place.find(":"), std::string::npos);
  }
}

TEST(SculptTable, AWrongTypeAndAnAbsurdLengthAreRefused) {
  for (const char* value : {"\nforearm = \"long\" #", "\nforearm = -5 #", "\nforearm = 1e9 #", "\nforearm = nan #"}) {
    const auto result = read(with(shipped_table(), "\nforearm ", std::string(value)));
    ASSERT_FALSE(result) << value;
    EXPECT_NE(to_string(result.error()).find("forearm"), std::string::npos) << value;
  }
}

TEST(SculptTool, TakesOneOfTheWordsOfItsChoice) {
  static std::optional<size_t> chosen;
  const FileTool tool{
      .name = "tool",
      .input = "IN",
      .output = "OUT",
      .about = "A tool.",
      .choice = {.flag = "--detail", .words = kDetailNames, .otherwise = 1, .about = "How fine"},
      .convert = [](const std::filesystem::path&, const std::filesystem::path&, size_t choice) -> Result<void> {
        chosen = choice;
        return {};
      }};
  const auto run = [&tool](std::vector<const char*> arguments) {
    chosen.reset();
    arguments.insert(arguments.begin(), "tool");
    return run_file_tool(tool, static_cast<int>(arguments.size()), arguments.data());
  };
  EXPECT_EQ(run({"a", "-o", "b"}), 0);
  EXPECT_EQ(chosen, 1U);
  EXPECT_EQ(run({"--detail", "high", "a", "-o", "b"}), 0);
  EXPECT_EQ(chosen, 2U);
  EXPECT_EQ(run({"a", "-o", "b", "--detail", "hi"}), 2);
  EXPECT_EQ(run({"a", "-o", "b", "--detail"}), 2);
  EXPECT_FALSE(chosen);
}

}  // namespace
}  // namespace auslan
