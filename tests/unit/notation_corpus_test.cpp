// SPDX-License-Identifier: Apache-2.0
// Real dictionaries: every well-formed file is read, and each sign is signed or refused with a reason and a place.
#include "notation/notation.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <iostream>
#include <map>
#include <set>

namespace auslan {
namespace {

std::filesystem::path corpora() {
  return std::filesystem::path(AUSLANJAM_SOURCE_DIR) / ".." / "shared" / "corpora";
}

/// What synthesis relies on, whatever the notation said.
void expect_performable(const NotatedSign& notated, const std::string& where) {
  const Sign& sign = notated.sign;
  ASSERT_FALSE(sign.dominant.empty()) << where;
  std::set<std::string> shapes;
  for (const Handshape& shape : notated.handshapes)
    EXPECT_TRUE(shapes.insert(shape.id).second) << where << ": " << shape.id << " twice";
  for (const auto* postures : {&sign.dominant, &sign.non_dominant})
    for (const Posture& posture : *postures) {
      EXPECT_TRUE(shapes.count(posture.handshape))
          << where << ": " << posture.handshape << " is not among the handshapes";
      const double across = glm::dot(to_vector(posture.fingers), to_vector(posture.palm));
      EXPECT_LE(across * across, 0.67) << where << ": the palm faces along the fingers";
      EXPECT_LE(glm::dot(posture.offset, posture.offset), 3.0) << where << ": a place more than 1.7 m off";
    }
  if (sign.handedness == Handedness::kDominantBase) {
    EXPECT_EQ(sign.non_dominant.size(), sign.dominant.size()) << where;
  } else {
    EXPECT_TRUE(sign.non_dominant.empty()) << where;
  }
  for (const Movement& movement : sign.movements) {
    EXPECT_GE(movement.from, 0) << where;
    EXPECT_LE(movement.from, movement.to) << where;
    EXPECT_LT(movement.to, static_cast<int>(sign.dominant.size())) << where;
    EXPECT_GE(movement.repeats, 1) << where;
  }
}

struct Count {
  int files = 0, signs = 0, signable = 0, plain = 0, whole = 0;
};

Count read_folder(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".sigml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Count count;
  std::map<std::string, int> reasons;
  for (const auto& file : files) {
    ++count.files;
    const auto signs = read_sigml(file);
    EXPECT_TRUE(signs) << to_string(signs.error());
    if (!signs) continue;
    for (const NotatedSign& sign : *signs) {
      const std::string where = file.filename().string() + " " + sign.sign.gloss;
      ++count.signs;
      count.signable += sign.signable;
      bool told = false, warned = false;
      for (const Diagnostic& diagnostic : sign.diagnostics) {
        EXPECT_GE(diagnostic.line, 1) << where;
        EXPECT_GE(diagnostic.column, 1) << where;
        told = told || diagnostic.grade == Diagnostic::Grade::kError;
        warned = warned || diagnostic.grade == Diagnostic::Grade::kWarning;
        if (diagnostic.left_out || diagnostic.grade == Diagnostic::Grade::kError) ++reasons[diagnostic.message];
      }
      EXPECT_EQ(told, !sign.signable) << where << ": refused without an error, or signed with one";
      count.plain += sign.signable && !warned;
      count.whole += sign.signable && nothing_left_out(sign.diagnostics);
      if (sign.signable) expect_performable(sign, where);
    }
  }
  std::cout << folder.filename().string() << ": " << count.files << " files, " << count.signs << " signs, "
            << count.signable << " signable, " << count.whole << " of them with nothing left out, " << count.plain
            << " without a warning\n";
  std::vector<std::pair<int, std::string>> ranked;
  for (const auto& [message, times] : reasons)
    ranked.emplace_back(times, message);
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (size_t i = 0; i < ranked.size() && i < 12; ++i)
    std::cout << "  " << ranked[i].first << "  " << ranked[i].second << "\n";
  return count;
}

class NotationCorpus : public ::testing::TestWithParam<const char*> {};

TEST_P(NotationCorpus, IsReadAndAlmostAllAreSignedWithNothingLeftOut) {
  const std::filesystem::path folder = corpora() / GetParam();
  if (!std::filesystem::is_directory(folder))
    GTEST_SKIP() << "the sample " << GetParam() << " is not beside this checkout (../shared/corpora)";
  const Count count = read_folder(folder);
  EXPECT_GT(count.files, 0);
  EXPECT_GE(count.whole * 100, count.signs * 98) << "signed, and nothing that is written left out";
}

INSTANTIATE_TEST_SUITE_P(Samples, NotationCorpus, ::testing::Values("ngt", "isl", "bsl"),
                         [](const auto& sample) { return std::string(sample.param); });

}  // namespace
}  // namespace auslan
