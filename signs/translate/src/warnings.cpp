// SPDX-License-Identifier: Apache-2.0
#include "warnings.h"

#include <utility>

namespace auslan {
namespace {

constexpr size_t kShown = 20;        // of each kind
constexpr size_t kLongestWord = 60;  // bytes of a word that a warning quotes

std::string quote(std::string_view what) {
  std::string result = "\"";
  size_t length = what.size();
  if (length > kLongestWord) {
    length = kLongestWord;
    while (length > 0 && (static_cast<unsigned char>(what[length]) & 0xC0) == 0x80)
      --length;
  }
  result += what.substr(0, length);
  if (length < what.size()) result += "\u2026";
  return result + "\"";
}

std::string sentence_of(WarningKind kind, std::string_view what, std::string_view detail) {
  const std::string word = quote(what);
  const std::string more(detail);
  switch (kind) {
    case WarningKind::kNoLetter:
      return word + " has no sign and no letter that can be fingerspelled: it is not signed.";
    case WarningKind::kLostCharacter:
      return word + " is spelled without " + more + ", which has no letter.";
    case WarningKind::kLongSpelling:
      return word + " is spelled in " + more + " letters: show it in writing too.";
    case WarningKind::kAmbiguous:
      return word + " can be " + more + ": the first was chosen.";
    case WarningKind::kPast:
      return "The past of " + word + " is not signed: add a time word such as \"yesterday\" if it matters.";
    case WarningKind::kMissingEntry:
      return "The entry " + word + " of phrase " + more + " is not in the lexicon: it is spelled.";
    case WarningKind::kNumberForm:
      return "The number " + word + " is signed digit by digit.";
  }
  return {};
}

}  // namespace

void Warnings::add(WarningKind kind, std::string_view what, std::string_view detail) {
  Group& group = groups_[static_cast<size_t>(kind)];
  if (group.sentences.size() >= kShown) {
    ++group.more;
    return;
  }
  std::string sentence = sentence_of(kind, what, detail);
  if (group.seen.insert(sentence).second) group.sentences.push_back(std::move(sentence));
}

std::vector<std::string> Warnings::sentences() const {
  std::vector<std::string> result;
  for (const Group& group : groups_) {
    result.insert(result.end(), group.sentences.begin(), group.sentences.end());
    if (group.more > 0)
      result.push_back("There are " + std::to_string(group.more) + " more warnings like the last one.");
  }
  return result;
}

}  // namespace auslan
