// SPDX-License-Identifier: Apache-2.0
#include "frame_maker.h"

#include <algorithm>
#include <string>
#include <utility>

namespace auslan {
namespace {

constexpr std::string_view kMark = "not checked by a Deaf signer";

/// Mark and gloss stand straight on the background, light on a dark one.
struct TextColours {
  explicit TextColours(uint32_t background) {
    const uint32_t red = background >> 16U & 255U, green = background >> 8U & 255U, blue = background & 255U;
    if (3 * red + 6 * green + blue >= 10 * kLight) return;
    mark = 0xFFD8B4;
    gloss = 0xF4F7F9;
  }
  static constexpr uint32_t kLight = 150;  ///< of 255
  uint32_t mark = 0x8A3B12, gloss = 0x26343D;
};

/// In pixels, from the height of the frame.
struct TextSizes {
  explicit TextSizes(int frame_height)
      : text(std::clamp(frame_height / 24, 9, 96)), gloss(text * 3 / 4), mark(std::max(8, text * 5 / 8)) {
    caption.size_px = text;
    caption.margin_px = text / 2;
  }
  int text, gloss, mark;
  CaptionStyle caption;
};

/// The rows at the top that gloss and mark are written in: two lines of text, of which the second is air.
int upper_rows(int frame_height, const CaptionPainter& painter) {
  const TextSizes sizes(frame_height);
  return std::min(frame_height, sizes.text / 2 + 2 * painter.line_height(std::max(sizes.gloss, sizes.mark)));
}

}  // namespace

int64_t frame_count(const Show& show, int fps) {
  return (show.end * fps + kTicksPerSecond - 1) / kTicksPerSecond + 1;
}

FrameMaker::FrameMaker(Stage stage, CaptionPainter painter, const Show& show, const FrameOptions& options)
    : stage_(std::move(stage)), painter_(std::move(painter)), show_(&show), options_(options) {}

Result<FrameMaker> FrameMaker::build(const Body& body, const Show& show, const FrameOptions& options) {
  auto stage = body.stage(options.stage);
  if (!stage) return tl::unexpected(stage.error());
  auto painter = CaptionPainter::open();
  if (!painter) return tl::unexpected(painter.error());
  return FrameMaker(std::move(*stage), std::move(*painter), show, options);
}

void FrameMaker::make(Tick time, FrameSpan frame) {
  show_->sample(time, pose_);
  figure_kept_ = false;
  stage_.render(pose_, frame.pixels);
  write(writing_at(time), frame);
}

std::span<const PixelRect> FrameMaker::update(Tick time, FrameSpan frame) {
  if (figure_.pixels.empty()) figure_ = make_picture(frame.width, frame.height);
  show_->sample(time, pose_);
  stage_.render(pose_, figure_.pixels, figure_kept_ ? raster::Canvas::kLastFrame : raster::Canvas::kUnknown);
  figure_kept_ = true;
  changed_.clear();
  for (const raster::PixelRect& rect : stage_.damage())
    changed_.push_back({rect.x, rect.y, rect.width, rect.height});
  // Text is blended over the figure: where it stands or stood, the figure comes first again, unless nothing changed.
  const Writing writing = writing_at(time);
  const size_t drawn = changed_.size();
  if (writing.sentence != nullptr || written_.sentence != nullptr)
    changed_.push_back(caption_band(frame.width, frame.height, TextSizes(frame.height).caption));
  if (writing.in_upper_rows() || written_.in_upper_rows())
    changed_.push_back({0, 0, frame.width, upper_rows(frame.height, painter_)});
  const std::span<const PixelRect> figure(changed_.data(), drawn);
  const std::span<const PixelRect> text(changed_.data() + drawn, changed_.size() - drawn);
  const bool rewrite =
      writing != written_ || std::ranges::any_of(text, [&](const PixelRect& place) {
        return std::ranges::any_of(figure, [&](const PixelRect& rect) { return intersection(place, rect).width > 0; });
      });
  if (!rewrite) changed_.resize(drawn);
  for (const PixelRect& rect : changed_)
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
      const auto first = static_cast<ptrdiff_t>(y) * frame.width + rect.x;
      std::copy_n(figure_.pixels.begin() + first, rect.width, frame.pixels.begin() + first);
    }
  if (rewrite) write(writing, frame);
  written_ = writing;
  return changed_;
}

FrameMaker::Writing FrameMaker::writing_at(Tick time) const {
  Writing writing;
  writing.mark = options_.mark_unreviewed && !show_->reviewed;
  const auto& glosses = show_->glosses;
  if (!options_.caption || glosses.empty()) return writing;
  // The entry that is on the hands, or the last one that was; before the first, the first.
  const auto next = std::upper_bound(glosses.begin(), glosses.end(), time,
                                     [](Tick t, const GlossSpan& span) { return t < span.begin; });
  const size_t current = next == glosses.begin() ? 0 : static_cast<size_t>(next - glosses.begin()) - 1;
  if (current < show_->sentence_of_gloss.size())
    writing.sentence = &show_->sentences[static_cast<size_t>(show_->sentence_of_gloss[current])];
  const GlossSpan& gloss = glosses[current];
  if (time >= gloss.begin && time <= gloss.end) writing.gloss = &gloss.label;
  return writing;
}

void FrameMaker::write(const Writing& writing, FrameSpan frame) const {
  const TextSizes sizes(frame.height);
  const TextColours colours(options_.stage.background);
  if (writing.sentence != nullptr) painter_.paint(frame, *writing.sentence, sizes.caption);
  // A span of the upper rows alone: what is written there cannot leave them.
  const int rows = upper_rows(frame.height, painter_);
  const FrameSpan upper{frame.pixels.first(static_cast<size_t>(rows) * static_cast<size_t>(frame.width)), frame.width,
                        rows};
  if (writing.gloss != nullptr)
    painter_.text(upper, frame.width - sizes.text / 2, sizes.text / 2 + painter_.ascent(sizes.gloss), *writing.gloss,
                  sizes.gloss, colours.gloss, TextAlign::kRight);
  if (writing.mark)
    painter_.text(upper, sizes.mark, sizes.mark / 2 + painter_.ascent(sizes.mark), kMark, sizes.mark, colours.mark);
}

}  // namespace auslan
