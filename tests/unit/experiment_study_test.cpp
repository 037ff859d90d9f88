// SPDX-License-Identifier: Apache-2.0
// What section 4.2 of the paper states about Euler angles, lerp and slerp.
#include "experiment/interpolation_study.h"
#include "experiment/study_report.h"
#include "kinematics/elementary.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>
#include <string>

namespace auslan {
namespace {

const std::vector<StudyRun>& runs() {
  static const std::vector<StudyRun> made = run_study();
  return made;
}

const StudyRun& run(int end, Method method) {
  return runs()[static_cast<size_t>(end * 3 + static_cast<int>(method))];
}

TEST(Study, TheTwoEndsAreOneOrientation) {
  const Quat a = from_euler(kStudyEnds[0] * kDegree, kPaperOrder), b = from_euler(kStudyEnds[1] * kDegree, kPaperOrder);
  EXPECT_LT(angle_between(a, b), 1e-12);
}

TEST(Study, InNoOtherAxisOrderAreTheyOneOrientation) {
  int equal = 0;
  for (const EulerOrder order :
       {EulerOrder::kXYZ, EulerOrder::kXZY, EulerOrder::kYXZ, EulerOrder::kYZX, EulerOrder::kZXY, EulerOrder::kZYX})
    equal +=
        angle_between(from_euler(kStudyEnds[0] * kDegree, order), from_euler(kStudyEnds[1] * kDegree, order)) < 1e-6
            ? 1
            : 0;
  EXPECT_EQ(equal, 1);
}

TEST(Study, HasTwoHundredFramesThatBeginAndEndWhereTheyShould) {
  ASSERT_EQ(runs().size(), 6U);
  const Quat start = from_euler(kStudyStart * kDegree, kPaperOrder);
  for (const StudyRun& r : runs()) {
    ASSERT_EQ(r.orientation.size(), 200U);
    ASSERT_EQ(r.velocity.size(), 199U);
    EXPECT_LT(angle_between(r.orientation.front(), start), 1e-12);
    EXPECT_LT(r.distance.back(), 1e-10);
    EXPECT_NEAR(r.distance.front(), 90.0, 1e-9);  // the turn from 180 to 270 degrees about Y
  }
}

TEST(Study, EulerAnglesTakeDifferentPathsToTheSameEnd) {
  EXPECT_GT(largest_separation(run(0, Method::kEuler), run(1, Method::kEuler)), 10.0);
  EXPECT_GT(summarise(run(0, Method::kEuler)).path_degrees, 100.0);
}

TEST(Study, LerpAndSlerpTakeTheSamePathWhicheverEndIsGiven) {
  EXPECT_LT(largest_separation(run(0, Method::kLerp), run(1, Method::kLerp)), 1e-10);
  EXPECT_LT(largest_separation(run(0, Method::kSlerp), run(1, Method::kSlerp)), 1e-10);
  EXPECT_NEAR(summarise(run(0, Method::kLerp)).path_degrees, 90.0, 1e-9);
}

TEST(Study, SlerpHasConstantSpeedLerpAndEulerHaveNot) {
  EXPECT_LT(summarise(run(0, Method::kSlerp)).variation, 1e-4);
  EXPECT_LT(summarise(run(1, Method::kSlerp)).variation, 1e-4);
  EXPECT_GT(summarise(run(0, Method::kLerp)).variation, 0.05);
  EXPECT_GT(summarise(run(0, Method::kEuler)).variation, 0.05);
}

TEST(Study, LerpIsFastestHalfWay) {
  // For an angle of 90 degrees between two orientations the quaternions are 45 degrees apart; the speed of the
  // normalised chord at its middle over that at its ends is 1 / cos^2(22.5 degrees).
  const auto& velocity = run(0, Method::kLerp).velocity;
  const double half = cosine(22.5 * kDegree);
  EXPECT_NEAR(velocity[99] / velocity[0], 1.0 / (half * half), 0.01);
}

TEST(Study, TheTableHasARowAFrame) {
  std::istringstream table(study_table(runs(), 0));
  std::string line;
  int rows = 0;
  while (std::getline(table, line)) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 6) << line;
    ++rows;
  }
  EXPECT_EQ(rows, 201);
}

}  // namespace
}  // namespace auslan
