// SPDX-License-Identifier: Apache-2.0
#include "lemma.h"

#include <algorithm>
#include <array>
#include <utility>

namespace auslan {
namespace {

template <size_t N>
bool contains(const std::array<std::string_view, N>& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

struct Closed {
  std::string_view form, lemma, rule, part_of_speech;
};

// Closed-class forms that WordNet does not list.
constexpr std::array<Closed, 28> kClosed = {{{"me", "i", "lemma:pronoun", ""},
                                             {"us", "we", "lemma:pronoun", ""},
                                             {"him", "he", "lemma:pronoun", ""},
                                             {"them", "they", "lemma:pronoun", ""},
                                             {"she", "he", "lemma:pronoun", ""},
                                             {"it", "he", "lemma:pronoun", ""},
                                             {"mine", "my", "lemma:pronoun", ""},
                                             {"yours", "your", "lemma:pronoun", ""},
                                             {"ours", "our", "lemma:pronoun", ""},
                                             {"theirs", "their", "lemma:pronoun", ""},
                                             {"hers", "her", "lemma:pronoun", ""},
                                             {"its", "his", "lemma:pronoun", ""},
                                             {"whom", "who", "lemma:wh", "wh"},
                                             {"whose", "who", "lemma:wh", "wh"},
                                             {"has", "have", "lemma:third-person", "verb"},
                                             {"had", "have", "lemma:past", "verb"},
                                             {"does", "do", "lemma:third-person", "verb"},
                                             {"did", "do", "lemma:past", "verb"},
                                             {"could", "can", "lemma:modal", ""},
                                             {"would", "will", "lemma:modal", ""},
                                             {"shall", "will", "lemma:modal", ""},
                                             {"might", "may", "lemma:modal", ""},
                                             {"people", "person", "lemma:plural", "noun"},
                                             {"children", "child", "lemma:plural", "noun"},
                                             {"men", "man", "lemma:plural", "noun"},
                                             {"hi", "hello", "synonym:greeting", "interj"},
                                             {"dr", "doctor", "abbreviation", "noun"},
                                             {"prof", "professor", "abbreviation", "noun"}}};

// Past forms and plurals that are also base words of another meaning.
constexpr std::array<std::string_view, 20> kAlsoBase = {"wound", "ground", "bore",  "lay",   "rose", "saw",   "left",
                                                        "found", "felt",   "fell",  "bound", "dove", "lit",   "bit",
                                                        "rung",  "spat",   "stove", "shot",  "cast", "leaves"};

// Words in -ly that do not mean what their adjective means.
constexpr std::array<std::string_view, 14> kOtherAdverbs = {"hardly", "lately",   "shortly",  "barely",  "nearly",
                                                            "likely", "scarcely", "highly",   "largely", "fairly",
                                                            "rarely", "lonely",   "friendly", "elderly"};

bool is_vowel(char c) {
  return c == 'a' || c == 'e' || c == 'i' || c == 'o' || c == 'u';
}

bool ends_with(std::string_view word, std::string_view suffix) {
  return word.size() >= suffix.size() && word.substr(word.size() - suffix.size()) == suffix;
}

/// walking -> walk, making -> make, stopping -> stop: what is left of a word without -ing, -ed, -er or -est.
void add_stems(std::string_view stem, std::string_view rule, std::string_view part_of_speech,
               std::vector<LemmaCandidate>* out) {
  if (stem.size() < 2) return;
  const auto add = [&](std::string lemma) { out->push_back({std::move(lemma), rule, part_of_speech, false}); };
  const char last = stem.back();
  const bool doubled = stem.size() > 2 && last == stem[stem.size() - 2] && !is_vowel(last);
  if (doubled && last != 'l' && last != 's') add(std::string(stem.substr(0, stem.size() - 1)));
  add(std::string(stem));
  add(std::string(stem) + "e");
  if (doubled && (last == 'l' || last == 's')) add(std::string(stem.substr(0, stem.size() - 1)));
  if (last == 'i') add(std::string(stem.substr(0, stem.size() - 1)) + "y");
}

void add_suffix_forms(std::string_view word, std::vector<LemmaCandidate>* out) {
  const auto cut = [&](size_t n) { return word.substr(0, word.size() - n); };
  if (word.size() > 2 && word.back() == 's' && !ends_with(word, "ss") && !ends_with(word, "us") &&
      !ends_with(word, "is")) {
    const auto both = [&](const std::string& lemma) {
      out->push_back({lemma, "lemma:plural", "noun", false});
      out->push_back({lemma, "lemma:third-person", "verb", false});
    };
    if (ends_with(word, "ies") && word.size() > 4) both(std::string(cut(3)) + "y");
    both(std::string(cut(1)));
    if (ends_with(word, "es")) both(std::string(cut(2)));
  }
  if (ends_with(word, "ing")) add_stems(cut(3), "lemma:ing", "verb", out);
  if (ends_with(word, "ed")) add_stems(cut(2), "lemma:past", "verb", out);
  if (ends_with(word, "er")) add_stems(cut(2), "lemma:comparative", "adj", out);
  if (ends_with(word, "est")) add_stems(cut(3), "lemma:superlative", "adj", out);
  if (ends_with(word, "ly") && word.size() > 4 && !contains(kOtherAdverbs, word)) {
    out->push_back({std::string(cut(2)), "lemma:adverb", "adj", false});
    if (ends_with(word, "ily")) out->push_back({std::string(cut(3)) + "y", "lemma:adverb", "adj", false});
  }
}

/// What an irregular form is, by the part of speech of its list.
std::string_view irregular_rule(std::string_view part_of_speech, std::string_view form) {
  if (part_of_speech == "noun") return "lemma:plural";
  if (part_of_speech == "verb") {
    if (ends_with(form, "ing")) return "lemma:ing";
    return ends_with(form, "s") ? "lemma:third-person" : "lemma:past";
  }
  return ends_with(form, "st") ? "lemma:superlative" : "lemma:comparative";
}

}  // namespace

Lemmatiser::Lemmatiser(const std::vector<WordForm>& irregular) {
  for (const WordForm& form : irregular)
    irregular_[form.form].push_back({form.lemma, form.part_of_speech});
}

std::vector<LemmaCandidate> Lemmatiser::candidates(std::string_view word) const {
  std::vector<LemmaCandidate> result;
  if (word.size() > 40) return result;  // no English word; keeps the work for a megabyte of letters small
  for (const Closed& closed : kClosed)
    if (closed.form == word) result.push_back({std::string(closed.lemma), closed.rule, closed.part_of_speech, false});
  const bool doubtful = contains(kAlsoBase, word);
  if (const auto found = irregular_.find(word); found != irregular_.end())
    for (const Form& form : found->second)
      result.push_back({form.lemma, irregular_rule(form.part_of_speech, word), form.part_of_speech, doubtful});
  add_suffix_forms(word, &result);
  return result;
}

}  // namespace auslan
