// SPDX-License-Identifier: Apache-2.0
// Irregular English word forms: "teeth" is the plural of "tooth".
#pragma once

#include "kinematics/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace auslan {

struct WordForm {
  std::string form;            ///< lower case
  std::string lemma;           ///< lower case
  std::string part_of_speech;  ///< noun, verb, adj or adv, as in Keyword
};

/// Where Debian's wordnet-base keeps its lists.
inline constexpr const char* kWordnetFolder = "/usr/share/wordnet";

/// Reads noun.exc, verb.exc, adj.exc and adv.exc of WordNet 3.0 from `folder`, in that order. Fixed expressions (with
/// an underscore) and lines that name no other lemma are left out. Fails with kNotFound or kUnreadable naming the file,
/// and with kMalformed and file:line where a line is not "form lemma…".
Result<std::vector<WordForm>> read_wordnet_exceptions(const std::filesystem::path& folder = kWordnetFolder);

}  // namespace auslan
