// SPDX-License-Identifier: Apache-2.0
#include "media/picture_module.h"

#include "oiio_abi.h"

#include <array>
#include <cassert>
#include <climits>
#include <cstdlib>
#include <dlfcn.h>
#include <mutex>
#include <unistd.h>
#include <utility>

namespace auslan {

namespace {

constexpr const char* kModuleName = "libauslan_picture_oiio.so";
constexpr int kMaxSide = 16384;
constexpr size_t kErrorSize = 512;

struct Module {
  auslan_oiio_encode_png_fn encode_png = nullptr;
  auslan_oiio_decode_fn decode = nullptr;
  auslan_oiio_decode_image_fn decode_image = nullptr;
  auslan_oiio_gif_open_fn gif_open = nullptr;
  auslan_oiio_gif_write_fn gif_write = nullptr;
  auslan_oiio_gif_finish_fn gif_finish = nullptr;
  auslan_oiio_gif_close_fn gif_close = nullptr;
};

/// The folders in which the module may be, best first.
std::vector<std::string> module_folders() {
  const char* named = std::getenv("AUSLANJAM_MODULE_DIR");
  // Whoever names a folder means that folder and no other.
  if (named != nullptr && *named != '\0') return {named};
  std::array<char, PATH_MAX> self{};
  const ssize_t length = readlink("/proc/self/exe", self.data(), self.size() - 1);
  std::string folder = length > 0 ? std::string(self.data(), static_cast<size_t>(length)) : std::string("./program");
  folder.resize(folder.rfind('/') == std::string::npos ? 0 : folder.rfind('/'));
  return {folder, folder + "/../lib", folder + "/../lib/auslanjam"};
}

template <typename Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

Result<Module> bind(void* library, const std::string& path) {
  Module module;
  auslan_oiio_abi_fn abi = nullptr;
  if (!find(library, "auslan_oiio_abi", abi) || abi() != AUSLAN_OIIO_ABI ||
      !find(library, "auslan_oiio_encode_png", module.encode_png) ||
      !find(library, "auslan_oiio_decode", module.decode) ||
      !find(library, "auslan_oiio_decode_image", module.decode_image) ||
      !find(library, "auslan_oiio_gif_open", module.gif_open) ||
      !find(library, "auslan_oiio_gif_write", module.gif_write) ||
      !find(library, "auslan_oiio_gif_finish", module.gif_finish) ||
      !find(library, "auslan_oiio_gif_close", module.gif_close))
    return fail(ErrorCode::kUnsupported,
                "the picture module " + path + " is of another version; build or install again");
  return module;
}

Result<Module> load() {
  std::string looked_in, reason;
  for (const std::string& folder : module_folders()) {
    const std::string path = folder + "/" + kModuleName;
    looked_in += (looked_in.empty() ? "" : ", ") + folder;
    if (access(path.c_str(), F_OK) != 0) continue;
    // Never closed: OpenImageIO keeps threads and statics that do not survive it.
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library != nullptr) return bind(library, path);
    const char* said = dlerror();
    reason = said != nullptr ? said : "";
    break;
  }
  if (!reason.empty())
    return fail(ErrorCode::kUnsupported, "PNG and GIF need the picture module, which does not load: " + reason +
                                             "; install OpenImageIO (Debian: apt install libopenimageio2.4)");
  return fail(
      ErrorCode::kUnsupported,
      std::string("PNG and GIF need the picture module ") + kModuleName + ", which is not in " + looked_in +
          "; install OpenImageIO (Debian: apt install libopenimageio-dev) and build again, or name its folder in "
          "AUSLANJAM_MODULE_DIR; .y4m needs no module");
}

/// Loaded at the first call that succeeds: whoever installs the module while a long program runs is served. The module
/// is written once, under the lock, before any pointer to it is handed out.
Result<const Module*> module() {
  static std::mutex lock;
  static Module loaded;
  static bool is_loaded = false;
  const std::scoped_lock guard(lock);
  if (!is_loaded) {
    auto found = load();
    if (!found) return tl::unexpected(found.error());
    loaded = *found;
    is_loaded = true;
  }
  return &loaded;
}

int append(void* user, const uint8_t* bytes, size_t size) {
  auto* out = static_cast<std::vector<uint8_t>*>(user);
  out->insert(out->end(), bytes, bytes + size);
  return 0;
}

uint32_t* place(void* user, int width, int height) {
  auto* picture = static_cast<Picture*>(user);
  *picture = make_picture(width, height);
  return picture->pixels.data();
}

ErrorCode code_of(int status) {
  switch (status) {
    case AUSLAN_OIIO_MALFORMED:
      return ErrorCode::kMalformed;
    case AUSLAN_OIIO_LIMIT:
      return ErrorCode::kLimit;
    default:
      return ErrorCode::kUnsupported;
  }
}

}  // namespace

Result<void> load_picture_module() {
  auto loaded = module();
  if (!loaded) return tl::unexpected(loaded.error());
  return {};
}

Result<std::vector<uint8_t>> encode_png(FrameView frame) {
  if (!is_well_formed(frame)) return fail(ErrorCode::kUsage, "a picture's size does not agree with its pixels");
  const auto loaded = module();
  if (!loaded) return tl::unexpected(loaded.error());
  std::vector<uint8_t> bytes;
  std::array<char, kErrorSize> error{};
  const int status =
      (*loaded)->encode_png(frame.pixels.data(), frame.width, frame.height, append, &bytes, error.data(), error.size());
  if (status != AUSLAN_OIIO_OK)
    return fail(code_of(status), std::string("a picture cannot be encoded as PNG: ") + error.data());
  return bytes;
}

Result<Picture> decode_picture(std::span<const uint8_t> bytes, PictureFormat format, int subimage,
                               const std::string& name) {
  const auto loaded = module();
  if (!loaded) return tl::unexpected(loaded.error());
  Picture picture;
  std::array<char, kErrorSize> error{};
  const int status = (*loaded)->decode(bytes.data(), bytes.size(), format == PictureFormat::kPng ? "png" : "gif",
                                       subimage, kMaxSide, place, &picture, error.data(), error.size());
  if (status != AUSLAN_OIIO_OK)
    return fail(
        code_of(status),
        std::string("this picture cannot be read: ") + error.data() + "; replace it by one that this program wrote",
        name);
  return picture;
}

Result<Picture> decode_image(std::span<const uint8_t> bytes, ImageFormat format, size_t max_pixels,
                             const std::string& name) {
  const auto loaded = module();
  if (!loaded) return tl::unexpected(loaded.error());
  Picture picture;
  std::array<char, kErrorSize> error{};
  const int status = (*loaded)->decode_image(bytes.data(), bytes.size(), format == ImageFormat::kPng ? "png" : "jpeg",
                                             max_pixels, place, &picture, error.data(), error.size());
  if (status != AUSLAN_OIIO_OK)
    return fail(code_of(status), std::string("this image cannot be read: ") + error.data(), name);
  return picture;
}

Result<GifEncoder> GifEncoder::open(int width, int height, double fps) {
  const auto loaded = module();
  if (!loaded) return tl::unexpected(loaded.error());
  std::array<char, kErrorSize> error{};
  auslan_oiio_gif* gif = (*loaded)->gif_open(width, height, fps, error.data(), error.size());
  if (gif == nullptr) return fail(ErrorCode::kUnsupported, std::string("a GIF cannot be encoded: ") + error.data());
  return GifEncoder(gif);
}

GifEncoder::GifEncoder(GifEncoder&& other) noexcept : gif_(std::exchange(other.gif_, nullptr)) {}

GifEncoder::~GifEncoder() {
  if (gif_ == nullptr) return;
  const auto loaded = module();
  if (loaded) (*loaded)->gif_close(static_cast<auslan_oiio_gif*>(gif_));
}

Result<void> GifEncoder::write(FrameView frame, std::vector<uint8_t>& bytes) {
  const auto loaded = module();
  if (!loaded) return tl::unexpected(loaded.error());
  std::array<char, kErrorSize> error{};
  const int status = (*loaded)->gif_write(static_cast<auslan_oiio_gif*>(gif_), frame.pixels.data(), append, &bytes,
                                          error.data(), error.size());
  if (status != AUSLAN_OIIO_OK) return fail(code_of(status), std::string("a GIF cannot be encoded: ") + error.data());
  return {};
}

Result<void> GifEncoder::finish(std::vector<uint8_t>& bytes) {
  const auto loaded = module();
  if (!loaded) return tl::unexpected(loaded.error());
  std::array<char, kErrorSize> error{};
  const int status =
      (*loaded)->gif_finish(static_cast<auslan_oiio_gif*>(gif_), append, &bytes, error.data(), error.size());
  if (status != AUSLAN_OIIO_OK) return fail(code_of(status), std::string("a GIF cannot be encoded: ") + error.data());
  return {};
}

}  // namespace auslan
