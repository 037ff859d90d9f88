// SPDX-License-Identifier: Apache-2.0
#include "lexicon/lexicon_check.h"

#include "lexicon/face_words.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace auslan {
namespace {

constexpr size_t kMaxPhases = 96;
constexpr size_t kMaxMoves = 200;
constexpr size_t kMaxFeatures = 64;
constexpr size_t kMaxDefinition = 600;
constexpr size_t kMaxName = 200, kMaxRemark = 2000, kMaxReviews = 200;
constexpr double kMaxOffset = 0.6;  // metres: no hand is further from its site
constexpr std::array<std::string_view, 3> kKinds = {"sign", "letter", "number"};
constexpr std::array<std::string_view, 11> kRegions = {"all", "north", "south", "act", "nsw", "nt",
                                                       "qld", "sa",    "tas",   "vic", "wa"};
constexpr std::array<std::string_view, 4> kSlots = {"{NAME}", "{NUMBER}", "{TIME}", "{WORD}"};

bool is_capital(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_small(char c) {
  return c >= 'a' && c <= 'z';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

template <typename Range>
bool contains(const Range& range, std::string_view word) {
  return std::ranges::find(range, word) != std::ranges::end(range);
}

/// Words of small letters and digits with single hyphens or underscores between.
bool is_slug(std::string_view text) {
  if (text.empty() || text.size() > 60) return false;
  char before = '-';
  for (const char c : text) {
    const bool joint = c == '-' || c == '_';
    if (!(is_small(c) || is_digit(c) || joint) || (joint && (before == '-' || before == '_'))) return false;
    before = c;
  }
  return before != '-' && before != '_';
}

bool all_digits(std::string_view text) {
  return !text.empty() && text.size() <= 18 && std::ranges::all_of(text, is_digit);
}

bool is_capital_gloss(std::string_view text) {
  if (text.empty() || text.size() > 60 || !is_capital(text.front()) || text.back() == '-') return false;
  char before = '-';
  for (const char c : text) {
    if (!(is_capital(c) || is_digit(c) || c == '-') || (c == '-' && before == '-')) return false;
    before = c;
  }
  return true;
}

bool is_iso_date(std::string_view date) {
  if (date.size() != 10) return false;
  for (size_t i = 0; i < date.size(); ++i)
    if ((i == 4 || i == 7) ? date[i] != '-' : !is_digit(date[i])) return false;
  const std::string_view month = date.substr(5, 2);
  const std::string_view day = date.substr(8, 2);
  return month >= "01" && month <= "12" && day >= "01" && day <= "31";
}

/// Collects the findings of one entry.
class Findings {
 public:
  Findings(std::vector<Finding>& list, std::string entry) : list_(list), entry_(std::move(entry)) {}
  void add(std::string part, std::string message) { list_.push_back({entry_, std::move(part), std::move(message)}); }
  void require(bool condition, std::string_view part, std::string_view message) {
    if (!condition) add(std::string(part), std::string(message));
  }

 private:
  std::vector<Finding>& list_;
  std::string entry_;
};

std::string indexed(std::string_view part, size_t index) {
  return std::string(part) + "[" + std::to_string(index) + "]";
}

void check_provenance(const Provenance& provenance, Findings& findings) {
  findings.require(!provenance.sources.empty(), "sources", "no source; expected at least one tag of SOURCES.md");
  for (const std::string& tag : provenance.sources) {
    const bool good = !tag.empty() && std::ranges::all_of(tag, [](char c) {
      return is_capital(c) || is_small(c) || is_digit(c) || c == '-';
    });
    if (!good) findings.add("sources", "source tag \"" + tag + "\"; expected letters, digits and hyphens");
  }
  const bool decided = provenance.review != ReviewState::kUnreviewed;
  if (decided)
    findings.require(!provenance.reviewed_by.empty() && is_iso_date(provenance.reviewed_on), "review",
                     "a decided review needs reviewed_by and reviewed_on (YYYY-MM-DD)");
  else
    findings.require(provenance.reviewed_by.empty() && provenance.reviewed_on.empty(), "review",
                     "reviewed_by or reviewed_on without a decided review");
  for (size_t i = 0; i < provenance.history.size(); ++i) {
    const Review& review = provenance.history[i];
    findings.require(!review.by.empty() && review.by.size() <= kMaxName && is_iso_date(review.on),
                     indexed("reviews", i), "a review needs by (at most 200 bytes) and on (YYYY-MM-DD)");
    findings.require(review.remark.size() <= kMaxRemark, indexed("reviews", i), "a remark of more than 2000 bytes");
    const bool digest = review.content.size() == 32 && std::ranges::all_of(review.content, [](char c) {
                          return is_digit(c) || (c >= 'a' && c <= 'f');
                        });
    findings.require(review.content.empty() || digest, indexed("reviews", i),
                     "content; expected 32 hexadecimal digits");
  }
  if (provenance.history.empty()) return;
  const Review& last = provenance.history.back();
  findings.require(provenance.history.size() <= kMaxReviews, "reviews", "more than 200 reviews");
  findings.require(last.verdict == provenance.review &&
                       (!decided || (last.by == provenance.reviewed_by && last.on == provenance.reviewed_on)),
                   "review", "review, reviewed_by and reviewed_on do not say what the last of reviews says");
}

/// A decided review holds for what was looked at.
void check_reviewed_content(const Provenance& provenance, const std::string& content, Findings& findings) {
  if (provenance.review == ReviewState::kUnreviewed || provenance.history.empty()) return;
  const std::string& seen = provenance.history.back().content;
  findings.require(
      seen.empty() || seen == content, "review",
      "the entry was changed after this review; review it again, or set review to \"unreviewed\" and add a "
      "review that says so");
}

void check_face(const NonManual& face, Findings& findings) {
  const std::array<const std::string*, kFaceTiers> words = {&face.brows, &face.eyes,      &face.mouth, &face.cheeks,
                                                            &face.head,  &face.shoulders, &face.gaze,  &face.face};
  for (size_t i = 0; i < words.size(); ++i) {
    const auto channel = static_cast<FaceTier>(i);
    if (!is_face_word(channel, *words[i]))
      findings.add("face",
                   std::string(tier_name(channel)) + " is \"" + *words[i] + "\", which is not in the vocabulary");
  }
  findings.require(face.more.size() <= kMaxFeatures, "face", "more than 64 features in parts of the sign");
  for (const NonManualFeature& feature : face.more) {
    bool known = feature.tier == "mouthing" && !feature.word.empty();
    for (size_t i = 0; i < words.size(); ++i)
      known = known || (feature.tier == tier_name(static_cast<FaceTier>(i)) && !feature.word.empty() &&
                        is_face_word(static_cast<FaceTier>(i), feature.word));
    if (!known)
      findings.add("face", "the feature " + feature.tier + " \"" + feature.word + "\" is not in the vocabulary");
    findings.require(feature.from >= 0 && feature.from <= feature.to && feature.to <= 1, "face",
                     "a feature's from and to; expected shares of the sign's time, 0 to 1");
    findings.require(feature.amount >= 0 && feature.amount <= 4, "face", "a feature's amount; expected 0 to 4");
  }
}

/// The palm must face across the fingers: between 53 and 127 degrees from them. Nearer than that the two directions say
/// nothing about the turn of the forearm that could be trusted.
bool is_across(const Direction& a, const Direction& b) {
  const auto product = [](const Direction& one, const Direction& two) {
    return static_cast<double>(one.left) * two.left + static_cast<double>(one.up) * two.up +
           static_cast<double>(one.away) * two.away;
  };
  const double dot = product(a, b), length_a = product(a, a), length_b = product(b, b);
  return length_a > 0 && length_b > 0 && 100 * dot * dot <= 36 * length_a * length_b;
}

void check_posture(const Posture& posture, const std::string& part, Findings& findings) {
  findings.require(!posture.handshape.empty(), part, "no handshape");
  findings.require(is_across(posture.fingers, posture.palm), part,
                   "palm " + to_name(posture.palm) + " faces along fingers " + to_name(posture.fingers) +
                       "; expected a palm that faces across them");
  for (const double v : {posture.offset.x, posture.offset.y, posture.offset.z})
    if (!(std::fabs(v) <= kMaxOffset)) {
      findings.add(part, "the offset is more than 60 cm; expected centimetres [left, up, away]");
      break;
    }
}

void check_hands(const Sign& sign, Findings& findings) {
  const bool one = sign.handedness == Handedness::kOne;
  const bool mirrored = is_mirrored(sign.handedness);
  const size_t phases = sign.dominant.size();
  const size_t base = sign.non_dominant.size();
  findings.require(phases >= 1 && phases <= kMaxPhases, "dominant", "expected 1 to 96 phases of the dominant hand");
  if (one) findings.require(base == 0, "base", "a one-handed sign has no base hand");
  if (mirrored)
    findings.require(base == 0, "base", "the other hand of a symmetric sign is its mirror image: leave base out");
  if (sign.handedness == Handedness::kDominantBase)
    findings.require(base == 1 || (base > 1 && base == phases), "base",
                     "expected one phase (a base that stays) or as many as the dominant hand has");
  for (size_t i = 0; i < phases; ++i) {
    const Posture& posture = sign.dominant[i];
    const std::string part = indexed("dominant", i);
    check_posture(posture, part, findings);
    if (one && (is_on_other_hand(posture.location) ||
                (posture.contact && posture.contact->target && is_on_other_hand(*posture.contact->target))))
      findings.add(part, "a one-handed sign cannot be placed on the other hand");
    if (mirrored && is_on_other_hand(posture.location) && posture.location != Location::kHands)
      findings.add(part, "mirrored hands cannot each be placed on the other; expected hands, a body site or space");
  }
  for (size_t i = 0; i < base; ++i) {
    check_posture(sign.non_dominant[i], indexed("base", i), findings);
    if (is_on_other_hand(sign.non_dominant[i].location))
      findings.add(indexed("base", i), "the base cannot be placed on the dominant hand; expected a body site or space");
  }
}

void check_moves(const Sign& sign, Findings& findings) {
  using enum MoveKind;
  findings.require(sign.movements.size() <= kMaxMoves, "moves", "more than 200 movements");
  const int phases = static_cast<int>(sign.dominant.size());
  for (size_t i = 0; i < sign.movements.size(); ++i) {
    const Movement& move = sign.movements[i];
    const std::string part = indexed("moves", i);
    if (move.from < 0 || move.to < move.from || move.to >= phases)
      findings.add(part, "from " + std::to_string(move.from) + " to " + std::to_string(move.to) +
                             " is out of range; expected 0 <= from <= to < " + std::to_string(phases) +
                             ", the number of phases");
    findings.require(move.repeats >= 1 && move.repeats <= 24, part, "repeats; expected 1 to 24");
    findings.require(move.eighths >= 1 && move.eighths <= 64, part, "eighths of a turn; expected 1 to 64");
    findings.require(move.pace >= 0.1 && move.pace <= 10, part, "pace; expected 0.1 to 10");
    findings.require(move.digits.find_first_not_of("12345") == std::string::npos && move.digits.size() <= 5, part,
                     "digits; expected some of 1 (the thumb) to 5 (the little finger)");
    const bool path = move.kind == kStraight || move.kind == kArc || move.kind == kZigzag || move.kind == kWavy;
    if (path && move.from == move.to)
      findings.require(move.direction.has_value(), part, "a path within one phase needs a direction");
    if (sign.handedness == Handedness::kOne)
      findings.require(move.hands == MovingHands::kDominant, part, "a one-handed sign moves only the dominant hand");
  }
}

}  // namespace

bool is_gloss(std::string_view gloss) {
  if (gloss.starts_with("fs:")) return gloss.size() == 4 && is_capital(gloss[3]);
  if (gloss.starts_with("num:")) return all_digits(gloss.substr(4)) && (gloss.size() == 5 || gloss[4] != '0');
  return is_capital_gloss(gloss);
}

bool is_phrase_item(std::string_view item) {
  if (item.starts_with("{")) return contains(kSlots, item);
  if (item.starts_with("fs:")) return is_capital_gloss(item.substr(3));
  if (item.starts_with("num:")) return all_digits(item.substr(4));
  return is_capital_gloss(item);
}

std::vector<Finding> check_sign(const Sign& sign) {
  std::vector<Finding> list;
  Findings findings(list, sign.gloss);
  findings.require(is_gloss(sign.gloss), "gloss",
                   "expected capital letters, digits and hyphens, fs:LETTER or num:DIGITS");
  findings.require(contains(kKinds, sign.kind), "kind", "expected sign, letter or number");
  const std::string_view kind = sign.gloss.starts_with("fs:")    ? "letter"
                                : sign.gloss.starts_with("num:") ? "number"
                                                                 : "sign";
  findings.require(sign.kind == kind, "gloss", "the gloss is not that of a " + sign.kind);
  findings.require(is_slug(sign.category), "category",
                   "expected a category of small letters, as in signs/CATEGORY.toml");
  findings.require(
      contains(kRegions, sign.region), "region", "expected " + [] {
        std::string all;
        for (const std::string_view region : kRegions)
          (all += all.empty() ? "" : ", ") += region;
        return all;
      }());
  findings.require(!sign.definition.empty() && sign.definition.size() <= kMaxDefinition, "definition",
                   "expected 1 to 600 bytes on how the sign looks");
  check_hands(sign, findings);
  check_moves(sign, findings);
  check_face(sign.non_manual, findings);
  check_provenance(sign.provenance, findings);
  findings.require(!sign.provenance.form_evidence.empty(), "form_evidence",
                   "expected what handshape and location rest on");
  findings.require(!sign.provenance.movement_evidence.empty(), "movement_evidence",
                   "expected what the movement rests on");
  return list;
}

std::vector<Finding> check_handshape(const Handshape& shape) {
  std::vector<Finding> list;
  Findings findings(list, "handshape " + shape.id);
  findings.require(is_slug(shape.id), "id", "expected small letters, digits and underscores");
  findings.require(!shape.name.empty(), "name", "expected a name");
  findings.require(!shape.description.empty(), "description", "expected a description");
  const auto within = [&findings](double value, double least, double most, const char* part) {
    if (!(value >= least && value <= most))
      findings.add(part, "an angle is out of range; expected " + std::to_string(static_cast<int>(least)) + " to " +
                             std::to_string(static_cast<int>(most)));
  };
  constexpr std::array<const char*, 4> kFingers = {"index", "middle", "ring", "little"};
  for (size_t i = 0; i < kFingers.size(); ++i) {
    within(shape.fingers[i].mcp, -45, 110, kFingers[i]);
    within(shape.fingers[i].pip, -15, 130, kFingers[i]);
    within(shape.fingers[i].dip, -30, 100, kFingers[i]);
    within(shape.fingers[i].abduction, -45, 45, kFingers[i]);
  }
  within(shape.thumb.radial_abduction, -30, 90, "thumb");
  within(shape.thumb.palmar_abduction, -30, 90, "thumb");
  within(shape.thumb.opposition, 0, 1, "thumb");
  within(shape.thumb.mp, -30, 90, "thumb");
  within(shape.thumb.ip, -45, 100, "thumb");
  constexpr std::array<std::string_view, 7> kSelected = {"none", "all", "thumb", "index", "middle", "ring", "little"};
  for (size_t start = 0; start <= shape.selected.size();) {
    const size_t end = std::min(shape.selected.find('+', start), shape.selected.size());
    if (!contains(kSelected, std::string_view(shape.selected).substr(start, end - start))) {
      findings.add("selected", "expected digits joined by +, as \"index+middle\", or \"all\" or \"none\"");
      break;
    }
    start = end + 1;
  }
  findings.require(shape.frequency_rank >= 0 && shape.frequency_rank <= 999, "frequency_rank", "expected 0 to 999");
  check_provenance(shape.provenance, findings);
  return list;
}

std::vector<Finding> check_phrase(const Phrase& phrase) {
  std::vector<Finding> list;
  Findings findings(list, "phrase " + phrase.id);
  findings.require(is_slug(phrase.id), "id", "expected small letters, digits and hyphens");
  findings.require(is_slug(phrase.domain), "domain", "expected small letters");
  findings.require(!phrase.english.empty(), "english", "expected the English sentence");
  findings.require(!phrase.glosses.empty() && phrase.glosses.size() <= 32, "glosses", "expected 1 to 32 items");
  for (const std::string& item : phrase.glosses)
    if (!is_phrase_item(item))
      findings.add("glosses", "item \"" + item + "\"; expected a GLOSS, fs:TEXT, num:DIGITS or a slot such as {NAME}");
  // A slot that only one side names would stay empty, or swallow what was typed.
  for (const std::string_view slot : kSlots) {
    const bool typed = phrase.english.find(slot) != std::string::npos;
    findings.require(typed == contains(phrase.glosses, slot), "glosses",
                     "the slot " + std::string(slot) + " must be in both english and glosses");
  }
  for (size_t i = 0; i < phrase.non_manual.size(); ++i) {
    const NonManualSpan& span = phrase.non_manual[i];
    const std::string part = indexed("spans", i);
    findings.require(contains(span_kinds(), span.kind), part, "unknown kind of span");
    if (span.from < 0 || span.to < span.from || span.to >= static_cast<int>(phrase.glosses.size()))
      findings.add(part, "from and to are out of range; expected indexes of glosses, both ends included");
    findings.require(span.ending.empty() || contains(span_endings(), span.ending), part, "unknown ending of a span");
    using enum FaceTier;
    findings.require(is_face_word(kBrows, span.brows) && is_face_word(kHead, span.head) &&
                         is_face_word(kGaze, span.gaze) && is_face_word(kMouth, span.mouth) &&
                         is_face_word(kEyes, span.eyes),
                     part, "a word that is not in the vocabulary of its channel");
  }
  check_provenance(phrase.provenance, findings);
  return list;
}

namespace {

void append(std::vector<Finding>& list, std::vector<Finding>&& more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

bool is_keyword(std::string_view word) {
  if (word.empty() || word.size() > 60 || word.front() == ' ' || word.back() == ' ') return false;
  if (word.find("  ") != std::string_view::npos) return false;
  return std::ranges::all_of(
      word, [](char c) { return is_small(c) || is_digit(c) || c == ' ' || c == '\'' || c == '-' || c == '.'; });
}

void check_keywords(const LexiconText& text, const std::set<std::string_view>& glosses, std::vector<Finding>& list) {
  std::set<std::string_view> spoken;
  std::map<std::tuple<std::string_view, std::string_view, int>, std::string_view> first_choice;
  std::map<std::string_view, size_t> counts;
  for (const Keyword& keyword : text.keywords) {
    Findings findings(list, keyword.gloss);
    const std::string part = indexed("english", counts[keyword.gloss]++);
    spoken.insert(keyword.gloss);
    findings.require(glosses.contains(keyword.gloss), part, "a keyword for an entry that does not exist");
    findings.require(is_keyword(keyword.word), part,
                     "keyword \"" + keyword.word + "\"; expected a lower-case word or words");
    findings.require(keyword.part_of_speech.empty() || contains(parts_of_speech(), keyword.part_of_speech), part,
                     "unknown part of speech \"" + keyword.part_of_speech + "\"");
    findings.require(keyword.rank >= 0 && keyword.rank <= 99, part, "rank; expected 0 to 99");
    const auto [found, fresh] =
        first_choice.insert({{keyword.word, keyword.part_of_speech, keyword.rank}, keyword.gloss});
    if (!fresh)
      findings.add(part, "\"" + keyword.word + "\" is choice " + std::to_string(keyword.rank) + " of " +
                             std::string(found->second) + " already; give one of them another rank (word:pos:rank)");
  }
  for (const Sign& sign : text.signs)
    if (sign.kind == "sign" && !spoken.contains(sign.gloss))
      list.push_back({sign.gloss, "english", "no English keyword, so that nobody can find the sign"});
}

}  // namespace

std::vector<Finding> check_lexicon(const LexiconText& text) {
  std::vector<Finding> list;
  std::set<std::string_view> shapes;
  for (const Handshape& shape : text.handshapes) {
    append(list, check_handshape(shape));
    Findings findings(list, "handshape " + shape.id);
    check_reviewed_content(shape.provenance, content_digest(shape), findings);
    if (!shapes.insert(shape.id).second) list.push_back({"handshape " + shape.id, "id", "the id is used twice"});
  }
  for (const Handshape& shape : text.handshapes)
    if (!shapes.contains(shape.base))
      list.push_back({"handshape " + shape.id, "base", "the base handshape \"" + shape.base + "\" does not exist"});

  std::set<std::string_view> glosses;
  for (const Sign& sign : text.signs) {
    append(list, check_sign(sign));
    if (sign.provenance.review != ReviewState::kUnreviewed) {
      Findings findings(list, sign.gloss);
      check_reviewed_content(sign.provenance, content_digest(sign, text.keywords), findings);
    }
    if (!glosses.insert(sign.gloss).second) list.push_back({sign.gloss, "gloss", "the gloss is used twice"});
    const auto check_shapes = [&](const std::vector<Posture>& postures, std::string_view part) {
      for (size_t i = 0; i < postures.size(); ++i)
        if (!postures[i].handshape.empty() && !shapes.contains(postures[i].handshape))
          list.push_back(
              {sign.gloss, indexed(part, i),
               "the handshape \"" + postures[i].handshape + "\" does not exist; expected an id of handshapes.toml"});
    };
    check_shapes(sign.dominant, "dominant");
    check_shapes(sign.non_dominant, "base");
  }
  check_keywords(text, glosses, list);

  std::set<std::string_view> phrases;
  for (const Phrase& phrase : text.phrases) {
    append(list, check_phrase(phrase));
    Findings findings(list, "phrase " + phrase.id);
    check_reviewed_content(phrase.provenance, content_digest(phrase), findings);
    if (!phrases.insert(phrase.id).second) list.push_back({"phrase " + phrase.id, "id", "the id is used twice"});
    for (const std::string& item : phrase.glosses)
      if (is_capital_gloss(item) && !glosses.contains(item))
        list.push_back({"phrase " + phrase.id, "glosses", "the gloss \"" + item + "\" does not exist"});
  }
  return list;
}

}  // namespace auslan
