// SPDX-License-Identifier: Apache-2.0
// From argv to Options. The only place that knows the command-line library.
#pragma once

#include "options.h"

#include <variant>

namespace auslan {

/// What the program should exit with at once: 0 after --help or --version, 2 after a usage error. Everything that had
/// to be said has been printed.
struct ExitNow {
  int status = 0;
};

std::variant<Options, ExitNow> parse_command_line(int argc, const char* const* argv);

}  // namespace auslan
