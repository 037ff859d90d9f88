// SPDX-License-Identifier: Apache-2.0
#include "database_rows.h"

#include "phonology/vocabulary.h"
#include "schema.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {
namespace {

std::string joined(const std::vector<std::string>& texts, char separator) {
  std::string out;
  for (const std::string& text : texts) {
    if (!out.empty()) out += separator;
    out += text;
  }
  return out;
}

void bind_provenance(Statement& statement, const Provenance& provenance, const std::string& content) {
  statement.bind(std::string_view(joined(provenance.sources, ',')));
  statement.bind(std::string_view(provenance.form_evidence));
  statement.bind(std::string_view(provenance.movement_evidence));
  statement.bind(to_name(provenance.confidence));
  statement.bind(to_name(provenance.review));
  statement.bind(std::string_view(provenance.reviewed_by));
  statement.bind(std::string_view(provenance.reviewed_on));
  statement.bind(std::string_view(content));
}

/// "INSERT INTO table VALUES (?, …)".
Result<Statement> insert_into(sqlite3* db, std::string_view table, int columns) {
  std::string sql = "INSERT INTO ";
  sql += table;
  sql += " VALUES (";
  for (int i = 0; i < columns; ++i)
    sql += i == 0 ? "?" : ", ?";
  sql += ")";
  return Statement::prepare(db, sql);
}

#define AUSLAN_TRY(result)                                 \
  do {                                                     \
    if (auto outcome = (result); !outcome) return outcome; \
  } while (false)

Result<void> insert_history(sqlite3* db, std::string_view kind, const std::string& entry,
                            const std::vector<Review>& history) {
  int position = 0;
  for (const Review& review : history)
    AUSLAN_TRY(insert_review(db, kind, entry, position++, review));
  return {};
}

/// What the full-text search finds a sign by.
Result<void> insert_words(Statement& row, const Sign& sign, const std::vector<Keyword>& keywords) {
  std::string words = sign.gloss;
  for (const Keyword& keyword : keywords)
    (words += '\n') += keyword.word;
  row.bind(std::string_view(sign.gloss));
  row.bind(std::string_view(words));
  row.bind(std::string_view(sign.definition));
  return row.run();
}

Result<void> insert_handshapes(sqlite3* db, const LexiconText& text) {
  Result<Statement> shape_row = insert_into(db, "handshape", 23);
  Result<Statement> finger_row = insert_into(db, "finger", 6);
  if (!shape_row) return tl::unexpected(shape_row.error());
  if (!finger_row) return tl::unexpected(finger_row.error());
  int position = 0;
  for (const Handshape& shape : text.handshapes) {
    shape_row->bind(std::string_view(shape.id));
    shape_row->bind(position++);
    for (const std::string* value : {&shape.name, &shape.base, &shape.selected})
      shape_row->bind(std::string_view(*value));
    shape_row->bind(shape.thumb.radial_abduction);
    shape_row->bind(shape.thumb.palmar_abduction);
    shape_row->bind(shape.thumb.opposition);
    shape_row->bind(shape.thumb.mp);
    shape_row->bind(shape.thumb.ip);
    shape_row->bind(std::string_view(shape.hamnosys));
    shape_row->bind(std::string_view(shape.description));
    shape_row->bind(std::string_view(joined(shape.aliases, '\n')));
    shape_row->bind(shape.core ? 1 : 0);
    shape_row->bind(shape.frequency_rank);
    bind_provenance(*shape_row, shape.provenance, content_digest(shape));
    AUSLAN_TRY(shape_row->run());
    AUSLAN_TRY(insert_history(db, "handshape", shape.id, shape.provenance.history));
    for (int digit = 0; digit < 4; ++digit) {
      const FingerAngles& finger = shape.fingers[static_cast<size_t>(digit)];
      finger_row->bind(std::string_view(shape.id));
      finger_row->bind(digit);
      for (const double angle : {finger.mcp, finger.pip, finger.dip, finger.abduction})
        finger_row->bind(angle);
      AUSLAN_TRY(finger_row->run());
    }
  }
  return {};
}

Result<void> insert_postures(Statement& row, const std::string& gloss, std::string_view hand,
                             const std::vector<Posture>& postures) {
  int phase = 0;
  for (const Posture& posture : postures) {
    row.bind(std::string_view(gloss));
    row.bind(hand);
    row.bind(phase++);
    row.bind(std::string_view(posture.handshape));
    row.bind(std::string_view(to_name(posture.fingers)));
    row.bind(std::string_view(to_name(posture.palm)));
    row.bind(to_name(posture.location));
    row.bind(posture.offset.x);
    row.bind(posture.offset.y);
    row.bind(posture.offset.z);
    std::optional<std::string_view> kind, part, target;
    if (posture.contact) {
      kind = to_name(posture.contact->kind);
      if (posture.contact->part) part = to_name(*posture.contact->part);
      if (posture.contact->target) target = to_name(*posture.contact->target);
    }
    row.bind(kind);
    row.bind(part);
    row.bind(target);
    AUSLAN_TRY(row.run());
  }
  return {};
}

Result<void> insert_moves(Statement& row, const Sign& sign) {
  int position = 0;
  for (const Movement& move : sign.movements) {
    row.bind(std::string_view(sign.gloss));
    row.bind(position++);
    row.bind(to_name(move.kind));
    const std::string direction = move.direction ? to_name(*move.direction) : "";
    if (move.direction)
      row.bind(std::string_view(direction));
    else
      row.bind_null();
    row.bind(to_name(move.size));
    row.bind(move.repeats);
    row.bind(to_name(move.hands));
    row.bind(to_name(move.manner));
    row.bind(to_name(move.plane));
    const auto optional_direction = [&row](const std::optional<Direction>& given) {
      if (given)
        row.bind(std::string_view(to_name(*given)));
      else
        row.bind_null();
    };
    optional_direction(move.bow);
    optional_direction(move.start);
    row.bind(move.eighths);
    optional_direction(move.ellipse);
    row.bind(to_name(move.flattening));
    row.bind(to_name(move.growth));
    row.bind(std::string_view(move.digits));
    row.bind(move.pace);
    row.bind(move.from);
    row.bind(move.to);
    AUSLAN_TRY(row.run());
  }
  return {};
}

Result<void> insert_features(Statement& row, const Sign& sign) {
  int position = 0;
  for (const NonManualFeature& feature : sign.non_manual.more) {
    row.bind(std::string_view(sign.gloss));
    row.bind(position++);
    row.bind(std::string_view(feature.tier));
    row.bind(std::string_view(feature.word));
    for (const double value : {feature.from, feature.to, feature.amount})
      row.bind(value);
    AUSLAN_TRY(row.run());
  }
  return {};
}

Result<void> insert_signs(sqlite3* db, const LexiconText& text) {
  Result<Statement> sign_row = insert_into(db, "sign", 25);
  Result<Statement> posture_row = insert_into(db, "posture", 13);
  Result<Statement> move_row = insert_into(db, "movement", 19);
  Result<Statement> feature_row = insert_into(db, "feature", 7);
  Result<Statement> index_row = insert_into(db, kWordIndex, 3);
  if (!feature_row) return tl::unexpected(feature_row.error());
  if (!index_row) return tl::unexpected(index_row.error());
  std::map<std::string, std::vector<Keyword>> keywords;
  for (const Keyword& keyword : text.keywords)
    keywords[keyword.gloss].push_back(keyword);
  if (!sign_row) return tl::unexpected(sign_row.error());
  if (!posture_row) return tl::unexpected(posture_row.error());
  if (!move_row) return tl::unexpected(move_row.error());
  int position = 0;
  for (const Sign& sign : text.signs) {
    sign_row->bind(std::string_view(sign.gloss));
    sign_row->bind(position++);
    for (const std::string* value : {&sign.kind, &sign.category, &sign.region, &sign.definition})
      sign_row->bind(std::string_view(*value));
    sign_row->bind(to_name(sign.handedness));
    const NonManual& nm = sign.non_manual;
    for (const std::string* value :
         {&nm.brows, &nm.eyes, &nm.mouth, &nm.cheeks, &nm.head, &nm.shoulders, &nm.gaze, &nm.face, &nm.mouthing})
      sign_row->bind(std::string_view(*value));
    sign_row->bind(sign.safety_critical ? 1 : 0);
    const std::vector<Keyword>& own = keywords[sign.gloss];
    bind_provenance(*sign_row, sign.provenance, content_digest(sign, own));
    AUSLAN_TRY(sign_row->run());
    AUSLAN_TRY(insert_history(db, "sign", sign.gloss, sign.provenance.history));
    AUSLAN_TRY(insert_words(*index_row, sign, own));
    AUSLAN_TRY(insert_postures(*posture_row, sign.gloss, "dominant", sign.dominant));
    AUSLAN_TRY(insert_postures(*posture_row, sign.gloss, "base", sign.non_dominant));
    AUSLAN_TRY(insert_moves(*move_row, sign));
    AUSLAN_TRY(insert_features(*feature_row, sign));
  }
  return execute(db, "INSERT INTO part_index SELECT words FROM word_index ORDER BY rowid");
}

Result<void> insert_keywords(sqlite3* db, const LexiconText& text) {
  Result<Statement> row = insert_into(db, "keyword", 5);
  if (!row) return tl::unexpected(row.error());
  int position = 0;
  for (const Keyword& keyword : text.keywords) {
    row->bind(std::string_view(keyword.word));
    row->bind(std::string_view(keyword.part_of_speech));
    row->bind(keyword.rank);
    row->bind(position++);
    row->bind(std::string_view(keyword.gloss));
    AUSLAN_TRY(row->run());
  }
  return {};
}

Result<void> insert_phrases(sqlite3* db, const LexiconText& text) {
  Result<Statement> phrase_row = insert_into(db, "phrase", 13);
  Result<Statement> item_row = insert_into(db, "phrase_item", 3);
  Result<Statement> span_row = insert_into(db, "phrase_span", 11);
  if (!phrase_row) return tl::unexpected(phrase_row.error());
  if (!item_row) return tl::unexpected(item_row.error());
  if (!span_row) return tl::unexpected(span_row.error());
  int position = 0;
  for (const Phrase& phrase : text.phrases) {
    phrase_row->bind(std::string_view(phrase.id));
    phrase_row->bind(position++);
    for (const std::string* value : {&phrase.domain, &phrase.english, &phrase.notes})
      phrase_row->bind(std::string_view(*value));
    bind_provenance(*phrase_row, phrase.provenance, content_digest(phrase));
    AUSLAN_TRY(phrase_row->run());
    AUSLAN_TRY(insert_history(db, "phrase", phrase.id, phrase.provenance.history));
    int item = 0;
    for (const std::string& gloss : phrase.glosses) {
      item_row->bind(std::string_view(phrase.id));
      item_row->bind(item++);
      item_row->bind(std::string_view(gloss));
      AUSLAN_TRY(item_row->run());
    }
    int number = 0;
    for (const NonManualSpan& span : phrase.non_manual) {
      span_row->bind(std::string_view(phrase.id));
      span_row->bind(number++);
      span_row->bind(std::string_view(span.kind));
      span_row->bind(span.from);
      span_row->bind(span.to);
      for (const std::string* value : {&span.brows, &span.head, &span.gaze, &span.mouth, &span.eyes, &span.ending})
        span_row->bind(std::string_view(*value));
      AUSLAN_TRY(span_row->run());
    }
  }
  return {};
}

}  // namespace

Result<void> insert_review(sqlite3* db, std::string_view kind, const std::string& entry, int position,
                           const Review& review) {
  Result<Statement> row = insert_into(db, "review", 8);
  if (!row) return tl::unexpected(row.error());
  row->bind(kind);
  row->bind(std::string_view(entry));
  row->bind(position);
  row->bind(std::string_view(review.by));
  row->bind(std::string_view(review.on));
  row->bind(to_name(review.verdict));
  row->bind(std::string_view(review.remark));
  row->bind(std::string_view(review.content));
  return row->run();
}

Result<void> create_tables(sqlite3* db) {
  for (const TableSchema& table : lexicon_tables())
    AUSLAN_TRY(execute(db, table.sql));
  return {};
}

Result<void> delete_rows(sqlite3* db) {
  // The reverse of how they are made: what refers goes before what is referred to.
  const std::vector<TableSchema> tables = lexicon_tables();
  for (auto table = tables.rbegin(); table != tables.rend(); ++table)
    AUSLAN_TRY(execute(db, "DELETE FROM " + std::string(table->name)));
  return {};
}

Result<void> insert_rows(sqlite3* db, const LexiconText& text) {
  AUSLAN_TRY(insert_handshapes(db, text));
  AUSLAN_TRY(insert_signs(db, text));
  AUSLAN_TRY(insert_keywords(db, text));
  return insert_phrases(db, text);
}

#undef AUSLAN_TRY

}  // namespace auslan
