// SPDX-License-Identifier: Apache-2.0
#include "lexicon/face_words.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <vector>

namespace auslan {
namespace {

using Words = std::string_view;

constexpr Words kBrows[] = {"raise",       "raise-slight", "furrow",      "furrow-slight",
                            "inner-raise", "raise-left",   "raise-right", "neutral"};
constexpr Words kEyes[] = {"wide",        "closed",       "narrow",      "half-closed", "squint",
                           "blink",       "wide-left",    "wide-right",  "closed-left", "closed-right",
                           "narrow-left", "narrow-right", "squint-left", "squint-right"};
constexpr Words kMouth[] = {
    "smile", "smile-slight", "down-turned", "teeth-showing", "pressed",   "pursed", "open",  "open-close",
    "blow",  "ow",           "breathe",     "exhale",        "stretched", "puffed", "cough", "shh"};
constexpr Words kCheeks[] = {"puffed"};
constexpr Words kHead[] = {
    "shake",       "nod",      "nod-slight",   "tilt",      "tilt-slight", "tilt-forward", "tilt-back-slight",
    "forward",     "sway",     "nod-up",       "tilt-left", "turn-left",   "turn-right",   "back",
    "follow-gaze", "straight", "lean-forward", "lean-back", "lean-left",   "lean-right",   "body-left",
    "body-right",  "sigh",     "heave",        "rounded"};
constexpr Words kShoulders[] = {"hunched",    "shrug",       "drop",   "hunched-left", "hunched-right",
                                "shrug-left", "shrug-right", "raised", "raised-left",  "raised-right"};
constexpr Words kGaze[] = {"addressee", "down-to-hand", "down-to-other-hand", "down",     "up",         "left",
                           "right",     "left-up",      "left-down",          "right-up", "right-down", "far",
                           "unfocused", "rolling"};
constexpr Words kFace[] = {"pained", "dislike", "nose-wrinkled", "nose-twitch", "nose-widened"};

/// The words for mouths, and the codes of the mouth gestures that have none: "T14".
std::span<const Words> mouth_words() {
  struct Gestures {
    char letter;
    int count;
  };
  static const std::vector<std::string> codes = [] {
    std::vector<std::string> made;
    for (const Gestures& kind :
         {Gestures{'D', 9}, Gestures{'J', 4}, Gestures{'L', 35}, Gestures{'C', 13}, Gestures{'T', 17}})
      for (int i = 1; i <= kind.count; ++i)
        made.push_back({kind.letter, static_cast<char>('0' + i / 10), static_cast<char>('0' + i % 10)});
    return made;
  }();
  static const std::vector<Words> all = [] {
    std::vector<Words> list(std::begin(kMouth), std::end(kMouth));
    list.insert(list.end(), codes.begin(), codes.end());
    return list;
  }();
  return all;
}
constexpr std::array<Words, kFaceTiers> kChannels = {"brows", "eyes",      "mouth", "cheeks",
                                                     "head",  "shoulders", "gaze",  "face"};
constexpr std::array<Words, 8> kKinds = {"topic", "yn", "wh", "neg", "cond", "aff", "cmd", "polite"};
constexpr std::array<Words, 2> kEndings = {"hold last sign", "pause/blink"};
constexpr std::array<Words, 13> kPartsOfSpeech = {"noun", "verb",  "adj",    "adv",  "pron", "wh", "num",
                                                  "neg",  "modal", "interj", "prep", "conj", "det"};

}  // namespace

std::span<const std::string_view> face_words(FaceTier channel) {
  switch (channel) {
    case FaceTier::kBrows:
      return kBrows;
    case FaceTier::kEyes:
      return kEyes;
    case FaceTier::kMouth:
      return mouth_words();
    case FaceTier::kCheeks:
      return kCheeks;
    case FaceTier::kHead:
      return kHead;
    case FaceTier::kShoulders:
      return kShoulders;
    case FaceTier::kGaze:
      return kGaze;
    case FaceTier::kFace:
      return kFace;
  }
  return {};
}

std::string_view tier_name(FaceTier channel) {
  return kChannels[static_cast<size_t>(channel)];
}

bool is_face_word(FaceTier channel, std::string_view word) {
  return word.empty() || std::ranges::find(face_words(channel), word) != face_words(channel).end();
}

std::span<const std::string_view> span_kinds() {
  return kKinds;
}
std::span<const std::string_view> span_endings() {
  return kEndings;
}
std::span<const std::string_view> parts_of_speech() {
  return kPartsOfSpeech;
}

}  // namespace auslan
