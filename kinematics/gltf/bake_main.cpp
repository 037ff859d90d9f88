// SPDX-License-Identifier: Apache-2.0
// auslan-bake: a glTF figure as the flat file that the programs load. Run by the build and by whoever edits the figure.
#include "gltf/figure_gltf.h"
#include "kinematics/figure_file.h"

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

constexpr std::string_view kUsage = "usage: auslan-bake FIGURE.glb -o OUT.figure\n";
constexpr std::string_view kHelp =
    "\n"
    "Turns a figure in glTF 2.0 (.glb or .gltf) into the flat binary file that the programs of Auslan Jam load.\n"
    "\n"
    "  -o, --output FILE   where to write; an older file is replaced once the new one is whole\n"
    "  -h, --help          this text\n"
    "\n"
    "Exit: 0 done, 1 the figure could not be read or written, 2 the command line was wrong.\n";

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
      return fail(ErrorCode::kUsage, "name one figure only");
    } else {
      request.input = argument;
    }
  }
  if (request.input.empty()) return fail(ErrorCode::kUsage, "name the figure to bake");
  if (request.output.empty()) return fail(ErrorCode::kUsage, "say with -o where to write");
  return request;
}

int report(const Error& error) {
  std::cerr << "auslan-bake: " << to_string(error) << "\n";
  return kWorkFailed;
}

int run(std::span<char* const> arguments) {
  const Result<Request> request = parse(arguments);
  if (!request) {
    std::cerr << "auslan-bake: " << to_string(request.error()) << "\n" << kUsage;
    return kWrongUsage;
  }
  if (request->wants_help) {
    std::cout << kUsage << kHelp << std::flush;
    return std::cout ? kDone : kWorkFailed;
  }
  const auto figure = read_gltf(request->input);
  if (!figure) return report(figure.error());
  const auto written = write_figure(*figure, request->output);
  if (!written) return report(written.error());
  return kDone;
}

}  // namespace
}  // namespace auslan

int main(int argc, char** argv) {
  try {
    return auslan::run(std::span<char* const>(argv, static_cast<size_t>(argc)).subspan(argc > 0 ? 1 : 0));
  } catch (const std::exception& error) {
    std::cerr << "auslan-bake: " << error.what() << "\n";
    return 1;
  }
}
