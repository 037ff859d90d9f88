// SPDX-License-Identifier: Apache-2.0
#include "golden.h"

#include "media/picture.h"

#include <filesystem>
#include <system_error>

namespace auslan {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

bool is_golden_name(const std::string& name) {
  return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

/// Writes a picture for a person to look at, and says where, or why not: the test fails either way.
std::string keep(const std::string& what, const std::string& path, FrameView frame) {
  const Result<void> written = write_png(path, frame);
  return "\n  " + what + ": " + (written ? path : "not kept, " + to_string(written.error()));
}

}  // namespace

GoldenFolders golden_folders() {
  return {AUSLANJAM_SOURCE_DIR "/tests/golden", AUSLANJAM_BINARY_DIR "/golden"};
}

AssertionResult matches_golden(FrameView frame, const std::string& name, const GoldenFolders& folders) {
  if (!is_golden_name(name)) {
    return AssertionFailure() << "a golden picture is named in lower case, digits and underscores, not \"" << name
                              << '"';
  }
  if (!is_well_formed(frame)) {
    return AssertionFailure() << name << ": the frame's size does not agree with its number of pixels";
  }
  const std::string golden = folders.golden + '/' + name + ".png";
  const std::string kept = folders.kept + '/' + name;
  std::error_code ignored;
  std::filesystem::create_directories(folders.kept, ignored);
  for (const char* kind : {".candidate.png", ".actual.png", ".expected.png", ".difference.png"}) {
    std::filesystem::remove(kept + kind, ignored);
  }

  const Result<Picture> expected = read_png(golden);
  if (!expected && expected.error().code == ErrorCode::kNotFound) {
    return AssertionFailure() << name << ": there is no golden picture " << golden
                              << keep("candidate", kept + ".candidate.png", frame)
                              << "\n  look at it; when it is right: tests/golden/accept " << name;
  }
  if (!expected) {
    return AssertionFailure() << name << ": the golden picture cannot be read: " << to_string(expected.error())
                              << keep("actual", kept + ".actual.png", frame);
  }

  const Comparison comparison = compare(expected->view(), frame);
  if (comparison.equal()) {
    return AssertionSuccess();
  }
  AssertionResult failure = AssertionFailure();
  failure << name << ": " << to_string(comparison) << keep("actual", kept + ".actual.png", frame)
          << keep("expected", kept + ".expected.png", expected->view());
  if (comparison.same_size) {
    failure << keep("difference", kept + ".difference.png", difference_image(expected->view(), frame).view());
  }
  return failure << "\n  look at them; when the new picture is right: tests/golden/accept " << name;
}

}  // namespace auslan
