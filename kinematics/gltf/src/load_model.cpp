// SPDX-License-Identifier: Apache-2.0
#include "load_model.h"

#include "container.h"
#include "gltf/figure_gltf.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace auslan::gltf {
namespace {

// What tinygltf calls in place of its own file and image functions.

bool file_exists(const std::string& path, void* folder) {
  return static_cast<Folder*>(folder)->holds(path);
}
std::string keep_path(const std::string& path, void*) {
  return path;
}
bool read_file(std::vector<unsigned char>* bytes, std::string*, const std::string& path, void* folder) {
  return static_cast<Folder*>(folder)->read(path, *bytes);
}
bool refuse_to_write(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
  return false;
}

/// Images may share bytes, so that a short file could ask for any number of copies.
struct Images {
  bool are_kept = false;
  uint64_t bytes_left = kMaxGltfBytes;
  std::optional<Error> error;
};

bool look_at_image(tinygltf::Image* image, int index, std::string*, std::string*, int, int, const unsigned char* bytes,
                   int length, void* user) {
  auto& images = *static_cast<Images*>(user);
  if (length < 0) return true;
  const auto size = static_cast<size_t>(length);
  const std::string place = place_of("images", index, "");
  if (is_image_too_large(bytes, size)) {
    images.error = Error{ErrorCode::kLimit, "the image is wider or taller than 8192 pixels; scale it down", place};
    return false;
  }
  if (!images.are_kept || (!is_png(bytes, size) && !is_jpeg(bytes, size))) return true;
  if (size > images.bytes_left) {
    images.error = Error{ErrorCode::kLimit, "the images exceed 64 MiB together; scale them down", place};
    return false;
  }
  images.bytes_left -= size;
  image->image.assign(bytes, bytes + size);
  return true;
}

}  // namespace

std::string place_of(const char* list, int index, const std::string& name) {
  return std::string(list) + "[" + std::to_string(index) + "]" + (name.empty() ? "" : " (" + name + ")");
}

std::string place_in_file(const std::filesystem::path& path, const std::string& place) {
  return place.empty() ? path.string() : path.string() + ": " + place;
}

Error error_of(const std::exception& exception) {
  return {ErrorCode::kMalformed,
          "the file breaks the glTF format (" + std::string(exception.what()) + "); export it again",
          {}};
}

Result<tinygltf::Model> load_model(std::span<const std::byte> bytes, const std::filesystem::path& path_of_folder,
                                   const LoadOptions& options) {
  const std::string_view text(static_cast<const char*>(static_cast<const void*>(bytes.data())), bytes.size());
  if (text.size() > kMaxGltfBytes) return fail(ErrorCode::kLimit, "the file is longer than 64 MiB; make it smaller");
  const auto container = open_container(text);
  if (!container) return tl::unexpected<Error>(container.error());
  if (auto checked = check_document(*container, options.known_extensions); !checked)
    return tl::unexpected<Error>(std::move(checked.error()));

  Folder folder(path_of_folder);
  Images images{.are_kept = options.keeps_images, .error = {}};
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks({&file_exists, &keep_path, &read_file, &refuse_to_write, &folder});
  loader.SetImageLoader(&look_at_image, &images);
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const auto size = static_cast<unsigned>(text.size());
  const bool is_loaded =
      container->is_glb
          ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                        static_cast<const unsigned char*>(static_cast<const void*>(bytes.data())), size,
                                        folder.base())
          : loader.LoadASCIIFromString(&model, &error, &warning, text.data(), size, folder.base());
  if (is_loaded) return model;
  if (images.error) return tl::unexpected<Error>(*images.error);
  if (folder.error()) return tl::unexpected<Error>(*folder.error());
  std::ranges::replace(error, '\n', ' ');
  return fail(ErrorCode::kMalformed, "the file breaks the glTF format (" + error + "); export it again");
}

}  // namespace auslan::gltf
