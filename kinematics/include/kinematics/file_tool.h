// SPDX-License-Identifier: Apache-2.0
// The command line of a tool that makes one file from another: NAME INPUT -o OUTPUT.
#pragma once

#include "kinematics/result.h"

#include <filesystem>
#include <string_view>

namespace auslan {

struct FileTool {
  std::string_view name;    ///< of the program
  std::string_view input;   ///< what the usage calls them: "FIGURE.glb"
  std::string_view output;  ///< "OUT.figure"
  std::string_view about;   ///< for --help: a sentence or two on what it does, without a newline at the end
  Result<void> (*convert)(const std::filesystem::path& input, const std::filesystem::path& output);
};

/// Runs the tool and returns its exit status: 0 done, 1 the work failed, 2 the command line was wrong. Messages go to
/// stderr, --help to stdout. Lets no exception out.
int run_file_tool(const FileTool& tool, int argc, const char* const* argv);

}  // namespace auslan
