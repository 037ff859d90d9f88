// SPDX-License-Identifier: Apache-2.0
// Figures of other makers under `auslanjam check`: the alphabet and fifty signs each, told in full, and what a figure
// cannot do is told too.
#include "sample_avatars.h"
#include "scratch_folder.h"

#include <array>
#include <cstdio>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

namespace auslan {
namespace {

using nlohmann::json;

/// Every eighth sign of the lexicon as it was when the figures were first measured, so that the figures stay
/// comparable.
constexpr std::array<const char*, 50> kSigns = {
    "LOSE",      "STAND", "BRING",    "WORK",        "STAY",       "NOT",   "HEAD",     "SHOULDER", "RED",
    "NAME",      "THINK", "SHOW",     "READ",        "EMERGENCY",  "STOP",  "HAPPY",    "LIKE",     "COFFEE",
    "CHICKEN",   "NUT",   "HELLO",    "SORRY-NORTH", "PATIENT",    "VOMIT", "HEADACHE", "SWOLLEN",  "WELL-HEALTHY",
    "ALIVE",     "HAVE",  "PEOPLE",   "CHILDREN",    "SISTER",     "HERE",  "UP",       "ROOM",     "BED",
    "HIS-HER",   "BAD",   "SMALL",    "DIFFERENT",   "WITHOUT",    "WHO",   "HOW-OLD",  "BAG",      "TORCH",
    "YESTERDAY", "YEAR",  "SATURDAY", "SINCE",       "BREAK-PAUSE"};

std::string subjects() {
  std::string all;
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    all += std::string(" fs:") + letter;
  for (const char* gloss : kSigns)
    all += std::string(" '") + gloss + "'";
  return all;
}

struct Sample {
  const char* name;
  const char* lack;  ///< something that it is told to lack
  int good;          ///< of the 76: how many keep all limits at least; may become more, never fewer

  friend std::ostream& operator<<(std::ostream& out, const Sample& sample) { return out << sample.name; }
};

class CheckAvatars : public testing::TestWithParam<Sample> {};

TEST_P(CheckAvatars, EveryMeasureIsTakenOfLettersAndSigns) {
  const auto& [name, lack, least_good] = GetParam();
  AUSLAN_NEEDS_AVATAR(name);
  const Ran ran = run(std::string(AUSLANJAM_PROGRAM) + " check --json --quiet --threads 2 --avatar '" +
                      test::sample_avatar(name).string() + "'" + subjects() + " 2>/dev/null");
  ASSERT_FALSE(ran.output.empty());
  const json told = json::parse(ran.output);
  ASSERT_EQ(told["entries"].size(), 76U);
  int good = 0;
  const std::string lacks = told["figure"]["lacks"].dump();
  for (const json& entry : told["entries"]) {
    const bool is_good = entry["good"].get<bool>();
    good += is_good ? 1 : 0;
    // What no place was found for is told in one line, with how far it is outside; ten are named.
    if (!is_good && entry.contains("out_of_reach")) {
      EXPECT_NE(lacks.find("found no place for a posture of"), std::string::npos) << entry["gloss"];
    }
    // A figure with whole hands does all else within the limits.
    if (!is_good && least_good > 0) {
      EXPECT_TRUE(entry.contains("out_of_reach")) << entry;
    }
    for (const char* measure : {"penetration", "direction", "handshape", "joint-limits", "joint-speed",
                                "angular-velocity", "wrist-speed", "mirror"})
      EXPECT_TRUE(entry["measures"].contains(measure)) << entry["gloss"] << " " << measure;
    EXPECT_TRUE(entry["measures"]["mirror"]["good"].get<bool>()) << entry["gloss"];
    // A limit that an arm meets within a few milliseconds of a key may show as a jump of its velocity there.
    EXPECT_LT(entry["measures"]["angular-velocity"]["value"].get<double>(), 5.0) << entry["gloss"];
  }
  std::printf("%s: %d of 76 within all limits; outside of each measure:", name, good);
  for (const auto& [measure, total] : told["totals"].items())
    if (total["measured"].get<int>() > 0)
      std::printf(" %s %d/%d", measure.c_str(), total["outside"].get<int>(), total["measured"].get<int>());
  std::printf("\n");
  EXPECT_GE(good, least_good);
  EXPECT_NE(lacks.find(lack), std::string::npos) << told["figure"];
}

INSTANTIATE_TEST_SUITE_P(Samples, CheckAvatars,
                         testing::Values(Sample{"makehuman.glb", "mouthPressLeft", 75},
                                         Sample{"makehuman.vrm", "mouthPressLeft", 75},
                                         Sample{"godette.vrm", "ring finger is missing", 0}));

}  // namespace
}  // namespace auslan
