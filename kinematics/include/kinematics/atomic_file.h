// SPDX-License-Identifier: Apache-2.0
// An output file that appears whole or not at all: written to a temporary beside the target, synced, renamed.
#pragma once

#include "kinematics/result.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace auslan {

/// A file that is being written. Destroying it before commit() removes what was written and leaves the target as it
/// was. A target that exists and is a device or a pipe is written directly. A symbolic link is followed.
class AtomicFile {
 public:
  /// Creates the temporary. kUnwritable where the folder is missing or closed to us, or the target is a folder.
  static Result<AtomicFile> create(const std::string& path);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// Appends. kUnwritable (with the system's reason) when the disk is full or fails.
  Result<void> write(std::span<const uint8_t> bytes);
  Result<void> write(std::string_view text);
  /// Replaces bytes that were already written. kUnwritable on a device or pipe too.
  Result<void> overwrite(uint64_t offset, std::string_view text);
  /// Syncs and closes the temporary, which waits for commit(): for sets of files that appear together. Nothing more can
  /// be written. No effect on a device or pipe.
  Result<void> suspend();
  /// Syncs and renames onto the target. Afterwards the object is done.
  Result<void> commit();

  /// The target as the caller named it.
  const std::string& path() const { return path_; }
  /// Where the bytes are until commit(), for programs that want a name; empty when the target is written directly.
  const std::string& temporary_path() const { return temporary_; }

 private:
  AtomicFile() = default;
  void abandon() noexcept;

  std::string path_;
  std::string target_;     ///< path_ with symbolic links followed
  std::string temporary_;  ///< empty when written directly
  int descriptor_ = -1;
  bool suspended_ = false;
};

/// "cannot write PATH: REASON; ADVICE", from an errno value.
Error unwritable(const std::string& path, int error_number);

}  // namespace auslan
