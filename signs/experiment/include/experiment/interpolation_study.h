// SPDX-License-Identifier: Apache-2.0
// The interpolation experiment of the Auslan Jam paper, section 4.2: one joint, one start, two spellings of the same
// end, three ways to get there.
#pragma once

#include "kinematics/rotation.h"
#include "kinematics/vector.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

enum class Method { kEuler, kLerp, kSlerp };
inline constexpr std::array<std::string_view, 3> kMethodNames = {"Euler angles, linear",
                                                                 "quaternion lerp, renormalised", "quaternion slerp"};

/// Frames of the paper's runs, first and last pose included.
inline constexpr int kStudyFrames = 200;
/// Degrees about X, Y, Z in the paper's order (kPaperOrder).
inline constexpr Vec3 kStudyStart{0.0, 180.0, 0.0};
inline constexpr std::array<Vec3, 2> kStudyEnds = {Vec3(90.0, 270.0, 90.0), Vec3(0.0, 270.0, 0.0)};

/// One run of one method.
struct StudyRun {
  Method method = Method::kEuler;
  int end = 0;                    ///< index into kStudyEnds
  std::vector<Quat> orientation;  ///< kStudyFrames of them
  std::vector<double> distance;   ///< degrees from each frame to the end pose
  std::vector<double> velocity;   ///< degrees a frame from each frame to the next; one fewer
};

/// What the numbers of a run come to.
struct StudySummary {
  double path_degrees = 0;               ///< sum of the velocities
  double mean = 0, least = 0, most = 0;  ///< of the velocity, degrees a frame
  double variation = 0;                  ///< (most - least) / mean
};

/// All six runs: by end, then by method.
std::vector<StudyRun> run_study();
StudySummary summarise(const StudyRun& run);
/// The largest angle in degrees between two runs at the same frame.
double largest_separation(const StudyRun& a, const StudyRun& b);

}  // namespace auslan
