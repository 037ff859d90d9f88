// SPDX-License-Identifier: Apache-2.0
// The command line of auslan-bake: AUSLANJAM_BAKE is the program.
#include "glb_document.h"
#include "kinematics/figure_file.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <string>
#include <sys/wait.h>

namespace auslan {
namespace {

/// The exit code; standard output and error go to files of these names.
int run(const ScratchFolder& folder, const std::string& arguments) {
  const std::string command =
      "cd '" + folder.path().string() + "' && '" AUSLANJAM_BAKE "' " + arguments + " >out 2>err";
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(GltfBake, BakesTheFigureThatTheGltfHolds) {
  const ScratchFolder folder;
  const Figure figure = test::sample_figure();
  ASSERT_TRUE(write_gltf(figure, folder / "a.glb"));
  ASSERT_EQ(run(folder, "a.glb -o a.figure"), 0) << bytes_of(folder / "err");
  const auto read = read_figure(folder / "a.figure");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(test::difference(figure, *read), "");
  EXPECT_EQ(bytes_of(folder / "out"), "");
}

TEST(GltfBake, HelpGoesToStandardOutput) {
  const ScratchFolder folder;
  EXPECT_EQ(run(folder, "--help"), 0);
  EXPECT_TRUE(bytes_of(folder / "out").starts_with("usage: auslan-bake"));
  EXPECT_EQ(bytes_of(folder / "err"), "");
}

TEST(GltfBake, WrongCommandLinesExitWithTwo) {
  const ScratchFolder folder;
  for (const char* arguments : {"", "a.glb", "-o a.figure", "a.glb -o", "a.glb b.glb -o c", "a.glb --fast -o c"}) {
    EXPECT_EQ(run(folder, arguments), 2) << arguments;
    EXPECT_NE(bytes_of(folder / "err").find("usage:"), std::string::npos) << arguments;
    EXPECT_EQ(bytes_of(folder / "out"), "");
  }
}

TEST(GltfBake, FailedWorkExitsWithOneAndKeepsTheOldFile) {
  const ScratchFolder folder;
  put_bytes(folder / "broken.glb", "glTF");
  put_bytes(folder / "old.figure", "old");
  EXPECT_EQ(run(folder, "broken.glb -o old.figure"), 1);
  EXPECT_NE(bytes_of(folder / "err").find("broken.glb"), std::string::npos);
  EXPECT_EQ(run(folder, "missing.glb -o old.figure"), 1);
  EXPECT_EQ(bytes_of(folder / "old.figure"), "old");
  ASSERT_TRUE(write_gltf(test::tiny_figure(), folder / "-a.glb"));
  EXPECT_EQ(run(folder, "-o nowhere/a.figure -- -a.glb"), 1);
}

}  // namespace
}  // namespace auslan
