// SPDX-License-Identifier: Apache-2.0
// A small vocabulary for the tests of the translator: hospital words, a few phrases, some words with two senses.
#pragma once

#include "translate/translator.h"

#include <string>
#include <utility>
#include <vector>

namespace auslan::test {

struct KeywordRow {
  const char* word;
  const char* part_of_speech;
  const char* gloss;
  int rank;
};

inline const std::vector<KeywordRow>& keyword_rows() {
  static const std::vector<KeywordRow> kRows = {
      {"hello", "interj", "HELLO", 0},
      {"please", "adv", "PLEASE", 0},
      {"thank you", "interj", "THANK-YOU", 0},
      {"yes", "interj", "YES", 0},
      {"no", "interj", "NO", 0},
      {"i", "pron", "I", 0},
      {"you", "pron", "YOU", 0},
      {"we", "pron", "WE", 0},
      {"he", "pron", "HE-SHE-IT", 0},
      {"she", "pron", "HE-SHE-IT", 0},
      {"it", "pron", "HE-SHE-IT", 0},
      {"my", "pron", "MY", 0},
      {"your", "pron", "YOUR", 0},
      {"name", "noun", "NAME", 0},
      {"what", "wh", "WHAT", 0},
      {"where", "wh", "WHERE", 0},
      {"when", "wh", "WHEN", 0},
      {"who", "wh", "WHO", 0},
      {"why", "wh", "WHY", 0},
      {"how", "wh", "HOW", 0},
      {"how much", "wh", "HOW-MUCH", 0},
      {"what time", "noun", "TIME", 0},
      {"time", "noun", "TIME", 0},
      {"hurt", "verb", "HURT", 0},
      {"pain", "noun", "PAIN", 0},
      {"eat", "verb", "EAT", 0},
      {"drink", "verb", "DRINK", 0},
      {"drink", "noun", "DRINK", 0},
      {"walk", "verb", "WALK", 0},
      {"know", "verb", "KNOW", 0},
      {"want", "verb", "WANT", 0},
      {"have", "verb", "HAVE", 0},
      {"like", "verb", "LIKE", 0},
      {"need", "verb", "NEED", 0},
      {"understand", "verb", "UNDERSTAND", 0},
      {"go", "verb", "GO", 0},
      {"leave", "verb", "GO", 0},
      {"wait", "verb", "WAIT", 0},
      {"see", "verb", "SEE", 0},
      {"take", "verb", "TAKE", 0},
      {"sit down", "verb", "SIT-DOWN", 0},
      {"blood pressure", "noun", "BLOOD-PRESSURE", 0},
      {"must", "modal", "MUST", 0},
      {"have to", "modal", "MUST", 0},
      {"can", "modal", "CAN", 0},
      {"will", "modal", "WILL", 0},
      {"not", "neg", "NOT", 0},
      {"don't", "neg", "NOT", 0},
      {"never", "neg", "NEVER", 0},
      {"nothing", "neg", "NOTHING", 0},
      {"today", "adv", "TODAY", 0},
      {"tomorrow", "adv", "TOMORROW", 0},
      {"yesterday", "adv", "YESTERDAY", 0},
      {"now", "adv", "NOW", 0},
      {"and", "conj", "AND-PLUS", 0},
      {"but", "conj", "BUT", 0},
      {"if", "conj", "IF", 0},
      {"because", "conj", "BECAUSE", 0},
      {"doctor", "noun", "DOCTOR", 0},
      {"nurse", "noun", "NURSE", 0},
      {"tablet", "noun", "TABLET", 0},
      {"tooth", "noun", "TOOTH", 0},
      {"leg", "noun", "LEG", 0},
      {"baby", "noun", "BABY", 0},
      {"toilet", "noun", "TOILET", 0},
      {"water", "noun", "WATER", 0},
      {"water", "noun", "WATER-NORTH", 1},
      {"fire", "noun", "FIRE", 0},
      {"sick", "adj", "SICK", 0},
      {"deaf", "adj", "DEAF", 0},
      {"big", "adj", "BIG", 0},
      {"slow", "adj", "SLOW", 0},
      {"slow", "adv", "SLOW", 0},
      {"brown", "adj", "BROWN", 0},
      {"more", "adv", "MORE", 0},
      {"many", "adj", "MANY", 0},
      {"left", "adj", "LEFT", 0},
      {"left", "noun", "LEFT", 0},
      {"right", "adj", "RIGHT-CORRECT", 0},
      {"right", "adj", "RIGHT", 1},
      {"cold", "adj", "COLD-TEMPERATURE", 0},
      {"cold", "noun", "COLD-ILLNESS", 1},
      {"first", "adj", "FIRST", 0},
      {"here", "adv", "HERE", 0},
      {"there", "adv", "THERE", 0},
      {"hearing (person)", "adj", "HEARING", 0},
      {"use", "verb", "USE", 0},
      {"stop", "verb", "STOP", 0},
      {"ghost", "noun", "REJECTED-SIGN", 0},
  };
  return kRows;
}

/// A span of a phrase.
inline NonManualSpan phrase_span(std::string kind, int from, int to, std::string brows) {
  NonManualSpan span;
  span.kind = std::move(kind);
  span.from = from;
  span.to = to;
  span.brows = std::move(brows);
  return span;
}

inline Phrase phrase(std::string id, std::string english, std::vector<std::string> glosses,
                     std::vector<NonManualSpan> spans = {}) {
  Phrase result;
  result.id = std::move(id);
  result.english = std::move(english);
  result.glosses = std::move(glosses);
  result.non_manual = std::move(spans);
  result.provenance.confidence = Confidence::kMedium;
  return result;
}

/// Entries for all glosses of the keywords, the lexicalised negatives, letters and the numbers 0 to 20; no phrases.
inline TranslatorData vocabulary() {
  TranslatorData data;
  const auto add_entry = [&](const std::string& gloss) {
    for (const EntryFacts& entry : data.entries)
      if (entry.gloss == gloss) return;
    data.entries.push_back({gloss, Confidence::kHigh, ReviewState::kUnreviewed});
  };
  for (const KeywordRow& row : keyword_rows()) {
    data.keywords.push_back({row.word, row.part_of_speech, row.gloss, row.rank});
    add_entry(row.gloss);
  }
  for (const char* gloss : {"CANT", "NOT-HAVE", "NOT-WANT", "NOT-LIKE", "NOT-UNDERSTAND", "DONT-KNOW"})
    add_entry(gloss);
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    add_entry(std::string("fs:") + letter);
  for (int number = 0; number <= 20; ++number)
    add_entry("num:" + std::to_string(number));
  for (EntryFacts& entry : data.entries)
    if (entry.gloss == "REJECTED-SIGN") entry.review = ReviewState::kRejected;
  data.irregular_lemmas = {{"teeth", "tooth", "noun"}, {"went", "go", "verb"},    {"left", "leave", "verb"},
                           {"knew", "know", "verb"},   {"taken", "take", "verb"}, {"took", "take", "verb"},
                           {"ate", "eat", "verb"},     {"eaten", "eat", "verb"}};
  return data;
}

/// The signed part of a translation on one line: glosses, spelled words as K-I-M, numbers as #10, "|" for a pause.
inline std::string signed_line(const Translation& translation) {
  std::string line;
  for (const Item& item : translation.items) {
    if (item.kind == ItemKind::kDropped) continue;
    if (!line.empty()) line += ' ';
    if (item.kind == ItemKind::kPause) line += '|';
    if (item.kind == ItemKind::kNumber) line += '#';
    for (size_t i = 0; i < item.glosses.size(); ++i) {
      const std::string& gloss = item.glosses[i];
      if (i > 0) line += '-';
      line += gloss.substr(gloss.find(':') + 1);
    }
  }
  return line;
}

}  // namespace auslan::test
