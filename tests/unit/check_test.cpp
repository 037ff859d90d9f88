// SPDX-License-Identifier: Apache-2.0
// Performances whose faults are known because they were put there.
#include "check/check.h"

#include "kinematics/arm_ik.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
#include "kinematics/solid.h"
#include "shipped.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace auslan {
namespace {

class Check : public ::testing::Test {
 protected:
  Check() : checker_(*shipped().signer) {
    Posture posture;
    posture.fingers = {0, 1, 0};
    posture.palm = {0, 0, 1};
    posture.offset = Vec3(-0.05, 0.0, 0.3);
    const Handshape flat = shipped().lexicon->handshape("flat").value().value();
    shown_ = shipped().signer->place(posture, flat, Side::kRight, {}).state;
    low_ = {shipped().signer->rest(Side::kLeft), shipped().signer->rest(Side::kRight)};
  }
  /// The left hand hangs; the right one goes from state to state, each way in so many seconds.
  static HandSegment segment(Tick begin, Tick end, const HandState& from, const HandState& to) {
    HandSegment made;
    made.begin = begin;
    made.end = end;
    made.from = from;
    made.to = to;
    return made;
  }
  Score score_of_states(const std::vector<HandState>& states, double each) const {
    Score score;
    for (size_t i = 0; i + 1 < states.size(); ++i) {
      score.hands[1].push_back(segment(score.end, score.end + ticks(each), states[i], states[i + 1]));
      score.end += ticks(each);
    }
    score.hands[0] = {segment(0, score.end, low_[0], low_[0])};
    return score;
  }
  HandState moved(const Vec3& way) const {
    HandState state = shown_;
    state.wrist.position += way;
    return state;
  }

  /// A place on the chest with the normal of the skin as it is drawn.
  static Site chest_skin() {
    const Figure& figure = shipped().figure;
    const int trunk = figure.skeleton.find("spine_base");
    const Vec3 origin = figure.skeleton.rest_position(trunk);
    const Vec3 place = shipped().signer->body().site(Location::kChest, Side::kRight, Vec3(0.0), true).position;
    const auto skin = Solid(figure.segments[static_cast<size_t>(trunk)]).nearest(place - origin, 0.05).value();
    return {skin.position + origin, skin.normal};
  }

  /// A hand with a point of it at a place, its arm within the limits of its joints: as near to `shown_` as they allow.
  HandState at(const Vec3& point, const Vec3& place) const {
    const Skeleton& skeleton = shipped().figure.skeleton;
    const Vec3 trunk = skeleton.rest_position(arm_nodes(skeleton, Side::kRight).trunk);
    HandState state = shown_;
    double least = 1e9;
    for (double swivel = -60.0; swivel <= 150.0; swivel += 5.0) {
      const auto reached =
          shipped().signer->reach(Side::kRight).reach(shown_.wrist.rotation, point, place - trunk, swivel * kDegree);
      if (reached.lean + 10.0 * reached.excess >= least) continue;
      least = reached.lean + 10.0 * reached.excess;
      state.wrist = {reached.wrist.rotation, reached.wrist.position + trunk};
      state.swivel = swivel * kDegree;
    }
    return state;
  }

  Checker checker_;
  HandState shown_;
  std::array<HandState, 2> low_;
};

TEST_F(Check, HandsThatHangAreInNothing) {
  const Verdict verdict = checker_.check(score_of_states({low_[1], low_[1]}, 0.5));
  EXPECT_TRUE(verdict.good(Measure::kPenetration));
  EXPECT_TRUE(verdict.good(Measure::kWristSpeed));
  EXPECT_FALSE(verdict.of(Measure::kContact));
}

TEST_F(Check, AStrokeOfTwentyCentimetresInATenthOfASecondIsTooFast) {
  // The peak of a minimum-jerk stroke is 1.875 times its mean; 120 samples a second see a little less of it.
  const Verdict verdict = checker_.check(score_of_states({shown_, moved({0.1, 0.17, 0.03})}, 0.1));
  const double way = std::sqrt(0.1 * 0.1 + 0.17 * 0.17 + 0.03 * 0.03);
  EXPECT_NEAR(verdict.of(Measure::kWristSpeed)->value, 1.875 * way / 0.1, 0.1);
  EXPECT_NEAR(verdict.of(Measure::kStroke)->value, 1.875, 0.01);
  EXPECT_FALSE(checker_.check(score_of_states({shown_, moved({0.2, 0.17, 0.03})}, 0.1)).good(Measure::kWristSpeed));
}

TEST_F(Check, AHandInTheHeadIsAsDeepAsItWasPut) {
  const Skeleton& skeleton = shipped().figure.skeleton;
  HandState state = shown_;
  // The fingers' middle joints in the middle of the head.
  state.wrist.position = skeleton.rest_position(skeleton.find("head_base")) + Vec3(0.0, -0.06, 0.02);
  const Verdict verdict = checker_.check(score_of_states({state, state}, 0.1));
  EXPECT_GT(verdict.of(Measure::kPenetration)->value, 40.0);
  EXPECT_LT(verdict.of(Measure::kPenetration)->value, 110.0);
  EXPECT_NE(verdict.of(Measure::kPenetration)->where.find("_base"), std::string::npos);
  EXPECT_FALSE(verdict.good());
}

TEST_F(Check, TouchingPartsMayPressWhereTheEntrySaysSo) {
  const Site chin = shipped().signer->body().site(Location::kChin, Side::kRight, Vec3(0.0), true);
  HandState state = shown_;
  const Vec3 tip = shipped().signer->hand(Side::kRight).site(HandPart::kMiddleTip, state.angles).position;
  Score score = score_of_states({state, state}, 0.2);
  const auto put = [&](double deep) {
    state = at(tip, chin.position - chin.normal * deep);
    score.hands[1].front().from = score.hands[1].front().to = state;
    HandTarget target;
    target.begin = ticks(0.05);
    target.end = ticks(0.15);
    target.touches = true;
    target.part = tip;
    target.location = Location::kChin;
    score.targets[1] = {target};
    return checker_.check(score);
  };
  EXPECT_NEAR(put(0.002).of(Measure::kContact)->value, 2.0, 1.5);
  EXPECT_NEAR(put(-0.008).of(Measure::kContact)->value, 8.0, 1.5);
  EXPECT_TRUE(put(-0.008).good(Measure::kPenetration));
  const Verdict pressed = put(0.012);
  ASSERT_TRUE(pressed.of(Measure::kPressing));
  EXPECT_NEAR(pressed.of(Measure::kPressing)->value, 12.0, 5.0);
}

TEST_F(Check, DirectionsAndHoldsAreThoseOfTheTarget) {
  Score score = score_of_states({shown_, shown_}, 0.4);
  const HandFrame& frame = shipped().signer->hand_frame(Side::kRight);
  HandTarget target;
  target.begin = ticks(0.1);
  target.end = ticks(0.16);
  target.palm = shown_.wrist.rotation * frame.palm;
  // The fingers were chosen to point ten degrees to the side of where they do, and are stated another twenty off.
  target.reached = axis_angle(target.palm, 10.0 * kDegree) * shown_.wrist.rotation;
  target.fingers = axis_angle(target.palm, 30.0 * kDegree) * (shown_.wrist.rotation * frame.fingers);
  target.angles = shown_.angles;
  score.targets[1] = {target};
  score.glosses = {{"X", 0, ticks(0.4), false, 0}};
  const Verdict verdict = checker_.check(score);
  EXPECT_NEAR(verdict.of(Measure::kDirection)->value, 10.0, 0.2);
  EXPECT_NEAR(verdict.of(Measure::kLeaning)->value, 20.0, 0.2);
  EXPECT_NEAR(verdict.of(Measure::kHold)->value, 60.0, 1.0);
  EXPECT_FALSE(verdict.good(Measure::kHold));
  EXPECT_NEAR(verdict.of(Measure::kHandshape)->value, 0.0, 1e-6);
  score.targets[1].front().angles.fingers[0].pip += 5.0 * kDegree;
  EXPECT_NEAR(checker_.check(score).of(Measure::kHandshape)->value, 5.0, 0.1);
}

TEST_F(Check, AJerkAtAKeyIsSeen) {
  // The first segment ends in full swing: a path twice as long, cut in its middle.
  Score score = score_of_states({shown_, moved({0.1, 0.1, 0.0})}, 0.4);
  EXPECT_TRUE(checker_.check(score).good(Measure::kAngularVelocity));
  HandSegment first = score.hands[1].front();
  first.oscillation.turn = Vec3(0.5, 0.0, 0.0);
  first.oscillation.cycles = 1.25;
  HandSegment second = first;
  second.oscillation = {};
  second.from = second.to;
  second.begin = ticks(0.2);
  first.end = ticks(0.2);
  second.from.wrist.rotation = axis_angle(Vec3(1, 0, 0), 0.2) * second.from.wrist.rotation;
  score.hands[1] = {first, second};
  EXPECT_FALSE(checker_.check(score).good(Measure::kAngularVelocity));
}

TEST_F(Check, AHandBeforeTheMouthHidesIt) {
  const Skeleton& skeleton = shipped().figure.skeleton;
  HandState state = shown_;
  state.wrist.position = skeleton.rest_position(skeleton.find("head_base")) + Vec3(0.0, -0.1, 0.25);
  EXPECT_NEAR(checker_.check(score_of_states({state, state}, 0.2)).of(Measure::kFaceHidden)->value, 100.0, 0.1);
  EXPECT_NEAR(checker_.check(score_of_states({low_[1], low_[1]}, 0.2)).of(Measure::kFaceHidden)->value, 0.0, 0.1);
}

TEST_F(Check, ALettersHoldIsMeasuredOnItsOwn) {
  Score score = score_of_states({shown_, shown_}, 0.4);
  HandTarget target;
  target.begin = ticks(0.1);
  target.end = ticks(0.2);
  target.fingers = Vec3(0, 1, 0);
  target.palm = Vec3(0, 0, 1);
  target.angles = shown_.angles;
  score.targets[1] = {target};
  score.glosses = {{"KIM", 0, ticks(0.4), true, 0}};
  const Verdict verdict = checker_.check(score);
  EXPECT_FALSE(verdict.of(Measure::kHold));
  EXPECT_NEAR(verdict.of(Measure::kLetterHold)->value, 100.0, 1.0);
  EXPECT_FALSE(verdict.good(Measure::kLetterHold));
}

TEST_F(Check, ARateNeedsFiveSignsOrThreeLettersInARowWithoutAPause) {
  Score score = score_of_states({shown_, shown_}, 4.0);
  const auto rate = [&](const std::vector<GlossSpan>& glosses, Measure measure) {
    score.glosses = glosses;
    const Verdict verdict = checker_.check(score);
    return verdict.of(measure) ? verdict.of(measure)->value : -1.0;
  };
  const auto at = [](double begin) { return ticks(begin); };
  std::vector<GlossSpan> signs;
  for (int i = 0; i < 5; ++i)
    signs.push_back({"A", at(.5 * i), at(.5 * i + .3), false, i});
  EXPECT_NEAR(rate(signs, Measure::kSignRate), 2.0, 1e-9);
  EXPECT_EQ(rate({signs.begin(), signs.begin() + 4}, Measure::kSignRate), -1.0);
  // A pause has a unit of its own.
  signs.back().unit = 5;
  EXPECT_EQ(rate(signs, Measure::kSignRate), -1.0);
  const std::vector<GlossSpan> letters = {
      {"KIM", at(0), at(.2), true, 0}, {"KIM", at(.25), at(.4), true, 1}, {"KIM", at(.5), at(.7), true, 2}};
  EXPECT_NEAR(rate(letters, Measure::kLetterRate), 4.0, 1e-9);
  EXPECT_FALSE(checker_.check(score).good(Measure::kLetterRate));
  EXPECT_EQ(rate(letters, Measure::kSignRate), -1.0);
}

TEST_F(Check, AnElbowThatSwingsRoundIsTooFast) {
  HandState swung = shown_;
  swung.swivel += 1.0;
  // A minimum-jerk stroke of a radian in half a second peaks at 1.875 / 0.5 rad/s, which shoulder and wrist share.
  const Verdict slow = checker_.check(score_of_states({shown_, swung}, 0.5));
  EXPECT_TRUE(slow.good(Measure::kJointSpeed));
  EXPECT_GT(slow.of(Measure::kJointSpeed)->value, 0.5 * 1.875 / 0.5 / kDegree);
  const Verdict fast = checker_.check(score_of_states({shown_, swung}, 0.03));
  EXPECT_FALSE(fast.good(Measure::kJointSpeed));
  EXPECT_TRUE(fast.good(Measure::kWristSpeed));
}

TEST_F(Check, ANearHandKeepsItsDistance) {
  const Site chest = chest_skin();
  HandState state = shown_;
  const Vec3 part = shipped().signer->hand(Side::kRight).site(HandPart::kPalm, state.angles).position;
  Score score = score_of_states({state, state}, 0.2);
  const auto miss = [&](double distance) {
    state = at(part, chest.position + chest.normal * distance);
    score.hands[1].front().from = score.hands[1].front().to = state;
    HandTarget target;
    target.begin = target.end = ticks(0.1);
    target.stand_off = 0.015;
    target.part = part;
    target.location = Location::kChest;
    score.targets[1] = {target};
    const Verdict verdict = checker_.check(score);
    EXPECT_FALSE(verdict.of(Measure::kContact));
    return verdict.of(Measure::kStandOff)->value;
  };
  EXPECT_NEAR(miss(0.015), 0.0, 1.5);
  EXPECT_NEAR(miss(0.045), 30.0, 2.0);
}

TEST_F(Check, AContactIsApproachedFromWithout) {
  const Site chest = chest_skin();
  const Vec3 part = shipped().signer->hand(Side::kRight).site(HandPart::kPalm, shown_.angles).position;
  const auto angle = [&](const Vec3& from) {
    const HandState touching = at(part, chest.position);
    HandState before = touching;
    before.wrist.position += from;
    Score score = score_of_states({before, touching}, 0.3);
    HandTarget target;
    target.begin = target.end = ticks(0.3);
    target.touches = true;
    target.part = part;
    target.location = Location::kChest;
    score.targets[1] = {target};
    const Verdict verdict = checker_.check(score);
    return verdict.of(Measure::kApproach) ? verdict.of(Measure::kApproach)->value : -1.0;
  };
  // Where triangles meet, the skin's normal is that of either or the mean of both.
  EXPECT_LT(angle(chest.normal * 0.1), 15.0);
  const Vec3 along = unit(Vec3(0, 1, 0) - chest.normal * chest.normal.y);
  EXPECT_NEAR(angle(chest.normal * 0.05 + along * 0.05), 45.0, 15.0);
  EXPECT_GT(angle(along * 0.1 + chest.normal * 0.045), 60.0);
}

TEST_F(Check, TheLeftHandedSignerIsTheMirrorImage) {
  const Verdict verdict = checker_.check(score_of({"WHERE"}));
  ASSERT_TRUE(verdict.of(Measure::kMirror));
  EXPECT_EQ(verdict.of(Measure::kMirror)->value, 0.0);
}

TEST_F(Check, AJointBeyondItsRangeIsToldWhichWay) {
  HandState state = shown_;
  state.angles.fingers[0].pip = 130.0 * kDegree;
  const Verdict verdict = checker_.check(score_of_states({state, state}, 0.1));
  EXPECT_NEAR(verdict.of(Measure::kJointLimits)->value, 20.0, 0.5);
  EXPECT_EQ(verdict.of(Measure::kJointLimits)->where, "index_pip_r");
  EXPECT_EQ(verdict.of(Measure::kJointLimits)->detail, "flexion of 130 degrees beyond 110 degrees");
}

}  // namespace
}  // namespace auslan
