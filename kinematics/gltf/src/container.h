// SPDX-License-Identifier: Apache-2.0
// What is checked before tinygltf sees a file: tinygltf 2.7 overflows the stack on deep JSON, reads past the end of
// short chunks and of images, and opens any path a URI names.
#pragma once

#include "kinematics/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace auslan::gltf {

/// Bounds on the JSON part: tinygltf recurses into it and spends a few hundred bytes on each value.
inline constexpr int kMaxJsonDepth = 64;
inline constexpr size_t kMaxJsonValues = 200'000;
inline constexpr size_t kMaxBuffers = 16;
inline constexpr uint32_t kMaxImageSide = 8192;

/// The JSON part of a file and whether it came as .glb.
struct Container {
  std::string_view json;
  bool is_glb = false;
};

/// Splits a .glb or recognises a .gltf. Errors: kMalformed, kUnsupported for glTF 1; `place` is the byte offset.
Result<Container> open_container(std::string_view bytes);

/// Depth and number of values of the JSON part, sizes and URIs of buffers, the bytes of images, version and required
/// extensions, of which only those `known` pass. Errors: kMalformed, kLimit, kUnsupported; `place` is the byte offset
/// or the part of the document.
Result<void> check_document(const Container& container, std::span<const std::string_view> known = {});

bool is_png(const unsigned char* bytes, size_t size);
bool is_jpeg(const unsigned char* bytes, size_t size);
/// Whether the bytes of a PNG or JPEG state a side longer than kMaxImageSide. Other formats are not looked into.
bool is_image_too_large(const unsigned char* bytes, size_t size);

/// The files that a .gltf may name: those in one folder and below it.
class Folder {
 public:
  explicit Folder(const std::filesystem::path& folder);

  /// What tinygltf is to put before the names of files.
  const std::string& base() const { return base_; }
  /// Whether something is there and, links followed, lies inside; remembers why not. Paths that do not begin with
  /// base() are not there: tinygltf also tries the working directory.
  bool holds(const std::string& path);
  /// The bytes of a regular file inside, as long as the bound on all files together allows; remembers why not.
  bool read(const std::string& path, std::vector<unsigned char>& bytes);
  const std::optional<Error>& error() const { return error_; }

 private:
  std::string base_;
  std::filesystem::path folder_;
  uint64_t bytes_left_;
  std::optional<Error> error_;
};

}  // namespace auslan::gltf
