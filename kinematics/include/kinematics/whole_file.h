// SPDX-License-Identifier: Apache-2.0
// Files as one piece: read whole under a stated bound, written so that a reader finds the old bytes or the new ones and
// never a half.
#pragma once

#include "kinematics/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace auslan {

/// The bytes of a regular file. Never waits: a FIFO, a device, a socket or a folder is refused (kUnreadable).
/// Errors: kNotFound, kUnreadable, kLimit if the file is longer than `max_bytes`. `place` is the path.
Result<std::string> read_whole_file(const std::filesystem::path& path, uint64_t max_bytes);

/// Replaces `path` by a file of these bytes: a temporary beside it, fsync, rename, fsync of the folder. After an error
/// the temporary is gone and what stood at `path` is untouched.
/// Errors: kUnwritable; the message names the path and the reason, a full disk for one.
Result<void> write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace auslan
