// SPDX-License-Identifier: Apache-2.0
#include "lexicon/lexicon_text.h"

#include "kinematics/whole_file.h"
#include "lexicon/lexicon_check.h"
#include "read_entry.h"
#include "table_reader.h"
#include "text_bounds.h"

#include <algorithm>
#include <exception>

namespace auslan {
namespace {

constexpr std::string_view kSignsFolder = "signs/";
constexpr std::string_view kSuffix = ".toml";

enum class FileKind { kHandshapes, kLetters, kNumbers, kSigns, kPhrases, kUnknown };

FileKind kind_of(std::string_view name) {
  if (name == "handshapes.toml") return FileKind::kHandshapes;
  if (name == "alphabet.toml") return FileKind::kLetters;
  if (name == "numbers.toml") return FileKind::kNumbers;
  if (name == "phrases.toml") return FileKind::kPhrases;
  if (name.starts_with(kSignsFolder) && name.ends_with(kSuffix)) return FileKind::kSigns;
  return FileKind::kUnknown;
}

/// The arrays that a kind of file holds, and what reads their entries.
void read_root(const toml::table& root, FileKind kind, std::string_view name, ProblemList& problems, LexiconText& text,
               Places& places) {
  TableReader reader(root, "file", problems);
  const auto each = [&](std::string_view key, auto&& read) {
    for (const toml::table* table : reader.tables(key, Need::kRequired)) {
      TableReader entry(*table, std::string(key), problems);
      read(entry);
    }
  };
  switch (kind) {
    case FileKind::kHandshapes:
      each("handshape", [&](TableReader& entry) { read_handshape(entry, text, places); });
      break;
    case FileKind::kLetters:
      each("letter", [&](TableReader& entry) { read_sign(entry, "letter", "alphabet", text, places); });
      break;
    case FileKind::kNumbers:
      each("number", [&](TableReader& entry) { read_sign(entry, "number", "numbers", text, places); });
      break;
    case FileKind::kSigns: {
      const std::string_view category =
          name.substr(kSignsFolder.size(), name.size() - kSignsFolder.size() - kSuffix.size());
      each("sign", [&](TableReader& entry) { read_sign(entry, "sign", category, text, places); });
      break;
    }
    case FileKind::kPhrases:
      each("phrase", [&](TableReader& entry) { read_phrase(entry, text, places); });
      break;
    case FileKind::kUnknown:
      problems.add(1,
                   "not a file of the lexicon; expected handshapes.toml, alphabet.toml, numbers.toml, phrases.toml or "
                   "signs/CATEGORY.toml");
      return;
  }
  reader.finish();
}

void read_source(const TextSource& source, ProblemList& problems, LexiconText& text, Places& places) {
  try {
    const toml::table root = toml::parse(std::string_view(source.text), source.name);
    read_root(root, kind_of(source.name), source.name, problems, text, places);
  } catch (const toml::parse_error& error) {
    problems.add(static_cast<long>(error.source().begin.line), "not TOML: " + std::string(error.description()));
  } catch (const std::exception& error) {
    problems.add(1, std::string("cannot be read: ") + error.what());
  }
}

/// Gives the findings of check_lexicon the lines that the reader noted.
void place_findings(const LexiconText& text, const Places& places, std::span<const TextSource> sources,
                    std::vector<Problem>& problems) {
  for (Finding& finding : check_lexicon(text)) {
    Places::Place place;
    if (const auto entry = places.of_entry.find(finding.entry); entry != places.of_entry.end()) {
      // The part itself, or the key it is an element of, or the entry.
      const std::string key = finding.part.substr(0, finding.part.find('['));
      for (const std::string& part : {finding.part, key, std::string()}) {
        if (const auto found = entry->second.find(part); found != entry->second.end()) {
          place = found->second;
          break;
        }
      }
    }
    ProblemList list(problems, place.file, place.file < sources.size() ? sources[place.file].name : "");
    const std::string part = finding.part.empty() ? "" : " " + finding.part;
    list.add(place.line, finding.entry + part + ": " + finding.message);
  }
}

std::string in_folder(const std::filesystem::path& folder, const std::string& place) {
  return (folder / place).string();
}

}  // namespace

LexiconReading parse_lexicon_text(std::span<const TextSource> sources) {
  LexiconReading reading;
  std::vector<Problem> problems;
  Places places;
  for (size_t i = 0; i < sources.size() && i < kMaxSourceFiles; ++i) {
    ProblemList list(problems, i, sources[i].name);
    if (std::optional<Error> broken = find_broken_bound(sources[i]); broken)
      problems.push_back({i, 0, std::move(*broken)});
    else
      read_source(sources[i], list, reading.text, places);
  }
  if (sources.size() > kMaxSourceFiles)
    problems.push_back(
        {kMaxSourceFiles, 0, {ErrorCode::kLimit, "more than " + std::to_string(kMaxSourceFiles) + " files", ""}});
  place_findings(reading.text, places, sources, problems);
  std::ranges::stable_sort(problems, [](const Problem& a, const Problem& b) {
    return a.file != b.file ? a.file < b.file : a.line < b.line;
  });
  for (Problem& problem : problems)
    reading.problems.push_back(std::move(problem.error));
  return reading;
}

Result<std::vector<TextSource>> load_lexicon_sources(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_directory(folder, error))
    return fail(ErrorCode::kNotFound, "not a folder; expected the folder with handshapes.toml, as assets/lexicon",
                folder.string());
  std::vector<std::string> names = {"handshapes.toml", "alphabet.toml", "numbers.toml"};
  std::vector<std::string> signs;
  for (fs::directory_iterator it(folder / "signs", error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.ends_with(kSuffix) && !name.starts_with(".")) signs.push_back(std::string(kSignsFolder) + name);
    if (signs.size() > kMaxSourceFiles)
      return fail(ErrorCode::kLimit, "more than 256 files", (folder / "signs").string());
  }
  if (error)
    return fail(ErrorCode::kUnreadable, "cannot list it (" + error.message() + ")", (folder / "signs").string());
  std::ranges::sort(signs);
  names.insert(names.end(), signs.begin(), signs.end());
  names.push_back("phrases.toml");
  std::vector<TextSource> sources;
  for (const std::string& name : names) {
    Result<std::string> bytes = read_whole_file(folder / name, kMaxSourceBytes);
    if (!bytes) return tl::unexpected(bytes.error());
    sources.push_back({name, std::move(*bytes)});
  }
  return sources;
}

std::vector<Error> check_lexicon_text(const std::filesystem::path& folder) {
  Result<std::vector<TextSource>> sources = load_lexicon_sources(folder);
  if (!sources) return {sources.error()};
  std::vector<Error> problems = parse_lexicon_text(*sources).problems;
  for (Error& problem : problems)
    if (!problem.place.empty()) problem.place = in_folder(folder, problem.place);
  return problems;
}

Result<LexiconText> read_lexicon_text(const std::filesystem::path& folder) {
  Result<std::vector<TextSource>> sources = load_lexicon_sources(folder);
  if (!sources) return tl::unexpected(sources.error());
  LexiconReading reading = parse_lexicon_text(*sources);
  if (reading.problems.empty()) return std::move(reading.text);
  Error first = reading.problems.front();
  if (!first.place.empty()) first.place = in_folder(folder, first.place);
  if (reading.problems.size() > 1)
    first.message +=
        " (and " + std::to_string(reading.problems.size() - 1) + " more; check the lexicon to see them all)";
  return tl::unexpected(std::move(first));
}

}  // namespace auslan
