// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "session.h"
#include "translate/report.h"

namespace auslan {

Result<void> run_translate(const Options& options) {
  Session session(options);
  const auto translation = session.translation();
  if (!translation) return tl::unexpected(translation.error());
  return print(options.json ? to_json(*translation) : interlinear(*translation));
}

}  // namespace auslan
