// SPDX-License-Identifier: Apache-2.0
#include "media/frame.h"
#include "scratch_folder.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace auslan {
namespace {

TEST(Digest, OfNothingIsTheConstantThatTheHashsAuthorPublishes) {
  EXPECT_EQ(frame_digest({{}, 0, 0}), "99aa06d3014798d86001c324468d497f");
}

TEST(Digest, IsWhatTheReferenceProgramGivesForTheSameBytes) {
  if (!has_program("xxh128sum")) GTEST_SKIP() << "xxh128sum is not installed (Debian: xxhash)";
  const ScratchFolder folder;
  // One pixel, a length inside the short-input code, one that spans the hash's 1024-byte blocks.
  for (const int width : {1, 31, 1000}) {
    std::vector<uint32_t> pixels;
    std::string bytes;
    for (int i = 0; i < width; ++i) {
      const auto n = static_cast<uint32_t>(i);
      const uint32_t red = n & 255, green = (n * 7) & 255, blue = (n * 13 + 5) & 255;
      pixels.push_back(red << 16 | green << 8 | blue);
      for (const uint32_t byte : {blue, green, red, 0U})
        bytes += static_cast<char>(byte);
    }
    put_bytes(folder / "pixels", bytes);
    const Ran reference = run("xxh128sum < " + (folder / "pixels").string());
    ASSERT_TRUE(reference.ok);
    EXPECT_EQ(frame_digest({pixels, width, 1}), reference.output.substr(0, 32)) << width;
  }
}

TEST(Digest, ChangesWithOneBitOfOnePixel) {
  std::vector<uint32_t> pixels(64 * 64, 0x123456);
  const std::string before = frame_digest({pixels, 64, 64});
  pixels[2000] ^= 1;
  EXPECT_NE(frame_digest({pixels, 64, 64}), before);
  pixels[2000] ^= 1;
  EXPECT_EQ(frame_digest({pixels, 64, 64}), before);
}

}  // namespace
}  // namespace auslan
