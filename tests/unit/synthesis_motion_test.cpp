// SPDX-License-Identifier: Apache-2.0
// The motion of the shipped signs on the shipped figure, against the project's quality limits.
#include "kinematics/elementary.h"
#include "kinematics/limits.h"
#include "kinematics/rotation.h"
#include "kinematics/solid.h"
#include "phonology/vocabulary.h"
#include "shipped.h"
#include "synthesis/choreography.h"
#include "synthesis/performance.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace auslan {
namespace {

constexpr int kRate = 120;  // the rate at which the limits are measured

PerformanceOptions still() {
  PerformanceOptions options;
  options.idle = false;
  return options;
}

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

std::vector<std::string> all_glosses() {
  std::vector<std::string> glosses;
  const std::vector<SignSummary> entries = shipped().lexicon->list().value();
  for (const SignSummary& entry : entries)
    glosses.push_back(entry.gloss);
  return glosses;
}

TEST(Motion, EveryShippedEntryCanBePerformed) {
  for (const std::string& gloss : all_glosses()) {
    const auto score = choreograph(*shipped().signer, utterance_of({gloss}));
    ASSERT_TRUE(score) << gloss << ": " << to_string(score.error());
    for (const auto& track : score->hands) {
      ASSERT_FALSE(track.empty()) << gloss;
      EXPECT_EQ(track.front().begin, 0) << gloss;
      EXPECT_EQ(track.back().end, score->end) << gloss;
      for (size_t i = 1; i < track.size(); ++i)
        ASSERT_EQ(track[i].begin, track[i - 1].end) << gloss;
    }
  }
}

TEST(Motion, HandsMoveWithoutJumpsAndNeverFasterThanFourMetresASecond) {
  Shipped& s = shipped();
  std::vector<Transform> world(static_cast<size_t>(s.figure.skeleton.size()));
  const std::array<int, 2> wrists = {s.figure.skeleton.find("wrist_l"), s.figure.skeleton.find("wrist_r")};
  for (const std::string& gloss : all_glosses()) {
    const Performance performance(*s.signer, score_of({gloss}), still());
    Pose pose;
    std::array<Vec3, 2> before{};
    double fastest = 0;
    for (Tick t = 0; t <= performance.end(); t += kTicksPerSecond / kRate) {
      performance.sample(t, pose);
      forward(s.figure.skeleton, pose, world);
      for (size_t side = 0; side < 2; ++side) {
        const Vec3 now = world[static_cast<size_t>(wrists[side])].position;
        ASSERT_TRUE(std::isfinite(now.x + now.y + now.z)) << gloss;
        if (t > 0) fastest = std::max(fastest, length(now - before[side]) * kRate);
        before[side] = now;
      }
      for (const Quat& q : pose.rotation)
        ASSERT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1.0, 1e-9) << gloss;
    }
    // ARM asks for more than an arm can do (the list of exceptions of `check` says what).
    EXPECT_LE(fastest, gloss == "ARM" ? 5.5 : 4.0) << gloss;
  }
}

TEST(Motion, TargetsAreHeldLongEnoughToBeRead) {
  for (const std::string& gloss : all_glosses()) {
    const Score score = score_of({gloss});
    const auto& track = score.hands[static_cast<size_t>(Side::kRight)];
    Tick longest = 0;
    for (const HandSegment& segment : track) {
      const bool still_hand = length(segment.from.wrist.position - segment.to.wrist.position) < 1e-9 &&
                              segment.oscillation.cycles <= 0 && segment.turns <= 0;
      if (still_hand && segment.begin >= score.glosses.front().begin && segment.end <= score.glosses.front().end)
        longest = std::max(longest, segment.end - segment.begin);
    }
    EXPECT_GE(seconds(longest), 0.080) << gloss;
  }
}

TEST(Motion, PointToPointStrokesPeakAtMinimumJerkSpeed) {
  // Flash & Hogan: peak over mean speed of a minimum-jerk movement is 1.875.
  const Score score = score_of({"HELLO"});
  int strokes = 0;
  for (const HandSegment& segment : score.hands[static_cast<size_t>(Side::kRight)]) {
    const double distance = length(segment.to.wrist.position - segment.from.wrist.position);
    if (distance < 0.05 || length(segment.bulge) > 0.001) continue;
    ++strokes;
    double peak = 0;
    const int steps = 400;
    Vec3 before = segment.from.wrist.position;
    for (int i = 1; i <= steps; ++i) {
      const Vec3 now = state_at(segment, segment.begin + (segment.end - segment.begin) * i / steps).wrist.position;
      peak = std::max(peak, length(now - before) * steps);
      before = now;
    }
    EXPECT_GT(peak / distance, 1.7);
    EXPECT_LT(peak / distance, 2.1);
  }
  // Arcs and raised transitions bow; the plain stroke of a sign that moves straight must be among those measured.
  const Score straight = score_of({"YOU"});
  for (const HandSegment& segment : straight.hands[static_cast<size_t>(Side::kRight)])
    if (length(segment.to.wrist.position - segment.from.wrist.position) > 0.02 && length(segment.bulge) < 0.001)
      ++strokes;
  EXPECT_GT(strokes, 0);
}

/// The greatest difference between two performances from the first posture of a gloss to the last one, radians over the
/// joints of the arms that the sign uses. How long the last posture is held may differ: the end of a phrase is longer.
double difference(const Score& a, size_t gloss_a, const Score& b, size_t gloss_b, bool with_left) {
  const Skeleton& skeleton = shipped().figure.skeleton;
  const Performance one(*shipped().signer, a, still()), two(*shipped().signer, b, still());
  const GlossSpan &in_a = a.glosses[gloss_a], &in_b = b.glosses[gloss_b];
  const Tick last = std::min(in_a.end - in_a.begin, in_b.end - in_b.begin);
  Pose p, q;
  double worst = 0.0;
  for (Tick time = 0; time <= last; time += kTicksPerSecond / 60) {
    one.sample(in_a.begin + time, p);
    two.sample(in_b.begin + time, q);
    for (int i = 0; i < skeleton.size(); ++i) {
      const std::string& name = skeleton.node(i).name;
      if (!name.ends_with("_r") && !(with_left && name.ends_with("_l"))) continue;
      const auto n = static_cast<size_t>(i);
      worst = std::max(worst, angle_between(p.rotation[n], q.rotation[n]));
    }
  }
  return worst;
}

TEST(Motion, ASignIsTheSameAloneFirstLastAndAfterAnyOther) {
  // Others that leave the hands in very different places: one-handed, symmetric, with a base, at the head, touching the
  // other arm.
  const std::vector<std::string> others = {"WHERE", "DOCTOR", "THINK"};
  const std::vector<std::string> all = all_glosses();
  for (size_t i = 0; i < all.size(); i += 3) {
    const std::string& gloss = all[i];
    const std::string& other = others[i / 3 % others.size()];
    const Sign sign = shipped().lexicon->sign(gloss).value().value();
    const bool both = sign.handedness != Handedness::kOne &&
                      (sign.handedness != Handedness::kDominantBase || !sign.non_dominant.empty());
    const Score alone = score_of({gloss});
    for (const auto& [sentence, which] : {std::pair{std::vector<std::string>{gloss, other}, size_t{0}},
                                          std::pair{std::vector<std::string>{other, gloss}, size_t{1}},
                                          std::pair{std::vector<std::string>{other, gloss, other}, size_t{1}}}) {
      const Score score = score_of(sentence);
      EXPECT_LT(difference(alone, 0, score, which, both), 1e-9) << gloss << " with " << other;
      // No more than the lengthening of a phrase's last sign lies between their lengths.
      const double longer = seconds(alone.glosses[0].end - alone.glosses[0].begin) /
                            seconds(score.glosses[which].end - score.glosses[which].begin);
      EXPECT_GT(longer, 0.999) << gloss;
      EXPECT_LT(longer, 1.121) << gloss;
    }
  }
}

TEST(Motion, NothingReturnsToRestInsideASentence) {
  Shipped& s = shipped();
  const Score score = score_of({"HELLO", "MY", "NAME", "fs:K", "fs:I", "fs:M"});
  const double rest = s.signer->rest(Side::kRight).wrist.position.y;
  for (const HandSegment& segment : score.hands[static_cast<size_t>(Side::kRight)]) {
    if (segment.begin < score.glosses.front().begin || segment.end > score.glosses.back().end) continue;
    EXPECT_GT(segment.to.wrist.position.y, rest + 0.15);
  }
}

TEST(Motion, TheBaseHandIsLoweredAfterASentenceThatTheNextSignDoesNotNeedItFor) {
  Utterance utterance = utterance_of({"DOCTOR", "HURT", "DOCTOR"});
  Unit pause;
  pause.pause_seconds = 0.5;
  utterance.units.insert(utterance.units.begin() + 1, pause);
  const Score score = choreograph(*shipped().signer, utterance).value();
  const double low = shipped().signer->rest(Side::kLeft).wrist.position.y;
  // Later in the sign it sets out for the next one.
  const Tick during = score.glosses[1].begin;
  for (const HandSegment& segment : score.hands[static_cast<size_t>(Side::kLeft)]) {
    if (segment.begin > during || segment.end <= during) continue;
    EXPECT_NEAR(state_at(segment, during).wrist.position.y, low, 0.01);
  }
}

TEST(Motion, SpelledLettersKeepThePaceAndTheirHold) {
  Translation t;
  t.english = "kim";
  Item word;
  word.kind = ItemKind::kSpelled;
  word.glosses = {"fs:K", "fs:I", "fs:M"};
  word.text = "kim";
  word.end = 3;
  t.items = {word};
  Shipped& s = shipped();
  const auto utterance = compose(
      t, [&s](std::string_view gloss) { return s.lexicon->sign(gloss); },
      [&s](std::string_view id) { return s.lexicon->handshape(id); });
  ASSERT_TRUE(utterance);
  const Score score = choreograph(*s.signer, *utterance).value();
  ASSERT_EQ(score.glosses.size(), 3U);
  for (size_t i = 0; i < 3; ++i)
    EXPECT_GE(seconds(score.glosses[i].end - score.glosses[i].begin), 0.120);
  // Three letters a second by default.
  const double pace = seconds(score.glosses[2].begin - score.glosses[0].begin) / 2;
  EXPECT_GT(pace, 0.25);
  EXPECT_LT(pace, 0.40);
}

TEST(Motion, TheLeftHandedSignerIsTheExactMirrorImage) {
  Shipped& s = shipped();
  PerformanceOptions left = still();
  left.left_handed = true;
  const Score score = score_of({"HELLO", "DOCTOR", "HURT"});
  const Performance right_handed(*s.signer, score, still()), left_handed(*s.signer, score, left);
  const Skeleton& skeleton = s.figure.skeleton;
  std::vector<Transform> a(static_cast<size_t>(skeleton.size())), b(a.size());
  Pose pose;
  for (Tick t = 0; t <= score.end; t += ticks(0.1)) {
    right_handed.sample(t, pose);
    forward(skeleton, pose, a);
    left_handed.sample(t, pose);
    forward(skeleton, pose, b);
    for (int i = 0; i < skeleton.size(); ++i) {
      std::string name = skeleton.node(i).name;
      if (name.ends_with("_l")) {
        name.back() = 'r';
      } else if (name.ends_with("_r")) {
        name.back() = 'l';
      }
      const Vec3 image = b[static_cast<size_t>(skeleton.find(name))].position;
      const Vec3 original = a[static_cast<size_t>(i)].position;
      EXPECT_NEAR(original.x, -image.x, 1e-12) << skeleton.node(i).name;
      EXPECT_NEAR(original.y, image.y, 1e-12) << skeleton.node(i).name;
      EXPECT_NEAR(original.z, image.z, 1e-12) << skeleton.node(i).name;
    }
  }
}

TEST(Motion, OnItsWayFromRestAndBackNoHandGoesThroughTheTrunk) {
  Shipped& s = shipped();
  const Skeleton& skeleton = s.figure.skeleton;
  const int node = skeleton.find("spine_base");
  const Solid trunk(s.figure.segments[static_cast<size_t>(node)]);
  const HandSites& hand = s.signer->hand(Side::kRight);
  // Metres below the shirt of what leads a hand.
  const auto depth = [&](const HandState& state) {
    double deepest = 0.0;
    for (const HandPart part : {HandPart::kPalm, HandPart::kIndexTip, HandPart::kMiddleTip, HandPart::kLittleTip}) {
      const Vec3 place = apply(state.wrist, hand.site(part, state.angles).position);
      if (const auto nearest = trunk.nearest(place - skeleton.rest_position(node), 0.3))
        deepest = std::max(deepest, -nearest->distance);
    }
    return deepest;
  };
  // Not NECK: its own posture still presses the hand into the shoulder, and the way to it too.
  for (const char* gloss : {"SHOULDER", "CHEST", "STOMACH", "HOSPITAL", "ARM", "BACK-BODY", "WHERE"}) {
    const Score score = score_of({gloss});
    const auto& track = score.hands[static_cast<size_t>(Side::kRight)];
    for (const HandSegment& segment : track) {
      const Vec3 way = segment.to.wrist.position - segment.from.wrist.position;
      if (glm::dot(way, way) < 0.04) continue;
      const double ends = std::max(depth(segment.from), depth(segment.to));
      for (int i = 1; i < 24; ++i) {
        const Tick time = segment.begin + (segment.end - segment.begin) * i / 24;
        EXPECT_LE(depth(state_at(segment, time)), ends + 0.004) << gloss << " at " << seconds(time);
      }
    }
  }
}

TEST(Motion, EveryChannelOfTheFaceChangesSidesWithTheHands) {
  Shipped& s = shipped();
  Score score;
  score.end = ticks(1.0);
  FaceSpan span{.begin = 0, .end = score.end};
  for (size_t i = 0; i < span.weights.size(); ++i)
    span.weights[i] = static_cast<float>(i + 1) / 64.0F;
  score.face = {span};
  PerformanceOptions left = still();
  left.left_handed = true;
  Pose a, b;
  Performance(*s.signer, score, still()).sample(ticks(0.5), a);
  Performance(*s.signer, score, left).sample(ticks(0.5), b);
  for (size_t i = 0; i < a.face.size(); ++i) {
    std::string image(kFaceChannelNames[i]);
    if (image.ends_with("Left")) {
      image.replace(image.size() - 4, 4, "Right");
    } else if (image.ends_with("Right")) {
      image.replace(image.size() - 5, 5, "Left");
    }
    const auto at = std::find(kFaceChannelNames.begin(), kFaceChannelNames.end(), image);
    ASSERT_NE(at, kFaceChannelNames.end()) << image;
    EXPECT_EQ(a.face[i], b.face[static_cast<size_t>(at - kFaceChannelNames.begin())]) << image;
  }
}

TEST(Motion, QuestionsShowOnTheBrowsWhileTheirSpanLasts) {
  Shipped& s = shipped();
  Utterance utterance = utterance_of({"HURT", "WHERE"});
  NonManualSpan wh;
  wh.kind = "wh";
  wh.from = wh.to = 1;
  wh.brows = "furrow";
  utterance.non_manual = {wh};
  const Score score = choreograph(*s.signer, utterance).value();
  const Performance performance(*s.signer, score, still());
  const auto brow = [&performance](Tick t) {
    Pose pose;
    performance.sample(t, pose);
    return pose.face[static_cast<size_t>(FaceChannel::kBrowDownLeft)];
  };
  const GlossSpan& where = score.glosses[1];
  EXPECT_GT(brow((where.begin + where.end) / 2), 0.9F);
  EXPECT_LT(brow(0), 0.01F);
  EXPECT_LT(brow(score.end), 0.01F);
}

TEST(Motion, SpeedScalesTheSigning) {
  const Utterance utterance = utterance_of({"HELLO", "MY", "NAME"});
  ChoreographyOptions slow;
  slow.speed = 0.5;
  const Score normal = choreograph(*shipped().signer, utterance).value();
  const Score half = choreograph(*shipped().signer, utterance, slow).value();
  // What takes a body its time at speed 1 already takes no twice as long at half of it.
  EXPECT_GT(static_cast<double>(half.end) / static_cast<double>(normal.end), 1.9);
  EXPECT_LE(static_cast<double>(half.end) / static_cast<double>(normal.end), 2.001);
  slow.speed = 0;
  EXPECT_FALSE(choreograph(*shipped().signer, utterance, slow));
}

/// Half of all postures break the limits of a straight solution; the hand leans until nearly none does.
TEST(Motion, LettersAreHeldWithinTheLimitsOfTheJoints) {
  Shipped& s = shipped();
  const Skeleton& skeleton = s.figure.skeleton;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const std::string gloss = std::string("fs:") + letter;
    const Score score = score_of({gloss});
    Pose pose;
    Performance(*s.signer, score, still()).sample(score.glosses.front().end - ticks(0.05), pose);
    for (const char* name : {"shoulder_l", "elbow_l", "wrist_l", "shoulder_r", "elbow_r", "wrist_r"}) {
      const int node = skeleton.find(name);
      EXPECT_LT(limit_violation(skeleton, node, pose.rotation[static_cast<size_t>(node)]) / kDegree, 6.0)
          << gloss << " " << name;
    }
  }
}

TEST(Motion, EveryArmKeepsTheLimitsOfItsJointsAtAllTimes) {
  Shipped& s = shipped();
  const Skeleton& skeleton = s.figure.skeleton;
  for (const std::string& gloss : all_glosses()) {
    const Performance performance(*s.signer, score_of({gloss}), still());
    Pose pose;
    double worst = 0.0;
    for (Tick t = 0; t <= performance.end(); t += kTicksPerSecond / 30) {
      performance.sample(t, pose);
      for (const char* name : {"shoulder_l", "elbow_l", "wrist_l", "shoulder_r", "elbow_r", "wrist_r"}) {
        const int node = skeleton.find(name);
        worst = std::max(worst, limit_violation(skeleton, node, pose.rotation[static_cast<size_t>(node)]));
      }
    }
    EXPECT_LT(worst / kDegree, 0.01) << gloss;
  }
}

}  // namespace
}  // namespace auslan
