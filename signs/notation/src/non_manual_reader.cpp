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
const Table kGaze = {{"AD", "addressee"},    {"FR", "addressee", false},    {"HD", "down-to-hand"},
                     {"HI", "down-to-hand"}, {"HC", "down-to-hand", false}, {"DN", "down-to-hand", false}};
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
const Table kMouth = {{"D01", "teeth-showing"},
                      {"L01", "shh"},
                      {"L04", "pursed"},
                      {"L05", "open"},
                      {"L06", "pursed"},
                      {"L07", "open", false},
                      {"L10", "open", false},
                      {"L14", "shh", false},
                      {"L19", "blow"},
                      {"L20", "blow"},
                      {"L21", "blow", false},
                      {"L22", "blow", false},
                      {"L23", "pressed"},
                      {"L24", "pressed"},
                      {"L25", "pressed", false},
                      {"L29", "down-turned", false},
                      {"L30", "down-turned", false},
                      {"L31", "down-turned"},
                      {"L34", "stretched"},
                      {"L35", "blow", false},
                      {"C01", "puffed"},
                      {"C02", "puffed", false},
                      {"C03", "puffed", false},
                      {"C04", "puffed", false},
                      {"C05", "puffed", false},
                      {"D02", "pressed", false},
                      {"T02", "open", false},
                      {"T05", "open", false},
                      {"L12", "stretched", false},
                      {"L32", "blow", false},
                      {"L33", "shh", false},
                      {"T17", "open", false}};

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
    set(face.mouth, kMouth, movement(), "mouth gesture", element);
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
      set(face.mouth, kMouth, tag(), "mouth gesture", child);
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
