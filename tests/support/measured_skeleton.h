// SPDX-License-Identifier: Apache-2.0
// A skeleton with the mean adult's bone lengths (ANSUR II arms and trunk; Buryanov & Kotiuk 2010 hand bones), left and
// right exact mirror images. Tests only.
#pragma once

#include "kinematics/skeleton.h"

#include <array>
#include <string>
#include <vector>

namespace auslan::test {

/// Joint places of the left hand from the wrist, millimetres: along the fingers, towards the back, towards the thumb.
struct MeasuredDigit {
  Vec3 root;
  std::array<double, 3> bones;  ///< the last to the tip of the soft tissue
};
inline const std::array<MeasuredDigit, 5> kMeasuredDigits = {{{Vec3(21, -7, 22), {46.2, 31.6, 27.4}},
                                                              {Vec3(91, 0.5, 27), {39.8, 22.4, 19.8}},
                                                              {Vec3(94.7, 2, 7.3), {44.6, 26.3, 21.4}},
                                                              {Vec3(87.5, 0.5, -12.2), {41.4, 25.7, 21.3}},
                                                              {Vec3(78.5, -2.5, -30), {32.7, 18.1, 20.0}}}};
/// Direction of the bones of a digit at rest: fingers straight ahead; the thumb 43 degrees out in the palm's plane and
/// 10 degrees to the palm's side (cosines and sines written out).
inline Vec3 measured_direction(size_t digit) {
  if (digit != 0) return {1.0, 0.0, 0.0};
  const Vec3 v(0.7313537 * 0.9848078, -0.1736482, 0.6819984 * 0.9848078);
  return glm::normalize(v);
}

/// Distance from the last joint of a digit to its tip, metres.
inline double measured_tip(size_t digit) {
  return 1e-3 * kMeasuredDigits[digit].bones[2];
}

/// `clavicles`: with a node of 0.15 m between trunk and shoulders.
inline Skeleton measured_skeleton(bool clavicles = false) {
  std::vector<Node> nodes = {{"spine_base", kNoNode, Vec3(0.0, 0.97, 0.0)},
                             {"neck_base", 0, Vec3(0.0, 0.47, -0.028)},
                             {"head_base", 1, Vec3(0.0, 0.09, 0.012)}};
  for (const double sign : {1.0, -1.0}) {
    const char* const side = sign > 0.0 ? "_l" : "_r";
    const auto add = [&](const std::string& stem, int parent, const Vec3& left) {
      nodes.push_back({stem + side, parent, Vec3(sign * left.x, left.y, left.z)});
      return static_cast<int>(nodes.size()) - 1;
    };
    const Vec3 from_trunk(0.17, -0.088, 0.028), bone(0.147, 0.0, -0.03);
    const int clavicle = clavicles ? add("clavicle", 1, from_trunk - bone) : kNoNode;
    const int shoulder = clavicles ? add("shoulder", clavicle, bone) : add("shoulder", 1, from_trunk);
    const int elbow = add("elbow", shoulder, Vec3(0.287, 0.0, 0.0));
    const int wrist = add("wrist", elbow, Vec3(0.2545, 0.0, 0.0));
    const std::array<std::array<std::string, 3>, 5> names = {{{"thumb_cmc", "thumb_mp", "thumb_ip"},
                                                              {"index_mp", "index_pip", "index_dip"},
                                                              {"middle_mp", "middle_pip", "middle_dip"},
                                                              {"ring_mp", "ring_pip", "ring_dip"},
                                                              {"little_mp", "little_pip", "little_dip"}}};
    for (size_t digit = 0; digit < 5; ++digit) {
      const MeasuredDigit& measured = kMeasuredDigits[digit];
      const Vec3 along = measured_direction(digit);
      int parent = add(names[digit][0], wrist, 1e-3 * measured.root);
      parent = add(names[digit][1], parent, 1e-3 * measured.bones[0] * along);
      add(names[digit][2], parent, 1e-3 * measured.bones[1] * along);
    }
  }
  return Skeleton::build(nodes).value();
}

}  // namespace auslan::test
