// SPDX-License-Identifier: Apache-2.0
// Figures of other makers, kept beside the project and never in it: in ../shared/avatars or in the folder that
// AUSLANJAM_SAMPLE_AVATARS names.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>

namespace auslan::test {

inline std::filesystem::path sample_avatar(const std::string& name) {
  const char* folder = std::getenv("AUSLANJAM_SAMPLE_AVATARS");
  if (folder != nullptr) return std::filesystem::path(folder) / name;
  return std::filesystem::path(AUSLANJAM_SOURCE_DIR) / "../shared/avatars" / name;
}

}  // namespace auslan::test

/// Skips the test at hand where the file is missing.
#define AUSLAN_NEEDS_AVATAR(name)                                    \
  if (!std::filesystem::exists(::auslan::test::sample_avatar(name))) \
  GTEST_SKIP() << "the sample avatar is not there: " << ::auslan::test::sample_avatar(name)
