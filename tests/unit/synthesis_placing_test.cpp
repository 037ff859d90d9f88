// SPDX-License-Identifier: Apache-2.0
// Where hands are put that something is in the way of: every vertex of the skin as it is drawn against the other's
// solid.
#include "kinematics/solid.h"
#include "shipped.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace auslan {
namespace {

// How deep a hand may press in, by the project's quality limits, metres.
constexpr double kPressing = 0.003;
// By how much the skin between the points that a fit tries may lie deeper than they do.
constexpr double kBetweenPoints = 0.002;

/// The segments of a hand and where they are.
std::vector<std::pair<int, Transform>> segments_of(Side side, const HandState& state) {
  const ArmNodes nodes = arm_nodes(shipped().figure.skeleton, side);
  std::vector<std::pair<int, Transform>> segments = {{nodes.wrist, state.wrist}};
  const auto digits = shipped().signer->hand(side).digits(state.angles);
  for (size_t digit = 0; digit < 5; ++digit)
    for (size_t joint = 0; joint < 3; ++joint) {
      const Transform& in_wrist = digits[digit][joint];
      segments.emplace_back(nodes.digits[digit][joint],
                            Transform{state.wrist.rotation * in_wrist.rotation, apply(state.wrist, in_wrist.position)});
    }
  return segments;
}

/// How deep the vertices of one lie in the other at most; negative: how far off the nearest one is.
double depth(const std::vector<std::pair<int, Transform>>& points,
             const std::vector<std::pair<int, Transform>>& solids) {
  double deepest = -1.0;
  for (const auto& [node, place] : solids) {
    const Solid solid(shipped().figure.segments[static_cast<size_t>(node)]);
    for (const auto& [of, from] : points) {
      for (const glm::vec3& vertex : shipped().figure.segments[static_cast<size_t>(of)].positions) {
        const Vec3 point = glm::conjugate(place.rotation) * (apply(from, Vec3(vertex)) - place.position);
        const auto nearest = solid.nearest(point, std::max(0.0, -deepest) + 0.1);
        if (nearest) deepest = std::max(deepest, -nearest->distance);
      }
    }
  }
  return deepest;
}

Handshape shape(const char* name) {
  return shipped().lexicon->handshape(name).value().value();
}

TEST(Placing, APalmKeepsOffTheFingertipThatStandsWhereItIsToBe) {
  Posture finger;
  finger.fingers = {0, 1, 0};
  finger.palm = {-1, 0, 0};
  finger.offset = Vec3(0.04, -0.02, 0.2);
  const HandState left = shipped().signer->place(finger, shape("point"), Side::kLeft, {}).state;
  // Its palm would be where the other hand's index ends.
  const Site tip = shipped().signer->hand(Side::kLeft).site(HandPart::kIndexTip, left.angles);
  const Vec3 end = apply(left.wrist, tip.position);
  Posture flat;
  flat.fingers = {1, 0, 1};
  flat.palm = {0, -1, 0};
  const Vec3 neutral = shipped().signer->body().site(Location::kNeutral, Side::kRight, Vec3(0.0), false).position;
  for (const double below : {0.0, 0.01, 0.02}) {
    flat.offset = end - neutral - Vec3(0.0, below, 0.0);
    OtherHand other;
    other.state = &left;
    const HandState through = shipped().signer->place(flat, shape("flat"), Side::kRight, {}).state;
    ASSERT_GT(depth(segments_of(Side::kLeft, left), segments_of(Side::kRight, through)), kPressing);
    other.acts = true;
    const HandState right = shipped().signer->place(flat, shape("flat"), Side::kRight, other).state;
    EXPECT_LT(depth(segments_of(Side::kLeft, left), segments_of(Side::kRight, right)), kPressing) << below;
    EXPECT_LT(depth(segments_of(Side::kRight, right), segments_of(Side::kLeft, left)), kPressing) << below;
  }
}

TEST(Placing, WhereTheNamedPartCannotComeFirstWhatIsBeforeItTouches) {
  // A fist with its palm to the chest: the thumb and the folded fingers are before the side that is named.
  Posture posture;
  posture.fingers = {1, 1, 0};
  posture.palm = {0, 0, -1};
  posture.location = Location::kChest;
  posture.contact = Contact{.kind = ContactKind::kTouch, .part = HandPart::kFistThumbSide, .target = std::nullopt};
  const PlacedHand placed = shipped().signer->place(posture, shape("fist"), Side::kRight, {});
  const int trunk = shipped().figure.skeleton.find("spine_base");
  const std::vector<std::pair<int, Transform>> body = {
      {trunk, Transform{kIdentity, shipped().figure.skeleton.rest_position(trunk)}}};
  const double pressed = depth(segments_of(Side::kRight, placed.state), body);
  EXPECT_LT(pressed, kPressing + kBetweenPoints);
  EXPECT_GT(pressed, -kPressing);
  EXPECT_TRUE(placed.touching);
}

}  // namespace
}  // namespace auslan
