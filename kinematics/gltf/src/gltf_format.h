// SPDX-License-Identifier: Apache-2.0
// Numbers of the glTF 2.0 specification that the reader and the writer share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace auslan::gltf {

inline constexpr std::string_view kGlbMagic = "glTF";
inline constexpr uint32_t kGlbVersion = 2;
inline constexpr size_t kGlbHeaderBytes = 12;
inline constexpr size_t kChunkHeaderBytes = 8;
inline constexpr uint32_t kJsonChunk = 0x4E4F534A;
inline constexpr uint32_t kBinaryChunk = 0x004E4942;

inline constexpr int kByte = 5120;
inline constexpr int kUnsignedByte = 5121;
inline constexpr int kShort = 5122;
inline constexpr int kUnsignedShort = 5123;
inline constexpr int kUnsignedInt = 5125;
inline constexpr int kFloat = 5126;

inline constexpr int kArrayBuffer = 34962;
inline constexpr int kElementArrayBuffer = 34963;
inline constexpr int kTriangles = 4;
inline constexpr int kTriangleStrip = 5;
inline constexpr int kTriangleFan = 6;

}  // namespace auslan::gltf
