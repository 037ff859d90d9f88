// SPDX-License-Identifier: Apache-2.0
// YUV4MPEG2: a line of text, then for each frame the word FRAME and its three planes. The matrix has no field in it;
// readers assume BT.601.
#include "kinematics/atomic_file.h"
#include "media/yuv.h"
#include "sinks.h"

#include <optional>
#include <utility>
#include <vector>

namespace auslan {

namespace {

class Y4mSink final : public FrameSink {
 public:
  Y4mSink(AtomicFile file, const ClipFormat& format) : file_(std::move(file)), format_(format) {}

  Result<void> write(FrameView frame) override {
    if (!file_) return sink_is_closed("the y4m clip");
    if (auto checked = check_frame(frame, format_, file_->path()); !checked) return abandon(checked);
    if (auto written = file_->write("FRAME\n"); !written) return abandon(written);
    to_yuv444(frame, YuvMatrix::kBt601, planes_);
    if (auto written = file_->write(planes_); !written) return abandon(written);
    ++frames_;
    return {};
  }

  Result<void> finish() override {
    if (!file_) return sink_is_closed("the y4m clip");
    auto done = frames_ > 0 ? file_->commit() : Result<void>(no_frames(file_->path()));
    file_.reset();
    return done;
  }

 private:
  Result<void> abandon(Result<void> failure) {
    file_.reset();
    return failure;
  }

  std::optional<AtomicFile> file_;
  ClipFormat format_;
  std::vector<uint8_t> planes_;
  int64_t frames_ = 0;
};

}  // namespace

Result<std::unique_ptr<FrameSink>> open_y4m(const std::string& path, const ClipFormat& format) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  const std::string header = "YUV4MPEG2 W" + std::to_string(format.width) + " H" + std::to_string(format.height) +
                             " F" + std::to_string(format.fps_numerator) + ":" +
                             std::to_string(format.fps_denominator) + " Ip A1:1 C444 XCOLORRANGE=LIMITED\n";
  if (auto written = file->write(header); !written) return tl::unexpected(written.error());
  return std::make_unique<Y4mSink>(std::move(*file), format);
}

}  // namespace auslan
