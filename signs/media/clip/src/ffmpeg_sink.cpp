// SPDX-License-Identifier: Apache-2.0
// Clips through the ffmpeg program. It is given planes in Y'CbCr that we computed ourselves, so that no conversion of
// its own (which differs between processors) touches the colours.
#include "encoder_process.h"
#include "kinematics/atomic_file.h"
#include "media/yuv.h"
#include "sinks.h"

#include <cerrno>
#include <cstdlib>
#include <optional>
#include <sys/stat.h>
#include <utility>
#include <vector>

namespace auslan {

namespace {

std::string program() {
  const char* named = std::getenv("AUSLANJAM_FFMPEG");
  return named != nullptr && *named != '\0' ? named : "ffmpeg";
}

/// WebP knows BT.601 only; the others carry their matrix.
YuvMatrix matrix_of(const std::string& suffix) {
  return suffix == ".webp" ? YuvMatrix::kBt601 : YuvMatrix::kBt709;
}

std::vector<std::string> command_line(const std::string& suffix, const ClipFormat& format, const std::string& output) {
  const std::string rate = std::to_string(format.fps_numerator) + "/" + std::to_string(format.fps_denominator);
  const std::string size =
      std::to_string((format.width + 1) / 2 * 2) + "x" + std::to_string((format.height + 1) / 2 * 2);
  // -xerror: otherwise a disk that fills while the index is written still ends with status 0.
  std::vector<std::string> line = {
      program(), "-nostdin", "-hide_banner", "-loglevel", "error",       "-xerror", "-y",
      "-f",      "rawvideo", "-pix_fmt",     "yuv420p",   "-video_size", size,      "-framerate",
      rate,      "-i",       "pipe:0",       "-an",       "-pix_fmt",    "yuv420p", "-map_metadata",
      "-1",      "-fflags",  "+bitexact",    "-flags:v",  "+bitexact"};
  const auto add = [&line](std::initializer_list<const char*> arguments) {
    for (const char* argument : arguments)
      line.emplace_back(argument);
  };
  if (suffix == ".mp4") {
    add({"-c:v", "libx264", "-preset", "medium", "-crf", "20", "-movflags", "+faststart"});
  } else if (suffix == ".webm") {
    add({"-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-deadline", "good", "-cpu-used", "4", "-row-mt", "1"});
  } else {
    add({"-c:v", "libwebp_anim", "-quality", "85", "-loop", "0"});
  }
  if (matrix_of(suffix) == YuvMatrix::kBt709) {
    add({"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv",
         "-chroma_sample_location", "center"});
  }
  add({"-f", suffix == ".mp4" ? "mp4" : suffix == ".webm" ? "webm" : "webp"});
  // "file:" so that nothing in the path is taken for a protocol or an option.
  line.push_back("file:" + output);
  return line;
}

class FfmpegSink final : public FrameSink {
 public:
  FfmpegSink(AtomicFile file, EncoderProcess process, const ClipFormat& format, YuvMatrix matrix)
      : path_(file.path()), format_(format), matrix_(matrix) {
    // Built in this order so that the program is gone before its file is removed.
    file_.emplace(std::move(file));
    process_.emplace(std::move(process));
  }
  ~FfmpegSink() override { abandon(); }

  Result<void> write(FrameView frame) override {
    if (!process_) return sink_is_closed(path_);
    if (auto checked = check_frame(frame, format_, path_); !checked) {
      abandon();
      return checked;
    }
    to_yuv420(frame, matrix_, planes_);
    if (!process_->write(planes_)) {
      process_->finish();
      return give_up();
    }
    ++frames_;
    return {};
  }

  Result<void> finish() override {
    if (!process_) return sink_is_closed(path_);
    if (frames_ == 0) {
      abandon();
      return no_frames(path_);
    }
    struct stat info {};
    if (!process_->finish() || stat(file_->temporary_path().c_str(), &info) != 0 || info.st_size == 0) return give_up();
    process_.reset();
    auto done = file_->commit();
    file_.reset();
    return done;
  }

 private:
  void abandon() {
    process_.reset();
    file_.reset();
  }

  Result<void> give_up() {
    std::string message = "cannot write " + path_ + ": ffmpeg stopped (" + process_->how_it_ended() + ")";
    const std::string words = process_->last_words();
    if (!words.empty()) message += " and said: " + words;
    message += "; check the free space and that this ffmpeg has the encoder, or write a .y4m";
    abandon();
    return fail(ErrorCode::kUnwritable, message);
  }

  std::string path_;
  ClipFormat format_;
  YuvMatrix matrix_;
  std::optional<AtomicFile> file_;
  std::optional<EncoderProcess> process_;
  std::vector<uint8_t> planes_;
  int64_t frames_ = 0;
};

}  // namespace

Result<std::unique_ptr<FrameSink>> open_ffmpeg(const std::string& path, const std::string& suffix,
                                               const ClipFormat& format) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  if (file->temporary_path().empty())
    return fail(ErrorCode::kUnwritable, path + " is a device or a pipe, and a " + suffix +
                                            " must be able to go back in the file; name a plain file, or use .y4m");
  auto process = EncoderProcess::start(command_line(suffix, format, file->temporary_path()));
  if (!process)
    return fail(process.error().code, "cannot write " + path + ": " + process.error().message +
                                          "; install it (Debian: apt install ffmpeg), or write a .y4m");
  return std::make_unique<FfmpegSink>(std::move(*file), std::move(*process), format, matrix_of(suffix));
}

}  // namespace auslan
