// SPDX-License-Identifier: Apache-2.0
#include "synthesis/mouthing.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
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
constexpr std::array<Rule, 66> kRules = {{
    {"tion", {kCh, kNn}, 2}, {"ough", {kOh, kOh}, 1}, {"igh", {kAa, kIh}, 2}, {"tch", {kCh, kAa}, 1},
    {"ear", {kIh, kE}, 2},   {"air", {kE, kE}, 1},    {"oor", {kOh, kOh}, 1}, {"our", {kOh, kOh}, 1},
    {"eau", {kOu, kOu}, 1},  {"ph", {kFf, kAa}, 1},   {"th", {kTh, kAa}, 1},  {"sh", {kCh, kAa}, 1},
    {"ch", {kCh, kAa}, 1},   {"wh", {kOu, kAa}, 1},   {"ck", {kKk, kAa}, 1},  {"ng", {kNn, kAa}, 1},
    {"qu", {kKk, kOu}, 2},   {"kn", {kNn, kAa}, 1},   {"wr", {kRr, kAa}, 1},  {"gh", {kKk, kAa}, 0},
    {"ee", {kIh, kIh}, 1},   {"ea", {kIh, kIh}, 1},   {"ie", {kIh, kIh}, 1},  {"ei", {kE, kIh}, 2},
    {"ai", {kE, kIh}, 2},    {"ay", {kE, kIh}, 2},    {"ey", {kE, kIh}, 2},   {"oo", {kOu, kOu}, 1},
    {"ou", {kAa, kOu}, 2},   {"ow", {kAa, kOu}, 2},   {"oa", {kOh, kOu}, 2},  {"oi", {kOh, kIh}, 2},
    {"oy", {kOh, kIh}, 2},   {"au", {kOh, kOh}, 1},   {"aw", {kOh, kOh}, 1},  {"ew", {kIh, kOu}, 2},
    {"ar", {kAa, kAa}, 1},   {"or", {kOh, kOh}, 1},   {"er", {kE, kE}, 1},    {"ir", {kE, kE}, 1},
    {"ur", {kE, kE}, 1},     {"p", {kPp, kAa}, 1},    {"b", {kPp, kAa}, 1},   {"m", {kPp, kAa}, 1},
    {"f", {kFf, kAa}, 1},    {"v", {kFf, kAa}, 1},    {"j", {kCh, kAa}, 1},   {"r", {kRr, kAa}, 1},
    {"w", {kOu, kAa}, 1},    {"k", {kKk, kAa}, 1},    {"g", {kKk, kAa}, 1},   {"h", {kKk, kAa}, 0},
    {"a", {kAa, kAa}, 1},    {"e", {kE, kE}, 1},      {"i", {kIh, kIh}, 1},   {"y", {kIh, kIh}, 1},
    {"o", {kOh, kOh}, 1},    {"u", {kAa, kAa}, 1},    {"t", {kDd, kAa}, 1},   {"d", {kDd, kAa}, 1},
    {"n", {kNn, kAa}, 1},    {"l", {kNn, kAa}, 1},    {"s", {kSs, kAa}, 1},   {"z", {kSs, kAa}, 1},
    {"c", {kKk, kAa}, 1},    {"x", {kKk, kSs}, 2},
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
    if (match == nullptr) {
      ++i;
      continue;
    }
    for (int k = 0; k < match->count; ++k)
      push(match->visemes[static_cast<size_t>(k)]);
    i += match->letters.size();
  }
  return visemes;
}

namespace {

bool is_vowel(Viseme viseme) {
  return viseme == kAa || viseme == kE || viseme == kIh || viseme == kOh || viseme == kOu;
}

/// Made by the lips themselves: nothing else is seen on them then.
bool is_labial(Viseme viseme) {
  return viseme == kPp || viseme == kFf;
}

}  // namespace

std::vector<Viseme> reduced(std::vector<Viseme> visemes, size_t most) {
  // Behind the lips first, then what the teeth show, then vowels; what the lips close for goes last.
  constexpr std::array<Viseme, 14> kFirstToGo = {kKk, kNn, kDd, kRr, kTh, kSs, kIh, kE, kCh, kAa, kOh, kOu, kFf, kPp};
  most = std::max<size_t>(1, most);
  for (const Viseme hidden : kFirstToGo) {
    while (visemes.size() > most) {
      const auto found = std::find(visemes.rbegin(), visemes.rend(), hidden);
      if (found == visemes.rend()) break;
      visemes.erase(std::next(found).base());
    }
  }
  visemes.erase(std::unique(visemes.begin(), visemes.end()), visemes.end());
  return visemes;
}

std::vector<FaceWeights> coarticulated(std::span<const Viseme> visemes) {
  using enum FaceChannel;
  constexpr std::array<FaceChannel, 6> kLips = {kMouthPucker,       kMouthFunnel,    kMouthStretchLeft,
                                                kMouthStretchRight, kMouthSmileLeft, kMouthSmileRight};
  constexpr float kNext = 0.45F, kLast = 0.25F;
  std::vector<FaceWeights> faces;
  for (size_t i = 0; i < visemes.size(); ++i) {
    FaceWeights face = weights_of(visemes[i]);
    if (!is_vowel(visemes[i]) && !is_labial(visemes[i])) {
      const auto take = [&](size_t neighbour, float share) {
        const FaceWeights other = weights_of(visemes[neighbour]);
        for (const FaceChannel channel : kLips) {
          const auto c = static_cast<size_t>(channel);
          face[c] = std::max(face[c], share * other[c]);
        }
      };
      if (i + 1 < visemes.size() && is_vowel(visemes[i + 1])) take(i + 1, kNext);
      if (i > 0 && is_vowel(visemes[i - 1])) take(i - 1, kLast);
    }
    faces.push_back(face);
  }
  return faces;
}

VisemeTiming timing_of(Viseme viseme) {
  if (is_vowel(viseme)) return {1.5, 0.25};
  return is_labial(viseme) ? VisemeTiming{1.1, 0.4} : VisemeTiming{0.9, 0.15};
}

FaceWeights weights_of(Viseme viseme) {
  using enum FaceChannel;
  FaceWeights w{};
  const auto set = [&w](FaceChannel channel, float value) { w[static_cast<size_t>(channel)] = value; };
  const auto both = [&w](FaceChannel left, float value) {
    w[static_cast<size_t>(left)] = w[static_cast<size_t>(right_of(left))] = value;
  };
  switch (viseme) {
    case kSilence:
      break;
    case kPp:
      both(kMouthPressLeft, 0.7F);
      set(kMouthRollUpper, 0.15F);
      set(kMouthRollLower, 0.15F);
      break;
    case kFf:
      set(kJawOpen, 0.05F);
      set(kMouthRollLower, 0.7F);
      both(kMouthUpperUpLeft, 0.4F);
      both(kMouthStretchLeft, 0.1F);
      break;
    case kTh:
      set(kJawOpen, 0.14F);
      set(kTongueOut, 0.6F);
      both(kMouthLowerDownLeft, 0.1F);
      break;
    case kDd:
      set(kJawOpen, 0.1F);
      set(kTongueUp, 0.5F);
      both(kMouthStretchLeft, 0.15F);
      both(kMouthLowerDownLeft, 0.2F);
      break;
    case kKk:
      set(kJawOpen, 0.18F);
      both(kMouthStretchLeft, 0.1F);
      break;
    case kCh:
      set(kJawOpen, 0.08F);
      set(kMouthFunnel, 0.65F);
      break;
    case kSs:
      set(kJawOpen, 0.03F);
      both(kMouthStretchLeft, 0.4F);
      both(kMouthLowerDownLeft, 0.35F);
      both(kMouthUpperUpLeft, 0.2F);
      break;
    case kNn:
      set(kJawOpen, 0.14F);
      set(kTongueUp, 0.8F);
      both(kMouthStretchLeft, 0.15F);
      both(kMouthUpperUpLeft, 0.15F);
      break;
    case kRr:
      set(kJawOpen, 0.1F);
      set(kMouthPucker, 0.35F);
      break;
    case kAa:
      set(kJawOpen, 0.6F);
      both(kMouthStretchLeft, 0.1F);
      break;
    case kE:
      set(kJawOpen, 0.35F);
      both(kMouthStretchLeft, 0.3F);
      break;
    case kIh:
      set(kJawOpen, 0.12F);
      both(kMouthStretchLeft, 0.5F);
      both(kMouthSmileLeft, 0.35F);
      break;
    case kOh:
      set(kJawOpen, 0.3F);
      set(kMouthFunnel, 0.7F);
      break;
    case kOu:
      set(kJawOpen, 0.04F);
      set(kMouthPucker, 0.9F);
      break;
  }
  return w;
}

}  // namespace auslan
