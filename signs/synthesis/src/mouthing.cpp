// SPDX-License-Identifier: Apache-2.0
#include "synthesis/mouthing.h"

#include <array>
#include <cstddef>
#include <string>

namespace auslan {
namespace {

struct Rule {
  std::string_view letters;
  std::array<Viseme, 2> visemes;
  int count;
};

using enum Viseme;

// Longest first within each length; a rule of count 0 is silent.
constexpr std::array<Rule, 58> kRules = {{
    {"tion", {kRounded, kAlveolar}, 2},
    {"ough", {kO, kO}, 1},
    {"igh", {kA, kI}, 2},
    {"tch", {kRounded, kA}, 1},
    {"ear", {kI, kE}, 2},
    {"air", {kE, kE}, 1},
    {"oor", {kO, kO}, 1},
    {"our", {kO, kO}, 1},
    {"eau", {kW, kW}, 1},
    {"ph", {kLipTeeth, kA}, 1},
    {"th", {kTongue, kA}, 1},
    {"sh", {kRounded, kA}, 1},
    {"ch", {kRounded, kA}, 1},
    {"wh", {kW, kA}, 1},
    {"ck", {kBack, kA}, 1},
    {"ng", {kBack, kA}, 1},
    {"qu", {kBack, kW}, 2},
    {"kn", {kAlveolar, kA}, 1},
    {"wr", {kR, kA}, 1},
    {"gh", {kBack, kA}, 0},
    {"ee", {kI, kI}, 1},
    {"ea", {kI, kI}, 1},
    {"ie", {kI, kI}, 1},
    {"ei", {kE, kI}, 2},
    {"ai", {kE, kI}, 2},
    {"ay", {kE, kI}, 2},
    {"ey", {kE, kI}, 2},
    {"oo", {kW, kW}, 1},
    {"ou", {kA, kW}, 2},
    {"ow", {kA, kW}, 2},
    {"oa", {kO, kW}, 2},
    {"oi", {kO, kI}, 2},
    {"oy", {kO, kI}, 2},
    {"au", {kO, kO}, 1},
    {"aw", {kO, kO}, 1},
    {"ew", {kI, kW}, 2},
    {"ar", {kA, kA}, 1},
    {"or", {kO, kO}, 1},
    {"er", {kE, kE}, 1},
    {"ir", {kE, kE}, 1},
    {"ur", {kE, kE}, 1},
    {"p", {kClosed, kA}, 1},
    {"b", {kClosed, kA}, 1},
    {"m", {kClosed, kA}, 1},
    {"f", {kLipTeeth, kA}, 1},
    {"v", {kLipTeeth, kA}, 1},
    {"j", {kRounded, kA}, 1},
    {"r", {kR, kA}, 1},
    {"w", {kW, kA}, 1},
    {"k", {kBack, kA}, 1},
    {"g", {kBack, kA}, 1},
    {"h", {kBack, kA}, 0},
    {"a", {kA, kA}, 1},
    {"e", {kE, kE}, 1},
    {"i", {kI, kI}, 1},
    {"y", {kI, kI}, 1},
    {"o", {kO, kO}, 1},
    {"u", {kA, kA}, 1},
}};

bool is_vowel(char c) {
  return c == 'a' || c == 'e' || c == 'i' || c == 'o' || c == 'u' || c == 'y';
}
bool is_letter(char c) {
  return c >= 'a' && c <= 'z';
}

}  // namespace

std::vector<Viseme> visemes_of(std::string_view english) {
  std::string word;
  for (const char c : english)
    word += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  std::vector<Viseme> visemes;
  const auto push = [&visemes](Viseme viseme) {
    if (visemes.empty() || visemes.back() != viseme) visemes.push_back(viseme);
  };
  for (size_t i = 0; i < word.size();) {
    const bool last = i + 1 >= word.size() || !is_letter(word[i + 1]);
    // A final e after a vowel and a consonant is silent ("name").
    if (word[i] == 'e' && last && i >= 2 && !is_vowel(word[i - 1]) && is_vowel(word[i - 2])) {
      ++i;
      continue;
    }
    const Rule* match = nullptr;
    for (const Rule& rule : kRules)
      if (match == nullptr && std::string_view(word).substr(i, rule.letters.size()) == rule.letters) match = &rule;
    if (match != nullptr) {
      for (int k = 0; k < match->count; ++k)
        push(match->visemes[static_cast<size_t>(k)]);
      i += match->letters.size();
    } else {
      if (is_letter(word[i])) push(kAlveolar);  // t d n l s z c x q
      ++i;
    }
  }
  return visemes;
}

FaceWeights weights_of(Viseme viseme) {
  using enum FaceChannel;
  FaceWeights w{};
  const auto set = [&w](FaceChannel channel, float value) { w[static_cast<size_t>(channel)] = value; };
  const auto both = [&set](FaceChannel left, FaceChannel right, float value) {
    set(left, value);
    set(right, value);
  };
  switch (viseme) {
    case kClosed:
      both(kMouthPressLeft, kMouthPressRight, 0.7F);
      break;
    case kLipTeeth:
      set(kJawOpen, 0.06F);
      both(kMouthUpperUpLeft, kMouthUpperUpRight, 0.35F);
      both(kMouthPressLeft, kMouthPressRight, 0.25F);
      break;
    case kTongue:
      set(kJawOpen, 0.16F);
      set(kTongueOut, 0.35F);
      break;
    case kAlveolar:
      set(kJawOpen, 0.12F);
      both(kMouthStretchLeft, kMouthStretchRight, 0.2F);
      both(kMouthLowerDownLeft, kMouthLowerDownRight, 0.2F);
      break;
    case kRounded:
      set(kMouthFunnel, 0.65F);
      set(kJawOpen, 0.1F);
      break;
    case kBack:
      set(kJawOpen, 0.18F);
      break;
    case kR:
      set(kMouthPucker, 0.35F);
      set(kJawOpen, 0.1F);
      break;
    case kW:
      set(kMouthPucker, 0.9F);
      break;
    case kO:
      set(kMouthFunnel, 0.7F);
      set(kJawOpen, 0.28F);
      break;
    case kA:
      set(kJawOpen, 0.42F);
      break;
    case kE:
      set(kJawOpen, 0.28F);
      both(kMouthStretchLeft, kMouthStretchRight, 0.25F);
      break;
    case kI:
      set(kJawOpen, 0.12F);
      both(kMouthStretchLeft, kMouthStretchRight, 0.5F);
      both(kMouthSmileLeft, kMouthSmileRight, 0.35F);
      break;
  }
  return w;
}

}  // namespace auslan
