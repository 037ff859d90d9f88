// SPDX-License-Identifier: Apache-2.0
// The list of what is known to break a limit: what is read, what is refused, and what it excuses.
#include "check/exceptions.h"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <vector>

namespace auslan {
namespace {

Checked checked(const std::string& subject, Measure measure, double value) {
  Checked made;
  made.subject = subject;
  made.verdict.worst[static_cast<size_t>(measure)] = Measured{value, ticks(0.5), "wrist_r to chin", {}};
  return made;
}

std::vector<CheckException> list(const std::string& text) {
  return read_exceptions(text, "list").value();
}

std::vector<CheckFinding::Kind> kinds(const std::vector<CheckFinding>& findings) {
  std::vector<CheckFinding::Kind> kinds;
  for (const CheckFinding& finding : findings)
    kinds.push_back(finding.kind);
  return kinds;
}

TEST(CheckExceptions, ALineHasASubjectAMeasureABoundAndAReason) {
  const auto read =
      list("# a remark\n\nHURT contact 4.5 the chin is round\r\nphrase:hello  sign-rate\t1.25 slow signs\n");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].subject, "HURT");
  EXPECT_EQ(read[0].measure, Measure::kContact);
  EXPECT_EQ(read[0].bound, 4.5);
  EXPECT_EQ(read[0].reason, "the chin is round");
  EXPECT_EQ(read[1].measure, Measure::kSignRate);
  EXPECT_EQ(read[1].reason, "slow signs");
  EXPECT_TRUE(list("").empty());
}

TEST(CheckExceptions, WhatIsWrongInALineIsToldWithItsPlace) {
  for (const char* wrong :
       {"HURT", "HURT contact", "HURT contact 4.5", "HURT contact 4.5   ", "HURT touching 4.5 reason",
        "HURT contact four reason", "HURT contact 4.5mm reason", "HURT contact nan reason", "HURT contact inf reason",
        "HURT contact 2.0 within the limit", "HURT hold 90 within the limit", "HURT contact 4 a\nHURT contact 5 b"}) {
    const auto read = read_exceptions("# one\n" + std::string(wrong), "list.txt");
    ASSERT_FALSE(read) << wrong;
    EXPECT_EQ(read.error().code, ErrorCode::kMalformed);
    EXPECT_EQ(read.error().place.rfind("list.txt:", 0), 0U) << read.error().place;
    EXPECT_NE(read.error().place, "list.txt:1");
  }
}

TEST(CheckExceptions, ABrokenLimitIsANewFindingUnlessItIsListed) {
  using Kind = CheckFinding::Kind;
  const std::vector<Checked> all = {checked("HURT", Measure::kContact, 4.0)};
  EXPECT_EQ(kinds(compare(all, {}, true)), std::vector{Kind::kNew});
  EXPECT_TRUE(compare(all, list("HURT contact 4.5 x"), true).empty());
  EXPECT_EQ(kinds(compare(all, list("HURT contact 3.9 x"), true)), std::vector{Kind::kWorse});
  EXPECT_EQ(kinds(compare(all, list("HURT pressing 4.5 x"), true)), (std::vector{Kind::kNew, Kind::kNeedless}));
}

TEST(CheckExceptions, WhatHasBeenMendedOrIsGoneHasNoPlaceOnTheList) {
  using Kind = CheckFinding::Kind;
  const std::vector<Checked> all = {checked("HURT", Measure::kContact, 2.0)};
  EXPECT_TRUE(compare(all, {}, true).empty());
  EXPECT_EQ(kinds(compare(all, list("HURT contact 4.5 x"), true)), std::vector{Kind::kNeedless});
  const auto other = list("GONE contact 4.5 x");
  EXPECT_EQ(kinds(compare(all, other, true)), std::vector{Kind::kUnknown});
  EXPECT_TRUE(compare(all, other, false).empty());
}

TEST(CheckExceptions, BelowARangeTheBoundIsTheLeast) {
  using Kind = CheckFinding::Kind;
  const std::vector<Checked> all = {checked("HURT", Measure::kHold, 60.0)};
  EXPECT_TRUE(compare(all, list("HURT hold 55 x"), true).empty());
  EXPECT_EQ(kinds(compare(all, list("HURT hold 65 x"), true)), std::vector{Kind::kWorse});
}

TEST(CheckExceptions, TheWrittenListExcusesWhatItWasWrittenForWithLittleRoom) {
  std::vector<Checked> all;
  double value = 3.001;
  for (int i = 0; i < 60; ++i, value *= 1.31) {
    all.push_back(checked("S" + std::to_string(i), Measure::kContact, value));
    all.push_back(checked("T" + std::to_string(i), Measure::kStroke, 1.69 / (1.0 + i)));
  }
  const auto made = exceptions_for(all);
  ASSERT_EQ(made.size(), all.size());
  const auto read = read_exceptions(write_exceptions(made), "list");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_TRUE(compare(all, *read, true).empty());
  for (size_t i = 0; i < made.size(); ++i) {
    EXPECT_EQ((*read)[i].bound, made[i].bound);
    const double worst = all[i].verdict.of(made[i].measure)->value;
    const double room = made[i].measure == Measure::kContact ? made[i].bound / worst : worst / made[i].bound;
    EXPECT_GE(room, 1.0);
    EXPECT_LE(room, 1.15);
  }
}

TEST(CheckExceptions, AReasonThatSomebodyWroteIsKeptWhileItsBoundHolds) {
  const std::vector<Checked> all = {checked("HURT", Measure::kContact, 4.0), checked("NECK", Measure::kContact, 6.0),
                                    checked("EYE", Measure::kContact, 5.0)};
  const auto made =
      exceptions_for(all, list("HURT contact 4.5 the sleeve\nNECK contact 5 the collar\nEAR contact 9 x"));
  ASSERT_EQ(made.size(), 3U);
  EXPECT_EQ(made[0].reason, "the sleeve");
  EXPECT_EQ(made[0].bound, 4.5);
  EXPECT_TRUE(made[1].reason.starts_with(kUnreviewed)) << made[1].reason;
  EXPECT_GE(made[1].bound, 6.0);
  EXPECT_TRUE(made[2].reason.starts_with(kUnreviewed)) << made[2].reason;
}

TEST(CheckExceptions, SomebodyHasLookedAtEachOfTheShippedOnes) {
  std::ifstream file(std::string(AUSLANJAM_SOURCE_DIR) + "/assets/check_exceptions.txt");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const auto shipped = read_exceptions(text, "check_exceptions.txt");
  ASSERT_TRUE(shipped) << to_string(shipped.error());
  for (const CheckException& one : *shipped)
    EXPECT_FALSE(one.reason.starts_with(kUnreviewed)) << one.subject << " " << info(one.measure).name;
}

}  // namespace
}  // namespace auslan
