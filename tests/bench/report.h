// SPDX-License-Identifier: Apache-2.0
// The report: the rasteriser beside what a user could have picked instead, in one run.
#pragma once

#include <string>

namespace auslan::bench {

struct ReportOptions {
  bool quick = false;    ///< two scenes, a frame of each kind: to see that the benchmark still works
  std::string json;      ///< file for every figure; empty: none
  std::string pictures;  ///< folder for the pictures that were compared, as PPM; empty: none
};

/// Prints the tables. Returns the exit status: 1 when the peers did not draw the same picture as the rasteriser (then
/// the figures compare different work) or a file could not be written.
int run_report(const ReportOptions& options);

}  // namespace auslan::bench
