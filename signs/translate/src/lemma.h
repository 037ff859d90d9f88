// SPDX-License-Identifier: Apache-2.0
// Base forms an English word may have, by table and by suffix. Candidates only: the caller keeps those that it knows.
#pragma once

#include "translate/word_forms.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

struct LemmaCandidate {
  std::string lemma;
  std::string_view rule;            ///< "lemma:plural", "lemma:past" …
  std::string_view part_of_speech;  ///< of the form, as in Keyword; empty = any
  bool doubtful = false;            ///< the form is itself a common base word ("wound")
};

class Lemmatiser {
 public:
  explicit Lemmatiser(const std::vector<WordForm>& irregular);

  /// Irregular forms first, then suffixes, the likelier base first. At most a dozen; `word` is case-folded.
  std::vector<LemmaCandidate> candidates(std::string_view word) const;

 private:
  struct Form {
    std::string lemma, part_of_speech;
  };
  std::map<std::string, std::vector<Form>, std::less<>> irregular_;
};

}  // namespace auslan
