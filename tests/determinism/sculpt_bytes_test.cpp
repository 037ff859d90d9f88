// SPDX-License-Identifier: Apache-2.0
// The committed figures are what the table says, byte for byte, whatever compiled the tool.
#include "gltf/figure_gltf.h"
#include "sculpt/sculpt.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <unistd.h>
#include <utility>

namespace auslan {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(SculptBytes, TheTableGivesTheCommittedFigures) {
  const std::filesystem::path assets = std::filesystem::path(AUSLANJAM_SOURCE_DIR) / "assets" / "figure";
  const auto table = read_measurements(assets / "measurements.toml");
  ASSERT_TRUE(table) << to_string(table.error());
  for (const auto& [detail, name] :
       {std::pair(Detail::kLow, "signer_low.glb"), std::pair(Detail::kNormal, "signer.glb"),
        std::pair(Detail::kHigh, "signer_high.glb")}) {
    const auto figure = sculpt_figure(*table, detail);
    ASSERT_TRUE(figure);
    const auto made = std::filesystem::temp_directory_path() / ("sculpt_bytes_" + std::to_string(::getpid()) + ".glb");
    ASSERT_TRUE(write_gltf(*figure, made));
    const std::string now = bytes_of(made), committed = bytes_of(assets / name);
    std::filesystem::remove(made);
    ASSERT_FALSE(committed.empty());
    EXPECT_TRUE(now == committed) << "the sculptor or its table changed: look at the new figure, then run\n"
                                  << "  auslan-sculpt assets/figure/measurements.toml -o assets/figure/" << name
                                  << " --detail " << kDetailNames[static_cast<size_t>(detail)];
  }
}

}  // namespace
}  // namespace auslan
