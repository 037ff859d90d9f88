// SPDX-License-Identifier: Apache-2.0
// Meshes of foreign figures: vertices with their bones and morph targets, triangles, materials.
#pragma once

#include "accessor.h"
#include "kinematics/avatar.h"
#include "kinematics/result.h"

namespace auslan::gltf {

/// What a file shows that is not kept, each thing said once however often it occurs.
class Warnings {
 public:
  explicit Warnings(std::vector<std::string>& texts) : texts_(texts) {}
  void add(std::string text);

 private:
  std::vector<std::string>& texts_;
};

/// A name for a warning: cut, since names may be as long as the file and be told of often.
std::string shortened(const std::string& name);

/// Whole triangles, indices in range, arrays of one length, weights of sum 1. Errors: kMalformed, kLimit; `place` is
/// the mesh or the accessor. `triangles_left` shrinks by the triangles of the mesh.
Result<AvatarMesh> read_avatar_mesh(const tinygltf::Model& model, int index, AccessorReader& reader,
                                    size_t& triangles_left, Warnings& warnings);

}  // namespace auslan::gltf
