// SPDX-License-Identifier: Apache-2.0
#include "kinematics/file_tool.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <span>
#include <string>

namespace auslan {
namespace {

constexpr int kDone = 0;
constexpr int kWorkFailed = 1;
constexpr int kWrongUsage = 2;

struct Request {
  std::string_view input;
  std::string_view output;
  size_t chosen = 0;
  bool wants_help = false;
};

/// "low, normal or high".
std::string listed(std::span<const std::string_view> words) {
  std::string text;
  for (size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : (i + 1 == words.size() ? " or " : ", ")) + std::string(words[i]);
  return text;
}

Result<Request> parse(const FileTool& tool, std::span<const char* const> arguments) {
  Request request;
  request.chosen = tool.choice.otherwise;
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
    } else if (!options_ended && !tool.choice.flag.empty() && argument == tool.choice.flag) {
      const std::string_view word = i + 1 == arguments.size() ? "" : arguments[++i];
      const auto found = std::ranges::find(tool.choice.words, word);
      if (found == tool.choice.words.end())
        return fail(ErrorCode::kUsage, std::string(argument) + " takes " + listed(tool.choice.words));
      request.chosen = static_cast<size_t>(found - tool.choice.words.begin());
    } else if (!options_ended && argument.starts_with('-')) {
      return fail(ErrorCode::kUsage, "there is no such option", std::string(argument));
    } else if (!request.input.empty()) {
      return fail(ErrorCode::kUsage, "name one " + std::string(tool.input) + " only");
    } else {
      request.input = argument;
    }
  }
  if (request.input.empty()) return fail(ErrorCode::kUsage, "name the " + std::string(tool.input) + " to read");
  if (request.output.empty()) return fail(ErrorCode::kUsage, "say with -o where to write");
  return request;
}

}  // namespace

int run_file_tool(const FileTool& tool, int argc, const char* const* argv) {
  const std::string name(tool.name);
  const std::string flag(tool.choice.flag);
  const std::string usage = "usage: " + name + " " + std::string(tool.input) + " -o " + std::string(tool.output) +
                            (flag.empty() ? "" : " [" + flag + " WORD]") + "\n";
  try {
    const auto arguments = std::span<const char* const>(argv, static_cast<size_t>(argc)).subspan(argc > 0 ? 1 : 0);
    const Result<Request> request = parse(tool, arguments);
    if (!request) {
      std::cerr << name << ": " << to_string(request.error()) << "\n" << usage;
      return kWrongUsage;
    }
    if (request->wants_help) {
      std::cout << usage << "\n"
                << tool.about
                << "\n\n"
                   "  -o, --output FILE   where to write; an older file is replaced once the new one is whole\n";
      if (!flag.empty()) {
        std::string option = "  " + flag + " WORD";
        option.resize(22, ' ');
        std::cout << option << tool.choice.about << ": " << listed(tool.choice.words) << " ("
                  << tool.choice.words[tool.choice.otherwise] << ")\n";
      }
      std::cout << "  -h, --help          this text\n"
                   "\n"
                   "Exit: 0 done, 1 the work failed, 2 the command line was wrong.\n"
                << std::flush;
      return std::cout ? kDone : kWorkFailed;
    }
    const Result<void> converted = tool.convert(request->input, request->output, request->chosen);
    if (converted) return kDone;
    std::cerr << name << ": " << to_string(converted.error()) << "\n";
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << "\n";
  }
  return kWorkFailed;
}

}  // namespace auslan
