// SPDX-License-Identifier: Apache-2.0
// The sinks behind open_clip: each checks its own means (folder, program, module) when it is opened.
#pragma once

#include "media/clip.h"

#include <memory>
#include <string>

namespace auslan {

Result<std::unique_ptr<FrameSink>> open_y4m(const std::string& path, const ClipFormat& format);
/// `suffix` is ".mp4", ".webm" or ".webp".
Result<std::unique_ptr<FrameSink>> open_ffmpeg(const std::string& path, const std::string& suffix,
                                               const ClipFormat& format);
Result<std::unique_ptr<FrameSink>> open_gif(const std::string& path, const ClipFormat& format);
Result<std::unique_ptr<FrameSink>> open_png_sequence(const std::string& path, const ClipFormat& format);

/// kUsage when the frame is not what the format says.
Result<void> check_frame(FrameView frame, const ClipFormat& format, const std::string& path);
/// The failure of a sink that is finished or has failed before.
tl::unexpected<Error> sink_is_closed(const std::string& path);
tl::unexpected<Error> no_frames(const std::string& path);

}  // namespace auslan
