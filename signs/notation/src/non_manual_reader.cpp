// SPDX-License-Identifier: Apache-2.0
// The non-manual tiers, in the words that the model has for the face and the head.
#include "element.h"
#include "mouth_spelling.h"
#include "written_of.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace auslan::notation {
namespace {

struct Feature {
  std::string_view tag;
  std::string_view word;  ///< of the model
};

using Table = std::initializer_list<Feature>;

/// When a feature is shown, in shares of the sign, and how strongly.
struct When {
  double from = 0, to = 1, amount = 1;
};

/// A tier of the model: its member and its name.
struct Tier {
  std::string NonManual::*member;
  std::string_view name;
};
constexpr Tier kBrowTier = {&NonManual::brows, "brows"}, kEyeTier = {&NonManual::eyes, "eyes"},
               kMouthTier = {&NonManual::mouth, "mouth"}, kHeadTier = {&NonManual::head, "head"},
               kShoulderTier = {&NonManual::shoulders, "shoulders"}, kGazeTier = {&NonManual::gaze, "gaze"},
               kFaceTier = {&NonManual::face, "face"}, kMouthingTier = {&NonManual::mouthing, "mouthing"};

/// What lasts for the whole sign is the tier's word; a second one, or one for a part of the time, is added to it.
void put(NonManual& face, const Tier& tier, std::string_view word, const When& when, const Element& element) {
  std::string& whole = face.*tier.member;
  if (whole.empty() && when.from == 0 && when.to == 1 && when.amount == 1) {
    whole = word;
    return;
  }
  if (whole == word && when.from == 0 && when.to == 1 && when.amount == 1) return;
  if (face.more.size() >= 64) {
    element.findings().left_out(element.mark(), "more than 64 non-manual features; the rest is left out");
    return;
  }
  face.more.push_back({std::string(tier.name), std::string(word), when.from, when.to, when.amount});
}

/// Sets a tier of the model from a tag. Everything that is not carried as written is told.
void set(NonManual& face, const Tier& tier, Table table, const std::string& tag, std::string_view what,
         const When& when, const Element& element) {
  Findings& findings = element.findings();
  if (tag.empty()) {
    findings.left_out(element.mark(), "the element " + in_quotes(element.name()) + " says nothing");
    return;
  }
  if (tag == "neutral" || tag == "NEUTRAL") return;
  const auto found = std::ranges::find(table, std::string_view(tag), &Feature::tag);
  if (found == table.end()) {
    std::string expected;
    for (const Feature& feature : table)
      (expected += expected.empty() ? "" : " ") += feature.tag;
    findings.left_out(element.mark(), "the " + std::string(what) + " " + in_quotes(tag) +
                                          " is not known and is left out (expected " + expected + ")");
    return;
  }
  put(face, tier, found->word, when, element);
}

const Table kBrows = {{"RB", "raise"}, {"RR", "raise-right"}, {"RL", "raise-left"}, {"FU", "furrow"}, {"DN", "furrow"}};
const Table kEyes = {{"WB", "wide"},         {"WR", "wide-right"},  {"WL", "wide-left"},    {"SB", "narrow"},
                     {"SR", "narrow-right"}, {"SL", "narrow-left"}, {"CB", "closed"},       {"CR", "closed-right"},
                     {"CL", "closed-left"},  {"TB", "squint"},      {"TR", "squint-right"}, {"TL", "squint-left"},
                     {"BB", "blink"}};
const Table kGaze = {{"AD", "addressee"},
                     {"FR", "far"},
                     {"HD", "down-to-hand"},
                     {"HI", "down-to-hand"},
                     {"HC", "down-to-other-hand"},
                     {"DN", "down"},
                     {"UP", "up"},
                     {"LE", "left"},
                     {"RI", "right"},
                     {"LU", "left-up"},
                     {"LD", "left-down"},
                     {"RU", "right-up"},
                     {"RD", "right-down"},
                     {"NO", "unfocused"},
                     {"RO", "rolling"}};
const Table kHead = {{"NO", "nod"},       {"SH", "shake"},     {"SR", "turn-right"},   {"SL", "turn-left"},
                     {"TR", "tilt"},      {"TL", "tilt-left"}, {"NF", "tilt-forward"}, {"NB", "tilt-back-slight"},
                     {"PF", "forward"},   {"PB", "back"},      {"LI", "follow-gaze"},  {"NU", "nod-up"},
                     {"ND", "nod-slight"}};
// Shoulder movements are met with the tags of the head's nods, too.
const Table kShoulders = {{"UB", "raised"},       {"UL", "raised-left"},   {"UR", "raised-right"}, {"HB", "hunched"},
                          {"HL", "hunched-left"}, {"HR", "hunched-right"}, {"SB", "shrug"},        {"SL", "shrug-left"},
                          {"SR", "shrug-right"},  {"ND", "drop"},          {"NU", "raised"}};
const Table kBody = {{"TF", "lean-forward"}, {"TB", "lean-back"},  {"TL", "lean-left"}, {"TR", "lean-right"},
                     {"RL", "body-left"},    {"RR", "body-right"}, {"ST", "straight"},  {"SI", "sigh"},
                     {"HE", "heave"},        {"RD", "rounded"}};
const Table kNose = {{"WR", "nose-wrinkled"}, {"TW", "nose-twitch"}, {"WI", "nose-widened"}};
// Gestures that the lexicon has a word for; the others are carried by their codes.
const Table kMouth = {{"D01", "teeth-showing"}, {"L01", "shh"},     {"L04", "pursed"}, {"L05", "ow"},
                      {"L20", "blow"},          {"L23", "pressed"}, {"C01", "puffed"}, {"L31", "down-turned"},
                      {"L34", "stretched"}};

bool is_mouth_gesture(const std::string& tag) {
  struct Letter {
    char letter;
    int last;
  };
  if (tag.size() != 3 || tag[1] < '0' || tag[1] > '9' || tag[2] < '0' || tag[2] > '9') return false;
  const int number = (tag[1] - '0') * 10 + (tag[2] - '0');
  for (const Letter& kind : {Letter{'D', 9}, Letter{'J', 4}, Letter{'L', 35}, Letter{'C', 13}, Letter{'T', 17}}) {
    if (tag[0] == kind.letter) return number >= 1 && number <= kind.last;
  }
  return false;
}

void set_mouth(NonManual& face, const std::string& tag, const When& when, const Element& element) {
  const bool has_word = std::ranges::find(kMouth, std::string_view(tag), &Feature::tag) != kMouth.end();
  if (has_word || tag.empty() || tag == "neutral") {
    set(face, kMouthTier, kMouth, tag, "mouth gesture", when, element);
  } else if (is_mouth_gesture(tag)) {
    put(face, kMouthTier, tag, when, element);
  } else {
    element.findings().left_out(element.mark(), "the mouth gesture " + in_quotes(tag) +
                                                    " is not known and is left out (expected D01 to D09, J01 to J04, "
                                                    "L01 to L35, C01 to C13 or T01 to T17)");
  }
}

void set_mouthing(const std::string& picture, NonManual& face, const When& when, const Element& element) {
  Findings& findings = element.findings();
  if (picture.empty()) {
    findings.note(element.mark(), "an empty mouth picture: nothing is mouthed");
    return;
  }
  const std::string spelling = spelling_of_sampa(picture);
  if (spelling.empty()) {
    findings.left_out(element.mark(), "the mouth picture " + in_quotes(picture) + " has no sound that is known");
    return;
  }
  findings.note(element.mark(), "the mouth picture " + in_quotes(picture) + " is mouthed as " + in_quotes(spelling));
  const bool alone = when.from == 0 && when.to == 1;
  if (alone && !face.mouthing.empty()) {
    face.mouthing += " " + spelling;
  } else {
    put(face, kMouthingTier, spelling, {when.from, when.to, 1}, element);
  }
}

std::optional<double> number(Element& element, const char* attribute, double least, double most) {
  const std::string value = element.text(attribute);
  if (value.empty()) return std::nullopt;
  double result = 0;
  const auto [rest, error] = std::from_chars(value.data(), value.data() + value.size(), result);
  if (error != std::errc() || rest != value.data() + value.size() || !(result >= least && result <= most)) {
    element.findings().left_out(element.mark(), "the value " + in_quotes(value) + " of the attribute " + attribute +
                                                    " is not a number in its range; left out");
    return std::nullopt;
  }
  return result;
}

/// A tier's or group's shift against the manual part.
void synchronise(Element& element, When& when) {
  const std::string before = element.text("presynchronization"), after = element.text("postsynchronization");
  constexpr double kShift = 0.12;
  const auto unknown = [&element](const std::string& value) {
    element.findings().left_out(element.mark(), "the synchronisation " + in_quotes(value) +
                                                    " is not known and is left out (expected slight_delay, "
                                                    "start_slightly_ahead, lasts_longer or ends_before)");
  };
  const double length = when.to - when.from;
  if (before == "slight_delay") {
    when.from += kShift * length;
  } else if (before == "start_slightly_ahead") {
    element.findings().note(element.mark(), "what starts ahead of the sign rises on the way to it, as every feature");
  } else if (!before.empty()) {
    unknown(before);
  }
  if (after == "ends_before") {
    when.to -= kShift * length;
  } else if (after == "lasts_longer") {
    element.findings().note(element.mark(), "what lasts longer than the sign falls after it, as every feature");
  } else if (!after.empty()) {
    unknown(after);
  }
}

/// How long a feature takes against its neighbours: half as long where it is twice as fast.
double weight_of(const pugi::xml_node& node) {
  const std::string value = node.attribute("speed").value();
  double speed = 1;
  std::from_chars(value.data(), value.data() + value.size(), speed);
  return speed >= 0.05 && speed <= 20 ? 1.0 / speed : 1.0;
}

/// One movement on any tier.
void read_feature(Element& element, NonManual& face, When when, bool alone) {
  const std::string_view name = element.name();
  if (const auto amount = number(element, "amount", 0, 4)) when.amount = *amount;
  if (element.flag("big")) when.amount = std::max(when.amount, 1.5);
  if (const auto speed = number(element, "speed", 0.05, 20); speed && alone) {
    // Faster than the sign it is over before it; slower it takes all its time.
    if (*speed > 1) when.to = when.from + (when.to - when.from) / *speed;
  }
  element.not_carried({"duration"});
  synchronise(element, when);
  const auto movement = [&element] {
    const std::string tag = element.text("tag");
    const std::string value = element.text("movement");
    return value.empty() ? tag : value;
  };
  const auto is = [name](std::string_view gestural, std::string_view hns) { return name == gestural || name == hns; };
  if (is("shoulder_movement", "hnm_shoulder")) {
    set(face, kShoulderTier, kShoulders, movement(), "shoulder movement", when, element);
  } else if (is("body_movement", "hnm_body")) {
    set(face, kHeadTier, kBody, movement(), "body movement", when, element);
  } else if (is("head_movement", "hnm_head")) {
    set(face, kHeadTier, kHead, movement(), "head movement", when, element);
  } else if (is("eye_gaze", "hnm_eyegaze")) {
    const std::string direction = element.text("direction");
    const std::string old = movement();
    set(face, kGazeTier, kGaze, direction.empty() ? old : direction, "gaze", when, element);
  } else if (is("eye_brows", "hnm_eyebrows")) {
    set(face, kBrowTier, kBrows, movement(), "eyebrow movement", when, element);
  } else if (is("eye_lids", "hnm_eyelids")) {
    set(face, kEyeTier, kEyes, movement(), "eyelid movement", when, element);
  } else if (is("nose", "hnm_nose")) {
    set(face, kFaceTier, kNose, movement(), "nose movement", when, element);
  } else if (is("mouth_gesture", "hnm_mouthgesture")) {
    set_mouth(face, movement(), when, element);
  } else if (is("mouth_picture", "hnm_mouthpicture")) {
    set_mouthing(element.text("picture"), face, when, element);
  } else if (name == "mouth_meta" || is("extra_movement", "hnm_extra")) {
    element.findings().left_out(element.mark(),
                                "the element " + in_quotes(name) + " is of one player's own making and is left out");
    return;
  } else if (name == "neutral") {
    return;
  } else {
    element.findings().left_out(
        element.mark(), "the element " + in_quotes(name) + " is not known in a non-manual tier and is left out");
    return;
  }
  element.done();
}

bool is_group(std::string_view name) {
  return name.ends_with("_par") || name.ends_with("_seq") || name.ends_with("_tier");
}

/// What is in a tier comes one after another, what is in a *_par at the same time.
void read_group(Element& group, NonManual& face, When when, bool outer) {
  synchronise(group, when);
  if (group.flag("fitpicturetomanual"))
    group.findings().note(group.mark(), "mouth pictures are fitted to the sign in any case");
  group.done();
  const bool in_turn = !outer && !group.name().ends_with("_par");
  double whole = 0;
  size_t count = 0;
  group.each_child([&](Element& child) {
    whole += weight_of(child.node());
    ++count;
  });
  double at = 0;
  group.each_child([&](Element& child) {
    When part = when;
    if (in_turn && count > 1) {
      const double length = when.to - when.from;
      part.from = when.from + length * at / whole;
      at += weight_of(child.node());
      part.to = std::min(when.to, when.from + length * at / whole);
    }
    if (is_group(child.name())) {
      read_group(child, face, part, false);
    } else {
      read_feature(child, face, part, !in_turn || count == 1);
    }
  });
}

}  // namespace

void read_tiers(Element& tiers, NonManual& face) {
  read_group(tiers, face, {}, true);
}

void read_hnm(Element& elements, NonManual& face) {
  read_group(elements, face, {}, true);
}

std::optional<WrittenFeature> feature_of(std::string_view tier, std::string_view word) {
  struct Written {
    std::string_view tier, element;
    const Table* table;
  };
  for (const Written& written :
       {Written{"brows", "hnm_eyebrows", &kBrows}, Written{"eyes", "hnm_eyelids", &kEyes},
        Written{"gaze", "hnm_eyegaze", &kGaze}, Written{"head", "hnm_head", &kHead},
        Written{"shoulders", "hnm_shoulder", &kShoulders}, Written{"shoulders", "hnm_body", &kBody},
        Written{"face", "hnm_nose", &kNose}, Written{"mouth", "hnm_mouthgesture", &kMouth},
        Written{"cheeks", "hnm_mouthgesture", &kMouth}}) {
    if (written.tier != tier) continue;
    const auto found = std::ranges::find(*written.table, word, &Feature::word);
    if (found != written.table->end()) return WrittenFeature{written.element, found->tag};
  }
  if (tier == "mouth" && is_mouth_gesture(std::string(word))) return WrittenFeature{"hnm_mouthgesture", word};
  return std::nullopt;
}

}  // namespace auslan::notation
