// SPDX-License-Identifier: Apache-2.0
// What is known to break a limit of quality: one line each, with how far at most and the reason, so that nothing gets
// worse unseen and nothing stays on the list that has been mended.
//
//     SUBJECT MEASURE BOUND REASON...
//
// A subject is an entry's gloss or "phrase:ID", a measure one of the names of check.h. Lines that begin with # and
// empty ones are skipped.
#pragma once

#include "check/check.h"
#include "kinematics/result.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

struct CheckException {
  std::string subject;
  Measure measure = Measure::kContact;
  double bound = 0.0;  ///< the worst value that is accepted: a largest above the measure's range, a least below it
  std::string reason;  ///< begins with kUnreviewed where nobody has looked at it yet
};

/// What a line says until somebody who has looked at the motion has written why it stays.
inline constexpr std::string_view kUnreviewed = "unreviewed:";

/// What was checked.
struct Checked {
  std::string subject;
  Verdict verdict;
  double trouble = 0.0;  ///< the most of its targets: above 1 the figure was found no place for one of them
};

/// The list of a text. kMalformed with `name`:line for a line with other than these fields, an unknown measure, a bound
/// that is no number or within the range, an empty reason, or a subject and measure that were listed before.
Result<std::vector<CheckException>> read_exceptions(std::string_view text, const std::string& name);

/// The list of everything that breaks a limit, in the order of `all`. What a line of `before` covers keeps that line
/// with its reason; the others are unreviewed, their bounds rounded up by a tenth at most.
std::vector<CheckException> exceptions_for(std::span<const Checked> all, std::span<const CheckException> before = {});
std::string write_exceptions(std::span<const CheckException> exceptions);

struct CheckFinding {
  enum class Kind {
    kNew,       ///< a limit is broken that is not listed
    kWorse,     ///< a listed one is broken farther than its bound
    kNeedless,  ///< what is listed is within its limit
    kUnknown,   ///< the subject is not among those checked
  };
  Kind kind = Kind::kNew;
  std::string subject;
  Measure measure = Measure::kContact;
  std::string text;  ///< a sentence
};

/// `whole`: all subjects there are were checked, so that a listed one that is not among them is unknown.
std::vector<CheckFinding> compare(std::span<const Checked> all, std::span<const CheckException> exceptions, bool whole);

/// "35.7 mm (thumb_ip_r in spine_base at 1.02 s)".
std::string in_words(Measure measure, const Measured& found);

}  // namespace auslan
