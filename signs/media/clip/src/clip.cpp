// SPDX-License-Identifier: Apache-2.0
#include "media/clip.h"

#include "sinks.h"

#include <string_view>

namespace auslan {

namespace {

constexpr int kMaxSide = 16384;

/// The part from the last dot of the file's name, in lower case; empty when there is none.
std::string suffix_of(const std::string& path) {
  const size_t slash = path.rfind('/');
  const size_t name = slash == std::string::npos ? 0 : slash + 1;
  const size_t dot = path.rfind('.');
  if (dot == std::string::npos || dot <= name) return {};
  std::string suffix = path.substr(dot);
  for (char& c : suffix)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return suffix;
}

bool is_known(std::string_view suffix) {
  for (const std::string_view known : {".y4m", ".mp4", ".webm", ".webp", ".gif", ".png"})
    if (suffix == known) return true;
  return false;
}

}  // namespace

bool is_clip_path(const std::string& path) {
  return is_known(suffix_of(path));
}

Result<std::unique_ptr<FrameSink>> open_clip(const std::string& path, const ClipFormat& format) {
  const std::string suffix = suffix_of(path);
  if (!is_known(suffix))
    return fail(ErrorCode::kUsage,
                "cannot tell a clip's format from \"" + path + "\"; end it in .mp4, .webm, .gif, .webp, .y4m or .png");
  if (format.width < 1 || format.height < 1 || format.width > kMaxSide || format.height > kMaxSide)
    return fail(ErrorCode::kUsage, "a clip of " + std::to_string(format.width) + " by " +
                                       std::to_string(format.height) +
                                       " pixels cannot be written; choose a size from 1x1 to 16384x16384");
  if (format.fps_numerator < 1 || format.fps_denominator < 1 || format.fps_numerator / 1000 > format.fps_denominator)
    return fail(ErrorCode::kUsage, "a clip needs a rate above 0 and up to 1000 frames a second");
  if (format.single_picture && suffix != ".png")
    return fail(ErrorCode::kUsage, "a single picture must end in .png, not " + suffix);
  if (suffix == ".y4m") return open_y4m(path, format);
  if (suffix == ".gif") return open_gif(path, format);
  if (suffix == ".png") return open_png_sequence(path, format);
  return open_ffmpeg(path, suffix, format);
}

Result<void> check_frame(FrameView frame, const ClipFormat& format, const std::string& path) {
  if (frame.width == format.width && frame.height == format.height && is_well_formed(frame)) return {};
  return fail(ErrorCode::kUsage, path + ": a frame of " + std::to_string(frame.width) + "x" +
                                     std::to_string(frame.height) + " in a clip of " + std::to_string(format.width) +
                                     "x" + std::to_string(format.height) + "; keep the size the same throughout");
}

tl::unexpected<Error> sink_is_closed(const std::string& path) {
  return fail(ErrorCode::kUsage, path + ": the clip is finished, or failed before; open it again");
}

tl::unexpected<Error> no_frames(const std::string& path) {
  return fail(ErrorCode::kUsage, path + ": no frame was drawn, so there is no clip to write");
}

}  // namespace auslan
