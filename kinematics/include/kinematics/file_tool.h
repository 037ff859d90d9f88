// SPDX-License-Identifier: Apache-2.0
// The command line of a tool that makes one file from another: NAME INPUT -o OUTPUT.
#pragma once

#include "kinematics/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace auslan {

/// An option of a tool that takes one of a few words.
struct FileToolChoice {
  std::string_view flag;  ///< "--detail"; empty: the tool has none
  std::span<const std::string_view> words;
  size_t otherwise = 0;    ///< which word stands where the option is missing
  std::string_view about;  ///< for --help, without the words
};

struct FileTool {
  std::string_view name;    ///< of the program
  std::string_view input;   ///< what the usage calls them: "FIGURE.glb"
  std::string_view output;  ///< "OUT.figure"
  std::string_view about;   ///< for --help: a sentence or two on what it does, without a newline at the end
  FileToolChoice choice;
  /// `chosen` is the place of the chosen word in choice.words.
  Result<void> (*convert)(const std::filesystem::path& input, const std::filesystem::path& output, size_t chosen);
};

/// Runs the tool and returns its exit status: 0 done, 1 the work failed, 2 the command line was wrong. Messages go to
/// stderr, --help to stdout. Lets no exception out.
int run_file_tool(const FileTool& tool, int argc, const char* const* argv);

}  // namespace auslan
