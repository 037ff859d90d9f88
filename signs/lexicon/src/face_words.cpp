// SPDX-License-Identifier: Apache-2.0
#include "lexicon/face_words.h"

#include <algorithm>
#include <array>

namespace auslan {
namespace {

using Words = std::string_view;

constexpr std::array<Words, 6> kBrows = {"raise", "raise-slight", "furrow", "furrow-slight", "inner-raise", "neutral"};
constexpr std::array<Words, 5> kEyes = {"wide", "closed", "narrow", "half-closed", "squint"};
constexpr std::array<Words, 16> kMouth = {
    "smile", "smile-slight", "down-turned", "teeth-showing", "pressed",   "pursed", "open",  "open-close",
    "blow",  "ow",           "breathe",     "exhale",        "stretched", "puffed", "cough", "shh"};
constexpr std::array<Words, 1> kCheeks = {"puffed"};
constexpr std::array<Words, 9> kHead = {
    "shake", "nod", "nod-slight", "tilt", "tilt-slight", "tilt-forward", "tilt-back-slight", "forward", "sway"};
constexpr std::array<Words, 3> kShoulders = {"hunched", "shrug", "drop"};
constexpr std::array<Words, 2> kGaze = {"addressee", "down-to-hand"};
constexpr std::array<Words, 2> kFace = {"pained", "dislike"};
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
      return kMouth;
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
