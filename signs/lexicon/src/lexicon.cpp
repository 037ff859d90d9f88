// SPDX-License-Identifier: Apache-2.0
#include "lexicon/lexicon.h"

#include "database_read.h"
#include "phonology/vocabulary.h"
#include "schema.h"
#include "statement.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace auslan {
namespace {

constexpr std::string_view kRebuild = "rebuild it: auslan-lexicon-build assets/lexicon -o lexicon.sqlite";
// Far more than any read of a sound lexicon takes; a damaged or hostile file ends here.
constexpr int kMaxBatches = 2000;
constexpr int kOpsPerBatch = 100000;

std::string advice(const std::string& what) {
  return what + "; " + std::string(kRebuild);
}

Result<int> read_pragma(sqlite3* db, std::string_view sql) {
  Result<Statement> statement = Statement::prepare(db, sql);
  if (!statement) return tl::unexpected(statement.error());
  const Result<bool> row = statement->step();
  if (!row) return tl::unexpected(row.error());
  const int value = *row ? statement->integer(0, INT32_MIN, INT32_MAX) : 0;
  return value;
}

Result<std::string> read_one_text(sqlite3* db, std::string_view sql, std::string_view parameter) {
  Result<std::vector<std::string>> rows = read_names(db, sql, parameter);
  if (!rows) return tl::unexpected(rows.error());
  return rows->empty() ? std::string() : rows->front();
}

/// Ours, of this version, whole, and with the tables exactly as this program makes them: what is read afterwards can
/// then be no view, and obeys the CHECKs unless bytes were changed behind SQLite's back.
Result<void> examine(sqlite3* db) {
  const Result<int> id = read_pragma(db, "PRAGMA application_id");
  if (!id) return fail(ErrorCode::kMalformed, advice("not a database, or a damaged one"));
  if (*id != kLexiconApplicationId) return fail(ErrorCode::kMalformed, advice("not a lexicon of this program"));
  const Result<int> version = read_pragma(db, "PRAGMA user_version");
  if (!version || *version != kLexiconSchemaVersion)
    return fail(ErrorCode::kUnsupported, advice("a lexicon of another version (" + std::to_string(version.value_or(0)) +
                                                ", this program reads " + std::to_string(kLexiconSchemaVersion) + ")"));
  const Result<std::vector<std::string>> check = read_names(db, "SELECT quick_check FROM pragma_quick_check(1)");
  if (!check || *check != std::vector<std::string>{"ok"})
    return fail(ErrorCode::kMalformed, advice("the lexicon is damaged"));
  for (const TableSchema& table : lexicon_tables()) {
    const Result<std::string> sql =
        read_one_text(db, "SELECT sql FROM sqlite_schema WHERE type = 'table' AND name = ?1", table.name);
    if (!sql || *sql != table.sql)
      return fail(ErrorCode::kMalformed,
                  advice("the table " + std::string(table.name) + " is missing or not as this program makes it"));
  }
  return {};
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string lowered(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), lower);
  return out;
}

/// 0 equal, 1 begins, 2 contains, 3 not found.
int match_rank(std::string_view text, std::string_view wanted) {
  const std::string low = lowered(text);
  const size_t at = low.find(wanted);
  if (at == std::string::npos) return 3;
  if (at > 0) return 2;
  return low.size() == wanted.size() ? 0 : 1;
}

}  // namespace

struct Lexicon::State {
  std::string place;  ///< of the file, for what goes wrong in it
  Database db;
  std::vector<Keyword> keywords;
  std::vector<Keyword> keywords_in_text_order;
  std::vector<Phrase> phrases;
  std::vector<Finding> damaged;
  int batches = 0;

  template <typename T>
  Result<T> in_file(Result<T> result) const {
    if (!result && result.error().place.empty()) result.error().place = place;
    return result;
  }
};

Lexicon::Lexicon(std::unique_ptr<State> state) : state_(std::move(state)) {}
Lexicon::Lexicon(Lexicon&&) noexcept = default;
Lexicon& Lexicon::operator=(Lexicon&&) noexcept = default;
Lexicon::~Lexicon() = default;

Result<Lexicon> Lexicon::open(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return fail(ErrorCode::kNotFound, advice("the lexicon is not there"), path.string());
  if (!std::filesystem::is_regular_file(status))
    return fail(ErrorCode::kUnreadable, advice("the lexicon is not a file"), path.string());
  Result<Database> db = open_database(path, SQLITE_OPEN_READONLY | SQLITE_OPEN_FULLMUTEX);
  if (!db) return tl::unexpected(db.error());
  auto state = std::make_unique<State>();
  state->place = path.string();
  state->db = std::move(*db);
  sqlite3* raw = state->db.get();
  sqlite3_db_config(raw, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_limit(raw, SQLITE_LIMIT_LENGTH, 1 << 20);
  sqlite3_busy_timeout(raw, 2000);
  int* batches = &state->batches;
  sqlite3_progress_handler(
      raw, kOpsPerBatch, [](void* count) { return ++*static_cast<int*>(count) > kMaxBatches ? 1 : 0; }, batches);
  const auto placed = [&path](Error problem) {
    problem.place = path.string();
    return tl::unexpected(std::move(problem));
  };
  if (Result<void> good = examine(raw); !good) return placed(good.error());
  Result<std::vector<Keyword>> keywords = read_keyword_rows(raw, state->damaged);
  if (!keywords) return placed(keywords.error());
  state->keywords_in_text_order = *keywords;
  std::ranges::sort(*keywords, {},
                    [](const Keyword& k) { return std::tie(k.word, k.part_of_speech, k.rank, k.gloss); });
  state->keywords = std::move(*keywords);
  const Result<std::vector<std::string>> ids =
      read_names(raw, "SELECT id FROM phrase WHERE ?1 = '' ORDER BY position", "");
  if (!ids) return placed(ids.error());
  for (const std::string& id : *ids) {
    Result<std::optional<Phrase>> phrase = read_phrase_row(raw, id);
    if (phrase && *phrase)
      state->phrases.push_back(std::move(**phrase));
    else
      state->damaged.push_back({"phrase " + id, "", phrase ? "it cannot be found by its id" : phrase.error().message});
  }
  return Lexicon(std::move(state));
}

Result<std::optional<Sign>> Lexicon::sign(std::string_view gloss) const {
  state_->batches = 0;
  return state_->in_file(read_sign_row(state_->db.get(), gloss));
}

Result<std::optional<Sign>> Lexicon::letter(char letter) const {
  const char capital = letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
  return sign(std::string("fs:") + capital);
}

Result<std::optional<Sign>> Lexicon::number(long long value) const {
  if (value < 0) return std::optional<Sign>();
  return sign("num:" + std::to_string(value));
}

Result<std::optional<Handshape>> Lexicon::handshape(std::string_view id) const {
  state_->batches = 0;
  return state_->in_file(read_handshape_row(state_->db.get(), id));
}

const std::vector<Finding>& Lexicon::damaged() const {
  return state_->damaged;
}
const std::vector<Keyword>& Lexicon::keywords() const {
  return state_->keywords;
}
const std::vector<Phrase>& Lexicon::phrases() const {
  return state_->phrases;
}

Result<std::vector<Handshape>> Lexicon::handshapes() const {
  state_->batches = 0;
  const Result<std::vector<std::string>> ids =
      state_->in_file(read_names(state_->db.get(), "SELECT id FROM handshape WHERE ?1 = '' ORDER BY position", ""));
  if (!ids) return tl::unexpected(ids.error());
  std::vector<Handshape> shapes;
  for (const std::string& id : *ids) {
    Result<std::optional<Handshape>> shape = handshape(id);
    if (!shape) return tl::unexpected(shape.error());
    if (*shape) shapes.push_back(std::move(**shape));
  }
  return shapes;
}

Result<std::vector<SignSummary>> Lexicon::list(const ListFilter& filter) const {
  state_->batches = 0;
  sqlite3* db = state_->db.get();
  Result<std::vector<SignSummary>> all = state_->in_file(read_summaries(db));
  if (!all) return all;
  const auto keep_only = [&all](const std::vector<std::string>& glosses) {
    const std::set<std::string> kept(glosses.begin(), glosses.end());
    std::erase_if(*all, [&kept](const SignSummary& sign) { return !kept.contains(sign.gloss); });
  };
  if (!filter.handshape.empty()) {
    const auto users =
        state_->in_file(read_names(db, "SELECT DISTINCT gloss FROM posture WHERE handshape = ?1", filter.handshape));
    if (!users) return tl::unexpected(users.error());
    keep_only(*users);
  }
  if (filter.location) {
    const auto users = state_->in_file(
        read_names(db, "SELECT DISTINCT gloss FROM posture WHERE location = ?1", to_name(*filter.location)));
    if (!users) return tl::unexpected(users.error());
    keep_only(*users);
  }
  std::erase_if(*all, [&filter](const SignSummary& sign) {
    return (!filter.kind.empty() && sign.kind != filter.kind) ||
           (!filter.category.empty() && sign.category != filter.category) ||
           (!filter.region.empty() && sign.region != filter.region) || (filter.review && sign.review != *filter.review);
  });
  return all;
}

Result<std::vector<SearchHit>> Lexicon::search(std::string_view text) const {
  Result<std::vector<SignSummary>> all = list();
  if (!all) return tl::unexpected(all.error());
  const std::string wanted = lowered(text);
  std::vector<SearchHit> hits;
  if (wanted.empty()) return hits;
  for (SignSummary& sign : *all) {
    SearchHit hit{{}, sign.gloss, match_rank(sign.gloss, wanted)};
    for (const Keyword& keyword : state_->keywords)
      if (keyword.gloss == sign.gloss && match_rank(keyword.word, wanted) < hit.rank)
        hit = {{}, keyword.word, match_rank(keyword.word, wanted)};
    if (hit.rank == 3) {
      if (match_rank(sign.definition, wanted) == 3) continue;
      hit.matched = sign.definition;
    }
    hit.sign = std::move(sign);
    hits.push_back(std::move(hit));
  }
  std::ranges::sort(hits, {}, [](const SearchHit& hit) { return std::tie(hit.rank, hit.sign.gloss); });
  return hits;
}

Result<LexiconCounts> Lexicon::counts() const {
  Result<std::vector<SignSummary>> all = list();
  if (!all) return tl::unexpected(all.error());
  const Result<std::vector<std::string>> shapes =
      state_->in_file(read_names(state_->db.get(), "SELECT id FROM handshape WHERE ?1 = ''", ""));
  if (!shapes) return tl::unexpected(shapes.error());
  LexiconCounts counts;
  counts.handshapes = static_cast<int>(shapes->size());
  counts.keywords = static_cast<int>(state_->keywords.size());
  counts.phrases = static_cast<int>(state_->phrases.size());
  const auto tally = [&counts](ReviewState review) {
    if (review == ReviewState::kReviewed) ++counts.reviewed;
    if (review == ReviewState::kRejected) ++counts.rejected;
  };
  for (const SignSummary& sign : *all) {
    ++(sign.kind == "letter" ? counts.letters : sign.kind == "number" ? counts.numbers : counts.signs);
    tally(sign.review);
  }
  for (const Phrase& phrase : state_->phrases)
    tally(phrase.provenance.review);
  return counts;
}

Result<LexiconText> Lexicon::read_all() const {
  LexiconText text;
  Result<std::vector<Handshape>> shapes = handshapes();
  if (!shapes) return tl::unexpected(shapes.error());
  text.handshapes = std::move(*shapes);
  Result<std::vector<SignSummary>> all = list();
  if (!all) return tl::unexpected(all.error());
  for (const SignSummary& summary : *all) {
    Result<std::optional<Sign>> entry = sign(summary.gloss);
    if (!entry) return tl::unexpected(entry.error());
    if (*entry) text.signs.push_back(std::move(**entry));
  }
  if (!state_->damaged.empty())
    return fail(ErrorCode::kMalformed, state_->damaged.front().entry + ": " + state_->damaged.front().message);
  text.keywords = state_->keywords_in_text_order;
  text.phrases = state_->phrases;
  return text;
}

std::vector<Finding> Lexicon::check() const {
  std::vector<Finding> findings = state_->damaged;
  LexiconText text;
  sqlite3* db = state_->db.get();
  const auto collect = [&findings, db](std::string_view sql, const std::string& kind, auto&& read) {
    const Result<std::vector<std::string>> names = read_names(db, sql, "");
    if (!names) {
      findings.push_back({kind, "", names.error().message});
      return;
    }
    for (const std::string& name : *names) {
      const Result<void> outcome = read(name);
      if (!outcome) findings.push_back({kind.empty() ? name : kind + " " + name, "", outcome.error().message});
    }
  };
  const auto take = [](auto entry, auto& list) -> Result<void> {
    if (!entry) return tl::unexpected(entry.error());
    if (!*entry) return fail(ErrorCode::kMalformed, "it cannot be found by its name");
    list.push_back(std::move(**entry));
    return {};
  };
  state_->batches = 0;
  collect("SELECT id FROM handshape WHERE ?1 = '' ORDER BY position", "handshape",
          [&](const std::string& id) { return take(handshape(id), text.handshapes); });
  collect("SELECT gloss FROM sign WHERE ?1 = '' ORDER BY position", "",
          [&](const std::string& gloss) { return take(sign(gloss), text.signs); });
  text.keywords = state_->keywords_in_text_order;
  text.phrases = state_->phrases;
  for (Finding& finding : check_lexicon(text))
    findings.push_back(std::move(finding));
  return findings;
}

}  // namespace auslan
