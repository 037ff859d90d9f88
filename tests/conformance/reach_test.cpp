// SPDX-License-Identifier: Apache-2.0
// What the built-in figure's hands reach, with the tables printed: all orientations of the notation before the body,
// and what pinches close. What is not reached is held against a search through the arm's own angles.
#include "arm_search.h"
#include "kinematics/rotation.h"
#include "kinematics/solid.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace auslan {
namespace {

constexpr double kFarthest = 0.5;  // metres; skin farther away is not looked for
/// The part of the palm that is across the fingers, which alone can be stated freely.
Vec3 across(const Vec3& palm, const Vec3& fingers) {
  return unit(palm - fingers * glm::dot(palm, fingers));
}

TEST(Reach, OrientationsThatAnArmAllowsAreShown) {
  const Reach reach;
  const Handshape flat = shipped().lexicon->handshape("flat").value().value();
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const HandFrame& frame = reach.signer().hand_frame(side);
    int shown = 0;
    int missed = 0;
    int never_here = 0;
    int never = 0;
    std::string table;
    for (const Direction& fingers : directions()) {
      char row[40];
      std::snprintf(row, sizeof row, "%-18s", to_name(fingers).c_str());
      table += row;
      for (const char* letters : kPalmLetters) {
        Posture posture;
        posture.fingers = fingers;
        posture.palm = palm_across(fingers, letters);
        // Before its own shoulder, where a hand is freest.
        posture.offset = Vec3(side == Side::kRight ? -0.15 : 0.15, 0.0, 0.3);
        const Vec3 f = to_vector(posture.fingers);
        const Vec3 p = across(to_vector(posture.palm), f);
        const PlacedHand placed = reach.signer().place(posture, flat, side, {});
        const Reach::Posed posed = reach.posed(side, placed.state);
        const double off = std::max(notation::angle_deg(posed.wrist.rotation * frame.fingers, f),
                                    notation::angle_deg(posed.wrist.rotation * frame.palm, p));
        if (off <= kWithin && posed.strain <= kInLimits) {
          ++shown;
          table += "  .";
          continue;
        }
        const Quat wanted = orient_hand(frame, f, p);
        const Vec3 place = apply(placed.state.wrist, placed.part);
        if (reach.possible(side, placed.part, place, wanted) <= kInLimits) {
          ++missed;
          table += "  M";
        } else if (reach.possible_somewhere(side, wanted)) {
          ++never_here;
          table += "  h";
        } else {
          ++never;
          table += "  n";
        }
      }
      table += "\n";
    }
    std::printf(
        "%s hand, fingers by palm (u ur r dr d dl l ul): . shown within %.0f degrees and all joint limits, M missed\n"
        "though an arm could that is in nothing, h not at this place but elsewhere before the body, n nowhere there\n%s"
        "%d shown, %d missed, %d not at this place, %d nowhere\n",
        side == Side::kRight ? "right" : "left", kWithin, table.c_str(), shown, missed, never_here, never);
    EXPECT_EQ(shown + missed + never_here + never, 26 * 8);
    EXPECT_EQ(missed, 0) << "orientations that an arm within its limits could show";
  }
}

/// What the description of a handshape says the thumb meets: digits 1 (index) to 4 (little). A thumb is as broad as two
/// fingers, and this hand's palm does not cup: of gathered fingers the others lie beside their neighbours.
struct Pinch {
  const char* handshape;
  std::vector<size_t> fingers;
  std::vector<size_t> beside = {};
};
const std::vector<Pinch>& pinches() {
  static const std::vector<Pinch> all = {{"round", {1, 2}, {3, 4}},
                                         {"okay", {1}},
                                         {"perth", {2}},
                                         {"soon", {1}},
                                         {"ten", {2}},
                                         {"write", {1}},
                                         {"salt", {1, 2}},
                                         {"animal", {2, 3}},
                                         {"queer", {3}},
                                         {"round_flat", {1, 2}, {3, 4}},
                                         {"okay_flat", {1}},
                                         {"okay_f", {1}},
                                         {"point_d", {2}, {3, 4}},
                                         {"soon_flick", {1}},
                                         {"soon_closed", {1}},
                                         {"ten_tip", {2}},
                                         {"ten_flat", {2}},
                                         {"write_flat", {1}},
                                         {"write_flick", {1}},
                                         {"salt_closed", {1, 2}},
                                         {"salt_flick", {1, 2}}};
  return all;
}

TEST(Reach, WhatPinchesClosesWithoutPressingDeep) {
  const Figure& figure = shipped().figure;
  const ArmNodes nodes = arm_nodes(figure.skeleton, Side::kRight);
  std::vector<Transform> world(static_cast<size_t>(figure.skeleton.size()));
  // The least distance of the skin of the last segments of two digits, negative where they are in each other.
  const auto gap = [&](size_t digit, size_t other) {
    const auto met = static_cast<size_t>(nodes.digits[other][2]);
    const auto tip = static_cast<size_t>(nodes.digits[digit][2]);
    double least = kFarthest;
    for (const auto& [points, solid] : {std::pair{met, tip}, std::pair{tip, met}}) {
      const Solid surface(figure.segments[solid]);
      for (const glm::vec3& position : figure.segments[points].positions) {
        const Vec3 p =
            glm::conjugate(world[solid].rotation) * (apply(world[points], Vec3(position)) - world[solid].position);
        if (const auto nearest = surface.nearest(p, kFarthest)) least = std::min(least, nearest->distance);
      }
    }
    return least;
  };
  constexpr double kClosed = 0.002, kBeside = 0.006;
  int wrong = 0;
  std::printf(
      "Gap of a finger's last segment to that of the thumb, or of the neighbour beside which it lies, mm (negative: "
      "inside)\n");
  for (const Pinch& pinch : pinches()) {
    const Handshape handshape = shipped().lexicon->handshape(pinch.handshape).value().value();
    Pose pose = rest_pose(figure.skeleton);
    pose_hand(figure.skeleton, Side::kRight, hand_angles(handshape), pose);
    forward(figure.skeleton, pose, world);
    std::printf("  %-12s", pinch.handshape);
    const auto measure = [&](size_t finger, size_t other, double closed) {
      const double found = gap(finger, other);
      if (std::abs(found) > closed) ++wrong;
      std::printf(" %s %5.1f%s", std::array{"thumb", "index", "middle", "ring", "little"}[finger], found * 1e3,
                  std::abs(found) > closed ? "!" : "");
    };
    for (const size_t finger : pinch.fingers)
      measure(finger, 0, kClosed);
    for (const size_t finger : pinch.beside)
      measure(finger, finger - 1, kBeside);
    std::printf("\n");
  }
  std::printf("%d of them open, or pressed in, by more than %.0f mm, of neighbours %.0f\n", wrong, kClosed * 1e3,
              kBeside * 1e3);
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace auslan
