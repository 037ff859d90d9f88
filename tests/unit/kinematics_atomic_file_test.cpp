// SPDX-License-Identifier: Apache-2.0
#include "kinematics/atomic_file.h"
#include "scratch_folder.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace auslan {
namespace {

using Names = std::vector<std::string>;

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const ScratchFolder folder;
  auto file = AtomicFile::create(folder / "out");
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->write("hello "));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  ASSERT_TRUE(file->write("world"));
  ASSERT_TRUE(file->overwrite(1, "E"));
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(bytes_of(folder / "out"), "hEllo world");
  EXPECT_EQ(folder.contents(), Names{"out"});
  EXPECT_FALSE(file->write("more"));
}

TEST(AtomicFile, AbandonedLeavesTheOldFileAndNothingElse) {
  const ScratchFolder folder;
  put_bytes(folder / "out", "old");
  {
    auto file = AtomicFile::create(folder / "out");
    ASSERT_TRUE(file && file->write("new"));
    auto moved = std::move(*file);
    EXPECT_EQ(folder.contents().size(), 2U);
  }
  EXPECT_EQ(bytes_of(folder / "out"), "old");
  EXPECT_EQ(folder.contents(), Names{"out"});
}

TEST(AtomicFile, KeepsTheRightsOfTheFileThatItReplaces) {
  const ScratchFolder folder;
  put_bytes(folder / "out", "old");
  chmod((folder / "out").c_str(), 0600);
  auto file = AtomicFile::create(folder / "out");
  ASSERT_TRUE(file && file->write("new") && file->commit());
  struct stat info {};
  ASSERT_EQ(stat((folder / "out").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0600U);
}

TEST(AtomicFile, WritesThroughASymbolicLink) {
  const ScratchFolder folder;
  put_bytes(folder / "real", "old");
  std::filesystem::create_symlink("real", folder / "link");
  auto file = AtomicFile::create(folder / "link");
  ASSERT_TRUE(file && file->write("new") && file->commit());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(bytes_of(folder / "real"), "new");
}

TEST(AtomicFile, ALongNameIsNoObstacle) {
  const ScratchFolder folder;
  const std::string name(250, 'n');
  auto file = AtomicFile::create(folder / name);
  ASSERT_TRUE(file && file->write("x") && file->commit());
  EXPECT_EQ(folder.contents(), Names{name});
}

TEST(AtomicFile, RefusesAFolderAMissingFolderAndAFileAsFolder) {
  const ScratchFolder folder;
  put_bytes(folder / "plain", "x");
  for (const std::string& path :
       {(folder / "").string(), (folder / "none/out").string(), (folder / "plain/out").string(), std::string()}) {
    const auto file = AtomicFile::create(path);
    ASSERT_FALSE(file) << path;
    EXPECT_EQ(file.error().code, ErrorCode::kUnwritable) << path;
    EXPECT_NE(file.error().message.find(';'), std::string::npos) << "says what to do: " << file.error().message;
  }
  EXPECT_EQ(folder.contents(), Names{"plain"});
}

TEST(AtomicFile, AFullDiskIsSaid) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  auto file = AtomicFile::create("/dev/full");
  ASSERT_TRUE(file);
  const auto written = file->write("x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kUnwritable);
  EXPECT_NE(written.error().message.find("free some space"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

}  // namespace
}  // namespace auslan
