// SPDX-License-Identifier: Apache-2.0
// From the words of a clause to items, still in English order: what is signed, spelled or dropped, and by which rule.
#pragma once

#include "clauses.h"
#include "translate/translation.h"
#include "warnings.h"
#include "word_index.h"
#include "words.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

/// An item and what the grammar must know of it.
struct Draft {
  Item item;
  bool lead = false;  ///< before the clause proper: "and", "please" …
  bool wh = false;    ///< the wh-sign of the clause, or a word that goes with it
  bool time = false;  ///< may go to the start of the clause
  bool negator = false;
};

class Resolver {
 public:
  Resolver(std::string_view text, std::span<const Word> words, const WordIndex& index, Warnings* warnings)
      : text_(text), words_(words), index_(index), warnings_(warnings) {}

  std::vector<Draft> resolve(const Clause& clause);

  /// One item for `count` words, spelled letter by letter; kDropped with a warning where none has a letter.
  Item spell(size_t at, size_t count, std::string_view rule);
  /// One item for the number at words[at] that `digits` reads.
  Item number(size_t at, size_t count, std::string_view digits, std::string_view rule);
  /// Sign, number or spelling of one word without regard to its neighbours' grammar.
  Item word(size_t at);
  /// Letters or digits of a text that stands in no input: the glosses "fs:" and "num:" of phrases.
  std::vector<std::string> letters_of(std::string_view written);
  std::vector<std::string> number_glosses(std::string_view digits);
  /// Lowers the item's confidence and review state to those of its entries.
  void rate(Item* item) const;
  Item item_over(size_t at, size_t count, ItemKind kind) const;

 private:
  struct Sense {
    std::vector<std::string> glosses;       ///< one or more distinct senses, best first
    std::vector<std::string> alternatives;  ///< senses that the part of speech ruled out
    std::string_view rule;
    bool doubtful = false;
  };

  size_t add_next(size_t at, std::vector<Draft>* out);
  size_t add_negation(size_t at, std::vector<Draft>* out);
  size_t add_expression(size_t at, std::vector<Draft>* out);
  void add_word(size_t at, std::vector<Draft>* out);
  void add_sign(size_t at, size_t count, const std::string& gloss, std::string_view rule, bool negator,
                std::vector<Draft>* out);
  std::string_view drop_rule(size_t at) const;
  std::string_view do_rule(size_t at) const;
  bool is_perfect(size_t at) const;
  bool is_existential(size_t at) const;
  bool is_dummy_it(size_t at) const;
  bool is_verb(size_t at) const;
  bool is_name(size_t at) const;
  bool stands_alone(size_t at) const;  ///< a letter as itself: "K-I-M", "ward A"
  bool joined(size_t at) const;        ///< words[at] is in the clause, no punctuation between it and the word before
  void find_names();
  void find_case();
  std::string_view expected_part_of_speech(size_t at) const;
  Sense sense_of(size_t at) const;
  std::vector<std::string> distinct(std::span<const int> keywords, std::string_view part_of_speech) const;
  bool lemma_is(size_t at, std::string_view lemma) const;
  void mark_past(size_t at, std::vector<Draft>* out);

  std::string_view text_;
  std::span<const Word> words_;
  const WordIndex& index_;
  Warnings* warnings_;
  Clause clause_;
  size_t name_begin_ = 0, name_end_ = 0;  ///< words after "my name is"
  bool ignore_capitals_ = false;          ///< the clause is written in capitals or in title case
  bool has_time_ = false;
};

}  // namespace auslan
