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
  static Result<FrameMaker> build(const Figure& figure, const Show& show, const FrameOptions& options);

  /// Draws what is to be seen at a time. `frame` has the size of the stage.
  void make(Tick time, FrameSpan frame);

 private:
  FrameMaker(Stage stage, CaptionPainter painter, const Show& show, const FrameOptions& options);

  Stage stage_;
  CaptionPainter painter_;
  const Show* show_;
  FrameOptions options_;
  Pose pose_;
};

/// How many frames a show has at a rate: the last one shows its end.
int64_t frame_count(const Show& show, int fps);
/// The time of a frame.
inline Tick frame_time(int64_t frame, int fps) {
  return frame * kTicksPerSecond / fps;
}

}  // namespace auslan
