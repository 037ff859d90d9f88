// SPDX-License-Identifier: Apache-2.0
// From bytes to tinygltf's model, which is then complete but unchecked: its indices may lead nowhere.
#pragma once

#include "kinematics/result.h"

#include <cstddef>
#include <exception>
#include <filesystem>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <tiny_gltf.h>

namespace auslan::gltf {

struct LoadOptions {
  std::span<const std::string_view> known_extensions = {};  ///< that a file may require
  bool keeps_images = false;                                ///< PNG and JPEG, encoded, in tinygltf::Image::image
};

/// Checks the bytes as container.h says and loads them; files they name are read from `folder` and below. May throw
/// what without_exceptions() catches. Errors: kMalformed, kLimit, kUnsupported, kNotFound, kUnreadable.
Result<tinygltf::Model> load_model(std::span<const std::byte> bytes, const std::filesystem::path& folder,
                                   const LoadOptions& options);

/// "nodes[3] (name)".
std::string place_of(const char* list, int index, const std::string& name);

/// The path and, after a colon, the place inside the file.
std::string place_in_file(const std::filesystem::path& path, const std::string& place);

/// An Error for an exception of the libraries.
Error error_of(const std::exception& exception);

/// What `work` returns, a Result; exceptions become errors.
template <typename Work>
auto without_exceptions(Work work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::kLimit, "there is not enough memory to read the file");
  } catch (const std::exception& exception) {
    return tl::unexpected<Error>(error_of(exception));
  }
}

}  // namespace auslan::gltf
