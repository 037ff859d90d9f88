// SPDX-License-Identifier: Apache-2.0
#include "media/picture.h"

#include "kinematics/atomic_file.h"
#include "media/picture_module.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sys/stat.h>

namespace auslan {

namespace {

/// A PNG of 16384x16384 that does not compress at all is smaller.
constexpr size_t kMaxBytes = size_t{1} << 30;

Result<std::vector<uint8_t>> read_whole(const std::string& path) {
  struct stat info {};
  if (stat(path.c_str(), &info) != 0) {
    const ErrorCode code = errno == ENOENT || errno == ENOTDIR ? ErrorCode::kNotFound : ErrorCode::kUnreadable;
    return fail(code, std::string(std::strerror(errno)) + "; check the path", path);
  }
  if (!S_ISREG(info.st_mode)) return fail(ErrorCode::kUnreadable, "this is not a plain file; name a picture", path);
  if (static_cast<size_t>(info.st_size) > kMaxBytes)
    return fail(ErrorCode::kLimit, "this picture is above 1 GiB; name a smaller one", path);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) return fail(ErrorCode::kUnreadable, std::string(std::strerror(errno)) + "; check its rights", path);
  std::vector<uint8_t> bytes(static_cast<size_t>(info.st_size));
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  if (std::ferror(file.get()) != 0) return fail(ErrorCode::kUnreadable, "it cannot be read to its end", path);
  return bytes;
}

}  // namespace

Result<void> write_png(const std::string& path, FrameView frame) {
  if (!is_well_formed(frame))
    return fail(ErrorCode::kUsage, "cannot write " + path + ": the picture's size does not agree with its pixels");
  const auto bytes = encode_png(frame);
  if (!bytes) return tl::unexpected(bytes.error());
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  if (auto written = file->write(*bytes); !written) return written;
  return file->commit();
}

Result<Picture> read_png(const std::string& path) {
  const auto bytes = read_whole(path);
  if (!bytes) return tl::unexpected(bytes.error());
  constexpr std::array<uint8_t, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  if (bytes->size() < kSignature.size() || std::memcmp(bytes->data(), kSignature.data(), kSignature.size()) != 0)
    return fail(ErrorCode::kMalformed, "this is not a PNG; name a .png that this program wrote", path);
  return decode_picture(*bytes, PictureFormat::kPng, 0, path);
}

}  // namespace auslan
