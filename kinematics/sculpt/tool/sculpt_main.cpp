// SPDX-License-Identifier: Apache-2.0
// auslan-sculpt: a table of measurements as a figure in glTF 2.0.
#include "gltf/figure_gltf.h"
#include "kinematics/file_tool.h"
#include "sculpt/sculpt.h"

namespace {

auslan::Result<void> sculpt(const std::filesystem::path& input, const std::filesystem::path& output, size_t detail) {
  const auto table = auslan::read_measurements(input);
  if (!table) return tl::unexpected(table.error());
  const auto figure = auslan::sculpt_figure(*table, static_cast<auslan::Detail>(detail));
  if (!figure) return tl::unexpected(figure.error());
  return auslan::write_gltf(*figure, output);
}

}  // namespace

int main(int argc, char** argv) {
  return auslan::run_file_tool(
      {.name = "auslan-sculpt",
       .input = "MEASUREMENTS.toml",
       .output = "OUT.glb",
       .about = "Makes the figure of a signer from a table of measurements: 41 joints, closed meshes, a face "
                "that moves.",
       .choice = {.flag = "--detail",
                  .words = auslan::kDetailNames,
                  .otherwise = static_cast<size_t>(auslan::Detail::kNormal),
                  .about = "5,000, 20,000 or 80,000 triangles"},
       .convert = sculpt},
      argc, argv);
}
