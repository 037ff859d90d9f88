// SPDX-License-Identifier: Apache-2.0
// Writes the files that the fuzzers of figures start from: figure_seeds gltf|figure_file|avatar FOLDER.
#include "glb_document.h"
#include "kinematics/figure_file.h"
#include "tiny_avatar.h"

#include <iostream>
#include <string>
#include <string_view>
#include <utility>

int main(int argc, char** argv) {
  using namespace auslan;
  if (argc != 3) {
    std::cerr << "usage: figure_seeds gltf|figure_file|avatar FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder(argv[2]);
  std::filesystem::create_directories(folder);
  const Figure figure = test::tiny_figure();
  if (std::string_view(argv[1]) == "figure_file") {
    put_bytes(folder / "tiny.figure", serialise_figure(figure));
    return 0;
  }
  if (std::string_view(argv[1]) == "avatar") {
    for (const auto& [kind, name] : {std::pair(Avatar::Kind::kGltf, "gltf"), std::pair(Avatar::Kind::kVrm0, "vrm0"),
                                     std::pair(Avatar::Kind::kVrm1, "vrm1")}) {
      const test::GlbDocument document = test::tiny_avatar(kind);
      put_bytes(folder / (std::string(name) + ".glb"), document.pack());
      put_bytes(folder / (std::string(name) + ".parts"), document.json.dump() + '\0' + document.binary);
    }
    return 0;
  }
  const std::string glb = test::glb_bytes(figure);
  const test::GlbDocument document = test::open_glb(glb);
  put_bytes(folder / "tiny.glb", glb);
  put_bytes(folder / "tiny.parts", document.json.dump() + '\0' + document.binary);
  return 0;
}
