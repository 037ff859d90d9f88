// SPDX-License-Identifier: Apache-2.0
// The commands: each does its work and prints its answer. An Error of code kUsage makes the program exit with 2, any
// other with 1.
#pragma once

#include "kinematics/result.h"
#include "options.h"

namespace auslan {

Result<void> run_sign(const Options& options);
Result<void> run_render(const Options& options);
Result<void> run_motion(const Options& options);
Result<void> run_translate(const Options& options);
Result<void> run_db(const Options& options);
Result<void> run_db_edit(const Options& options);
Result<void> run_experiment(const Options& options);
Result<void> run_avatar(const Options& options);
Result<void> run_bench(const Options& options);
Result<void> run_check(const Options& options);
Result<void> run_notation(const Options& options);
/// In place of any command that takes --appearance, where that is "list".
Result<void> list_appearances(const Options& options);

/// Writes to stdout; kUnwritable when that fails (a full disk, a closed pipe).
Result<void> print(std::string_view text);
/// Writes a remark to stderr unless --quiet.
void remark(const Options& options, std::string_view text);

}  // namespace auslan
