// SPDX-License-Identifier: Apache-2.0
#include "frame_maker.h"

#include <algorithm>
#include <string>
#include <utility>

namespace auslan {
namespace {

constexpr std::string_view kMark = "not checked by a Deaf signer";
constexpr uint32_t kMarkColour = 0x8A3B12;
constexpr uint32_t kGlossColour = 0x26343D;

}  // namespace

int64_t frame_count(const Show& show, int fps) {
  return (show.end * fps + kTicksPerSecond - 1) / kTicksPerSecond + 1;
}

FrameMaker::FrameMaker(Stage stage, CaptionPainter painter, const Show& show, const FrameOptions& options)
    : stage_(std::move(stage)), painter_(std::move(painter)), show_(&show), options_(options) {}

Result<FrameMaker> FrameMaker::build(const Figure& figure, const Show& show, const FrameOptions& options) {
  auto stage = Stage::build(figure, options.stage);
  if (!stage) return tl::unexpected(stage.error());
  auto painter = CaptionPainter::open();
  if (!painter) return tl::unexpected(painter.error());
  return FrameMaker(std::move(*stage), std::move(*painter), show, options);
}

void FrameMaker::make(Tick time, FrameSpan frame) {
  show_->sample(time, pose_);
  stage_.render(pose_, frame.pixels);
  const int size = std::clamp(frame.height / 24, 9, 96);
  // The entry that is on the hands, or the last one that was; before the first, the first.
  const auto& glosses = show_->glosses;
  const auto next = std::upper_bound(glosses.begin(), glosses.end(), time,
                                     [](Tick t, const GlossSpan& span) { return t < span.begin; });
  const size_t current = next == glosses.begin() ? 0 : static_cast<size_t>(next - glosses.begin()) - 1;
  if (options_.caption && !glosses.empty()) {
    if (current < show_->sentence_of_gloss.size()) {
      CaptionStyle style;
      style.size_px = size;
      style.margin_px = size / 2;
      painter_.paint(frame, show_->sentences[static_cast<size_t>(show_->sentence_of_gloss[current])], style);
    }
    const GlossSpan& gloss = glosses[current];
    if (time >= gloss.begin && time <= gloss.end)
      painter_.text(frame, frame.width - size / 2, size / 2 + painter_.ascent(size * 3 / 4), gloss.label, size * 3 / 4,
                    kGlossColour, TextAlign::kRight);
  }
  if (options_.mark_unreviewed && !show_->reviewed) {
    const int small = std::max(8, size * 5 / 8);
    painter_.text(frame, small, small / 2 + painter_.ascent(small), kMark, small, kMarkColour);
  }
}

}  // namespace auslan
