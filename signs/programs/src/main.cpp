// SPDX-License-Identifier: Apache-2.0
// The program: one command line, one command, one exit status.
#include "command_line.h"
#include "commands.h"
#include "stop_request.h"

#include <cstdio>
#include <exception>
#include <iostream>
#include <variant>

namespace auslan {

Result<void> print(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    return fail(ErrorCode::kUnwritable, "cannot write to the standard output; is its disk full or its reader gone?");
  return {};
}

void remark(const Options& options, std::string_view text) {
  if (options.quiet) return;
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fputc('\n', stderr);
}

}  // namespace auslan

namespace {

auslan::Result<void> run(const auslan::Options& options) {
  using enum auslan::Command;
  if (options.appearance == auslan::kListAppearances) return auslan::list_appearances(options);
  switch (options.command) {
    case kSign:
      return auslan::run_sign(options);
    case kRender:
      return auslan::run_render(options);
    case kMotion:
      return auslan::run_motion(options);
    case kTranslate:
      return auslan::run_translate(options);
    case kExperiment:
      return auslan::run_experiment(options);
    case kAvatar:
      return auslan::run_avatar(options);
    case kBench:
      return auslan::run_bench(options);
    case kCheck:
      return auslan::run_check(options);
    case kNotation:
      return auslan::run_notation(options);
    case kDbList:
    case kDbShow:
    case kDbSearch:
    case kDbCheck:
    case kDbStats:
      return auslan::run_db(options);
    case kDbBuild:
    case kDbExport:
    case kDbImport:
    case kDbReview:
    case kDbDiff:
    case kDbMigrate:
      return auslan::run_db_edit(options);
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto parsed = auslan::parse_command_line(argc, argv);
    if (const auto* exit_now = std::get_if<auslan::ExitNow>(&parsed)) return exit_now->status;
    auslan::watch_for_stop();
    const auto done = run(std::get<auslan::Options>(parsed));
    if (done) return 0;
    std::cerr << "auslanjam: " << to_string(done.error()) << '\n';
    return done.error().code == auslan::ErrorCode::kUsage ? 2 : 1;
  } catch (const std::bad_alloc&) {
    std::cerr << "auslanjam: there is not enough memory; try a smaller --size or fewer --threads\n";
  } catch (const std::exception& error) {
    std::cerr << "auslanjam: " << error.what() << '\n';
  }
  return 1;
}
