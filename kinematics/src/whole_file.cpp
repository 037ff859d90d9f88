// SPDX-License-Identifier: Apache-2.0
#include "kinematics/whole_file.h"

#include "kinematics/atomic_file.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace auslan {
namespace {

class FileDescriptor {
 public:
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

std::string reason(int error) {
  return std::generic_category().message(error);
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
  auto file = AtomicFile::create(path.string());
  if (!file) return tl::unexpected(file.error());
  if (auto written = file->write(bytes); !written) return written;
  return file->commit();
}

}  // namespace auslan
