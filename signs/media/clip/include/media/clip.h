// SPDX-License-Identifier: Apache-2.0
// Clips: frames in, a film file out. The suffix of the path chooses the format.
//
//   .y4m               own code: YUV4MPEG2, 4:4:4, BT.601 limited range, exact integers (yuv.h)
//   .mp4 .webm .webp   the ffmpeg program, over a pipe: H.264, VP9, animated WebP; 4:2:0; odd sizes grow by one pixel
//   .gif               the picture module; at most 255 colours a frame, times rounded to 1/100 s
//   .png               the picture module; a numbered sequence out-0001.png, out-0002.png …, or one picture
#pragma once

#include "kinematics/result.h"
#include "media/frame.h"

#include <memory>
#include <string>

namespace auslan {

struct ClipFormat {
  int width = 0;  ///< pixels, 1 to 16384
  int height = 0;
  int fps_numerator = 25;
  int fps_denominator = 1;
  bool single_picture = false;  ///< .png only: exactly one frame, under the name of the path itself
};

/// Takes frames in order. Nothing is visible under the target's name before finish() succeeds; destroying the sink
/// earlier, or after a failure, removes whatever is unfinished and leaves an older file of that name alone.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  FrameSink(const FrameSink&) = delete;
  FrameSink& operator=(const FrameSink&) = delete;

  /// kUsage for a frame of another size; kUnwritable when the disk or the encoder fails. After a failure every further
  /// call fails.
  virtual Result<void> write(FrameView frame) = 0;
  /// Completes, syncs and renames. kUsage when no frame was written.
  virtual Result<void> finish() = 0;

 protected:
  FrameSink() = default;
};

/// Opens the sink for a path. kUsage: unknown suffix, impossible size or rate. kUnwritable: the folder. kNotFound: the
/// ffmpeg program is missing. kUnsupported: the picture module is not there. Each message says what to install or
/// change. The environment variable AUSLANJAM_FFMPEG names another ffmpeg program.
Result<std::unique_ptr<FrameSink>> open_clip(const std::string& path, const ClipFormat& format);

/// Whether open_clip knows the suffix of the path.
bool is_clip_path(const std::string& path);

}  // namespace auslan
