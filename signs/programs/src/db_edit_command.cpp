// SPDX-License-Identifier: Apache-2.0
// `db`, as far as it writes or compares: build, export, import, review, diff, migrate.
#include "commands.h"
#include "lexicon/lexicon_compare.h"
#include "lexicon/lexicon_edit.h"
#include "phonology/vocabulary.h"
#include "session.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace auslan {
namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// A folder of text, or a database.
Result<LexiconText> lexicon_at(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return read_lexicon_text(path);
  const Result<Lexicon> lexicon = Lexicon::open(path);
  if (!lexicon) return tl::unexpected(lexicon.error());
  return lexicon->read_all();
}

/// What is written to has to be named: the built-in lexicon is made anew with every build.
Result<LexiconEditor> editor(const Options& options) {
  if (options.database.empty())
    return fail(ErrorCode::kUsage,
                "name the database to write with --db FILE; `auslanjam db build assets/lexicon -o FILE` makes one");
  Result<LexiconEditor> opened = LexiconEditor::open(options.database);
  if (opened && opened->opened_version() != kLexiconSchemaVersion)
    remark(options, options.database + " had the schema " + std::to_string(opened->opened_version()) +
                        " and has been brought to " + std::to_string(kLexiconSchemaVersion));
  return opened;
}

std::string today() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[16];
  return std::strftime(text, sizeof text, "%Y-%m-%d", &utc) > 0 ? std::string(text) : std::string();
}

/// "HURT", "handshape:flat", "phrase:ID" as the lexicon names them. Letters and numbers have a colon of their own.
std::string entry_of(const std::string& word) {
  for (const std::string_view kind : {"handshape:", "phrase:"})
    if (word.starts_with(kind)) return std::string(kind.substr(0, kind.size() - 1)) + " " + word.substr(kind.size());
  if (word.starts_with("fs:") || word.starts_with("num:")) return word;
  std::string gloss = word;
  std::ranges::transform(gloss, gloss.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return gloss;
}

Json change_json(const EntryChange& change) {
  return {{"entry", change.entry}, {"change", to_name(change.kind)}, {"lines", change.lines}};
}

std::string change_text(const EntryChange& change) {
  std::string text = change.entry + " " + std::string(to_name(change.kind)) + "\n";
  for (const std::string& line : change.lines)
    text += "  " + line + "\n";
  return text;
}

Result<void> build(const Options& options) {
  const std::filesystem::path folder = options.words.front();
  const std::vector<Error> problems = check_lexicon_text(folder);
  for (const Error& problem : problems)
    remark(options, to_string(problem));
  if (!problems.empty())
    return fail(ErrorCode::kMalformed,
                "the text has " + std::to_string(problems.size()) + " problems; nothing was written", folder.string());
  const Result<LexiconText> text = read_lexicon_text(folder);
  if (!text) return tl::unexpected(text.error());
  if (Result<void> written = build_database(*text, options.output); !written) return written;
  remark(options, options.output + ": " + std::to_string(text->signs.size()) + " signs, letters and numbers, " +
                      std::to_string(text->phrases.size()) + " phrases");
  return {};
}

Result<void> export_text(const Options& options) {
  Session session(options);
  const auto lexicon = session.lexicon();
  if (!lexicon) return tl::unexpected(lexicon.error());
  const Result<LexiconText> text = (*lexicon)->read_all();
  if (!text) return tl::unexpected(text.error());
  if (Result<void> saved = save_lexicon_text(*text, options.output); !saved) return saved;
  remark(options, options.output + ": the text of " + std::to_string(text->signs.size()) +
                      " signs, letters and numbers, " + std::to_string(text->phrases.size()) + " phrases");
  return {};
}

Result<void> import(const Options& options) {
  const Result<LexiconText> theirs = lexicon_at(options.words.front());
  if (!theirs) return tl::unexpected(theirs.error());
  Result<LexiconEditor> lexicon = editor(options);
  if (!lexicon) return tl::unexpected(lexicon.error());
  const Result<LexiconText> ours = lexicon->read_all();
  if (!ours) return tl::unexpected(ours.error());
  const OnConflict on_conflict = options.conflicts == "theirs" ? OnConflict::kTakeTheirs
                                 : options.conflicts == "ours" ? OnConflict::kKeepOurs
                                                               : OnConflict::kRefuse;
  const LexiconMerge merge = merge_lexicons(*ours, *theirs, on_conflict);
  const bool refused = on_conflict == OnConflict::kRefuse && !merge.conflicts.empty();
  if (options.json) {
    Json json = {{"added", merge.added}, {"reviewed", merge.reviewed}, {"conflicts", Json::array()}};
    for (const EntryChange& conflict : merge.conflicts)
      json["conflicts"].push_back(change_json(conflict));
    json["written"] = !refused;
    if (auto printed = print(dump(json)); !printed) return printed;
  } else {
    std::string text;
    for (const EntryChange& conflict : merge.conflicts)
      text += change_text(conflict);
    if (auto printed = print(text); !printed) return printed;
  }
  if (refused)
    return fail(ErrorCode::kMalformed,
                std::to_string(merge.conflicts.size()) +
                    " entries say different things here and there (listed above: - here, + there); nothing was "
                    "written. --conflicts ours keeps what is here, --conflicts theirs takes what is there");
  if (Result<void> done = lexicon->replace(merge.merged); !done) return done;
  if (Result<void> done = lexicon->close(); !done) return done;
  remark(options, std::to_string(merge.added.size()) + " entries added, " + std::to_string(merge.reviewed.size()) +
                      " with new reviews, " + std::to_string(merge.conflicts.size()) + " conflicts" +
                      (merge.conflicts.empty()         ? ""
                       : options.conflicts == "theirs" ? ", theirs taken"
                                                       : ", ours kept"));
  return {};
}

Result<void> review(const Options& options) {
  Result<LexiconEditor> lexicon = editor(options);
  if (!lexicon) return tl::unexpected(lexicon.error());
  Review said;
  said.by = options.reviewer;
  said.on = options.reviewed_on.empty() ? today() : options.reviewed_on;
  said.verdict = from_name<ReviewState>(options.verdict).value_or(ReviewState::kUnreviewed);
  said.remark = options.remark;
  const std::string entry = entry_of(options.words.front());
  if (Result<void> done = lexicon->review(entry, said); !done) return done;
  if (Result<void> done = lexicon->close(); !done) return done;
  remark(options, entry + " is " + options.verdict + " by " + said.by + " on " + said.on +
                      "; `auslanjam db export --db " + options.database + " -o FOLDER` writes the text");
  return {};
}

Result<void> diff(const Options& options) {
  const Result<LexiconText> before = lexicon_at(options.words[0]);
  if (!before) return tl::unexpected(before.error());
  const Result<LexiconText> after = lexicon_at(options.words[1]);
  if (!after) return tl::unexpected(after.error());
  const std::vector<EntryChange> changes = compare_lexicons(*before, *after);
  if (options.json) {
    Json json = Json::array();
    for (const EntryChange& change : changes)
      json.push_back(change_json(change));
    return print(dump(json));
  }
  std::string text;
  for (const EntryChange& change : changes)
    text += change_text(change);
  if (auto printed = print(text); !printed) return printed;
  remark(options, changes.empty() ? "both say the same" : std::to_string(changes.size()) + " entries differ");
  return {};
}

Result<void> migrate(const Options& options) {
  Options named = options;
  named.database = options.words.front();
  Result<LexiconEditor> lexicon = editor(named);
  if (!lexicon) return tl::unexpected(lexicon.error());
  if (lexicon->opened_version() == kLexiconSchemaVersion) remark(options, "it is up to date");
  return lexicon->close();
}

}  // namespace

Result<void> run_db_edit(const Options& options) {
  switch (options.command) {
    case Command::kDbBuild:
      return build(options);
    case Command::kDbExport:
      return export_text(options);
    case Command::kDbImport:
      return import(options);
    case Command::kDbReview:
      return review(options);
    case Command::kDbMigrate:
      return migrate(options);
    default:
      return diff(options);
  }
}

}  // namespace auslan
