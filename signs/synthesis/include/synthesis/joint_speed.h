// SPDX-License-Identifier: Apache-2.0
// How fast joints turn when people sign: limits that synthesis keeps, and where they come from.
//
// What trained people reach at their fastest, quoted from memory of the abstracts: 50 rad/s (2865 degrees a second) at
// the wrist, the highest of the upper limb (Jessop & Pain 2016, Journal of Human Kinetics 50:37); 2320 at the elbow of
// a pitcher (Fleisig et al. 1999, Journal of Biomechanics 32:1371); 780 of the head in vigorous shaking (Grossman et
// al. 1988, Experimental Brain Research 70:470). Nobody signs like a pitcher: arms and fingers stay at about half of
// that or below. The trunk leans slowly.
#pragma once

#include "kinematics/elementary.h"

#include <string_view>

namespace auslan {

/// Radians a second that a joint may turn against its parent.
namespace joint_speed {
inline constexpr double kTrunk = 120 * kDegree;
inline constexpr double kNeck = 390 * kDegree;      ///< neck and head share the head's turn
inline constexpr double kClavicle = 120 * kDegree;  ///< the shoulder then moves by 0.3 m/s: as the trunk, slowly
inline constexpr double kShoulder = 900 * kDegree;
inline constexpr double kElbow = 1200 * kDegree;  ///< bend and the forearm's turn together
inline constexpr double kWrist = 1200 * kDegree;
inline constexpr double kDigit = 1200 * kDegree;
/// Metres a second at which a wrist passes through the air; 4 is the limit of the project's quality.
inline constexpr double kWristInSpace = 3.7;
}  // namespace joint_speed

/// Of a node by its name; of nodes that are neither of the 39 nor clavicles that of a digit.
double fastest_turn(std::string_view node);

}  // namespace auslan
