// SPDX-License-Identifier: Apache-2.0
// The canonical text: one fixed order of keys, one line a posture or movement, defaults left out.
#include "digest/digest.h"
#include "kinematics/whole_file.h"
#include "lexicon/face_words.h"
#include "lexicon/lexicon_text.h"
#include "phonology/vocabulary.h"
#include "usual_hands.h"

#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <map>

namespace auslan {
namespace {

/// Whether an entry is written with what reviewers said of it.
enum class Reviews { kWritten, kLeftOut };

constexpr std::string_view kLicence = "# SPDX-License-Identifier: Apache-2.0\n";

std::string toml_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

/// The shortest decimal that reads back as the same number.
std::string decimal(double value) {
  std::array<char, 40> buffer{};
  if (value == 0) value = 0;  // no minus zero
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed).ptr;
  return {buffer.data(), end};
}

/// Centimetres, as a person wrote them: metres * 100 is rounded where that reads back as the same metres.
std::string centimetres(double metres) {
  const double plain = std::round(metres * 1e6) / 1e4;
  return decimal(plain / 100.0 == metres ? plain : metres * 100.0);
}

// Appending, not operator+: g++ 12 sees overlaps that are not there in "literal" + std::string.
std::string list_of(const std::vector<std::string>& texts) {
  std::string out = "[";
  for (const std::string& text : texts) {
    if (out.size() > 1) out += ", ";
    out += toml_string(text);
  }
  out += ']';
  return out;
}

std::string numbers_of(std::initializer_list<std::string> numbers) {
  std::string out = "[";
  for (const std::string& number : numbers) {
    if (out.size() > 1) out += ", ";
    out += number;
  }
  out += ']';
  return out;
}

/// Builds "{ key = value, … }".
class InlineTable {
 public:
  void add(std::string_view key, const std::string& value) {
    text_ += text_.empty() ? "" : ", ";
    text_ += key;
    text_ += " = ";
    text_ += value;
  }
  void add_text(std::string_view key, std::string_view value) {
    if (!value.empty()) add(key, toml_string(value));
  }
  bool empty() const { return text_.empty(); }
  std::string str() const {
    std::string out = "{ ";
    out += text_;
    out += " }";
    return out;
  }

 private:
  std::string text_;
};

void line(std::string& out, std::string_view key, const std::string& value) {
  out += key;
  out += " = ";
  out += value;
  out += '\n';
}

void text_line(std::string& out, std::string_view key, std::string_view value) {
  if (!value.empty()) line(out, key, toml_string(value));
}

std::string review_text(const Review& review) {
  InlineTable table;
  table.add_text("by", review.by);
  table.add_text("on", review.on);
  table.add_text("verdict", to_name(review.verdict));
  table.add_text("remark", review.remark);
  table.add_text("content", review.content);
  return table.str();
}

std::string posture_text(const Posture& posture) {
  InlineTable table;
  table.add_text("shape", posture.handshape);
  table.add_text("fingers", to_name(posture.fingers));
  table.add_text("palm", to_name(posture.palm));
  table.add_text("at", to_name(posture.location));
  if (posture.offset != Vec3(0.0))
    table.add("offset_cm", numbers_of({centimetres(posture.offset.x), centimetres(posture.offset.y),
                                       centimetres(posture.offset.z)}));
  if (posture.contact) {
    InlineTable contact;
    contact.add_text("kind", to_name(posture.contact->kind));
    if (posture.contact->part) contact.add_text("part", to_name(*posture.contact->part));
    if (posture.contact->target) contact.add_text("target", to_name(*posture.contact->target));
    table.add("contact", contact.str());
  }
  return table.str();
}

std::string move_text(const Movement& move, Handedness handedness) {
  InlineTable table;
  table.add_text("kind", to_name(move.kind));
  if (move.direction) table.add_text("direction", to_name(*move.direction));
  if (move.size != Size::kMedium) table.add_text("size", to_name(move.size));
  if (move.repeats != 1) table.add("repeats", std::to_string(move.repeats));
  if (move.hands != usual_hands(handedness)) table.add_text("hands", to_name(move.hands));
  if (move.manner != Manner::kPlain) table.add_text("manner", to_name(move.manner));
  if (move.plane != Plane::kNone) table.add_text("plane", to_name(move.plane));
  if (move.bow) table.add_text("bow", to_name(*move.bow));
  if (move.start) table.add_text("start", to_name(*move.start));
  if (move.eighths != 8) table.add("eighths", std::to_string(move.eighths));
  if (move.ellipse) table.add_text("ellipse", to_name(*move.ellipse));
  if (move.flattening != Size::kMedium) table.add_text("flattening", to_name(move.flattening));
  if (move.growth != Growth::kNone) table.add_text("growth", to_name(move.growth));
  table.add_text("digits", move.digits);
  if (move.pace != 1) table.add("pace", decimal(move.pace));
  table.add("from", std::to_string(move.from));
  table.add("to", std::to_string(move.to));
  return table.str();
}

template <typename T, typename Write>
void write_array(std::string& out, std::string_view key, const std::vector<T>& items, Write&& write) {
  if (items.empty()) return line(out, key, "[]");
  out += key;
  out += " = [\n";
  for (const T& item : items)
    out += "  " + write(item) + ",\n";
  out += "]\n";
}

void write_provenance(std::string& out, const Provenance& provenance, Reviews reviews) {
  line(out, "sources", list_of(provenance.sources));
  text_line(out, "form_evidence", provenance.form_evidence);
  text_line(out, "movement_evidence", provenance.movement_evidence);
  text_line(out, "confidence", to_name(provenance.confidence));
  if (reviews == Reviews::kLeftOut) return;
  text_line(out, "review", to_name(provenance.review));
  text_line(out, "reviewed_by", provenance.reviewed_by);
  text_line(out, "reviewed_on", provenance.reviewed_on);
  if (!provenance.history.empty()) write_array(out, "reviews", provenance.history, review_text);
}

std::string keyword_text(const Keyword& keyword) {
  std::string text = keyword.word;
  if (!keyword.part_of_speech.empty() || keyword.rank != 0) (text += ':') += keyword.part_of_speech;
  if (keyword.rank != 0) (text += ':') += std::to_string(keyword.rank);
  return text;
}

void write_sign(std::string& out, const Sign& sign, const std::vector<std::string>& english,
                Reviews reviews = Reviews::kWritten) {
  ((out += "\n[[") += sign.kind) += "]]\n";
  text_line(out, "gloss", sign.gloss);
  if (!english.empty()) line(out, "english", list_of(english));
  if (sign.region != "all") text_line(out, "region", sign.region);
  text_line(out, "definition", sign.definition);
  text_line(out, "hands", to_name(sign.handedness));
  write_array(out, "dominant", sign.dominant, posture_text);
  if (!sign.non_dominant.empty()) write_array(out, "base", sign.non_dominant, posture_text);
  write_array(out, "moves", sign.movements, [&sign](const Movement& move) { return move_text(move, sign.handedness); });
  InlineTable face;
  const NonManual& nm = sign.non_manual;
  const std::array<const std::string*, kFaceTiers> words = {&nm.brows, &nm.eyes,      &nm.mouth, &nm.cheeks,
                                                            &nm.head,  &nm.shoulders, &nm.gaze,  &nm.face};
  for (size_t i = 0; i < words.size(); ++i)
    face.add_text(tier_name(static_cast<FaceTier>(i)), *words[i]);
  if (!nm.more.empty()) {
    std::string list = "[";
    for (const NonManualFeature& feature : nm.more) {
      InlineTable table;
      table.add_text("tier", feature.tier);
      table.add_text("word", feature.word);
      table.add("from", decimal(feature.from));
      table.add("to", decimal(feature.to));
      if (feature.amount != 1) table.add("amount", decimal(feature.amount));
      if (list.size() > 1) list += ", ";
      list += table.str();
    }
    list += ']';
    face.add("more", list);
  }
  if (!face.empty()) line(out, "face", face.str());
  text_line(out, "mouthing", nm.mouthing);
  if (sign.safety_critical) line(out, "safety_critical", "true");
  write_provenance(out, sign.provenance, reviews);
}

void write_handshape(std::string& out, const Handshape& shape, Reviews reviews = Reviews::kWritten) {
  out += "\n[[handshape]]\n";
  text_line(out, "id", shape.id);
  text_line(out, "name", shape.name);
  if (shape.base != shape.id) text_line(out, "base", shape.base);
  text_line(out, "selected", shape.selected);
  constexpr std::array<std::string_view, 4> kFingers = {"index", "middle", "ring", "little"};
  for (size_t i = 0; i < kFingers.size(); ++i) {
    const FingerAngles& f = shape.fingers[i];
    line(out, kFingers[i], numbers_of({decimal(f.mcp), decimal(f.pip), decimal(f.dip), decimal(f.abduction)}));
  }
  InlineTable thumb;
  thumb.add("radial", decimal(shape.thumb.radial_abduction));
  thumb.add("palmar", decimal(shape.thumb.palmar_abduction));
  thumb.add("opposition", decimal(shape.thumb.opposition));
  thumb.add("mp", decimal(shape.thumb.mp));
  thumb.add("ip", decimal(shape.thumb.ip));
  line(out, "thumb", thumb.str());
  text_line(out, "hamnosys", shape.hamnosys);
  text_line(out, "description", shape.description);
  if (!shape.aliases.empty()) line(out, "aliases", list_of(shape.aliases));
  if (shape.core) line(out, "core", "true");
  if (shape.frequency_rank != 0) line(out, "frequency_rank", std::to_string(shape.frequency_rank));
  write_provenance(out, shape.provenance, reviews);
}

std::string span_text(const NonManualSpan& span) {
  InlineTable table;
  table.add_text("kind", span.kind);
  table.add("from", std::to_string(span.from));
  table.add("to", std::to_string(span.to));
  table.add_text("brows", span.brows);
  table.add_text("head", span.head);
  table.add_text("gaze", span.gaze);
  table.add_text("mouth", span.mouth);
  table.add_text("eyes", span.eyes);
  table.add_text("ending", span.ending);
  return table.str();
}

void write_phrase(std::string& out, const Phrase& phrase, Reviews reviews = Reviews::kWritten) {
  out += "\n[[phrase]]\n";
  text_line(out, "id", phrase.id);
  text_line(out, "domain", phrase.domain);
  text_line(out, "english", phrase.english);
  line(out, "glosses", list_of(phrase.glosses));
  if (!phrase.non_manual.empty()) write_array(out, "spans", phrase.non_manual, span_text);
  text_line(out, "notes", phrase.notes);
  write_provenance(out, phrase.provenance, reviews);
}

}  // namespace

std::vector<TextSource> write_lexicon_text(const LexiconText& text) {
  std::map<std::string, std::vector<std::string>> english;
  for (const Keyword& keyword : text.keywords)
    english[keyword.gloss].push_back(keyword_text(keyword));
  const std::string head(kLicence);
  std::string shapes =
      head + "# Handshapes. Fingers: flexion at mcp, pip, dip and abduction from the middle finger, in degrees.\n";
  std::string letters = head + "# The two-handed alphabet, for a right-handed signer.\n";
  std::string numbers = head + "# Numbers with a sign of their own.\n";
  std::string phrases = head + "# Sentences in signing order, with the spans of their non-manual features.\n";
  std::map<std::string, std::string> categories;
  for (const Handshape& shape : text.handshapes)
    write_handshape(shapes, shape);
  for (const Sign& sign : text.signs) {
    if (sign.kind == "letter") {
      write_sign(letters, sign, english[sign.gloss]);
    } else if (sign.kind == "number") {
      write_sign(numbers, sign, english[sign.gloss]);
    } else {
      std::string& file = categories[sign.category];
      if (file.empty()) file = head + "# Signs: " + sign.category + ". Offsets are centimetres [left, up, away].\n";
      write_sign(file, sign, english[sign.gloss]);
    }
  }
  for (const Phrase& phrase : text.phrases)
    write_phrase(phrases, phrase);
  // An array that has no entries still has its name, so that the file reads.
  if (text.handshapes.empty()) shapes += "handshape = []\n";
  if (letters.find("[[letter]]") == std::string::npos) letters += "letter = []\n";
  if (numbers.find("[[number]]") == std::string::npos) numbers += "number = []\n";
  if (text.phrases.empty()) phrases += "phrase = []\n";
  std::vector<TextSource> sources;
  sources.push_back({"handshapes.toml", std::move(shapes)});
  sources.push_back({"alphabet.toml", std::move(letters)});
  sources.push_back({"numbers.toml", std::move(numbers)});
  for (auto& [category, file] : categories)
    sources.push_back({"signs/" + category + ".toml", std::move(file)});
  sources.push_back({"phrases.toml", std::move(phrases)});
  return sources;
}

std::string content_digest(const Sign& sign, std::span<const Keyword> keywords) {
  std::vector<std::string> english;
  for (const Keyword& keyword : keywords)
    if (keyword.gloss == sign.gloss) english.push_back(keyword_text(keyword));
  std::string text = "# " + sign.category;
  write_sign(text, sign, english, Reviews::kLeftOut);
  return digest_of(text);
}

std::string content_digest(const Handshape& shape) {
  std::string text;
  write_handshape(text, shape, Reviews::kLeftOut);
  return digest_of(text);
}

std::string content_digest(const Phrase& phrase) {
  std::string text;
  write_phrase(text, phrase, Reviews::kLeftOut);
  return digest_of(text);
}

Result<void> save_lexicon_text(const LexiconText& text, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder / "signs", error);
  if (error)
    return fail(ErrorCode::kUnwritable, "cannot make it (" + error.message() + ")", (folder / "signs").string());
  for (const TextSource& source : write_lexicon_text(text)) {
    Result<void> written = write_whole_file(folder / source.name, source.text);
    if (!written) return written;
  }
  return {};
}

}  // namespace auslan
