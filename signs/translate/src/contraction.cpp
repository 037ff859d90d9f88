// SPDX-License-Identifier: Apache-2.0
#include "contraction.h"

#include <algorithm>
#include <array>
#include <utility>

namespace auslan {
namespace {

constexpr std::array<std::string_view, 20> kBeforeNot = {"do",    "does", "did",   "is",    "are",   "was",    "were",
                                                         "have",  "has",  "had",   "could", "would", "should", "must",
                                                         "might", "need", "ought", "dare",  "may",   "am"};

// Words whose 's is "is", and "let", whose 's is "us".
constexpr std::array<std::string_view, 18> kBeforeIs = {
    "it",  "he",   "she", "that", "this",       "there",     "here",    "what", "where",
    "who", "when", "how", "why",  "everything", "something", "nothing", "name", "everyone"};

template <size_t N>
bool contains(const std::array<std::string_view, N>& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

struct Bare {
  std::string_view word, first;
  size_t first_length;
  std::string_view second;
};

// Written without the apostrophe. Only forms that are no other common word: "ill", "well", "shed" are left alone.
constexpr std::array<Bare, 26> kBare = {{{"dont", "do", 2, "not"},
                                         {"doesnt", "does", 4, "not"},
                                         {"didnt", "did", 3, "not"},
                                         {"cant", "can", 3, "not"},
                                         {"cannot", "can", 3, "not"},
                                         {"wont", "will", 2, "not"},
                                         {"isnt", "is", 2, "not"},
                                         {"arent", "are", 3, "not"},
                                         {"wasnt", "was", 3, "not"},
                                         {"werent", "were", 4, "not"},
                                         {"couldnt", "could", 5, "not"},
                                         {"wouldnt", "would", 5, "not"},
                                         {"shouldnt", "should", 6, "not"},
                                         {"mustnt", "must", 4, "not"},
                                         {"havent", "have", 4, "not"},
                                         {"hasnt", "has", 3, "not"},
                                         {"hadnt", "had", 3, "not"},
                                         {"neednt", "need", 4, "not"},
                                         {"im", "i", 1, "am"},
                                         {"ive", "i", 1, "have"},
                                         {"youre", "you", 3, "are"},
                                         {"theyre", "they", 4, "are"},
                                         {"youve", "you", 3, "have"},
                                         {"weve", "we", 2, "have"},
                                         {"gonna", "going", 3, "to"},
                                         {"wanna", "want", 3, "to"}}};

/// Splits at the last apostrophe; false where it is no contraction.
bool split_last(std::string_view word, ContractionPart* base, ContractionPart* tail, ApostropheS* apostrophe_s) {
  const size_t at = word.rfind('\'');
  if (at == std::string_view::npos || at == 0 || at + 1 == word.size()) return false;
  const std::string_view suffix = word.substr(at + 1);
  const auto parts = [&](size_t length, std::string_view first, std::string_view second) {
    *base = {length, std::string(first)};
    *tail = {word.size() - length, std::string(second)};
    return true;
  };
  const std::string_view stem = word.substr(0, at);
  if (suffix == "t" && stem.size() > 2 && stem.back() == 'n') {
    if (stem == "can") return parts(3, "can", "not");
    if (stem == "won") return parts(2, "will", "not");
    if (stem == "shan") return parts(3, "shall", "not");
    if (stem == "ain") return parts(2, "is", "not");
    const std::string_view verb = stem.substr(0, stem.size() - 1);
    return contains(kBeforeNot, verb) && parts(verb.size(), verb, "not");
  }
  if (suffix == "m") return parts(at, stem, "am");
  if (suffix == "re") return parts(at, stem, "are");
  if (suffix == "ve") return parts(at, stem, "have");
  if (suffix == "ll") return parts(at, stem, "will");
  if (suffix == "d") return parts(at, stem, "would");
  if (suffix == "s") {
    if (stem == "let") return parts(at, stem, "us");
    if (contains(kBeforeIs, stem)) {
      *apostrophe_s = ApostropheS::kCopula;
      return parts(at, stem, "is");
    }
    *apostrophe_s = ApostropheS::kUnclear;
  }
  return false;
}

}  // namespace

Contraction expand_contraction(std::string_view word) {
  Contraction result;
  for (const Bare& bare : kBare)
    if (bare.word == word) {
      result.parts.push_back({bare.first_length, std::string(bare.first)});
      result.parts.push_back({word.size() - bare.first_length, std::string(bare.second)});
      return result;
    }
  std::vector<ContractionPart> tails;  // from the last to the first: "couldn't've"
  std::string_view rest = word;
  ContractionPart base{word.size(), std::string(word)};
  ContractionPart tail;
  while (tails.size() < 3 && split_last(rest, &base, &tail, &result.apostrophe_s)) {
    tails.push_back(tail);
    rest = rest.substr(0, base.length);
  }
  result.parts.push_back(std::move(base));
  for (size_t i = tails.size(); i-- > 0;)
    result.parts.push_back(std::move(tails[i]));
  if (result.parts.size() > 1 && result.apostrophe_s == ApostropheS::kUnclear) result.apostrophe_s = ApostropheS::kNone;
  return result;
}

}  // namespace auslan
