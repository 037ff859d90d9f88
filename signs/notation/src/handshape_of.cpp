// SPDX-License-Identifier: Apache-2.0
#include "handshape_of.h"

#include <algorithm>

namespace auslan::notation {
namespace {

// A joint bent by four quarters, degrees.
constexpr double kFullMcp = 85, kFullPip = 105, kFullDip = 65;
constexpr std::array<double, 4> kSpread = {15, 0, 12, 25};

using Quarters = std::array<double, 3>;

/// How the base form treats the digits that it names.
enum class Grip { kStraight, kPinch, kCee };

struct BaseForm {
  std::string_view name;
  std::string_view selected;  ///< fingers that are out, or meet the thumb
  Grip grip;
  bool spread;  ///< the selected fingers, or those left open by a grip
  bool others_open;
};

constexpr std::array<BaseForm, 12> kBases = {{
    {"fist", "", Grip::kStraight, false, false},
    {"flat", "2345", Grip::kStraight, false, false},
    {"finger2", "2", Grip::kStraight, false, false},
    {"finger23", "23", Grip::kStraight, false, false},
    {"finger23spread", "23", Grip::kStraight, true, false},
    {"finger2345", "2345", Grip::kStraight, true, false},
    {"pinch12", "2", Grip::kPinch, false, false},
    {"pinchall", "2345", Grip::kPinch, false, false},
    {"pinch12open", "2", Grip::kPinch, true, true},
    {"cee12", "2", Grip::kCee, false, false},
    {"ceeall", "2345", Grip::kCee, false, false},
    {"cee12open", "2", Grip::kCee, true, true},
}};

/// Base, middle and end joint in quarters of full flexion.
std::optional<Quarters> quarters_of(std::string_view bend) {
  if (bend == "straight") return Quarters{0, 0, 0};
  if (bend == "bent") return Quarters{4, 0, 0};
  if (bend == "round") return Quarters{2, 2, 2};
  if (bend == "hooked") return Quarters{0, 4, 4};
  if (bend == "dblbent") return Quarters{4, 4, 0};
  if (bend == "dblhooked") return Quarters{4, 4, 4};
  if (bend == "halfbent") return Quarters{2, 0, 0};
  // Three numbers in a row, as some files have them: "0.5 0.5 0.5", also without the spaces.
  if (bend.find('.') != std::string_view::npos) {
    Quarters result{};
    size_t at = 0;
    for (double& quarters : result) {
      while (at < bend.size() && bend[at] == ' ')
        ++at;
      if (at + 2 >= bend.size() || bend[at] < '0' || bend[at] > '4' || bend[at + 1] != '.' || bend[at + 2] < '0' ||
          bend[at + 2] > '9')
        return std::nullopt;
      quarters = std::min(4.0, (bend[at] - '0') + 0.1 * (bend[at + 2] - '0'));
      at += 3;
    }
    return at >= bend.size() ? std::optional<Quarters>(result) : std::nullopt;
  }
  if (bend.size() != 3 && bend.size() != 4) return std::nullopt;
  Quarters result{};
  for (size_t i = 0; i < bend.size(); ++i) {
    if (bend[i] < '0' || bend[i] > '4') return std::nullopt;
    if (i < 3) result[i] = bend[i] - '0';
  }
  return result;
}

FingerAngles angles_of(const Quarters& quarters, double abduction) {
  return {quarters[0] * kFullMcp / 4, quarters[1] * kFullPip / 4, quarters[2] * kFullDip / 4, abduction};
}

bool has(std::string_view digits, size_t finger) {
  return digits.find(static_cast<char>('2' + finger)) != std::string_view::npos;
}

ThumbAngles thumb_of(const WrittenShape& written, Grip grip, std::string_view selected) {
  if (written.thumb_enclosed) return {0, 30, 0.9, 45, 30};
  if (!written.thumb_between.empty()) return {0, 30, 0.8, 30, 10};
  if (grip == Grip::kPinch)
    return selected == "2" ? ThumbAngles{15, 40, 0.7, 20, 25} : ThumbAngles{10, 45, 0.8, 20, 20};
  if (grip == Grip::kCee) {
    if (written.thumb == "across" || written.opening == "tight") return {20, 42, 0.7, 12, 18};
    if (written.thumb == "opposed" || written.opening == "slack") return {35, 55, 0.6, 0, 5};
    return {30, 50, 0.6, 5, 10};
  }
  if (written.thumb == "out") return {50, 10, 0, 0, 0};
  if (written.thumb == "opposed") return {20, 55, 0.7, 5, 5};
  if (written.thumb == "across") return {0, 28, 0.8, 38, 42};
  // Alongside: against the edge of the hand, along the knuckles of a closed one.
  return selected == "2345" ? ThumbAngles{12, 8, 0.05, 3, 3} : ThumbAngles{8, 15, 0.2, 15, 15};
}

std::string selected_name(std::string_view digits, bool thumb) {
  if (digits == "2345") return thumb ? "all+thumb" : "all";
  static constexpr std::string_view kNames[] = {"index", "middle", "ring", "little"};
  std::string name;
  for (size_t i = 0; i < 4; ++i)
    if (has(digits, i)) name += (name.empty() ? "" : "+") + std::string(kNames[i]);
  if (thumb) name += name.empty() ? "thumb" : "+thumb";
  return name.empty() ? "none" : name;
}

std::string id_of(const WrittenShape& written) {
  std::string id = written.base;
  const auto add = [&id](std::string_view before, std::string_view what) {
    if (!what.empty()) id += "+" + std::string(before) + std::string(what);
  };
  add("thumb", written.thumb);
  add("", written.bend);
  for (size_t i = 0; i < 5; ++i)
    add(std::to_string(i + 1), written.digit_bend[i]);
  add("only", written.special);
  add("but", written.exempt);
  add("", written.opening);
  add("splay", written.splay);
  add("crossed", written.crossed);
  add("at", written.contact_kind);
  add("thumbbetween", written.thumb_between);
  if (written.thumb_enclosed) id += "+thumbenclosed";
  return id;
}

Handshape single(const WrittenShape& written, const Mark& mark, Findings& findings) {
  const auto base = std::ranges::find(kBases, std::string_view(written.base), &BaseForm::name);
  const BaseForm& form = base == kBases.end() ? kBases[1] : *base;
  if (base == kBases.end())
    findings.left_out(mark, "the base handshape " + in_quotes(written.base) + " is not known; signed with a flat hand");
  std::string selected(form.selected);
  bool thumb_selected = form.grip != Grip::kStraight;
  if (!written.special.empty()) {
    selected.clear();
    for (const char digit : written.special) {
      if (digit >= '2' && digit <= '5' && selected.find(digit) == std::string::npos) selected += digit;
      if (digit == '1') thumb_selected = true;
    }
    std::ranges::sort(selected);
  }
  std::optional<Quarters> bend;
  if (!written.bend.empty()) {
    bend = quarters_of(written.bend);
    if (!bend)
      findings.left_out(mark, "the bend " + in_quotes(written.bend) +
                                  " is not known (expected bent, round, hooked, dblbent, dblhooked or halfbent); left "
                                  "straight");
  }
  Handshape shape;
  for (size_t i = 0; i < 4; ++i) {
    const bool in = has(selected, i);
    FingerAngles& finger = shape.fingers[i];
    double spread = form.spread ? kSpread[i] : 0.0;
    if (written.splay == "1") spread = kSpread[i];
    if (written.splay == "2") spread = 1.3 * kSpread[i];
    if (written.splay == "0") spread = 0;
    if (form.grip == Grip::kStraight) {
      // A bend on a fist bends the whole fist.
      const bool bendable = (in || form.selected.empty()) && !has(written.exempt, i);
      if (bend && bendable) {
        finger = angles_of(*bend, in ? spread : 0.0);
      } else {
        finger = angles_of(in ? Quarters{0, 0, 0} : Quarters{4, 4, 4}, in ? spread : 0.0);
      }
    } else if (in) {
      finger = form.grip == Grip::kPinch ? FingerAngles{55, 60, 35, 0} : FingerAngles{35, 45, 25, 0};
      // The grip stays closed at the thumb: a bend only says where the finger gives.
      if (bend && (*bend)[1] == 0)
        finger = form.grip == Grip::kPinch ? FingerAngles{68, 22, 8, 0} : FingerAngles{50, 8, 4, 0};
      if (bend && (*bend)[0] == 0 && (*bend)[1] > 0)
        finger = form.grip == Grip::kPinch ? FingerAngles{28, 92, 50, 0} : FingerAngles{12, 72, 45, 0};
      if (written.opening == "tight" || (form.grip == Grip::kCee && written.thumb == "across")) finger.mcp += 10;
      if (written.opening == "slack" || (form.grip == Grip::kCee && written.thumb == "opposed")) finger.mcp -= 10;
    } else {
      finger = angles_of(form.others_open ? Quarters{0, 0, 0} : Quarters{4, 4, 4}, form.others_open ? spread : 0.0);
    }
    if (const std::string& own = written.digit_bend[i + 1]; !own.empty()) {
      if (const auto quarters = quarters_of(own)) {
        finger = angles_of(*quarters, finger.abduction);
      } else {
        findings.left_out(mark, "the bend " + in_quotes(own) + " of digit " + std::to_string(i + 2) +
                                    " is not known; the digit stays as the handshape has it");
      }
    }
  }
  if (written.crossed == "23" || written.crossed == "32") {
    shape.fingers[0].abduction = -6;
    shape.fingers[1].abduction = -8;
  }
  shape.thumb = thumb_of(written, form.grip, form.selected);
  const bool neighbours = written.crossed == "23" || written.crossed == "32";
  if (written.crossed.size() == 2 && !neighbours) {
    // Two digits at each other: the thumb meets a finger, or two fingers lean together.
    for (const char digit : written.crossed) {
      if (digit == '1') {
        shape.thumb = {15, 45, 0.75, 20, 20};
        continue;
      }
      FingerAngles& finger = shape.fingers[static_cast<size_t>(digit - '2')];
      if (written.crossed.find('1') != std::string::npos) {
        finger = {50, 55, 30, 0};
      } else {
        finger.abduction = -7;
      }
    }
    findings.note(mark, "the digits " + in_quotes(written.crossed) + " touch each other approximately");
  } else if (!written.crossed.empty() && !neighbours) {
    findings.left_out(mark, "the crossing or contact of the digits " + in_quotes(written.crossed) +
                                " is left out (expected two digits)");
  }
  if (!written.contact_kind.empty())
    findings.warning(
        mark, "the contact of two fingers at the " + in_quotes(written.contact_kind) + " is signed as crossed fingers");
  if (!written.thumb_contact.empty())
    findings.note(mark, "the thumb touches the finger's " + in_quotes(written.thumb_contact) + " approximately");
  if (!written.opposed.empty())
    findings.note(mark, "the thumb opposes the digit " + in_quotes(written.opposed) + " approximately");
  if (const std::string& own = written.digit_bend[0]; !own.empty()) {
    if (const auto quarters = quarters_of(own)) {
      shape.thumb.mp = std::max(shape.thumb.mp, (*quarters)[1] * 50 / 4);
      shape.thumb.ip = std::max(shape.thumb.ip, (*quarters)[2] * 70 / 4);
    } else {
      findings.left_out(mark, "the bend " + in_quotes(own) + " of the thumb is not known; the thumb stays straight");
    }
  }
  if (written.thumb_enclosed || !written.thumb_between.empty())
    findings.note(mark, "the thumb between or under the fingers is posed approximately");
  // A fist whose thumb is out points with it.
  if (form.selected.empty() && selected.empty() && written.thumb == "out") thumb_selected = true;
  shape.selected = selected_name(selected, thumb_selected);
  shape.id = id_of(written);
  return shape;
}

double mean(double a, double b) {
  return 0.5 * (a + b);
}

}  // namespace

Handshape handshape_of(const WrittenShape& written, const std::optional<WrittenShape>& second, const Mark& mark,
                       Findings& findings) {
  Handshape shape = single(written, mark, findings);
  if (second) {
    const Handshape other = single(*second, mark, findings);
    for (size_t i = 0; i < 4; ++i) {
      FingerAngles& finger = shape.fingers[i];
      const FingerAngles& there = other.fingers[i];
      finger = {mean(finger.mcp, there.mcp), mean(finger.pip, there.pip), mean(finger.dip, there.dip),
                mean(finger.abduction, there.abduction)};
    }
    ThumbAngles& thumb = shape.thumb;
    thumb = {mean(thumb.radial_abduction, other.thumb.radial_abduction),
             mean(thumb.palmar_abduction, other.thumb.palmar_abduction), mean(thumb.opposition, other.thumb.opposition),
             mean(thumb.mp, other.thumb.mp), mean(thumb.ip, other.thumb.ip)};
    if (other.id != shape.id) shape.id += "~" + other.id;
  }
  shape.id = "ham:" + shape.id;
  shape.name = shape.id;
  shape.base = shape.id;
  shape.description = "Read from a sign notation.";
  shape.provenance.form_evidence = "the notation's base form and modifiers; the angles are the project's";
  return shape;
}

}  // namespace auslan::notation
