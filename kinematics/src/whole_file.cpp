// SPDX-License-Identifier: Apache-2.0
#include "kinematics/whole_file.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace auslan {
namespace {

class FileDescriptor {
 public:
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor() { close(); }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  /// False if the system reports, as network disks do, that earlier writes failed.
  bool close() {
    const int number = std::exchange(number_, -1);
    return number < 0 || ::close(number) == 0;
  }

 private:
  int number_;
};

std::string reason(int error) {
  return std::generic_category().message(error);
}

tl::unexpected<Error> cannot_write(const std::filesystem::path& path, int error) {
  if (error == ENOSPC || error == EDQUOT)
    return fail(ErrorCode::kUnwritable, "the disk is full; free some space or choose another folder, then try again",
                path.string());
  return fail(ErrorCode::kUnwritable,
              "cannot write the file (" + reason(error) + "); choose a folder that exists and may be written",
              path.string());
}

/// 0, or the errno of the write that failed.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0 ? ENOSPC : errno;
    bytes.remove_prefix(static_cast<size_t>(count));
  }
  return 0;
}

}  // namespace

Result<std::string> read_whole_file(const std::filesystem::path& path, uint64_t max_bytes) {
  // O_NONBLOCK: opening a FIFO without a writer would wait for ever.
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open()) {
    const int error = errno;
    if (error == ENOENT || error == ENOTDIR)
      return fail(ErrorCode::kNotFound, "there is no such file; check the path", path.string());
    return fail(ErrorCode::kUnreadable, "cannot open the file (" + reason(error) + "); check its permissions",
                path.string());
  }
  struct stat status = {};
  if (::fstat(file.number(), &status) != 0)
    return fail(ErrorCode::kUnreadable, "cannot examine the file (" + reason(errno) + ")", path.string());
  if (!S_ISREG(status.st_mode))
    return fail(ErrorCode::kUnreadable, "this is a folder, a pipe or a device; name a regular file", path.string());
  if (static_cast<uint64_t>(status.st_size) > max_bytes)
    return fail(ErrorCode::kLimit,
                "the file has " + std::to_string(status.st_size) + " bytes, more than the " +
                    std::to_string(max_bytes) + " that are read; make it smaller",
                path.string());
  std::string bytes(static_cast<size_t>(status.st_size), '\0');
  size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t count = ::read(file.number(), bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return fail(ErrorCode::kUnreadable, "cannot read the file (" + reason(errno) + ")", path.string());
    if (count == 0) break;  // another program shortened it meanwhile
    filled += static_cast<size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

Result<void> write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code ignored;
  const std::filesystem::file_status before = std::filesystem::status(path, ignored);
  if (std::filesystem::exists(before) && !std::filesystem::is_regular_file(before))
    return fail(ErrorCode::kUnwritable, "a folder, a pipe or a device stands there; choose another name",
                path.string());

  std::filesystem::path temporary = path;
  temporary += ".part" + std::to_string(::getpid());
  ::unlink(temporary.c_str());  // left by a crashed process of the same number
  FileDescriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!file.is_open()) return cannot_write(path, errno);
  int error = write_all(file.number(), bytes);
  if (error == 0 && ::fsync(file.number()) != 0) error = errno;
  if (!file.close() && error == 0) error = errno;
  if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.c_str());
    return cannot_write(path, error);
  }
  // The rename itself lives in the folder. Some file systems cannot sync folders; the file is whole either way.
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  FileDescriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.is_open()) ::fsync(directory.number());
  return {};
}

}  // namespace auslan
