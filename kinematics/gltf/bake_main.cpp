// SPDX-License-Identifier: Apache-2.0
// auslan-bake: a glTF figure as the flat file that the programs load. Run by the build and by whoever edits the figure.
#include "gltf/figure_gltf.h"
#include "kinematics/figure_file.h"
#include "kinematics/file_tool.h"

namespace {

auslan::Result<void> bake(const std::filesystem::path& input, const std::filesystem::path& output, size_t) {
  const auto figure = auslan::read_gltf(input);
  if (!figure) return tl::unexpected(figure.error());
  return auslan::write_figure(*figure, output);
}

}  // namespace

int main(int argc, char** argv) {
  return auslan::run_file_tool(
      {.name = "auslan-bake",
       .input = "FIGURE.glb",
       .output = "OUT.figure",
       .about = "Turns a figure in glTF 2.0 (.glb or .gltf) into the flat binary file that the programs load.",
       .choice = {},
       .convert = bake},
      argc, argv);
}
