// SPDX-License-Identifier: Apache-2.0
// Tables of other signers, made from the shipped one: taller, shorter, broader, older, younger.
#pragma once

#include "sculpt/measurements.h"

#include <string>
#include <vector>

namespace auslan::test {

/// How a body differs from the shipped table's, as factors.
struct Build {
  std::string name;
  double height = 1.0, breadth = 1.0, head = 1.0, hand = 1.0;
};

inline std::vector<Build> other_builds() {
  return {{"taller", 1.12, 1.03, 1.03, 1.09},
          {"shorter", 0.89, 0.95, 0.98, 0.92},
          {"broader", 1.0, 1.2, 1.04, 1.07},
          {"older", 0.97, 1.1, 1.0, 1.02},
          {"younger", 0.85, 0.86, 0.96, 0.87}};
}

inline Measurements of_build(Measurements table, const Build& build) {
  for (double* length : {&table.stature, &table.hip_height, &table.acromial_height, &table.acromion_to_shoulder_joint,
                         &table.neck_base_height, &table.neck_base_depth, &table.upper_arm, &table.forearm})
    *length *= build.height;
  for (double* length : {&table.shoulder_joint_breadth, &table.chest_breadth, &table.chest_depth, &table.waist_breadth,
                         &table.waist_depth, &table.hip_breadth, &table.neck_circumference, &table.wrist_circumference,
                         &table.upper_arm_circumference, &table.forearm_circumference})
    *length *= build.breadth;
  for (double* length :
       {&table.head_length, &table.head_breadth, &table.eye_to_vertex, &table.face_height, &table.interpupillary})
    *length *= build.head;
  for (double* length : {&table.hand_length, &table.hand_breadth, &table.palm_thickness})
    *length *= build.hand;
  for (DigitMeasurements& digit : table.digits) {
    digit.root *= build.hand;
    digit.tip *= build.hand;
    for (size_t i = 0; i < 3; ++i) {
      digit.bones[i] *= build.hand;
      digit.breadths[i] *= build.hand;
    }
  }
  table.name = build.name;
  return table;
}

}  // namespace auslan::test
