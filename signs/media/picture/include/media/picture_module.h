// SPDX-License-Identifier: Apache-2.0
// Encoding and decoding in memory through the picture module, for the writers of pictures and clips. Programs want
// picture.h.
#pragma once

#include "kinematics/result.h"
#include "media/frame.h"
#include "media/picture.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace auslan {

/// Loads the module if need be. kUnsupported (what to install, where it was looked for) when that fails. Safe from any
/// thread.
Result<void> load_picture_module();

/// The bytes of a PNG.
Result<std::vector<uint8_t>> encode_png(FrameView frame);

enum class PictureFormat { kPng, kGif };
/// Frame `subimage` of a picture in memory, as read_png says. `name` stands for it in messages.
Result<Picture> decode_picture(std::span<const uint8_t> bytes, PictureFormat format, int subimage,
                               const std::string& name);

enum class ImageFormat { kPng, kJpeg };
/// An image with transparency, as figures bring them: 0xAARRGGBB, sRGB-encoded, colours not multiplied by alpha, the
/// top row first. kLimit beyond `max_pixels`. A JPEG's pixels are those of the installed library, which other versions
/// may round otherwise.
Result<Picture> decode_image(std::span<const uint8_t> bytes, ImageFormat format, size_t max_pixels,
                             const std::string& name);

/// An animated GIF in memory. Bytes come out as frames go in.
class GifEncoder {
 public:
  static Result<GifEncoder> open(int width, int height, double fps);
  GifEncoder(GifEncoder&& other) noexcept;
  GifEncoder& operator=(GifEncoder&&) = delete;
  ~GifEncoder();

  /// Appends what is ready to `bytes`.
  Result<void> write(FrameView frame, std::vector<uint8_t>& bytes);
  Result<void> finish(std::vector<uint8_t>& bytes);

 private:
  explicit GifEncoder(void* gif) : gif_(gif) {}
  void* gif_ = nullptr;
};

}  // namespace auslan
