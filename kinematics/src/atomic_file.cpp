// SPDX-License-Identifier: Apache-2.0
#include "kinematics/atomic_file.h"

#include <array>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace auslan {

namespace {

std::string advice(int error_number) {
  switch (error_number) {
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a folder that you may write to";
    case ENOENT:
    case ENOTDIR:
      return "make the folder first, or correct the path";
    case EISDIR:
      return "that is a folder: name a file in it";
    case ENOSPC:
    case EDQUOT:
      return "free some space, or choose another disk";
    case EFBIG:
      return "the system limits the size of files (ulimit -f): raise the limit, or write less";
    case ENAMETOOLONG:
      return "choose a shorter name";
    default:
      return "check the disk, or choose another place";
  }
}

/// A name of fixed length, so that it fits wherever the target's own name fits; random, so that two programs that write
/// to one folder do not meet.
std::string temporary_name(const std::string& target) {
  std::array<unsigned char, 8> noise{};
  if (getrandom(noise.data(), noise.size(), 0) != static_cast<ssize_t>(noise.size())) {
    const long pid = getpid();
    std::memcpy(noise.data(), &pid, sizeof noise < sizeof pid ? sizeof noise : sizeof pid);
  }
  std::string name = ".auslanjam-";
  for (const unsigned char byte : noise) {
    name += static_cast<char>('a' + (byte >> 4));
    name += static_cast<char>('a' + (byte & 15));
  }
  const size_t slash = target.rfind('/');
  return (slash == std::string::npos ? "" : target.substr(0, slash + 1)) + name + ".part";
}

std::string folder_of(const std::string& path) {
  const size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

int open_again(const char* path, int flags, mode_t mode) {
  int descriptor = -1;
  do {
    descriptor = ::open(path, flags | O_CLOEXEC, mode);
  } while (descriptor < 0 && errno == EINTR);
  return descriptor;
}

}  // namespace

Error unwritable(const std::string& path, int error_number) {
  return Error{ErrorCode::kUnwritable,
               "cannot write " + path + ": " + std::strerror(error_number) + "; " + advice(error_number),
               {}};
}

Result<AtomicFile> AtomicFile::create(const std::string& path) {
  AtomicFile file;
  file.path_ = path;
  file.target_ = path;
  if (path.empty()) return fail(ErrorCode::kUnwritable, "the output has no name; give a path");
  if (path.find('\0') != std::string::npos) return fail(ErrorCode::kUnwritable, "the output's name holds a zero byte");
  if (path.back() == '/') return tl::unexpected(unwritable(path, EISDIR));

  struct stat info {};
  mode_t mode = 0666;
  if (::stat(path.c_str(), &info) == 0) {
    if (S_ISDIR(info.st_mode)) return tl::unexpected(unwritable(path, EISDIR));
    if (!S_ISREG(info.st_mode)) {
      file.descriptor_ = open_again(path.c_str(), O_WRONLY, 0);
      if (file.descriptor_ < 0) return tl::unexpected(unwritable(path, errno));
      return file;
    }
    if (::access(path.c_str(), W_OK) != 0) return tl::unexpected(unwritable(path, errno));
    mode = info.st_mode & 0777;
  }
  std::array<char, PATH_MAX> resolved{};
  if (::realpath(path.c_str(), resolved.data()) != nullptr) file.target_ = resolved.data();

  std::string name = temporary_name(file.target_);
  const int descriptor = open_again(name.c_str(), O_RDWR | O_CREAT | O_EXCL, mode);
  if (descriptor < 0) return tl::unexpected(unwritable(path, errno));
  file.descriptor_ = descriptor;
  file.temporary_ = std::move(name);
  return file;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      suspended_(std::exchange(other.suspended_, false)) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this != &other) {
    abandon();
    path_ = std::move(other.path_);
    target_ = std::move(other.target_);
    temporary_ = std::exchange(other.temporary_, {});
    descriptor_ = std::exchange(other.descriptor_, -1);
    suspended_ = std::exchange(other.suspended_, false);
  }
  return *this;
}

AtomicFile::~AtomicFile() {
  abandon();
}

void AtomicFile::abandon() noexcept {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
  suspended_ = false;
}

Result<void> AtomicFile::write(std::span<const uint8_t> bytes) {
  if (descriptor_ < 0) return fail(ErrorCode::kUsage, path_ + " is closed already");
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return tl::unexpected(unwritable(path_, errno));
    }
    bytes = bytes.subspan(static_cast<size_t>(written));
  }
  return {};
}

Result<void> AtomicFile::write(std::string_view text) {
  return write(std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()));
}

Result<void> AtomicFile::overwrite(uint64_t offset, std::string_view text) {
  if (descriptor_ < 0) return fail(ErrorCode::kUsage, path_ + " is closed already");
  if (temporary_.empty()) return tl::unexpected(unwritable(path_, ESPIPE));
  while (!text.empty()) {
    const ssize_t written = ::pwrite(descriptor_, text.data(), text.size(), static_cast<off_t>(offset));
    if (written < 0) {
      if (errno == EINTR) continue;
      return tl::unexpected(unwritable(path_, errno));
    }
    text.remove_prefix(static_cast<size_t>(written));
    offset += static_cast<uint64_t>(written);
  }
  return {};
}

Result<void> AtomicFile::suspend() {
  if (temporary_.empty() || suspended_) return {};
  int error = 0;
  if (::fsync(descriptor_) != 0) error = errno;
  if (::close(std::exchange(descriptor_, -1)) != 0 && error == 0) error = errno;
  if (error != 0) {
    abandon();
    return tl::unexpected(unwritable(path_, error));
  }
  suspended_ = true;
  return {};
}

Result<void> AtomicFile::commit() {
  if (descriptor_ < 0 && !suspended_) return fail(ErrorCode::kUsage, path_ + " is closed already");
  if (temporary_.empty()) {
    // A device or pipe: nothing to sync or rename.
    if (::close(std::exchange(descriptor_, -1)) != 0) return tl::unexpected(unwritable(path_, errno));
    return {};
  }
  if (auto synced = suspend(); !synced) return synced;
  suspended_ = false;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    const int error = errno;
    abandon();
    return tl::unexpected(unwritable(path_, error));
  }
  temporary_.clear();
  // The name is as durable as the bytes only once the folder is synced too; a file system that cannot is not a failure.
  const int folder = open_again(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY, 0);
  if (folder >= 0) {
    ::fsync(folder);
    ::close(folder);
  }
  return {};
}

}  // namespace auslan
