// SPDX-License-Identifier: Apache-2.0
// Golden pictures: what a test drew against a picture that a person has looked at, pixel for pixel.
#pragma once

#include "media/frame.h"

#include <gtest/gtest.h>
#include <string>

namespace auslan {

/// Where golden pictures are and where those of failed tests are kept.
struct GoldenFolders {
  std::string golden;  ///< holds NAME.png; the tree's tests/golden
  std::string kept;    ///< made when needed; <build>/golden
};

/// The folders of this tree and this build.
GoldenFolders golden_folders();

/// Success when golden/NAME.png is there and every pixel of it is equal to that of `frame`. NAME: [a-z0-9_]+.
/// Otherwise the failure says what to do, and names the worst pixel where both pictures can be compared; kept are
/// - NAME.candidate.png where there is no golden picture: look at it, then run tests/golden/accept NAME;
/// - NAME.actual.png, NAME.expected.png and, when the sizes agree, NAME.difference.png where the pictures differ.
/// Nothing is ever written into the golden folder. Pictures that an earlier run kept under this name are removed first.
::testing::AssertionResult matches_golden(FrameView frame, const std::string& name,
                                          const GoldenFolders& folders = golden_folders());

}  // namespace auslan

#define EXPECT_GOLDEN(frame, name) EXPECT_TRUE(::auslan::matches_golden((frame), (name)))
