// SPDX-License-Identifier: Apache-2.0
#include "atomic_file.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace auslan {
namespace {

std::string reason(int error) {
  return std::generic_category().message(error);
}

tl::unexpected<Error> cannot_write(const std::filesystem::path& path, int error) {
  return fail(ErrorCode::kUnwritable,
              "cannot write it (" + reason(error) + "); check the folder, its permissions and the free space",
              path.string());
}

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }

 private:
  int fd_;
};

}  // namespace

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  std::filesystem::path temporary = path;
  temporary += ".tmp." + std::to_string(::getpid());
  return temporary;
}

Result<void> commit_file(const std::filesystem::path& temporary, const std::filesystem::path& path) {
  const auto give_up = [&temporary, &path](int error) {
    ::unlink(temporary.c_str());
    return cannot_write(path, error);
  };
  {
    const Descriptor file(::open(temporary.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0 || ::fsync(file.get()) != 0) return give_up(errno);
  }
  if (::rename(temporary.c_str(), path.c_str()) != 0) return give_up(errno);
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  // The rename itself is durable only when the folder is synced; some file systems refuse, and then it is good enough.
  const Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.get() >= 0) (void)::fsync(directory.get());
  return {};
}

Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  const std::filesystem::path temporary = temporary_beside(path);
  {
    const Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
    if (file.get() < 0) return cannot_write(path, errno);
    while (!bytes.empty()) {
      const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) {
        const int error = errno;
        ::unlink(temporary.c_str());
        return cannot_write(path, error);
      }
      bytes.remove_prefix(static_cast<size_t>(written));
    }
  }
  return commit_file(temporary, path);
}

Result<std::string> read_whole_file(const std::filesystem::path& path, size_t limit) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) {
    const ErrorCode code = errno == ENOENT ? ErrorCode::kNotFound : ErrorCode::kUnreadable;
    return fail(code, "cannot open it (" + reason(errno) + ")", path.string());
  }
  struct stat status {};
  if (::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode))
    return fail(ErrorCode::kUnreadable, "it is not a regular file", path.string());
  std::string bytes;
  char buffer[1 << 16];
  while (true) {
    const ssize_t got = ::read(file.get(), buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return fail(ErrorCode::kUnreadable, "cannot read it (" + reason(errno) + ")", path.string());
    if (got == 0) return bytes;
    bytes.append(buffer, static_cast<size_t>(got));
    if (bytes.size() > limit)
      return fail(ErrorCode::kLimit, "it is larger than " + std::to_string(limit) + " bytes; split it", path.string());
  }
}

}  // namespace auslan
