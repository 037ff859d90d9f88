// SPDX-License-Identifier: Apache-2.0
#include "container.h"

#include "gltf/figure_gltf.h"
#include "gltf_format.h"
#include "kinematics/little_endian.h"
#include "kinematics/whole_file.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

namespace auslan::gltf {
namespace {

// The parser that tinygltf uses, so that both see the same document where keys are doubled.
using Json = nlohmann::json;

tl::unexpected<Error> malformed(std::string message, std::string place) {
  return fail(ErrorCode::kMalformed, std::move(message), std::move(place));
}

std::string byte(size_t offset) {
  return "byte " + std::to_string(offset);
}
std::string element(const char* list, size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

/// Strings are skipped, so that brackets in them do not count; everything else is left to the parser.
Result<void> scan_json(std::string_view json) {
  int depth = 0;
  size_t values = 0;
  bool in_string = false;
  for (size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_string) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (c == '[' || c == '{' || c == ',') ++values;
    if (depth > kMaxJsonDepth)
      return fail(ErrorCode::kLimit, "the JSON is nested deeper than 64 levels; remove the nested extras", byte(i));
    if (values > kMaxJsonValues)
      return fail(ErrorCode::kLimit, "the JSON has more than 200000 values; remove extras and unused parts", byte(i));
  }
  return {};
}

/// A member, or null where the object lacks it or is none.
const Json& member(const Json& object, const char* key) {
  static const Json kNull;
  if (!object.is_object()) return kNull;
  const auto found = object.find(key);
  return found == object.end() ? kNull : *found;
}

/// The elements of a list member: empty where it is missing; anything but a list is malformed.
Result<const Json*> list(const Json& document, const char* key) {
  static const Json kEmpty = Json::array();
  const Json& found = member(document, key);
  if (found.is_null()) return &kEmpty;
  if (!found.is_array()) return malformed(std::string(key) + " must be a list", key);
  return &found;
}

/// A whole number from 0 to kMaxGltfBytes, or `otherwise` where it is missing.
std::optional<uint64_t> size_member(const Json& object, const char* key, std::optional<uint64_t> otherwise) {
  const Json& found = member(object, key);
  if (found.is_null()) return otherwise;
  if (!found.is_number_unsigned() || found.get<uint64_t>() > kMaxGltfBytes) return std::nullopt;
  return found.get<uint64_t>();
}

bool is_hex(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

int hex_value(char c) {
  if (c <= '9') return c - '0';
  return (c <= 'F' ? c - 'A' : c - 'a') + 10;
}

/// The path a relative URI names, or nothing for a URI that is absolute, climbs out, or is badly escaped.
std::optional<std::string> relative_path(std::string_view uri) {
  std::string path;
  for (size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      path += uri[i];
      continue;
    }
    if (i + 2 >= uri.size() || !is_hex(uri[i + 1]) || !is_hex(uri[i + 2])) return std::nullopt;
    path += static_cast<char>(hex_value(uri[i + 1]) * 16 + hex_value(uri[i + 2]));
    i += 2;
  }
  const bool has_foreign = path.find_first_of(std::string_view("\0:\\~", 4)) != std::string::npos;
  if (path.empty() || path.front() == '/' || has_foreign) return std::nullopt;
  for (const std::filesystem::path& part : std::filesystem::path(path))
    if (part == "..") return std::nullopt;
  return path;
}

Result<void> check_uri(const Json& uri, const std::string& place) {
  if (!uri.is_string()) return malformed("the uri must be a text", place);
  const auto& text = uri.get_ref<const std::string&>();
  if (text.starts_with("data:") || relative_path(text)) return {};
  return fail(ErrorCode::kUnsupported,
              "the uri leaves the folder of the file; put the file it names beside this one, or export as .glb", place);
}

Result<void> check_buffers(const Json& buffers, bool is_glb) {
  if (buffers.size() > kMaxBuffers)
    return fail(ErrorCode::kLimit, "there are more than 16 buffers; export as .glb", "buffers");
  uint64_t total = 0;
  for (size_t i = 0; i < buffers.size(); ++i) {
    const std::optional<uint64_t> length = size_member(buffers[i], "byteLength", std::nullopt);
    if (!length || *length == 0)
      return malformed("byteLength must be a number from 1 to " + std::to_string(kMaxGltfBytes), element("buffers", i));
    total += *length;
    const Json& uri = member(buffers[i], "uri");
    if (uri.is_null()) {
      if (!is_glb || i > 0) return malformed("the buffer has no uri and is not that of a .glb", element("buffers", i));
      continue;
    }
    if (auto checked = check_uri(uri, element("buffers", i)); !checked) return checked;
  }
  if (total > kMaxGltfBytes) return fail(ErrorCode::kLimit, "the buffers exceed 64 MiB together", "buffers");
  return {};
}

/// tinygltf hands out the bytes of an image without asking whether the buffer has them.
Result<void> check_images(const Json& images, const Json& views, const Json& buffers) {
  for (size_t i = 0; i < images.size(); ++i) {
    const std::string place = element("images", i);
    if (const Json& uri = member(images[i], "uri"); !uri.is_null()) {
      if (auto checked = check_uri(uri, place); !checked) return checked;
    }
    if (member(images[i], "bufferView").is_null()) continue;
    const std::optional<uint64_t> view = size_member(images[i], "bufferView", std::nullopt);
    if (!view || *view >= views.size()) return malformed("the image names a bufferView that does not exist", place);
    const std::optional<uint64_t> buffer = size_member(views[*view], "buffer", std::nullopt);
    const std::optional<uint64_t> offset = size_member(views[*view], "byteOffset", 0);
    const std::optional<uint64_t> length = size_member(views[*view], "byteLength", std::nullopt);
    if (!buffer || *buffer >= buffers.size() || !offset || !length || *length == 0 ||
        *offset + *length > size_member(buffers[*buffer], "byteLength", 0).value_or(0))
      return malformed("the bufferView of the image lies outside its buffer", place);
  }
  return {};
}

Result<void> check_version_and_extensions(const Json& document, std::span<const std::string_view> known) {
  const Json& version = member(member(document, "asset"), "version");
  if (!version.is_string()) return malformed("asset.version is missing; this is not glTF", "asset");
  if (!version.get_ref<const std::string&>().starts_with("2."))
    return fail(ErrorCode::kUnsupported, "this is not glTF 2; export it again as glTF 2.0", "asset");
  const auto required = list(document, "extensionsRequired");
  if (!required) return tl::unexpected<Error>(required.error());
  for (const Json& extension : **required) {
    const std::string name = extension.is_string() ? extension.get<std::string>() : "an extension";
    if (std::ranges::find(known, name) == known.end())
      return fail(ErrorCode::kUnsupported,
                  "the file requires " + name + ", which is not read; export without extensions or compression",
                  "extensionsRequired");
  }
  return {};
}

uint32_t big_endian(const unsigned char* bytes, int count) {
  uint32_t value = 0;
  for (int i = 0; i < count; ++i)
    value = value << 8U | bytes[i];
  return value;
}

}  // namespace

Result<Container> open_container(std::string_view bytes) {
  if (!bytes.starts_with(kGlbMagic)) {
    const size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || bytes[first] != '{')
      return malformed("this is neither .glb nor .gltf; name a glTF 2.0 file", byte(0));
    return Container{.json = bytes, .is_glb = false};
  }
  if (bytes.size() < kGlbHeaderBytes + kChunkHeaderBytes) return malformed("the file is cut short", byte(bytes.size()));
  const auto word = [&](size_t at) { return load_little_endian<uint32_t>(bytes.data() + at); };
  if (word(4) != kGlbVersion)
    return fail(ErrorCode::kUnsupported, "this is not glTF 2; export it again as glTF 2.0", byte(4));
  if (word(8) != bytes.size())
    return malformed("the file has " + std::to_string(bytes.size()) + " bytes but states " + std::to_string(word(8)) +
                         "; copy it again",
                     byte(8));
  Container container{.json = {}, .is_glb = true};
  int chunks = 0;
  for (size_t at = kGlbHeaderBytes; at < bytes.size(); ++chunks) {
    if (bytes.size() - at < kChunkHeaderBytes) return malformed("a chunk is cut short", byte(at));
    const uint64_t length = word(at);
    if (length % 4 != 0 || length > bytes.size() - at - kChunkHeaderBytes)
      return malformed("the length of a chunk does not fit the file", byte(at));
    if (chunks == 0) {
      if (word(at + 4) != kJsonChunk) return malformed("the first chunk is not JSON", byte(at + 4));
      container.json = bytes.substr(at + kChunkHeaderBytes, length);
    }
    at += kChunkHeaderBytes + length;
  }
  return container;
}

Result<void> check_document(const Container& container, std::span<const std::string_view> known) {
  if (auto scanned = scan_json(container.json); !scanned) return scanned;
  try {
    const Json document = Json::parse(container.json);
    if (!document.is_object()) return malformed("the JSON is not an object", byte(0));
    if (auto checked = check_version_and_extensions(document, known); !checked) return checked;
    const auto buffers = list(document, "buffers");
    const auto views = list(document, "bufferViews");
    const auto images = list(document, "images");
    for (const auto* found : {&buffers, &views, &images})
      if (!*found) return tl::unexpected<Error>(found->error());
    if (auto checked = check_buffers(**buffers, container.is_glb); !checked) return checked;
    return check_images(**images, **views, **buffers);
  } catch (const Json::parse_error& error) {
    return malformed("the JSON is broken; export the file again", "JSON " + byte(error.byte));
  }
}

bool is_png(const unsigned char* bytes, size_t size) {
  constexpr std::array<unsigned char, 8> kMagic = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  return size >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), bytes);
}

bool is_jpeg(const unsigned char* bytes, size_t size) {
  return size >= 2 && bytes[0] == 0xFF && bytes[1] == 0xD8;
}

bool is_image_too_large(const unsigned char* bytes, size_t size) {
  constexpr size_t kPngHeaderBytes = 24;
  if (is_png(bytes, size))
    return size >= kPngHeaderBytes && std::max(big_endian(bytes + 16, 4), big_endian(bytes + 20, 4)) > kMaxImageSide;
  if (!is_jpeg(bytes, size)) return false;
  for (size_t at = 2; at + 9 <= size && bytes[at] == 0xFF;) {
    const unsigned char marker = bytes[at + 1];
    const bool is_frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (is_frame) return std::max(big_endian(bytes + at + 5, 2), big_endian(bytes + at + 7, 2)) > kMaxImageSide;
    at += 2 + big_endian(bytes + at + 2, 2);
  }
  return false;
}

Folder::Folder(const std::filesystem::path& folder)
    : base_((folder.empty() ? std::filesystem::path(".") : folder).string()), bytes_left_(2 * kMaxGltfBytes) {
  if (!base_.ends_with('/')) base_ += '/';
  std::error_code error;
  folder_ = std::filesystem::canonical(base_, error);
}

bool Folder::holds(const std::string& path) {
  if (!path.starts_with(base_)) return false;
  std::error_code error;
  const std::filesystem::path found = std::filesystem::canonical(path, error);
  if (error || folder_.empty()) {
    error_ = Error{ErrorCode::kNotFound, "a file that this one names is missing; put it in the same folder", path};
    return false;
  }
  const auto [in_folder, in_found] = std::mismatch(folder_.begin(), folder_.end(), found.begin(), found.end());
  if (in_folder == folder_.end() && in_found != found.end()) return true;
  error_ = Error{ErrorCode::kUnsupported, "a file that this one names lies outside its folder; put it inside", path};
  return false;
}

bool Folder::read(const std::string& path, std::vector<unsigned char>& bytes) {
  if (!holds(path)) return false;
  auto content = read_whole_file(path, bytes_left_);
  if (!content) {
    error_ = std::move(content.error());
    return false;
  }
  bytes_left_ -= content->size();
  bytes.assign(content->begin(), content->end());
  return true;
}

}  // namespace auslan::gltf
