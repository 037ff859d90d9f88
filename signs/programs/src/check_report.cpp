// SPDX-License-Identifier: Apache-2.0
#include "check_report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string_view>

namespace auslan {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kWorst = 10;  // how many are told of each measure
constexpr std::array<std::string_view, 4> kFindings = {"new", "worse", "needless", "unknown"};

std::string number(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

std::string limit_of(Measure measure) {
  const MeasureInfo& range = info(measure);
  if (range.low > 0.0 && range.high >= kUnbounded) return "at least " + number(range.low);
  return (range.low > 0.0 ? number(range.low) + " to " : "at most ") + number(range.high);
}

/// How many times outside its limit.
double times_outside(Measure measure, double value) {
  const MeasureInfo& range = info(measure);
  return value > range.high ? value / std::max(range.high, 1e-9) : range.low / std::max(value, 1e-3);
}

/// Those outside, the worst first.
std::vector<const Checked*> outside(std::span<const Checked> all, Measure measure) {
  std::vector<const Checked*> found;
  for (const Checked& one : all)
    if (!one.verdict.good(measure)) found.push_back(&one);
  std::ranges::stable_sort(found, [measure](const Checked* a, const Checked* b) {
    return times_outside(measure, a->verdict.of(measure)->value) >
           times_outside(measure, b->verdict.of(measure)->value);
  });
  return found;
}

}  // namespace

std::optional<Measure> worst_of(const Verdict& verdict) {
  std::optional<Measure> worst;
  double most = 0.0;
  for (size_t i = 0; i < kMeasureCount; ++i) {
    const auto measure = static_cast<Measure>(i);
    if (verdict.good(measure)) continue;
    const double times = times_outside(measure, verdict.of(measure)->value);
    if (times <= most) continue;
    most = times;
    worst = measure;
  }
  return worst;
}

std::optional<std::string> out_of_reach(std::span<const Checked> all) {
  std::vector<std::string> names;
  for (const Checked& one : all) {
    const auto worst = worst_of(one.verdict);
    if (one.trouble <= 1.0 || !worst) continue;
    const Measured& found = *one.verdict.of(*worst);
    names.push_back(one.subject + " (" + std::string(info(*worst).name) + " " + number(found.value) + " " +
                    std::string(info(*worst).unit) + ")");
  }
  if (names.empty()) return std::nullopt;
  std::string text = "its arms and hands were found no place for a posture of " + std::to_string(names.size()) +
                     " of " + std::to_string(all.size()) + ": ";
  for (size_t i = 0; i < names.size() && i < kWorst; ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > kWorst) text += " and more";
  return text;
}

std::string as_text(const CheckReport& report) {
  std::string text;
  for (const std::string& lack : report.lacks)
    text += "the figure: " + lack + "\n";
  for (const Checked& one : report.all) {
    if (!report.each || one.verdict.good()) continue;
    text += one.subject + "\n";
    for (size_t i = 0; i < kMeasureCount; ++i) {
      const auto measure = static_cast<Measure>(i);
      if (one.verdict.good(measure)) continue;
      text += "  " + std::string(info(measure).name) + ": " + in_words(measure, *one.verdict.of(measure)) + "\n";
    }
  }
  for (size_t i = 0; i < kMeasureCount; ++i) {
    const auto measure = static_cast<Measure>(i);
    const auto measured = std::ranges::count_if(
        report.all, [measure](const Checked& one) { return one.verdict.of(measure).has_value(); });
    if (measured == 0) continue;
    const std::vector<const Checked*> bad = outside(report.all, measure);
    text += std::string(info(measure).name) + " (" + limit_of(measure) + " " + std::string(info(measure).unit) +
            "): " + std::to_string(measured - static_cast<std::ptrdiff_t>(bad.size())) + " of " +
            std::to_string(measured) + "\n";
    for (size_t j = 0; j < bad.size() && j < kWorst && !report.each; ++j)
      text += "  " + bad[j]->subject + ": " + in_words(measure, *bad[j]->verdict.of(measure)) + "\n";
  }
  const auto good = std::ranges::count_if(report.all, [](const Checked& one) { return one.verdict.good(); });
  text += std::to_string(good) + " of " + std::to_string(report.all.size()) + " within all limits\n";
  if (report.exceptions > 0) {
    text += std::to_string(report.exceptions) + " exceptions, " + std::to_string(report.findings.size()) +
            " findings beside them\n";
    for (const CheckFinding& finding : report.findings)
      text += "  " + finding.text + "\n";
  }
  return text;
}

std::string as_json(const CheckReport& report) {
  Json json;
  if (!report.figure.empty()) json["figure"] = {{"file", report.figure}, {"lacks", report.lacks}};
  json["limits"] = Json::object();
  json["totals"] = Json::object();
  for (size_t i = 0; i < kMeasureCount; ++i) {
    const auto measure = static_cast<Measure>(i);
    const MeasureInfo& range = info(measure);
    Json& limit = json["limits"][std::string(range.name)] = {{"unit", range.unit}, {"low", range.low}};
    if (range.high < kUnbounded) limit["high"] = range.high;
    const auto measured = std::ranges::count_if(
        report.all, [measure](const Checked& one) { return one.verdict.of(measure).has_value(); });
    Json worst = Json::array();
    const std::vector<const Checked*> bad = outside(report.all, measure);
    for (size_t j = 0; j < bad.size() && j < kWorst; ++j)
      worst.push_back(bad[j]->subject);
    json["totals"][std::string(range.name)] = {{"measured", measured}, {"outside", bad.size()}, {"worst", worst}};
  }
  json["entries"] = Json::array();
  for (const Checked& entry : report.all) {
    Json one = {{"gloss", entry.subject}, {"good", entry.verdict.good()}, {"measures", Json::object()}};
    for (size_t i = 0; i < kMeasureCount; ++i) {
      const auto measure = static_cast<Measure>(i);
      const auto& found = entry.verdict.of(measure);
      if (!found) continue;
      Json& told = one["measures"][std::string(info(measure).name)] = {{"value", found->value},
                                                                       {"good", entry.verdict.good(measure)},
                                                                       {"seconds", seconds(found->time)},
                                                                       {"frame", Verdict::frame(*found)},
                                                                       {"where", found->where}};
      if (!found->detail.empty()) told["detail"] = found->detail;
    }
    if (entry.trouble > 1.0) one["out_of_reach"] = entry.trouble;
    json["entries"].push_back(one);
  }
  json["exceptions"] = report.exceptions;
  json["findings"] = Json::array();
  for (const CheckFinding& finding : report.findings)
    json["findings"].push_back({{"kind", kFindings[static_cast<size_t>(finding.kind)]},
                                {"gloss", finding.subject},
                                {"measure", info(finding.measure).name},
                                {"text", finding.text}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace auslan
