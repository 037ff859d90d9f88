// SPDX-License-Identifier: Apache-2.0
// The development sample of real dictionaries beside the checkout, where there is one.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace auslan::testing {

inline std::filesystem::path corpora() {
  return std::filesystem::path(AUSLANJAM_SOURCE_DIR) / ".." / "shared" / "corpora";
}

/// The SiGML files of one dictionary by name; empty where the sample is not there.
inline std::vector<std::filesystem::path> sigml_files(const std::string& dictionary) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(corpora() / dictionary)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(corpora() / dictionary))
    if (entry.path().extension() == ".sigml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace auslan::testing
