// SPDX-License-Identifier: Apache-2.0
// What holds for every sentence, tried on generated ones.
#include "translate/report.h"
#include "translate_vocabulary.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {
namespace {

constexpr int kSentences = 5000;

constexpr std::array<std::string_view, 62> kWords = {
    "I",     "you",   "the",   "a",      "is",    "are",        "was",           "do",    "does",  "did",     "have",
    "has",   "had",   "not",   "never",  "no",    "can",        "can't",         "won't", "must",  "mustn't", "will",
    "could", "may",   "might", "should", "what",  "where",      "who",           "how",   "much",  "why",     "when",
    "Kim",   "Zorba", "Dr.",   "name",   "my",    "it",         "there",         "to",    "going", "hurt",    "hurts",
    "eat",   "water", "left",  "right",  "teeth", "tablets",    "two",           "25",    "2.5",   "today",   "now",
    "and",   "but",   "if",    "don't",  "got",   "frobnicate", "blood pressure"};
constexpr std::array<std::string_view, 6> kEnds = {" ", " ", " ", ", ", ". ", "? "};

struct Token {
  size_t begin = 0, end = 0;
  std::string_view word;
};

struct Generated {
  std::string text;
  std::vector<Token> tokens;
};

Generated generate(uint32_t seed) {
  uint32_t state = seed * 2654435761u + 1;
  const auto draw = [&](size_t n) {
    state = state * 1664525u + 1013904223u;
    return static_cast<size_t>(state >> 8) % n;
  };
  Generated result;
  const size_t count = 1 + draw(14);
  for (size_t i = 0; i < count; ++i) {
    const std::string_view word = kWords[draw(kWords.size())];
    result.tokens.push_back({result.text.size(), result.text.size() + word.size(), word});
    result.text += word;
    result.text += kEnds[draw(kEnds.size())];
  }
  return result;
}

const Translator& translator() {
  static const Translator kTranslator = [] {
    TranslatorData data = test::vocabulary();
    data.phrases = {test::phrase("name", "My name is {NAME}.", {"MY", "NAME", "{NAME}"}),
                    test::phrase("where-pain", "Where is the water?", {"WATER", "WHERE"}),
                    test::phrase("must-not", "You must not eat.", {"EAT", "MUST", "NOT"})};
    return std::move(*Translator::build(std::move(data)));
  }();
  return kTranslator;
}

bool contains(const std::vector<std::string_view>& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

TEST(Properties, EveryWordIsCoveredByExactlyOneItem) {
  for (uint32_t seed = 0; seed < kSentences; ++seed) {
    const Generated sentence = generate(seed);
    const auto result = translator().translate(sentence.text);
    ASSERT_TRUE(result) << sentence.text;
    std::vector<int> covered(sentence.text.size(), 0);
    for (const Item& item : result->items) {
      ASSERT_LE(item.begin, item.end);
      ASSERT_EQ(sentence.text.substr(item.begin, item.end - item.begin), item.text) << sentence.text;
      if (item.kind != ItemKind::kPause)
        for (size_t i = item.begin; i < item.end; ++i)
          ++covered[i];
    }
    for (size_t i = 0; i < sentence.text.size(); ++i) {
      if (std::isalnum(static_cast<unsigned char>(sentence.text[i])) != 0) {
        ASSERT_EQ(covered[i], 1) << sentence.text << " at " << i;
      }
    }
  }
}

TEST(Properties, NegatorsModalsNumbersAndNamesAreSigned) {
  const std::vector<std::string_view> negators = {"not", "never", "no", "can't", "won't", "mustn't", "don't"};
  const std::vector<std::string_view> kept = {"can", "must",  "will", "could", "may", "might",     "should",
                                              "Kim", "Zorba", "two",  "25",    "2.5", "frobnicate"};
  const std::vector<std::string_view> negative_signs = {
      "NOT", "NEVER", "NO", "CANT", "NOT-HAVE", "NOT-WANT", "NOT-LIKE", "NOT-UNDERSTAND", "DONT-KNOW"};
  for (uint32_t seed = 0; seed < kSentences; ++seed) {
    const Generated sentence = generate(seed);
    const auto result = translator().translate(sentence.text);
    ASSERT_TRUE(result);
    for (const Token& token : sentence.tokens) {
      bool is_signed = false, negative = false;
      for (const Item& item : result->items) {
        if (item.kind == ItemKind::kDropped || item.kind == ItemKind::kPause) continue;
        if (item.end <= token.begin || item.begin >= token.end) continue;
        is_signed = true;
        negative = negative || contains(negative_signs, item.glosses.front());
      }
      if (contains(kept, token.word)) {
        ASSERT_TRUE(is_signed) << token.word << " in " << sentence.text;
      }
      if (contains(negators, token.word) && sentence.text.find("ou must not eat") == std::string::npos) {
        ASSERT_TRUE(negative) << token.word << " in " << sentence.text;
      }
    }
  }
}

TEST(Properties, TheSameSentenceGivesTheSameResult) {
  const Translator other = *Translator::build([] {
    TranslatorData data = test::vocabulary();
    data.phrases = {test::phrase("name", "My name is {NAME}.", {"MY", "NAME", "{NAME}"}),
                    test::phrase("where-pain", "Where is the water?", {"WATER", "WHERE"}),
                    test::phrase("must-not", "You must not eat.", {"EAT", "MUST", "NOT"})};
    return data;
  }());
  for (uint32_t seed = 0; seed < kSentences; seed += 10) {
    const std::string text = generate(seed).text;
    ASSERT_EQ(to_json(*translator().translate(text)), to_json(*other.translate(text)));
  }
}

TEST(Properties, SpansLieOnItemsAndItemsNameEntriesAndRules) {
  const TranslatorData data = test::vocabulary();
  for (uint32_t seed = 0; seed < kSentences; seed += 5) {
    const Generated sentence = generate(seed);
    const auto result = translator().translate(sentence.text);
    ASSERT_TRUE(result);
    for (const NonManualSpan& span : result->non_manual) {
      ASSERT_GE(span.from, 0);
      ASSERT_LE(span.from, span.to) << sentence.text << " " << span.kind;
      ASSERT_LT(static_cast<size_t>(span.to), result->items.size());
    }
    for (const Item& item : result->items) {
      ASSERT_FALSE(item.rules.empty()) << sentence.text;
      const bool performs = item.kind != ItemKind::kDropped && item.kind != ItemKind::kPause;
      ASSERT_EQ(item.glosses.empty(), !performs) << sentence.text;
      for (const std::string& gloss : item.glosses)
        ASSERT_TRUE(std::any_of(data.entries.begin(), data.entries.end(), [&](const EntryFacts& entry) {
          return entry.gloss == gloss;
        })) << gloss;
    }
  }
}

}  // namespace
}  // namespace auslan
