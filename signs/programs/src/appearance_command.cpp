// SPDX-License-Identifier: Apache-2.0
// `--appearance list`: the names that --appearance takes.
#include "commands.h"
#include "session.h"

#include <nlohmann/json.hpp>

namespace auslan {

Result<void> list_appearances(const Options& options) {
  Options as_it_comes = options;
  as_it_comes.appearance.clear();
  Session session(as_it_comes);
  const auto figure = session.figure();
  if (!figure) return tl::unexpected(figure.error());
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  std::string lines;
  for (const Appearance& appearance : (*figure)->appearances) {
    names.push_back(appearance.name);
    lines += appearance.name + "\n";
  }
  return print(options.json ? names.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n" : lines);
}

}  // namespace auslan
