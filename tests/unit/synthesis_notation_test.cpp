// SPDX-License-Identifier: Apache-2.0
// Movements as notations write them, as the shipped figure performs them: which way an arc bows, how a circle goes.
#include "corpora.h"
#include "kinematics/rotation.h"
#include "notation/notation.h"
#include "shipped.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace auslan {
namespace {

constexpr size_t kLeft = static_cast<size_t>(Side::kLeft), kRight = static_cast<size_t>(Side::kRight);

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

Result<Score> score_of_sign(const NotatedSign& notated) {
  Utterance utterance;
  Unit unit;
  unit.sign = notated.sign;
  unit.label = notated.sign.gloss;
  unit.mouthing = notated.sign.non_manual.mouthing;
  utterance.units.push_back(std::move(unit));
  utterance.sentences = {"test"};
  for (const Handshape& shape : notated.handshapes)
    utterance.handshapes.emplace(shape.id, shape);
  return choreograph(*shipped().signer, utterance);
}

/// A flat hand before the chest that makes this movement.
Score score_of_movement(const std::string& symbols) {
  const auto sign = parse_hamnosys("hamflathand,hamextfingero,hampalmd,hamshoulders," + symbols);
  EXPECT_TRUE(sign && sign->signable) << symbols;
  return score_of_sign(*sign).value();
}

/// The longest segment of a hand that circles, bows or turns.
HandSegment moving(const Score& score, size_t side) {
  for (const HandSegment& segment : score.hands[side])
    if (segment.begin >= score.glosses.front().begin && segment.end <= score.glosses.front().end &&
        (segment.turns > 0 || length(segment.bulge) > 0 || segment.oscillation.cycles > 0))
      return segment;
  ADD_FAILURE() << "nothing moves";
  return {};
}

Vec3 at(const HandSegment& segment, double share) {
  const double length_of = static_cast<double>(segment.end - segment.begin);
  return state_at(segment, segment.begin + static_cast<Tick>(share * length_of)).wrist.position;
}

TEST(SynthesisNotation, ArcsBowWhereTheyAreWritten) {
  // Away from the signer the letters of a bow are literal.
  const std::pair<const char*, Vec3> bows[] = {
      {"hamarcu", {0, 1, 0}}, {"hamarcd", {0, -1, 0}}, {"hamarcl", {1, 0, 0}}, {"hamarcr", {-1, 0, 0}}};
  for (const auto& [symbol, wanted] : bows) {
    const HandSegment arc = moving(score_of_movement("hammoveo," + std::string(symbol)), kRight);
    const Vec3 middle = at(arc, 0.5) - 0.5 * (at(arc, 0) + at(arc, 1));
    EXPECT_GT(length(middle), 0.02) << symbol;
    EXPECT_GT(glm::dot(middle, wanted) / length(middle), 0.99) << symbol;
  }
}

TEST(SynthesisNotation, CirclesGoRoundTheirAxisByTheRightHandsRule) {
  const std::pair<const char*, Vec3> axes[] = {{"o", {0, 0, 1}},
                                               {"i", {0, 0, -1}},
                                               {"u", {0, 1, 0}},
                                               {"d", {0, -1, 0}},
                                               {"l", {1, 0, 0}},
                                               {"r", {-1, 0, 0}},
                                               {"ul", {0.70710678, 0.70710678, 0}}};
  for (const auto& [letters, axis] : axes) {
    const HandSegment circle = moving(score_of_movement("hamcircle" + std::string(letters)), kRight);
    const Vec3 centre = 0.5 * (at(circle, 0) + at(circle, 0.5));
    EXPECT_LT(length(at(circle, 1) - at(circle, 0)), 1e-9) << letters << ": once round";
    const double radius = length(at(circle, 0) - centre);
    EXPECT_GT(radius, 0.03) << letters;
    for (double share = 0; share < 1; share += 0.1) {
      const Vec3 out = at(circle, share) - centre;
      EXPECT_NEAR(glm::dot(out, axis), 0, 1e-6) << letters << ": across the axis";
      EXPECT_NEAR(length(out), radius, 1e-6) << letters;
      if (share > 0.15 && share < 0.85) {
        EXPECT_GT(glm::dot(glm::cross(out, at(circle, share + 0.05) - centre), axis), 0) << letters << ": its sense";
      }
    }
  }
}

TEST(SynthesisNotation, APartOfACircleEndsWhereTheClockSays) {
  const HandSegment quarter = moving(score_of_movement("hamcircleo,hamclocku,hamclockr"), kRight);
  const Vec3 start = at(quarter, 0), end = at(quarter, 1);
  const double radius = std::abs(end.x - start.x);
  EXPECT_NEAR(end.x - start.x, -radius, 1e-9);
  EXPECT_NEAR(end.y - start.y, -radius, 0.2 * radius) << "from the top to the right: as far down as across";
  EXPECT_GT(radius, 0.03);
  // Round the middle of the clock, which lies under its top.
  const Vec3 centre = start - Vec3(0, radius, 0);
  EXPECT_NEAR(length(at(quarter, 0.5) - centre), radius, 0.1 * radius);
}

TEST(SynthesisNotation, EllipsesAndSpiralsHaveTheirShape) {
  const HandSegment wide = moving(score_of_movement("hamcircleo,hamellipseh"), kRight);
  double x = 0, y = 0;
  const Vec3 middle = 0.5 * (at(wide, 0) + at(wide, 0.5));
  for (double share = 0; share < 1; share += 0.01) {
    x = std::max(x, std::abs((at(wide, share) - middle).x));
    y = std::max(y, std::abs((at(wide, share) - middle).y));
  }
  EXPECT_NEAR(y / x, 0.5, 0.01) << "an ellipse without a size is half as high as wide";
  const HandSegment growing = moving(score_of_movement("hamcircleo,hamclockfull,hamincreasing"), kRight);
  const auto across = [&](double share) {
    return length(at(growing, share) - at(growing, std::max(0.0, share - 0.02)));
  };
  EXPECT_GT(across(0.7), 1.3 * across(0.32)) << "a growing circle is wider on its second turn";
}

TEST(SynthesisNotation, TheWristSwingsAndStirs) {
  // Fingers away, palm down: swinging turns the hand about the upright axis, nodding about the level one.
  const Score swing = score_of_movement("hamswinging"), nod = score_of_movement("hamnodding");
  const Vec3 by_swing = moving(swing, kRight).oscillation.turn, by_nod = moving(nod, kRight).oscillation.turn;
  EXPECT_GT(std::abs(by_swing.y), 0.95 * length(by_swing));
  EXPECT_GT(std::abs(by_nod.x), 0.95 * length(by_nod));
  const HandSegment stir = moving(score_of_movement("hamstircw"), kRight);
  EXPECT_NEAR(glm::dot(stir.oscillation.turn, stir.oscillation.turn_ahead), 0, 1e-6) << "two turns across each other";
  EXPECT_GT(length(stir.oscillation.turn), 0.1);
  EXPECT_NEAR(length(stir.oscillation.turn), length(stir.oscillation.turn_ahead), 1e-6);
  const HandSegment back = moving(score_of_movement("hamstirccw"), kRight);
  EXPECT_LT(glm::dot(stir.oscillation.turn, back.oscillation.turn), 0) << "the other way round";
}

TEST(SynthesisNotation, OnlyTheNamedFingersPlay) {
  const HandSegment play = moving(score_of_movement("hamfingerplay,hamindexfinger"), kRight);
  bool index = false;
  for (double share = 0.1; share < 1; share += 0.1) {
    const HandState state =
        state_at(play, play.begin + static_cast<Tick>(share * static_cast<double>(play.end - play.begin)));
    index = index || std::abs(state.angles.fingers[0].mcp - play.from.angles.fingers[0].mcp) > 0.05;
    for (size_t finger = 1; finger < 4; ++finger)
      EXPECT_EQ(state.angles.fingers[finger].mcp, play.from.angles.fingers[finger].mcp);
  }
  EXPECT_TRUE(index);
}

TEST(SynthesisNotation, BothHandsOfUnlikeShapesCircleAsMirrorImages) {
  const auto sign = parse_hamnosys(
      "hamsymmlr,hamparbegin,hamfist,hamplus,hamflathand,hamparend,hamextfingero,hampalmd,hamshoulders,hamcircleo");
  ASSERT_TRUE(sign);
  const Score score = score_of_sign(*sign).value();
  const HandSegment right = moving(score, kRight), left = moving(score, kLeft);
  for (double share = 0.1; share < 1; share += 0.1) {
    const Vec3 r = at(right, share) - at(right, 0), l = at(left, share) - at(left, 0);
    EXPECT_NEAR(r.x, -l.x, 1e-9);
    EXPECT_NEAR(r.y, l.y, 1e-9);
    EXPECT_NEAR(r.z, l.z, 1e-9);
  }
}

TEST(SynthesisNotation, TheFinerPlacesOfTheHeadLieWhereTheyAreNamed) {
  const BodySites& body = shipped().signer->body();
  const auto place = [&body](Location location) { return body.site(location, Side::kRight, Vec3(0.0), true); };
  const auto height = [&place](Location location) { return place(location).position.y; };
  EXPECT_GT(height(Location::kEyebrow), height(Location::kEye));
  EXPECT_LT(height(Location::kEyebrow), height(Location::kForehead));
  EXPECT_LT(height(Location::kNostrils), height(Location::kNose));
  EXPECT_GT(height(Location::kNostrils), height(Location::kUpperLip));
  EXPECT_GT(height(Location::kUpperLip), height(Location::kMouth));
  EXPECT_GT(height(Location::kMouth), height(Location::kLowerLip));
  EXPECT_GT(height(Location::kLowerLip), height(Location::kChin));
  EXPECT_LT(height(Location::kEarlobe), height(Location::kEar));
  EXPECT_NEAR(place(Location::kContraEar).position.x, -place(Location::kEar).position.x, 1e-6);
  const Site under = place(Location::kUnderChin);
  EXPECT_LT(under.position.y, height(Location::kChin));
  EXPECT_GT(under.position.y, height(Location::kNeck));
  EXPECT_LT(under.normal.y, -0.7) << "its skin faces down";
  EXPECT_GT(height(Location::kUpperChest), height(Location::kChest));
  EXPECT_LT(height(Location::kLowerStomach), height(Location::kStomach));
}

TEST(SynthesisNotation, HandsThatTapInTurnAreNotOutAtOnce) {
  auto notated = parse_hamnosys(
      "hamsymmlr,hamparbegin,hamfist,hamplus,hamflathand,hamparend,hamextfingero,hampalmd,"
      "hamshoulders");
  ASSERT_TRUE(notated);
  Movement tap;
  tap.kind = MoveKind::kTap;
  tap.repeats = 2;
  tap.hands = MovingHands::kAlternating;
  notated->sign.movements = {tap};
  const Score score = score_of_sign(*notated).value();
  const auto turns = [&score](size_t side) {
    int count = 0;
    for (const HandSegment& segment : score.hands[side])
      count += segment.begin >= score.glosses.front().begin && segment.end <= score.glosses.front().end &&
               length(segment.to.wrist.position - segment.from.wrist.position) > 0.01;
    return count;
  };
  EXPECT_EQ(turns(kRight), 3) << "in, out, in: the way to the sign ends before the first tap";
  EXPECT_EQ(turns(kLeft), 4);
  for (size_t i = 0; i < score.hands[kRight].size() && i < score.hands[kLeft].size(); ++i) {
    const HandSegment &right = score.hands[kRight][i], &left = score.hands[kLeft][i];
    if (right.begin < score.glosses.front().begin || right.end > score.glosses.front().end) continue;
    const double r = (right.to.wrist.position - right.from.wrist.position).y,
                 l = (left.to.wrist.position - left.from.wrist.position).y;
    EXPECT_LE(r * l, 1e-12) << "segment " << i << ": both the same way";
  }
}

class NotatedCorpus : public ::testing::TestWithParam<const char*> {};

TEST_P(NotatedCorpus, EverySignIsPerformedWithoutAJump) {
  const auto files = testing::sigml_files(GetParam());
  if (files.empty()) GTEST_SKIP() << "the sample " << GetParam() << " is not beside this checkout (../shared/corpora)";
  for (const auto& file : files) {
    const auto signs = read_sigml(file);
    ASSERT_TRUE(signs);
    for (const NotatedSign& sign : *signs) {
      if (!sign.signable) continue;
      const std::string where = file.filename().string() + " " + sign.sign.gloss;
      const auto score = score_of_sign(sign);
      ASSERT_TRUE(score) << where << ": " << to_string(score.error());
      for (const auto& track : score->hands)
        for (size_t i = 1; i < track.size(); ++i) {
          ASSERT_EQ(track[i].begin, track[i - 1].end) << where;
          const HandState before = state_at(track[i - 1], track[i - 1].end), after = state_at(track[i], track[i].begin);
          ASSERT_LT(length(before.wrist.position - after.wrist.position), 1e-6) << where << ", segment " << i;
          ASSERT_LT(angle_between(before.wrist.rotation, after.wrist.rotation), 1e-3) << where << ", segment " << i;
        }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, NotatedCorpus, ::testing::Values("ngt", "isl", "bsl"),
                         [](const auto& sample) { return std::string(sample.param); });

}  // namespace
}  // namespace auslan
