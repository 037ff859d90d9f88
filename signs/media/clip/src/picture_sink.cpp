// SPDX-License-Identifier: Apache-2.0
// Clips that the picture module encodes in memory: an animated GIF, a numbered sequence of PNGs, one PNG.
#include "kinematics/atomic_file.h"
#include "media/picture_module.h"
#include "sinks.h"

#include <optional>
#include <unistd.h>
#include <utility>
#include <vector>

namespace auslan {

namespace {

class GifSink final : public FrameSink {
 public:
  GifSink(AtomicFile file, GifEncoder encoder, const ClipFormat& format) : path_(file.path()), format_(format) {
    file_.emplace(std::move(file));
    encoder_.emplace(std::move(encoder));
  }

  Result<void> write(FrameView frame) override {
    if (!file_) return sink_is_closed(path_);
    auto done = check_frame(frame, format_, path_);
    bytes_.clear();
    if (done) done = encoder_->write(frame, bytes_);
    if (done) done = file_->write(bytes_);
    if (!done) abandon();
    ++frames_;
    return done;
  }

  Result<void> finish() override {
    if (!file_) return sink_is_closed(path_);
    bytes_.clear();
    auto done = frames_ > 0 ? encoder_->finish(bytes_) : Result<void>(no_frames(path_));
    if (done) done = file_->write(bytes_);
    if (done) done = file_->commit();
    abandon();
    return done;
  }

 private:
  void abandon() {
    encoder_.reset();
    file_.reset();
  }

  std::string path_;
  ClipFormat format_;
  std::optional<AtomicFile> file_;
  std::optional<GifEncoder> encoder_;
  std::vector<uint8_t> bytes_;
  int64_t frames_ = 0;
};

/// "out.png", 7 -> "out-0007.png"
std::string numbered(const std::string& path, size_t number) {
  std::string digits = std::to_string(number);
  if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
  const size_t dot = path.rfind('.');
  return path.substr(0, dot) + "-" + digits + path.substr(dot);
}

class PngSink final : public FrameSink {
 public:
  PngSink(std::string path, const ClipFormat& format) : path_(std::move(path)), format_(format) {}

  Result<void> write(FrameView frame) override {
    if (closed_) return sink_is_closed(path_);
    auto done = check_frame(frame, format_, path_);
    if (done && format_.single_picture && !written_.empty())
      done = fail(ErrorCode::kUsage, path_ + " takes one picture; ask for a numbered sequence to write more");
    if (done) done = append(frame);
    if (!done) abandon();
    return done;
  }

  Result<void> finish() override {
    if (closed_) return sink_is_closed(path_);
    Result<void> done;
    if (written_.empty()) done = no_frames(path_);
    std::vector<std::string> placed;
    for (AtomicFile& file : written_) {
      if (!done) break;
      done = file.commit();
      if (done) placed.push_back(file.path());
    }
    // Half a sequence under its final names is a partial result as well.
    if (!done)
      for (const std::string& name : placed)
        unlink(name.c_str());
    abandon();
    return done;
  }

 private:
  Result<void> append(FrameView frame) {
    auto bytes = encode_png(frame);
    if (!bytes) return tl::unexpected(bytes.error());
    auto file = AtomicFile::create(format_.single_picture ? path_ : numbered(path_, written_.size() + 1));
    if (!file) return tl::unexpected(file.error());
    if (auto wrote = file->write(*bytes); !wrote) return wrote;
    // Closed between, because a long sequence has more files than a process may hold open.
    if (auto closed = file->suspend(); !closed) return closed;
    written_.push_back(std::move(*file));
    return {};
  }

  void abandon() {
    written_.clear();
    closed_ = true;
  }

  std::string path_;
  ClipFormat format_;
  std::vector<AtomicFile> written_;
  bool closed_ = false;
};

}  // namespace

Result<std::unique_ptr<FrameSink>> open_gif(const std::string& path, const ClipFormat& format) {
  auto encoder =
      GifEncoder::open(format.width, format.height, static_cast<double>(format.fps_numerator) / format.fps_denominator);
  if (!encoder) return tl::unexpected(encoder.error());
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  return std::make_unique<GifSink>(std::move(*file), std::move(*encoder), format);
}

Result<std::unique_ptr<FrameSink>> open_png_sequence(const std::string& path, const ClipFormat& format) {
  if (auto loaded = load_picture_module(); !loaded) return tl::unexpected(loaded.error());
  // Tells about a bad folder now rather than after the first frame has been drawn.
  if (auto probe = AtomicFile::create(format.single_picture ? path : numbered(path, 1)); !probe)
    return tl::unexpected(probe.error());
  return std::make_unique<PngSink>(path, format);
}

}  // namespace auslan
