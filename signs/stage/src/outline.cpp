// SPDX-License-Identifier: Apache-2.0
#include "outline.h"

#include <cstddef>
#include <utility>

namespace auslan {
namespace {

constexpr glm::u8vec4 kInk{22, 18, 20, 255};

}  // namespace

std::span<const PosedMesh> Outline::around(std::span<const PosedMesh> meshes) {
  hulls_.resize(meshes.size());
  meshes_.assign(meshes.begin(), meshes.end());
  for (size_t i = 0; i < meshes.size(); ++i) {
    const PosedMesh& mesh = meshes[i];
    Hull& hull = hulls_[i];
    if (hull.revision == 0) {
      hull.colours.assign(mesh.positions.size(), kInk);
      hull.indices.assign(mesh.indices.begin(), mesh.indices.end());
      for (size_t first = 0; first + 2 < hull.indices.size(); first += 3)
        std::swap(hull.indices[first + 1], hull.indices[first + 2]);
      hull.positions.resize(mesh.positions.size());
    }
    if (hull.revision != mesh.revision) {
      for (size_t v = 0; v < mesh.positions.size(); ++v)
        hull.positions[v] = mesh.positions[v] + mesh.normals[v] * width_;
      hull.revision = mesh.revision;
    }
    meshes_[i].positions = hull.positions;
    meshes_[i].colours = hull.colours;
    meshes_[i].indices = hull.indices;
  }
  return meshes_;
}

}  // namespace auslan
