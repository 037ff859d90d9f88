// SPDX-License-Identifier: Apache-2.0
#include "check/exceptions.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

namespace auslan {
namespace {

using Key = std::pair<std::string, Measure>;

std::string_view next_word(std::string_view& rest) {
  const size_t begin = std::min(rest.find_first_not_of(" \t"), rest.size());
  const size_t end = std::min(rest.find_first_of(" \t", begin), rest.size());
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

std::string_view trimmed(std::string_view text) {
  const size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  text.remove_prefix(begin);
  const size_t end = text.find_last_not_of(" \t\r");
  return text.substr(0, end == std::string_view::npos ? 0 : end + 1);
}

std::string decimal(double value) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed).ptr;
  return {buffer.data(), end};
}

/// Outwards by up to a tenth, to two figures.
double with_room(Measure measure, double value) {
  const double room = value > info(measure).high ? 1.03 * value : 0.97 * value;
  double step = 1e-6;
  while (room / step >= 100.0)
    step *= 10.0;
  // The division gives the nearest number to the decimal that is meant.
  const double steps = value > info(measure).high ? std::ceil(room / step) : std::floor(room / step);
  return step < 1.0 ? steps / std::round(1.0 / step) : steps * step;
}

std::map<Key, const CheckException*> by_key(std::span<const CheckException> exceptions) {
  std::map<Key, const CheckException*> listed;
  for (const CheckException& one : exceptions)
    listed[{one.subject, one.measure}] = &one;
  return listed;
}

/// A value outside of its measure's range.
bool is_worse(Measure measure, double value, double bound) {
  return info(measure).high < value ? value > bound : value < bound;
}

std::string named(const Checked& checked, Measure measure) {
  return checked.subject + " " + std::string(info(measure).name);
}

}  // namespace

std::string in_words(Measure measure, const Measured& found) {
  std::array<char, 40> value{};
  std::array<char, 40> at{};
  std::snprintf(value.data(), value.size(), "%.4g ", found.value);
  std::snprintf(at.data(), at.size(), " at %.2f s, frame %d", seconds(found.time), Verdict::frame(found));
  return value.data() + std::string(info(measure).unit) + " (" + found.where + at.data() +
         (found.detail.empty() ? "" : "; " + found.detail) + ")";
}

Result<std::vector<CheckException>> read_exceptions(std::string_view text, const std::string& name) {
  std::vector<CheckException> list;
  std::map<Key, int> seen;
  int line = 0;
  while (!text.empty()) {
    ++line;
    const size_t end = std::min(text.find('\n'), text.size());
    std::string_view rest = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (rest.empty() || rest.front() == '#') continue;
    const auto wrong = [&](const std::string& what) {
      return fail(ErrorCode::kMalformed, what + "; a line has SUBJECT MEASURE BOUND REASON",
                  name + ":" + std::to_string(line));
    };
    CheckException one;
    one.subject = next_word(rest);
    const std::string_view word = next_word(rest);
    const auto measure = measure_of(word);
    if (!measure) return wrong("\"" + std::string(word) + "\" is no measure of check");
    one.measure = *measure;
    const std::string_view number = next_word(rest);
    const auto read = std::from_chars(number.data(), number.data() + number.size(), one.bound);
    if (read.ec != std::errc() || read.ptr != number.data() + number.size() || !std::isfinite(one.bound))
      return wrong("\"" + std::string(number) + "\" is no number");
    const MeasureInfo& range = info(one.measure);
    if (one.bound >= range.low && one.bound <= range.high)
      return wrong("a bound of " + std::string(number) + " is within the limit and needs no exception");
    one.reason = trimmed(rest);
    if (one.reason.empty()) return wrong("there is no reason");
    const auto [before, fresh] = seen.try_emplace({one.subject, one.measure}, line);
    if (!fresh) return wrong("the same was listed on line " + std::to_string(before->second));
    list.push_back(std::move(one));
  }
  return list;
}

std::vector<CheckException> exceptions_for(std::span<const Checked> all, std::span<const CheckException> before) {
  const std::map<Key, const CheckException*> listed = by_key(before);
  std::vector<CheckException> list;
  for (const Checked& checked : all) {
    for (size_t i = 0; i < kMeasureCount; ++i) {
      const auto measure = static_cast<Measure>(i);
      if (checked.verdict.good(measure)) continue;
      const Measured& found = *checked.verdict.of(measure);
      const auto known = listed.find({checked.subject, measure});
      if (known != listed.end() && !is_worse(measure, found.value, known->second->bound)) {
        list.push_back(*known->second);
        continue;
      }
      list.push_back({checked.subject, measure, with_room(measure, found.value),
                      std::string(kUnreviewed) + " " + in_words(measure, found)});
    }
  }
  return list;
}

std::string write_exceptions(std::span<const CheckException> exceptions) {
  std::string text =
      "# SPDX-License-Identifier: Apache-2.0\n"
      "# What is known to break a limit of `auslanjam check`, how far at most, and why it stays:\n"
      "#   SUBJECT MEASURE BOUND REASON\n"
      "# `auslanjam check` fails where something else breaks a limit, a bound is exceeded, or a line is needless.\n"
      "# `auslanjam check --write-exceptions FILE` adds what is new as \"unreviewed\" and drops what is mended; "
      "whoever has\n"
      "# looked at the motion writes the reason. The aim is an empty list.\n";
  for (const CheckException& one : exceptions)
    text +=
        one.subject + " " + std::string(info(one.measure).name) + " " + decimal(one.bound) + " " + one.reason + "\n";
  return text;
}

std::vector<CheckFinding> compare(std::span<const Checked> all, std::span<const CheckException> exceptions,
                                  bool whole) {
  using Kind = CheckFinding::Kind;
  std::map<Key, const CheckException*> listed = by_key(exceptions);
  std::vector<CheckFinding> findings;
  for (const Checked& checked : all) {
    for (size_t i = 0; i < kMeasureCount; ++i) {
      const auto measure = static_cast<Measure>(i);
      const auto entry = listed.find({checked.subject, measure});
      const CheckException* exception = entry == listed.end() ? nullptr : entry->second;
      if (entry != listed.end()) listed.erase(entry);
      const auto& found = checked.verdict.of(measure);
      if (checked.verdict.good(measure)) {
        if (exception != nullptr)
          findings.push_back({Kind::kNeedless, checked.subject, measure,
                              named(checked, measure) + " is within its limit: its exception is needless"});
        continue;
      }
      if (exception == nullptr) {
        findings.push_back({Kind::kNew, checked.subject, measure,
                            named(checked, measure) + " is outside its limit: " + in_words(measure, *found)});
      } else if (is_worse(measure, found->value, exception->bound)) {
        findings.push_back({Kind::kWorse, checked.subject, measure,
                            named(checked, measure) + " is outside the " + decimal(exception->bound) +
                                " of its exception: " + in_words(measure, *found)});
      }
    }
  }
  if (!whole) return findings;
  for (const auto& [key, exception] : listed)
    findings.push_back(
        {Kind::kUnknown, key.first, key.second,
         key.first + " " + std::string(info(key.second).name) + " is an exception for what is not in the lexicon"});
  return findings;
}

}  // namespace auslan
