// SPDX-License-Identifier: Apache-2.0
// `check`: entries of the lexicon performed on the figure and held against the limits of the project.
#include "check/check.h"
#include "commands.h"
#include "frame_maker.h"
#include "media/picture.h"
#include "progress.h"
#include "session.h"
#include "stop_request.h"
#include "synthesis/choreography.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

namespace auslan {
namespace {

using Json = nlohmann::ordered_json;

struct Checked {
  std::string gloss;
  Verdict verdict;
};

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

/// "35.7 mm (thumb_ip_r in spine_base at 1.02 s)".
std::string in_words(Measure measure, const Measured& found) {
  char at[40];
  std::snprintf(at, sizeof at, " at %.2f s)", seconds(found.time));
  return number(found.value) + " " + std::string(info(measure).unit) + " (" + found.where + at;
}

std::string limit_of(Measure measure) {
  const MeasureInfo& range = info(measure);
  if (range.low > 0.0 && range.high >= 1e6) return "at least " + number(range.low);
  return (range.low > 0.0 ? number(range.low) + " to " : "at most ") + number(range.high);
}

/// The measure that is farthest outside, counted in its limit; nothing when all are good.
std::optional<Measure> worst_of(const Verdict& verdict) {
  std::optional<Measure> worst;
  double most = 0.0;
  for (size_t i = 0; i < kMeasureCount; ++i) {
    const auto measure = static_cast<Measure>(i);
    if (verdict.good(measure)) continue;
    const double value = verdict.of(measure)->value;
    const MeasureInfo& range = info(measure);
    const double times = value > range.high ? value / range.high : range.low / std::max(value, 1e-3);
    if (times <= most) continue;
    most = times;
    worst = measure;
  }
  return worst;
}

std::string as_text(const std::vector<Checked>& all) {
  std::string text;
  std::array<int, kMeasureCount> outside{};
  std::array<const Checked*, kMeasureCount> extreme{};
  int good = 0;
  for (const Checked& entry : all) {
    if (entry.verdict.good()) {
      ++good;
      continue;
    }
    text += entry.gloss + "\n";
    for (size_t i = 0; i < kMeasureCount; ++i) {
      const auto measure = static_cast<Measure>(i);
      if (entry.verdict.good(measure)) continue;
      ++outside[i];
      const double value = entry.verdict.of(measure)->value;
      if (extreme[i] == nullptr || value > extreme[i]->verdict.of(measure)->value) extreme[i] = &entry;
      text += "  " + std::string(info(measure).name) + ": " + in_words(measure, *entry.verdict.of(measure)) + "\n";
    }
  }
  text += std::to_string(good) + " of " + std::to_string(all.size()) + " within all limits\n";
  for (size_t i = 0; i < kMeasureCount; ++i) {
    if (outside[i] == 0) continue;
    const auto measure = static_cast<Measure>(i);
    text += std::string(info(measure).name) + ": " + std::to_string(outside[i]) + " outside (" + limit_of(measure) +
            " " + std::string(info(measure).unit) + "), the most " + number(extreme[i]->verdict.of(measure)->value) +
            " in " + extreme[i]->gloss + "\n";
  }
  return text;
}

std::string as_json(const std::vector<Checked>& all) {
  Json json;
  json["limits"] = Json::object();
  for (size_t i = 0; i < kMeasureCount; ++i) {
    const MeasureInfo& range = info(static_cast<Measure>(i));
    json["limits"][std::string(range.name)] = {{"unit", range.unit}, {"low", range.low}, {"high", range.high}};
  }
  json["entries"] = Json::array();
  for (const Checked& entry : all) {
    Json one = {{"gloss", entry.gloss}, {"good", entry.verdict.good()}, {"measures", Json::object()}};
    for (size_t i = 0; i < kMeasureCount; ++i) {
      const auto measure = static_cast<Measure>(i);
      const auto& found = entry.verdict.of(measure);
      if (!found) continue;
      one["measures"][std::string(info(measure).name)] = {{"value", found->value},
                                                          {"good", entry.verdict.good(measure)},
                                                          {"seconds", seconds(found->time)},
                                                          {"where", found->where}};
    }
    json["entries"].push_back(one);
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The moment of the worst measure, with what is wrong as its caption.
Result<void> draw_worst(const Options& options, const Body& body, const StageOptions& form, const Score& score,
                        const Signer& signer, const Checked& entry) {
  const auto measure = worst_of(entry.verdict);
  if (!measure) return {};
  const Measured& found = *entry.verdict.of(*measure);
  auto stage = body.stage(form);
  if (!stage) return tl::unexpected(stage.error());
  Picture picture = make_picture(form.width, form.height);
  Pose pose;
  Performance(signer, score, {.left_handed = false, .idle = false, .seed = 1}).sample(found.time, pose);
  stage->render(pose, picture.pixels);
  const auto painter = CaptionPainter::open();
  if (!painter) return tl::unexpected(painter.error());
  CaptionStyle style;
  style.size_px = std::max(12, form.height / 30);
  painter->paint(picture.span(),
                 entry.gloss + ", " + std::string(info(*measure).name) + ": " + in_words(*measure, found), style);
  std::string name = entry.gloss;
  for (char& c : name)
    if (c == ':' || c == '/' || c == ' ') c = '_';
  return write_png((std::filesystem::path(options.output) / (name + ".png")).string(), picture.view());
}

}  // namespace

Result<void> run_check(const Options& options) {
  Session session(options);
  const auto body = session.body();
  if (!body) return tl::unexpected(body.error());
  const auto signer = session.signer();
  if (!signer) return tl::unexpected(signer.error());
  const auto lexicon = session.lexicon();
  if (!lexicon) return tl::unexpected(lexicon.error());
  std::vector<std::string> glosses = options.words;
  if (glosses.empty()) {
    const auto entries = (*lexicon)->list();
    if (!entries) return tl::unexpected(entries.error());
    for (const SignSummary& entry : *entries)
      glosses.push_back(entry.gloss);
  }
  if (!options.output.empty()) {
    std::error_code failed;
    std::filesystem::create_directories(options.output, failed);
    if (failed) return fail(ErrorCode::kUnwritable, "cannot make the folder " + options.output);
  }
  const Checker checker(**signer);
  std::vector<Checked> all;
  Progress progress("checking", static_cast<int64_t>(glosses.size()), options.quiet);
  for (const std::string& gloss : glosses) {
    if (stop_requested()) return stopped();
    const auto utterance = session.utterance_of(gloss);
    if (!utterance) return tl::unexpected(utterance.error());
    const auto score = choreograph(**signer, *utterance);
    if (!score) return tl::unexpected(score.error());
    all.push_back({gloss, checker.check(*score)});
    if (!options.output.empty())
      if (auto drawn = draw_worst(options, *body, session.stage(), *score, **signer, all.back()); !drawn) return drawn;
    progress.update(static_cast<int64_t>(all.size()));
  }
  if (auto printed = print(options.json ? as_json(all) : as_text(all)); !printed) return printed;
  const auto bad = std::ranges::count_if(all, [](const Checked& entry) { return !entry.verdict.good(); });
  if (bad == 0) return {};
  return fail(ErrorCode::kMalformed, std::to_string(bad) + " of " + std::to_string(all.size()) +
                                         " entries are outside the limits; `auslanjam check --picture FOLDER` draws "
                                         "the worst moment of each");
}

}  // namespace auslan
