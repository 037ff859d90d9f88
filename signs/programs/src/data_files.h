// SPDX-License-Identifier: Apache-2.0
// Where the program's own data lies.
#pragma once

#include <filesystem>
#include <string_view>

namespace auslan {

/// The path of a data file ("signer.figure", "lexicon.sqlite"): in the folder that AUSLANJAM_DATA names, else in
/// ../share/auslanjam beside the program, else where the build put it. The file need not be there.
std::filesystem::path data_file(std::string_view name);

}  // namespace auslan
