// SPDX-License-Identifier: Apache-2.0
// Figures as glTF 2.0: how the built-in figure is stored and how a figure comes in from a modelling program.
//
// A figure is one scene of nodes. Each node has a name, a translation (metres) and at most one mesh; nothing is
// rotated, scaled or skinned. A mesh is one indexed triangle list with POSITION, NORMAL, COLOR_0 (linear light, as glTF
// has it) and morph targets of POSITION, named in mesh.extras.targetNames as ARKit names its blend shapes.
// A figure with appearances has them in scene.extras.appearances (name, background, pigments as sRGB triples) and each
// painted mesh an attribute _PAINT of four unsigned bytes: two pigments, the second's share in 255ths, the shade in
// 200ths. COLOR_0 is what the figure wore when it was written.
#pragma once

#include "kinematics/figure.h"
#include "kinematics/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace auslan {

/// No longer .glb, .gltf or external buffer is read or written.
inline constexpr uint64_t kMaxGltfBytes = uint64_t{64} << 20;

/// Writes a .glb, whole or not at all; the same figure always gives the same bytes. Nodes stand depth-first.
/// Errors: kMalformed if the figure breaks what figure.h promises, kLimit, kUnwritable.
Result<void> write_gltf(const Figure& figure, const std::filesystem::path& path);

/// Reads a .glb or .gltf, whatever its name says, and trusts nothing in it. read_gltf of what write_gltf wrote is the
/// same figure bit for bit; the bytes depend on no processor or maths library. Meshes without COLOR_0 take the
/// material's base colour. Ignored: textures (their sizes are bounded, their pixels never decoded), cameras, lights,
/// animations, morph targets that are not a face channel. External buffers are read from the file's own folder and
/// below, never elsewhere. Errors (`place` is the path and the part of the file): kNotFound, kUnreadable (also FIFOs
/// and devices), kLimit, kMalformed, kUnsupported (rotated or scaled rest poses, skins, several primitives a mesh,
/// required extensions).
Result<Figure> read_gltf(const std::filesystem::path& path);

/// The same of bytes in memory; `folder` is where external buffers are looked for. `place` is the part of the file.
Result<Figure> parse_gltf(std::span<const std::byte> bytes, const std::filesystem::path& folder);

}  // namespace auslan
