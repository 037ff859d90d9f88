// SPDX-License-Identifier: Apache-2.0
#include "schema.h"

#include "lexicon/face_words.h"
#include "phonology/vocabulary.h"

namespace auslan {
namespace {

/// "CHECK (column IN ('a', 'b'))"; the empty string is let in for words that may be absent.
std::string check_in(std::string_view column, std::span<const std::string_view> words, bool or_empty = false) {
  std::string sql = "CHECK (";
  sql += column;
  sql += " IN (";
  if (or_empty) sql += "''";
  for (size_t i = 0; i < words.size(); ++i) {
    if (i > 0 || or_empty) sql += ", ";
    sql += '\'';
    sql += words[i];
    sql += '\'';
  }
  sql += "))";
  return sql;
}

template <typename E>
std::string vocabulary(std::string_view column) {
  return "TEXT NOT NULL " + check_in(column, names_of<E>());
}

template <typename E>
std::string optional_vocabulary(std::string_view column) {
  return "TEXT " + check_in(column, names_of<E>());
}

std::string face(FaceTier channel) {
  return "TEXT NOT NULL " + check_in(tier_name(channel), face_words(channel), true);
}

std::string provenance() {
  return "  sources TEXT NOT NULL,\n"
         "  form_evidence TEXT NOT NULL,\n"
         "  movement_evidence TEXT NOT NULL,\n"
         "  confidence " +
         vocabulary<Confidence>("confidence") + ",\n" + "  review " + vocabulary<ReviewState>("review") + ",\n" +
         "  reviewed_by TEXT NOT NULL CHECK ((reviewed_by = '') = (review = 'unreviewed')),\n"
         "  reviewed_on TEXT NOT NULL CHECK ((reviewed_on = '') = (review = 'unreviewed')),\n"
         "  content TEXT NOT NULL CHECK (length(content) = 32)";
}

}  // namespace

// One tree for each table, and no index that nothing looks up by: integrity_check reads them all at every opening. The
// columns of the key stand first: SQLite 3.40 takes sound rows for damaged where they do not.
std::vector<TableSchema> lexicon_tables() {
  using enum FaceTier;
  std::vector<TableSchema> tables;
  tables.push_back({"handshape",
                    "CREATE TABLE handshape (\n"
                    "  id TEXT PRIMARY KEY NOT NULL,\n"
                    "  position INTEGER NOT NULL,\n"
                    "  name TEXT NOT NULL,\n"
                    "  base TEXT NOT NULL REFERENCES handshape (id) DEFERRABLE INITIALLY DEFERRED,\n"
                    "  selected TEXT NOT NULL,\n"
                    "  thumb_radial REAL NOT NULL,\n"
                    "  thumb_palmar REAL NOT NULL,\n"
                    "  thumb_opposition REAL NOT NULL CHECK (thumb_opposition BETWEEN 0 AND 1),\n"
                    "  thumb_mp REAL NOT NULL,\n"
                    "  thumb_ip REAL NOT NULL,\n"
                    "  hamnosys TEXT NOT NULL,\n"
                    "  description TEXT NOT NULL,\n"
                    "  aliases TEXT NOT NULL,\n"
                    "  core INTEGER NOT NULL CHECK (core IN (0, 1)),\n"
                    "  frequency_rank INTEGER NOT NULL CHECK (frequency_rank BETWEEN 0 AND 999),\n" +
                        provenance() + ") STRICT, WITHOUT ROWID"});
  tables.push_back({"finger",
                    "CREATE TABLE finger (\n"
                    "  handshape TEXT NOT NULL REFERENCES handshape (id) ON DELETE CASCADE,\n"
                    "  digit INTEGER NOT NULL CHECK (digit BETWEEN 0 AND 3),\n"
                    "  mcp REAL NOT NULL,\n"
                    "  pip REAL NOT NULL,\n"
                    "  dip REAL NOT NULL,\n"
                    "  abduction REAL NOT NULL,\n"
                    "  PRIMARY KEY (handshape, digit)) STRICT, WITHOUT ROWID"});
  tables.push_back({"sign",
                    "CREATE TABLE sign (\n"
                    "  gloss TEXT PRIMARY KEY NOT NULL,\n"
                    "  position INTEGER NOT NULL,\n"
                    "  kind TEXT NOT NULL CHECK (kind IN ('sign', 'letter', 'number')),\n"
                    "  category TEXT NOT NULL,\n"
                    "  region TEXT NOT NULL,\n"
                    "  definition TEXT NOT NULL CHECK (definition <> ''),\n"
                    "  handedness " +
                        vocabulary<Handedness>("handedness") + ",\n" + "  brows " + face(kBrows) + ",\n" + "  eyes " +
                        face(kEyes) + ",\n" + "  mouth " + face(kMouth) + ",\n" + "  cheeks " + face(kCheeks) + ",\n" +
                        "  head " + face(kHead) + ",\n" + "  shoulders " + face(kShoulders) + ",\n" + "  gaze " +
                        face(kGaze) + ",\n" + "  face " + face(kFace) + ",\n" +
                        "  mouthing TEXT NOT NULL,\n"
                        "  safety_critical INTEGER NOT NULL CHECK (safety_critical IN (0, 1)),\n" +
                        provenance() + ") STRICT, WITHOUT ROWID"});
  tables.push_back({"posture",
                    "CREATE TABLE posture (\n"
                    "  gloss TEXT NOT NULL REFERENCES sign (gloss) ON DELETE CASCADE,\n"
                    "  hand TEXT NOT NULL CHECK (hand IN ('dominant', 'base')),\n"
                    "  phase INTEGER NOT NULL CHECK (phase BETWEEN 0 AND 95),\n"
                    "  handshape TEXT NOT NULL REFERENCES handshape (id),\n"
                    "  fingers TEXT NOT NULL,\n"
                    "  palm TEXT NOT NULL,\n"
                    "  location " +
                        vocabulary<Location>("location") + ",\n" +
                        "  offset_left REAL NOT NULL,\n"
                        "  offset_up REAL NOT NULL,\n"
                        "  offset_away REAL NOT NULL,\n"
                        "  contact " +
                        optional_vocabulary<ContactKind>("contact") + ",\n" + "  contact_part " +
                        optional_vocabulary<HandPart>("contact_part") + ",\n" + "  contact_target " +
                        optional_vocabulary<Location>("contact_target") + ",\n" +
                        "  PRIMARY KEY (gloss, hand, phase)) STRICT, WITHOUT ROWID"});
  tables.push_back({"movement",
                    "CREATE TABLE movement (\n"
                    "  gloss TEXT NOT NULL REFERENCES sign (gloss) ON DELETE CASCADE,\n"
                    "  position INTEGER NOT NULL,\n"
                    "  kind " +
                        vocabulary<MoveKind>("kind") + ",\n" +
                        "  direction TEXT,\n"
                        "  size " +
                        vocabulary<Size>("size") + ",\n" +
                        "  repeats INTEGER NOT NULL CHECK (repeats BETWEEN 1 AND 24),\n"
                        "  hands " +
                        vocabulary<MovingHands>("hands") + ",\n" + "  manner " + vocabulary<Manner>("manner") + ",\n" +
                        "  plane " + vocabulary<Plane>("plane") + ",\n" +
                        "  bow TEXT,\n"
                        "  start TEXT,\n"
                        "  eighths INTEGER NOT NULL CHECK (eighths BETWEEN 1 AND 64),\n"
                        "  ellipse TEXT,\n"
                        "  flattening " +
                        vocabulary<Size>("flattening") + ",\n" + "  growth " + vocabulary<Growth>("growth") + ",\n" +
                        "  digits TEXT NOT NULL,\n"
                        "  pace REAL NOT NULL CHECK (pace BETWEEN 0.1 AND 10),\n" +
                        "  from_phase INTEGER NOT NULL CHECK (from_phase >= 0),\n"
                        "  to_phase INTEGER NOT NULL CHECK (to_phase >= from_phase),\n"
                        "  PRIMARY KEY (gloss, position)) STRICT, WITHOUT ROWID"});
  tables.push_back({"feature",
                    "CREATE TABLE feature (\n"
                    "  gloss TEXT NOT NULL REFERENCES sign (gloss) ON DELETE CASCADE,\n"
                    "  position INTEGER NOT NULL,\n"
                    "  tier TEXT NOT NULL,\n"
                    "  word TEXT NOT NULL CHECK (word <> ''),\n"
                    "  from_share REAL NOT NULL CHECK (from_share BETWEEN 0 AND 1),\n"
                    "  to_share REAL NOT NULL CHECK (to_share BETWEEN from_share AND 1),\n"
                    "  amount REAL NOT NULL CHECK (amount BETWEEN 0 AND 4),\n"
                    "  PRIMARY KEY (gloss, position)) STRICT, WITHOUT ROWID"});
  tables.push_back({"keyword",
                    "CREATE TABLE keyword (\n"
                    "  word TEXT NOT NULL CHECK (word <> ''),\n"
                    "  part_of_speech TEXT NOT NULL " +
                        check_in("part_of_speech", parts_of_speech(), true) + ",\n" +
                        "  rank INTEGER NOT NULL CHECK (rank BETWEEN 0 AND 99),\n"
                        "  position INTEGER NOT NULL,\n"
                        "  gloss TEXT NOT NULL REFERENCES sign (gloss) ON DELETE CASCADE,\n"
                        "  PRIMARY KEY (word, part_of_speech, rank)) STRICT, WITHOUT ROWID"});
  tables.push_back({"phrase",
                    "CREATE TABLE phrase (\n"
                    "  id TEXT PRIMARY KEY NOT NULL,\n"
                    "  position INTEGER NOT NULL,\n"
                    "  domain TEXT NOT NULL,\n"
                    "  english TEXT NOT NULL CHECK (english <> ''),\n"
                    "  notes TEXT NOT NULL,\n" +
                        provenance() + ") STRICT, WITHOUT ROWID"});
  tables.push_back({"phrase_item",
                    "CREATE TABLE phrase_item (\n"
                    "  phrase TEXT NOT NULL REFERENCES phrase (id) ON DELETE CASCADE,\n"
                    "  position INTEGER NOT NULL,\n"
                    "  item TEXT NOT NULL CHECK (item <> ''),\n"
                    "  PRIMARY KEY (phrase, position)) STRICT, WITHOUT ROWID"});
  tables.push_back({"phrase_span",
                    "CREATE TABLE phrase_span (\n"
                    "  phrase TEXT NOT NULL REFERENCES phrase (id) ON DELETE CASCADE,\n"
                    "  position INTEGER NOT NULL,\n"
                    "  kind TEXT NOT NULL " +
                        check_in("kind", span_kinds()) + ",\n" +
                        "  from_item INTEGER NOT NULL CHECK (from_item >= 0),\n"
                        "  to_item INTEGER NOT NULL CHECK (to_item >= from_item),\n"
                        "  brows " +
                        face(kBrows) + ",\n" + "  head " + face(kHead) + ",\n" + "  gaze " + face(kGaze) + ",\n" +
                        "  mouth " + face(kMouth) + ",\n" + "  eyes " + face(kEyes) + ",\n" +
                        "  ending TEXT NOT NULL " + check_in("ending", span_endings(), true) + ",\n" +
                        "  PRIMARY KEY (phrase, position)) STRICT, WITHOUT ROWID"});
  tables.push_back({"review",
                    "CREATE TABLE review (\n"
                    "  kind TEXT NOT NULL CHECK (kind IN ('handshape', 'sign', 'phrase')),\n"
                    "  entry TEXT NOT NULL CHECK (entry <> ''),\n"
                    "  position INTEGER NOT NULL CHECK (position >= 0),\n"
                    "  reviewer TEXT NOT NULL CHECK (reviewer <> ''),\n"
                    "  reviewed_on TEXT NOT NULL CHECK (reviewed_on <> ''),\n"
                    "  verdict " +
                        vocabulary<ReviewState>("verdict") + ",\n" +
                        "  remark TEXT NOT NULL,\n"
                        "  content TEXT NOT NULL CHECK (length(content) IN (0, 32)),\n"
                        "  PRIMARY KEY (kind, entry, position)) STRICT, WITHOUT ROWID"});
  tables.push_back({kWordIndex,
                    "CREATE VIRTUAL TABLE word_index USING fts5(gloss UNINDEXED, words, definition, "
                    "tokenize = 'porter unicode61')"});
  tables.push_back({kPartIndex, "CREATE VIRTUAL TABLE part_index USING fts5(words, tokenize = 'trigram')"});
  return tables;
}

}  // namespace auslan
