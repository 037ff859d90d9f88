// SPDX-License-Identifier: Apache-2.0
// Whether core handshapes, or letters, could be taken for one another: how far apart their joint angles are, and how
// far what a viewer sees.
#include "kinematics/arm_ik.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
#include "shipped.h"
#include "stage/stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace auslan {
namespace {

constexpr int kWidth = 640, kHeight = 480;
constexpr double kNoise = 5.0;   // degrees, of every angle
constexpr double kApart = 0.05;  // of what either covers: a folded or an unfolded finger is 6 to 10 hundredths
constexpr int kWorst = 8;        // pairs printed

using Silhouette = std::vector<bool>;

/// One of the things that must not be confused.
struct Form {
  std::string name;
  std::vector<double> angles;        ///< degrees
  std::vector<Silhouette> pictures;  ///< of the same views or moments in all
};

struct Pair {
  std::string names;
  double value = 0.0;
};

/// The figure with nothing but its hands, before a background of no other use.
class HandStage {
 public:
  HandStage() : figure_(shipped().figure), pixels_(size_t{kWidth} * kHeight) {
    std::vector<bool> keep(figure_.segments.size(), false);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const ArmNodes nodes = arm_nodes(figure_.skeleton, side);
      keep[static_cast<size_t>(nodes.wrist)] = true;
      for (const auto& digit : nodes.digits)
        for (const int node : digit)
          keep[static_cast<size_t>(node)] = true;
    }
    for (size_t node = 0; node < keep.size(); ++node)
      if (!keep[node]) figure_.segments[node] = Mesh{};
    StageOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.samples = 1;
    options.rigid = true;
    options.shadow = false;
    options.camera = CameraName::kHands;
    options.background = kBackground;
    stage_.emplace(Stage::build(figure_, options).value());
  }

  Silhouette of(const Pose& pose) {
    stage_->render(pose, pixels_);
    Silhouette covered(pixels_.size());
    for (size_t i = 0; i < pixels_.size(); ++i)
      covered[i] = (pixels_[i] & 0xFFFFFFU) != kBackground;
    return covered;
  }

 private:
  static constexpr uint32_t kBackground = 0x00FF00;
  Figure figure_;
  std::vector<uint32_t> pixels_;
  std::optional<Stage> stage_;
};

/// Of all that either covers, the share that one of them covers alone.
double apart(const Silhouette& a, const Silhouette& b) {
  int either = 0, one = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    either += a[i] || b[i] ? 1 : 0;
    one += a[i] != b[i] ? 1 : 0;
  }
  return either == 0 ? 0.0 : static_cast<double>(one) / either;
}

/// In the view, or at the moment, that tells them apart best.
double seen_apart(const Form& a, const Form& b) {
  double most = 0.0;
  for (size_t i = 0; i < a.pictures.size(); ++i)
    most = std::max(most, apart(a.pictures[i], b.pictures[i]));
  return most;
}

/// By how many degrees all angles of `a` may be wrong, each in the worst way, before it is as near to `b`: noise n
/// confuses them where n . d >= d . d / 2, d the way from a to b, and n . d is at most the noise times the sum of |d|.
double noise_borne(const Form& a, const Form& b) {
  double squares = 0.0, sum = 0.0;
  for (size_t i = 0; i < a.angles.size(); ++i) {
    const double d = b.angles[i] - a.angles[i];
    squares += d * d;
    sum += std::abs(d);
  }
  return sum == 0.0 ? 0.0 : squares / (2.0 * sum);
}

/// All pairs, the least first; prints the first few.
std::vector<Pair> ranked(const std::vector<Form>& forms, double (*value)(const Form&, const Form&), const char* title) {
  std::vector<Pair> pairs;
  for (size_t i = 0; i < forms.size(); ++i)
    for (size_t j = i + 1; j < forms.size(); ++j)
      pairs.push_back({forms[i].name + " " + forms[j].name, value(forms[i], forms[j])});
  std::ranges::stable_sort(pairs, {}, &Pair::value);
  std::printf("%s, of %zu pairs the nearest:\n", title, pairs.size());
  for (size_t i = 0; i < pairs.size() && i < kWorst; ++i)
    std::printf("  %-28s %.2f\n", pairs[i].names.c_str(), pairs[i].value);
  return pairs;
}

std::vector<double> degrees_of(const HandAngles& hand) {
  std::vector<double> all;
  for (const DigitAngles& finger : hand.fingers)
    for (const double angle : {finger.mcp, finger.pip, finger.dip, finger.abduction})
      all.push_back(angle / kDegree);
  const ThumbPose& thumb = hand.thumb;
  for (const double angle :
       {thumb.radial_abduction, thumb.palmar_abduction, thumb.opposition * (kPi / 2.0), thumb.mp, thumb.ip})
    all.push_back(angle / kDegree);
  return all;
}

/// The right hand before the shoulder, fingers up, the palm facing as said.
Pose showing(const Handshape& handshape, const Direction& palm) {
  const Signer& signer = *shipped().signer;
  const Skeleton& skeleton = shipped().figure.skeleton;
  Posture posture;
  posture.fingers = {0, 1, 0};
  posture.palm = palm;
  posture.offset = Vec3(0.0, 0.0, 0.25);
  const HandState state = signer.place(posture, handshape, Side::kRight, {}).state;
  Pose pose = rest_pose(skeleton);
  const ArmNodes nodes = arm_nodes(skeleton, Side::kRight);
  const Transform trunk{kIdentity, skeleton.rest_position(nodes.trunk)};
  pose_arm(nodes, solve_arm(skeleton, Side::kRight, trunk, state.wrist, state.swivel), pose);
  pose_hand(skeleton, Side::kRight, state.angles, pose);
  return pose;
}

const std::vector<Form>& core_handshapes() {
  static const std::vector<Form> forms = [] {
    HandStage stage;
    std::vector<Form> made;
    const std::vector<Handshape> all = shipped().lexicon->handshapes().value();
    for (const Handshape& handshape : all) {
      if (!handshape.core) continue;
      Form form{handshape.id, degrees_of(hand_angles(handshape)), {}};
      for (const Direction& palm : {Direction{0, 0, 1}, Direction{1, 0, 0}})
        form.pictures.push_back(stage.of(showing(handshape, palm)));
      made.push_back(std::move(form));
    }
    return made;
  }();
  return forms;
}

/// Each by itself, when it is reached and when it ends: the joints of both arms as rotation vectors.
const std::vector<Form>& letters() {
  static const std::vector<Form> forms = [] {
    HandStage stage;
    const Skeleton& skeleton = shipped().figure.skeleton;
    std::vector<Form> made;
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
      const std::string gloss = std::string("fs:") + letter;
      const Performance performance(*shipped().signer, score_of({gloss}),
                                    {.left_handed = false, .idle = false, .seed = 1});
      const GlossSpan& span = performance.score().glosses.front();
      Form form{std::string(1, letter), {}, {}};
      Pose pose;
      for (const Tick time : {span.begin, span.end}) {
        performance.sample(time, pose);
        form.pictures.push_back(stage.of(pose));
        for (const Side side : {Side::kLeft, Side::kRight}) {
          const ArmNodes nodes = arm_nodes(skeleton, side);
          std::vector<int> joints{nodes.shoulder, nodes.elbow, nodes.wrist};
          for (const auto& digit : nodes.digits)
            joints.insert(joints.end(), digit.begin(), digit.end());
          for (const int node : joints) {
            const Vec3 turn = rotation_vector(pose.rotation[static_cast<size_t>(node)]) / kDegree;
            form.angles.insert(form.angles.end(), {turn.x, turn.y, turn.z});
          }
        }
      }
      made.push_back(std::move(form));
    }
    return made;
  }();
  return forms;
}

TEST(Confusable, NoTwoCoreHandshapes) {
  ASSERT_EQ(core_handshapes().size(), 37U);
  const auto noise = ranked(core_handshapes(), noise_borne, "core handshapes, degrees of noise borne");
  EXPECT_GT(noise.front().value, kNoise);
  const auto seen = ranked(core_handshapes(), seen_apart, "core handshapes, share of the silhouette");
  EXPECT_GT(seen.front().value, kApart);
}

TEST(Confusable, NoTwoLetters) {
  ASSERT_EQ(letters().size(), 26U);
  const auto noise = ranked(letters(), noise_borne, "letters, degrees of noise borne");
  EXPECT_GT(noise.front().value, kNoise);
  const auto seen = ranked(letters(), seen_apart, "letters, share of the silhouette");
  EXPECT_GT(seen.front().value, kApart);
}

}  // namespace
}  // namespace auslan
