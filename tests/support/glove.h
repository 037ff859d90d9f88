// SPDX-License-Identifier: Apache-2.0
// Recordings of signs with two instrumented gloves, and the motion of the figure, in the same terms.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/result.h"
#include "kinematics/vector.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace auslan::glove {

/// One hand at one time. Space of the project: +x the signer's left, +y up, +z away from the chest; metres.
struct Hand {
  Vec3 place{0.0};  ///< of the tracker on the back of the hand; the zero of a recording is its session's own
  Vec3 fingers{0.0}, palm{0.0};
  std::array<double, 5> bends{};  ///< thumb to little finger, 0 straight to 1 bent, each sensor in its own way
};
using Frame = std::array<Hand, 2>;  ///< by Side

struct Recording {
  std::string word;     ///< as the file is named: "change_mind_"
  std::string session;  ///< "session4"
  std::vector<Frame> frames;
};

/// How far the tracker is above the axis of the wrist, metres.
inline constexpr double kTrackerAbove = 0.045;

/// Reads rows of 22 numbers: for the left and then the right hand x y z roll pitch yaw thumb fore middle ring little
/// (M. W. Kadous' Auslan recordings). An Error names the line.
Result<std::vector<Frame>> parse_glove(std::string_view text, const std::string& place);

/// WORD.SESSION.tsd of a folder, by name.
Result<std::vector<Recording>> read_glove_folder(const std::filesystem::path& folder);

/// A sign of the lexicon on the shipped figure, `rate` times a second.
std::vector<Frame> synthesised(const std::string& gloss, double rate);

/// From where the more active hand has left its rest by two fifths of its farthest way, to where it is last so far from
/// it. The rest is where the hands are at the end.
std::vector<Frame> without_rest(const std::vector<Frame>& frames);
/// Whether a hand leaves its rest by more than a hand is broad.
bool takes_part(const std::vector<Frame>& frames, Side side);

}  // namespace auslan::glove
