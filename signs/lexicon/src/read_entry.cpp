// SPDX-License-Identifier: Apache-2.0
#include "read_entry.h"

#include "lexicon/face_words.h"
#include "usual_hands.h"

#include <charconv>

namespace auslan {
namespace {

constexpr double kCentimetresPerMetre = 100.0;

Provenance read_provenance(TableReader& reader, Need evidence) {
  Provenance provenance;
  provenance.sources = reader.texts("sources", Need::kRequired);
  provenance.form_evidence = reader.text("form_evidence", evidence);
  provenance.movement_evidence = reader.text("movement_evidence", evidence);
  provenance.confidence = reader.vocabulary<Confidence>("confidence", Need::kRequired).value_or(Confidence::kLow);
  provenance.review = reader.vocabulary<ReviewState>("review", Need::kOptional).value_or(ReviewState::kUnreviewed);
  provenance.reviewed_by = reader.text("reviewed_by", Need::kOptional);
  provenance.reviewed_on = reader.text("reviewed_on", Need::kOptional);
  for (const toml::table* table : reader.tables("reviews", Need::kOptional)) {
    TableReader inner(*table, reader.what() + " reviews[" + std::to_string(provenance.history.size()) + "]",
                      reader.problems());
    Review review;
    review.by = inner.text("by", Need::kRequired);
    review.on = inner.text("on", Need::kRequired);
    review.verdict = inner.vocabulary<ReviewState>("verdict", Need::kRequired).value_or(ReviewState::kUnreviewed);
    review.remark = inner.text("remark", Need::kOptional);
    review.content = inner.text("content", Need::kOptional);
    inner.finish();
    provenance.history.push_back(std::move(review));
  }
  return provenance;
}

Posture read_posture(TableReader& reader) {
  Posture posture;
  posture.handshape = reader.text("shape", Need::kRequired);
  posture.fingers = reader.direction("fingers", Need::kRequired).value_or(Direction{0, 1, 0});
  posture.palm = reader.direction("palm", Need::kRequired).value_or(Direction{0, 0, 1});
  posture.location = reader.vocabulary<Location>("at", Need::kRequired).value_or(Location::kNeutral);
  const auto offset = reader.numbers<3>("offset_cm", Need::kOptional);
  posture.offset = {offset[0] / kCentimetresPerMetre, offset[1] / kCentimetresPerMetre,
                    offset[2] / kCentimetresPerMetre};
  if (const toml::table* table = reader.table("contact", Need::kOptional); table != nullptr) {
    TableReader inner(*table, reader.what() + " contact", reader.problems());
    Contact contact;
    contact.kind = inner.vocabulary<ContactKind>("kind", Need::kRequired).value_or(ContactKind::kTouch);
    contact.part = inner.vocabulary<HandPart>("part", Need::kOptional);
    contact.target = inner.vocabulary<Location>("target", Need::kOptional);
    inner.finish();
    posture.contact = contact;
  }
  reader.finish();
  return posture;
}

Movement read_move(TableReader& reader, Handedness handedness) {
  Movement move;
  move.kind = reader.vocabulary<MoveKind>("kind", Need::kRequired).value_or(MoveKind::kHold);
  move.direction = reader.direction("direction", Need::kOptional);
  move.size = reader.vocabulary<Size>("size", Need::kOptional).value_or(Size::kMedium);
  move.repeats = reader.integer("repeats", 1, 1, 24);
  move.hands = reader.vocabulary<MovingHands>("hands", Need::kOptional).value_or(usual_hands(handedness));
  move.manner = reader.vocabulary<Manner>("manner", Need::kOptional).value_or(Manner::kPlain);
  move.plane = reader.vocabulary<Plane>("plane", Need::kOptional).value_or(Plane::kNone);
  move.bow = reader.direction("bow", Need::kOptional);
  move.start = reader.direction("start", Need::kOptional);
  move.eighths = reader.integer("eighths", 8, 1, 64);
  move.ellipse = reader.direction("ellipse", Need::kOptional);
  move.flattening = reader.vocabulary<Size>("flattening", Need::kOptional).value_or(Size::kMedium);
  move.growth = reader.vocabulary<Growth>("growth", Need::kOptional).value_or(Growth::kNone);
  move.digits = reader.text("digits", Need::kOptional);
  if (reader.node("pace") != nullptr) move.pace = reader.number("pace", Need::kOptional);
  move.from = reader.integer("from", 0, 0, 99);
  move.to = reader.integer("to", move.from, 0, 99);
  reader.finish();
  return move;
}

NonManual read_face(TableReader& reader) {
  NonManual face;
  const auto channel = [&reader](FaceTier which) {
    return reader.word(tier_name(which), Need::kOptional, face_words(which));
  };
  using enum FaceTier;
  face.brows = channel(kBrows);
  face.eyes = channel(kEyes);
  face.mouth = channel(kMouth);
  face.cheeks = channel(kCheeks);
  face.head = channel(kHead);
  face.shoulders = channel(kShoulders);
  face.gaze = channel(kGaze);
  face.face = channel(kFace);
  for (const toml::table* table : reader.tables("more", Need::kOptional)) {
    TableReader inner(*table, reader.what() + " more[" + std::to_string(face.more.size()) + "]", reader.problems());
    NonManualFeature feature;
    feature.tier = inner.text("tier", Need::kRequired);
    feature.word = inner.text("word", Need::kRequired);
    feature.from = inner.number("from", Need::kRequired);
    feature.to = inner.number("to", Need::kRequired);
    if (inner.node("amount") != nullptr) feature.amount = inner.number("amount", Need::kOptional);
    inner.finish();
    face.more.push_back(std::move(feature));
  }
  reader.finish();
  return face;
}

void note_keys(const TableReader& reader, const std::string& entry, Places& places) {
  places.note(entry, "", reader.problems(), reader.line());
  reader.each_key([&](const std::string& key, long line) { places.note(entry, key, reader.problems(), line); });
}

/// "word", "word:pos" or "word:pos:rank".
void read_keywords(TableReader& reader, const std::string& gloss, Need need, LexiconText& text, Places& places) {
  const std::vector<std::string> words = reader.texts("english", need);
  const long line = reader.node("english") != nullptr ? ProblemList::line_of(*reader.node("english")) : reader.line();
  for (size_t i = 0; i < words.size(); ++i) {
    Keyword keyword;
    keyword.gloss = gloss;
    const std::string& spec = words[i];
    const size_t colon = spec.find(':');
    keyword.word = spec.substr(0, colon);
    if (colon != std::string::npos) {
      const size_t second = spec.find(':', colon + 1);
      keyword.part_of_speech = spec.substr(colon + 1, second == std::string::npos ? second : second - colon - 1);
      if (second != std::string::npos) {
        const char* begin = spec.data() + second + 1;
        const char* end = spec.data() + spec.size();
        const auto [rest, error] = std::from_chars(begin, end, keyword.rank);
        if (error != std::errc() || rest != end)
          reader.problems().add(
              line, reader.what() + ": keyword \"" + spec + "\"; expected word:pos:rank, as \"hurt:verb:1\"");
      }
    }
    places.note(gloss, "english[" + std::to_string(i) + "]", reader.problems(), line);
    text.keywords.push_back(std::move(keyword));
  }
}

}  // namespace

void read_handshape(TableReader& reader, LexiconText& text, Places& places) {
  Handshape shape;
  shape.id = reader.text("id", Need::kRequired);
  reader.rename("handshape " + shape.id);
  note_keys(reader, reader.what(), places);
  shape.name = reader.text("name", Need::kRequired);
  shape.base = reader.text("base", Need::kOptional);
  if (shape.base.empty()) shape.base = shape.id;
  shape.selected = reader.text("selected", Need::kRequired);
  constexpr std::array<std::string_view, 4> kFingers = {"index", "middle", "ring", "little"};
  for (size_t i = 0; i < kFingers.size(); ++i) {
    const auto angles = reader.numbers<4>(kFingers[i], Need::kRequired);
    shape.fingers[i] = {angles[0], angles[1], angles[2], angles[3]};
  }
  if (const toml::table* table = reader.table("thumb", Need::kRequired); table != nullptr) {
    TableReader thumb(*table, reader.what() + " thumb", reader.problems());
    shape.thumb.radial_abduction = thumb.number("radial", Need::kRequired);
    shape.thumb.palmar_abduction = thumb.number("palmar", Need::kRequired);
    shape.thumb.opposition = thumb.number("opposition", Need::kRequired);
    shape.thumb.mp = thumb.number("mp", Need::kRequired);
    shape.thumb.ip = thumb.number("ip", Need::kRequired);
    thumb.finish();
  }
  shape.hamnosys = reader.text("hamnosys", Need::kOptional);
  shape.description = reader.text("description", Need::kRequired);
  shape.aliases = reader.texts("aliases", Need::kOptional);
  shape.core = reader.flag("core");
  shape.frequency_rank = reader.integer("frequency_rank", 0, 0, 999);
  shape.provenance = read_provenance(reader, Need::kOptional);
  reader.finish();
  text.handshapes.push_back(std::move(shape));
}

void read_sign(TableReader& reader, std::string_view kind, std::string_view category, LexiconText& text,
               Places& places) {
  Sign sign;
  sign.gloss = reader.text("gloss", Need::kRequired);
  sign.kind = kind;
  sign.category = category;
  reader.rename(std::string(kind) + " " + sign.gloss);
  ProblemList& problems = reader.problems();
  note_keys(reader, sign.gloss, places);
  read_keywords(reader, sign.gloss, kind == "sign" ? Need::kRequired : Need::kOptional, text, places);
  sign.region = reader.text("region", Need::kOptional);
  if (sign.region.empty()) sign.region = "all";
  sign.definition = reader.text("definition", Need::kRequired);
  sign.handedness = reader.vocabulary<Handedness>("hands", Need::kRequired).value_or(Handedness::kOne);
  const auto read_hand = [&](std::string_view key, Need need) {
    std::vector<Posture> phases;
    for (const toml::table* table : reader.tables(key, need)) {
      const std::string part = std::string(key) + "[" + std::to_string(phases.size()) + "]";
      places.note(sign.gloss, part, problems, ProblemList::line_of(*table));
      TableReader inner(*table, reader.what() + " " + part, problems);
      phases.push_back(read_posture(inner));
    }
    return phases;
  };
  sign.dominant = read_hand("dominant", Need::kRequired);
  sign.non_dominant = read_hand("base", Need::kOptional);
  for (const toml::table* table : reader.tables("moves", Need::kRequired)) {
    const std::string part = "moves[" + std::to_string(sign.movements.size()) + "]";
    places.note(sign.gloss, part, problems, ProblemList::line_of(*table));
    TableReader inner(*table, reader.what() + " " + part, problems);
    sign.movements.push_back(read_move(inner, sign.handedness));
  }
  if (const toml::table* table = reader.table("face", Need::kOptional); table != nullptr) {
    TableReader inner(*table, reader.what() + " face", problems);
    sign.non_manual = read_face(inner);
  }
  sign.non_manual.mouthing = reader.text("mouthing", Need::kOptional);
  sign.safety_critical = reader.flag("safety_critical");
  sign.provenance = read_provenance(reader, Need::kRequired);
  reader.finish();
  text.signs.push_back(std::move(sign));
}

void read_phrase(TableReader& reader, LexiconText& text, Places& places) {
  Phrase phrase;
  phrase.id = reader.text("id", Need::kRequired);
  reader.rename("phrase " + phrase.id);
  note_keys(reader, reader.what(), places);
  phrase.domain = reader.text("domain", Need::kRequired);
  phrase.english = reader.text("english", Need::kRequired);
  phrase.glosses = reader.texts("glosses", Need::kRequired);
  for (const toml::table* table : reader.tables("spans", Need::kOptional)) {
    const std::string part = "spans[" + std::to_string(phrase.non_manual.size()) + "]";
    places.note(reader.what(), part, reader.problems(), ProblemList::line_of(*table));
    TableReader inner(*table, reader.what() + " " + part, reader.problems());
    NonManualSpan span;
    span.kind = inner.word("kind", Need::kRequired, span_kinds());
    span.from = inner.integer("from", 0, 0, 99);
    span.to = inner.integer("to", span.from, 0, 99);
    using enum FaceTier;
    span.brows = inner.word("brows", Need::kOptional, face_words(kBrows));
    span.head = inner.word("head", Need::kOptional, face_words(kHead));
    span.gaze = inner.word("gaze", Need::kOptional, face_words(kGaze));
    span.mouth = inner.word("mouth", Need::kOptional, face_words(kMouth));
    span.eyes = inner.word("eyes", Need::kOptional, face_words(kEyes));
    span.ending = inner.word("ending", Need::kOptional, span_endings());
    inner.finish();
    phrase.non_manual.push_back(std::move(span));
  }
  phrase.notes = reader.text("notes", Need::kOptional);
  phrase.provenance = read_provenance(reader, Need::kOptional);
  reader.finish();
  text.phrases.push_back(std::move(phrase));
}

}  // namespace auslan
