// SPDX-License-Identifier: Apache-2.0
// The non-manual tiers, in the words that the model has for the face and the head. The model holds one feature a tier
// and no time within the sign: sequences keep their first element.
#include "element.h"
#include "mouth_spelling.h"

#include <algorithm>

namespace auslan::notation {
namespace {

struct Feature {
  std::string_view tag;
  std::string_view word;  ///< of the model; empty: nothing to carry
  bool exact = true;
};

using Table = std::initializer_list<Feature>;

/// Sets a tier of the model from a tag. Everything that is not carried as written is told.
void set(std::string& tier, Table table, const std::string& tag, std::string_view what, const Element& element) {
  Findings& findings = element.findings();
  if (tag.empty()) {
    findings.warning(element.mark(), "the element " + in_quotes(element.name()) + " says nothing");
    return;
  }
  if (tag == "neutral" || tag == "NEUTRAL") return;
  const auto found = std::ranges::find(table, std::string_view(tag), &Feature::tag);
  const std::string whole = std::string(what) + " " + in_quotes(tag);
  if (found == table.end()) {
    findings.warning(element.mark(), "the " + whole + " is not carried: the model has no word for it");
    return;
  }
  if (found->word.empty()) return;
  if (!tier.empty() && tier != found->word) {
    findings.warning(element.mark(),
                     "the " + whole + " is left out: the sign already has " + in_quotes(tier) + " there");
    return;
  }
  if (!found->exact) findings.warning(element.mark(), "the " + whole + " is carried as " + in_quotes(found->word));
  tier = found->word;
}

const Table kBrows = {
    {"RB", "raise"}, {"RR", "raise", false}, {"RL", "raise", false}, {"FU", "furrow"}, {"DN", "furrow", false}};
const Table kEyes = {{"WB", "wide"},          {"WR", "wide", false},   {"WL", "wide", false},  {"SB", "narrow"},
                     {"SR", "narrow", false}, {"SL", "narrow", false}, {"CB", "closed"},       {"CR", "closed", false},
                     {"CL", "closed", false}, {"TB", "squint", false}, {"BB", "closed", false}};
const Table kGaze = {{"AD", "addressee"},
                     {"FR", "addressee", false},
                     {"HD", "down-to-hand"},
                     {"HI", "down-to-hand"},
                     {"HC", "down-to-hand", false},
                     {"DN", "down"},
                     {"UP", "up"},
                     {"LE", "left"},
                     {"RI", "right"},
                     {"LU", "left", false},
                     {"LD", "left", false},
                     {"RU", "right", false},
                     {"RD", "right", false}};
const Table kHead = {{"NO", "nod"},
                     {"SH", "shake"},
                     {"TR", "tilt"},
                     {"TL", "tilt", false},
                     {"NF", "tilt-forward"},
                     {"NB", "tilt-back-slight"},
                     {"PF", "forward"},
                     {"PB", "tilt-back-slight", false},
                     {"NU", "nod-slight", false},
                     {"ND", "nod-slight", false}};
const Table kShoulders = {{"UB", "shrug", false},   {"HB", "hunched"},      {"SB", "shrug"},
                          {"UL", "shrug", false},   {"UR", "shrug", false}, {"HL", "hunched", false},
                          {"HR", "hunched", false}, {"SL", "shrug", false}, {"SR", "shrug", false}};
const Table kBody = {{"TF", "lean-forward"}, {"ST", ""}, {"SI", "sway", false}};
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

void set_mouth(std::string& tier, const std::string& tag, const Element& element) {
  const bool has_word = std::ranges::find(kMouth, std::string_view(tag), &Feature::tag) != kMouth.end();
  if (has_word || !is_mouth_gesture(tag)) return set(tier, kMouth, tag, "mouth gesture", element);
  set(tier, {{tag, tag}}, tag, "mouth gesture", element);
}

void set_mouthing(const std::string& picture, NonManual& face, const Element& element) {
  Findings& findings = element.findings();
  if (picture.empty()) {
    findings.warning(element.mark(), "an empty mouth picture is left out");
    return;
  }
  const std::string spelling = spelling_of_sampa(picture);
  if (spelling.empty()) {
    findings.warning(element.mark(), "the mouth picture " + in_quotes(picture) + " has no sound that is known");
    return;
  }
  if (!face.mouthing.empty()) {
    face.mouthing += " " + spelling;
  } else {
    face.mouthing = spelling;
  }
  findings.note(element.mark(), "the mouth picture " + in_quotes(picture) + " is mouthed as " + in_quotes(spelling));
}

/// One movement on any tier.
void read_feature(Element& element, NonManual& face) {
  const std::string_view name = element.name();
  element.not_carried({"amount", "speed", "duration", "presynchronization", "postsynchronization"});
  const auto movement = [&element] { return element.text("movement"); };
  if (name == "shoulder_movement") {
    set(face.shoulders, kShoulders, movement(), "shoulder movement", element);
  } else if (name == "body_movement") {
    set(face.head, kBody, movement(), "body movement", element);
  } else if (name == "head_movement") {
    set(face.head, kHead, movement(), "head movement", element);
  } else if (name == "eye_gaze") {
    const std::string direction = element.text("direction");
    const std::string old = movement();
    set(face.gaze, kGaze, direction.empty() ? old : direction, "gaze", element);
  } else if (name == "eye_brows") {
    set(face.brows, kBrows, movement(), "eyebrow movement", element);
  } else if (name == "eye_lids") {
    set(face.eyes, kEyes, movement(), "eyelid movement", element);
  } else if (name == "nose") {
    set(face.face, {{"WR", "dislike", false}}, movement(), "nose movement", element);
  } else if (name == "mouth_gesture") {
    set_mouth(face.mouth, movement(), element);
  } else if (name == "mouth_picture") {
    set_mouthing(element.text("picture"), face, element);
  } else if (name == "mouth_meta" || name == "extra_movement") {
    element.findings().warning(element.mark(), "the element " + in_quotes(name) + " is not carried");
    return;
  } else if (name == "neutral") {
    return;
  } else {
    element.findings().warning(element.mark(),
                               "the element " + in_quotes(name) + " is not known in a non-manual tier and is left out");
    return;
  }
  element.done();
}

bool is_group(std::string_view name) {
  return name.ends_with("_par") || name.ends_with("_seq") || name.ends_with("_tier");
}

void read_group(Element& group, NonManual& face) {
  group.not_carried({"presynchronization", "postsynchronization", "fitpicturetomanual"});
  group.done();
  group.each_child([&face](Element& child) {
    if (is_group(child.name())) {
      read_group(child, face);
    } else {
      read_feature(child, face);
    }
  });
}

}  // namespace

void read_tiers(Element& tiers, NonManual& face) {
  tiers.done();
  tiers.each_child([&face](Element& child) {
    if (is_group(child.name())) {
      read_group(child, face);
    } else {
      read_feature(child, face);
    }
  });
}

void read_hnm(Element& elements, NonManual& face) {
  elements.done();
  elements.each_child([&face](Element& child) {
    const std::string_view name = child.name();
    const auto tag = [&child] { return child.text("tag"); };
    child.not_carried({"amount", "speed"});
    if (name == "hnm_shoulder") {
      set(face.shoulders, kShoulders, tag(), "shoulder movement", child);
    } else if (name == "hnm_body") {
      set(face.head, kBody, tag(), "body movement", child);
    } else if (name == "hnm_head") {
      set(face.head, kHead, tag(), "head movement", child);
    } else if (name == "hnm_eyegaze") {
      set(face.gaze, kGaze, tag(), "gaze", child);
    } else if (name == "hnm_eyebrows") {
      set(face.brows, kBrows, tag(), "eyebrow movement", child);
    } else if (name == "hnm_eyelids") {
      set(face.eyes, kEyes, tag(), "eyelid movement", child);
    } else if (name == "hnm_nose") {
      set(face.face, {{"WR", "dislike", false}}, tag(), "nose movement", child);
    } else if (name == "hnm_mouthgesture") {
      set_mouth(face.mouth, tag(), child);
    } else if (name == "hnm_mouthpicture") {
      set_mouthing(child.text("picture"), face, child);
    } else {
      child.findings().warning(child.mark(), "the element " + in_quotes(name) + " is not carried");
      return;
    }
    child.done();
  });
}

}  // namespace auslan::notation
