// SPDX-License-Identifier: Apache-2.0
// Irregular word forms from WordNet's exception lists.
#include "translate/word_forms.h"
#include "translate_vocabulary.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace auslan {
namespace {

class WordFormsFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("word_forms_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const char* name, const char* text) { std::ofstream(folder_ / name) << text; }

  std::filesystem::path folder_;
};

TEST_F(WordFormsFolder, ReadsFormsInTheOrderOfTheLists) {
  write("noun.exc", "teeth tooth\naxes ax axis\nattorneys_general attorney_general\n");
  write("verb.exc", "went go\n");
  write("adj.exc", "better good\nafter after\n");
  write("adv.exc", "");
  const auto forms = read_wordnet_exceptions(folder_);
  ASSERT_TRUE(forms) << to_string(forms.error());
  std::string line;
  for (const WordForm& form : *forms)
    line += form.form + ">" + form.lemma + ":" + form.part_of_speech + " ";
  EXPECT_EQ(line, "teeth>tooth:noun axes>ax:noun axes>axis:noun went>go:verb better>good:adj ");
}

TEST_F(WordFormsFolder, NamesTheFileThatIsMissingAndTheLineThatIsBroken) {
  EXPECT_EQ(read_wordnet_exceptions(folder_).error().code, ErrorCode::kNotFound);
  write("noun.exc", "teeth tooth\nalone\n");
  const auto broken = read_wordnet_exceptions(folder_);
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().code, ErrorCode::kMalformed);
  EXPECT_NE(broken.error().place.find("noun.exc:2"), std::string::npos);
}

TEST(WordForms, DebiansListsLeadToTheBaseForm) {
  const auto forms = read_wordnet_exceptions();
  if (!forms) GTEST_SKIP() << to_string(forms.error());
  TranslatorData data = test::vocabulary();
  data.irregular_lemmas = *forms;
  const auto translator = Translator::build(std::move(data));
  ASSERT_TRUE(translator);
  EXPECT_EQ(test::signed_line(*translator->translate("my teeth hurt")), "MY TOOTH HURT");
  EXPECT_EQ(test::signed_line(*translator->translate("we drank, knew, saw and understood")),
            "WE DRINK | KNOW | SEE AND-PLUS UNDERSTAND");
}

}  // namespace
}  // namespace auslan
