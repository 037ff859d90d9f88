// SPDX-License-Identifier: Apache-2.0
#include "translate/word_forms.h"

#include <array>
#include <fstream>
#include <sstream>
#include <utility>

namespace auslan {

Result<std::vector<WordForm>> read_wordnet_exceptions(const std::filesystem::path& folder) {
  static constexpr std::array<const char*, 4> kParts = {"noun", "verb", "adj", "adv"};
  std::vector<WordForm> forms;
  for (const char* part : kParts) {
    const std::filesystem::path path = folder / (std::string(part) + ".exc");
    std::error_code error;
    if (!std::filesystem::exists(path, error))
      return fail(ErrorCode::kNotFound, "no WordNet exception list is there; install the package wordnet-base",
                  path.string());
    std::ifstream file(path);
    if (!file) return fail(ErrorCode::kUnreadable, "the file cannot be opened; check its permissions", path.string());
    std::string line;
    for (size_t number = 1; std::getline(file, line); ++number) {
      std::istringstream fields(line);
      std::string form, lemma;
      fields >> form;
      if (form.empty()) continue;
      if (!(fields >> lemma))
        return fail(ErrorCode::kMalformed, "a line is not \"form lemma\"; install wordnet-base again",
                    path.string() + ":" + std::to_string(number));
      do {
        if (form != lemma && form.find('_') == std::string::npos && lemma.find('_') == std::string::npos)
          forms.push_back({form, lemma, part});
      } while (fields >> lemma);
    }
    if (file.bad()) return fail(ErrorCode::kUnreadable, "the file cannot be read to its end", path.string());
  }
  return forms;
}

}  // namespace auslan
