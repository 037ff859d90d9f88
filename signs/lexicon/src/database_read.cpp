// SPDX-License-Identifier: Apache-2.0
#include "database_read.h"

#include "phonology/vocabulary.h"

namespace auslan {
namespace {

constexpr size_t kMaxRows = 100000;
constexpr size_t kMaxParts = 256;

tl::unexpected<Error> damaged(const std::string& entry, const std::string& what) {
  return fail(ErrorCode::kMalformed, entry + " is damaged in the database (" + what + "); rebuild it from the text");
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  if (text.empty()) return parts;
  size_t start = 0;
  while (true) {
    const size_t end = text.find(separator, start);
    parts.push_back(text.substr(start, end == std::string::npos ? end : end - start));
    if (end == std::string::npos) return parts;
    start = end + 1;
  }
}

/// Reads the columns of one row from left to right and remembers whether one was wrong.
class Row {
 public:
  explicit Row(Statement& statement) : statement_(statement) {}
  std::string text() { return statement_.text(column_++); }
  int integer(int least, int most) { return statement_.integer(column_++, least, most); }
  double real() { return statement_.real(column_++); }
  template <typename E>
  E word() {
    const std::optional<E> value = from_name<E>(statement_.text(column_++));
    if (!value) wrong_ = true;
    return value.value_or(E{});
  }
  template <typename E>
  std::optional<E> optional_word() {
    const std::optional<std::string> name = statement_.optional_text(column_++);
    if (!name) return std::nullopt;
    const std::optional<E> value = from_name<E>(*name);
    if (!value) wrong_ = true;
    return value;
  }
  Direction direction() {
    const std::optional<Direction> value = direction_from_name(text());
    if (!value) wrong_ = true;
    return value.value_or(Direction{});
  }
  std::optional<Direction> optional_direction() {
    const std::optional<std::string> name = statement_.optional_text(column_++);
    if (!name) return std::nullopt;
    const std::optional<Direction> value = direction_from_name(*name);
    if (!value) wrong_ = true;
    return value;
  }
  Provenance provenance() {
    Provenance value;
    value.sources = split(text(), ',');
    value.form_evidence = text();
    value.movement_evidence = text();
    value.confidence = word<Confidence>();
    value.review = word<ReviewState>();
    value.reviewed_by = text();
    value.reviewed_on = text();
    return value;
  }
  bool good() const { return !wrong_ && !statement_.damaged(); }

 private:
  Statement& statement_;
  int column_ = 0;
  bool wrong_ = false;
};

/// Calls `take` for each row of a query with one parameter; `take` says whether the row was good.
template <typename Take>
Result<void> each_row(sqlite3* db, std::string_view sql, std::string_view parameter, const std::string& entry,
                      size_t most, Take&& take) {
  Result<Statement> statement = Statement::prepare(db, sql);
  if (!statement) return tl::unexpected(statement.error());
  statement->bind(parameter);
  for (size_t count = 0;; ++count) {
    const Result<bool> more = statement->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    if (count >= most) return damaged(entry, "more parts than an entry may have");
    Row row(*statement);
    if (!take(row) || !row.good()) return damaged(entry, "a value of the wrong type or outside the vocabulary");
  }
}

template <typename Entry>
Result<std::optional<Entry>> whole(Entry entry, std::vector<Finding> findings, const std::string& name) {
  if (!findings.empty()) return damaged(name, findings.front().part + ": " + findings.front().message);
  return std::optional<Entry>(std::move(entry));
}

Result<void> read_history(sqlite3* db, std::string_view kind, const std::string& entry, std::vector<Review>& history) {
  // The kind is one of three words of this file.
  return each_row(db,
                  "SELECT position, reviewer, reviewed_on, verdict, remark, content FROM review WHERE kind = '" +
                      std::string(kind) + "' AND entry = ?1 ORDER BY position",
                  entry, entry, kMaxParts, [&history](Row& row) {
                    const int position = row.integer(0, static_cast<int>(kMaxParts));
                    Review review;
                    review.by = row.text();
                    review.on = row.text();
                    review.verdict = row.word<ReviewState>();
                    review.remark = row.text();
                    review.content = row.text();
                    const bool in_order = static_cast<size_t>(position) == history.size();
                    history.push_back(std::move(review));
                    return in_order;
                  });
}

Result<void> read_postures(sqlite3* db, Sign& sign) {
  return each_row(
      db,
      "SELECT hand, phase, handshape, fingers, palm, location, offset_left, offset_up, offset_away, contact, "
      "contact_part, contact_target FROM posture WHERE gloss = ?1 ORDER BY hand DESC, phase",
      sign.gloss, sign.gloss, kMaxParts, [&sign](Row& row) {
        const std::string hand = row.text();
        std::vector<Posture>& phases = hand == "base" ? sign.non_dominant : sign.dominant;
        const int phase = row.integer(0, 95);
        Posture posture;
        posture.handshape = row.text();
        posture.fingers = row.direction();
        posture.palm = row.direction();
        posture.location = row.word<Location>();
        posture.offset.x = row.real();
        posture.offset.y = row.real();
        posture.offset.z = row.real();
        const std::optional<ContactKind> kind = row.optional_word<ContactKind>();
        const std::optional<HandPart> part = row.optional_word<HandPart>();
        const std::optional<Location> target = row.optional_word<Location>();
        if (kind) posture.contact = Contact{*kind, part, target};
        const bool in_order = static_cast<size_t>(phase) == phases.size();
        phases.push_back(std::move(posture));
        return in_order && (hand == "base" || hand == "dominant");
      });
}

Result<void> read_moves(sqlite3* db, Sign& sign) {
  return each_row(
      db,
      "SELECT kind, direction, size, repeats, hands, manner, plane, bow, start, eighths, ellipse, flattening, "
      "growth, digits, pace, from_phase, to_phase FROM movement "
      "WHERE gloss = ?1 ORDER BY position",
      sign.gloss, sign.gloss, kMaxParts, [&sign](Row& row) {
        Movement move;
        move.kind = row.word<MoveKind>();
        move.direction = row.optional_direction();
        move.size = row.word<Size>();
        move.repeats = row.integer(1, 24);
        move.hands = row.word<MovingHands>();
        move.manner = row.word<Manner>();
        move.plane = row.word<Plane>();
        move.bow = row.optional_direction();
        move.start = row.optional_direction();
        move.eighths = row.integer(1, 64);
        move.ellipse = row.optional_direction();
        move.flattening = row.word<Size>();
        move.growth = row.word<Growth>();
        move.digits = row.text();
        move.pace = row.real();
        move.from = row.integer(0, 95);
        move.to = row.integer(0, 95);
        sign.movements.push_back(move);
        return true;
      });
}

Result<void> read_features(sqlite3* db, Sign& sign) {
  return each_row(db, "SELECT tier, word, from_share, to_share, amount FROM feature WHERE gloss = ?1 ORDER BY position",
                  sign.gloss, sign.gloss, kMaxParts, [&sign](Row& row) {
                    NonManualFeature feature;
                    feature.tier = row.text();
                    feature.word = row.text();
                    for (double* value : {&feature.from, &feature.to, &feature.amount})
                      *value = row.real();
                    sign.non_manual.more.push_back(std::move(feature));
                    return true;
                  });
}

Result<std::vector<SignSummary>> read_summaries_where(sqlite3* db, std::string_view condition,
                                                      std::string_view parameter) {
  std::vector<SignSummary> list;
  Result<void> outcome = each_row(
      db,
      "SELECT gloss, kind, category, region, definition, handedness, confidence, review, safety_critical FROM sign "
      "WHERE " +
          std::string(condition),
      parameter, "the table of signs", kMaxRows, [&list](Row& row) {
        SignSummary sign;
        for (std::string* value : {&sign.gloss, &sign.kind, &sign.category, &sign.region, &sign.definition})
          *value = row.text();
        sign.handedness = row.word<Handedness>();
        sign.confidence = row.word<Confidence>();
        sign.review = row.word<ReviewState>();
        sign.safety_critical = row.integer(0, 1) == 1;
        list.push_back(std::move(sign));
        return true;
      });
  if (!outcome) return tl::unexpected(outcome.error());
  return list;
}

}  // namespace

Result<std::optional<Sign>> read_sign_row(sqlite3* db, std::string_view gloss) {
  std::optional<Sign> found;
  const std::string name(gloss);
  Result<void> outcome = each_row(
      db,
      "SELECT gloss, kind, category, region, definition, handedness, brows, eyes, mouth, cheeks, head, shoulders, "
      "gaze, face, mouthing, safety_critical, sources, form_evidence, movement_evidence, confidence, review, "
      "reviewed_by, reviewed_on "
      "FROM sign WHERE gloss = ?1",
      gloss, name, 1, [&found](Row& row) {
        Sign& sign = found.emplace();
        for (std::string* value : {&sign.gloss, &sign.kind, &sign.category, &sign.region, &sign.definition})
          *value = row.text();
        sign.handedness = row.word<Handedness>();
        NonManual& nm = sign.non_manual;
        for (std::string* value :
             {&nm.brows, &nm.eyes, &nm.mouth, &nm.cheeks, &nm.head, &nm.shoulders, &nm.gaze, &nm.face, &nm.mouthing})
          *value = row.text();
        sign.safety_critical = row.integer(0, 1) == 1;
        sign.provenance = row.provenance();
        return true;
      });
  if (!outcome) return tl::unexpected(outcome.error());
  if (!found) return std::optional<Sign>();
  if (outcome = read_postures(db, *found); !outcome) return tl::unexpected(outcome.error());
  if (outcome = read_moves(db, *found); !outcome) return tl::unexpected(outcome.error());
  if (outcome = read_features(db, *found); !outcome) return tl::unexpected(outcome.error());
  if (outcome = read_history(db, "sign", name, found->provenance.history); !outcome)
    return tl::unexpected(outcome.error());
  std::vector<Finding> findings = check_sign(*found);
  return whole(std::move(*found), std::move(findings), name);
}

Result<std::optional<Handshape>> read_handshape_row(sqlite3* db, std::string_view id) {
  std::optional<Handshape> found;
  const std::string name = "handshape " + std::string(id);
  Result<void> outcome = each_row(
      db,
      "SELECT id, name, base, selected, thumb_radial, thumb_palmar, thumb_opposition, thumb_mp, thumb_ip, hamnosys, "
      "description, aliases, core, frequency_rank, sources, form_evidence, movement_evidence, confidence, review, "
      "reviewed_by, reviewed_on "
      "FROM handshape WHERE id = ?1",
      id, name, 1, [&found](Row& row) {
        Handshape& shape = found.emplace();
        for (std::string* value : {&shape.id, &shape.name, &shape.base, &shape.selected})
          *value = row.text();
        for (double* value : {&shape.thumb.radial_abduction, &shape.thumb.palmar_abduction, &shape.thumb.opposition,
                              &shape.thumb.mp, &shape.thumb.ip})
          *value = row.real();
        shape.hamnosys = row.text();
        shape.description = row.text();
        shape.aliases = split(row.text(), '\n');
        shape.core = row.integer(0, 1) == 1;
        shape.frequency_rank = row.integer(0, 999);
        shape.provenance = row.provenance();
        return true;
      });
  if (!outcome) return tl::unexpected(outcome.error());
  if (!found) return std::optional<Handshape>();
  int digits = 0;
  outcome = each_row(db, "SELECT digit, mcp, pip, dip, abduction FROM finger WHERE handshape = ?1 ORDER BY digit", id,
                     name, 4, [&found, &digits](Row& row) {
                       const int digit = row.integer(0, 3);
                       FingerAngles& finger = found->fingers[static_cast<size_t>(digit)];
                       for (double* value : {&finger.mcp, &finger.pip, &finger.dip, &finger.abduction})
                         *value = row.real();
                       return digit == digits++;
                     });
  if (!outcome) return tl::unexpected(outcome.error());
  if (digits != 4) return damaged(name, "a finger is missing");
  if (outcome = read_history(db, "handshape", std::string(id), found->provenance.history); !outcome)
    return tl::unexpected(outcome.error());
  std::vector<Finding> findings = check_handshape(*found);
  return whole(std::move(*found), std::move(findings), name);
}

Result<std::optional<Phrase>> read_phrase_row(sqlite3* db, std::string_view id) {
  std::optional<Phrase> found;
  const std::string name = "phrase " + std::string(id);
  Result<void> outcome =
      each_row(db,
               "SELECT id, domain, english, notes, sources, form_evidence, movement_evidence, confidence, review, "
               "reviewed_by, reviewed_on FROM phrase WHERE id = ?1",
               id, name, 1, [&found](Row& row) {
                 Phrase& phrase = found.emplace();
                 for (std::string* value : {&phrase.id, &phrase.domain, &phrase.english, &phrase.notes})
                   *value = row.text();
                 phrase.provenance = row.provenance();
                 return true;
               });
  if (!outcome) return tl::unexpected(outcome.error());
  if (!found) return std::optional<Phrase>();
  outcome = each_row(db, "SELECT item FROM phrase_item WHERE phrase = ?1 ORDER BY position", id, name, kMaxParts,
                     [&found](Row& row) {
                       found->glosses.push_back(row.text());
                       return true;
                     });
  if (!outcome) return tl::unexpected(outcome.error());
  outcome =
      each_row(db,
               "SELECT kind, from_item, to_item, brows, head, gaze, mouth, eyes, ending FROM phrase_span "
               "WHERE phrase = ?1 ORDER BY position",
               id, name, kMaxParts, [&found](Row& row) {
                 NonManualSpan span;
                 span.kind = row.text();
                 span.from = row.integer(0, 63);
                 span.to = row.integer(0, 63);
                 for (std::string* value : {&span.brows, &span.head, &span.gaze, &span.mouth, &span.eyes, &span.ending})
                   *value = row.text();
                 found->non_manual.push_back(std::move(span));
                 return true;
               });
  if (!outcome) return tl::unexpected(outcome.error());
  if (outcome = read_history(db, "phrase", std::string(id), found->provenance.history); !outcome)
    return tl::unexpected(outcome.error());
  std::vector<Finding> findings = check_phrase(*found);
  return whole(std::move(*found), std::move(findings), name);
}

Result<std::vector<Keyword>> read_keyword_rows(sqlite3* db, KeywordOrder order, std::vector<Finding>& findings) {
  Result<Statement> statement =
      Statement::prepare(db, std::string("SELECT word, part_of_speech, gloss, rank FROM keyword ORDER BY ") +
                                 (order == KeywordOrder::kText ? "position, " : "") + "word, part_of_speech, rank");
  if (!statement) return tl::unexpected(statement.error());
  std::vector<Keyword> keywords;
  while (true) {
    const Result<bool> more = statement->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return keywords;
    if (keywords.size() + findings.size() >= kMaxRows) return damaged("the table of keywords", "too many rows");
    Row row(*statement);
    Keyword keyword;
    keyword.word = row.text();
    keyword.part_of_speech = row.text();
    keyword.gloss = row.text();
    keyword.rank = row.integer(0, 99);
    if (row.good() && !keyword.word.empty() && is_gloss(keyword.gloss)) {
      keywords.push_back(std::move(keyword));
      continue;
    }
    if (statement->damaged()) return damaged("the table of keywords", "a value of the wrong type");
    findings.push_back({keyword.gloss, "english", "the keyword \"" + keyword.word + "\" is damaged"});
  }
}

Result<std::vector<SignSummary>> read_summaries(sqlite3* db) {
  return read_summaries_where(db, "?1 = '' ORDER BY position", "");
}

Result<std::optional<SignSummary>> read_summary(sqlite3* db, std::string_view gloss) {
  Result<std::vector<SignSummary>> found = read_summaries_where(db, "gloss = ?1", gloss);
  if (!found) return tl::unexpected(found.error());
  return found->empty() ? std::optional<SignSummary>() : std::optional<SignSummary>(std::move(found->front()));
}

Result<std::vector<std::string>> read_names(sqlite3* db, std::string_view sql,
                                            std::optional<std::string_view> parameter) {
  std::vector<std::string> names;
  Result<void> outcome = each_row(db, sql, parameter.value_or(""), "the list of entries", kMaxRows, [&names](Row& row) {
    names.push_back(row.text());
    return true;
  });
  if (!outcome) return tl::unexpected(outcome.error());
  return names;
}

Result<LexiconText> read_lexicon_rows(sqlite3* db) {
  LexiconText text;
  const auto read_each = [db](std::string_view sql, const auto& read, auto& list) -> Result<void> {
    const Result<std::vector<std::string>> names = read_names(db, sql);
    if (!names) return tl::unexpected(names.error());
    for (const std::string& name : *names) {
      auto entry = read(db, name);
      if (!entry) return tl::unexpected(entry.error());
      if (!*entry) return damaged(name, "it cannot be found by its name");
      list.push_back(std::move(**entry));
    }
    return {};
  };
  Result<void> outcome =
      read_each("SELECT id FROM handshape WHERE ?1 = '' ORDER BY position", read_handshape_row, text.handshapes);
  if (outcome) outcome = read_each("SELECT gloss FROM sign WHERE ?1 = '' ORDER BY position", read_sign_row, text.signs);
  if (outcome)
    outcome = read_each("SELECT id FROM phrase WHERE ?1 = '' ORDER BY position", read_phrase_row, text.phrases);
  if (!outcome) return tl::unexpected(outcome.error());
  std::vector<Finding> findings;
  Result<std::vector<Keyword>> keywords = read_keyword_rows(db, KeywordOrder::kText, findings);
  if (!keywords) return tl::unexpected(keywords.error());
  if (!findings.empty()) return damaged(findings.front().entry, findings.front().message);
  text.keywords = std::move(*keywords);
  return text;
}

}  // namespace auslan
