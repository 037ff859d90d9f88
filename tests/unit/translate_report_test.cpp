// SPDX-License-Identifier: Apache-2.0
// The translation as a table and as JSON.
#include "translate/report.h"
#include "translate_vocabulary.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

namespace auslan {
namespace {

Translation translated(const char* english) {
  return *Translator::build(test::vocabulary())->translate(english);
}

TEST(Report, JsonHoldsWhatTheTranslationHolds) {
  const Translation translation = translated("Where does it hurt, \"Kim\"?");
  const auto json = nlohmann::json::parse(to_json(translation));
  EXPECT_EQ(json["english"], translation.english);
  ASSERT_EQ(json["items"].size(), translation.items.size());
  for (size_t i = 0; i < translation.items.size(); ++i) {
    const Item& item = translation.items[i];
    EXPECT_EQ(json["items"][i]["glosses"].get<std::vector<std::string>>(), item.glosses);
    EXPECT_EQ(json["items"][i]["rules"].get<std::vector<std::string>>(), item.rules);
    EXPECT_EQ(json["items"][i]["begin"], item.begin);
    EXPECT_EQ(json["items"][i]["kind"], to_name(item.kind));
    for (const size_t s : json["items"][i]["non_manual"]) {
      EXPECT_LE(translation.non_manual[s].from, static_cast<int>(i));
      EXPECT_GE(translation.non_manual[s].to, static_cast<int>(i));
    }
  }
  EXPECT_EQ(json["non_manual"][0]["kind"], "wh");
  EXPECT_EQ(json["warnings"].size(), translation.warnings.size());
}

TEST(Report, TableShowsEnglishGlossRulesReviewSpansAndWarnings) {
  const std::string table = interlinear(translated("I can't see the right abbey?"));
  for (const char* part : {"can't", "CANT", "neg:lexical", "(not signed)", "drop:article", "A-B-B-E-Y", "unreviewed",
                           "ambiguous: RIGHT", "neg over 1 to", "brows raise", "checked by a Deaf signer"})
    EXPECT_NE(table.find(part), std::string::npos) << part << "\n" << table;
}

TEST(Report, TableHoldsNoControlCharacters) {
  const std::string table = interlinear(translated("a\x1B[31mred\x07 \u202Ehello, not\r\nwater"));
  for (const char c : table)
    EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20);
  EXPECT_EQ(table.find("\u202E"), std::string::npos);
}

}  // namespace
}  // namespace auslan
