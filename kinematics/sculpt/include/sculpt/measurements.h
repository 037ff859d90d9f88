// SPDX-License-Identifier: Apache-2.0
// The table a signer is made from: body lengths in millimetres and colours, read from TOML.
#pragma once

#include "kinematics/result.h"
#include "kinematics/vector.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace auslan {

/// An sRGB-encoded colour, each channel 0 to 255.
struct TableColour {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
};

/// One look of the signer.
struct TableAppearance {
  std::string name;
  TableColour skin, palm, hair, shirt, trousers, iris, lips, background;
};

/// One digit. All lengths in millimetres.
struct DigitMeasurements {
  /// First joint (MP of a finger, CMC of the thumb) from the wrist, left hand at rest: along the fingers, towards the
  /// back of the hand, towards the thumb's side.
  Vec3 root{0.0};
  std::array<double, 3> bones{};     ///< joint to joint, root to tip; the last is the distal bone
  double tip = 0.0;                  ///< soft tissue beyond the last bone
  std::array<double, 3> breadths{};  ///< at the root joint, the middle joint and the last joint
};

/// Everything the sculptor takes from the table. Millimetres; names follow ANSUR II.
struct Measurements {
  std::string name;

  double stature = 0.0;
  double hip_height = 0.0;  ///< height of spine_base
  double acromial_height = 0.0;
  double acromion_to_shoulder_joint = 0.0;  ///< how far the joint's centre lies below the acromion
  double shoulder_joint_breadth = 0.0;      ///< between the centres of the two shoulder joints
  double neck_base_height = 0.0;
  double neck_base_depth = 0.0;  ///< how far neck_base lies behind the shoulder line
  double chest_breadth = 0.0;
  double chest_depth = 0.0;
  double waist_breadth = 0.0;
  double waist_depth = 0.0;
  double hip_breadth = 0.0;
  double neck_circumference = 0.0;

  double upper_arm = 0.0;  ///< acromion to radiale
  double forearm = 0.0;    ///< radiale to stylion
  double wrist_circumference = 0.0;
  double upper_arm_circumference = 0.0;
  double forearm_circumference = 0.0;

  double head_length = 0.0;
  double head_breadth = 0.0;
  double eye_to_vertex = 0.0;
  double face_height = 0.0;  ///< menton to sellion
  double interpupillary = 0.0;

  double hand_length = 0.0;
  double hand_breadth = 0.0;
  double palm_thickness = 0.0;
  double thumb_angle_deg = 0.0;             ///< between thumb and index in the palm plane
  double thumb_drop_deg = 0.0;              ///< how far the thumb points to the palm side of that plane
  std::array<DigitMeasurements, 5> digits;  ///< thumb, index, middle, ring, little

  std::vector<TableAppearance> appearances;  ///< at least one; the first is the one that the figure comes in
};

/// Reads and checks a table. kUnreadable when the file cannot be opened; kMalformed, with file:line, for bad TOML, a
/// missing or unknown key, a value of the wrong type and a length outside the range in which a figure can be made.
Result<Measurements> read_measurements(const std::filesystem::path& path);

}  // namespace auslan
