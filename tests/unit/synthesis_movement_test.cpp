// SPDX-License-Identifier: Apache-2.0
// How the shipped signs move in sentences: pace, joint speeds, continuity of all channels, holds, the base hand, idle
// life and lips.
#include "kinematics/elementary.h"
#include "kinematics/interpolate.h"
#include "kinematics/rotation.h"
#include "phonology/vocabulary.h"
#include "shipped.h"
#include "synthesis/choreography.h"
#include "synthesis/joint_speed.h"
#include "synthesis/mouthing.h"
#include "synthesis/performance.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

namespace auslan {
namespace {

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

PerformanceOptions still() {
  PerformanceOptions options;
  options.idle = false;
  return options;
}

/// Ten sentences of the phrase book, with their non-manual features and mouthing.
const std::vector<const char*>& ten_sentences() {
  static const std::vector<const char*> kIds = {"what-is-your-name",
                                                "do-you-need-an-interpreter",
                                                "the-doctor-will-see-you-soon",
                                                "your-appointment-is-tomorrow-at-ten-oclock",
                                                "do-you-have-any-allergies",
                                                "please-wait-i-will-get-someone",
                                                "the-toilet-is-there-on-the-left",
                                                "what-would-you-like-to-eat-or-drink",
                                                "you-have-the-right-to-an-interpreter",
                                                "do-you-have-a-fever-or-a-cough"};
  return kIds;
}

Utterance sentence(const std::string& id) {
  for (const Phrase& phrase : shipped().lexicon->phrases()) {
    if (phrase.id != id) continue;
    Utterance utterance = utterance_of(phrase.glosses);
    utterance.non_manual = phrase.non_manual;
    return utterance;
  }
  ADD_FAILURE() << "the phrase book has no " << id;
  return {};
}

Score performed(const std::string& id, double speed = 1.0) {
  ChoreographyOptions options;
  options.speed = speed;
  return choreograph(*shipped().signer, sentence(id), options).value();
}

TEST(Movement, TenSentencesRunAtOneAndAHalfToThreeSignsASecond) {
  for (const char* id : ten_sentences()) {
    const Score score = performed(id);
    const double rate =
        static_cast<double>(score.glosses.size()) / seconds(score.glosses.back().end - score.glosses.front().begin);
    EXPECT_GE(rate, 1.5) << id;
    EXPECT_LE(rate, 3.0) << id;
  }
}

TEST(Movement, NoJointTurnsFasterThanAPersonsAtAnySpeed) {
  constexpr Tick kStep = kTicksPerSecond / 120;
  const Skeleton& skeleton = shipped().figure.skeleton;
  for (const double speed : {1.0, 1.5}) {
    for (const char* id : ten_sentences()) {
      const Score score = performed(id, speed);
      const Performance performance(*shipped().signer, score);
      Pose before, now;
      performance.sample(0, before);
      for (Tick time = kStep; time <= score.end; time += kStep) {
        performance.sample(time, now);
        for (int i = 0; i < skeleton.size(); ++i) {
          const auto n = static_cast<size_t>(i);
          const std::string& name = skeleton.node(i).name;
          EXPECT_LE(angle_between(before.rotation[n], now.rotation[n]) * 120.0, fastest_turn(name))
              << id << " at speed " << speed << ", " << name << " at " << seconds(time);
        }
        std::swap(before, now);
      }
    }
  }
}

/// Joints, face and body, with idle life: at every key the velocity before and after differ by no more than a percent
/// of the peak within a quarter of a second, beside what the acceleration on either side of the key makes of a tick.
TEST(Movement, EveryChannelIsContinuousInVelocity) {
  constexpr Tick kStep = kTicksPerSecond / 120, kNear = kTicksPerSecond / 4;
  constexpr double kSlowest = 0.3;  // a second: channels whose peak is lower have no jump worth a percentage
  const auto nodes = static_cast<size_t>(shipped().figure.skeleton.size());
  for (const char* id : ten_sentences()) {
    const Score score = performed(id);
    const Performance performance(*shipped().signer, score);
    std::set<Tick> keys;
    for (const auto& track : score.hands) {
      for (const HandSegment& segment : track) {
        keys.insert(segment.begin);
        keys.insert(segment.begin +
                    static_cast<Tick>(segment.digits_lead * static_cast<double>(segment.end - segment.begin)));
      }
    }
    for (const FaceSpan& span : score.face)
      keys.insert({span.begin, span.begin + span.onset, span.end - span.release, span.end});
    for (const BodySpan& span : score.body)
      keys.insert({span.begin, span.begin + span.onset, span.end - span.release, span.end});
    // Of each channel the velocity, per second: joints, then the face.
    const auto velocities = [&](Tick from, Tick to) {
      Pose a, b;
      performance.sample(from, a);
      performance.sample(to, b);
      const double rate = static_cast<double>(kTicksPerSecond) / static_cast<double>(to - from);
      std::vector<Vec3> v;
      for (size_t i = 0; i < nodes; ++i)
        v.push_back(rotation_vector(b.rotation[i] * glm::conjugate(a.rotation[i])) * rate);
      for (size_t i = 0; i < a.face.size(); ++i)
        v.emplace_back((static_cast<double>(b.face[i]) - static_cast<double>(a.face[i])) * rate, 0.0, 0.0);
      return v;
    };
    std::vector<std::vector<double>> speeds;
    for (Tick time = 0; time + kStep <= score.end; time += kStep) {
      std::vector<double>& row = speeds.emplace_back();
      for (const Vec3& v : velocities(time, time + kStep))
        row.push_back(length(v));
    }
    for (const Tick key : keys) {
      if (key < 2 || key + 2 > score.end) continue;
      const std::vector<Vec3> before = velocities(key - 1, key), after = velocities(key, key + 1);
      const std::vector<Vec3> earlier = velocities(key - 2, key - 1), later = velocities(key + 1, key + 2);
      const auto first = static_cast<size_t>(std::max<Tick>(0, key - kNear) / kStep);
      const auto last = std::min(speeds.size(), static_cast<size_t>((key + kNear) / kStep));
      for (size_t i = 0; i < before.size(); ++i) {
        double peak = 0.0;
        for (size_t row = first; row < last; ++row)
          peak = std::max(peak, speeds[row][i]);
        if (peak < kSlowest) continue;
        // A weight of the face is a float: what its last digit makes of a tick is not motion.
        const double rounding = i < nodes ? 0.0 : 2.0 * 6e-8 * static_cast<double>(kTicksPerSecond);
        const double accelerated = std::max(length(before[i] - earlier[i]), length(later[i] - after[i]));
        EXPECT_LE(length(after[i] - before[i]), 0.01 * peak + accelerated + rounding)
            << id << " at " << seconds(key) << ", channel " << i << " of " << nodes << " joints and the face";
      }
    }
  }
}

/// Lacquaniti, Terzuolo & Viviani 1983: on a curve the hand's speed is proportional to curvature^(-1/3), so that their
/// product of speed and curvature^(1/3) follows the progress alone.
TEST(Movement, BentPathsSlowWithTheTwoThirdsPowerOfTheirCurvature) {
  HandSegment segment;
  segment.end = kTicksPerSecond;
  segment.to.wrist.position = Vec3(0.3, 0.1, 0.0);
  segment.bulge = Vec3(0.0, 0.05, 0.12);
  constexpr double kStep = 1.0 / 600.0;
  const auto at = [&](double tau) {
    return state_at(segment, static_cast<Tick>(std::lround(tau * static_cast<double>(kTicksPerSecond)))).wrist.position;
  };
  double expected = 0.0;
  for (const double tau : {0.3, 0.4, 0.45, 0.5, 0.55, 0.6, 0.7}) {
    const Vec3 before = at(tau - kStep), here = at(tau), after = at(tau + kStep);
    const Vec3 velocity = (after - before) / (2.0 * kStep);
    const Vec3 acceleration = (after - here * 2.0 + before) / (kStep * kStep);
    const double speed = length(velocity);
    const double curvature = length(glm::cross(velocity, acceleration)) / (speed * speed * speed);
    const double progress = 30.0 * tau * tau * (1.0 - tau) * (1.0 - tau);
    const double product = speed * std::cbrt(curvature) / progress;
    if (expected == 0.0) expected = product;
    EXPECT_NEAR(product / expected, 1.0, 0.01) << tau;
  }
}

TEST(Movement, RoundsOfACircleAreAlikeAndBeginAndEndAtRest) {
  HandSegment segment;
  segment.end = kTicksPerSecond;
  segment.circle_u = Vec3(0.0, 0.04, 0.0);
  segment.circle_v = Vec3(0.04, 0.0, 0.0);
  segment.turns = 3;
  const auto speed = [&](Tick time) {
    return length(state_at(segment, time + 1).wrist.position - state_at(segment, time).wrist.position);
  };
  const double middle = speed(kTicksPerSecond / 2);
  for (Tick time = kTicksPerSecond / 8; time < kTicksPerSecond * 7 / 8; time += 100)
    EXPECT_NEAR(speed(time) / middle, 1.0, 1e-3) << time;
  EXPECT_LT(speed(0), 1e-3 * middle);
  EXPECT_LT(speed(kTicksPerSecond - 1), 1e-3 * middle);
  EXPECT_LT(length(state_at(segment, kTicksPerSecond).wrist.position), 1e-9);
}

Utterance spelled(const std::vector<std::string>& letters) {
  Translation translation;
  translation.english = "word";
  Item word;
  word.kind = ItemKind::kSpelled;
  word.glosses = letters;
  word.text = "word";
  word.end = 4;
  translation.items = {word};
  Shipped& s = shipped();
  return compose(
             translation, [&s](std::string_view gloss) { return s.lexicon->sign(gloss); },
             [&s](std::string_view id) { return s.lexicon->handshape(id); })
      .value();
}

TEST(Movement, SignsAreHeldForEightyAndLettersForAHundredAndTwentyMillisecondsAtAnySpeed) {
  for (const double speed : {0.5, 1.0, 1.5}) {
    ChoreographyOptions options;
    options.speed = speed;
    const Score letters = choreograph(*shipped().signer, spelled({"fs:W", "fs:O", "fs:R", "fs:D"}), options).value();
    const Score signs = choreograph(*shipped().signer, utterance_of({"DOCTOR", "YOU", "HELP"}), options).value();
    for (const auto& [score, least] : {std::pair{&letters, 0.120}, std::pair{&signs, 0.080}}) {
      for (const GlossSpan& gloss : score->glosses) {
        Tick longest = 0;
        for (const HandTarget& target : score->targets[static_cast<size_t>(Side::kRight)])
          if (target.begin >= gloss.begin && target.end <= gloss.end)
            longest = std::max(longest, target.end - target.begin);
        EXPECT_GE(seconds(longest), least - 1e-9) << gloss.label << " at speed " << speed;
      }
    }
  }
}

TEST(Movement, TheLastSignOfAPhraseIsATwelfthLongerInItsHold) {
  const Score score = score_of({"DOCTOR", "NAME", "NAME"});
  const GlossSpan &inside = score.glosses[1], &last = score.glosses[2];
  EXPECT_NEAR(seconds(last.end - last.begin) / seconds(inside.end - inside.begin), 1.12, 0.002);
  // Before a comma too.
  Utterance with_comma = utterance_of({"NAME", "NAME"});
  Unit comma;
  comma.pause_seconds = 0.25;
  with_comma.units.insert(with_comma.units.begin() + 1, comma);
  const Score pause = choreograph(*shipped().signer, with_comma).value();
  EXPECT_NEAR(seconds(pause.glosses[0].end - pause.glosses[0].begin) / seconds(inside.end - inside.begin), 1.12, 0.002);
}

TEST(Movement, TheBaseHandSetsOutBeforeTheSignThatNeedsItDoes) {
  const Score score = score_of({"YOU", "DOCTOR"});
  const auto& left = score.hands[static_cast<size_t>(Side::kLeft)];
  const auto moves = std::find_if(left.begin(), left.end(), [](const HandSegment& segment) {
    return length(segment.to.wrist.position - segment.from.wrist.position) > 0.1;
  });
  ASSERT_NE(moves, left.end());
  EXPECT_LT(moves->begin, score.glosses[0].end);
  EXPECT_EQ(moves->end, score.glosses[1].begin);
}

/// Of signs that touch the body at their start and come from far off: in the last quarter of the time, when a straight
/// way would slide along the skin, the hand comes within 60 degrees of the normal.
TEST(Movement, HandsComeToWhatTheyTouchAlongItsNormal) {
  int met = 0;
  for (const char* gloss : {"MOTHER", "THINK", "DOCTOR", "MY", "I", "SHOULDER", "HOSPITAL"}) {
    const Score score = score_of({"WHERE", gloss});
    const auto& track = score.hands[static_cast<size_t>(Side::kRight)];
    const auto way = std::find_if(track.begin(), track.end(),
                                  [&](const HandSegment& segment) { return segment.end == score.glosses[1].begin; });
    ASSERT_NE(way, track.end()) << gloss;
    if (way->approach == Vec3(0.0)) continue;
    ++met;
    const Vec3 normal = unit(way->approach);
    // The last 15 mm.
    Tick near = way->end;
    const auto to_go = [&](Tick time) { return way->to.wrist.position - state_at(*way, time).wrist.position; };
    while (near > way->begin && length(to_go(near)) < 0.015)
      near -= ticks(0.002);
    const Vec3 last = to_go(near);
    EXPECT_GT(-glm::dot(last, normal), 0.5 * length(last)) << gloss;
  }
  EXPECT_GT(met, 2);
}

TEST(Movement, WhatIsMadeTwiceIsSeenTwice) {
  // Otherwise "Kelly" is "Kely" and 000 one long zero.
  for (const char* gloss : {"num:0", "num:7", "fs:L", "fs:S"}) {
    const Score score = score_of({gloss, gloss});
    const auto& track = score.hands[static_cast<size_t>(Side::kRight)];
    const auto way = std::find_if(track.begin(), track.end(),
                                  [&](const HandSegment& segment) { return segment.end == score.glosses[1].begin; });
    ASSERT_NE(way, track.end()) << gloss;
    double farthest = 0.0;
    for (int i = 0; i <= 20; ++i)
      farthest =
          std::max(farthest, length(state_at(*way, way->begin + (way->end - way->begin) * i / 20).wrist.position -
                                    way->from.wrist.position));
    EXPECT_GT(farthest, 0.025) << gloss;
    EXPECT_EQ(way->to.wrist, way->from.wrist) << gloss;
  }
}

TEST(Movement, AHandOnTheFaceGoesWithItsPlaceAndStaysTurned) {
  Utterance utterance = utterance_of({"THINK", "YOUNG", "DOCTOR", "MOTHER"});
  const size_t signs = utterance.units.size();
  NonManualSpan span;
  span.kind = "yn";
  span.to = static_cast<int>(signs) - 1;
  span.head = "tilt-forward";
  utterance.non_manual = {span};
  const Score score = choreograph(*shipped().signer, utterance).value();
  const Skeleton& skeleton = shipped().figure.skeleton;
  const auto place = [&](const std::vector<Transform>& world, const char* node) {
    return world[static_cast<size_t>(skeleton.find(node))];
  };
  std::vector<Transform> rest(static_cast<size_t>(skeleton.size())), world(rest.size());
  forward(skeleton, rest_pose(skeleton), rest);
  double most_tilted = 0.0;
  int touching = 0;
  for (const HandTarget& target : score.targets[static_cast<size_t>(Side::kRight)]) {
    if (!target.touches || !is_on_head(target.location)) continue;
    ++touching;
    Pose pose;
    Performance(*shipped().signer, score, still()).sample(target.end, pose);
    forward(skeleton, pose, world);
    const Transform head = place(world, "head_base"), was = place(rest, "head_base");
    most_tilted = std::max(most_tilted, angle_between(head.rotation, kIdentity) / kDegree);
    const Transform wrist = place(world, "wrist_r");
    const Quat seen = glm::conjugate(place(world, "spine_base").rotation) * wrist.rotation;
    EXPECT_LT(angle_between(seen, target.reached) / kDegree, 0.5);
    // Where the part is on the head, and where it was put on the head at rest.
    const auto& track = score.hands[static_cast<size_t>(Side::kRight)];
    const auto segment =
        std::find_if(track.begin(), track.end(), [&](const HandSegment& s) { return s.end >= target.end; });
    ASSERT_NE(segment, track.end());
    const Vec3 put = apply(state_at(*segment, target.end).wrist, target.part) - was.position;
    const Vec3 on_head = glm::conjugate(head.rotation) * (apply(wrist, target.part) - head.position);
    EXPECT_LT(length(on_head - put), 0.001);
  }
  EXPECT_GE(touching, 2);
  EXPECT_GT(most_tilted, 3.0);
}

TEST(Movement, IdleLifeIsTheSeedsAndCanBeTurnedOff) {
  const Score score = score_of({"HELLO"});
  const auto trunk = [&](const PerformanceOptions& options, Tick time) {
    Pose pose;
    Performance(*shipped().signer, score, options).sample(time, pose);
    return pose.rotation[static_cast<size_t>(shipped().figure.skeleton.find("spine_base"))];
  };
  PerformanceOptions one, other;
  other.seed = 2;
  double widest = 0.0, apart = 0.0;
  for (Tick time = 0; time <= score.end; time += ticks(0.1)) {
    EXPECT_EQ(trunk(one, time), trunk(one, time));
    EXPECT_EQ(trunk(still(), time), kIdentity);
    widest = std::max(widest, angle_between(trunk(one, time), kIdentity));
    apart = std::max(apart, angle_between(trunk(one, time), trunk(other, time)));
  }
  EXPECT_GT(widest / kDegree, 0.1);
  EXPECT_LT(widest / kDegree, 1.0);
  EXPECT_GT(apart / kDegree, 0.01);
}

TEST(Movement, LipsTakeAsLongAsTheirSignAndAreNeverBetweenShapesAtOnce) {
  const Score score = score_of({"HOSPITAL"});
  std::vector<FaceSpan> lips;
  std::copy_if(score.face.begin(), score.face.end(), std::back_inserter(lips),
               [](const FaceSpan& span) { return span.mouthing; });
  ASSERT_GT(lips.size(), 3U);
  EXPECT_LE(lips.front().begin, score.glosses[0].begin);
  EXPECT_GE(lips.back().end, score.glosses[0].end);
  for (size_t i = 1; i < lips.size(); ++i) {
    // One shape falls while the next one rises: their strengths add up to one.
    EXPECT_EQ(lips[i].begin, lips[i - 1].end - lips[i - 1].release);
    EXPECT_EQ(lips[i].begin + lips[i].onset, lips[i - 1].end);
  }
}

TEST(Movement, TheLipsClosePursedBeforeARoundVowelAndSpreadBeforeAWideOne) {
  // "tool" and "tea": the t is made behind the lips, which already have the vowel's shape.
  const auto pucker = static_cast<size_t>(FaceChannel::kMouthPucker);
  const auto stretch = static_cast<size_t>(FaceChannel::kMouthStretchLeft);
  const auto round = coarticulated(std::vector<Viseme>{Viseme::kDd, Viseme::kOu});
  const auto wide = coarticulated(std::vector<Viseme>{Viseme::kDd, Viseme::kIh});
  EXPECT_GT(round[0][pucker], 0.2F);
  EXPECT_EQ(wide[0][pucker], 0.0F);
  EXPECT_GT(wide[0][stretch], weights_of(Viseme::kDd)[stretch]);
  // What the lips are closed for is not given up.
  EXPECT_EQ(coarticulated(std::vector<Viseme>{Viseme::kPp, Viseme::kOu})[0], weights_of(Viseme::kPp));
}

TEST(Movement, QuickMouthingKeepsWhatTheLipsShowMost) {
  // "map": m a p; with room for two shapes or one the closed lips stay.
  const std::vector<Viseme> word = {Viseme::kPp, Viseme::kAa, Viseme::kNn, Viseme::kPp};
  EXPECT_EQ(reduced(word, 4), word);
  EXPECT_EQ(reduced(word, 3), (std::vector<Viseme>{Viseme::kPp, Viseme::kAa, Viseme::kPp}));
  EXPECT_EQ(reduced(word, 0), (std::vector<Viseme>{Viseme::kPp}));
}

}  // namespace
}  // namespace auslan
