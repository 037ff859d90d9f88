// SPDX-License-Identifier: Apache-2.0
// What VRM adds to glTF that figures need: which node is which part of the body, and the expressions of the face.
// VRM 0: extension VRM (vrm-c/vrm-specification, 0.0); VRM 1: VRMC_vrm 1.0.
#pragma once

#include "avatar_mesh.h"
#include "kinematics/avatar.h"
#include "kinematics/result.h"

#include <span>

namespace auslan::gltf {

/// Fills the kind, the name, author and licence, the humanoid map and the expressions of an avatar whose nodes and
/// meshes are read. `node_of_source` gives the avatar's node for one of the file. Errors: kMalformed for parts of the
/// map that lead nowhere; binds that do are left out with a warning.
Result<void> read_vrm(const tinygltf::Model& model, std::span<const int> node_of_source, Avatar& avatar,
                      Warnings& warnings);

}  // namespace auslan::gltf
