// SPDX-License-Identifier: Apache-2.0
#include "lexicon/lexicon.h"

#include "database_read.h"
#include "examine.h"
#include "phonology/vocabulary.h"
#include "schema.h"
#include "statement.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <tuple>

namespace auslan {
namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string lowered(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), lower);
  return out;
}

/// What the index of words is asked for: every word of the text, the last one also as a beginning; empty where the text
/// has no words.
std::string words_query(std::string_view text) {
  std::string query, word;
  const auto end_word = [&] {
    if (!word.empty()) query += (query.empty() ? "\"" : " \"") + word + '"';
    word.clear();
  };
  for (const char c : text) {
    const bool part = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
    if (part)
      word += c;
    else
      end_word();
  }
  end_word();
  return query.empty() ? query : query + "*";
}

/// What the index of parts is asked for: the text as it is; empty below the three letters that it goes by.
std::string part_query(std::string_view text) {
  if (text.size() < 3) return {};
  std::string query = "\"";
  for (const char c : text)
    query += c == '"' ? std::string("\"\"") : std::string(1, c);
  return query + '"';
}

/// 0 equal, 1 begins, 2 contains, 3 not found.
int match_rank(std::string_view text, std::string_view wanted) {
  const std::string low = lowered(text);
  const size_t at = low.find(wanted);
  if (at == std::string::npos) return 3;
  if (at > 0) return 2;
  return low.size() == wanted.size() ? 0 : 1;
}

/// How a sign that was found matches: the best of `words`, its gloss and keywords, a line each.
SearchHit hit_of(SignSummary sign, std::string_view words, std::string_view wanted) {
  SearchHit hit;
  hit.rank = 3;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find('\n'));
    words.remove_prefix(std::min(words.size(), word.size() + 1));
    if (const int rank = match_rank(word, wanted); rank < hit.rank) {
      hit.matched = word;
      hit.rank = rank;
    }
  }
  if (hit.rank == 3) {
    const bool defined = match_rank(sign.definition, wanted) < 3;
    // Otherwise found by another form of its words; which of them is not told.
    hit.matched = defined ? sign.definition : sign.gloss;
    hit.rank = defined ? 3 : 2;
  }
  hit.sign = std::move(sign);
  return hit;
}

}  // namespace

struct Lexicon::State {
  std::string place;  ///< of the file, for what goes wrong in it
  Database db;
  std::vector<Keyword> keywords;
  std::vector<Phrase> phrases;
  std::vector<Finding> damaged;
  int batches = 0;

  template <typename T>
  Result<T> in_file(Result<T> result) const {
    if (!result && result.error().place.empty()) result.error().place = place;
    return result;
  }

  /// The signs that one of the full-text indices finds.
  Result<std::vector<SearchHit>> find(std::string_view index, const std::string& query, std::string_view wanted) const;
};

Result<std::vector<SearchHit>> Lexicon::State::find(std::string_view index, const std::string& query,
                                                    std::string_view wanted) const {
  std::vector<SearchHit> hits;
  if (query.empty()) return hits;
  const std::string table(index);
  Result<std::vector<std::string>> found =
      read_names(db.get(), "SELECT words FROM " + table + " WHERE " + table + " MATCH ?1", query);
  if (!found) return tl::unexpected(found.error());
  for (const std::string& words : *found) {
    const std::string gloss = words.substr(0, words.find('\n'));
    Result<std::optional<SignSummary>> sign = read_summary(db.get(), gloss);
    if (!sign) return tl::unexpected(sign.error());
    if (!*sign) return fail(ErrorCode::kMalformed, "the full-text index names " + gloss + ", which is not there");
    hits.push_back(hit_of(std::move(**sign), words, wanted));
  }
  return hits;
}

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
  distrust(raw, &state->batches);
  const auto placed = [&path](Error problem) {
    problem.place = path.string();
    return tl::unexpected(std::move(problem));
  };
  // One transaction: the file is locked once, and what is read is of one state.
  if (Result<void> begun = execute(raw, "BEGIN"); !begun) return placed(begun.error());
  if (Result<void> good = examine(raw); !good) return placed(good.error());
  Result<std::vector<Keyword>> keywords = read_keyword_rows(raw, KeywordOrder::kWord, state->damaged);
  if (!keywords) return placed(keywords.error());
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
  if (Result<void> done = execute(raw, "COMMIT"); !done) return placed(done.error());
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
    const auto users =
        state_->in_file(read_names(db, "SELECT DISTINCT gloss FROM posture WHERE location = ?1 OR contact_target = ?1",
                                   to_name(*filter.location)));
    if (!users) return tl::unexpected(users.error());
    keep_only(*users);
  }
  if (filter.movement) {
    const auto users = state_->in_file(
        read_names(db, "SELECT DISTINCT gloss FROM movement WHERE kind = ?1", to_name(*filter.movement)));
    if (!users) return tl::unexpected(users.error());
    keep_only(*users);
  }
  std::erase_if(*all, [&filter](const SignSummary& sign) {
    return (!filter.kind.empty() && sign.kind != filter.kind) ||
           (!filter.category.empty() && sign.category != filter.category) ||
           (!filter.region.empty() && sign.region != filter.region) ||
           (filter.review && sign.review != *filter.review) ||
           (filter.handedness && sign.handedness != *filter.handedness);
  });
  return all;
}

Result<std::vector<SearchHit>> Lexicon::search(std::string_view text) const {
  state_->batches = 0;
  const std::string wanted = lowered(text);
  Result<std::vector<SearchHit>> hits = state_->find(kWordIndex, words_query(wanted), wanted);
  if (hits && hits->empty()) hits = state_->find(kPartIndex, part_query(wanted), wanted);
  if (!hits) return state_->in_file(std::move(hits));
  std::ranges::sort(*hits, {}, [](const SearchHit& hit) { return std::tie(hit.rank, hit.sign.gloss); });
  return hits;
}

Result<LexiconCounts> Lexicon::counts() const {
  const Result<LexiconText> text = read_all();
  if (!text) return tl::unexpected(text.error());
  LexiconCounts counts;
  for (const Handshape& shape : text->handshapes) {
    ++counts.handshapes;
    counts.base_handshapes += shape.base == shape.id ? 1 : 0;
    counts.core_handshapes += shape.core ? 1 : 0;
  }
  counts.keywords = static_cast<int>(text->keywords.size());
  counts.phrases = static_cast<int>(text->phrases.size());
  const auto tally = [&counts](const Provenance& provenance) {
    if (provenance.review == ReviewState::kReviewed) ++counts.reviewed;
    if (provenance.review == ReviewState::kRejected) ++counts.rejected;
  };
  for (const Sign& sign : text->signs) {
    ++(sign.kind == "letter" ? counts.letters : sign.kind == "number" ? counts.numbers : counts.signs);
    tally(sign.provenance);
    counts.safety_critical += sign.safety_critical ? 1 : 0;
    ++counts.regions[sign.region];
    ++counts.confidences[std::string(to_name(sign.provenance.confidence))];
    const std::string& evidence = sign.provenance.movement_evidence;
    ++counts.movement_evidence[evidence.substr(0, evidence.find_first_of(":; "))];
    for (const std::string& source : sign.provenance.sources)
      ++counts.sources[source];
  }
  for (const Phrase& phrase : text->phrases)
    tally(phrase.provenance);
  return counts;
}

Result<LexiconText> Lexicon::read_all() const {
  state_->batches = 0;
  return state_->in_file(read_lexicon_rows(state_->db.get()));
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
  std::vector<Finding> damaged_keywords;  // told by open() already
  Result<std::vector<Keyword>> keywords = read_keyword_rows(db, KeywordOrder::kText, damaged_keywords);
  if (keywords)
    text.keywords = std::move(*keywords);
  else
    findings.push_back({"keyword", "", keywords.error().message});
  text.phrases = state_->phrases;
  for (Finding& finding : check_lexicon(text))
    findings.push_back(std::move(finding));
  return findings;
}

}  // namespace auslan
