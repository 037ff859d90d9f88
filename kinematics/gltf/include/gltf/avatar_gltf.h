// SPDX-License-Identifier: Apache-2.0
// Foreign humanoid figures: glTF 2.0 with skins and morph targets, VRM 0 and VRM 1.
#pragma once

#include "kinematics/avatar.h"
#include "kinematics/result.h"

#include <cstddef>
#include <filesystem>
#include <span>

namespace auslan {

/// Reads a .vrm, .glb or .gltf, whatever its name says, and trusts nothing in it. The bytes depend on no processor or
/// maths library.
///
/// Kept: the nodes of the file, parents first; meshes of the default scene's nodes with up to four joints a vertex
/// (the heaviest), morph targets, the material's base colour, its image still encoded (PNG, JPEG); the humanoid map and
/// the expressions of VRM. Without a VRM map, and where it has gaps, roles are told from the names of nodes.
/// Not kept, and told in Avatar::warnings where it shows: animations, spring bones, constraints, other textures and
/// shading, points and lines, shear, other image formats.
///
/// Bounds: 64 MiB of file, buffers and images; JSON of 64 levels and 200,000 values; 16 million numbers in meshes;
/// those of avatar.h. Files that the .gltf names are read from its own folder and below, never elsewhere.
/// Errors (`place` is the path and the part of the file): kNotFound, kUnreadable (also FIFOs and devices), kLimit,
/// kMalformed, kUnsupported (glTF 1, required extensions that are not known, nothing to draw).
Result<Avatar> read_avatar(const std::filesystem::path& path);

/// The same of bytes in memory; `folder` is where external files are looked for. `place` is the part of the file.
Result<Avatar> parse_avatar(std::span<const std::byte> bytes, const std::filesystem::path& folder);

}  // namespace auslan
