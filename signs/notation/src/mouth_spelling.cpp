// SPDX-License-Identifier: Apache-2.0
#include "mouth_spelling.h"

#include <array>
#include <utility>

namespace auslan::notation {
namespace {

using Sound = std::pair<std::string_view, std::string_view>;

// Longer signs first.
constexpr std::array<Sound, 62> kSounds = {{
    {"a_I", "igh"}, {"e_I", "ay"}, {"O_I", "oy"}, {"@_U", "oh"}, {"a_U", "ow"}, {"t_S", "ch"}, {"d_Z", "j"},
    {"aI", "igh"},  {"eI", "ay"},  {"OI", "oy"},  {"@U", "oh"},  {"aU", "ow"},  {"tS", "ch"},  {"dZ", "j"},
    {"a:", "ah"},   {"A:", "ah"},  {"i:", "ee"},  {"u:", "oo"},  {"O:", "aw"},  {"o:", "oh"},  {"e:", "ay"},
    {"3:", "er"},   {"E:", "air"}, {"y:", "oo"},  {"2:", "er"},  {"9y", "oy"},  {"Ei", "ay"},  {"Au", "ow"},
    {"a", "a"},     {"A", "ah"},   {"e", "e"},    {"E", "e"},    {"{", "a"},    {"i", "i"},    {"I", "i"},
    {"o", "o"},     {"O", "o"},    {"Q", "o"},    {"u", "u"},    {"U", "oo"},   {"V", "u"},    {"@", "e"},
    {"3", "er"},    {"y", "oo"},   {"Y", "oo"},   {"2", "er"},   {"9", "er"},   {"S", "sh"},   {"Z", "zh"},
    {"T", "th"},    {"D", "th"},   {"N", "ng"},   {"j", "y"},    {"J", "ny"},   {"x", "h"},    {"X", "h"},
    {"R", "r"},     {"G", "g"},    {"C", "h"},    {"6", "er"},   {"q", "k"},    {"c", "k"},
}};

constexpr std::string_view kOwnLetters = "bdfghklmnprstvwz";

}  // namespace

std::string spelling_of_sampa(std::string_view sampa) {
  std::string spelling;
  size_t i = 0;
  while (i < sampa.size() && spelling.size() < 200) {
    bool found = false;
    for (const auto& [sign, letters] : kSounds) {
      if (sampa.substr(i, sign.size()) != sign) continue;
      spelling += letters;
      i += sign.size();
      found = true;
      break;
    }
    if (found) continue;
    const char c = sampa[i++];
    if (kOwnLetters.find(c) != std::string_view::npos) spelling += c;
    if (c == ' ' && !spelling.empty() && spelling.back() != ' ') spelling += ' ';
  }
  while (!spelling.empty() && spelling.back() == ' ')
    spelling.pop_back();
  return spelling;
}

}  // namespace auslan::notation
