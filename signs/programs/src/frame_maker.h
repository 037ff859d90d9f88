// SPDX-License-Identifier: Apache-2.0
// The frames of a show: body, caption and the mark of what nobody has checked.
#pragma once

#include "media/caption.h"
#include "media/frame.h"
#include "media/picture.h"
#include "session.h"
#include "stage/stage.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace auslan {

struct FrameOptions {
  StageOptions stage;
  bool caption = false;
  bool mark_unreviewed = true;
};

/// Draws single frames. One thread at a time; makers of the same show and figure are independent.
class FrameMaker {
 public:
  static Result<FrameMaker> build(const Body& body, const Show& show, const FrameOptions& options);

  /// Draws what is to be seen at a time. `frame` has the size of the stage.
  void make(Tick time, FrameSpan frame);

  /// The same pixels with less work, for a window: `frame` holds what the last call of update left in it, or anything
  /// at the first. Returns where it was written; valid until the next call.
  std::span<const PixelRect> update(Tick time, FrameSpan frame);

 private:
  /// The text on a frame; null where there is none.
  struct Writing {
    const std::string* sentence = nullptr;
    const std::string* gloss = nullptr;
    bool mark = false;
    bool in_upper_rows() const { return gloss != nullptr || mark; }
    bool operator==(const Writing&) const = default;
  };
  FrameMaker(Stage stage, CaptionPainter painter, const Show& show, const FrameOptions& options);
  Writing writing_at(Tick time) const;
  void write(const Writing& writing, FrameSpan frame) const;

  Stage stage_;
  CaptionPainter painter_;
  const Show* show_;
  FrameOptions options_;
  Pose pose_;
  // Of update: the figure without text, which the stage adds to and the text is taken off with.
  Picture figure_;
  bool figure_kept_ = false;  ///< figure_ holds what the stage rendered last
  Writing written_;
  std::vector<PixelRect> changed_;
};

/// How many frames a show has at a rate: the last one shows its end.
int64_t frame_count(const Show& show, int fps);
/// The time of a frame.
inline Tick frame_time(int64_t frame, int fps) {
  return frame * kTicksPerSecond / fps;
}

}  // namespace auslan
