// SPDX-License-Identifier: Apache-2.0
#include "closed_class.h"

#include <algorithm>
#include <array>

namespace auslan {
namespace {

template <size_t N>
bool contains(const std::array<std::string_view, N>& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

using Words3 = std::array<std::string_view, 3>;

}  // namespace

bool is_article(std::string_view word) {
  return contains(Words3{"a", "an", "the"}, word);
}

bool is_copula(std::string_view word) {
  static constexpr std::array<std::string_view, 8> kWords = {"am", "is", "are", "was", "were", "be", "been", "being"};
  return contains(kWords, word);
}

bool is_past_copula(std::string_view word) {
  return contains(Words3{"was", "were", "been"}, word);
}

bool is_do_form(std::string_view word) {
  return contains(Words3{"do", "does", "did"}, word);
}

bool is_have_form(std::string_view word) {
  return contains(Words3{"have", "has", "had"}, word);
}

bool is_modal(std::string_view word) {
  static constexpr std::array<std::string_view, 9> kWords = {"can",   "could",  "may",  "might", "must",
                                                             "shall", "should", "will", "would"};
  return contains(kWords, word);
}

bool is_auxiliary(std::string_view word) {
  return is_do_form(word) || is_have_form(word) || is_modal(word) ||
         (is_copula(word) && word != "be" && word != "been" && word != "being");
}

bool is_wh(std::string_view word) {
  static constexpr std::array<std::string_view, 9> kWords = {"what",  "where", "when", "who", "whom",
                                                             "whose", "which", "why",  "how"};
  return contains(kWords, word);
}

bool is_negator(std::string_view word) {
  static constexpr std::array<std::string_view, 9> kWords = {"not",    "never",   "no",      "nothing", "none",
                                                             "nobody", "nowhere", "neither", "nor"};
  return contains(kWords, word);
}

bool is_subject_pronoun(std::string_view word) {
  static constexpr std::array<std::string_view, 7> kWords = {"i", "you", "he", "she", "it", "we", "they"};
  return contains(kWords, word);
}

bool is_pronoun(std::string_view word) {
  static constexpr std::array<std::string_view, 19> kWords = {
      "this", "that", "these", "those", "there", "anyone",   "someone",   "everyone",   "anybody",  "somebody",
      "me",   "him",  "her",   "us",    "them",  "anything", "something", "everything", "everybody"};
  return is_subject_pronoun(word) || contains(kWords, word);
}

bool is_possessive_pronoun(std::string_view word) {
  static constexpr std::array<std::string_view, 7> kWords = {"my", "your", "his", "her", "its", "our", "their"};
  return contains(kWords, word);
}

bool is_determiner(std::string_view word) {
  static constexpr std::array<std::string_view, 10> kWords = {"this", "that", "these", "those", "some",
                                                              "any",  "no",   "every", "each",  "another"};
  return is_article(word) || is_possessive_pronoun(word) || contains(kWords, word);
}

bool is_conjunction(std::string_view word) {
  static constexpr std::array<std::string_view, 10> kWords = {"and", "but",  "or",    "so",  "because",
                                                              "if",  "then", "while", "nor", "although"};
  return contains(kWords, word);
}

bool is_clause_opener(std::string_view word) {
  static constexpr std::array<std::string_view, 18> kWords = {"and",    "but",   "or",   "so",     "because", "then",
                                                              "please", "hello", "hi",   "hey",    "sorry",   "ok",
                                                              "okay",   "yes",   "well", "thanks", "goodbye", "oh"};
  return contains(kWords, word);
}

bool is_clause_closer(std::string_view word) {
  static constexpr std::array<std::string_view, 8> kWords = {"please", "thanks", "thank",   "but",
                                                             "so",     "then",   "because", "sorry"};
  return contains(kWords, word);
}

bool is_time_word(std::string_view word) {
  static constexpr std::array<std::string_view, 5> kWords = {"today", "tomorrow", "yesterday", "now", "tonight"};
  return contains(kWords, word);
}

bool is_preposition(std::string_view word) {
  static constexpr std::array<std::string_view, 30> kWords = {
      "to",     "at",      "in",      "on",      "of",    "for",  "from", "by",      "with",   "about",
      "until",  "till",    "since",   "before",  "after", "into", "onto", "near",    "under",  "over",
      "during", "through", "between", "without", "than",  "as",   "like", "against", "except", "beside"};
  return contains(kWords, word);
}

bool is_degree(std::string_view word) {
  static constexpr std::array<std::string_view, 13> kWords = {"much", "many", "long", "old",  "far",   "often", "bad",
                                                              "big",  "late", "soon", "tall", "heavy", "early"};
  return contains(kWords, word);
}

bool is_title(std::string_view word) {
  static constexpr std::array<std::string_view, 8> kWords = {"mr", "mrs",    "ms",   "miss",
                                                             "dr", "doctor", "prof", "professor"};
  return contains(kWords, word);
}

bool is_title_abbreviation(std::string_view word) {
  static constexpr std::array<std::string_view, 6> kWords = {"mr", "mrs", "ms", "dr", "prof", "st"};
  return contains(kWords, word);
}

bool is_unit(std::string_view word) {
  static constexpr std::array<std::string_view, 24> kWords = {"am",   "pm", "mg",  "ml",   "mcg", "g",  "kg",  "cm",
                                                              "mm",   "km", "m",   "l",    "h",   "hr", "hrs", "min",
                                                              "mins", "s",  "sec", "secs", "c",   "x",  "kj",  "k"};
  return contains(kWords, word);
}

bool is_ordinal(std::string_view word) {
  if (word.size() < 3) return false;
  const std::string_view digits = word.substr(0, word.size() - 2);
  const std::string_view suffix = word.substr(word.size() - 2);
  return std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
         (suffix == "st" || suffix == "nd" || suffix == "rd" || suffix == "th");
}

bool is_impersonal_verb(std::string_view word) {
  static constexpr std::array<std::string_view, 19> kWords = {
      "hurt", "hurts", "hurting", "ache",   "aches",   "aching",   "rain",   "rains",   "raining", "rained",
      "snow", "snows", "snowing", "happen", "happens", "happened", "matter", "matters", "snowed"};
  return contains(kWords, word);
}

bool is_motion_verb(std::string_view word) {
  static constexpr std::array<std::string_view, 22> kWords = {
      "go",     "goes",    "going", "went",  "gone",    "come",   "comes",  "coming", "came",    "walk", "walks",
      "walked", "walking", "drive", "drove", "driving", "travel", "return", "bring",  "brought", "take", "took"};
  return contains(kWords, word);
}

bool follows_copula(std::string_view word) {
  static constexpr std::array<std::string_view, 12> kWords = {"here", "there",  "ok",    "okay", "very", "so",
                                                              "sick", "coming", "going", "late", "gone", "been"};
  return is_article(word) || is_possessive_pronoun(word) || is_negator(word) || is_preposition(word) ||
         is_pronoun(word) || is_wh(word) || contains(kWords, word);
}

bool is_closed_class(std::string_view word) {
  static constexpr std::array<std::string_view, 8> kWords = {"yes",  "ok",  "okay",    "here",
                                                             "also", "too", "spelled", "called"};
  return is_article(word) || is_auxiliary(word) || is_copula(word) || is_wh(word) || is_negator(word) ||
         is_pronoun(word) || is_determiner(word) || is_conjunction(word) || is_clause_opener(word) ||
         is_preposition(word) || is_time_word(word) || contains(kWords, word);
}

}  // namespace auslan
