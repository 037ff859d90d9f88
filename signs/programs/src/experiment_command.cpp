// SPDX-License-Identifier: Apache-2.0
// `experiment`: the paper's interpolation experiment into a folder.
#include "commands.h"
#include "experiment/study_report.h"
#include "session.h"

#include <nlohmann/json.hpp>

namespace auslan {

Result<void> run_experiment(const Options& options) {
  Session session(options);
  const auto figure = session.figure();
  if (!figure) return tl::unexpected(figure.error());
  const auto written = write_study(**figure, options.output);
  if (!written) return tl::unexpected(written.error());
  if (options.json) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const std::filesystem::path& path : *written)
      json.push_back(path.string());
    return print(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  }
  std::string text;
  for (const std::filesystem::path& path : *written)
    text += path.string() + "\n";
  return print(text);
}

}  // namespace auslan
