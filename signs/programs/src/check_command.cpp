// SPDX-License-Identifier: Apache-2.0
// `check`: entries and phrases of the lexicon performed on the figure and held against the limits of the project, and
// against the list of what is known to break them.
#include "check/check.h"
#include "check/exceptions.h"
#include "check_report.h"
#include "commands.h"
#include "data_files.h"
#include "frame_maker.h"
#include "kinematics/whole_file.h"
#include "media/picture.h"
#include "progress.h"
#include "session.h"
#include "stop_request.h"
#include "synthesis/choreography.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace auslan {
namespace {

constexpr std::string_view kPhrase = "phrase:";
constexpr uint64_t kLargestList = 16'000'000;

struct Subject {
  std::string name;
  Utterance utterance;
};

/// A phrase with something in its slots.
std::string filled(std::string english) {
  for (const auto& [slot, word] : {std::pair<std::string_view, std::string_view>{"{NAME}", "Kim"},
                                   {"{NUMBER}", "5"},
                                   {"{TIME}", "3"},
                                   {"{WORD}", "Kim"}}) {
    for (size_t at = english.find(slot); at != std::string::npos; at = english.find(slot))
      english.replace(at, slot.size(), word);
  }
  return english;
}

Result<std::vector<Subject>> subjects_of(Session& session, const Options& options) {
  const auto lexicon = session.lexicon();
  if (!lexicon) return tl::unexpected(lexicon.error());
  std::vector<std::string> names = options.words;
  if (names.empty()) {
    const auto entries = (*lexicon)->list();
    if (!entries) return tl::unexpected(entries.error());
    for (const SignSummary& entry : *entries)
      names.push_back(entry.gloss);
    for (const Phrase& phrase : (*lexicon)->phrases())
      names.push_back(std::string(kPhrase) + phrase.id);
  }
  std::vector<Subject> subjects;
  for (const std::string& name : names) {
    Result<Utterance> utterance;
    if (name.starts_with(kPhrase)) {
      const auto& phrases = (*lexicon)->phrases();
      const auto phrase = std::ranges::find(phrases, name.substr(kPhrase.size()), &Phrase::id);
      if (phrase == phrases.end())
        return fail(ErrorCode::kNotFound, "the lexicon has no phrase " + name.substr(kPhrase.size()));
      utterance = session.utterance_of_text(filled(phrase->english));
    } else {
      utterance = session.utterance_of(name);
    }
    if (!utterance) return tl::unexpected(utterance.error());
    subjects.push_back({name, std::move(*utterance)});
  }
  return subjects;
}

double trouble_of(const Score& score) {
  double most = 0.0;
  for (const auto& side : score.targets)
    for (const HandTarget& target : side)
      most = std::max(most, target.trouble);
  return most;
}

/// All of them, `threads` at a time; in their own order, whatever the number.
Result<std::vector<Checked>> check_all(const Signer& signer, const std::vector<Subject>& subjects, int threads,
                                       bool quiet) {
  const Checker checker(signer);
  std::vector<Checked> all(subjects.size());
  std::vector<std::optional<Error>> errors(subjects.size());
  std::atomic<size_t> next{0};
  std::mutex showing;
  int64_t done = 0;
  Progress progress("checking", static_cast<int64_t>(subjects.size()), quiet);
  const auto work = [&] {
    for (size_t i = next++; i < subjects.size() && !stop_requested(); i = next++) {
      const auto score = choreograph(signer, subjects[i].utterance);
      if (score) {
        all[i] = {subjects[i].name, checker.check(*score), trouble_of(*score)};
      } else {
        errors[i] = score.error();
      }
      const std::lock_guard lock(showing);
      progress.update(++done);
    }
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < threads; ++i)
    others.emplace_back(work);
  work();
  others.clear();
  if (stop_requested()) return stopped();
  for (const auto& error : errors)
    if (error) return tl::unexpected(*error);
  return all;
}

/// The list that goes with what is checked: that of the command line, else for the built-in figure and lexicon the one
/// that lies beside them.
Result<std::vector<CheckException>> known_exceptions(const Options& options) {
  const bool built_in = options.avatar.empty() && options.database.empty() && options.detail == "normal";
  if (options.exceptions.empty() && !built_in) return std::vector<CheckException>();
  const std::filesystem::path path =
      options.exceptions.empty() ? data_file("check_exceptions.txt") : std::filesystem::path(options.exceptions);
  const auto text = read_whole_file(path, kLargestList);
  if (!text) return tl::unexpected(text.error());
  return read_exceptions(*text, path.string());
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
                 entry.subject + ", " + std::string(info(*measure).name) + ": " + in_words(*measure, found), style);
  std::string name = entry.subject;
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
  const auto exceptions = known_exceptions(options);
  if (!exceptions) return tl::unexpected(exceptions.error());
  const auto subjects = subjects_of(session, options);
  if (!subjects) return tl::unexpected(subjects.error());
  if (!options.output.empty()) {
    std::error_code failed;
    std::filesystem::create_directories(options.output, failed);
    if (failed) return fail(ErrorCode::kUnwritable, "cannot make the folder " + options.output);
  }
  auto all = check_all(**signer, *subjects, options.threads, options.quiet);
  if (!all) return tl::unexpected(all.error());
  CheckReport report;
  report.all = std::move(*all);
  report.exceptions = exceptions->size();
  report.findings = compare(report.all, *exceptions, options.words.empty());
  report.figure = options.avatar;
  report.lacks = session.figure_lacks();
  if (const auto beyond = out_of_reach(report.all)) report.lacks.push_back(*beyond);
  report.each = !options.words.empty();
  for (size_t i = 0; i < report.all.size() && !options.output.empty(); ++i) {
    if (stop_requested()) return stopped();
    if (report.all[i].verdict.good()) continue;
    const auto score = choreograph(**signer, (*subjects)[i].utterance);
    if (!score) return tl::unexpected(score.error());
    if (auto drawn = draw_worst(options, *body, session.stage(), *score, **signer, report.all[i]); !drawn) return drawn;
  }
  if (auto printed = print(options.json ? as_json(report) : as_text(report)); !printed) return printed;
  if (!options.write_exceptions.empty())
    return write_whole_file(options.write_exceptions, write_exceptions(exceptions_for(report.all, *exceptions)));
  if (report.findings.empty()) return {};
  return fail(ErrorCode::kMalformed, std::to_string(report.findings.size()) + " findings beside " +
                                         std::to_string(report.exceptions) +
                                         " listed exceptions; `auslanjam check --picture FOLDER` draws the worst "
                                         "moment of each entry, `--write-exceptions FILE` lists them anew");
}

}  // namespace auslan
