// SPDX-License-Identifier: Apache-2.0
// The baked figure: a Figure as one flat binary file that loads by copying arrays, so that no program parses glTF at
// start. auslan-bake makes it from a .glb.
//
// Layout, all little-endian, no padding between fields:
//   header   8 bytes "AJFIGURE", u32 version, u32 zero, u64 length of the payload, u64 checksum of the payload
//   payload  text name; u32 appearances, u32 pigments; for each appearance: text name, 3 u8 background, pigments x 3
//   u8;
//            u32 nodes; for each node: text name, i32 parent, 3 f64 offset;
//            for each node: u32 vertices, u32 painted vertices (all or none), u32 indices, u32 morphs,
//              vertices x 3 f32 position, vertices x 3 f32 normal, vertices x 4 u8 colour,
//              painted x 4 u8 (two pigments, share, shade), indices x u32,
//              for each morph: u32 channel, u32 count, count x u32 vertex, count x 3 f32 displacement
//   text     u32 length, then that many bytes
//   checksum FNV-1a over 64-bit words instead of bytes: h = (0xcbf29ce484222325 ^ length) * 0x100000001b3 (mod 2^64),
//   then
//            for each word, the last filled with zero bytes: h = (h ^ word) * 0x100000001b3, h ^= h >> 32
#pragma once

#include "kinematics/figure.h"
#include "kinematics/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace auslan {

inline constexpr uint32_t kFigureFileVersion = 2;
/// No figure file is longer; nothing longer is read or written.
inline constexpr uint64_t kMaxFigureFileBytes = uint64_t{64} << 20;
/// Bounds of a figure's parts, against files that would ask for more work than they have bytes.
inline constexpr size_t kMaxFigureNodes = 4096;
inline constexpr size_t kMaxFigureMorphs = 256;  ///< of one mesh
inline constexpr size_t kMaxFigureAppearances = 64;
inline constexpr size_t kMaxFigurePigments = 256;

/// What figure.h promises of a Figure: one segment a node, arrays of one length, whole triangles, indices in range,
/// finite positions, unit normals, opaque colours, morph vertices ascending,
/// appearances with names that differ and as many pigments each, paints of pigments that there are. kMalformed with the
/// node's name as `place`.
Result<void> check_figure(const Figure& figure);

/// The checksum of a payload, as the header of the file holds it.
uint64_t figure_checksum(std::span<const std::byte> payload);

/// The bytes of the file. The same figure always gives the same bytes. `figure` passes check_figure.
std::string serialise_figure(const Figure& figure);

/// The reverse, and check_figure. Lengths are checked before anything is allocated.
/// Errors: kMalformed, kLimit (longer than kMaxFigureFileBytes); kUnsupported for another version. `place` is the byte
/// offset, the message says how to rebuild the file.
Result<Figure> parse_figure(std::span<const std::byte> bytes);

/// serialise_figure to a file, whole or not at all. Errors: kMalformed by check_figure, kLimit, kUnwritable.
Result<void> write_figure(const Figure& figure, const std::filesystem::path& path);

/// parse_figure of a regular file. Errors: those of parse_figure with the path before the offset, kNotFound,
/// kUnreadable.
Result<Figure> read_figure(const std::filesystem::path& path);

}  // namespace auslan
