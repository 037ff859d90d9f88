// SPDX-License-Identifier: Apache-2.0
// The experiment as files: tables, plots, pictures of the figure, and a page that says what the numbers show.
#pragma once

#include "experiment/interpolation_study.h"
#include "kinematics/figure.h"
#include "kinematics/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace auslan {

/// One row a frame: frame, then distance and velocity of each method. Velocity of a frame leads to the next; the last
/// row has none.
std::string study_table(const std::vector<StudyRun>& runs, int end);

/// Fills a folder (made when missing; files of the same names are replaced, each whole or not at all) and returns what
/// it wrote, in order. Deterministic.
Result<std::vector<std::filesystem::path>> write_study(const Figure& figure, const std::filesystem::path& folder);

}  // namespace auslan
