// SPDX-License-Identifier: Apache-2.0
// The command line of `db`.
#pragma once

#include "options.h"

#include <CLI/CLI.hpp>
#include <utility>
#include <vector>

namespace auslan {

/// Adds the commands of `db`, and says which command each of them is.
std::vector<std::pair<CLI::App*, Command>> add_db(CLI::App& app, Options& options);

}  // namespace auslan
