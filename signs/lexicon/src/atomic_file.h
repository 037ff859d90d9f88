// SPDX-License-Identifier: Apache-2.0
// Files that appear complete or not at all.
#pragma once

#include "kinematics/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace auslan {

/// A name beside `path` that no other process of this machine uses now; in the same folder, so that renaming is atomic.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Flushes `temporary` to the disk and renames it to `path`; on failure removes it and leaves `path` as it was.
Result<void> commit_file(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// Writes `bytes` to `path` through a temporary file, fsync and rename.
Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// The bytes of a regular file of at most `limit` bytes.
Result<std::string> read_whole_file(const std::filesystem::path& path, size_t limit);

}  // namespace auslan
