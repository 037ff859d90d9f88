// SPDX-License-Identifier: Apache-2.0
// What `check` found, as text for people and as JSON for programs.
#pragma once

#include "check/exceptions.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace auslan {

struct CheckReport {
  std::vector<Checked> all;
  std::vector<CheckFinding> findings;  ///< against the list of exceptions
  size_t exceptions = 0;               ///< how many are listed
  std::string figure;                  ///< its file; empty: the built-in one
  std::vector<std::string> lacks;      ///< what the figure cannot do
  bool each = false;                   ///< the text tells of every subject, not of measures alone
};

/// Measure by measure: how many pass, and the worst ten of those that do not.
std::string as_text(const CheckReport& report);
std::string as_json(const CheckReport& report);

/// Which postures the figure was found no place for that keeps all limits, and what is worst of them.
std::optional<std::string> out_of_reach(std::span<const Checked> all);

/// The measure that is farthest outside, counted in its limit; nothing when all are good.
std::optional<Measure> worst_of(const Verdict& verdict);

}  // namespace auslan
