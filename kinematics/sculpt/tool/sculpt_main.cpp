// SPDX-License-Identifier: Apache-2.0
// auslan-sculpt: a table of measurements as a figure in glTF 2.0.
#include "gltf/figure_gltf.h"
#include "sculpt/sculpt.h"

#include <exception>
#include <iostream>
#include <span>
#include <string>
#include <string_view>

namespace auslan {
namespace {

constexpr int kDone = 0;
constexpr int kWorkFailed = 1;
constexpr int kWrongUsage = 2;

constexpr std::string_view kUsage = "usage: auslan-sculpt MEASUREMENTS.toml -o OUT.glb\n";
constexpr std::string_view kHelp =
    "\n"
    "Makes the figure of a signer from a table of measurements: 39 joints, a closed mesh for each, a face that moves.\n"
    "\n"
    "  -o, --output FILE   where to write; an older file is replaced once the new one is whole\n"
    "  -h, --help          this text\n"
    "\n"
    "Exit: 0 done, 1 the table could not be read or the figure not written, 2 the command line was wrong.\n";

struct Request {
  std::string_view input;
  std::string_view output;
  bool wants_help = false;
};

Result<Request> parse(std::span<char* const> arguments) {
  Request request;
  bool options_ended = false;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view argument = arguments[i];
    if (!options_ended && argument == "--") {
      options_ended = true;
    } else if (!options_ended && (argument == "-h" || argument == "--help")) {
      request.wants_help = true;
      return request;
    } else if (!options_ended && (argument == "-o" || argument == "--output")) {
      if (i + 1 == arguments.size()) return fail(ErrorCode::kUsage, "-o needs the name of a file");
      request.output = arguments[++i];
    } else if (!options_ended && argument.starts_with('-')) {
      return fail(ErrorCode::kUsage, "there is no such option", std::string(argument));
    } else if (!request.input.empty()) {
      return fail(ErrorCode::kUsage, "name one table only");
    } else {
      request.input = argument;
    }
  }
  if (request.input.empty()) return fail(ErrorCode::kUsage, "name the table of measurements");
  if (request.output.empty()) return fail(ErrorCode::kUsage, "say with -o where to write");
  return request;
}

int report(const Error& error) {
  std::cerr << "auslan-sculpt: " << to_string(error) << "\n";
  return kWorkFailed;
}

int run(std::span<char* const> arguments) {
  const Result<Request> request = parse(arguments);
  if (!request) {
    std::cerr << "auslan-sculpt: " << to_string(request.error()) << "\n" << kUsage;
    return kWrongUsage;
  }
  if (request->wants_help) {
    std::cout << kUsage << kHelp << std::flush;
    return std::cout ? kDone : kWorkFailed;
  }
  const auto table = read_measurements(request->input);
  if (!table) return report(table.error());
  const auto figure = sculpt_figure(*table);
  if (!figure) return report(figure.error());
  const auto written = write_gltf(*figure, request->output);
  if (!written) return report(written.error());
  return kDone;
}

}  // namespace
}  // namespace auslan

int main(int argc, char** argv) {
  try {
    return auslan::run(std::span<char* const>(argv, static_cast<size_t>(argc)).subspan(argc > 0 ? 1 : 0));
  } catch (const std::exception& error) {
    std::cerr << "auslan-sculpt: " << error.what() << "\n";
    return 1;
  }
}
